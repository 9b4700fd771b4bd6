//! Seeding density in a camera's image, for whoever sets it at the bench: before anything is measured, and whatever
//! is.

use std::ops::Range;

use lfpiv_core::{
    lightfield::{ApertureEdge, GridSampling, LightLevels, MicrolensWindow, Seeding, ViewLayout},
    model::VolumeGrid,
};
use lfpiv_hw::{Optics, Pose, RawImage};
use nalgebra::Vector3;

use crate::config::Config;

/// Microlenses along an edge of the window, of which the middle half is looked at: a reading takes little time.
const MOST_LENSES: usize = 48;

/// Each camera's views of the middle of the volume. None if a camera does not see it.
#[derive(Debug, Clone, Default)]
pub struct VolumeViews(Vec<Option<ViewLayout>>);

impl VolumeViews {
    /// The views of the configured cameras, with calibrated micro-images where they are known.
    pub fn new(config: &Config) -> Self {
        let (optics, volume) = (&config.optics, config.volume.grid());
        let views = config.poses().into_iter().enumerate().map(|(camera, pose)| {
            let window = window(optics, &pose, &volume)?;
            let calibration = config.calibration.iter().find(|known| known.camera == camera + 1);
            let grid = calibration.and_then(|calibration| calibration.known.grid.as_ref());
            Some(match grid {
                None => ViewLayout::new(optics, window),
                Some(grid) => {
                    let (edge, grid) =
                        (ApertureEdge::sharp(optics), GridSampling::new(optics, grid));
                    ViewLayout::on_grid(optics, window, edge, grid)
                }
            })
        });
        Self(views.collect())
    }

    /// Particles per microlens of the volume; `None` if no light stands out.
    pub(super) fn seeding_ppm(
        &self,
        camera: usize,
        image: &RawImage,
        levels: &LightLevels,
    ) -> Option<f64> {
        let layout = self.0.get(camera)?.as_ref()?;
        let views = layout.decode_above_black(image, levels);
        Some(Seeding::of(&views, layout, levels.noise_counts)?.ppm)
    }
}

/// The microlenses that see the volume in the plane in focus, of the nominal optics.
fn window(optics: &Optics, pose: &Pose, volume: &VolumeGrid) -> Option<MicrolensWindow> {
    let centre = pose.to_camera(&volume.centre_mm.into());
    let seen = |direction: &Vector3<f64>, centre_mm: f64, lenses: usize| -> Option<Range<usize>> {
        let half_mm: f64 = (0..3)
            .map(|axis| direction[axis].abs() * volume.voxels[axis] as f64 * volume.voxel_mm / 2.0)
            .sum();
        let half = (half_mm / optics.object_pitch_mm()).min(MOST_LENSES as f64 / 2.0);
        // The image is upside down.
        let middle = (lenses as f64 - 1.0) / 2.0 - centre_mm / optics.object_pitch_mm();
        let first = (middle - half).round().max(0.0) as usize;
        let last = (middle + half).round().min(lenses as f64 - 1.0);
        (last >= first as f64).then_some(first..last as usize + 1)
    };
    Some(MicrolensWindow {
        columns: seen(&pose.right, centre.xi_mm, optics.microlens.columns)?,
        rows: seen(&pose.up, centre.eta_mm, optics.microlens.rows)?,
    })
}
