//! `lfpiv statistics`: ensemble statistics of a run's shots.

use std::{
    ops::RangeInclusive,
    path::PathBuf,
    time::{Duration, Instant},
};

use anyhow::bail;
use lfpiv_core::{
    ensemble::{Ensemble, Estimate, Estimates, Quantity, Snapshot},
    statistics::median,
};

use super::{
    output::{count, print, progress_bar},
    shot_range::shot_range,
};
use crate::archive::{StoredShot, StoredShots, write_statistics};

/// Arguments of `lfpiv statistics`.
#[derive(Debug, clap::Args)]
pub struct StatisticsArgs {
    /// Folder of the run, or an output folder of `lfpiv process`.
    #[arg(value_name = "RUN")]
    pub run: PathBuf,
    /// File for the statistics at every point (NetCDF); default: statistics.nc in the run's folder.
    #[arg(long, value_name = "FILE")]
    pub out: Option<PathBuf>,
    /// Only these shots: a number, or first and last as A..B.
    #[arg(long, value_name = "A..B", value_parser = shot_range)]
    pub shots: Option<RangeInclusive<u64>>,
}

/// Reads the stored vectors once, writes the statistics and prints medians over the points.
pub fn statistics(args: &StatisticsArgs) -> anyhow::Result<()> {
    let mut stored = StoredShots::find(&args.run)?;
    let all = stored.len();
    stored.retain(|shot| args.shots.as_ref().is_none_or(|range| range.contains(&shot)));
    if stored.is_empty() {
        let run = args.run.display();
        match all {
            0 => bail!("{run} contains no results: is it the folder of a run?"),
            _ => bail!("{run} has none of these shots: it has results of {}", count(all, "shot")),
        }
    }
    let configuration = stored.configuration()?;
    let bar = progress_bar(stored.len(), "shots");
    let mut ensemble: Option<Ensemble> = None;
    let mut spent = Duration::ZERO;
    stored.for_each(|shot| {
        let ensemble = ensemble.get_or_insert_with(|| Ensemble::new(shot.grid.clone()));
        let began = Instant::now();
        add(ensemble, &shot)?;
        spent += began.elapsed();
        bar.inc(1);
        anyhow::Ok(())
    })?;
    bar.finish_and_clear();
    let Some(ensemble) = ensemble else { return Ok(()) };
    let out = args.out.clone().unwrap_or_else(|| args.run.join("statistics.nc"));
    write_statistics(&out, &configuration, &ensemble)?;
    print(&summary(&ensemble))?;
    let per_shot_ms = 1e3 * spent.as_secs_f64() / stored.len() as f64;
    print(&format!("{per_shot_ms:.2} ms per shot, without reading"))?;
    print(&format!("all points: {}", out.display()))
}

fn add(ensemble: &mut Ensemble, shot: &StoredShot) -> anyhow::Result<()> {
    if *ensemble.grid() != shot.grid {
        bail!(
            "the vector grid of shot {} differs from that of earlier shots: select shots of one \
             configuration at a time, with --shots A..B",
            shot.shot
        );
    }
    let StoredShot { velocity_m_s, uncertainty_m_s, status, .. } = shot;
    ensemble.add(&Snapshot::new(shot.shot, velocity_m_s, uncertainty_m_s, status));
    Ok(())
}

/// Medians over the points, and properties of the run as a whole, as a table.
fn summary(ensemble: &Ensemble) -> String {
    let estimates = ensemble.estimates();
    let counts: Vec<f64> = estimates.counts.iter().map(|count| *count as f64).collect();
    let mut lines = vec![format!(
        "{}, {}, {:.0} valid vectors at the median point",
        count(ensemble.shots() as usize, "shot"),
        count(counts.len(), "point"),
        median(counts.iter().copied()).unwrap_or_default()
    )];
    lines.push(format!("{:34}{:>12}{:>12}{:>12}", "median over the points, m/s", "u", "v", "w"));
    let mut row = |name: &str, of: &dyn Fn(usize) -> Option<f64>| {
        let cell = |c: usize| of(c).map_or("-".to_owned(), |number| format!("{number:.4}"));
        lines.push(format!("{name:34}{:>12}{:>12}{:>12}", cell(0), cell(1), cell(2)));
    };
    let mean = |part: fn(&Estimate) -> f64| {
        let estimates = &estimates;
        move |c: usize| middle(estimates, Quantity::Mean(c), part)
    };
    row("mean", &mean(|e| e.value));
    row("  standard uncertainty", &mean(Estimate::uncertainty));
    row("  part due to the flow", &mean(|e| e.flow_uncertainty));
    row("  part due to the measurement", &mean(|e| e.measurement_uncertainty));
    row("rms of the flow", &|c| middle(&estimates, Quantity::Rms(c), |e| e.value));
    row("  standard uncertainty", &|c| middle(&estimates, Quantity::Rms(c), Estimate::uncertainty));
    row("skewness (a number)", &|c| middle(&estimates, Quantity::Skewness(c), |e| e.value));
    for correlation in ensemble.correlations() {
        let scales = correlation.integral_scale_mm();
        let axis = ["x", "y", "z"][correlation.axis];
        row(&format!("integral scale along {axis} (mm)"), &|c| scales[c]);
    }
    lines.join("\n")
}

fn middle(estimates: &Estimates, quantity: Quantity, part: fn(&Estimate) -> f64) -> Option<f64> {
    median(estimates.of(quantity).iter().flatten().map(part))
}
