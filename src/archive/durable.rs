//! Files that appear whole or not at all.

use std::{
    fs::{self, File},
    io::{self, BufWriter, Seek, Write},
    os::unix::fs::OpenOptionsExt,
    path::{Path, PathBuf},
    sync::atomic::{AtomicU64, Ordering},
};

use super::ArchiveError;

/// Where files in memory are made: on the machine's memory, else where temporary files are.
const IN_MEMORY: &str = "/dev/shm";

/// Room that is left free there, in bytes.
const SPARED_BYTES: u64 = 16 << 20;

/// A file in memory, for a library that writes to a path and cannot bear that writing fails: the disk
/// comes into it only when the file is finished, and then through [`Self::store`]. It has no name, and
/// ends with the process.
#[derive(Debug)]
pub(super) struct MemoryFile(File);

impl MemoryFile {
    /// A file with room for `bytes`, and what `open` makes of its path, which is gone afterwards.
    pub fn create<T, E>(
        bytes: u64,
        open: impl FnOnce(&Path) -> Result<T, E>,
    ) -> io::Result<(Self, Result<T, E>)> {
        let places = [PathBuf::from(IN_MEMORY), std::env::temp_dir()];
        let has_room = |place: &&PathBuf| free_bytes(place) >= bytes.saturating_add(SPARED_BYTES);
        let place = places.iter().find(has_room).ok_or_else(|| {
            let mb = bytes as f64 / 1e6;
            io::Error::other(format!(
                "it is made in memory first, and neither {} nor {} has {mb:.0} MB free",
                places[0].display(),
                places[1].display()
            ))
        })?;
        let (file, path) = unnamed_yet(place)?;
        let opened = open(&path);
        fs::remove_file(&path)?;
        Ok((Self(file), opened))
    }

    /// Its size in bytes, as far as the library has written it.
    pub fn bytes(&self) -> u64 {
        self.0.metadata().map_or(0, |metadata| metadata.len())
    }

    /// Writes it to `path`, where it appears whole. It can be tried again after a failure, which leaves
    /// nothing behind.
    pub fn store(&self, path: &Path) -> Result<(), ArchiveError> {
        self.write_part(path)?;
        seal(path)
    }

    /// The first half of [`Self::store`]: [`seal`] is the second.
    pub fn write_part(&self, path: &Path) -> Result<(), ArchiveError> {
        let part = part_path(path);
        let written = File::create(&part).and_then(|mut file| {
            let mut memory = &self.0;
            memory.rewind()?;
            io::copy(&mut memory, &mut file)?;
            file.sync_all()
        });
        written.map_err(|reason| {
            // Half a file is of no use, and takes room.
            let _ = fs::remove_file(&part);
            ArchiveError::unwritten(path, Some(self.bytes()))(reason)
        })
    }
}

/// Where a file lies while it is being written: the final name with `.part` appended.
pub(super) fn part_path(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".part");
    PathBuf::from(name)
}

/// A new file in `folder`, for this user only.
fn unnamed_yet(folder: &Path) -> io::Result<(File, PathBuf)> {
    static NUMBER: AtomicU64 = AtomicU64::new(0);
    loop {
        let number = NUMBER.fetch_add(1, Ordering::Relaxed);
        let path = folder.join(format!("lfpiv-{}-{number}", std::process::id()));
        let mut options = File::options();
        match options.read(true).write(true).create_new(true).mode(0o600).open(&path) {
            Ok(file) => return Ok((file, path)),
            // Left by a process of this number that was killed in between.
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
            Err(error) => return Err(error),
        }
    }
}

/// Room on the file system of a folder, in bytes; 0 where it cannot be asked.
pub(super) fn free_bytes(folder: &Path) -> u64 {
    rustix::fs::statvfs(folder).map_or(0, |fs| fs.f_bavail * fs.f_frsize)
}

/// Moves a finished, closed `.part` file to its final name, so that it survives a power cut.
pub(super) fn seal(path: &Path) -> Result<(), ArchiveError> {
    let part = part_path(path);
    File::open(&part).and_then(|file| file.sync_all()).map_err(ArchiveError::io("sync", &part))?;
    fs::rename(&part, path).map_err(ArchiveError::io("give its final name to", &part))?;
    // The new name itself lives in the folder.
    let folder = path.parent().unwrap_or(Path::new("."));
    File::open(folder).and_then(|file| file.sync_all()).map_err(ArchiveError::io("sync", folder))
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
        .map_err(ArchiveError::unwritten(path, None))?;
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
    fn what_the_memory_has_no_room_for_is_not_begun() {
        let refused = MemoryFile::create(u64::MAX, |_| -> Result<(), ()> { unreachable!() });
        assert!(refused.unwrap_err().to_string().contains("made in memory first"));
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
