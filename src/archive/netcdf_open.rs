//! Opens NetCDF files without the diagnostics of the HDF5 library.
//!
//! HDF5 prints pages to standard error on every error, including expected ones, in every thread
//! that has not disabled this. The NetCDF library disables it in the first thread only.

use std::{cell::Cell, path::Path, ptr};

use hdf5_sys::{LOCK, h5e};
use lfpiv_rawlog::regular_file::open_regular;
use netcdf::{Error, File, FileMut};

/// Opens a file for reading. Use it on this thread only.
pub(super) fn open(path: &Path) -> netcdf::Result<File> {
    // The library would block on a pipe.
    open_regular(path).map_err(|reason| Error::Str(reason.to_string()))?;
    silence();
    netcdf::open(path)
}

/// Creates a file. Use it on this thread only.
pub(super) fn create(path: &Path) -> netcdf::Result<FileMut> {
    silence();
    netcdf::create(path)
}

/// Disables the diagnostics in this thread.
#[expect(unsafe_code)]
fn silence() {
    thread_local! {
        static IS_SILENT: Cell<bool> = const { Cell::new(false) };
    }
    if IS_SILENT.replace(true) {
        return;
    }
    let _lock = LOCK.lock();
    // SAFETY: the default error stack always exists, a null function with null data means "print
    // nothing", and the library's lock is held.
    unsafe { h5e::H5Eset_auto2(h5e::H5E_DEFAULT, None, ptr::null_mut()) };
}

#[cfg(test)]
mod tests {
    use std::{os::fd::AsFd, thread};

    use super::*;

    /// Standard error belongs to the whole process, so the test runs itself in a child process.
    #[test]
    fn a_damaged_file_is_an_error_and_nothing_is_printed() {
        if std::env::var_os("LFPIV_OPENS").is_some() {
            let folder = tempfile::tempdir().unwrap();
            let path = folder.path().join("damaged.nc");
            std::fs::write(&path, b"\x89HDF\r\n\x1a\n and no more").unwrap();
            thread::spawn(move || assert!(open(&path).is_err())).join().unwrap();
            return;
        }
        let stderr = tempfile::tempfile().unwrap();
        let status = std::process::Command::new(std::env::current_exe().unwrap())
            .args(["--exact", "--nocapture"])
            .arg("archive::netcdf_open::tests::a_damaged_file_is_an_error_and_nothing_is_printed")
            .env("LFPIV_OPENS", "1")
            .stderr(stderr.as_fd().try_clone_to_owned().unwrap())
            .stdout(std::process::Stdio::null())
            .status()
            .unwrap();
        assert!(status.success());
        assert_eq!(stderr.metadata().unwrap().len(), 0);
    }
}
