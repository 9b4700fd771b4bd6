//! Light-field images by ray tracing: what a camera's sensor collects from points of light.
//!
//! Rays leave a point through equal-area strata of the circular pupil and follow the thin-lens
//! rules of DESIGN section 2 ray by ray. Nothing here knows voxel weights, so these images can
//! judge a reconstruction. Simplifications: every particle sends the same light through the pupil
//! wherever it is (no fall-off with distance), and lenses are free of aberrations.

mod pupil;

use lfpiv_hw::{CameraPoint, Optics, Pose};
use nalgebra::Point3;
use rand::{Rng, RngExt};
use rand_distr::StandardNormal;
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;

use crate::stream::{Purpose, random_stream};
use pupil::{LowDiscrepancy, PupilStrata, concentric_disc};

/// Particles traced in parallel before they are added to the image: bounds the memory of the
/// footprints, about 4 kB each.
const PARTICLES_PER_BATCH: usize = 4096;

/// Rays of a box traced as one task.
const RAYS_PER_BOX_TASK: u64 = 1 << 16;

/// How rays are drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct RaySettings {
    /// Rays per particle, rounded up to a square number.
    pub rays_per_particle: usize,
    /// Wavelength in nm where diffraction at both apertures is wanted. Each Airy pattern is
    /// replaced by the Gaussian of the same core, σ = 0.42 λ N (Zhang, Zerubia and Olivo-Marin
    /// 2007), with the working f-numbers of the main lens and of a microlens.
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
    /// Standard deviations of the diffraction blur on the microlens plane and on the sensor, mm.
    blur_mm: Option<(f64, f64)>,
}

impl<'a> RayTracer<'a> {
    /// A tracer through `optics` standing at `pose`.
    pub fn new(optics: &'a Optics, pose: &'a Pose, settings: &RaySettings) -> Self {
        let blur_mm = settings.diffraction_nm.map(|wavelength_nm| {
            let sigma_mm = |f_number: f64| 0.42 * wavelength_nm * 1e-6 * f_number;
            let lens = &optics.microlens;
            (
                sigma_mm(optics.image_distance_mm() / optics.pupil_diameter_mm()),
                sigma_mm(lens.focal_length_mm / lens.pitch_mm),
            )
        });
        let strata = PupilStrata::new(optics.pupil_diameter_mm() / 2.0, settings.rays_per_particle);
        Self { optics, pose, strata, blur_mm }
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
    /// randomly shifted by `seed`: it converges faster than independent draws.
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
                self.point_imaging(start_mm)?.pixel(self, on_pupil_mm, &mut rng)
            })
            .collect();
        count_runs(&mut pixels)
    }

    /// Rays per pixel of one source.
    fn footprint(&self, source: &PointSource, stream: &[u64]) -> Vec<(u32, u32)> {
        let Some(imaging) = self.point_imaging(source.position_mm) else {
            return Vec::new();
        };
        let key: Vec<u64> = stream.iter().copied().chain([source.id]).collect();
        let mut rng = random_stream(Purpose::Rays, &key);
        let mut pixels = Vec::with_capacity(self.strata.rays());
        for stratum in 0..self.strata.rays() {
            let on_pupil_mm = self.strata.jittered(stratum, rng.next_u64());
            pixels.extend(imaging.pixel(self, on_pupil_mm, &mut rng));
        }
        count_runs(&mut pixels)
    }

    /// How the main lens images a world point, or `None` for a point not in front of the lens.
    fn point_imaging(&self, position_mm: [f64; 3]) -> Option<PointImaging> {
        let seen = self.pose.to_camera(&Point3::from(position_mm));
        PointImaging::new(self.optics, seen)
    }
}

/// Where the rays of one point meet the microlens plane: x = a U + b ξ, and likewise in y.
///
/// From DESIGN section 2, x = U + (ξ' − U) s_i/s' with ξ' = −ξ s'/s gives a = 1 − s_i/s' and
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

    /// Index of the pixel that the ray through `pupil_mm` hits, if any.
    #[inline]
    fn pixel(&self, tracer: &RayTracer, pupil_mm: [f64; 2], rng: &mut Pcg64Mcg) -> Option<u32> {
        let optics = tracer.optics;
        let lens = &optics.microlens;
        let mut plane_mm: [f64; 2] =
            std::array::from_fn(|axis| self.pupil_factor * pupil_mm[axis] + self.centre_mm[axis]);
        if let Some((sigma_mm, _)) = tracer.blur_mm {
            blur(&mut plane_mm, sigma_mm, rng);
        }
        let column = nearest(plane_mm[0] / lens.pitch_mm, lens.columns)?;
        let row = nearest(plane_mm[1] / lens.pitch_mm, lens.rows)?;
        let slope = lens.focal_length_mm / optics.image_distance_mm();
        let mut sensor_mm = [
            lens.column_centre_mm(column) + slope * (plane_mm[0] - pupil_mm[0]),
            lens.row_centre_mm(row) + slope * (plane_mm[1] - pupil_mm[1]),
        ];
        if let Some((_, sigma_mm)) = tracer.blur_mm {
            blur(&mut sensor_mm, sigma_mm, rng);
        }
        let sensor = &optics.sensor;
        let pitch_mm = optics.pixel_pitch_mm();
        let pixel_column = nearest(sensor_mm[0] / pitch_mm, sensor.columns)?;
        // Rows count downwards, against `up`.
        let pixel_row = nearest(-sensor_mm[1] / pitch_mm, sensor.rows)?;
        Some((pixel_row * sensor.columns + pixel_column) as u32)
    }
}

/// Index of the nearest of `count` cells of unit pitch centred on zero, or `None` outside them.
#[inline]
fn nearest(position: f64, count: usize) -> Option<usize> {
    let from_edge = (position + count as f64 / 2.0).floor();
    (from_edge >= 0.0 && from_edge < count as f64).then_some(from_edge as usize)
}

fn blur(position_mm: &mut [f64; 2], sigma_mm: f64, rng: &mut Pcg64Mcg) {
    for coordinate in position_mm {
        let deviation: f64 = rng.sample(StandardNormal);
        *coordinate += sigma_mm * deviation;
    }
}

/// Sorts pixel indices and counts how often each occurs.
fn count_runs(pixels: &mut [u32]) -> Vec<(u32, u32)> {
    pixels.sort_unstable();
    pixels.chunk_by(|a, b| a == b).map(|run| (run[0], run.len() as u32)).collect()
}

#[cfg(test)]
mod tests;
