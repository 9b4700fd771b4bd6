//! Planar PIV by the correlation of volumes: images as grids of one layer, from coarse pixels to fine ones.
//!
//! Windows have the same number of pixels on every level, and pixels half the edge of those before: 256 -> 128 ->
//! 64 -> 32 of the image's own.

use lfpiv_core::{
    model::VolumeGrid,
    reconstruction::DenseVolume,
    velocimetry::{VectorGrid, VelocimetrySettings, VelocityField, VolumeInterrogation},
};
use lfpiv_hw::RawImage;
use lfpiv_sim::ConventionalCamera;

/// Passes of a level, with the search or what stands for it.
const PASSES: usize = 4;

/// A level before the last one makes no vectors, only a guess: where the flow changes across its windows their
/// peaks are low.
const LEAST_CORRELATION: f64 = 0.15;

/// Windows from coarse to fine on the images of a camera.
pub(super) struct PlanarInterrogation {
    coarse: Vec<Level>,
    finest: Level,
}

struct Level {
    /// Pixels of the image along an edge of one of the level's.
    bin: usize,
    grid: VolumeGrid,
    windows: VolumeInterrogation,
}

impl PlanarInterrogation {
    /// Windows with an edge of `first` to `last` pixels of `camera`, whose axis is that of z, for displacements up
    /// to `fastest_m`, in m.
    pub fn new(camera: &ConventionalCamera, [first, last]: [usize; 2], fastest_m: f64) -> Self {
        let level = |bin| Level::new(camera, bin, last, fastest_m);
        let bins = std::iter::successors(Some(first / last), |bin| Some(bin / 2));
        let coarse = bins.take_while(|bin| *bin > 1).map(level).collect();
        Self { coarse, finest: level(1) }
    }

    /// Where the vectors will be.
    pub fn vector_grid(&self) -> VectorGrid {
        self.finest.windows.vector_grid()
    }

    /// The displacement between two images in the camera's object plane.
    pub fn measure(&self, images: &[RawImage; 2], dt_s: f64) -> VelocityField {
        let guess = self
            .coarse
            .iter()
            .fold(None, |known, level| Some(level.measure(known.as_ref(), images, dt_s)));
        self.finest.measure(guess.as_ref(), images, dt_s)
    }
}

impl Level {
    fn new(camera: &ConventionalCamera, bin: usize, window: usize, fastest_m: f64) -> Self {
        let pixel_mm = camera.object_pixel_mm();
        let [nx, ny] = camera.pixels.map(|n| n / bin);
        let at = camera.pose.origin_mm;
        // Pixels that fill no bin are left out at the end of rows and columns.
        let centre = |axis: usize, n: usize| {
            at[axis] + ((n * bin) as f64 - camera.pixels[axis] as f64) / 2.0 * pixel_mm
        };
        let grid = VolumeGrid {
            voxels: [nx, ny, 1],
            voxel_mm: bin as f64 * pixel_mm,
            centre_mm: [centre(0, nx), centre(1, ny), at.z],
        };
        let usual = VelocimetrySettings::default();
        let settings = VelocimetrySettings {
            window_mm: window as f64 * grid.voxel_mm,
            overlap: 0.5,
            passes: PASSES,
            max_displacement_vox: fastest_m * 1e3 / grid.voxel_mm,
            follow_particles: false,
            least_correlation: if bin > 1 { LEAST_CORRELATION } else { usual.least_correlation },
            least_peak_ratio: if bin > 1 { 1.0 } else { usual.least_peak_ratio },
            largest_uncertainty_vox: if bin > 1 { 4.0 } else { usual.largest_uncertainty_vox },
            ..usual
        };
        let windows = VolumeInterrogation::new(&grid, &settings);
        Self { bin, grid, windows }
    }

    /// The displacement from what is known of it, or else from a search.
    fn measure(
        &self,
        known: Option<&VelocityField>,
        images: &[RawImage; 2],
        dt_s: f64,
    ) -> VelocityField {
        let [a, b] = images.each_ref().map(|image| self.light(image));
        match known {
            None => self.windows.measure(&a, &b, dt_s),
            Some(known) => self.windows.measure_from(known, &a, &b, dt_s),
        }
    }

    /// The image in the level's pixels and as the flow is: the lens has inverted it, and rows count downwards, so
    /// columns change their order and rows do not.
    fn light(&self, image: &RawImage) -> DenseVolume {
        let [nx, ny, _] = self.grid.voxels;
        let mut intensity = vec![0.0; nx * ny];
        let rows = image.counts().chunks_exact(image.columns()).take(ny * self.bin);
        for (row, counts) in rows.enumerate() {
            let to = &mut intensity[row / self.bin * nx..][..nx];
            for (place, &count) in counts.iter().rev().take(nx * self.bin).enumerate() {
                to[place / self.bin] += f32::from(count);
            }
        }
        DenseVolume { grid: self.grid.clone(), intensity }
    }
}

#[cfg(test)]
mod tests {
    use lfpiv_core::velocimetry::VectorStatus;
    use lfpiv_sim::{
        Flow, PlanarScene,
        flow::{Axis, LinearShear, RoundJet},
    };

    use super::*;

    /// Means of the magnitudes of the errors of valid vectors along x and y, in pixels, and the share of valid ones.
    fn errors_px(
        scene: &PlanarScene,
        first_window_px: usize,
        dt_s: f64,
        fastest_m_s: f64,
    ) -> ([f64; 2], f64) {
        let shot = scene.shot(dt_s, 3, 0);
        let windows =
            PlanarInterrogation::new(&scene.camera, [first_window_px, 32], fastest_m_s * dt_s);
        let field = windows.measure(&shot.images, dt_s);
        assert_eq!(field.grid, windows.vector_grid());
        let valid: Vec<usize> =
            (0..field.grid.len()).filter(|n| field.status[*n] == VectorStatus::Valid).collect();
        let mean = [0, 1].map(|c| {
            let error = |n: &usize| {
                let truth = shot.flow.displacement_mm(field.grid.position_mm(*n), dt_s)[c];
                (f64::from(field.displacement_vox[*n][c]) - truth / field.voxel_mm).abs()
            };
            valid.iter().map(error).sum::<f64>() / valid.len() as f64
        });
        (mean, field.valid_share())
    }

    #[test]
    fn a_shear_is_found_where_it_is_and_in_its_own_direction() {
        let shear = LinearShear { component: Axis::Y, along: Axis::X, rate_per_s: 1000.0 };
        let mut scene = PlanarScene { flow: Flow::LinearShear(shear), ..PlanarScene::default() };
        scene.camera.pixels = [330, 260];
        scene.camera.pose.origin_mm = [1.0, -2.0, 0.0].into();
        let (mean, valid) = errors_px(&scene, 64, 60e-6, 4.0);
        println!("{mean:?} {valid}");
        assert!(valid > 0.97 && mean.iter().all(|error| *error < 0.1), "{mean:?} {valid}");
    }

    /// 256 -> 32 pixels in a jet's shear layer, with the displacements of the paper.
    #[test]
    fn a_jet_is_followed_from_windows_of_256_pixels_to_32() {
        let mut scene =
            PlanarScene { flow: Flow::RoundJet(RoundJet::default()), ..PlanarScene::default() };
        // A part of the field beside the axis, at the height of the light-field volume.
        scene.camera.pixels = [768, 512];
        scene.camera.pose.origin_mm = [0.0, 0.0, 0.0].into();
        let (mean, valid) = errors_px(&scene, 256, 51e-6, 20.8);
        println!("{mean:?} {valid}");
        assert!(valid > 0.95 && mean.iter().all(|error| *error < 0.15), "{mean:?} {valid}");
    }
}
