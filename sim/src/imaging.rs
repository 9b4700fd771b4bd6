//! Light-field images by ray tracing: what a camera's sensor collects from points of light.
//!
//! Rays leave a point through equal-area strata of the circular pupil and follow the thin-lens
//! rules of docs/theory.md, section 2, ray by ray. Nothing here knows voxel weights, so these images can
//! judge a reconstruction. Simplifications: every particle sends the same light through the pupil
//! wherever it is (no fall-off with distance), and lenses are free of aberrations.

mod detector;
mod pupil;

use lfpiv_hw::{CameraPoint, Optics, Pose};
use nalgebra::Point3;
use rayon::prelude::*;

use crate::stream::{Purpose, random_stream};
use detector::Detector;
use pupil::{LowDiscrepancy, PupilStrata, concentric_disc};

/// Particles traced in parallel before they are added to the image: bounds the memory of the
/// footprints, about 20 kB each.
const PARTICLES_PER_BATCH: usize = 1024;

/// Rays of a box traced as one task.
const RAYS_PER_BOX_TASK: u64 = 1 << 16;

/// How rays are drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct RaySettings {
    /// Rays per particle, rounded up to a square number.
    pub rays_per_particle: usize,
    /// Wavelength in nm where diffraction is wanted. Each Airy pattern, of the main lens on the
    /// microlenses and of a microlens on the sensor, is replaced by a Gaussian of the same core.
    pub diffraction_nm: Option<f64>,
}

/// A point of light in the world.
#[derive(Debug, Clone, PartialEq)]
pub struct PointSource {
    /// Which random stream it draws from: the particle's number, not its place in a list.
    pub id: u64,
    /// World position, in mm.
    pub position_mm: [f64; 3],
    /// Photo-electrons it would release if no ray were lost.
    pub electrons: f64,
}

/// What a sensor collected, in photo-electrons; row-major, row 0 at the top.
#[derive(Debug, Clone, PartialEq)]
pub struct ElectronImage {
    columns: usize,
    rows: usize,
    electrons: Vec<f32>,
}

impl ElectronImage {
    /// A dark image of the sensor's size.
    pub fn dark(optics: &Optics) -> Self {
        Self::uniform(optics.sensor.columns, optics.sensor.rows, 0.0)
    }

    /// The same light on every pixel.
    pub fn uniform(columns: usize, rows: usize, electrons: f32) -> Self {
        Self { columns, rows, electrons: vec![electrons; columns * rows] }
    }

    /// Number of pixel columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Number of pixel rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Mean photo-electrons per pixel, row-major, length `columns × rows`.
    pub fn electrons(&self) -> &[f32] {
        &self.electrons
    }

    /// Adds the light of another exposure of the same sensor.
    pub fn add(&mut self, other: &Self) {
        for (mine, others) in self.electrons.iter_mut().zip(&other.electrons) {
            *mine += others;
        }
    }

    /// Sum over all pixels.
    pub fn total(&self) -> f64 {
        self.electrons.iter().map(|&electrons| f64::from(electrons)).sum()
    }
}

/// Traces rays through one camera.
#[derive(Debug, Clone)]
pub struct RayTracer<'a> {
    optics: &'a Optics,
    pose: &'a Pose,
    strata: PupilStrata,
    detector: Detector,
}

impl<'a> RayTracer<'a> {
    /// A tracer through `optics` standing at `pose`.
    pub fn new(optics: &'a Optics, pose: &'a Pose, settings: &RaySettings) -> Self {
        let strata = PupilStrata::new(optics.pupil_diameter_mm() / 2.0, settings.rays_per_particle);
        Self { optics, pose, strata, detector: Detector::new(optics, settings.diffraction_nm) }
    }

    /// The image of `sources`. `stream` (seed, shot, camera, frame…) and each source's id choose
    /// the random numbers: the result is the same bit for bit whatever the number of threads.
    pub fn trace(&self, sources: &[PointSource], stream: &[u64]) -> ElectronImage {
        let mut image = ElectronImage::dark(self.optics);
        for batch in sources.chunks(PARTICLES_PER_BATCH) {
            let footprints: Vec<Vec<(u32, u32)>> =
                batch.par_iter().map(|source| self.footprint(source, stream)).collect();
            // Adding in the order of the sources keeps the rounding independent of the threads.
            for (source, footprint) in batch.iter().zip(footprints) {
                let per_ray = source.electrons / self.strata.rays() as f64;
                for (pixel, rays) in footprint {
                    image.electrons[pixel as usize] += (per_ray * f64::from(rays)) as f32;
                }
            }
        }
        image
    }

    /// The image of a box of edge `edge_mm` about `centre_mm` (edges along the world axes) that
    /// glows uniformly with `electrons` in all, by `rays` rays (rounded up to a multiple of
    /// 65,536) from points spread through it. For tests of forward models.
    ///
    /// Points and directions follow a five-dimensional additive sequence (Roberts' R-sequence),
    /// randomly shifted by `seed`: it converges faster than independent draws. A voxel of the
    /// bench repeats within 1 % (L1, between seeds) at 2^20 rays and 0.3 % at 2^22.
    pub fn trace_box(
        &self,
        centre_mm: [f64; 3],
        edge_mm: f64,
        electrons: f64,
        rays: u64,
        seed: u64,
    ) -> ElectronImage {
        let sequence = LowDiscrepancy::<5>::shifted(&mut random_stream(Purpose::Box, &[seed]));
        let tasks = rays.div_ceil(RAYS_PER_BOX_TASK).max(1);
        let per_ray = electrons / (tasks * RAYS_PER_BOX_TASK) as f64;
        let hits: Vec<Vec<(u32, u32)>> = (0..tasks)
            .into_par_iter()
            .map(|task| self.box_task(centre_mm, edge_mm, &sequence, task, seed))
            .collect();
        let mut image = ElectronImage::dark(self.optics);
        for (pixel, rays) in hits.into_iter().flatten() {
            image.electrons[pixel as usize] += (per_ray * f64::from(rays)) as f32;
        }
        image
    }

    fn box_task(
        &self,
        centre_mm: [f64; 3],
        edge_mm: f64,
        sequence: &LowDiscrepancy<5>,
        task: u64,
        seed: u64,
    ) -> Vec<(u32, u32)> {
        let mut rng = random_stream(Purpose::Box, &[seed, task]);
        let radius_mm = self.optics.pupil_diameter_mm() / 2.0;
        let first = task * RAYS_PER_BOX_TASK;
        let mut pixels: Vec<u32> = (first..first + RAYS_PER_BOX_TASK)
            .filter_map(|ray| {
                let [u, v, fractions @ ..] = sequence.point(ray);
                let start_mm: [f64; 3] =
                    std::array::from_fn(|axis| centre_mm[axis] + (fractions[axis] - 0.5) * edge_mm);
                let on_pupil_mm = concentric_disc([2.0 * u - 1.0, 2.0 * v - 1.0], radius_mm);
                let imaging = self.point_imaging(start_mm)?;
                self.detector.pixel(imaging.on_microlenses_mm(on_pupil_mm), on_pupil_mm, &mut rng)
            })
            .collect();
        count_runs(&mut pixels)
    }

    /// Pixels hit by the rays of one source and by how many in a row; a pixel may come again.
    fn footprint(&self, source: &PointSource, stream: &[u64]) -> Vec<(u32, u32)> {
        let Some(imaging) = self.point_imaging(source.position_mm) else {
            return Vec::new();
        };
        let key: Vec<u64> = stream.iter().copied().chain([source.id]).collect();
        let mut rng = random_stream(Purpose::Rays, &key);
        let mut diffraction_rng = random_stream(Purpose::Diffraction, &key);
        let mut runs: Vec<(u32, u32)> = Vec::with_capacity(self.strata.rays() / 2);
        self.strata.jittered(&mut rng, |on_pupil_mm| {
            let plane_mm = imaging.on_microlenses_mm(on_pupil_mm);
            let pixel = self.detector.pixel(plane_mm, on_pupil_mm, &mut diffraction_rng);
            // Neighbouring strata mostly hit the same pixel.
            match (pixel, runs.last_mut()) {
                (None, _) => {}
                (Some(pixel), Some((last, rays))) if *last == pixel => *rays += 1,
                (Some(pixel), _) => runs.push((pixel, 1)),
            }
        });
        runs
    }

    /// How the main lens images a world point, or `None` for a point not in front of the lens.
    fn point_imaging(&self, position_mm: [f64; 3]) -> Option<PointImaging> {
        let seen = self.pose.to_camera(&Point3::from(position_mm));
        PointImaging::new(self.optics, seen)
    }
}

/// Where the rays of one point meet the microlens plane: x = a U + b ξ, and likewise in y.
///
/// From docs/theory.md, section 2: x = U + (ξ' − U) s_i/s' with ξ' = −ξ s'/s gives a = 1 − s_i/s' and
/// b = −s_i/s; with 1/s' = 1/F − 1/s it holds for points inside the focal length, too.
struct PointImaging {
    pupil_factor: f64,
    centre_mm: [f64; 2],
}

impl PointImaging {
    fn new(optics: &Optics, seen: CameraPoint) -> Option<Self> {
        let object_distance_mm = optics.object_distance_mm - seen.depth_mm;
        if object_distance_mm.is_nan() || object_distance_mm <= 0.0 {
            return None;
        }
        let image_distance_mm = optics.image_distance_mm();
        let inverse_conjugate = 1.0 / optics.focal_length_mm - 1.0 / object_distance_mm;
        let magnification = -image_distance_mm / object_distance_mm;
        Some(Self {
            pupil_factor: 1.0 - image_distance_mm * inverse_conjugate,
            centre_mm: [magnification * seen.xi_mm, magnification * seen.eta_mm],
        })
    }

    /// Where the ray through `pupil_mm` meets the microlens plane, in mm.
    #[inline]
    fn on_microlenses_mm(&self, pupil_mm: [f64; 2]) -> [f64; 2] {
        std::array::from_fn(|axis| self.pupil_factor * pupil_mm[axis] + self.centre_mm[axis])
    }
}

/// Sorts pixel indices and counts how often each occurs.
fn count_runs(pixels: &mut [u32]) -> Vec<(u32, u32)> {
    pixels.sort_unstable();
    pixels.chunk_by(|a, b| a == b).map(|run| (run[0], run.len() as u32)).collect()
}

#[cfg(test)]
mod tests;
