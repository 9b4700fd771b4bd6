//! Files that appear whole or not at all.

use std::{
    fs::{self, File},
    io::{BufWriter, Write},
    path::{Path, PathBuf},
};

use super::ArchiveError;

/// Where a file lies while it is being written: the final name with `.part` appended.
pub(super) fn part_path(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".part");
    PathBuf::from(name)
}

/// Moves a finished, closed `.part` file to its final name, so that it survives a power cut.
pub(super) fn seal(path: &Path) -> Result<(), ArchiveError> {
    let part = part_path(path);
    File::open(&part)
        .and_then(|file| file.sync_all())
        .map_err(ArchiveError::io("flush to disk", &part))?;
    fs::rename(&part, path).map_err(ArchiveError::io("give its final name to", &part))?;
    // The new name itself lives in the folder.
    let folder = path.parent().unwrap_or(Path::new("."));
    File::open(folder)
        .and_then(|file| file.sync_all())
        .map_err(ArchiveError::io("flush to disk", folder))
}

/// Writes a convenience file (one that can be made again): a reader sees the old or the new
/// content, never half of it. Not fsynced.
pub fn replace(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> std::io::Result<()>,
) -> Result<(), ArchiveError> {
    let part = part_path(path);
    File::create(&part)
        .and_then(|file| {
            let mut writer = BufWriter::new(file);
            write(&mut writer)?;
            writer.flush()
        })
        .map_err(ArchiveError::io("write", &part))?;
    fs::rename(&part, path).map_err(ArchiveError::io("give its final name to", &part))
}

/// Creates a folder and those above it.
pub(super) fn create_folder(path: &Path) -> Result<(), ArchiveError> {
    fs::create_dir_all(path).map_err(ArchiveError::io("create the folder", path))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failed_write_leaves_the_old_content() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("list");
        replace(&path, |w| w.write_all(b"old")).unwrap();
        let failed = replace(&path, |w| {
            w.write_all(b"ne")?;
            Err(std::io::Error::other("disk full"))
        });
        assert!(failed.unwrap_err().to_string().contains("disk full"));
        assert_eq!(fs::read(&path).unwrap(), b"old");
    }

    #[test]
    fn sealing_moves_the_part_to_its_name() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("run.nc");
        fs::write(part_path(&path), b"whole").unwrap();
        seal(&path).unwrap();
        assert_eq!(fs::read(&path).unwrap(), b"whole");
        assert!(!part_path(&path).exists());
    }
}
