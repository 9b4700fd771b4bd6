//! SART and OS-SART: the paper's Eq. 2 over the subsets of its Eq. 4.

use std::ops::Range;

use rayon::prelude::*;

use super::{PassReport, SparseVolume, convergence::relative_residual};
use crate::{
    Clock,
    clock::seconds_since,
    lightfield::ViewStack,
    model::{ForwardModel, Projector, ViewId},
};

/// Voxels per parallel task.
const CHUNK_VOXELS: usize = 8192;

/// Pixels and voxels with a smaller sum of weights are ignored: such sums are rounding errors at the edge of a
/// footprint, and a division by them would amplify noise.
pub(super) const MIN_SUM: f32 = 1e-6;

/// Memory limit for keeping column sums between passes. Above it they are recomputed at each use, which
/// costs as much as back-projection.
const COLUMN_SUM_BYTES: usize = 256 << 20;

/// Parameters of SART and OS-SART.
#[derive(Debug, Clone)]
pub struct SartOptions {
    /// Relaxation factor μ of Eq. 2, between 0 and 2; the paper uses 1.
    pub relaxation: f32,
    /// Passes over all subsets; the paper calls them iterations.
    pub passes: usize,
    /// The views N_β of each correction, in order: see
    /// [`balanced_subsets`](super::subsets::balanced_subsets); one subset per camera gives the
    /// conventional SART.
    pub subsets: Vec<Vec<ViewId>>,
    /// Times the passes.
    pub clock: Clock,
}

/// Reconstructs the light of `voxels` (ascending, in the grid's z, y, x order) from the views, by
/// SART or OS-SART according to the subsets.
///
/// For each subset N_β in turn, starting from a dark volume (paper, Eq. 2):
///
/// E_j ← max(0, E_j + μ · Σ_{i∈N_β} w_ji (I_i − Σ_m w_mi E_m) / Σ_m w_mi  /  Σ_{i∈N_β} w_ji)
///
/// with the row sums Σ_m over `voxels`: the whole volume for the paper's SART and OS-SART, those
/// kept by pre-recognition for PR-SART. Pixels that no voxel reaches and voxels that reach no pixel of
/// the subset are left unchanged. `views` has one stack per camera, in counts above the black
/// level. `observer` is called after each pass. The result is identical, bit for bit, for any
/// number of threads; its intensities are in the counts of [`ForwardModel`].
pub fn sart(
    model: &dyn ForwardModel,
    views: &[ViewStack],
    voxels: Vec<u32>,
    options: &SartOptions,
    observer: &mut dyn FnMut(&PassReport, &SparseVolume),
) -> SparseVolume {
    sart_within(model, views, voxels, options, COLUMN_SUM_BYTES, observer)
}

fn sart_within(
    model: &dyn ForwardModel,
    views: &[ViewStack],
    voxels: Vec<u32>,
    options: &SartOptions,
    column_sum_bytes: usize,
    observer: &mut dyn FnMut(&PassReport, &SparseVolume),
) -> SparseVolume {
    let mut started = (options.clock)();
    let solver = Sart::new(model, views, &voxels, options, column_sum_bytes);
    let order: Vec<ViewId> = options.subsets.iter().flatten().copied().collect();
    let active_voxels = voxels.len();
    let mut volume =
        SparseVolume { grid: model.grid().clone(), voxels, intensity: vec![0.0; active_voxels] };
    for pass in 1..=options.passes {
        for subset in 0..options.subsets.len() {
            solver.correct(subset, &mut volume.intensity);
        }
        let seconds = seconds_since(options.clock, started);
        let residual =
            relative_residual(solver.projector.as_ref(), views, &order, &volume.intensity);
        observer(&PassReport { pass, residual, active_voxels, seconds }, &volume);
        started = (options.clock)();
    }
    volume
}

/// Projector and the sums that are constant between passes.
struct Sart<'a> {
    projector: Box<dyn Projector + 'a>,
    views: &'a [ViewStack],
    options: &'a SartOptions,
    /// 1 / Σ_m w_mi for each pixel of each view of each subset: as much memory as the views.
    inverse_rows: Vec<Vec<Vec<f32>>>,
    /// Σ_{i∈N_β} w_ji for each voxel and subset, where memory allows.
    columns: Option<Vec<Vec<f32>>>,
}

impl<'a> Sart<'a> {
    fn new(
        model: &'a dyn ForwardModel,
        views: &'a [ViewStack],
        voxels: &[u32],
        options: &'a SartOptions,
        column_sum_bytes: usize,
    ) -> Self {
        let projector = model.projector(voxels);
        let ones = vec![1.0; voxels.len()];
        let inverse_rows = options
            .subsets
            .iter()
            .map(|subset| {
                subset
                    .par_iter()
                    .map(|&id| {
                        let mut sums = vec![0.0; views[id.camera].view(id.view).len()];
                        projector.project(id, &ones, &mut sums);
                        sums.iter_mut().for_each(|sum| *sum = inverse(*sum));
                        sums
                    })
                    .collect()
            })
            .collect();
        let mut solver = Self { projector, views, options, inverse_rows, columns: None };
        if options.subsets.len() * voxels.len() * size_of::<f32>() <= column_sum_bytes {
            let all = |subset| solver.all_column_sums(subset, voxels.len());
            solver.columns = Some((0..options.subsets.len()).map(all).collect());
        }
        solver
    }

    /// One correction by one subset: the paper's Eq. 2.
    fn correct(&self, subset: usize, intensity: &mut [f32]) {
        let corrections = self.corrections(subset, intensity);
        let voxels = intensity.par_chunks_mut(CHUNK_VOXELS).enumerate();
        voxels.for_each(|(chunk, intensity)| {
            let start = chunk * CHUNK_VOXELS;
            let range = start..start + intensity.len();
            let mut spread = vec![0.0; intensity.len()];
            for (&id, correction) in self.options.subsets[subset].iter().zip(&corrections) {
                self.projector.back_project(id, correction, range.clone(), &mut spread);
            }
            let made;
            let columns = match &self.columns {
                Some(columns) => &columns[subset][range],
                None => {
                    made = self.column_sums(subset, range);
                    &made
                }
            };
            for ((e, spread), &column) in intensity.iter_mut().zip(spread).zip(columns) {
                *e = (*e + self.options.relaxation * spread * inverse(column)).max(0.0);
            }
        });
    }

    /// (I_i − Σ_m w_mi E_m) / Σ_m w_mi for each view of a subset.
    fn corrections(&self, subset: usize, intensity: &[f32]) -> Vec<Vec<f32>> {
        let views = self.options.subsets[subset].par_iter().zip(&self.inverse_rows[subset]);
        views
            .map(|(&id, inverse_rows)| {
                let measured = self.views[id.camera].view(id.view);
                let mut image = vec![0.0; measured.len()];
                self.projector.project(id, intensity, &mut image);
                for ((pixel, &measured), &inverse_row) in
                    image.iter_mut().zip(measured).zip(inverse_rows)
                {
                    *pixel = (measured - *pixel) * inverse_row;
                }
                image
            })
            .collect()
    }

    fn all_column_sums(&self, subset: usize, voxels: usize) -> Vec<f32> {
        let chunks: Vec<Vec<f32>> = (0..voxels.div_ceil(CHUNK_VOXELS))
            .into_par_iter()
            .map(|chunk| {
                let start = chunk * CHUNK_VOXELS;
                self.column_sums(subset, start..(start + CHUNK_VOXELS).min(voxels))
            })
            .collect();
        chunks.concat()
    }

    /// Σ_{i∈N_β} w_ji of the voxels in a range.
    fn column_sums(&self, subset: usize, range: Range<usize>) -> Vec<f32> {
        let mut sums = vec![0.0; range.len()];
        for &id in &self.options.subsets[subset] {
            let ones = vec![1.0; self.views[id.camera].view(id.view).len()];
            self.projector.back_project(id, &ones, range.clone(), &mut sums);
        }
        sums
    }
}

/// 1/sum, or 0 for a negligible sum.
fn inverse(sum: f32) -> f32 {
    if sum >= MIN_SUM { 1.0 / sum } else { 0.0 }
}

#[cfg(test)]
mod tests;
