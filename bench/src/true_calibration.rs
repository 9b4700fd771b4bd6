//! What a perfect calibration would say of the simulated cameras: their own rays, nothing fitted to
//! images.

use lfpiv_core::{
    lightfield::MicroImageGrid,
    model::{CameraCalibration, EquivalentPoint, VolumeMap},
};
use lfpiv_hw::Optics;
use lfpiv_sim::imaging::RayTracer;

use crate::case::Setting;

/// Where rays pass the stop besides its middle, as a share of the pupil's radius: the slope between is
/// that of the whole stop for the simulator's lenses.
const STOP_SHARE: f64 = 0.5;

/// Degree of the polynomials of a map: with it distortion is followed to a micrometre.
const DEGREE: usize = 4;

/// Voxels beyond the volume that are reconstructed, too.
const MARGIN_VOXELS: f64 = 6.0;

/// The calibrations of a case's cameras.
pub fn true_calibrations(setting: &Setting) -> Vec<CameraCalibration> {
    (0..setting.config.camera.len()).map(|camera| calibration(setting, camera)).collect()
}

fn calibration(setting: &Setting, camera: usize) -> CameraCalibration {
    let (scene, bench) = (&setting.scene, &setting.bench);
    let grid = scene.micro_image_grid(bench, camera).map(|grid| MicroImageGrid {
        microlenses: grid.microlenses,
        column_px: grid.column_px,
        row_px: grid.row_px,
    });
    let map = scene.tracer(bench, camera).and_then(|tracer| {
        let volume = &setting.config.volume.grid();
        let half = |voxels: usize| (voxels as f64 / 2.0 + MARGIN_VOXELS) * volume.voxel_mm;
        let exit_pupil_mm = scene.camera.get(camera).map_or(0.0, |flaws| flaws.exit_pupil_mm);
        let seen = |world_mm| equivalent(&bench.optics, &tracer, exit_pupil_mm, world_mm);
        VolumeMap::fit(volume.centre_mm, volume.voxels.map(half), DEGREE, seen)
    });
    CameraCalibration { grid, map: map.map(|(map, _)| map) }
}

/// The point before the ideal thin lens whose rays x = a U + b ξ are those of a world point, along
/// the columns and along the rows.
///
/// A reconstruction takes places on the pupil and microlenses from pixels by the drawn distances. A stop
/// d behind the lens is nearer to the microlenses than the drawn pupil: one pixel sees (s_i - d)/s_i
/// of the drawn width on it, and micro-images stand further apart.
fn equivalent(
    optics: &Optics,
    tracer: &RayTracer<'_>,
    exit_pupil_mm: f64,
    world_mm: [f64; 3],
) -> Option<EquivalentPoint> {
    let image_mm = optics.image_distance_mm();
    let nearer = (image_mm - exit_pupil_mm) / image_mm;
    let magnified = (1.0 + optics.microlens.focal_length_mm / (image_mm - exit_pupil_mm))
        / optics.micro_image_magnification();
    let off_mm = STOP_SHARE * optics.pupil_diameter_mm() / 2.0;
    let on_microlenses_mm = |pupil_mm: [f64; 2]| {
        let place_mm = tracer.on_microlenses_mm(world_mm, pupil_mm.map(|u| u * nearer))?;
        Some(place_mm.map(|x| x * magnified))
    };
    let mut slopes = [0.0; 2];
    for (axis, slope) in slopes.iter_mut().enumerate() {
        let through = |sign: f64| {
            let mut pupil_mm = [0.0; 2];
            pupil_mm[axis] = sign * off_mm;
            Some(on_microlenses_mm(pupil_mm)?[axis])
        };
        *slope = (through(1.0)? - through(-1.0)?) / (2.0 * off_mm);
    }
    Some(EquivalentPoint::of_rays(optics, on_microlenses_mm([0.0; 2])?, slopes))
}
