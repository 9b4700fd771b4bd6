//! Planar PIV: particles in a light sheet, seen by one conventional camera.

use lfpiv_hw::{Pose, RawImage};
use nalgebra::Vector3;
use rand::RngExt;
use rayon::prelude::*;

use crate::{
    flow::Flow,
    imaging::{ConventionalCamera, PointSource},
    sensor::SensorSettings,
    stream::{Purpose, random_stream},
};

/// The number by which the camera's noise is drawn: those of a bench's cameras are small.
const CAMERA: u64 = 1000;

/// Particles are simulated to this many thicknesses of the sheet from its middle, where it has e⁻⁸ of its light.
const REACH: f64 = 1.0;

/// A light sheet in the plane in focus of a conventional camera, and the particles in it.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanarScene {
    /// The camera.
    pub camera: ConventionalCamera,
    /// Thickness of the sheet along the camera's axis, in mm: between the places where a Gaussian has e⁻² of its
    /// light.
    pub sheet_mm: f64,
    /// Particles within that thickness, per pixel of the image.
    pub particles_per_pixel: f64,
    /// Half-width s of the uniform distribution of relative brightness on [1 − s, 1 + s].
    pub intensity_spread: f64,
    /// Photo-electrons of a particle of mean brightness in the middle of the sheet.
    pub particle_photoelectrons: f64,
    /// The flow that carries the particles.
    pub flow: Flow,
    /// Conversion of light into counts.
    pub sensor: SensorSettings,
}

/// What the camera records of a shot.
#[derive(Debug, Clone, PartialEq)]
pub struct PlanarShot {
    /// Exposures 1 and 2.
    pub images: [RawImage; 2],
    /// The flow of the shot.
    pub flow: Flow,
}

impl Default for PlanarScene {
    /// The paper's planar measurement: magnification −0.33, a pixel of 1/60 mm in the flow (32 pixels are 0.53 mm),
    /// 1.4 D × 1.7 D for D = 18 mm, from 0.23 D above the outlet on. Neither the lens nor the sheet is described
    /// there: 100 mm at f/11 make images of two pixels' diameter, and the sheet is 1 mm thick.
    fn default() -> Self {
        Self {
            camera: ConventionalCamera {
                pose: Pose {
                    right: Vector3::x(),
                    up: Vector3::y(),
                    axis: Vector3::z(),
                    origin_mm: Vector3::new(5.94, -10.4, 0.0),
                },
                focal_length_mm: 100.0,
                f_number: 11.0,
                magnification: -0.33,
                pixels: [1512, 1836],
                pixel_pitch_um: 5.5,
                wavelength_nm: 532.0,
            },
            sheet_mm: 1.0,
            particles_per_pixel: 0.03,
            intensity_spread: 0.2,
            particle_photoelectrons: 4000.0,
            flow: Flow::default(),
            sensor: SensorSettings::default(),
        }
    }
}

impl PlanarScene {
    /// One shot with pulses `dt_s` apart. Equal scene, seed and shot give equal results for any number of threads.
    pub fn shot(&self, dt_s: f64, seed: u64, shot: u64) -> PlanarShot {
        let flow = self.flow.of_shot(seed, shot);
        let particles = self.particles(&flow, dt_s, (seed, shot));
        let images = [-0.5, 0.5].map(|half| {
            let sources: Vec<PointSource> = particles
                .par_iter()
                .enumerate()
                .map(|(id, (middle_mm, light))| {
                    let position_mm = flow.advect_mm(*middle_mm, half * dt_s);
                    let electrons = light * self.particle_photoelectrons * self.lit(position_mm);
                    PointSource { id: id as u64, position_mm, electrons }
                })
                .collect();
            let frame = u64::from(half > 0.0);
            self.sensor.expose(&self.camera.image(&sources), &[seed, shot, CAMERA, frame])
        });
        PlanarShot { images, flow }
    }

    /// Light of the sheet at a place, relative to its middle.
    fn lit(&self, position_mm: [f64; 3]) -> f64 {
        let depth_mm = self.camera_frame(position_mm)[2];
        (-8.0 * (depth_mm / self.sheet_mm).powi(2)).exp()
    }

    /// Places in the middle of the pair, and relative brightness, of all particles that may be seen.
    fn particles(&self, flow: &Flow, dt_s: f64, (seed, shot): (u64, u64)) -> Vec<([f64; 3], f64)> {
        let pixel_mm = self.camera.object_pixel_mm();
        let reach_mm = self.reach_mm(flow, dt_s);
        let field_mm = self.camera.pixels.map(|n| n as f64 * pixel_mm);
        let [width, height] = [0, 1].map(|c| field_mm[c] + 2.0 * reach_mm[c]);
        let depth_mm = 2.0 * (REACH * self.sheet_mm + reach_mm[2]);
        let per_mm3 = self.particles_per_pixel / (pixel_mm * pixel_mm * self.sheet_mm);
        let count = (per_mm3 * width * height * depth_mm).round() as usize;
        let mut rng = random_stream(Purpose::PlanarSeeding, &[seed, shot]);
        let Pose { right, up, axis, origin_mm } = &self.camera.pose;
        (0..count)
            .map(|_| {
                let [x, y, z] =
                    [width, height, depth_mm].map(|edge| edge * rng.random_range(-0.5..0.5));
                let at = origin_mm + right * x + up * y + axis * z;
                let light = 1.0 + self.intensity_spread * rng.random_range(-1.0..=1.0);
                ([at.x, at.y, at.z], light)
            })
            .collect()
    }

    /// How far the flow carries particles in half a pulse separation along the camera's axes, in mm: the largest on
    /// a grid of places, and a tenth more for what the grid misses.
    fn reach_mm(&self, flow: &Flow, dt_s: f64) -> [f64; 3] {
        const PLACES: usize = 25;
        let Pose { right, up, origin_mm, .. } = &self.camera.pose;
        let field_mm = self.camera.pixels.map(|n| n as f64 * self.camera.object_pixel_mm());
        let mut reach_mm = [0.0_f64; 3];
        for place in 0..PLACES * PLACES {
            let [x, y] =
                [place % PLACES, place / PLACES].map(|n| n as f64 / (PLACES - 1) as f64 - 0.5);
            let start = origin_mm + right * (x * field_mm[0]) + up * (y * field_mm[1]);
            let start = [start.x, start.y, start.z];
            let [from, to] =
                [start, flow.advect_mm(start, dt_s / 2.0)].map(|at| self.camera_frame(at));
            for axis in 0..3 {
                reach_mm[axis] = reach_mm[axis].max(1.1 * (to[axis] - from[axis]).abs());
            }
        }
        reach_mm
    }

    fn camera_frame(&self, position_mm: [f64; 3]) -> [f64; 3] {
        let point = self.camera.pose.to_camera(&position_mm.into());
        [point.xi_mm, point.eta_mm, point.depth_mm]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::flow::{RoundJet, Uniform};

    fn small(flow: Flow) -> PlanarScene {
        let mut scene = PlanarScene { flow, ..PlanarScene::default() };
        scene.camera.pixels = [256, 192];
        scene
    }

    fn uniform(velocity_m_s: [f64; 3]) -> Flow {
        Flow::Uniform(Uniform { velocity_m_s })
    }

    fn light(image: &RawImage) -> f64 {
        image.counts().iter().map(|&count| f64::from(count) - 64.0).sum()
    }

    #[test]
    fn shots_can_be_repeated_and_differ_in_particles_noise_and_flow() {
        let scene = small(Flow::RoundJet(RoundJet::default()));
        let shot = |seed, shot| scene.shot(60e-6, seed, shot);
        let threads = rayon::ThreadPoolBuilder::new().num_threads(3).build().unwrap();
        assert_eq!(shot(1, 2), threads.install(|| shot(1, 2)));
        assert_ne!(shot(1, 2).images, shot(1, 3).images);
        assert_ne!(shot(1, 2).flow, shot(1, 3).flow);
        assert_ne!(shot(1, 2).images, shot(2, 2).images);
    }

    /// Both frames have the light of the density that is asked for: a Gaussian sheet has √(π/8) of its thickness.
    #[test]
    fn the_light_is_that_of_the_density_with_and_without_motion() {
        for velocity in [[0.0; 3], [0.0, 16.0, 0.0], [-5.0, 3.0, 4.0]] {
            let scene = small(uniform(velocity));
            let expected = 0.03 * 256.0 * 192.0 * (std::f64::consts::PI / 8.0).sqrt() * 4000.0;
            let mut sums = [0.0; 2];
            for shot in 0..4 {
                let images = scene.shot(60e-6, 5, shot).images;
                for (sum, image) in sums.iter_mut().zip(&images) {
                    *sum += light(image) / 4.0;
                }
            }
            for sum in sums {
                assert!((sum / expected - 1.0).abs() < 0.03, "{velocity:?}: {sum} {expected}");
            }
        }
    }

    /// The frames correlate best where the flow has carried the particles: up by 30 pixels, which the lens inverts.
    #[test]
    fn particles_move_by_the_flow_times_the_magnification() {
        let pixel_m = 1e-3 / 60.0;
        let scene = small(uniform([10.0 * pixel_m / 60e-6, 30.0 * pixel_m / 60e-6, 0.0]));
        let [a, b] = scene.shot(60e-6, 1, 0).images;
        let at = |image: &RawImage, column: usize, row: usize| {
            f64::from(image.counts()[row * 256 + column]) - 80.0
        };
        let correlation = |dc: i64, dr: i64| -> f64 {
            (60..130)
                .flat_map(|row: i64| (60..190).map(move |column: i64| (column, row)))
                .map(|(column, row)| {
                    at(&a, column as usize, row as usize)
                        * at(&b, (column + dc) as usize, (row + dr) as usize)
                })
                .sum()
        };
        let best = (-12..=12)
            .flat_map(|dc| (-40..=40).map(move |dr| (dc, dr)))
            .max_by(|a, b| correlation(a.0, a.1).total_cmp(&correlation(b.0, b.1)));
        // Rows count downwards.
        assert_eq!(best, Some((-10, 30)));
    }
}
