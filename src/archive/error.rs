//! Why something could not be read from or written to disk.

use std::{
    io,
    path::{Path, PathBuf},
};

use thiserror::Error;

use super::{ImageSize, durable::free_bytes};

/// Why something could not be read from or written to disk.
///
/// Every message is complete: it contains the reason, which is not repeated as `source`.
#[derive(Debug, Error)]
pub enum ArchiveError {
    /// The operating system reported an error.
    #[error("cannot {action} {}: {reason}", path.display())]
    Io {
        /// The attempted action.
        action: &'static str,
        /// The file or folder.
        path: PathBuf,
        /// The system's error.
        reason: io::Error,
    },
    /// The disk has no room for a file.
    #[error(
        "the disk is full: {} needs {needed} and {free_mb:.1} MB are free; make room on its disk",
        path.display()
    )]
    DiskFull {
        /// The file.
        path: PathBuf,
        /// The file's size in words, or "more" if unknown.
        needed: String,
        /// Free space, in MB of 10⁶ bytes.
        free_mb: f64,
    },
    /// The NetCDF library reported an error.
    #[error("cannot write NetCDF file {}: {reason}", path.display())]
    NetCdf {
        /// The file.
        path: PathBuf,
        /// The library's error.
        reason: netcdf::Error,
    },
    /// Stored results cannot be read.
    #[error(
        "cannot read the results in {}: {reason}; to measure its shots again, move the file \
         away", path.display()
    )]
    UnreadableResults {
        /// The file.
        path: PathBuf,
        /// The library's error.
        reason: netcdf::Error,
    },
    /// Stored particles cannot be read.
    #[error(
        "cannot read the particles in {}: {reason}; to measure them again, move this file and the \
         file of vectors beside it away, then `lfpiv process` the run", path.display()
    )]
    UnreadableParticles {
        /// The file.
        path: PathBuf,
        /// The library's error.
        reason: netcdf::Error,
    },
    /// A file does not contain usable volumes.
    #[error(
        "cannot read volumes from {}: {reason}; the file needs variables a and b over z, y, x, on \
         the voxels of [volume]", path.display()
    )]
    UnreadableVolumes {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        reason: String,
    },
    /// An image of a pair is missing.
    #[error(
        "{} is missing: with {cameras} configured a pair folder needs {needed}; \
         add the image or remove the camera from the configuration", path.display()
    )]
    MissingImage {
        /// The missing file.
        path: PathBuf,
        /// "1 camera" or "2 cameras".
        cameras: String,
        /// All required files.
        needed: String,
    },
    /// Two files match the name of one image.
    #[error(
        "{} and {} match the same image: remove one of them", first.display(),
        second.display()
    )]
    TwoImages {
        /// One file.
        first: PathBuf,
        /// The other file.
        second: PathBuf,
    },
    /// The file is damaged or not a TIFF.
    #[error(
        "cannot read {}: {reason}; the file is damaged, truncated or not a TIFF: \
         copy or record it again", path.display()
    )]
    UnreadableImage {
        /// The file.
        path: PathBuf,
        /// The decoder's error.
        reason: String,
    },
    /// The file is an image, but not an 8- or 16-bit grey TIFF.
    #[error(
        "{} is {found}: save it as grey TIFF of 8 or 16 bit without colour or transparency",
        path.display()
    )]
    NotGrey {
        /// The file.
        path: PathBuf,
        /// What it is instead: its format or its pixel type.
        found: String,
    },
    /// The file contains several images.
    #[error(
        "{} holds several pages of {size} pixels: save each \
         frame of each camera as a file of its own", path.display()
    )]
    SeveralPages {
        /// The file.
        path: PathBuf,
        /// Size of the pages.
        size: ImageSize,
    },
    /// The image size differs from the sensor size.
    #[error(
        "{} has {found} pixels but the configured sensor has {expected}: correct \
         optics.sensor.columns and rows, or use the configuration this image was recorded with",
        path.display()
    )]
    WrongSize {
        /// The file.
        path: PathBuf,
        /// Its size.
        found: ImageSize,
        /// The sensor's size.
        expected: ImageSize,
    },
    /// The folder contains no image pair.
    #[error(
        "no image pair in {}: a pair folder holds cam1_a.tif and cam1_b.tif (and cam2_a.tif, \
         cam2_b.tif with two cameras); give such a folder or the folder above several of them",
        path.display()
    )]
    NoPair {
        /// The folder searched.
        path: PathBuf,
    },
    /// A run's folder is already in use.
    #[error("{} already holds results: choose another folder or move them away", path.display())]
    AlreadyUsed {
        /// The folder.
        path: PathBuf,
    },
    /// All vectors of a file share one grid.
    #[error(
        "the vector grid of shot {shot} differs from that of the shots already in {}: start a new \
         run for changed settings", path.display()
    )]
    GridChanged {
        /// The refused shot.
        shot: u64,
        /// The file with the earlier shots.
        path: PathBuf,
    },
}

impl ArchiveError {
    /// Adapter for `map_err`: adds the attempted action and the path.
    pub(super) fn io(
        action: &'static str,
        path: impl Into<PathBuf>,
    ) -> impl FnOnce(io::Error) -> Self {
        let path = path.into();
        move |reason| Self::Io { action, path, reason }
    }

    /// Adapter for `map_err`: adds the file being written and its size, if known.
    pub(super) fn unwritten(
        path: &Path,
        bytes: Option<u64>,
    ) -> impl FnOnce(io::Error) -> Self + use<> {
        let path = path.to_owned();
        move |reason| {
            if !matches!(reason.kind(), io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded) {
                return Self::Io { action: "write", path, reason };
            }
            let free = free_bytes(path.parent().unwrap_or(Path::new(".")));
            let mb = |bytes: u64| bytes as f64 / 1e6;
            let needed = bytes.map_or("more".to_owned(), |bytes| format!("{:.1} MB", mb(bytes)));
            Self::DiskFull { path, needed, free_mb: mb(free) }
        }
    }

    /// Adapter for `map_err`: adds the file of stored results being read.
    pub(super) fn unreadable_results(path: &Path) -> impl FnOnce(netcdf::Error) -> Self {
        move |reason| Self::UnreadableResults { path: path.into(), reason }
    }

    /// Adapter for `map_err`: adds the file of stored particles being read.
    pub(super) fn unreadable_particles(path: &Path) -> impl FnOnce(netcdf::Error) -> Self {
        move |reason| Self::UnreadableParticles { path: path.into(), reason }
    }

    /// Adapter for `map_err`: adds the file.
    pub(super) fn netcdf(path: impl Into<PathBuf>) -> impl FnOnce(netcdf::Error) -> Self {
        let path = path.into();
        move |reason| Self::NetCdf { path, reason }
    }
}
