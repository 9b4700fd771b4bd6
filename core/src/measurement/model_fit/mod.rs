//! Model fit: how well the configured bench explains a pair's images, and likely causes if it does not.
//!
//! Five tests, each from the images of this pair only:
//!
//! 1. Are the micro-images at their configured positions? ([`MicroImages`])
//! 2. Does the reconstruction explain each camera's light? ([`unexplained`])
//! 3. Do both cameras see the same particles? ([`agreement`])
//! 4. Do they place them at the same positions? ([`disparity`])
//! 5. Do windows with particles give vectors?
//!
//! [`causes`] derives the verdict and the likely causes.

mod agreement;
mod bench_error;
mod causes;
mod disparity;
mod sources;
mod unexplained;

use lfpiv_hw::{CameraName, RawImage};
use nalgebra::Vector3;
use rayon::prelude::*;

use self::{
    agreement::{Agreement, profile, shared_direction},
    bench_error::ConfiguredBench,
    causes::{Evidence, judge},
    disparity::{Disparity, disparity, position_equations},
    sources::{lit_windows, sources},
    unexplained::unexplained,
};
use super::{Measurement, fitted::Fitted, frame::Frame};
use crate::{
    lightfield::{ImagePair, MicroImages},
    model::PointImager,
    reconstruction::{CameraFit, Footprint, ModelFit, ProjectedView, Reconstruction, Solver},
    velocimetry::{VectorStatus, VelocityField},
};

/// Edge of the light source that represents a reconstructed particle, in microlens pitches in the
/// volume: approximately the width of a point reconstructed by OS-MART on quarter voxels.
const SOURCE_PITCHES: f64 = 0.5;

/// Largest voxel size, in microlens pitches, at which the residual depends more on the bench than
/// on the voxels.
const FINE_VOXEL_PITCHES: f64 = 0.3;

/// Bins of the common profile affected by the ends of the volume.
const END_BINS: f64 = 6.0;

/// Inputs of the assessment.
pub(super) struct FitInputs<'a> {
    pub measurement: &'a Measurement,
    pub fitted: &'a Fitted,
    /// Frames a and b.
    pub frames: [&'a Frame; 2],
    pub solved: [&'a Reconstruction; 2],
    pub field: &'a VelocityField,
    /// Measured micro-images of each camera, in frame a.
    pub micro_images: Vec<Option<MicroImages>>,
}

/// Measures the micro-images of frame a, per camera.
pub(super) fn micro_images(
    measurement: &Measurement,
    pair: &ImagePair,
) -> Vec<Option<MicroImages>> {
    if !measurement.is_nominal() {
        return vec![None; pair.cameras.len()];
    }
    pair.cameras.par_iter().map(|[a, _]| MicroImages::find(&measurement.optics, a)).collect()
}

/// Cameras whose frames a and b are identical.
pub(super) fn identical_frames(pair: &ImagePair) -> impl Iterator<Item = CameraName> {
    let same = |[a, b]: &[RawImage; 2]| a == b;
    pair.cameras
        .iter()
        .enumerate()
        .filter(move |(_, frames)| same(frames))
        .map(|(n, _)| CameraName(n))
}

impl FitInputs<'_> {
    /// The fit of this pair, with a verdict.
    pub fn fit(self) -> ModelFit {
        let lit = self.frames.iter().all(|frame| frame.lit);
        let unexplained = || {
            let cameras = 0..self.measurement.cameras.len();
            cameras.into_par_iter().map(|camera| self.unexplained(camera)).collect()
        };
        let (unexplained, (agreement, disparity)) = rayon::join(unexplained, || match lit {
            true => rayon::join(|| self.agreement(), || self.disparity()),
            false => (None, None),
        });
        let evidence = Evidence {
            measurement: self.measurement,
            lit,
            residual_counts: self.residual_is_of_the_bench(),
            saturated_share: self.frames.iter().map(|f| f.saturated_share).fold(0.0, f64::max),
            micro_images: &self.micro_images,
            unexplained,
            agreement,
            disparity,
            valid_share: self.valid_share(),
        };
        let (verdict, causes) = judge(&evidence);
        let offset = |found: &Option<MicroImages>| {
            found.map(|found| found.farthest_px[0].max(found.farthest_px[1]))
        };
        ModelFit {
            verdict,
            cameras: evidence
                .unexplained
                .iter()
                .zip(&self.micro_images)
                .map(|(&unexplained, found)| CameraFit {
                    unexplained,
                    micro_image_offset_px: offset(found),
                })
                .collect(),
            camera_agreement: evidence.agreement.map(|agreement| agreement.direct),
            camera_disparity_mm: evidence.disparity.map(|disparity| disparity.rms_mm),
            valid_share: evidence.valid_share.unwrap_or(0.0),
            causes,
        }
    }

    /// Whether the residual depends on the bench: OS-MART on voxels small enough for a particle's
    /// light, or on the particles' own positions.
    fn residual_is_of_the_bench(&self) -> bool {
        let Measurement { optics, volume, reconstruction, .. } = self.measurement;
        let pitch_mm = optics.object_pitch_mm();
        let voxel_mm = volume.voxel_mm / self.fitted.choice.refinement.max(1) as f64;
        reconstruction.solver == Solver::OsMart
            && reconstruction.footprint == Footprint::Voxel
            && voxel_mm <= FINE_VOXEL_PITCHES * pitch_mm
    }

    fn projected(&self, frame: usize, camera: usize) -> Vec<&ProjectedView> {
        self.solved[frame].projected.iter().filter(|view| view.id.camera == camera).collect()
    }

    /// The larger value of both frames.
    fn unexplained(&self, camera: usize) -> f64 {
        let layout = &self.fitted.reconstructor.layouts()[camera];
        (0..2)
            .map(|n| {
                let frame = self.frames[n];
                let (views, levels) = (&frame.views[camera], &frame.levels[camera]);
                unexplained(views, layout, levels, &self.projected(n, camera))
            })
            .fold(0.0, f64::max)
    }

    /// The lower value of both frames.
    fn agreement(&self) -> Option<Agreement> {
        if !self.measurement.is_nominal() {
            return None;
        }
        let Measurement { optics, cameras, volume, .. } = self.measurement;
        let direction = shared_direction(cameras)?;
        let layouts = self.fitted.reconstructor.layouts();
        let middle = Vector3::from(volume.centre_mm);
        let half_mm = (0..3)
            .map(|a| direction[a].abs() * volume.voxels[a] as f64 * volume.voxel_mm / 2.0)
            .sum::<f64>();
        let bin_mm = optics.object_pitch_mm();
        // At the volume's ends the profiles of all cameras fall alike.
        let half_mm = half_mm - END_BINS * bin_mm;
        let compared = self.frames.iter().map(|frame| {
            let [first, second] = [0, 1].map(|c| {
                let along = (&direction, &middle, half_mm, bin_mm);
                profile(optics, &cameras[c], &layouts[c], &frame.views[c], &frame.levels[c], along)
            });
            first.compare(&second, bin_mm)
        });
        let worse = |a: Agreement, b: Agreement| if b.direct < a.direct { b } else { a };
        compared.collect::<Option<Vec<_>>>()?.into_iter().reduce(worse)
    }

    /// For frame a.
    fn disparity(&self) -> Option<Disparity> {
        if !self.measurement.is_nominal() {
            return None;
        }
        let Measurement { optics, cameras, volume, .. } = self.measurement;
        let [first, second] = &cameras[..] else { return None };
        let solved = self.solved[0];
        let sources = sources(&solved.volume, volume);
        let source_mm = SOURCE_PITCHES * optics.object_pitch_mm();
        let parts = &self.fitted.choice.model;
        let layouts = self.fitted.reconstructor.layouts();
        let of_camera = |c: usize| {
            let pose = &cameras[c];
            let imager = PointImager::new(
                optics,
                pose,
                c,
                &solved.volume.grid,
                &layouts[c],
                source_mm,
                parts,
            )
            .ok()?;
            Some(position_equations(
                &imager,
                pose,
                &self.frames[0].views[c],
                &self.projected(0, c),
                &sources,
            ))
        };
        let bench = ConfiguredBench {
            optics,
            poses: [first, second],
            middle: Vector3::from(volume.centre_mm),
        };
        disparity(&bench, &sources, [&of_camera(0)?, &of_camera(1)?])
    }

    /// Share of windows with particles in the flow whose vectors are valid; `None` if too few windows contain
    /// particles.
    fn valid_share(&self) -> Option<f64> {
        let particle_counts =
            self.frames[0].levels.iter().map(|level| level.particle_counts).fold(0.0, f64::max);
        let window_mm = self.measurement.velocimetry.window_mm;
        let lit =
            lit_windows(&self.solved[0].volume, &self.field.grid, window_mm, particle_counts)?;
        let having =
            |wanted: VectorStatus| lit.iter().filter(|&&n| self.field.status[n] == wanted).count();
        let in_flow = lit.len() - having(VectorStatus::Masked);
        (in_flow > 0).then(|| having(VectorStatus::Valid) as f64 / in_flow as f64)
    }
}
