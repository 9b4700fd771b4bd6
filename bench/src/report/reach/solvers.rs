//! Bars on OS-SART beside OS-MART, both on active voxels.

use lfpiv_core::reconstruction::Solver;

use super::{
    super::{
        Report,
        tables::{mean_of_components, median},
        text::number,
    },
    Candidate, all_of, at_most, missed,
    ratios::fastest,
};
use crate::{Bar, Row};

/// Densities in ppm, and how many times OS-MART's seconds OS-SART may take there.
const MOST_TIMES: [(f64, f64); 2] = [(0.3, 2.0), (1.0, 3.0)];
/// How many times OS-MART's error it may have.
const MOST_ERROR: f64 = 1.5;
/// How many times OS-MART's seconds it may take to this Q.
const MOST_TIMES_TO_Q: f64 = 3.0;
const GOOD_Q: f64 = 0.95;
/// Peak memory of the whole process, in MB.
const MOST_MB: f64 = 250.0;

/// Rows of a bar by OS-SART and by OS-MART.
fn both<'a>(report: &'a Report<'a>, bar: Bar) -> [Vec<&'a Row>; 2] {
    let rows = report.held_against(bar);
    [Solver::OsSart, Solver::OsMart].map(|solver| {
        let of = |row: &&Row| report.suite.solver_of(&row.method) == Some(solver);
        rows.iter().copied().filter(of).collect()
    })
}

/// Seconds and error of a pair over OS-MART's in the same run: medians and means over the seeds, the
/// worst component.
pub(super) fn pair(report: &Report) -> Vec<Candidate> {
    let [sart, mart] = both(report, Bar::OsSartPair);
    let judged = MOST_TIMES.into_iter().filter_map(|(ppm, most)| {
        let [sart, mart] = [&sart, &mart].map(|rows| -> Vec<&Row> {
            rows.iter().copied().filter(|row| row.ppm == ppm).collect()
        });
        let times = median(&sart, |row| row.seconds)? / median(&mart, |row| row.seconds)?;
        let (own, other) = (
            mean_of_components(&sart, Row::error_vox)?,
            mean_of_components(&mart, Row::error_vox)?,
        );
        let error = own.iter().zip(other).map(|(own, other)| own / other).fold(0.0, f64::max);
        let measured = format!("{} × at {} × the error at {ppm} ppm", number(times), number(error));
        Some(at_most(measured, &[(times, most), (error, MOST_ERROR)]))
    });
    all_of(judged.collect())
}

/// The largest peak of the whole process.
pub(super) fn memory(report: &Report) -> Vec<Candidate> {
    let [sart, _] = both(report, Bar::OsSartMemory);
    let most = sart.iter().filter_map(|row| row.peak_mb).reduce(f64::max);
    most.map(|most| at_most(format!("{} MB", number(most)), &[(most, MOST_MB)]))
        .into_iter()
        .collect()
}

/// Seconds to a good Q over OS-MART's, each in as few passes as reach it.
pub(super) fn to_good_q(report: &Report) -> Vec<Candidate> {
    let rows = both(report, Bar::OsSartOnGrid);
    if rows.iter().any(Vec::is_empty) {
        return Vec::new();
    }
    let good = |rows: Vec<&Row>| {
        let reached = rows.into_iter().filter(|row| row.q.is_some_and(|q| q >= GOOD_Q));
        let row = fastest(reached)?;
        Some((row.seconds?, row.q?))
    };
    match rows.map(good) {
        [Some((own_s, own_q)), Some((other_s, other_q))] => {
            let times = own_s / other_s;
            let measured =
                format!("{} × at Q {} against {}", number(times), number(own_q), number(other_q));
            vec![at_most(measured, &[(times, MOST_TIMES_TO_Q)])]
        }
        _ => vec![missed("not both reach it".to_owned())],
    }
}
