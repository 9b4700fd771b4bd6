//! Consistency checks between the tables of a configuration. Each value may be in its range while
//! the values together describe a bench that cannot measure.

use std::borrow::Cow;

use lfpiv_core::{
    model::{Sight, VolumeGrid, degrees_apart},
    reconstruction::{Domain, ReconstructionSettings, Solver},
    velocimetry::Placing,
};
use lfpiv_hw::{
    CameraName,
    timing::{PulseSchedule, Violation},
};

use super::Config;

/// What a configuration is used for. It decides which checks are made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Purpose {
    /// To make images or to calibrate: calibration files are not read.
    Optics,
    /// To correlate given volumes: volume and windows are checked.
    Volumes,
    /// To measure images: cameras and their calibrations are checked as well.
    Images,
    /// To run the bench: the rate of laser and cameras is checked as well.
    Bench,
}

/// Smallest share of the volume that all cameras must see. A camera knows nothing about light
/// outside its view, so with less than half of the volume in common view the rest of the volume
/// cannot be measured.
const LEAST_COMMON_VIEW: f64 = 0.5;

/// Smallest angle between two cameras. Closer cameras see the same: the pupil of one camera spans
/// several degrees.
const LEAST_DEGREES_APART: f64 = 1.0;

/// Largest number of vectors of a field, which take some 200 bytes each while they are measured and sent.
const MOST_VECTORS: f64 = 4e6;

/// A key whose value contradicts other values, and the reason.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Inconsistency {
    pub key: Cow<'static, str>,
    pub message: String,
}

impl Inconsistency {
    pub fn new(key: impl Into<Cow<'static, str>>, message: String) -> Self {
        Self { key: key.into(), message }
    }
}

/// The field through placed particles is one field of the whole volume.
fn placing(config: &Config) -> Option<Inconsistency> {
    let always = config.velocimetry.place_particles == Placing::Always;
    let asked = always && config.mask.is_some();
    asked.then(|| {
        let message = "the field through placed particles does not know the volume's mask and would mix the flows on \
                       both sides of a body; leave out one of the two";
        Inconsistency::new("velocimetry.place_particles", message.to_owned())
    })
}

/// All inconsistencies for `purpose`.
pub(super) fn inconsistencies(config: &Config, purpose: Purpose) -> Vec<Inconsistency> {
    let mut found = windows(config);
    found.extend(vectors(config));
    found.extend(placing(config));
    if purpose != Purpose::Volumes {
        found.extend(domain(config));
        found.extend(common_view(config));
        found.extend(same_camera(config));
    }
    if purpose == Purpose::Bench {
        found.extend(schedule(config));
        found.extend(frames_for_workers(config));
    }
    found
}

/// OS-MART needs active voxels.
fn domain(config: &Config) -> Option<Inconsistency> {
    let ReconstructionSettings { solver, domain, .. } = config.reconstruction;
    (solver == Solver::OsMart && domain == Domain::Volume).then(|| {
        let message = "os-mart works on active voxels only; use domain = \"active\", or solver = \
                       \"sart\", \"os-sart\" or \"pr-sart\"";
        Inconsistency::new("reconstruction.domain", message.to_owned())
    })
}

fn windows(config: &Config) -> Vec<Inconsistency> {
    let VolumeGrid { voxels, voxel_mm, .. } = &config.volume.grid();
    let shortest_mm = voxels.iter().min().map_or(0.0, |&n| n as f64) * voxel_mm;
    let settings = &config.velocimetry;
    let windows = [
        ("velocimetry.window_mm", Some(settings.window_mm)),
        ("velocimetry.first_window_mm", settings.first_window_mm),
    ];
    let too_large = windows.into_iter().filter_map(|(key, window_mm)| Some((key, window_mm?)));
    // The tolerance is a thousandth of a voxel, for lengths that are not binary fractions.
    let too_large = too_large.filter(|(_, window_mm)| *window_mm > shortest_mm + 1e-3 * voxel_mm);
    too_large
        .map(|(key, _)| {
            let most_mm = (shortest_mm * 1e6).round() / 1e6;
            let message = format!(
                "larger than the volume, whose shortest edge is {most_mm} mm; allowed: at most that"
            );
            Inconsistency::new(key, message)
        })
        .collect()
}

/// A spacing that gives more vectors than memory should hold.
fn vectors(config: &Config) -> Option<Inconsistency> {
    let (spacing_mm, grid) = (config.output.spacing_mm?, &config.volume.grid());
    let volume_mm3: f64 = grid.voxels.iter().map(|&n| n as f64 * grid.voxel_mm).product();
    (volume_mm3 / spacing_mm.powi(3) > MOST_VECTORS).then(|| {
        let least_mm = ((volume_mm3 / MOST_VECTORS).cbrt() * 100.0).ceil() / 100.0;
        let message =
            format!("more than {MOST_VECTORS:.0} vectors; allowed: {least_mm} mm or more");
        Inconsistency::new("output.spacing_mm", message)
    })
}

fn common_view(config: &Config) -> Option<Inconsistency> {
    let sight = |grid: &VolumeGrid| Sight::new(&config.optics, &config.poses(), grid);
    let seen = sight(&config.volume.grid());
    if seen.common >= LEAST_COMMON_VIEW {
        return None;
    }
    let centred = VolumeGrid { centre_mm: [0.0; 3], ..config.volume.grid() };
    let off_centre =
        config.volume.centre_mm != [0.0; 3] && sight(&centred).common >= LEAST_COMMON_VIEW;
    let (key, todo) = match off_centre {
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
    Some(Inconsistency::new(key, format!("{message}; {todo}")))
}

/// Workers read frames from the record.
fn frames_for_workers(config: &Config) -> Option<Inconsistency> {
    (config.cluster.is_some() && !config.raw_log.keep).then(|| {
        let message = "workers read a shot's frames from the record, and none is kept; keep it, or leave out [cluster]";
        Inconsistency::new("raw_log.keep", message.to_owned())
    })
}

fn same_camera(config: &Config) -> Option<Inconsistency> {
    let poses = config.poses();
    let [one, other] = poses.as_slice() else { return None };
    let degrees = degrees_apart(&config.optics, [one, other], &config.volume.grid());
    (degrees < LEAST_DEGREES_APART).then(|| {
        Inconsistency::new(
            "camera[1].axis",
            format!(
                "{} looks from where {} does: the angle between them is {degrees:.2} degrees, \
                 allowed: {LEAST_DEGREES_APART} or more; give it its own pose, or leave it out",
                CameraName(1),
                CameraName(0)
            ),
        )
    })
}

/// Violations of the laser's or the cameras' limits by rate and pulse separation.
fn schedule(config: &Config) -> Vec<Inconsistency> {
    let planned = PulseSchedule::plan(&config.timing, config.shot.dt_us, config.shot.rate_hz);
    let violations = planned.err().map(|error| error.violations).unwrap_or_default();
    violations.iter().map(|rule| Inconsistency::new(key_of(rule), rule.to_string())).collect()
}

/// The key to change for a violated rule.
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
