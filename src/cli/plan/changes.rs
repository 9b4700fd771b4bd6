//! Variants of a planned bench with one change each.

use lfpiv_core::measurement::{Measurement, SceneConditions};
use lfpiv_hw::Pose;
use nalgebra::Vector3;

use crate::config::Config;

/// A bench with one change.
pub(super) struct Change {
    pub words: String,
    pub measurement: Measurement,
    pub conditions: SceneConditions,
}

/// Angle between two cameras, in degrees, below which a wider angle is tried.
const WIDE_DEGREES: f64 = 80.0;

/// Possible changes of a bench, one at a time.
pub(super) fn changes(config: &Config, conditions: &SceneConditions) -> Vec<Change> {
    let measurement = config.measurement();
    let with = |words: String, change: &dyn Fn(&mut Measurement, &mut SceneConditions)| {
        let mut changed =
            Change { words, measurement: measurement.clone(), conditions: *conditions };
        change(&mut changed.measurement, &mut changed.conditions);
        changed
    };
    let mut changes = vec![
        with(
            format!("twice the seeding: {} particles per microlens", 2.0 * conditions.ppm),
            &|_, c| {
                c.ppm *= 2.0;
            },
        ),
        with(
            format!("half the seeding: {} particles per microlens", conditions.ppm / 2.0),
            &|_, c| {
                c.ppm /= 2.0;
            },
        ),
        with("four times the light: a stronger laser or larger particles".to_owned(), &|_, c| {
            c.photoelectrons *= 4.0;
        }),
        with(
            format!(
                "windows 1.5 times as large, {:.2} mm: smaller flow structures are lost",
                1.5 * measurement.velocimetry.window_mm
            ),
            &|m, _| m.velocimetry.window_mm *= 1.5,
        ),
        with(
            "a light sheet half as thick along z, with as many particles per microlens".to_owned(),
            &|m, _| {
                m.volume.voxels[2] = (m.volume.voxels[2] / 2).max(1);
            },
        ),
        with(
            format!(
                "a main lens one stop faster, f/{:.1}, and microlenses that match it",
                measurement.optics.f_number / 2f64.sqrt()
            ),
            &|m, c| {
                m.optics.f_number /= 2f64.sqrt();
                m.optics.microlens.focal_length_mm /= 2f64.sqrt();
                c.photoelectrons *= 2.0;
            },
        ),
    ];
    if let Some(cameras) = wider(&measurement.cameras) {
        let words = match measurement.cameras.len() {
            1 => "a second camera, at 90 degrees".to_owned(),
            _ => "the second camera at 90 degrees from the first".to_owned(),
        };
        changes.push(with(words, &|m, _| m.cameras = cameras.clone()));
    }
    changes
}

/// The first camera and a second one at a right angle; `None` if there is one already.
fn wider(cameras: &[Pose]) -> Option<Vec<Pose>> {
    let first = cameras.first()?;
    if let Some(second) = cameras.get(1) {
        let degrees = first.axis.dot(&second.axis).clamp(-1.0, 1.0).acos().to_degrees();
        if degrees > WIDE_DEGREES && degrees < 180.0 - WIDE_DEGREES {
            return None;
        }
    }
    let origin_mm: Vector3<f64> = first.origin_mm;
    let second = Pose { right: first.right, up: -first.axis, axis: first.up, origin_mm };
    Some(vec![first.clone(), second])
}
