//! What a pair says about the scene, in the terms that the choice of a model needs.

use lfpiv_hw::Pose;

use super::{Measurement, frame::Frame};
use crate::{
    lightfield::{Seeding, ViewLayout},
    model::{Blur, SceneMeasure, VolumeGrid},
};

/// Measures the scene in one frame, cut into the views of `layouts`. `None` when a camera sees no
/// particles: such a frame says nothing.
pub(super) fn measure_scene(
    measurement: &Measurement,
    layouts: &[ViewLayout],
    frame: &Frame,
) -> Option<SceneMeasure> {
    let Measurement { optics, cameras, volume, model, velocimetry, .. } = measurement;
    let seeding = frame.views.iter().zip(layouts).zip(&frame.levels);
    let seeding: Vec<Seeding> = seeding
        .map(|((views, layout), levels)| Seeding::of(views, layout, levels.noise_counts))
        .collect::<Option<_>>()?;
    let depths: Vec<[f64; 2]> = cameras.iter().map(|pose| depth_range_mm(pose, volume)).collect();
    let mean = |of_camera: &dyn Fn(usize) -> f64| {
        (0..cameras.len()).map(of_camera).sum::<f64>() / cameras.len() as f64
    };
    let object_pitch_mm = optics.object_pitch_mm();
    let per_mm3 =
        |n: usize| seeding[n].ppm / object_pitch_mm.powi(2) / (depths[n][1] - depths[n][0]);
    let particles_per_mm3 = mean(&per_mm3);
    let width_vox = |blur: Blur| {
        let square = |n: usize| (blur.rms_width_mm(optics, depths[n]) / volume.voxel_mm).powi(2);
        mean(&square).sqrt()
    };
    let (partly_open_views, partly_open_light) = partly_open(layouts);
    let noise = seeding.iter().zip(&frame.levels);
    Some(SceneMeasure {
        seeding_ppm: mean(&|n| seeding[n].ppm),
        particles_per_mm3,
        window_vox: velocimetry.window_mm / volume.voxel_mm,
        particles_per_window: particles_per_mm3 * velocimetry.window_mm.powi(3),
        particle_counts: seeding.iter().map(|s| s.particle_counts).fold(f64::INFINITY, f64::min),
        noise_per_particle: noise
            .map(|(s, l)| l.noise_counts / s.particle_counts)
            .fold(0.0, f64::max),
        saturated_share: frame.saturated_share,
        depth_mm: depths.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], depth| {
            [low.min(depth[0]), high.max(depth[1])]
        }),
        pitch_vox: object_pitch_mm / volume.voxel_mm,
        parallax_vox: width_vox(Blur { pupil_mm: optics.pupil_diameter_mm(), plane_mm: 0.0 }),
        pupil_blur_vox: width_vox(Blur { pupil_mm: optics.pupil_cell_mm(), plane_mm: 0.0 }),
        diffraction_vox: model.wavelength_nm.map(|nm| width_vox(Blur::of_diffraction(optics, nm))),
        partly_open_light,
        partly_open_views,
    })
}

/// Lowest and highest depth of a box of voxels along a camera's axis, in mm.
fn depth_range_mm(pose: &Pose, volume: &VolumeGrid) -> [f64; 2] {
    let half: f64 = (0..3)
        .map(|axis| pose.axis[axis].abs() * volume.voxels[axis] as f64 * volume.voxel_mm / 2.0)
        .sum();
    let centre = pose.to_camera(&volume.centre_mm.into()).depth_mm;
    [centre - half, centre + half]
}

/// Shares of the views, and of their light, that the aperture's edge cuts.
fn partly_open(layouts: &[ViewLayout]) -> (f64, f64) {
    let (mut views, mut partly, mut light, mut partly_light) = (0.0, 0.0, 0.0, 0.0);
    for view in layouts.iter().flat_map(|layout| &layout.views) {
        let open = view.coverage.as_ref().map_or(1.0, |coverage| {
            coverage.iter().map(|&share| f64::from(share)).sum::<f64>() / coverage.len() as f64
        });
        let cut = f64::from(u8::from(view.is_cut()));
        (views, partly) = (views + 1.0, partly + cut);
        (light, partly_light) = (light + open, partly_light + cut * open);
    }
    (partly / views, partly_light / light)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{model::thin_lens_model, test_bench};

    /// A round pupil of 18.2 cells: some 57 of 260 cells lie on its edge, about half open each, and those
    /// less than a third open are no views.
    #[test]
    fn the_aperture_cuts_the_views_on_its_edge_and_about_half_of_their_light() {
        let grid = VolumeGrid { voxels: [8; 3], voxel_mm: 0.1, centre_mm: [0.0; 3] };
        let (optics, poses) = (test_bench::optics(), test_bench::poses());
        let model = thin_lens_model(&optics, &poses, &grid, 0.1).unwrap();
        let (views, light) = partly_open(model.layouts());
        assert!((0.1..0.35).contains(&views), "{views}");
        assert!((0.4 * views..0.95 * views).contains(&light), "{light} of {views}");
    }
}
