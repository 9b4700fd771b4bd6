//! The file operations that the log needs, and no others: what a power cut may leave is decided by
//! their order, and a test can stand in for the disk.

mod disk;
#[cfg(test)]
pub(super) mod model;

use std::{fmt, io, path::Path};

pub(super) use disk::Disk;

/// A disk with folders and files.
pub(super) trait Storage: fmt::Debug + Send + Sync {
    /// Creates the folder and those above it.
    fn create_folder(&self, folder: &Path) -> io::Result<()>;
    /// Names of the files in a folder, in any order.
    fn list(&self, folder: &Path) -> io::Result<Vec<String>>;
    /// Creates a file that must not exist.
    fn create(&self, path: &Path) -> io::Result<Box<dyn LogFile>>;
    /// Opens a file for reading.
    fn open(&self, path: &Path) -> io::Result<Box<dyn LogFile>>;
    /// Opens a file to cut it and to append to it.
    fn open_to_repair(&self, path: &Path) -> io::Result<Box<dyn LogFile>>;
    /// Gives a file another name in the same folder, in place of a file that has it.
    fn rename(&self, from: &Path, to: &Path) -> io::Result<()>;
    /// Makes the names in a folder survive a power cut.
    fn sync_folder(&self, folder: &Path) -> io::Result<()>;
    /// Bytes that may still be written.
    fn free_bytes(&self, folder: &Path) -> io::Result<u64>;
}

/// An open file.
pub(super) trait LogFile: Send {
    /// Appends all bytes, or fails having appended some of them.
    fn append(&mut self, bytes: &[u8]) -> io::Result<()>;
    /// Makes content and length survive a power cut.
    fn sync(&mut self) -> io::Result<()>;
    /// Cuts the file.
    fn truncate(&mut self, length: u64) -> io::Result<()>;
    /// Fills `bytes` from `offset` on; the number of bytes read is smaller at the end of the file.
    fn read_at(&self, offset: u64, bytes: &mut [u8]) -> io::Result<usize>;
    /// Bytes in the file.
    fn length(&self) -> io::Result<u64>;
}
