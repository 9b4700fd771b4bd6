//! One pass over ordered subsets of views, on active voxels only: what every iterative solver shares.
//!
//! Each subset projects the light, compares it with what was measured, spreads back what every pixel
//! asks for and lets each voxel answer. What is asked and answered is the solver's [`Update`].

use rayon::prelude::*;

use super::BlockVolume;
use crate::{
    lightfield::ViewStack,
    model::{BlockLight, BlockModel, BlockProjector, ViewId, retain},
};

/// How a solver corrects the light.
pub trait Update: Sync {
    /// Whether the sums Σ_m w_im over active voxels and Σ_i w_ji over the subset's pixels are needed.
    const NEEDS_SUMS: bool;

    /// What a pixel of `camera` asks of the voxels that it sees; 0 for nothing. `row_sum` is
    /// Σ_m w_im over the active voxels, 0 unless [`Self::NEEDS_SUMS`].
    fn ask(&self, camera: usize, measured: f32, projected: f32, row_sum: f32) -> f32;

    /// The new light of a voxel, not negative. `asked` is Σ_i w_ji ask_i over the pixels of the
    /// subset's `views`; `column_sum` is Σ_i w_ji, 0 unless [`Self::NEEDS_SUMS`].
    fn answer(&self, light: f32, asked: f32, column_sum: f32, views: usize) -> f32;
}

/// When dim voxels are given up.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clearance {
    /// Voxels with no more light than this are given up, in counts.
    pub prune_below: f32,
    /// The light is at first spread over more voxels than hold any, and true ones are still dim:
    /// the threshold rises from 0 over so many passes.
    pub rising_passes: usize,
    /// Passes made before this one.
    pub passes_done: usize,
}

impl Clearance {
    /// The threshold after a share of this pass.
    fn threshold(&self, share: f32) -> f32 {
        let risen = (self.passes_done as f32 + share) / self.rising_passes.max(1) as f32;
        self.prune_below * risen.min(1.0)
    }
}

/// Subsets between two clearances of dim voxels.
const SUBSETS_PER_CLEARANCE: usize = 4;

/// Blocks that one task updates.
const BLOCKS_PER_TASK: usize = 8192;

/// One view, measured against projected.
struct Compared {
    /// What each pixel asks for, prepared to be spread back.
    asked: Vec<f32>,
    /// 1 in each pixel, prepared to be spread back; empty where no sums are needed.
    ones: Vec<f32>,
    /// Σ (I − p)².
    missed: f64,
    /// Σ I².
    seen: f64,
}

/// A model and the views that it is to explain.
pub struct Problem<'a> {
    /// What a voxel does to a pixel.
    pub model: &'a dyn BlockModel,
    /// One stack per camera, in counts above the black level.
    pub views: &'a [ViewStack],
}

impl Problem<'_> {
    /// One pass over `subsets`; returns the relative residual ‖I − p‖ / ‖I‖ that the pass met, each
    /// view's before its own correction. Neither it nor the volume depends on the number of threads.
    pub fn pass<U: Update>(
        &self,
        update: &U,
        subsets: &[Vec<ViewId>],
        clearance: Clearance,
        volume: &mut BlockVolume,
        projector: &mut dyn BlockProjector,
    ) -> f64 {
        let (mut missed, mut seen) = (0.0, 0.0);
        let all: usize = subsets.iter().map(Vec::len).sum();
        let mut active = active_voxels::<U>(volume);
        for (n, subset) in subsets.iter().enumerate() {
            let compared = self.compare(update, subset, volume, &active, projector);
            missed += compared.iter().map(|view| view.missed).sum::<f64>();
            seen += compared.iter().map(|view| view.seen).sum::<f64>();
            correct(update, subset, &compared, volume, projector);
            if (n + 1).is_multiple_of(SUBSETS_PER_CLEARANCE) {
                let done = ((n + 1) * subset.len()) as f32 / all as f32;
                clear_dim_voxels(clearance.threshold(done.min(1.0)), volume, projector);
                active = active_voxels::<U>(volume);
            }
        }
        clear_dim_voxels(clearance.threshold(1.0), volume, projector);
        if seen > 0.0 { (missed / seen).sqrt() } else { 0.0 }
    }

    /// Measured against projected light in every view of the subset.
    fn compare<U: Update>(
        &self,
        update: &U,
        subset: &[ViewId],
        volume: &BlockVolume,
        active: &[BlockLight],
        projector: &dyn BlockProjector,
    ) -> Vec<Compared> {
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
            let (mut missed, mut seen) = (0.0f64, 0.0f64);
            for (n, (pixel, &measured)) in image.iter_mut().zip(pixels).enumerate() {
                missed += f64::from(measured - *pixel).powi(2);
                seen += f64::from(measured).powi(2);
                let row_sum = if U::NEEDS_SUMS { rows[n] } else { 0.0 };
                *pixel = update.ask(id.camera, measured, *pixel, row_sum);
            }
            image[pixels.len()..].fill(0.0);
            projector.prepare(id, &mut image);
            Compared { asked: image, ones, missed, seen }
        };
        subset.par_iter().map(compare).collect()
    }
}

/// Spreads back what the pixels ask for and lets the active voxels answer.
fn correct<U: Update>(
    update: &U,
    subset: &[ViewId],
    compared: &[Compared],
    volume: &mut BlockVolume,
    projector: &dyn BlockProjector,
) {
    volume.light.par_chunks_mut(BLOCKS_PER_TASK).enumerate().for_each(|(task, chunk)| {
        let start = task * BLOCKS_PER_TASK;
        let range = || start..start + chunk.len();
        let mut asked: Vec<BlockLight> = vec![[0.0; 8]; chunk.len()];
        let sums = if U::NEEDS_SUMS { chunk.len() } else { 0 };
        let mut columns: Vec<BlockLight> = vec![[0.0; 8]; sums];
        for (&id, view) in subset.iter().zip(compared) {
            projector.back_project(id, &view.asked, range(), &mut asked);
            if U::NEEDS_SUMS {
                projector.back_project(id, &view.ones, range(), &mut columns);
            }
        }
        let (asked, columns) = (asked.as_flattened(), columns.as_flattened());
        for (n, (light, &asked)) in chunk.as_flattened_mut().iter_mut().zip(asked).enumerate() {
            let column_sum = if U::NEEDS_SUMS { columns[n] } else { 0.0 };
            // A voxel that was given up has no light, and none beyond the grid's end has any.
            if !U::NEEDS_SUMS || *light > 0.0 {
                *light = update.answer(*light, asked, column_sum, subset.len());
            }
        }
    });
}

/// 1 in each active voxel; nothing where no sums are needed.
fn active_voxels<U: Update>(volume: &BlockVolume) -> Vec<BlockLight> {
    if !U::NEEDS_SUMS {
        return Vec::new();
    }
    let active = |block: &BlockLight| block.map(|light| f32::from(u8::from(light > 0.0)));
    volume.light.iter().map(active).collect()
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
