//! One pass over ordered subsets of views, on active voxels only; shared by all iterative solvers.
//!
//! Each subset projects the light, compares it with the measurement, back-projects a correction per
//! pixel and updates each voxel. Correction and update are defined by the solver's [`Update`].

use rayon::prelude::*;

use super::BlockVolume;
use crate::{
    lightfield::ViewStack,
    model::{BlockLight, BlockModel, BlockProjector, ViewId, retain},
};

/// Correction and update of a solver.
pub trait Update: Sync {
    /// Whether the row sums Σ_m w_im and the column sums Σ_i w_ji are needed.
    const NEEDS_SUMS: bool;

    /// Correction of a pixel of `camera`, to be back-projected, 0 for none, from its measured and its projected
    /// light and its row sum Σ_m w_im over the active voxels, 0 unless [`Self::NEEDS_SUMS`].
    fn correction(&self, camera: usize) -> impl Fn(f32, f32, f32) -> f32;

    /// The new light of a voxel, not negative. `back_projected` is Σ_i w_ji c_i with the
    /// corrections c_i of the pixels of the subset's `views`; `column_sum` is Σ_i w_ji, 0 unless
    /// [`Self::NEEDS_SUMS`].
    fn update(&self, light: f32, back_projected: f32, column_sum: f32, views: usize) -> f32;
}

/// Pruning of dim voxels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pruning {
    /// Voxels with at most this light are pruned, in counts.
    pub prune_below: f32,
    /// Number of passes over which the threshold rises from 0. In the first passes the light is distributed
    /// over too many voxels, so that those with particles are still dim.
    pub rising_passes: usize,
    /// Passes completed before this one.
    pub passes_done: usize,
}

impl Pruning {
    /// The threshold after a share of this pass.
    fn threshold(&self, share: f32) -> f32 {
        let risen = (self.passes_done as f32 + share) / self.rising_passes.max(1) as f32;
        self.prune_below * risen.min(1.0)
    }
}

/// Subsets between two prunings.
const SUBSETS_PER_PRUNING: usize = 4;

/// Blocks per parallel task.
const BLOCKS_PER_TASK: usize = 8192;

/// Comparison of one view.
struct ViewComparison {
    /// Correction per pixel, prepared for back-projection.
    corrections: Vec<f32>,
    /// 1 per pixel, prepared for back-projection; empty if no sums are needed.
    ones: Vec<f32>,
    /// Σ (I − p)².
    residual_square: f64,
    /// Σ I².
    light_square: f64,
}

/// A model and the measured views.
pub struct InverseProblem<'a> {
    /// The forward model.
    pub model: &'a dyn BlockModel,
    /// One stack per camera, in counts above the black level.
    pub views: &'a [ViewStack],
}

impl InverseProblem<'_> {
    /// One pass over `subsets`; returns the relative residual ‖I − p‖ / ‖I‖ of the pass, each view
    /// measured before its own correction. Volume and residual are independent of the number of
    /// threads.
    pub fn pass<U: Update>(
        &self,
        update: &U,
        subsets: &[Vec<ViewId>],
        pruning: Pruning,
        volume: &mut BlockVolume,
        projector: &mut dyn BlockProjector,
    ) -> f64 {
        let (mut residual_square, mut light_square) = (0.0, 0.0);
        let all: usize = subsets.iter().map(Vec::len).sum();
        let mut active = active_voxels::<U>(volume);
        for (n, subset) in subsets.iter().enumerate() {
            let compared = self.compare(update, subset, volume, &active, projector);
            residual_square += compared.iter().map(|view| view.residual_square).sum::<f64>();
            light_square += compared.iter().map(|view| view.light_square).sum::<f64>();
            correct(update, subset, &compared, volume, projector);
            if (n + 1).is_multiple_of(SUBSETS_PER_PRUNING) {
                let done = ((n + 1) * subset.len()) as f32 / all as f32;
                prune(pruning.threshold(done.min(1.0)), volume, projector);
                active = active_voxels::<U>(volume);
            }
        }
        prune(pruning.threshold(1.0), volume, projector);
        if light_square > 0.0 { (residual_square / light_square).sqrt() } else { 0.0 }
    }

    /// Compares measured and projected light in every view of the subset.
    fn compare<U: Update>(
        &self,
        update: &U,
        subset: &[ViewId],
        volume: &BlockVolume,
        active: &[BlockLight],
        projector: &dyn BlockProjector,
    ) -> Vec<ViewComparison> {
        let compare = |&id: &ViewId| {
            let len = self.model.image_len(id.camera);
            let pixels = self.views[id.camera].view(id.view);
            let (mut image, mut rows, mut ones) = (vec![0.0; len], Vec::new(), Vec::new());
            projector.project(id, &volume.light, &mut image);
            if U::NEEDS_SUMS {
                rows.resize(len, 0.0);
                projector.project(id, active, &mut rows);
                ones.resize(len, 0.0);
                ones[..pixels.len()].fill(1.0);
                projector.prepare(id, &mut ones);
            }
            let [residual_square, light_square] = sums_of_squares(pixels, &image);
            let correction = update.correction(id.camera);
            for (n, (pixel, &measured)) in image.iter_mut().zip(pixels).enumerate() {
                let row_sum = if U::NEEDS_SUMS { rows[n] } else { 0.0 };
                *pixel = correction(measured, *pixel, row_sum);
            }
            image[pixels.len()..].fill(0.0);
            projector.prepare(id, &mut image);
            ViewComparison { corrections: image, ones, residual_square, light_square }
        };
        subset.par_iter().map(compare).collect()
    }
}

/// Σ (I_i − p_i)² and Σ I_i² of measured and projected light, in independent partial sums for vectorisation.
fn sums_of_squares(measured: &[f32], projected: &[f32]) -> [f64; 2] {
    const LANES: usize = 8;
    let mut sums = [[0.0f64; LANES]; 2];
    let (whole, rest) = measured.as_chunks::<LANES>();
    let (whole_projected, rest_projected) = projected[..measured.len()].as_chunks::<LANES>();
    for (measured, projected) in whole.iter().zip(whole_projected) {
        for l in 0..LANES {
            sums[0][l] += f64::from(measured[l] - projected[l]).powi(2);
            sums[1][l] += f64::from(measured[l]).powi(2);
        }
    }
    for (l, (&measured, &projected)) in rest.iter().zip(rest_projected).enumerate() {
        sums[0][l] += f64::from(measured - projected).powi(2);
        sums[1][l] += f64::from(measured).powi(2);
    }
    sums.map(|lanes| lanes.iter().sum())
}

/// Back-projects the corrections and updates the active voxels.
fn correct<U: Update>(
    update: &U,
    subset: &[ViewId],
    compared: &[ViewComparison],
    volume: &mut BlockVolume,
    projector: &dyn BlockProjector,
) {
    volume.light.par_chunks_mut(BLOCKS_PER_TASK).enumerate().for_each(|(task, chunk)| {
        let start = task * BLOCKS_PER_TASK;
        let range = || start..start + chunk.len();
        let mut back_projected: Vec<BlockLight> = vec![[0.0; 8]; chunk.len()];
        let sums = if U::NEEDS_SUMS { chunk.len() } else { 0 };
        let mut columns: Vec<BlockLight> = vec![[0.0; 8]; sums];
        for (&id, view) in subset.iter().zip(compared) {
            projector.back_project(id, &view.corrections, range(), &mut back_projected);
            if U::NEEDS_SUMS {
                projector.back_project(id, &view.ones, range(), &mut columns);
            }
        }
        let (back_projected, columns) = (back_projected.as_flattened(), columns.as_flattened());
        for (n, (light, &back_projected)) in
            chunk.as_flattened_mut().iter_mut().zip(back_projected).enumerate()
        {
            let column_sum = if U::NEEDS_SUMS { columns[n] } else { 0.0 };
            // Pruned voxels and those outside the grid have no light.
            if !U::NEEDS_SUMS || *light > 0.0 {
                *light = update.update(*light, back_projected, column_sum, subset.len());
            }
        }
    });
}

/// 1 in each active voxel; empty if no sums are needed.
fn active_voxels<U: Update>(volume: &BlockVolume) -> Vec<BlockLight> {
    if !U::NEEDS_SUMS {
        return Vec::new();
    }
    let active = |block: &BlockLight| block.map(|light| f32::from(u8::from(light > 0.0)));
    volume.light.iter().map(active).collect()
}

/// Sets voxels up to `threshold` to zero and removes blocks without light.
fn prune(threshold: f32, volume: &mut BlockVolume, projector: &mut dyn BlockProjector) {
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

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;

    #[test]
    fn sums_in_lanes_are_those_one_by_one() {
        let mut random = Pcg64Mcg::seed_from_u64(7);
        for count in [0, 3, 8, 29] {
            let mut light =
                || -> Vec<f32> { (0..count).map(|_| random.random_range(-1.0..9.0)).collect() };
            let (measured, mut projected) = (light(), light());
            let square = |of: &dyn Fn(usize) -> f32| -> f64 {
                (0..count).map(|n| f64::from(of(n)).powi(2)).sum()
            };
            let expected = [square(&|n| measured[n] - projected[n]), square(&|n| measured[n])];
            // A projected image may be longer than its view.
            projected.push(1.0);
            for (found, expected) in sums_of_squares(&measured, &projected).iter().zip(expected) {
                assert!((found - expected).abs() <= 1e-12 * expected);
            }
        }
    }
}
