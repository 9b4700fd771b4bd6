//! Speed against error: declared cases against declared methods, in one report.
//!
//! A [`Suite`] (TOML) names methods, each a `[reconstruction]` table, and cases, each a
//! configuration file and what is different in it. [`run`] simulates every case, measures it with
//! every method and collects a [`Record`]: rows of figures, curves and pictures, each beside the
//! machine, threads, code version and seed that made it. [`report`] writes the record as CSV, as
//! JSON and as one HTML page that needs nothing else. Nothing here knows a solver by name beyond
//! what the settings say, so a new one is a new entry in the TOML.
//!
//! [`validate`] is the paper's experiment: light-field cameras and planar PIV on one simulated jet.

mod between;
mod calibration_commands;
mod case;
mod child;
mod error;
mod kernel;
mod machine;
mod measure;
mod paper;
mod particle_score;
pub mod peers;
mod record;
pub mod report;
mod row;
mod runner;
mod score;
mod suite;
mod true_calibration;
mod truth;
pub mod validate;

pub use error::BenchmarkError;
pub use kernel::{ReferenceKernel, reference_seconds};
pub use machine::Stamp;
pub use peers::read_peers;
pub use record::{Curve, MeasuredField, Projection, Record};
pub use row::Row;
pub use runner::{RunOptions, run};
pub use suite::{Bar, Beside, Calibration, Case, Claim, Figure, Measure, Method, Suite, Sweep};
