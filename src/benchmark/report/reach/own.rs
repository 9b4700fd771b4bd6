//! Bars on our own figures: error beside the floor, seconds, memory, width.

use super::{
    super::{
        Report,
        figures::growth::voxels,
        svg::number,
        tables::{mean, median},
    },
    Candidate, FLOOR_1_PPM_VOX, at_most, candidates,
};
use crate::benchmark::{Bar, Row};

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

/// Seconds of the whole process, and error over the floor, together.
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

/// The worst component of the floor.
pub(super) fn floor(report: &Report) -> Vec<Candidate> {
    candidates(report, Bar::Floor, |rows| {
        let component = |axis: usize| mean(rows, |row| row.floor_vox().map(|floor| floor[axis]));
        let floor = [component(0)?, component(1)?, component(2)?];
        let most = floor.into_iter().fold(0.0, f64::max);
        let measured = format!("{} voxel", floor.map(number).join(", "));
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
        let component = |axis: usize| mean(rows, |row| row.error_vox().map(|error| error[axis]));
        let (v, w) = (component(1)?, component(2)?);
        let times = times_floor(rows, &[1, 2], FLOOR_1_PPM_VOX)?;
        let measured =
            format!("{} and {} voxel, {} × the floor", number(v), number(w), number(times));
        Some(at_most(measured, &[(v.max(w), 0.06), (times, 1.15)]))
    })
}

/// Shares of v and w within 0.3 voxels.
pub(super) fn ring_within(report: &Report) -> Vec<Candidate> {
    candidates(report, Bar::Ring16Ppm, |rows| {
        let component = |axis: usize| mean(rows, |row| row.within().map(|within| within[axis]));
        let (v, w) = (component(1)?, component(2)?);
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
