//! Cases that may cost no more than others of the same run: cameras that are not as drawn, and known;
//! and cases that must be refused: cameras that are not as drawn, and not known.

use super::{
    super::{
        Report,
        tables::{mean, mean_error, median},
        text::number,
    },
    Reached, Verdict,
};
use crate::{Beside, Case, Row};

/// A row for every case that is held against another, where both were measured, and for every case that
/// must be refused.
pub(super) fn beside(report: &Report) -> Vec<Reached> {
    let judged = |case: &Case| match &case.beside {
        Some(beside) => Some(judge(report, case, beside)),
        None => case.refused.then(|| refused(report, case)),
    };
    report.suite.cases.iter().filter_map(judged).collect()
}

/// Whether no vector of the case's fields is valid.
fn refused(report: &Report, case: &Case) -> Reached {
    let rows = report.record.rows.iter().filter(|row| row.case == case.name);
    let shares: Vec<f64> = rows.filter_map(|row| row.valid_share).collect();
    let most = shares.iter().copied().fold(0.0, f64::max);
    let verdict = match shares.is_empty() {
        true => Verdict::NotMeasured,
        false if most == 0.0 => Verdict::Met,
        false => Verdict::Missed,
    };
    Reached {
        work: case.name.clone(),
        bar: "no valid vector, and a warning that says why".to_owned(),
        measured: format!("{} % valid at most, {} fields", number(100.0 * most), shares.len()),
        verdict,
    }
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
    let intervals = beside.intervals_within.map_or(String::new(), |points| {
        format!(", 68 and 95 % intervals hold within {points} points")
    });
    Reached {
        work: format!("{} beside {}", case.name, beside.case),
        bar: format!("≤ {} × the error, ≤ {} × the time{intervals}", beside.error, beside.seconds),
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
    let mut met = error <= beside.error && seconds <= beside.seconds;
    let mut intervals = String::new();
    if let Some(points) = beside.intervals_within {
        let percent = [mean(&own, |row| row.covered_68)?, mean(&own, |row| row.covered_95)?];
        let [covered_68, covered_95] = percent.map(|share| 100.0 * share);
        met &= (covered_68 - 68.0).abs() <= points && (covered_95 - 95.0).abs() <= points;
        intervals = format!(", {} and {} % covered", number(covered_68), number(covered_95));
    }
    let against = if exact_error_vox.is_some() { " of the voxelwise model" } else { "" };
    let measured = format!(
        "{} × the error{against} at {} × the time{intervals}, {ppm} ppm",
        number(error),
        number(seconds)
    );
    Some((met, measured))
}
