//! Why a benchmark cannot be run.

use std::{io, path::PathBuf};

use lfpiv::{archive::ArchiveError, config::ConfigError};
use lfpiv_core::{
    measurement::{ProcessError, SetupError},
    model::ModelError,
};
use lfpiv_sim::flow::SampledFlowError;
use thiserror::Error;

/// Why a benchmark cannot be run.
#[derive(Debug, Error)]
pub enum BenchmarkError {
    /// A file cannot be read.
    #[error("cannot read {}: {reason}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        reason: io::Error,
    },
    /// A file's content is not what it should be.
    #[error("{}: {reason}", path.display())]
    Malformed {
        /// The file.
        path: PathBuf,
        /// What is wrong in it.
        reason: String,
    },
    /// A case names a method that is not declared.
    #[error("case {case} names the method {method}, which no [[method]] table declares")]
    UnknownMethod {
        /// The case.
        case: String,
        /// The method that is missing.
        method: String,
    },
    /// The command line names a set that no case belongs to.
    #[error("no case belongs to the set {set}; there are: {known}")]
    UnknownSet {
        /// The name asked for.
        set: String,
        /// All names.
        known: String,
    },
    /// A case's flow has samples that cannot be read.
    #[error("case {case}: {reason}")]
    Flow {
        /// The case.
        case: String,
        /// What is wrong.
        reason: SampledFlowError,
    },
    /// A case's configuration has no scene to simulate.
    #[error("case {case}: its configuration has no [simulation] table")]
    NoScene {
        /// The case.
        case: String,
    },
    /// A case is to be calibrated by commands and names no card.
    #[error("case {case}: calibration = \"commands\" needs a card, as \"../config/card.toml\"")]
    NoCard {
        /// The case.
        case: String,
    },
    /// A case's changes do not make a valid configuration.
    #[error("case {case}: {reason}")]
    Configuration {
        /// The case.
        case: String,
        /// What is wrong.
        reason: ConfigError,
    },
    /// The optics cannot see the volume.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// A processor cannot be set up.
    #[error(transparent)]
    Setup(#[from] SetupError),
    /// A simulated pair cannot be measured.
    #[error(transparent)]
    Process(#[from] ProcessError),
    /// Images or reports cannot be written.
    #[error(transparent)]
    Archive(#[from] ArchiveError),
    /// The child process cannot be run.
    #[error("cannot run {}: {reason}", program.display())]
    Spawn {
        /// The program.
        program: PathBuf,
        /// The system's reason.
        reason: io::Error,
    },
    /// The child process failed.
    #[error("{command} failed: {message}")]
    Child {
        /// What was run.
        command: String,
        /// What it said.
        message: String,
    },
}
