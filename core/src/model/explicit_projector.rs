//! The explicit matrix of every view, restricted to a list of active voxels.

use std::ops::Range;

use rayon::prelude::*;

use super::{
    Projector, ViewId,
    sparse_columns::{Columns, add_column, assemble, column, column_sum},
    weights::WeightSource,
};

/// The matrices of every view for a list of active voxels.
pub struct ExplicitProjector {
    cameras: Vec<Vec<ViewMatrices>>,
}

/// Rows are the view's pixels, columns the active voxels; CSC.
struct ViewMatrices {
    weights: Columns<f32>,
    /// The support of each voxel; entries are the open shares of pupil cells, or 0 for pixels less than half open.
    support: Columns<f32>,
}

impl ExplicitProjector {
    /// The columns of these voxels in every view.
    pub fn new(source: &dyn WeightSource, voxels: &[u32]) -> Self {
        let camera = |camera: usize| {
            (0..source.layouts()[camera].views.len())
                .into_par_iter()
                .map(|view| ViewMatrices::new(source, ViewId { camera, view }, voxels))
                .collect()
        };
        Self { cameras: (0..source.layouts().len()).map(camera).collect() }
    }

    fn view(&self, id: ViewId) -> &ViewMatrices {
        &self.cameras[id.camera][id.view]
    }
}

impl ViewMatrices {
    fn new(source: &dyn WeightSource, id: ViewId, voxels: &[u32]) -> Self {
        let layout = &source.layouts()[id.camera];
        let coverage = layout.views[id.view].coverage.as_deref();
        let judged = |pixel: u32| match coverage.map_or(1.0, |c| c[pixel as usize]) {
            open if open > 0.5 => open,
            _ => 0.0,
        };
        let weights_of = |n: usize| {
            let mut weights = Vec::new();
            source.weights(id, voxels[n], &mut weights);
            weights
        };
        let pixels = layout.window.len();
        let weights = assemble(pixels, voxels.len(), |n, indices, data| {
            for w in weights_of(n).iter().filter(|w| w.weight > 0.0) {
                indices.push(w.pixel);
                data.push(w.weight);
            }
        });
        let support = assemble(pixels, voxels.len(), |n, indices, data| {
            for w in weights_of(n).iter().filter(|w| w.support) {
                indices.push(w.pixel);
                data.push(judged(w.pixel));
            }
        });
        Self { weights, support }
    }
}

impl Projector for ExplicitProjector {
    fn project(&self, view: ViewId, intensity: &[f32], image: &mut [f32]) {
        let matrix = &self.view(view).weights;
        image.fill(0.0);
        for (n, &intensity) in intensity.iter().enumerate() {
            add_column(matrix, n, intensity, image);
        }
    }

    fn back_project(&self, view: ViewId, image: &[f32], range: Range<usize>, out: &mut [f32]) {
        let matrix = &self.view(view).weights;
        for (n, out) in range.zip(out) {
            *out += column_sum(matrix, n, image);
        }
    }

    fn brightest(&self, view: ViewId, image: &[f32], range: Range<usize>, out: &mut [f32]) {
        let matrix = &self.view(view).support;
        let seen = |(&pixel, &open): (&u32, &f32)| {
            if open > 0.0 { image[pixel as usize] / open } else { f32::INFINITY }
        };
        for (n, out) in range.zip(out) {
            let (pixels, open) = column(matrix, n);
            let most = pixels.iter().zip(open).map(seen).reduce(f32::max);
            // Negative values are noise, as in the tables.
            *out = most.map_or(f32::INFINITY, |most| most.max(0.0));
        }
    }

    fn retain(&mut self, keep: &[bool]) {
        let kept: Vec<usize> =
            keep.iter().enumerate().filter_map(|(n, &keep)| keep.then_some(n)).collect();
        self.cameras.par_iter_mut().flatten().for_each(|view| {
            view.weights = select(&view.weights, &kept);
            view.support = select(&view.support, &kept);
        });
    }
}

/// The matrix with only the columns `kept`.
fn select(matrix: &Columns<f32>, kept: &[usize]) -> Columns<f32> {
    assemble(matrix.rows(), kept.len(), |n, indices, data| {
        let (pixels, values) = column(matrix, kept[n]);
        indices.extend_from_slice(pixels);
        data.extend_from_slice(values);
    })
}
