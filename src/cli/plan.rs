//! `lfpiv plan`: forecasts how well a bench will measure.

mod changes;
mod chart;

use std::{fmt::Write as _, fs, path::PathBuf};

use anyhow::{Context, bail};
use indicatif::ProgressBar;
use lfpiv_core::{
    measurement::{Forecast, ForecastPlace, SceneConditions, bound, forecast},
    statistics::median,
    velocimetry::correlation_error_vox,
};
use lfpiv_sim::Scene;

use self::{changes::Change, chart::chart_svg};
use super::output::{print, progress_bar};
use crate::config::{Config, ConfigFile, Purpose};

/// Arguments of `lfpiv plan`.
#[derive(Debug, clap::Args)]
pub struct PlanArgs {
    /// Configuration file (TOML). Its [simulation] table, if present, gives seeding and light: ppm,
    /// particle_photoelectrons and the sensor.
    #[arg(long, value_name = "FILE")]
    pub config: PathBuf,
    /// Particles per microlens, instead of the configuration's.
    #[arg(long, value_name = "PPM")]
    pub ppm: Option<f64>,
    /// Also write a chart of the uncertainty over the volume to this file.
    #[arg(long, value_name = "FILE")]
    pub svg: Option<PathBuf>,
}

/// Forecasts the uncertainty over the volume, and what would improve it most.
pub fn plan(args: &PlanArgs) -> anyhow::Result<()> {
    let config = ConfigFile::load_for(Purpose::Images, &args.config)?.config;
    let scene = config.simulation.clone().unwrap_or_default();
    if config.simulation.is_none() {
        tracing::warn!(
            "{} has no [simulation] table, which would give light and seeding: \
             assuming {} particles per microlens with {} photo-electrons each",
            args.config.display(),
            scene.ppm,
            scene.particle_photoelectrons
        );
    }
    let mut conditions = conditions(&scene);
    if let Some(ppm) = args.ppm {
        if !(ppm > 0.0 && ppm.is_finite()) {
            bail!("--ppm {ppm}: seeding must be greater than 0");
        }
        conditions.ppm = ppm;
    }
    let measurement = config.measurement();
    let impossible = || format!("no forecast is possible for {}", args.config.display());
    let held = bound(&measurement, &conditions).with_context(impossible)?;
    let changes = changes::changes(&config, &conditions);
    let bar = progress_bar(1 + changes.len(), "benches");
    bar.tick();
    let measured = forecast(&measurement, &conditions).with_context(impossible)?;
    bar.inc(1);
    bar.suspend(|| print(&report(&config, &conditions, &measured, &held)))?;
    let improvements = improvements(changes, &measured.places, &bar);
    bar.finish_and_clear();
    print(&improvements)?;
    if let Some(path) = &args.svg {
        let drawing = chart_svg(&measured.places, metres_per_second_per_voxel(&config));
        fs::write(path, drawing).with_context(|| format!("cannot write {}", path.display()))?;
        print(&format!("chart written to {}", path.display()))?;
    }
    Ok(())
}

/// Seeding and light of a scene, for one exposure of an average camera.
fn conditions(scene: &Scene) -> SceneConditions {
    let sensor = &scene.sensor;
    SceneConditions {
        ppm: scene.ppm,
        intensity_spread: scene.intensity_spread,
        photoelectrons: scene.particle_photoelectrons,
        background_electrons: sensor.background_electrons,
        read_noise_electrons: sensor.read_noise_electrons,
        counts_per_electron: sensor.gain_counts_per_electron,
        offset_counts: sensor.offset_counts,
        saturation_counts: sensor.saturation_counts(),
        diffraction_nm: scene.diffraction.then_some(scene.wavelength_nm),
    }
}

fn metres_per_second_per_voxel(config: &Config) -> f64 {
    config.volume.voxel_mm * 1e3 / config.shot.dt_us
}

/// The uncertainty in slabs along each axis, as text, from what is `measured` in trials; `held` is the bound.
fn report(
    config: &Config,
    conditions: &SceneConditions,
    measured: &Forecast,
    held: &[ForecastPlace],
) -> String {
    let speed = metres_per_second_per_voxel(config);
    let Forecast { places, valid_share, pairs } = measured;
    let ([u, v, w], [x, y, z]) = (root_mean_squares(places), medians(held));
    let mut text = format!(
        "Standard uncertainty of a vector to expect at {} particles per microlens: {u:.4}, {v:.4}, {w:.4} \
         voxel along x, y, z ({:.4}, {:.4}, {:.4} m/s), and {:.1} % of the vectors valid: root mean square error in \
         {pairs} trial pairs in a smooth flow. Flow structures smaller than the vector spacing add to this.\n\
         Lower (Cramér-Rao) bound, with the light of other particles treated as noise: {x:.4}, {y:.4}, {z:.4} \
         voxel.\n",
        conditions.ppm,
        u * speed,
        v * speed,
        w * speed,
        100.0 * valid_share,
    );
    if !config.velocimetry.follow_particles {
        let window_vox = config.velocimetry.window_mm / config.volume.voxel_mm;
        let in_window =
            particles_per_mm3(config, conditions) * config.velocimetry.window_mm.powi(3);
        let windows = correlation_error_vox(window_vox, in_window);
        let _ = writeln!(
            text,
            "follow_particles = false: windows alone add some {windows:.3} voxel in a flow of 10 \
             mm wavelength."
        );
    }
    for axis in 0..3 {
        let name = ["x", "y", "z"][axis];
        let _ = writeln!(text, "\n{:>10}{:>10}{:>10}{:>10}", format!("{name} (mm)"), "u", "v", "w");
        for (position, [u, v, w]) in slabs(places, axis) {
            let _ = writeln!(text, "{position:>10.2}{u:>10.4}{v:>10.4}{w:>10.4}");
        }
    }
    text
}

/// The changes that would reduce the worst component's uncertainty most, best first.
fn improvements(changes: Vec<Change>, places: &[ForecastPlace], bar: &ProgressBar) -> String {
    let before = root_mean_squares(places);
    let worst = (0..3).max_by(|a, b| before[*a].total_cmp(&before[*b])).unwrap_or(0);
    let mut tried: Vec<(f64, Change)> = Vec::new();
    for change in changes {
        let after = forecast(&change.measurement, &change.conditions);
        bar.inc(1);
        // Skip benches that cannot be built.
        let Ok(after) = after else { continue };
        tried.push((root_mean_squares(&after.places)[worst] / before[worst], change));
    }
    tried.sort_by(|a, b| a.0.total_cmp(&b.0));
    let name = ["x", "y", "z"][worst];
    let mut text = format!(
        "Changes that reduce the uncertainty along {name}, the largest, most, and the factor on it:\n"
    );
    for (factor, change) in &tried {
        let _ = writeln!(text, "{factor:>7.2} x  {}", change.words);
    }
    if tried.first().is_none_or(|(factor, _)| *factor > 0.9) {
        text.push_str("None of these improves it by more than a tenth.\n");
    }
    text
}

fn particles_per_mm3(config: &Config, conditions: &SceneConditions) -> f64 {
    let depth_mm = config.volume.voxels[2] as f64 * config.volume.voxel_mm;
    conditions.ppm / config.optics.object_pitch_mm().powi(2) / depth_mm
}

/// Root of the mean square of each component; infinite where nothing is measured.
fn root_mean_squares(places: &[ForecastPlace]) -> [f64; 3] {
    std::array::from_fn(|component| {
        let squares = places.iter().map(|place| place.uncertainty_vox[component].powi(2));
        if places.is_empty() {
            return f64::INFINITY;
        }
        (squares.sum::<f64>() / places.len() as f64).sqrt()
    })
}

fn medians(places: &[ForecastPlace]) -> [f64; 3] {
    std::array::from_fn(|component| {
        median(places.iter().map(|place| place.uncertainty_vox[component])).unwrap_or(f64::INFINITY)
    })
}

/// Root mean squares over the vectors at each position along an axis.
fn slabs(places: &[ForecastPlace], axis: usize) -> Vec<(f64, [f64; 3])> {
    let mut positions: Vec<f64> = places.iter().map(|place| place.position_mm[axis]).collect();
    positions.sort_by(f64::total_cmp);
    positions.dedup();
    let of = |position: &f64| -> Vec<ForecastPlace> {
        places.iter().filter(|place| place.position_mm[axis] == *position).copied().collect()
    };
    positions.iter().map(|position| (*position, root_mean_squares(&of(position)))).collect()
}

#[cfg(test)]
mod tests {
    use lfpiv_core::velocimetry::Placing;

    use super::*;

    fn shipped(name: &str) -> Config {
        let path = PathBuf::from(format!("config/{name}.toml"));
        ConfigFile::load(&path).unwrap().config
    }

    #[test]
    fn a_plan_lists_slabs_and_improvements() {
        let mut config = shipped("sim");
        config.camera.truncate(1);
        config.volume.voxels = [28, 24, 32];
        config.velocimetry.window_mm = 1.2;
        // One camera's vectors are rough: particles would be placed in every trial, which takes ten times as long.
        config.velocimetry.place_particles = Placing::Never;
        let conditions = conditions(config.simulation.as_ref().unwrap());
        let held = bound(&config.measurement(), &conditions).unwrap();
        let measured = forecast(&config.measurement(), &conditions).unwrap();
        let places = &measured.places;
        let report = report(&config, &conditions, &measured, &held);
        assert!(report.contains("z (mm)") && report.lines().count() > 15, "{report}");
        // One camera does not resolve depth, so a second one helps most.
        let bar = ProgressBar::hidden();
        let mut changes = changes::changes(&config, &conditions);
        changes
            .retain(|change| ["second camera", "seeding"].iter().any(|w| change.words.contains(w)));
        let improvements = improvements(changes, places, &bar);
        assert!(improvements.contains("along z, the largest"), "{improvements}");
        let best = improvements.lines().nth(1).unwrap();
        assert!(best.contains("second camera"), "{improvements}");
        let drawing = chart_svg(places, 1.0);
        assert!(drawing.starts_with("<svg") && !drawing.contains("NaN"), "{drawing}");
    }
}
