//! The real file system.

use std::{
    fs::{self, File, OpenOptions},
    io::{self, ErrorKind, Write},
    os::unix::fs::FileExt,
    path::Path,
};

use rustix::{
    fs::{FallocateFlags, fallocate},
    io::{Errno, retry_on_intr},
};

use super::{LogFile, Storage};
use crate::regular_file::{open_regular, open_regular_with};

/// The operating system's files.
#[derive(Debug, Clone, Copy)]
pub(in super::super) struct Disk;

impl Storage for Disk {
    fn create_folder(&self, folder: &Path) -> io::Result<()> {
        fs::create_dir_all(folder)
    }

    fn list(&self, folder: &Path) -> io::Result<Vec<String>> {
        let name = |entry: io::Result<fs::DirEntry>| entry.map(|entry| entry.file_name());
        let names = fs::read_dir(folder)?.map(name).collect::<io::Result<Vec<_>>>()?;
        Ok(names.into_iter().filter_map(|name| name.into_string().ok()).collect())
    }

    fn create(&self, path: &Path) -> io::Result<Box<dyn LogFile>> {
        // Append mode: after truncation, writes go to the new end.
        let file = OpenOptions::new().read(true).append(true).create_new(true).open(path)?;
        Ok(Box::new(file))
    }

    fn open(&self, path: &Path) -> io::Result<Box<dyn LogFile>> {
        Ok(Box::new(open_regular(path)?))
    }

    fn open_writable(&self, path: &Path) -> io::Result<Box<dyn LogFile>> {
        Ok(Box::new(open_regular_with(OpenOptions::new().read(true).append(true), path)?))
    }

    fn rename(&self, from: &Path, to: &Path) -> io::Result<()> {
        fs::rename(from, to)
    }

    fn sync_folder(&self, folder: &Path) -> io::Result<()> {
        File::open(folder)?.sync_all()
    }

    fn free_bytes(&self, folder: &Path) -> io::Result<u64> {
        let disk = rustix::fs::statvfs(folder)?;
        Ok(disk.f_bavail.saturating_mul(disk.f_frsize))
    }
}

/// Fails if the file system has stopped accepting changes, in which case the sync before it proves
/// nothing.
///
/// When an error makes ext4 read-only, it first aborts its journal and discards uncommitted
/// transactions. The whole file system is marked some time later. In between, a sync succeeds if its
/// transaction is neither running nor being committed (`jbd2_complete_transaction`). Allocating a byte
/// that the file already has changes nothing but starts a transaction, which an aborted journal
/// refuses. An aborted journal never recovers, so if this call succeeds, the journal worked during
/// the sync.
fn probe_journal(file: &File) -> io::Result<()> {
    match retry_on_intr(|| fallocate(file, FallocateFlags::KEEP_SIZE, 0, 1)) {
        Err(refused @ (Errno::ROFS | Errno::IO)) => Err(refused.into()),
        // File systems without this call, or without free space, give no evidence about the sync.
        _ => Ok(()),
    }
}

impl LogFile for File {
    fn append(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.write_all(bytes)
    }

    fn sync(&mut self) -> io::Result<()> {
        self.sync_data()?;
        probe_journal(self)
    }

    fn truncate(&mut self, length: u64) -> io::Result<()> {
        self.set_len(length)
    }

    fn read_at(&self, offset: u64, bytes: &mut [u8]) -> io::Result<usize> {
        let mut read = 0;
        while read < bytes.len() {
            match FileExt::read_at(self, &mut bytes[read..], offset + read as u64) {
                Ok(0) => break,
                Ok(more) => read += more,
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
        }
        Ok(read)
    }

    fn length(&self) -> io::Result<u64> {
        Ok(self.metadata()?.len())
    }
}
