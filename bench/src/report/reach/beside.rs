//! Cases that may cost no more than others of the same run: cameras that are not as drawn, and known.

use super::{
    super::{
        Report,
        tables::{mean, mean_error, median},
        text::number,
    },
    Reached, Verdict,
};
use crate::{Beside, Case, Row};

/// A row for every case that is held against another, where both were measured.
pub(super) fn beside(report: &Report) -> Vec<Reached> {
    let judged = |case: &Case| Some(judge(report, case, case.beside.as_ref()?));
    report.suite.cases.iter().filter_map(judged).collect()
}

fn judge(report: &Report, case: &Case, beside: &Beside) -> Reached {
    let rows = |name: &str| -> Vec<&Row> {
        report.record.rows.iter().filter(|row| row.case == name).collect()
    };
    let (own, other) = (rows(&case.name), rows(&beside.case));
    let mut densities: Vec<f64> = own.iter().map(|row| row.ppm).collect();
    densities.dedup();
    let compared: Vec<(bool, String)> = densities
        .iter()
        .enumerate()
        .filter_map(|(n, &ppm)| {
            let at = |rows: &[&'_ Row]| -> Vec<Row> {
                rows.iter().filter(|row| row.ppm == ppm).map(|&row| row.clone()).collect()
            };
            compare(&at(&own), &at(&other), beside, beside.exact_error_vox.get(n).copied(), ppm)
        })
        .collect();
    let verdict = match compared.is_empty() {
        true => Verdict::NotMeasured,
        false if compared.iter().all(|(met, _)| *met) => Verdict::Met,
        false => Verdict::Missed,
    };
    let measured: Vec<String> = compared.into_iter().map(|(_, measured)| measured).collect();
    Reached {
        work: format!("{} beside {}", case.name, beside.case),
        bar: format!("≤ {} × the error, ≤ {} × the time", beside.error, beside.seconds),
        measured: measured.join("; "),
        verdict,
    }
}

/// Both cases at one density.
fn compare(
    own: &[Row],
    other: &[Row],
    beside: &Beside,
    exact_error_vox: Option<f64>,
    ppm: f64,
) -> Option<(bool, String)> {
    let (own, other): (Vec<&Row>, Vec<&Row>) = (own.iter().collect(), other.iter().collect());
    let seconds = median(&own, |row| row.seconds)? / median(&other, |row| row.seconds)?;
    let reference = match exact_error_vox {
        Some(exact) => exact,
        None => mean(&other, mean_error)?,
    };
    let error = mean(&own, mean_error)? / reference;
    let met = error <= beside.error && seconds <= beside.seconds;
    let against = if exact_error_vox.is_some() { " of the voxelwise model" } else { "" };
    let measured = format!(
        "{} × the error{against} at {} × the time, {ppm} ppm",
        number(error),
        number(seconds)
    );
    Some((met, measured))
}
