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

use super::BlockVolume;
use crate::{
    lightfield::ViewStack,
    model::{BlockLight, BlockModel, BlockProjector, ViewId, retain},
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

/// Whether the light has found its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Settled {
    /// It is spread over more voxels than hold any: true ones are still dim, so the threshold
    /// below which voxels are given up rises from 0 during the pass.
    No,
    /// A pass was made on this grid.
    Yes,
}

/// Subsets between two clearances of dim voxels.
const SUBSETS_PER_CLEARANCE: usize = 4;

/// Blocks that one task updates.
const BLOCKS_PER_TASK: usize = 8192;

/// One view, measured against projected.
struct Compared {
    /// (I + β)/(p + β) − 1 per pixel, prepared to be spread back.
    excess: Vec<f32>,
    /// Σ (I − p)².
    missed: f64,
    /// Σ I².
    seen: f64,
}

impl OsMart {
    /// One pass over the views in `order`; returns the relative residual ‖I − p‖ / ‖I‖ that the
    /// pass met, each view's before its own update. Neither depends on the number of threads.
    pub fn pass(
        &self,
        model: &dyn BlockModel,
        views: &[ViewStack],
        order: &[ViewId],
        volume: &mut BlockVolume,
        projector: &mut dyn BlockProjector,
        settled: Settled,
    ) -> f64 {
        let (mut missed, mut seen) = (0.0, 0.0);
        for (n, subset) in order.chunks(self.views_per_subset.max(1)).enumerate() {
            let compared = self.compare(model, views, subset, volume, projector);
            missed += compared.iter().map(|view| view.missed).sum::<f64>();
            seen += compared.iter().map(|view| view.seen).sum::<f64>();
            self.update(subset, &compared, volume, projector);
            if (n + 1).is_multiple_of(SUBSETS_PER_CLEARANCE) {
                let done = ((n + 1) * subset.len()) as f32 / order.len() as f32;
                let share = if settled == Settled::Yes { 1.0 } else { done.min(1.0) };
                clear_dim_voxels(self.prune_below * share, volume, projector);
            }
        }
        clear_dim_voxels(self.prune_below, volume, projector);
        if seen > 0.0 { (missed / seen).sqrt() } else { 0.0 }
    }

    /// Measured against projected light in every view of the subset.
    fn compare(
        &self,
        model: &dyn BlockModel,
        views: &[ViewStack],
        subset: &[ViewId],
        volume: &BlockVolume,
        projector: &dyn BlockProjector,
    ) -> Vec<Compared> {
        subset
            .par_iter()
            .map(|&id| {
                let mut image = vec![0.0; model.image_len(id.camera)];
                projector.project(id, &volume.light, &mut image);
                let noise = self.noise_counts[id.camera];
                let (mut missed, mut seen) = (0.0f64, 0.0f64);
                for (pixel, &measured) in image.iter_mut().zip(views[id.camera].view(id.view)) {
                    missed += f64::from(measured - *pixel).powi(2);
                    seen += f64::from(measured).powi(2);
                    *pixel = (measured.max(0.0) + noise) / (*pixel + noise) - 1.0;
                }
                projector.prepare(id, &mut image);
                Compared { excess: image, missed, seen }
            })
            .collect()
    }

    fn update(
        &self,
        subset: &[ViewId],
        compared: &[Compared],
        volume: &mut BlockVolume,
        projector: &dyn BlockProjector,
    ) {
        let step = self.relaxation / subset.len() as f32;
        volume.light.par_chunks_mut(BLOCKS_PER_TASK).enumerate().for_each(|(task, chunk)| {
            let start = task * BLOCKS_PER_TASK;
            let mut sums: Vec<BlockLight> = vec![[0.0; 8]; chunk.len()];
            for (&id, view) in subset.iter().zip(compared) {
                projector.back_project(id, &view.excess, start..start + chunk.len(), &mut sums);
            }
            let sums = sums.as_flattened();
            for (light, sum) in chunk.as_flattened_mut().iter_mut().zip(sums) {
                *light *= (1.0 + step * sum).max(0.0);
            }
        });
    }
}

/// Darkens voxels of no more light than `threshold` and gives up blocks without light.
fn clear_dim_voxels(threshold: f32, volume: &mut BlockVolume, projector: &mut dyn BlockProjector) {
    for light in volume.light.as_flattened_mut() {
        *light = if *light > threshold { *light } else { 0.0 };
    }
    let lit = |light: &BlockLight| light.iter().any(|&light| light > 0.0);
    let keep: Vec<bool> = volume.light.iter().map(lit).collect();
    if keep.iter().any(|&keep| !keep) {
        projector.retain(&keep);
        retain(&mut volume.blocks, &keep);
        retain(&mut volume.light, &keep);
    }
}
