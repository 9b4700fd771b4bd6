//! Runs a suite.

use std::{fs, path::Path};

use super::{
    BenchmarkError, Case, Record, Row, Stamp, Suite,
    calibration_commands::CalibratedBenches,
    kernel::reference_seconds,
    measure::{Findings, Surroundings, measure},
};

/// What a run needs beside its suite.
#[derive(Debug, Clone, Copy)]
pub struct RunOptions<'a> {
    /// The program whose `process` command is timed.
    pub program: &'a Path,
    /// Folder for files that are not part of the report; made, and removed at the end.
    pub work: &'a Path,
}

/// Simulates and measures every case of a suite. `progress` is told about every row as it comes. A
/// case that cannot be measured is among the record's failures, and the others are still measured.
///
/// # Errors
/// The work folder cannot be made.
pub fn run(
    suite: &Suite,
    options: RunOptions,
    progress: &mut dyn FnMut(&Row),
) -> Result<Record, BenchmarkError> {
    let stamp = Stamp::now();
    let kernel = reference_seconds();
    let mut stamped = |row: &Row| {
        let mut row = row.clone();
        row.stamp(&stamp, kernel.seconds);
        progress(&row);
    };
    let mut findings = Findings::default();
    fs::create_dir_all(options.work)
        .map_err(|reason| BenchmarkError::Unreadable { path: options.work.into(), reason })?;
    let mut surroundings = Surroundings {
        program: options.program,
        work: options.work,
        progress: &mut stamped,
        calibrated: CalibratedBenches::default(),
    };
    let mut failures = Vec::new();
    for case in &suite.cases {
        if let Err(error) = run_case(suite, case, &mut surroundings, &mut findings) {
            failures.push(format!("{}: {error}", case.name));
        }
    }
    // A folder left behind costs room alone.
    let _ = fs::remove_dir_all(options.work);
    let Findings { mut rows, curves, projections, fields } = findings;
    rows.iter_mut().for_each(|row| row.stamp(&stamp, kernel.seconds));
    Ok(Record { stamp, kernel, rows, curves, failures, projections, fields })
}

fn run_case(
    suite: &Suite,
    case: &Case,
    surroundings: &mut Surroundings,
    findings: &mut Findings,
) -> Result<(), BenchmarkError> {
    let methods = suite.methods_of(case)?;
    for setting in case.settings(&suite.folder)? {
        measure(&setting, &methods, surroundings, findings)?;
    }
    Ok(())
}
