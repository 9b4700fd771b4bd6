//! The particles of a pair, placed in its images.

use lfpiv_hw::CameraName;

use super::{Measurement, frame::Correction};
use crate::{
    lightfield::ImagePair,
    model::{CameraCalibration, ModelError, PointCamera, VolumeGrid},
    particles::{
        Candidate, FIRST_WIDTH_PX, Flow, FrameStart, ParticleImage, ParticlePair, PixelNoise,
        PlacedParticles, blur_of_width, place_pairs,
    },
    reconstruction::SparseVolume,
    velocimetry::{CorrectedField, MeasuredParticle, PointCloud, Sample, particles},
};

/// How the cameras image points of `volume`, with the blur that the fit starts from.
///
/// # Errors
/// A camera does not see the volume, or its array is not square.
pub(super) fn point_cameras(
    measurement: &Measurement,
    volume: &VolumeGrid,
) -> Result<Vec<PointCamera>, ModelError> {
    let Measurement { optics, cameras, calibrations, .. } = measurement;
    let uncalibrated = CameraCalibration::default();
    let blur = blur_of_width(FIRST_WIDTH_PX, optics.pixel_pitch_mm());
    let camera = |(n, pose)| {
        let calibration = calibrations.get(n).unwrap_or(&uncalibrated);
        PointCamera::new(optics, pose, calibration, volume, CameraName(n), blur)
    };
    cameras.iter().enumerate().map(camera).collect()
}

/// Least standard deviation of a particle's displacement, in voxels: error of the midpoint rule.
const LEAST_DEVIATION_VOX: f32 = 1e-3;

/// Input of the particle fit: a pair after correlation.
pub(super) struct PairForPlacing<'a> {
    pub cameras: &'a [PointCamera],
    pub correction: &'a Correction<'a>,
    /// The light of frames a and b.
    pub volumes: [&'a SparseVolume; 2],
    /// The grid of the light, with margin.
    pub grid: &'a VolumeGrid,
}

/// Assumed standard deviation of displacements that correct the flow during the fit, in voxels.
const PLACING_ERROR_VOX: f32 = 0.02;

/// The flow in mm.
struct FlowInMm<'a, 'b> {
    field: &'a mut CorrectedField<'b>,
    grid: &'a VolumeGrid,
}

impl Flow for FlowInMm<'_, '_> {
    fn displacement_mm(&self, at_mm: [f64; 3]) -> [f64; 3] {
        self.field.at(at_vox(self.grid, at_mm)).map(|vox| f64::from(vox) * self.grid.voxel_mm)
    }

    fn correct(&mut self, middles_mm: &[[f64; 3]], moved_mm: &[[f64; 3]]) {
        let sample = |(middle_mm, moved_mm): (&[f64; 3], &[f64; 3])| Sample {
            middle_vox: at_vox(self.grid, *middle_mm),
            displacement_vox: moved_mm.map(|mm| (mm / self.grid.voxel_mm) as f32),
            variance_vox2: [PLACING_ERROR_VOX * PLACING_ERROR_VOX; 3],
        };
        self.field.correct(middles_mm.iter().zip(moved_mm).map(sample));
    }
}

fn at_vox(grid: &VolumeGrid, at_mm: [f64; 3]) -> [f32; 3] {
    std::array::from_fn(|axis| grid.index_of(axis, at_mm[axis]) as f32)
}

impl PairForPlacing<'_> {
    /// The particles: candidates are the local maxima of light in the volumes. They correct `field`.
    pub fn place(&self, pair: &ImagePair, field: &mut CorrectedField<'_>) -> PlacedParticles {
        let (a, b) = rayon::join(|| self.start(pair, 0), || self.start(pair, 1));
        let mut flow = FlowInMm { field, grid: self.grid };
        place_pairs(self.cameras, self.grid.voxel_mm, [a, b], &mut flow)
    }

    fn start(&self, pair: &ImagePair, frame: usize) -> FrameStart {
        let image = |camera: usize| {
            let (image, levels) = self.correction.levels(pair, camera, frame);
            let dark = (levels.noise_counts * levels.noise_counts) as f32;
            let noise = PixelNoise { dark, gain: 0.0, misfit: 0.0 };
            ParticleImage::new(&image, &levels, noise)
        };
        let grid = self.grid;
        let cloud = PointCloud::from_volume(self.volumes[frame], grid);
        let candidates = particles(&cloud).into_iter().map(|peak| Candidate {
            at_mm: std::array::from_fn(|axis| {
                grid.coordinate_mm(axis, f64::from(peak.at_vox[axis]))
            }),
            light: f64::from(peak.light),
        });
        FrameStart {
            images: (0..self.cameras.len()).map(image).collect(),
            candidates: candidates.collect(),
        }
    }
}

/// Displacement samples of `pairs`, in voxels of `grid`.
pub(super) fn samples(pairs: &[ParticlePair], grid: &VolumeGrid) -> Vec<Sample> {
    let vox = |mm: f64| (mm / grid.voxel_mm) as f32;
    let sample = |pair: &ParticlePair| Sample {
        middle_vox: at_vox(grid, pair.middle_mm()),
        displacement_vox: pair.displacement_mm().map(vox),
        variance_vox2: pair.uncertainty_mm().map(|mm| vox(mm).max(LEAST_DEVIATION_VOX).powi(2)),
    };
    pairs.iter().map(sample).collect()
}

/// Positions of the particles without a partner, in voxels of `grid`.
pub(super) fn alone(placed: &PlacedParticles, grid: &VolumeGrid) -> [Vec<[f32; 3]>; 2] {
    placed.unpaired.each_ref().map(|of| of.iter().map(|one| at_vox(grid, one.at_mm)).collect())
}

/// The particles of `samples`, and whether they agree with their neighbours.
pub(super) fn measured_particles(
    pairs: &[ParticlePair],
    samples: &[Sample],
    agrees: &[bool],
) -> Vec<MeasuredParticle> {
    let particle = |((pair, sample), &agrees): ((&ParticlePair, &Sample), &bool)| {
        let [a, b] = pair.light;
        MeasuredParticle {
            at_mm: pair.middle_mm(),
            displacement_vox: sample.displacement_vox,
            uncertainty_vox: sample.variance_vox2.map(f32::sqrt),
            light: std::array::from_fn(|camera| ((a[camera] + b[camera]) / 2.0) as f32),
            agrees,
        }
    };
    pairs.iter().zip(samples).zip(agrees).map(particle).collect()
}
