//! The images of points on the cameras' sensors: the exact footprints of [`PointCamera`], which reconstruction does
//! not use, with the noise of light and sensor.

use lfpiv_hw::{CameraName, RawImage};
use rand::RngExt;
use rand_distr::StandardNormal;
use rayon::prelude::*;

use super::{SceneConditions, generator};
use crate::{
    measurement::Measurement,
    model::{AIRY_SIGMA, CameraCalibration, ModelError, PointBlur, PointCamera, PointFootprint},
};

/// A point of light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PointSource {
    pub at_mm: [f64; 3],
    /// Its brightness over that of the mean particle.
    pub brightness: f64,
}

/// All cameras and their sensors.
pub(super) struct Exposures<'a> {
    cameras: Vec<PointCamera>,
    conditions: &'a SceneConditions,
}

impl<'a> Exposures<'a> {
    /// # Errors
    /// A camera does not see the volume, or it reaches too deep for the lens.
    pub fn new(
        measurement: &Measurement,
        conditions: &'a SceneConditions,
    ) -> Result<Self, ModelError> {
        let Measurement { optics, cameras, calibrations, volume, .. } = measurement;
        let (uncalibrated, pixel_mm) = (CameraCalibration::default(), optics.pixel_pitch_mm());
        // Microlenses have the f-number that the main lens works at: both blur alike.
        let f_number = optics.microlens.focal_length_mm / optics.microlens.pitch_mm;
        let plane_mm =
            conditions.diffraction_nm.map_or(0.0, |nm| AIRY_SIGMA * nm * 1e-6 * f_number);
        let blur = PointBlur { plane_mm, sensor_px: plane_mm / pixel_mm };
        let camera = |(n, pose)| {
            let calibration = calibrations.get(n).unwrap_or(&uncalibrated);
            PointCamera::new(optics, pose, calibration, volume, CameraName(n), blur)
        };
        let cameras = cameras.iter().enumerate().map(camera).collect::<Result<_, _>>()?;
        Ok(Self { cameras, conditions })
    }

    /// How many cameras there are.
    pub fn cameras(&self) -> usize {
        self.cameras.len()
    }

    /// What camera number `camera` records of `sources`, with the noise of random numbers `stream`.
    pub fn image(&self, camera: usize, sources: &[PointSource], stream: u64) -> RawImage {
        let camera = &self.cameras[camera];
        let [columns, rows] = camera.sensor_px();
        let electrons = electrons(camera, sources, self.conditions.photoelectrons);
        let mut counts = vec![0; columns * rows];
        counts.par_chunks_mut(columns).zip(electrons.par_chunks(columns)).enumerate().for_each(
            |(row, (counts, electrons))| {
                let mut random = generator((stream << 32) + row as u64);
                for (count, &electrons) in counts.iter_mut().zip(electrons) {
                    *count = self.count(f64::from(electrons), random.sample(StandardNormal));
                }
            },
        );
        RawImage::new(columns, rows, counts).expect("a count per pixel")
    }

    /// The count of a pixel in which so many electrons are expected. Photo-electrons and read-out are normal
    /// together: where a Poisson distribution is not, read-out is larger.
    fn count(&self, electrons: f64, deviate: f64) -> u16 {
        let SceneConditions { background_electrons, read_noise_electrons, .. } = *self.conditions;
        let mean = electrons + background_electrons;
        let seen = mean + (mean + read_noise_electrons * read_noise_electrons).sqrt() * deviate;
        let counts = self.conditions.offset_counts + self.conditions.counts_per_electron * seen;
        // The cast takes what is below zero to zero.
        (counts.round() as u16).min(self.conditions.saturation_counts)
    }
}

/// Photo-electrons of sources of which the mean one releases `photoelectrons`.
fn electrons(camera: &PointCamera, sources: &[PointSource], photoelectrons: f64) -> Vec<f32> {
    let [width, height] = camera.sensor_px();
    let (open, stride) = (camera.open_shares(), camera.open_stride());
    // Open shares are in steps of 1/255.
    let unit = photoelectrons * camera.light_per_cell() / 255.0;
    let (mut image, mut footprint) = (vec![0.0; width * height], PointFootprint::default());
    for source in sources {
        camera.image(source.at_mm, &mut footprint);
        let light = (unit * source.brightness) as f32;
        for patch in &footprint.patches {
            let columns = footprint.of(0, &patch.columns);
            for (r, row) in footprint.of(0, &patch.rows).iter().enumerate() {
                let pixels =
                    &mut image[(patch.rows.first_px + r) * width + patch.columns.first_px..];
                let open = &open[patch.open + r * stride..];
                for ((pixel, column), open) in pixels.iter_mut().zip(columns).zip(open) {
                    *pixel += light * row * column * f32::from(*open);
                }
            }
        }
    }
    image
}
