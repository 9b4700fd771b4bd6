//! The measurements, one file each. A measurement takes a setting, runs the methods on it and adds
//! to the findings.

mod convergence;
mod elongation;
mod loopback;
mod matrix;
mod particles;
mod process;
mod velocity;
mod volume;

use std::path::Path;

use super::{
    BenchmarkError, Curve, Measure, MeasuredField, Method, Projection, Row,
    calibration_commands::CalibratedBenches, case::Setting,
};

/// What measurements add to a record.
#[derive(Debug, Default)]
pub struct Findings {
    /// See [`super::Record`].
    pub rows: Vec<Row>,
    /// See [`super::Record`].
    pub curves: Vec<Curve>,
    /// See [`super::Record`].
    pub projections: Vec<Projection>,
    /// See [`super::Record`].
    pub fields: Vec<MeasuredField>,
}

/// What a measurement needs beside its setting.
pub struct Surroundings<'a> {
    /// The program that `process` measurements run.
    pub program: &'a Path,
    /// Folder for files that are not part of the report; exists.
    pub work: &'a Path,
    /// Told about every row that is added.
    pub progress: &'a mut dyn FnMut(&Row),
    /// What the calibration commands found so far.
    pub calibrated: CalibratedBenches,
}

impl Findings {
    /// Adds a row and tells about it.
    fn add(&mut self, row: Row, surroundings: &mut Surroundings) {
        (surroundings.progress)(&row);
        self.rows.push(row);
    }
}

/// Measures a setting with these methods.
pub fn measure(
    setting: &Setting,
    methods: &[Option<&Method>],
    surroundings: &mut Surroundings,
    findings: &mut Findings,
) -> Result<(), BenchmarkError> {
    match setting.case.measure {
        Measure::Velocity => velocity::measure(setting, methods, surroundings, findings),
        Measure::Particles => particles::measure(setting, methods, surroundings, findings),
        Measure::Volume => volume::measure(setting, methods, surroundings, findings),
        Measure::Convergence => convergence::measure(setting, methods, surroundings, findings),
        Measure::Elongation => elongation::measure(setting, methods, surroundings, findings),
        Measure::Process => process::measure(setting, methods, surroundings, findings),
        Measure::Loopback => loopback::measure(setting, surroundings, findings),
        Measure::Matrix => matrix::measure(setting, methods, surroundings, findings),
    }
}
