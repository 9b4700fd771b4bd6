//! Light-field images by ray tracing.
//!
//! Rays leave a point through equal-area strata of the circular pupil and follow the thin-lens
//! rules of docs/theory.md, section 2, ray by ray. The tracer shares neither voxel weights with the
//! reconstruction nor the fitted map with the calibration, so its images can test both. Deviations
//! of a camera from its nominal properties ([`CameraFlaws`]) change the paths of the rays.
//! Simplifications: every particle sends the same light through the pupil from any position (no
//! fall-off with distance, no reflection at walls), and lenses have no aberrations except
//! distortion.

mod blemishes;
mod card;
mod cells;
mod conventional;
mod detector;
mod electron_image;
mod flaws;
mod main_lens;
mod microlenses;
mod pupil;
mod wall;
mod white;

use lfpiv_hw::{Optics, Pose};
use nalgebra::{Point3, Rotation3, Vector3};
use rand_pcg::Pcg64Mcg;
use rayon::prelude::*;

use crate::stream::{Purpose, random_stream};
use blemishes::Blemishes;
use detector::Detector;
use main_lens::{ImagedPoint, MainLens, RayBundle};
use pupil::{LowDiscrepancy, PupilStrata, concentric_disc};
use wall::{RefractedPoint, WallView};

pub use card::PlacedCard;
pub use conventional::ConventionalCamera;
pub use electron_image::ElectronImage;
pub use flaws::{CameraFlaws, Distortion, Dust, SecondAperture, WallSettings};
pub use white::TrueMicroImageGrid;

/// Particles traced in parallel before they are added to the image. Limits the memory for
/// footprints, about 20 kB each.
const PARTICLES_PER_BATCH: usize = 1024;

/// Rays of a box traced as one task.
const RAYS_PER_BOX_TASK: u64 = 1 << 16;

/// Settings of ray tracing.
#[derive(Debug, Clone, PartialEq)]
pub struct RaySettings {
    /// Rays per particle, rounded up to a square number.
    pub rays_per_particle: usize,
    /// Wavelength in nm to simulate diffraction. Each Airy pattern, of the main lens on the
    /// microlenses and of a microlens on the sensor, is replaced by a Gaussian with the same core.
    pub diffraction_nm: Option<f64>,
}

/// A point light source in the world.
#[derive(Debug, Clone, PartialEq)]
pub struct PointSource {
    /// Number of its random stream: the particle's number, independent of the order of a list.
    pub id: u64,
    /// World position, in mm.
    pub position_mm: [f64; 3],
    /// Photo-electrons that it would release if no ray were lost.
    pub electrons: f64,
}

/// Traces rays through one camera.
#[derive(Debug, Clone)]
pub struct RayTracer<'a> {
    optics: &'a Optics,
    pose: Pose,
    lens: MainLens,
    wall: Option<WallView>,
    strata: PupilStrata,
    detector: Detector,
    blemishes: Blemishes,
}

/// The rays of one point.
enum Bundle {
    InAir(ImagedPoint),
    ThroughWall(Box<RefractedPoint>),
}

impl RayBundle for Bundle {
    fn on_microlenses_mm(&self, stop_mm: [f64; 2]) -> [f64; 2] {
        match self {
            Self::InAir(bundle) => bundle.on_microlenses_mm(stop_mm),
            Self::ThroughWall(bundle) => bundle.on_microlenses_mm(stop_mm),
        }
    }
}

impl<'a> RayTracer<'a> {
    /// A tracer for nominal `optics` at `pose`.
    pub fn new(optics: &'a Optics, pose: &Pose, settings: &RaySettings) -> Self {
        Self::imperfect(optics, pose, [0.0; 3], &CameraFlaws::default(), settings)
    }

    /// A tracer for a camera with nominal `optics` and `pose` that is displaced by `shift_mm` (x,
    /// y, z of the world) and has `flaws`.
    pub fn imperfect(
        optics: &'a Optics,
        pose: &Pose,
        shift_mm: [f64; 3],
        flaws: &CameraFlaws,
        settings: &RaySettings,
    ) -> Self {
        let lens = MainLens::new(optics, flaws);
        let shift_mm = Vector3::from(shift_mm);
        let [x, y, z] = flaws.turn_deg.map(f64::to_radians);
        let turn = Rotation3::from_euler_angles(x, y, z);
        let wall = flaws.wall.as_ref();
        Self {
            optics,
            wall: wall.map(|wall| WallView::new(wall, &lens, pose, &turn, shift_mm)),
            pose: Pose {
                right: turn * pose.right,
                up: turn * pose.up,
                axis: turn * pose.axis,
                origin_mm: pose.origin_mm + shift_mm,
            },
            strata: PupilStrata::new(lens.stop_radius_mm, settings.rays_per_particle),
            detector: Detector::new(optics, &lens, flaws, settings.diffraction_nm),
            blemishes: Blemishes::new(optics, flaws),
            lens,
        }
    }

    /// The image of `sources`. `stream` (seed, shot, camera, frame…) and each source's id select
    /// the random numbers, so the result is identical, bit for bit, for any number of threads.
    pub fn trace(&self, sources: &[PointSource], stream: &[u64]) -> ElectronImage {
        let mut image = ElectronImage::dark(self.optics);
        for batch in sources.chunks(PARTICLES_PER_BATCH) {
            let footprints: Vec<Vec<(u32, u32)>> =
                batch.par_iter().map(|source| self.footprint(source, stream)).collect();
            // Adding in the order of the sources makes rounding independent of the threads.
            for (source, footprint) in batch.iter().zip(footprints) {
                let per_ray = source.electrons / self.strata.rays() as f64;
                for (pixel, rays) in footprint {
                    image.electrons_mut()[pixel as usize] += (per_ray * f64::from(rays)) as f32;
                }
            }
        }
        self.blemishes.apply(&mut image);
        image
    }

    /// The image of a uniformly glowing box with edges of `edge_mm` along the world axes and its
    /// centre at `centre_mm`, releasing `electrons` in total. `rays` rays, rounded up to a multiple
    /// of 65,536, start at points spread through the box. Used to test forward models.
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
            image.electrons_mut()[pixel as usize] += (per_ray * f64::from(rays)) as f32;
        }
        self.blemishes.apply(&mut image);
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
        let radius_mm = self.lens.stop_radius_mm;
        let first = task * RAYS_PER_BOX_TASK;
        let mut pixels: Vec<u32> = (first..first + RAYS_PER_BOX_TASK)
            .filter_map(|ray| {
                let [u, v, fractions @ ..] = sequence.point(ray);
                let start_mm: [f64; 3] =
                    std::array::from_fn(|axis| centre_mm[axis] + (fractions[axis] - 0.5) * edge_mm);
                let stop_mm = concentric_disc([2.0 * u - 1.0, 2.0 * v - 1.0], radius_mm);
                let plane_mm = self.on_microlenses_mm(start_mm, stop_mm)?;
                self.hit(plane_mm, stop_mm, &mut rng)
            })
            .collect();
        count_runs(&mut pixels)
    }

    /// Pixels hit by the rays of one source, with the number of consecutive hits; a pixel may occur
    /// several times.
    fn footprint(&self, source: &PointSource, stream: &[u64]) -> Vec<(u32, u32)> {
        let key: Vec<u64> = stream.iter().copied().chain([source.id]).collect();
        match self.bundle(source.position_mm) {
            None => Vec::new(),
            Some(Bundle::InAir(bundle)) => self.runs(&bundle, &key),
            Some(Bundle::ThroughWall(bundle)) => self.runs(&*bundle, &key),
        }
    }

    fn runs(&self, bundle: &impl RayBundle, key: &[u64]) -> Vec<(u32, u32)> {
        let mut rng = random_stream(Purpose::Rays, key);
        let mut diffraction_rng = random_stream(Purpose::Diffraction, key);
        let mut runs: Vec<(u32, u32)> = Vec::with_capacity(self.strata.rays() / 2);
        self.strata.jittered(&mut rng, |stop_mm| {
            let plane_mm = bundle.on_microlenses_mm(stop_mm);
            let pixel = self.hit(plane_mm, stop_mm, &mut diffraction_rng);
            // Neighbouring strata mostly hit the same pixel.
            match (pixel, runs.last_mut()) {
                (None, _) => {}
                (Some(pixel), Some((last, rays))) if *last == pixel => *rays += 1,
                (Some(pixel), _) => runs.push((pixel, 1)),
            }
        });
        runs
    }

    /// Position on the microlens plane of the ray from a world point through a position on the
    /// stop, both in mm along the sensor's right and up; `None` for a point that the camera cannot
    /// see.
    pub fn on_microlenses_mm(&self, position_mm: [f64; 3], stop_mm: [f64; 2]) -> Option<[f64; 2]> {
        Some(self.bundle(position_mm)?.on_microlenses_mm(stop_mm))
    }

    /// The rays of a world point. `None` for a point that is not in front of the camera, or is not
    /// behind the wall if there is one.
    fn bundle(&self, position_mm: [f64; 3]) -> Option<Bundle> {
        let position_mm = Point3::from(position_mm);
        Some(match &self.wall {
            None => Bundle::InAir(self.lens.bundle(self.pose.to_camera(&position_mm))?),
            Some(wall) => Bundle::ThroughWall(Box::new(wall.bundle(&position_mm)?)),
        })
    }

    /// The pixel hit by the ray through `stop_mm` that meets the microlens plane at `plane_mm`.
    #[inline]
    fn hit(&self, plane_mm: [f64; 2], stop_mm: [f64; 2], rng: &mut Pcg64Mcg) -> Option<u32> {
        if !self.lens.lets_pass(plane_mm, stop_mm) {
            return None;
        }
        self.detector.pixel(plane_mm, stop_mm, rng)
    }
}

/// Sorts pixel indices and counts how often each occurs.
fn count_runs(pixels: &mut [u32]) -> Vec<(u32, u32)> {
    pixels.sort_unstable();
    pixels.chunk_by(|a, b| a == b).map(|run| (run[0], run.len() as u32)).collect()
}

#[cfg(test)]
mod tests;
