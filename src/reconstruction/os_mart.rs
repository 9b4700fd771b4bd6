//! Multiplicative updates over ordered subsets of views, on active voxels only.
//!
//! Every voxel's intensity is multiplied by the mean ratio of measured to projected light over the
//! pixels it reaches in one subset of views:
//!
//! E_j ← E_j (1 + μ/S Σ_v Σ_i w_ji ((I_i + β)/(p_i + β) − 1)),  p_i = Σ_m w_mi E_m
//!
//! with S views in the subset. The arithmetic mean of ratios (as in ordered-subset expectation
//! maximisation, Hudson and Larkin 1994) stands where MART has a product: in a product a single
//! dark pixel vetoes a voxel, and a particle that fills its voxel only partly has such pixels in
//! many views. β is the noise of a dark pixel: where both lights are within the noise their ratio
//! means nothing and tends to 1.

use rayon::prelude::*;

use super::{SparseVolume, hull::retain};
use crate::{
    lightfield::ViewStack,
    model::{ForwardModel, Projector, ViewId},
};

/// One pass's parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct OsMart {
    /// Relaxation factor μ, at most 1 so that intensities stay positive.
    pub relaxation: f32,
    /// Views per subset, S.
    pub views_per_subset: usize,
    /// β of each camera, in counts.
    pub noise_counts: Vec<f32>,
    /// Voxels with less light than this are given up, in counts.
    pub prune_below: f32,
}

/// Subsets between two clearances of dim voxels.
const SUBSETS_PER_CLEARANCE: usize = 8;

/// Voxels that one task updates.
const VOXELS_PER_TASK: usize = 4096;

/// One view, measured against projected.
struct Compared {
    /// (I + β)/(p + β) − 1 per pixel.
    excess: Vec<f32>,
    /// Σ (I − p)².
    missed: f64,
    /// Σ I².
    seen: f64,
}

impl OsMart {
    /// One pass over all views in `order`; returns the relative residual ‖I − p‖ / ‖I‖ that the
    /// pass met, each view's before its own update. Neither depends on the number of threads.
    pub fn pass(
        &self,
        model: &dyn ForwardModel,
        views: &[ViewStack],
        order: &[ViewId],
        volume: &mut SparseVolume,
        projector: &mut dyn Projector,
    ) -> f64 {
        let (mut missed, mut seen) = (0.0, 0.0);
        for (n, subset) in order.chunks(self.views_per_subset.max(1)).enumerate() {
            let compared = self.compare(model, views, subset, volume, projector);
            missed += compared.iter().map(|view| view.missed).sum::<f64>();
            seen += compared.iter().map(|view| view.seen).sum::<f64>();
            self.update(subset, &compared, volume, projector);
            if (n + 1).is_multiple_of(SUBSETS_PER_CLEARANCE) {
                self.clear_dim_voxels(volume, projector);
            }
        }
        self.clear_dim_voxels(volume, projector);
        if seen > 0.0 { (missed / seen).sqrt() } else { 0.0 }
    }

    /// Measured against projected light in every view of the subset.
    fn compare(
        &self,
        model: &dyn ForwardModel,
        views: &[ViewStack],
        subset: &[ViewId],
        volume: &SparseVolume,
        projector: &dyn Projector,
    ) -> Vec<Compared> {
        subset
            .par_iter()
            .map(|&id| {
                let mut image = vec![0.0; model.layouts()[id.camera].window.len()];
                projector.project(id, &volume.intensity, &mut image);
                let noise = self.noise_counts[id.camera];
                let (mut missed, mut seen) = (0.0f64, 0.0f64);
                for (pixel, &measured) in image.iter_mut().zip(views[id.camera].view(id.view)) {
                    missed += f64::from(measured - *pixel).powi(2);
                    seen += f64::from(measured).powi(2);
                    *pixel = (measured.max(0.0) + noise) / (*pixel + noise) - 1.0;
                }
                Compared { excess: image, missed, seen }
            })
            .collect()
    }

    fn update(
        &self,
        subset: &[ViewId],
        compared: &[Compared],
        volume: &mut SparseVolume,
        projector: &dyn Projector,
    ) {
        let step = self.relaxation / subset.len() as f32;
        volume.intensity.par_chunks_mut(VOXELS_PER_TASK).enumerate().for_each(|(task, chunk)| {
            let start = task * VOXELS_PER_TASK;
            let mut sum = vec![0.0; chunk.len()];
            for (&id, view) in subset.iter().zip(compared) {
                projector.back_project(id, &view.excess, start..start + chunk.len(), &mut sum);
            }
            for (intensity, sum) in chunk.iter_mut().zip(sum) {
                *intensity *= (1.0 + step * sum).max(0.0);
            }
        });
    }

    fn clear_dim_voxels(&self, volume: &mut SparseVolume, projector: &mut dyn Projector) {
        let keep: Vec<bool> = volume.intensity.iter().map(|&e| e > self.prune_below).collect();
        if keep.iter().any(|&keep| !keep) {
            projector.retain(&keep);
            retain(&mut volume.voxels, &keep);
            retain(&mut volume.intensity, &keep);
        }
    }
}
