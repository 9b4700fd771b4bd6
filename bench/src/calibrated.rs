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

/// The calibrations of a case's cameras; none where the case is not calibrated.
pub fn calibrations(setting: &Setting) -> Vec<CameraCalibration> {
    if !setting.case.calibrated {
        return Vec::new();
    }
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
        let volume = &setting.config.volume;
        let half = |voxels: usize| (voxels as f64 / 2.0 + MARGIN_VOXELS) * volume.voxel_mm;
        let seen = |world_mm| equivalent(&bench.optics, &tracer, world_mm);
        VolumeMap::fit(volume.centre_mm, volume.voxels.map(half), DEGREE, seen)
    });
    CameraCalibration { grid, map: map.map(|(map, _)| map) }
}

/// The point before the ideal thin lens whose rays x = a U + b ξ are those of a world point, along
/// the columns and along the rows.
fn equivalent(
    optics: &Optics,
    tracer: &RayTracer<'_>,
    world_mm: [f64; 3],
) -> Option<EquivalentPoint> {
    let off_mm = STOP_SHARE * optics.pupil_diameter_mm() / 2.0;
    let middle = tracer.on_microlenses_mm(world_mm, [0.0; 2])?;
    let mut point = EquivalentPoint { lateral_mm: [0.0; 2], depth_mm: [0.0; 2] };
    for axis in 0..2 {
        let through = |sign: f64| {
            let mut stop_mm = [0.0; 2];
            stop_mm[axis] = sign * off_mm;
            Some(tracer.on_microlenses_mm(world_mm, stop_mm)?[axis])
        };
        let slope = (through(1.0)? - through(-1.0)?) / (2.0 * off_mm);
        // a = 1 - s_i/s' with 1/s' = 1/F - 1/s, solved for s.
        let image_mm = optics.image_distance_mm();
        let distance_mm = 1.0 / (1.0 / optics.focal_length_mm - (1.0 - slope) / image_mm);
        point.depth_mm[axis] = optics.object_distance_mm - distance_mm;
        point.lateral_mm[axis] = -middle[axis] * distance_mm / image_mm;
    }
    Some(point)
}
