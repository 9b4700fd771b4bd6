//! The file operations that the log needs. Their order decides what a power cut may leave, so a
//! test can replace the disk by a model.

mod disk;
#[cfg(test)]
pub(super) mod model;

use std::{fmt, io, path::Path};

pub(super) use disk::Disk;

/// A file system.
pub(super) trait Storage: fmt::Debug + Send + Sync {
    /// Creates the folder and its parents.
    fn create_folder(&self, folder: &Path) -> io::Result<()>;
    /// Names of the files in a folder, in any order.
    fn list(&self, folder: &Path) -> io::Result<Vec<String>>;
    /// Creates a file that must not exist yet.
    fn create(&self, path: &Path) -> io::Result<Box<dyn LogFile>>;
    /// Opens a file for reading.
    fn open(&self, path: &Path) -> io::Result<Box<dyn LogFile>>;
    /// Opens a file for truncating and appending.
    fn open_writable(&self, path: &Path) -> io::Result<Box<dyn LogFile>>;
    /// Renames a file within its folder, replacing a file of that name.
    fn rename(&self, from: &Path, to: &Path) -> io::Result<()>;
    /// Makes the names in a folder durable.
    fn sync_folder(&self, folder: &Path) -> io::Result<()>;
    /// Free space in bytes.
    fn free_bytes(&self, folder: &Path) -> io::Result<u64>;
}

/// An open file.
pub(super) trait LogFile: Send {
    /// Appends all bytes; on failure some of them may have been appended.
    fn append(&mut self, bytes: &[u8]) -> io::Result<()>;
    /// Makes content and length durable.
    fn sync(&mut self) -> io::Result<()>;
    /// Truncates the file.
    fn truncate(&mut self, length: u64) -> io::Result<()>;
    /// Fills `bytes` from `offset` on; returns the number of bytes read, which is smaller at the end of
    /// the file.
    fn read_at(&self, offset: u64, bytes: &mut [u8]) -> io::Result<usize>;
    /// Bytes in the file.
    fn length(&self) -> io::Result<u64>;
}
