//! What the program must reach: bar, measured figure, verdict.

use serde::Serialize;

use super::{
    Report,
    figures::{convergence::accelerations, growth::voxels},
    svg::number,
    tables::{mean, median},
};
use crate::benchmark::{Bar, Row};

/// In every bar the floor is the smaller of our own and this, in voxels: a worse correlator must
/// not make a ratio easier.
const FLOOR_1_PPM_VOX: f64 = 0.068;
const FLOOR_03_PPM_VOX: f64 = 0.095;

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
    pub work: &'static str,
    /// What is asked for.
    pub bar: &'static str,
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
    let row = |work, bar, candidates: Vec<Candidate>| {
        let best = candidates
            .into_iter()
            .min_by(|a, b| b.met.cmp(&a.met).then(a.distance.total_cmp(&b.distance)));
        match best {
            None => {
                Reached { work, bar, measured: "–".to_owned(), verdict: Verdict::NotMeasured }
            }
            Some(best) => {
                let verdict = if best.met { Verdict::Met } else { Verdict::Missed };
                Reached { work, bar, measured: best.measured, verdict }
            }
        }
    };
    let process = |bar, floor, seconds, times| process(report, bar, floor, seconds, times);
    vec![
        row(
            "Four raw images to velocity, 100 × 80 × 80 voxels, 1 ppm, off-grid, noise",
            "≤ 1.5 s at ≤ 1.4 × the floor",
            process(Bar::Process1Ppm, FLOOR_1_PPM_VOX, 1.5, 1.4),
        ),
        row(
            "The same, accurate",
            "≤ 3 s at ≤ 1.15 × the floor",
            process(Bar::Process1Ppm, FLOOR_1_PPM_VOX, 3.0, 1.15),
        ),
        row(
            "The same at 0.3 ppm",
            "≤ 0.7 s at ≤ 1.3 × the floor",
            process(Bar::Process03Ppm, FLOOR_03_PPM_VOX, 0.7, 1.3),
        ),
        row(
            "The floor: true particles, ABC flow of 2 voxels amplitude, 1 ppm, a vector per 0.8 mm",
            "< 0.04 voxel",
            floor(report),
        ),
        row(
            "Reconstruction at the Q of ASTRA's SART or better, full volume",
            "≥ 15 × faster",
            against_astra(report, false, 15.0),
        ),
        row(
            "The same, ASTRA on active voxels only",
            "≥ 4 × faster",
            against_astra(report, true, 4.0),
        ),
        row("OS-SART against SART at Q = 0.75", "≥ 2 × faster", acceleration(report)),
        row(
            "The fast solver against OS-SART at its own final Q",
            "≥ 100 × faster",
            against_os_sart(report),
        ),
        row(
            "3-D correlation against OpenPIV, same volumes and windows",
            "≥ 10 × faster per vector, ≤ half the error",
            against_openpiv(report),
        ),
        row("Peak memory of the whole process, 100³ voxels", "≤ 400 MB", memory(report)),
        row(
            "Time and memory from 50³ to 200³ voxels at fixed ppm",
            "grow no faster than the voxels",
            growth(report),
        ),
        row(
            "The paper's ring vortex, 1 ppm, on-grid: σ of v and w",
            "≤ 1.15 × the floor and ≤ 0.06 voxel",
            ring_error(report),
        ),
        row("The same at 1.6 ppm: v and w within 0.3 voxel", "≥ 99 %", ring_within(report)),
        row(
            "Elongation, two cameras, on-grid, voxels of 0.1 mm, −10 to 10 mm",
            "one voxel: 0.1 mm",
            elongation(report, Bar::ElongationOnGrid, 0.1, f64::INFINITY),
        ),
        row(
            "Elongation, off-grid, voxels of 0.05 mm, 200 random places",
            "mean ≤ 0.12 mm, depth centroid error ≤ 0.03 mm",
            elongation(report, Bar::ElongationOffGrid, 0.12, 0.03),
        ),
    ]
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

/// The largest component's error over its floor, each a mean over the seeds.
fn times_floor(rows: &[&Row], components: &[usize], known_vox: f64) -> Option<f64> {
    components
        .iter()
        .map(|&axis| {
            let error = mean(rows, |row| row.error_vox().map(|error| error[axis]))?;
            let floor = mean(rows, |row| row.floor_vox().map(|floor| floor[axis]))?;
            Some(error / floor.min(known_vox))
        })
        .try_fold(0.0, |largest: f64, times| Some(largest.max(times?)))
}

fn process(report: &Report, bar: Bar, known_vox: f64, most_s: f64, most: f64) -> Vec<Candidate> {
    candidates(report, bar, |rows| {
        let seconds = median(rows, |row| row.seconds)?;
        let ratio = median(rows, |row| row.kernel_ratio)?;
        let times = times_floor(rows, &[0, 1, 2], known_vox)?;
        let measured = format!(
            "{} s ({} × the reference kernel) at {} × the floor",
            number(seconds),
            number(ratio),
            number(times)
        );
        Some(at_most(measured, &[(seconds, most_s), (times, most)]))
    })
}

fn floor(report: &Report) -> Vec<Candidate> {
    candidates(report, Bar::Floor, |rows| {
        let component = |axis: usize| mean(rows, |row| row.floor_vox().map(|floor| floor[axis]));
        let floor = [component(0)?, component(1)?, component(2)?];
        let most = floor.into_iter().fold(0.0, f64::max);
        let measured = format!("{} voxel", floor.map(number).join(", "));
        Some(at_most(measured, &[(most, 0.04)]))
    })
}

/// Ours against a peer's rows on the same case; the fastest of ours that is at least as good.
fn against_astra(report: &Report, active: bool, least: f64) -> Vec<Candidate> {
    let ours = report.held_against(Bar::AgainstAstra);
    let peers = report.peers.iter().filter(|row| {
        let astra = row.peer.as_deref().is_some_and(|peer| peer.to_lowercase().contains("astra"));
        astra && row.method.contains("active") == active
    });
    peers
        .filter_map(|peer| {
            let (peer_s, peer_q) = (peer.seconds?, peer.q?);
            let good = |row: &&&Row| row.case == peer.case && row.q.is_some_and(|q| q >= peer_q);
            let fastest = ours.iter().filter(good).min_by(|a, b| {
                a.seconds.unwrap_or(f64::MAX).total_cmp(&b.seconds.unwrap_or(f64::MAX))
            })?;
            let gain = peer_s / fastest.seconds?;
            let measured = format!(
                "{} × at Q {} against {} ({})",
                number(gain),
                number(fastest.q?),
                number(peer_q),
                report.label(fastest)
            );
            Some(at_most(measured, &[(least, gain)]))
        })
        .collect()
}

fn acceleration(report: &Report) -> Vec<Candidate> {
    let gains = accelerations(report);
    let ratios: Option<Vec<f64>> = gains.iter().map(|gain| gain.ratio).collect();
    let Some(ratios) = ratios.filter(|ratios| !ratios.is_empty()) else { return Vec::new() };
    let least = ratios.iter().copied().fold(f64::INFINITY, f64::min);
    let each: Vec<String> = gains
        .iter()
        .zip(&ratios)
        .map(|(gain, ratio)| format!("{} × at {} ppm", number(*ratio), gain.ppm))
        .collect();
    vec![at_most(each.join(", "), &[(2.0, least)])]
}

fn against_os_sart(report: &Report) -> Vec<Candidate> {
    let rows = report.held_against(Bar::AgainstOsSart);
    let paper = rows.iter().filter(|row| report.label(row).starts_with("OS-SART"));
    paper
        .filter_map(|slow| {
            let (slow_s, slow_q) = (slow.seconds?, slow.q?);
            let better = |row: &&&Row| {
                !report.label(row).contains("SART")
                    && (row.ppm, row.cameras, &row.case) == (slow.ppm, slow.cameras, &slow.case)
                    && row.q.is_some_and(|q| q >= slow_q)
            };
            let fast = rows.iter().filter(better).min_by(|a, b| {
                a.seconds.unwrap_or(f64::MAX).total_cmp(&b.seconds.unwrap_or(f64::MAX))
            });
            let Some(fast) = fast else {
                let measured = format!("none reaches its Q {} at {} ppm", number(slow_q), slow.ppm);
                return Some(Candidate { measured, met: false, distance: f64::MAX });
            };
            let gain = slow_s / fast.seconds?;
            let measured = format!(
                "{} × at {} ppm, Q {} against {} ({})",
                number(gain),
                slow.ppm,
                number(fast.q?),
                number(slow_q),
                report.label(fast)
            );
            Some(at_most(measured, &[(100.0, gain)]))
        })
        // The hardest density counts.
        .max_by(|a, b| a.distance.total_cmp(&b.distance))
        .into_iter()
        .collect()
}

fn against_openpiv(report: &Report) -> Vec<Candidate> {
    let ours = report.held_against(Bar::AgainstOpenpiv);
    let per_vector = |seconds: f64, row: &Row| Some(seconds / row.vectors? as f64);
    let error = |row: &Row| row.error_vox().map(|e| e.iter().sum::<f64>() / 3.0);
    let peers = report
        .peers
        .iter()
        .filter(|row| row.peer.as_deref().is_some_and(|p| p.to_lowercase().contains("openpiv")));
    peers
        .filter_map(|peer| {
            let row = ours.iter().find(|row| row.case == peer.case)?;
            let gain = per_vector(peer.seconds?, peer)? / per_vector(row.correlate_s?, row)?;
            let share = error(row)? / error(peer)?;
            let measured = format!("{} × per vector, {} of the error", number(gain), number(share));
            Some(at_most(measured, &[(10.0, gain), (share, 0.5)]))
        })
        .collect()
}

fn memory(report: &Report) -> Vec<Candidate> {
    candidates(report, Bar::Memory, |rows| {
        let most = rows.iter().filter_map(|row| row.peak_mb).reduce(f64::max)?;
        Some(at_most(format!("{} MB", number(most)), &[(most, 400.0)]))
    })
}

fn growth(report: &Report) -> Vec<Candidate> {
    candidates(report, Bar::Growth, |rows| {
        let mut rows = rows.to_vec();
        rows.sort_by(|a, b| voxels(a).total_cmp(&voxels(b)));
        let steps: Vec<(f64, f64)> = rows
            .windows(2)
            .filter_map(|pair| {
                let voxels = voxels(pair[1]) / voxels(pair[0]);
                let time = pair[1].seconds? / pair[0].seconds?;
                let memory = pair[1].peak_mb? / pair[0].peak_mb?;
                Some((time / voxels, memory / voxels))
            })
            .collect();
        if steps.is_empty() {
            return None;
        }
        let each: Vec<String> = steps
            .iter()
            .map(|(time, memory)| format!("time {}, memory {}", number(*time), number(*memory)))
            .collect();
        let most = steps.iter().map(|(time, memory)| time.max(*memory)).fold(0.0, f64::max);
        Some(at_most(format!("growth over the voxels': {}", each.join("; ")), &[(most, 1.0)]))
    })
}

fn ring_error(report: &Report) -> Vec<Candidate> {
    candidates(report, Bar::Ring1Ppm, |rows| {
        let component = |axis: usize| mean(rows, |row| row.error_vox().map(|error| error[axis]));
        let (v, w) = (component(1)?, component(2)?);
        let times = times_floor(rows, &[1, 2], FLOOR_1_PPM_VOX)?;
        let measured =
            format!("{} and {} voxel, {} × the floor", number(v), number(w), number(times));
        Some(at_most(measured, &[(v.max(w), 0.06), (times, 1.15)]))
    })
}

fn ring_within(report: &Report) -> Vec<Candidate> {
    candidates(report, Bar::Ring16Ppm, |rows| {
        let component = |axis: usize| mean(rows, |row| row.within().map(|within| within[axis]));
        let (v, w) = (component(1)?, component(2)?);
        let measured = format!("{:.2} % and {:.2} %", 100.0 * v, 100.0 * w);
        Some(at_most(measured, &[(0.99, v), (0.99, w)]))
    })
}

/// The widest particle or the mean of the random ones, and the centroid's error.
fn elongation(report: &Report, bar: Bar, most_mm: f64, most_off_mm: f64) -> Vec<Candidate> {
    candidates(report, bar, |rows| {
        let width = rows.iter().filter_map(|row| row.fwhm_mm).reduce(f64::max)?;
        let off = rows.iter().filter_map(|row| row.centroid_error_mm).reduce(f64::max)?;
        let measured = format!("{} mm, centroid off by {} mm", number(width), number(off));
        Some(at_most(measured, &[(width, most_mm), (off, most_off_mm)]))
    })
}
