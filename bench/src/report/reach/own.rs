//! Bars on our own figures: error beside that of the true particles, seconds, memory, width.

use super::{
    super::{
        Report,
        figures::growth::voxels,
        tables::{mean, mean_of_components, median},
        text::number,
    },
    Candidate, WINDOWS_1_PPM_VOX, at_most, candidates,
};
use crate::{Bar, Row};

/// The largest component's error over that of the true particles, each a mean over the seeds.
fn times(
    rows: &[&Row],
    components: &[usize],
    true_particles_vox: impl Fn(&Row) -> Option<[f64; 3]>,
    known_vox: f64,
) -> Option<f64> {
    components
        .iter()
        .map(|&axis| {
            let error = mean(rows, |row| row.error_vox().map(|error| error[axis]))?;
            let least = mean(rows, |row| true_particles_vox(row).map(|error| error[axis]))?;
            Some(error / least.min(known_vox))
        })
        .try_fold(0.0, |largest: f64, times| Some(largest.max(times?)))
}

/// The same in words, beside the true particles by windows (against which bars are set) and followed;
/// and the first of the two.
fn beside_true_particles(
    rows: &[&Row],
    components: &[usize],
    known_vox: f64,
) -> Option<(String, f64)> {
    let windows = times(rows, components, Row::true_windows_vox, known_vox)?;
    let mut text = format!("{} × the true particles, windows only", number(windows));
    if let Some(followed) = times(rows, components, Row::true_followed_vox, f64::INFINITY) {
        text += &format!(" ({} × followed)", number(followed));
    }
    Some((text, windows))
}

/// Seconds of the whole process, and error over that of the true particles, together.
pub(super) fn process(
    report: &Report,
    bar: Bar,
    known_vox: f64,
    most_s: f64,
    most: f64,
) -> Vec<Candidate> {
    candidates(report, bar, |rows| {
        let seconds = median(rows, |row| row.seconds)?;
        let ratio = median(rows, |row| row.kernel_ratio)?;
        let (beside, times) = beside_true_particles(rows, &[0, 1, 2], known_vox)?;
        let measured =
            format!("{} s ({} × the reference kernel) at {beside}", number(seconds), number(ratio));
        Some(at_most(measured, &[(seconds, most_s), (times, most)]))
    })
}

/// The worst component of the true particles by windows alone.
pub(super) fn true_particles(report: &Report) -> Vec<Candidate> {
    candidates(report, Bar::TrueParticles, |rows| {
        let windows = mean_of_components(rows, Row::true_windows_vox)?;
        let most = windows.into_iter().fold(0.0, f64::max);
        let mut measured = format!("{} voxel", windows.map(number).join(", "));
        if let Some(followed) = mean_of_components(rows, Row::true_followed_vox) {
            measured += &format!(" (followed: {})", followed.map(number).join(", "));
        }
        Some(at_most(measured, &[(most, 0.04)]))
    })
}

/// The largest peak.
pub(super) fn memory(report: &Report) -> Vec<Candidate> {
    candidates(report, Bar::Memory, |rows| {
        let most = rows.iter().filter_map(|row| row.peak_mb).reduce(f64::max)?;
        Some(at_most(format!("{} MB", number(most)), &[(most, 400.0)]))
    })
}

/// From each size to the next: growth of time and memory over that of the voxels.
pub(super) fn growth(report: &Report) -> Vec<Candidate> {
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

/// σ of v and w, alone and over the floor.
pub(super) fn ring_error(report: &Report) -> Vec<Candidate> {
    candidates(report, Bar::Ring1Ppm, |rows| {
        let [_, v, w] = mean_of_components(rows, Row::error_vox)?;
        let (beside, times) = beside_true_particles(rows, &[1, 2], WINDOWS_1_PPM_VOX)?;
        let measured = format!("{} and {} voxel, {beside}", number(v), number(w));
        Some(at_most(measured, &[(v.max(w), 0.06), (times, 1.15)]))
    })
}

/// Shares of v and w within 0.3 voxels.
pub(super) fn ring_within(report: &Report) -> Vec<Candidate> {
    candidates(report, Bar::Ring16Ppm, |rows| {
        let [_, v, w] = mean_of_components(rows, Row::within)?;
        let measured = format!("{:.2} % and {:.2} %", 100.0 * v, 100.0 * w);
        Some(at_most(measured, &[(0.99, v), (0.99, w)]))
    })
}

/// The widest particle or the mean of the random ones, and the centroid's error.
pub(super) fn elongation(
    report: &Report,
    bar: Bar,
    most_mm: f64,
    most_off_mm: f64,
) -> Vec<Candidate> {
    candidates(report, bar, |rows| {
        let width = rows.iter().filter_map(|row| row.fwhm_mm).reduce(f64::max)?;
        let off = rows.iter().filter_map(|row| row.centroid_error_mm).reduce(f64::max)?;
        let measured = format!("{} mm, centroid off by {} mm", number(width), number(off));
        Some(at_most(measured, &[(width, most_mm), (off, most_off_mm)]))
    })
}
