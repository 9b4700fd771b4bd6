//! Why a case cannot be made, written or read.

use std::{
    io,
    path::{Path, PathBuf},
};

use lfpiv_core::{
    measurement::{ProcessError, SetupError},
    model::ModelError,
};
use thiserror::Error;

/// Why a case cannot be made, written or read.
#[derive(Debug, Error)]
pub enum PeersError {
    /// The operating system refused.
    #[error("cannot {action} {}: {reason}", path.display())]
    Io {
        /// What was tried.
        action: &'static str,
        /// On which file.
        path: PathBuf,
        /// The system's reason.
        reason: io::Error,
    },
    /// The file is not the array that belongs there.
    #[error("{} is not the expected array: {reason}; export the case again", path.display())]
    WrongArray {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        reason: String,
    },
    /// `case.json` cannot be read.
    #[error("{} does not describe a case: {reason}; export the case again", path.display())]
    WrongDescription {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        reason: serde_json::Error,
    },
    /// The optics cannot see the volume.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// The measurement cannot be set up.
    #[error(transparent)]
    Setup(#[from] SetupError),
    /// The simulated pair cannot be measured.
    #[error(transparent)]
    Process(#[from] ProcessError),
}

impl PeersError {
    /// Turns the system's reason into an error about `path`.
    pub(super) fn io(action: &'static str, path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_owned();
        move |reason| Self::Io { action, path, reason }
    }
}
