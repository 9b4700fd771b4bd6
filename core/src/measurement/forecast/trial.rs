//! A trial: particles at random in a flow, imaged, measured as a real pair is, and compared.

use nalgebra::Vector3;
use rand::{Rng, RngExt};

use super::{
    ForecastError, SceneConditions,
    exposure::{Exposures, PointSource},
    flow::WavyFlow,
    generator,
};
use crate::{
    lightfield::{Background, ImagePair},
    measurement::{Measurement, Processor},
    velocimetry::{VectorGrid, VectorStatus},
};

/// A bench with what it measures.
pub(super) struct SimulatedBench<'a> {
    exposures: Exposures<'a>,
    processor: Processor,
    conditions: &'a SceneConditions,
}

/// Errors of a pair.
pub(super) struct Errors {
    /// Of every valid vector, by its number: along x, y, z, in voxels.
    pub valid: Vec<(usize, [f64; 3])>,
    /// Vectors that are flow.
    pub in_flow: usize,
}

impl<'a> SimulatedBench<'a> {
    /// # Errors
    /// A camera does not see the volume, or it reaches too deep for the lens.
    pub fn new(
        measurement: &Measurement,
        conditions: &'a SceneConditions,
    ) -> Result<Self, ForecastError> {
        let exposures = Exposures::new(measurement, conditions)?;
        let mut measurement = measurement.clone();
        // There is no run to learn stationary light from.
        measurement.image.background = Background::Constant;
        Ok(Self { exposures, processor: Processor::new(measurement)?, conditions })
    }

    pub fn vector_grid(&self) -> VectorGrid {
        self.processor.interrogation().vector_grid()
    }

    /// Images pair number `pair`, measures it, and compares.
    ///
    /// # Errors
    /// The model of a pair cannot be built.
    pub fn errors_vox(&self, pair: u64) -> Result<Errors, ForecastError> {
        let Measurement { volume, velocimetry, .. } = self.processor.measurement();
        let largest_mm = velocimetry.max_displacement_vox * volume.voxel_mm;
        let mut random = generator(pair + (1 << 17));
        let flow = WavyFlow::random(velocimetry.window_mm, largest_mm, &mut random);
        let frames = self.particles(&flow, &mut random);
        let image = |camera: usize, frame: usize| {
            let stream = (pair << 8) + 2 * camera as u64 + frame as u64 + 1;
            self.exposures.image(camera, &frames[frame], stream)
        };
        let cameras = (0..self.exposures.cameras()).map(|c| [image(c, 0), image(c, 1)]).collect();
        let field = self.processor.process(ImagePair { cameras })?.field;
        let error = |n: usize| {
            let [a_mm, b_mm] = flow.in_frames(field.grid.position_mm(n).into());
            let moved_mm = b_mm - a_mm;
            std::array::from_fn(|c| {
                f64::from(field.displacement_vox[n][c]) - moved_mm[c] / field.voxel_mm
            })
        };
        let with = |status: VectorStatus| {
            field.status.iter().enumerate().filter(move |(_, own)| **own == status)
        };
        Ok(Errors {
            valid: with(VectorStatus::Valid).map(|(n, _)| (n, error(n))).collect(),
            in_flow: field.status.len() - with(VectorStatus::Masked).count(),
        })
    }

    /// The particles that are lit in frames a and b: those in the volume then, and not in a body.
    fn particles(&self, flow: &WavyFlow, random: &mut impl Rng) -> [Vec<PointSource>; 2] {
        let Measurement { optics, volume, velocimetry, mask, .. } = self.processor.measurement();
        let size_mm = volume.voxels.map(|voxels| voxels as f64 * volume.voxel_mm);
        let per_mm3 = self.conditions.ppm / optics.object_pitch_mm().powi(2) / size_mm[2];
        // Particles come in by the faces as well.
        let drawn_mm =
            size_mm.map(|size| size + velocimetry.max_displacement_vox * volume.voxel_mm);
        let count = (per_mm3 * drawn_mm.iter().product::<f64>()).round() as usize;
        let is_lit = |at_mm: [f64; 3]| {
            (0..3).all(|axis| (at_mm[axis] - volume.centre_mm[axis]).abs() <= size_mm[axis] / 2.0)
                && mask.as_ref().is_none_or(|mask| mask.is_flow(at_mm))
        };
        let mut frames = [Vec::new(), Vec::new()];
        for _ in 0..count {
            let middle_mm = Vector3::from_fn(|axis, _| {
                volume.centre_mm[axis] + drawn_mm[axis] * (random.random::<f64>() - 0.5)
            });
            let spread = self.conditions.intensity_spread * (2.0 * random.random::<f64>() - 1.0);
            for (frame, at_mm) in frames.iter_mut().zip(flow.in_frames(middle_mm)) {
                let at_mm = at_mm.into();
                if is_lit(at_mm) {
                    frame.push(PointSource { at_mm, brightness: 1.0 + spread });
                }
            }
        }
        frames
    }
}
