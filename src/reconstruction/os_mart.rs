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

impl OsMart {
    /// One pass over all views in `order`. The result does not depend on the number of threads.
    pub fn pass(
        &self,
        model: &dyn ForwardModel,
        views: &[ViewStack],
        order: &[ViewId],
        volume: &mut SparseVolume,
        projector: &mut dyn Projector,
    ) {
        for (n, subset) in order.chunks(self.views_per_subset.max(1)).enumerate() {
            let excess = self.excess(model, views, subset, volume, projector);
            self.update(subset, &excess, volume, projector);
            if (n + 1).is_multiple_of(SUBSETS_PER_CLEARANCE) {
                self.clear_dim_voxels(volume, projector);
            }
        }
        self.clear_dim_voxels(volume, projector);
    }

    /// (I + β)/(p + β) − 1 in every pixel of every view of the subset.
    fn excess(
        &self,
        model: &dyn ForwardModel,
        views: &[ViewStack],
        subset: &[ViewId],
        volume: &SparseVolume,
        projector: &dyn Projector,
    ) -> Vec<Vec<f32>> {
        subset
            .par_iter()
            .map(|&id| {
                let mut image = vec![0.0; model.layouts()[id.camera].window.len()];
                projector.project(id, &volume.intensity, &mut image);
                let noise = self.noise_counts[id.camera];
                for (pixel, &measured) in image.iter_mut().zip(views[id.camera].view(id.view)) {
                    *pixel = (measured.max(0.0) + noise) / (*pixel + noise) - 1.0;
                }
                image
            })
            .collect()
    }

    fn update(
        &self,
        subset: &[ViewId],
        excess: &[Vec<f32>],
        volume: &mut SparseVolume,
        projector: &dyn Projector,
    ) {
        let step = self.relaxation / subset.len() as f32;
        volume.intensity.par_chunks_mut(VOXELS_PER_TASK).enumerate().for_each(|(task, chunk)| {
            let start = task * VOXELS_PER_TASK;
            let mut sum = vec![0.0; chunk.len()];
            for (&id, excess) in subset.iter().zip(excess) {
                projector.back_project(id, excess, start..start + chunk.len(), &mut sum);
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
