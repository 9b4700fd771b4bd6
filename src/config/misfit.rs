//! Whether the parts of a configuration fit together: every value may be in its range, and the whole
//! still describe nothing that can be measured.

use std::borrow::Cow;

use lfpiv_core::{
    model::{Sight, VolumeGrid, degrees_apart},
    reconstruction::{Domain, ReconstructionSettings, Solver},
};
use lfpiv_hw::{
    CameraName,
    timing::{PulseSchedule, Violation},
};

use super::Config;

/// What a configuration is read for, and so what of it has to fit together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Purpose {
    /// To make images, or to calibrate: calibrations are not read.
    Optics,
    /// To correlate volumes that are there: volume and windows.
    Volumes,
    /// To measure images: the cameras and their calibrations, too.
    Images,
    /// To run the bench: laser and cameras must keep its rate, too.
    Bench,
}

/// Share of the volume that all cameras must see. Light from outside a camera's view tells it
/// nothing: with less than half of the volume in view the rest is not measured but made up.
const LEAST_COMMON_VIEW: f64 = 0.5;

/// Cameras closer to each other see the same: the pupil of one alone spans several degrees.
const LEAST_DEGREES_APART: f64 = 1.0;

/// Most vectors of a field: some 200 bytes each while they are measured and sent.
const MOST_VECTORS: f64 = 4e6;

/// A key, and why its value does not fit the rest.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Misfit {
    pub key: Cow<'static, str>,
    pub message: String,
}

impl Misfit {
    pub fn new(key: impl Into<Cow<'static, str>>, message: String) -> Self {
        Self { key: key.into(), message }
    }
}

/// Everything that does not fit together for `purpose`.
pub(super) fn misfits(config: &Config, purpose: Purpose) -> Vec<Misfit> {
    let mut found = windows(config);
    found.extend(vectors(config));
    if purpose != Purpose::Volumes {
        found.extend(domain(config));
        found.extend(common_view(config));
        found.extend(same_camera(config));
    }
    if purpose == Purpose::Bench {
        found.extend(schedule(config));
    }
    found
}

/// OS-MART works on active voxels only.
fn domain(config: &Config) -> Option<Misfit> {
    let ReconstructionSettings { solver, domain, .. } = config.reconstruction;
    (solver == Solver::OsMart && domain == Domain::Volume).then(|| {
        let message = "os-mart works on active voxels only; use domain = \"active\", or solver = \
                       \"sart\", \"os-sart\" or \"pr-sart\"";
        Misfit::new("reconstruction.domain", message.to_owned())
    })
}

fn windows(config: &Config) -> Vec<Misfit> {
    let VolumeGrid { voxels, voxel_mm, .. } = &config.volume;
    let shortest_mm = voxels.iter().min().map_or(0.0, |&n| n as f64) * voxel_mm;
    let settings = &config.velocimetry;
    let windows = [
        ("velocimetry.window_mm", Some(settings.window_mm)),
        ("velocimetry.first_window_mm", settings.first_window_mm),
    ];
    let too_large = windows.into_iter().filter_map(|(key, window_mm)| Some((key, window_mm?)));
    // A thousandth of a voxel for lengths that are no binary fractions.
    let too_large = too_large.filter(|(_, window_mm)| *window_mm > shortest_mm + 1e-3 * voxel_mm);
    too_large
        .map(|(key, _)| {
            let most_mm = (shortest_mm * 1e6).round() / 1e6;
            let message = format!(
                "larger than the volume, whose shortest edge is {most_mm} mm; allowed up to that"
            );
            Misfit::new(key, message)
        })
        .collect()
}

/// Vectors closer than the windows are many soon.
fn vectors(config: &Config) -> Option<Misfit> {
    let (spacing_mm, grid) = (config.output.spacing_mm?, &config.volume);
    let volume_mm3: f64 = grid.voxels.iter().map(|&n| n as f64 * grid.voxel_mm).product();
    (volume_mm3 / spacing_mm.powi(3) > MOST_VECTORS).then(|| {
        let least_mm = ((volume_mm3 / MOST_VECTORS).cbrt() * 100.0).ceil() / 100.0;
        let message =
            format!("more than {MOST_VECTORS:.0} vectors; allowed: {least_mm} mm or more");
        Misfit::new("output.spacing_mm", message)
    })
}

fn common_view(config: &Config) -> Option<Misfit> {
    let sight = |grid: &VolumeGrid| Sight::new(&config.optics, &config.poses(), grid);
    let seen = sight(&config.volume);
    if seen.common >= LEAST_COMMON_VIEW {
        return None;
    }
    let centred = VolumeGrid { centre_mm: [0.0; 3], ..config.volume.clone() };
    let aside = config.volume.centre_mm != [0.0; 3] && sight(&centred).common >= LEAST_COMMON_VIEW;
    let (key, todo) = match aside {
        true => ("volume.centre_mm", "move [volume], or correct the poses of the cameras"),
        false => ("volume.voxels", "make [volume] smaller, or correct optics and poses"),
    };
    let each: Vec<String> = (0..)
        .zip(&seen.each)
        .map(|(camera, share)| format!("{} sees {:.0} %", CameraName(camera), 100.0 * share))
        .collect();
    let each = each.join(", ");
    let message = match config.camera.len() {
        1 => format!("{each} of the volume, allowed: {:.0} or more", 100.0 * LEAST_COMMON_VIEW),
        _ => format!(
            "{:.0} % of the volume is in the common view of the cameras, allowed: {:.0} or more \
             ({each})",
            100.0 * seen.common,
            100.0 * LEAST_COMMON_VIEW
        ),
    };
    Some(Misfit::new(key, format!("{message}; {todo}")))
}

fn same_camera(config: &Config) -> Option<Misfit> {
    let poses = config.poses();
    let [one, other] = poses.as_slice() else { return None };
    let degrees = degrees_apart(&config.optics, [one, other], &config.volume);
    (degrees < LEAST_DEGREES_APART).then(|| {
        Misfit::new(
            "camera[1].axis",
            format!(
                "{} looks from where {} does, {degrees:.2} degrees apart, allowed: \
                 {LEAST_DEGREES_APART} or more; give it its own pose, or leave it out",
                CameraName(1),
                CameraName(0)
            ),
        )
    })
}

/// What the devices cannot hold of rate and pulse separation.
fn schedule(config: &Config) -> Vec<Misfit> {
    let planned = PulseSchedule::plan(&config.timing, config.shot.dt_us, config.shot.rate_hz);
    let violations = planned.err().map(|error| error.violations).unwrap_or_default();
    violations.iter().map(|rule| Misfit::new(key_of(rule), rule.to_string())).collect()
}

/// The key that decides whether a rule is kept.
fn key_of(rule: &Violation) -> &'static str {
    match rule {
        Violation::LaserRate { .. }
        | Violation::RateAboveSource { .. }
        | Violation::CameraBusy { .. } => "shot.rate_hz",
        Violation::NotPositive { quantity: "rate_hz", .. } => "shot.rate_hz",
        Violation::OutsidePeriod { start_us, .. } if *start_us >= 0.0 => "shot.rate_hz",
        Violation::OutsidePeriod { .. } => "timing.lamp_1_us",
        Violation::ExternalTriggerUndeclared { .. } => "timing.trigger",
        Violation::ExternalTriggerRate { .. } => "timing.external_trigger.max_rate_hz",
        Violation::NotPositive { .. }
        | Violation::NotAStep { .. }
        | Violation::OutsideUnit { .. }
        | Violation::PulseOutsideExposure { .. } => "shot.dt_us",
    }
}
