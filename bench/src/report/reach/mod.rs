//! What the program must reach: bar, measured figure, verdict.

mod beside;
mod claims;
mod own;
mod ratios;
mod solvers;

use serde::Serialize;

use super::Report;
use crate::{Bar, Row};

/// In every bar the error of the true particles by windows is the smaller of our own and this, in
/// voxels: a worse correlator must not make a ratio easier.
const WINDOWS_1_PPM_VOX: f64 = 0.068;
const WINDOWS_03_PPM_VOX: f64 = 0.095;

/// Most methods named in a bar's row, the nearest to it first.
const SHOWN: usize = 3;

/// Whether a bar is met.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// The figure is as good as asked for, or better.
    Met,
    /// It is not.
    Missed,
    /// What it needs was not part of this run.
    NotMeasured,
}

/// One bar.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Reached {
    /// The work.
    pub work: String,
    /// What is asked for.
    pub bar: String,
    /// What was measured.
    pub measured: String,
    /// Whether it is enough.
    pub verdict: Verdict,
}

/// A method on a bar: a figure for the table, and whether it is enough.
struct Candidate {
    measured: String,
    met: bool,
    /// How far it is from enough; the nearest stands for all.
    distance: f64,
}

/// Every bar of the report's first table.
pub fn reached(report: &Report) -> Vec<Reached> {
    let row = |work: &str, bar: &str, mut candidates: Vec<Candidate>| {
        candidates.sort_by(|a, b| b.met.cmp(&a.met).then(a.distance.total_cmp(&b.distance)));
        let verdict = match candidates.first() {
            None => Verdict::NotMeasured,
            Some(best) if best.met => Verdict::Met,
            Some(_) => Verdict::Missed,
        };
        let shown: Vec<String> =
            candidates.into_iter().take(SHOWN).map(|candidate| candidate.measured).collect();
        Reached { work: work.to_owned(), bar: bar.to_owned(), measured: shown.join("; "), verdict }
    };
    let mut reached = vec![
        row(
            "Four raw images to velocity, 100 × 80 × 80 voxels, 1 ppm, off-grid, noise",
            "≤ 1.5 s at ≤ 1.4 × the true particles, windows only",
            own::process(report, Bar::Process1Ppm, WINDOWS_1_PPM_VOX, 1.5, 1.4),
        ),
        row(
            "The same, accurate",
            "≤ 3 s at ≤ 1.15 × the true particles, windows only",
            own::process(report, Bar::Process1Ppm, WINDOWS_1_PPM_VOX, 3.0, 1.15),
        ),
        row(
            "The same at 0.3 ppm",
            "≤ 0.7 s at ≤ 1.3 × the true particles, windows only",
            own::process(report, Bar::Process03Ppm, WINDOWS_03_PPM_VOX, 0.7, 1.3),
        ),
        row(
            "True particles, windows only: ABC flow, components up to 2 voxels, 1 ppm, a vector per \
             0.8 mm",
            "< 0.04 voxel",
            own::true_particles(report),
        ),
        row(
            "Reconstruction at the best Q of ASTRA's SART or better, full volume",
            "≥ 15 × faster",
            ratios::against_astra(report, false, 15.0),
        ),
        row(
            "The same, ASTRA on active voxels only",
            "≥ 4 × faster",
            ratios::against_astra(report, true, 4.0),
        ),
        row("OS-SART against SART at Q = 0.75", "≥ 2 × faster", ratios::acceleration(report)),
        row(
            "The fast solver against OS-SART at its own final Q",
            "≥ 100 × faster",
            ratios::against_os_sart(report),
        ),
        row(
            "3-D correlation against OpenPIV's single pass, same volumes and windows",
            "≥ 10 × faster per vector, ≤ half the error",
            ratios::against_openpiv(report),
        ),
        row("Peak memory of the whole process, 100³ voxels", "≤ 400 MB", own::memory(report)),
        row(
            "Time and memory from 50³ to 200³ voxels at fixed ppm",
            "grow no faster than the voxels",
            own::growth(report),
        ),
        row(
            "The paper's ring vortex, 1 ppm, on-grid: σ of v and w",
            "≤ 1.15 × the true particles, windows only, and ≤ 0.06 voxel",
            own::ring_error(report),
        ),
        row("The same at 1.6 ppm: v and w within 0.3 voxel", "≥ 99 %", own::ring_within(report)),
        row(
            "Elongation, two cameras, on-grid, voxels of 0.1 mm, −10 to 10 mm",
            "one voxel: 0.10 mm, to 0.005",
            own::elongation(report, Bar::ElongationOnGrid, 0.105, f64::INFINITY),
        ),
        row(
            "Elongation, off-grid, voxels of 0.05 mm, 200 random places",
            "mean ≤ 0.12 mm, depth centroid error ≤ 0.03 mm",
            own::elongation(report, Bar::ElongationOffGrid, 0.12, 0.03),
        ),
        row(
            "OS-SART beside OS-MART: a pair of the shipped bench, 0.3 and 1 ppm, off-grid, noise",
            "≤ 2 and ≤ 3 × the time, ≤ 1.5 × the error",
            solvers::pair(report),
        ),
        row("OS-SART: peak memory of the whole process", "≤ 250 MB", solvers::memory(report)),
        row(
            "OS-SART beside OS-MART: 100³ voxels, 1 ppm, on-grid, to Q = 0.95",
            "≤ 3 × the time",
            solvers::to_good_q(report),
        ),
    ];
    reached.extend(beside::beside(report));
    reached.extend(claims::claims(report));
    reached
}

/// One candidate per group of rows of a bar that have the same method and number of cameras.
fn candidates(
    report: &Report,
    bar: Bar,
    judge: impl Fn(&[&Row]) -> Option<Candidate>,
) -> Vec<Candidate> {
    let rows = report.held_against(bar);
    let mut keys: Vec<(&str, usize)> = Vec::new();
    for row in &rows {
        if !keys.contains(&(row.method.as_str(), row.cameras)) {
            keys.push((&row.method, row.cameras));
        }
    }
    let group = |(method, cameras): (&str, usize)| {
        let same = |row: &&Row| row.method == method && row.cameras == cameras;
        let rows: Vec<&Row> = rows.iter().copied().filter(same).collect();
        let mut candidate = judge(&rows)?;
        candidate.measured = format!("{} ({})", candidate.measured, report.label(rows[0]));
        Some(candidate)
    };
    keys.into_iter().filter_map(group).collect()
}

/// A figure that must not exceed its bar.
fn at_most(measured: String, figures: &[(f64, f64)]) -> Candidate {
    let distance = figures.iter().map(|(figure, bar)| figure / bar).fold(0.0, f64::max);
    Candidate { measured, met: distance <= 1.0 + 1e-9, distance }
}

/// What must hold of every case.
fn all_of(candidates: Vec<Candidate>) -> Vec<Candidate> {
    if candidates.is_empty() {
        return candidates;
    }
    let each: Vec<&str> = candidates.iter().map(|candidate| candidate.measured.as_str()).collect();
    vec![Candidate {
        measured: each.join("; "),
        met: candidates.iter().all(|candidate| candidate.met),
        distance: candidates.iter().map(|candidate| candidate.distance).fold(0.0, f64::max),
    }]
}

fn missed(measured: String) -> Candidate {
    Candidate { measured, met: false, distance: f64::INFINITY }
}
