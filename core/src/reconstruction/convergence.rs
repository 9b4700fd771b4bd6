//! Convergence of a reconstruction, pass by pass.

use rayon::prelude::*;
use serde::Serialize;

use super::{
    DenseVolume, SparseVolume,
    quality::{quality_factor, reconstruction_error},
};
use crate::{
    lightfield::ViewStack,
    model::{Projector, ViewId},
};

/// Report of an iterative solver after each pass over all views.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct PassReport {
    /// Passes done, from 1.
    pub pass: usize,
    /// [`relative_residual`] of the volume after this pass.
    pub residual: f64,
    /// Number of active voxels.
    pub active_voxels: usize,
    /// Time of this pass on the caller's clock, in s, without computing the residual.
    pub seconds: f64,
}

/// ‖I − W E‖ / ‖I‖ over all pixels of `order`, accumulated in f64.
///
/// `intensity` has one value per voxel of the projector. Pixels that no active voxel reaches are included, so that
/// pruned volumes can be compared with whole ones. For dark views the residual is 0 for a dark volume and 1 for any
/// other. It does not depend on the number of threads.
pub fn relative_residual(
    projector: &dyn Projector,
    views: &[ViewStack],
    order: &[ViewId],
    intensity: &[f32],
) -> f64 {
    let squares: Vec<(f64, f64)> = order
        .par_iter()
        .map(|&id| {
            let measured = views[id.camera].view(id.view);
            let mut image = vec![0.0; measured.len()];
            projector.project(id, intensity, &mut image);
            image.iter().zip(measured).fold((0.0, 0.0), |(missed, seen), (&image, &measured)| {
                let measured = f64::from(measured);
                (missed + (measured - f64::from(image)).powi(2), seen + measured * measured)
            })
        })
        .collect();
    let missed: f64 = squares.iter().map(|(missed, _)| missed).sum();
    let seen: f64 = squares.iter().map(|(_, seen)| seen).sum();
    match (missed > 0.0, seen > 0.0) {
        (false, _) => 0.0,
        (true, true) => (missed / seen).sqrt(),
        (true, false) => 1.0,
    }
}

/// One line of a [`ConvergenceLog`].
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct ConvergencePoint {
    /// The solver's report.
    #[serde(flatten)]
    pub report: PassReport,
    /// Quality factor Q (paper, Eq. 5), if the truth is known.
    pub quality: Option<f64>,
    /// Reconstruction error ε (paper, Eq. 3) in the unit of the truth, if it is known.
    pub error: Option<f64>,
}

/// The history of a reconstruction.
#[derive(Debug, Clone, Default, Serialize)]
pub struct ConvergenceLog {
    /// One point per pass, in order.
    pub passes: Vec<ConvergencePoint>,
    #[serde(skip)]
    truth: Option<DenseVolume>,
}

impl ConvergenceLog {
    /// A log without a true volume.
    pub fn new() -> Self {
        Self::default()
    }

    /// A log that compares each pass with the true volume, in the intensities of
    /// [`crate::model::ForwardModel`]. Finer reconstructions are summed onto the truth's grid.
    pub fn with_truth(truth: DenseVolume) -> Self {
        Self { passes: Vec::new(), truth: Some(truth) }
    }

    /// Adds a pass; can be used as a solver's observer.
    pub fn record(&mut self, report: &PassReport, volume: &SparseVolume) {
        let compared = self.truth.as_ref().map(|truth| {
            let dense = volume.on_grid(&truth.grid);
            (
                quality_factor(&dense.intensity, &truth.intensity),
                reconstruction_error(&dense.intensity, &truth.intensity),
            )
        });
        self.passes.push(ConvergencePoint {
            report: *report,
            quality: compared.map(|(quality, _)| quality),
            error: compared.map(|(_, error)| error),
        });
    }

    /// The latest pass.
    pub fn last(&self) -> Option<&ConvergencePoint> {
        self.passes.last()
    }

    /// The first pass whose Q is at least `quality`, if any.
    pub fn first_to_reach(&self, quality: f64) -> Option<&ConvergencePoint> {
        self.passes.iter().find(|point| point.quality.is_some_and(|q| q >= quality))
    }

    /// Wall-clock time of all passes, in s.
    pub fn seconds(&self) -> f64 {
        self.passes.iter().map(|point| point.report.seconds).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        model::{ForwardModel, VolumeGrid, thin_lens_model},
        test_bench,
    };

    fn grid() -> VolumeGrid {
        VolumeGrid { voxels: [3, 2, 2], voxel_mm: 0.1, centre_mm: [0.0; 3] }
    }

    /// Views of a volume, computed with the model itself.
    fn views_of(model: &dyn ForwardModel, intensity: &[f32]) -> (Vec<ViewStack>, Vec<ViewId>) {
        let voxels: Vec<u32> = (0..model.grid().len() as u32).collect();
        let projector = model.projector(&voxels);
        let mut order = Vec::new();
        let stacks = model.layouts().iter().enumerate().map(|(camera, layout)| {
            let mut values = vec![0.0; layout.window.len() * layout.views.len()];
            for (view, image) in values.chunks_mut(layout.window.len()).enumerate() {
                order.push(ViewId { camera, view });
                projector.project(ViewId { camera, view }, intensity, image);
            }
            ViewStack::new(layout.window.len(), values)
        });
        (stacks.collect(), order)
    }

    #[test]
    fn the_residual_is_the_share_of_the_light_not_explained() {
        let model =
            thin_lens_model(&test_bench::optics(), &test_bench::poses(), &grid(), 0.1).unwrap();
        let truth: Vec<f32> = (0..12u8).map(f32::from).collect();
        let (views, order) = views_of(model.as_ref(), &truth);
        let projector = model.projector(&(0..12).collect::<Vec<_>>());
        let residual = |scale: f32| {
            let scaled: Vec<f32> = truth.iter().map(|e| e * scale).collect();
            relative_residual(projector.as_ref(), &views, &order, &scaled)
        };
        for (scale, expected) in [(0.0, 1.0), (0.25, 0.75), (1.0, 0.0), (3.0, 2.0)] {
            assert!((residual(scale) - expected).abs() < 1e-6, "{scale}: {}", residual(scale));
        }
        let (dark, _) = views_of(model.as_ref(), &[0.0; 12]);
        let against_dark = |e: &[f32]| relative_residual(projector.as_ref(), &dark, &order, e);
        assert_eq!((against_dark(&[0.0; 12]), against_dark(&truth)), (0.0, 1.0));
    }

    #[test]
    fn the_log_compares_with_the_truth_where_it_is_known() {
        let truth = DenseVolume { grid: grid(), intensity: vec![1.0; 12] };
        let half = SparseVolume { grid: grid(), voxels: (0..6).collect(), intensity: vec![1.0; 6] };
        let report = PassReport { pass: 1, residual: 0.5, active_voxels: 6, seconds: 0.25 };
        let mut log = ConvergenceLog::with_truth(truth);
        log.record(&report, &half);
        log.record(
            &report,
            &SparseVolume { voxels: (0..12).collect(), intensity: vec![1.0; 12], ..half.clone() },
        );
        let first = log.passes[0];
        assert!((first.quality.unwrap() - 0.5f64.sqrt()).abs() < 1e-12);
        assert!((first.error.unwrap() - 6f64.sqrt()).abs() < 1e-12);
        assert_eq!(log.first_to_reach(0.9), log.last());
        assert_eq!(log.seconds(), 0.5);
        let mut blind = ConvergenceLog::new();
        blind.record(&report, &half);
        assert_eq!((blind.passes[0].quality, blind.first_to_reach(0.0)), (None, None));
    }
}
