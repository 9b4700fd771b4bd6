//! The particles of a pair, placed in its images.

use lfpiv_hw::CameraName;

use super::{Measurement, frame::Correction};
use crate::{
    lightfield::ImagePair,
    model::{CameraCalibration, ModelError, PointCamera, VolumeGrid},
    particles::{
        Candidate, ExpectedDisplacement, FIRST_WIDTH_PX, Flow, FrameStart, Motion, MovedParticle,
        ParticleImage, ParticlePair, PixelNoise, PlacedParticles, blur_of_width, place_pairs,
    },
    reconstruction::SparseVolume,
    velocimetry::{
        CorrectedField, MeasuredParticle, PlacedPositions, PointCloud, Prediction, Sample,
        particles,
    },
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

    fn correct(&mut self, near: &[MovedParticle], far: &[MovedParticle]) {
        let sample = |particle: &MovedParticle| Sample {
            middle_vox: at_vox(self.grid, particle.middle_mm),
            displacement_vox: particle.moved_mm.map(|mm| (mm / self.grid.voxel_mm) as f32),
            variance_vox2: [PLACING_ERROR_VOX * PLACING_ERROR_VOX; 3],
        };
        self.field.correct(near.iter().map(sample), far.iter().map(sample));
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

/// Mid-pair positions of the particles, in voxels of `grid`.
pub(super) fn positions(placed: &PlacedParticles, grid: &VolumeGrid) -> PlacedPositions {
    let seen = placed.pairs.iter().filter(|pair| placed.is_seen_by_all(pair));
    PlacedPositions {
        paired: seen.map(|pair| at_vox(grid, pair.middle_mm())).collect(),
        alone: placed
            .unpaired
            .each_ref()
            .map(|of| of.iter().map(|one| at_vox(grid, one.at_mm)).collect()),
    }
}

/// The particles of `pairs`: from their images, and from the others' predictions where both agree.
pub(super) fn measured_particles(
    pairs: &[ParticlePair],
    predictions: &[Prediction],
    grid: &VolumeGrid,
) -> Vec<MeasuredParticle> {
    let voxel_mm = grid.voxel_mm;
    let particle = |(pair, prediction): (&ParticlePair, &Prediction)| {
        let motion = motion(pair, prediction, voxel_mm);
        let [a, b] = pair.light;
        let uncertainty_vox = |variance_mm2: [f64; 3], least: f32| {
            variance_mm2.map(|variance| ((variance.sqrt() / voxel_mm) as f32).max(least))
        };
        MeasuredParticle {
            at_mm: motion.middle_mm,
            place_uncertainty_vox: uncertainty_vox(
                motion.middle_variance_mm2,
                LEAST_DEVIATION_VOX / 2.0,
            ),
            displacement_vox: motion.displacement_mm.map(|mm| (mm / voxel_mm) as f32),
            uncertainty_vox: uncertainty_vox(motion.displacement_variance_mm2, LEAST_DEVIATION_VOX),
            light: std::array::from_fn(|camera| ((a[camera] + b[camera]) / 2.0) as f32),
            agrees: prediction.agrees,
        }
    };
    pairs.iter().zip(predictions).map(particle).collect()
}

fn motion(pair: &ParticlePair, prediction: &Prediction, voxel_mm: f64) -> Motion {
    if !prediction.agrees {
        return pair.motion();
    }
    let mm = |vox: f32| f64::from(vox) * voxel_mm;
    pair.motion_given(&ExpectedDisplacement {
        displacement_mm: prediction.displacement_vox.map(mm),
        variance_mm2: prediction.uncertainty_vox.map(|vox| mm(vox).powi(2)),
    })
}
