//! Files that are either complete or absent.

use std::{
    fs::{self, File},
    io::{self, BufWriter, Seek, Write},
    os::unix::fs::OpenOptionsExt,
    path::{Path, PathBuf},
    sync::atomic::{AtomicU64, Ordering},
};

use super::ArchiveError;

/// Preferred folder for files in memory; the fallback is the folder of temporary files.
const IN_MEMORY: &str = "/dev/shm";

/// Free space to leave in that folder, in bytes.
const RESERVE_BYTES: u64 = 16 << 20;

/// A file in memory, for a library that writes to a path and does not survive a failed write. The
/// finished file is copied to disk by [`Self::store`]. The file has no name and ends with the
/// process.
#[derive(Debug)]
pub(super) struct MemoryFile(File);

impl MemoryFile {
    /// Creates a file with room for `bytes`. Returns it with the result of `open`, which gets the
    /// file's path; the path is removed afterwards.
    pub fn create<T, E>(
        bytes: u64,
        open: impl FnOnce(&Path) -> Result<T, E>,
    ) -> io::Result<(Self, Result<T, E>)> {
        let places = [PathBuf::from(IN_MEMORY), std::env::temp_dir()];
        let has_room = |place: &&PathBuf| free_bytes(place) >= bytes.saturating_add(RESERVE_BYTES);
        let place = places.iter().find(has_room).ok_or_else(|| {
            let mb = bytes as f64 / 1e6;
            io::Error::other(format!(
                "the file is built in memory first, but neither {} nor {} has {mb:.0} MB free",
                places[0].display(),
                places[1].display()
            ))
        })?;
        let (file, path) = create_private(place)?;
        let opened = open(&path);
        fs::remove_file(&path)?;
        Ok((Self(file), opened))
    }

    /// Bytes that the library has written so far.
    pub fn bytes(&self) -> u64 {
        self.0.metadata().map_or(0, |metadata| metadata.len())
    }

    /// Writes the file to `path`, complete or not at all. A failed call leaves nothing behind and
    /// can be repeated.
    pub fn store(&self, path: &Path) -> Result<(), ArchiveError> {
        self.write_part(path)?;
        seal(path)
    }

    /// Writes the `.part` file; [`seal`] completes the work of [`Self::store`].
    pub fn write_part(&self, path: &Path) -> Result<(), ArchiveError> {
        let part = part_path(path);
        let written = File::create(&part).and_then(|mut file| {
            let mut memory = &self.0;
            memory.rewind()?;
            io::copy(&mut memory, &mut file)?;
            file.sync_all()
        });
        written.map_err(|reason| {
            // A partial file is useless and takes space.
            let _ = fs::remove_file(&part);
            ArchiveError::unwritten(path, Some(self.bytes()))(reason)
        })
    }
}

/// Path of a file while it is being written: the final name with `.part` appended.
pub(super) fn part_path(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".part");
    PathBuf::from(name)
}

/// Creates a new file in `folder` that only this user can read.
fn create_private(folder: &Path) -> io::Result<(File, PathBuf)> {
    static NUMBER: AtomicU64 = AtomicU64::new(0);
    loop {
        let number = NUMBER.fetch_add(1, Ordering::Relaxed);
        let path = folder.join(format!("lfpiv-{}-{number}", std::process::id()));
        let mut options = File::options();
        match options.read(true).write(true).create_new(true).mode(0o600).open(&path) {
            Ok(file) => return Ok((file, path)),
            // A killed process with the same id left this file.
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            Err(error) => return Err(error),
        }
    }
}

/// Free space on the file system of a folder, in bytes; 0 if it cannot be determined.
pub(super) fn free_bytes(folder: &Path) -> u64 {
    rustix::fs::statvfs(folder).map_or(0, |fs| fs.f_bavail * fs.f_frsize)
}

/// Renames a finished, closed `.part` file to its final name and syncs, so that it survives a power
/// cut.
pub(super) fn seal(path: &Path) -> Result<(), ArchiveError> {
    let part = part_path(path);
    File::open(&part).and_then(|file| file.sync_all()).map_err(ArchiveError::io("sync", &part))?;
    fs::rename(&part, path).map_err(ArchiveError::io("rename", &part))?;
    // The new name is stored in the folder, which needs its own sync.
    let folder = path.parent().unwrap_or(Path::new("."));
    File::open(folder).and_then(|file| file.sync_all()).map_err(ArchiveError::io("sync", folder))
}

/// Replaces a file that can be regenerated: readers see either the old or the new content. The file
/// is not synced.
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
        .map_err(ArchiveError::unwritten(path, None))?;
    fs::rename(&part, path).map_err(ArchiveError::io("rename", &part))
}

/// Creates a folder and its parents.
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
    fn a_file_in_memory_is_stored_whole_and_can_be_tried_again() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("sub/run.nc");
        let (memory, written) =
            MemoryFile::create(100_000, |path| fs::write(path, vec![7; 100_000])).unwrap();
        written.unwrap();
        assert_eq!(memory.bytes(), 100_000);
        let error = memory.store(&path).unwrap_err().to_string();
        assert!(error.contains("run.nc"), "{error}");
        fs::create_dir(folder.path().join("sub")).unwrap();
        memory.store(&path).unwrap();
        assert_eq!(fs::read(&path).unwrap(), vec![7; 100_000]);
        assert!(!part_path(&path).exists());
    }

    #[test]
    fn a_file_larger_than_the_free_memory_is_refused() {
        let refused = MemoryFile::create(u64::MAX, |_| -> Result<(), ()> { unreachable!() });
        assert!(refused.unwrap_err().to_string().contains("built in memory first"));
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
