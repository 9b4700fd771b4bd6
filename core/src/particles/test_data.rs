//! Particles and their images for the tests of the fit.

use lfpiv_hw::{CameraName, RawImage};
use rand::RngExt;
use rand_pcg::Pcg64Mcg;

use super::{
    image::ParticleImage,
    kernels,
    noise::PixelNoise,
    normal::{CAMERAS, Particle},
};
use crate::{
    lightfield::LightLevels,
    model::{CameraCalibration, LANES, PointBlur, PointCamera, PointFootprint, VolumeGrid},
    test_bench,
};

pub const VOXEL_MM: f64 = 0.1;
/// Of every particle, in counts.
pub const LIGHT: f64 = 3000.0;
/// Number of particles. Most of their images overlap.
pub const PARTICLES: usize = 130;

/// The cameras of the test bench, about a small volume.
pub fn cameras() -> Vec<PointCamera> {
    let (optics, poses) = (test_bench::optics(), test_bench::poses());
    let volume = VolumeGrid { voxels: [30; 3], voxel_mm: VOXEL_MM, centre_mm: [0.0; 3] };
    let blur = PointBlur { plane_mm: 2e-3, sensor_px: 0.3 };
    let calibration = CameraCalibration::default();
    let camera = |(c, pose)| {
        PointCamera::new(&optics, pose, &calibration, &volume, CameraName(c), blur).unwrap()
    };
    poses.iter().enumerate().map(camera).collect()
}

/// At random places in the volume.
pub fn particles(random: &mut Pcg64Mcg) -> Vec<Particle> {
    let mut coordinate = |_| random.random_range(-1.4..1.4);
    let place = |_| [0; 3].map(&mut coordinate);
    let places: Vec<[f64; 3]> = (0..PARTICLES).map(place).collect();
    places.into_iter().map(|at_mm| Particle { at_mm, light: [LIGHT; CAMERAS] }).collect()
}

/// An image without noise.
pub fn image(camera: &PointCamera, c: usize, particles: &[Particle]) -> ParticleImage {
    let [width, height] = camera.sensor_px();
    let mut light = vec![0.0; width * height + LANES];
    let mut footprint = PointFootprint::default();
    for particle in particles {
        camera.image(particle.at_mm, &mut footprint);
        let (open, stride) = (camera.open_shares(), camera.open_stride());
        let counts = particle.light[c] as f32;
        kernels::add_image(&mut light, width, open, stride, &footprint, counts);
    }
    let counts = light[..width * height].iter().map(|light| light.round() as u16).collect();
    let image = RawImage::new(width, height, counts).unwrap();
    let levels = LightLevels {
        offset_counts: 0.0,
        background_counts: 0.0,
        noise_counts: 1.0,
        saturation_counts: None,
        saturated_share: 0.0,
        mean_signal_counts: 0.0,
        bright_share: 0.0,
    };
    ParticleImage::new(&image, &levels, PixelNoise { dark: 1.0, gain: 0.1, misfit: 0.0 })
}
