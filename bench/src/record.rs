//! What a run of the benchmark leaves: rows, curves and pictures.

use lfpiv_core::velocimetry::VelocityField;
use serde::Serialize;

use super::{ReferenceKernel, Row, Stamp};

/// Everything that was measured.
#[derive(Debug, Clone, Serialize)]
pub struct Record {
    /// Machine, threads, version, date.
    pub stamp: Stamp,
    /// The reference kernel in this run.
    pub kernel: ReferenceKernel,
    /// One per case, method and seed.
    pub rows: Vec<Row>,
    /// Figures along an axis.
    pub curves: Vec<Curve>,
    /// Cases that could not be measured to their end, and why.
    pub failures: Vec<String>,
    /// Volumes to look at.
    #[serde(skip)]
    pub projections: Vec<Projection>,
    /// Fields to look at.
    #[serde(skip)]
    pub fields: Vec<MeasuredField>,
}

/// A figure along an axis: per pass, or per share of the vectors.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Curve {
    /// Case.
    pub case: String,
    /// Method by name.
    pub method: String,
    /// Number of cameras.
    pub cameras: usize,
    /// Particles per microlens.
    pub ppm: f64,
    /// Seed.
    pub seed: u64,
    /// What is shown against what: `q(iteration)`, `seconds(iteration)`, `cdf_y(error_vox)`, ...
    pub name: String,
    /// Points (x, y).
    pub points: Vec<[f64; 2]>,
}

impl Curve {
    /// A curve of the row's case, method, cameras, ppm and seed.
    pub fn of(row: &Row, name: impl Into<String>, points: Vec<[f64; 2]>) -> Self {
        Self {
            case: row.case.clone(),
            method: row.method.clone(),
            cameras: row.cameras,
            ppm: row.ppm,
            seed: row.seed,
            name: name.into(),
            points,
        }
    }
}

/// The light of a volume summed along x onto the y-z plane.
#[derive(Debug, Clone, PartialEq)]
pub struct Projection {
    /// Case.
    pub case: String,
    /// Method by name; `None` for the truth.
    pub method: Option<String>,
    /// Number of cameras.
    pub cameras: usize,
    /// Particles per microlens.
    pub ppm: f64,
    /// Columns (y) and rows (z).
    pub size: [usize; 2],
    /// Light, row by row.
    pub light: Vec<f32>,
}

/// A displacement field and where it comes from.
#[derive(Debug, Clone)]
pub struct MeasuredField {
    /// Case.
    pub case: String,
    /// Method by name; `None` for the analytic solution at the same places.
    pub method: Option<String>,
    /// Number of cameras.
    pub cameras: usize,
    /// Particles per microlens.
    pub ppm: f64,
    /// The field.
    pub field: VelocityField,
}
