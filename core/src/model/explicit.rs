//! The explicit sparse weight matrix, one ordered subset at a time.
//!
//! This is the method of the paper (Zhu et al. 2023, figure 6): the matrix of one subset of views is loaded,
//! used and dropped before the next, so that memory contains one subset's entries instead of the whole matrix.
//! It is the reference for the tables. In contrast to them, it is limited by memory.
//!
//! Rows are pixels (views in the order of the subset, each row-major over its microlens window), columns are
//! voxels. Storage is CSC for three reasons. Weights are computed voxel by voxel, so that columns can be
//! appended; CSR would need a second copy for the transposition. Back-projection, `brightest` and `retain`
//! access the pixels of a voxel, which are contiguous. A subset has far fewer pixels than the volume has
//! voxels, so that the partial sums of forward projection are images, not volumes. sprs parallelises only
//! products of sparse matrices; products with dense vectors are computed here with rayon, in an order that does
//! not depend on the number of threads.

use rayon::prelude::*;
use sprs::CsMatI;

use super::{
    ForwardModel, Projector, ViewId, VolumeGrid,
    explicit_projector::ExplicitProjector,
    sparse_columns::{Columns, add_column, assemble, bytes, column_sum},
    weights::WeightSource,
};
use crate::lightfield::ViewLayout;

/// Number of partial images of forward projection. It is fixed, so that rounding does not depend on the threads.
const PARTS: usize = 16;

/// Source of the weight matrix, from which subsets are loaded.
///
/// As a [`ForwardModel`] its projectors store the entries of all views for their active voxels. It is therefore
/// suitable for small volumes, with any solver.
pub struct ExplicitModel {
    source: Box<dyn WeightSource>,
}

impl ExplicitModel {
    /// A matrix of these weights.
    pub fn new(source: impl WeightSource + 'static) -> Self {
        Self { source: Box::new(source) }
    }

    /// Every view of every camera, camera by camera.
    pub fn views(&self) -> Vec<ViewId> {
        let of_camera = |(camera, layout): (usize, &ViewLayout)| {
            (0..layout.views.len()).map(move |view| ViewId { camera, view }).collect::<Vec<_>>()
        };
        self.layouts().iter().enumerate().flat_map(of_camera).collect()
    }

    /// Builds the matrix of a subset of views, for all voxels of the grid.
    ///
    /// Panics if a view does not exist or the subset has 2^32 pixels or more.
    pub fn load(&self, subset: &[ViewId]) -> SubsetMatrix {
        let (firsts, rows) = self.first_rows(subset);
        let matrix = assemble(rows, self.grid().len(), |voxel, indices, data| {
            let mut weights = Vec::new();
            for (&view, &first) in subset.iter().zip(&firsts) {
                weights.clear();
                self.source.weights(view, voxel as u32, &mut weights);
                for w in weights.iter().filter(|w| w.weight > 0.0) {
                    indices.push(first + w.pixel);
                    data.push(w.weight);
                }
            }
        });
        SubsetMatrix { matrix }
    }

    /// Bytes of the matrix that [`Self::load`] returns for these views, without storing it. For
    /// [`Self::views`], the bytes of the full matrix.
    pub fn matrix_bytes(&self, views: &[ViewId]) -> usize {
        let voxels = self.grid().len();
        let entries: usize = (0..voxels as u32)
            .into_par_iter()
            .map_init(Vec::new, |weights, voxel| {
                weights.clear();
                for &view in views {
                    self.source.weights(view, voxel, weights);
                }
                weights.iter().filter(|w| w.weight > 0.0).count()
            })
            .sum();
        bytes::<f32>(entries, voxels)
    }

    /// The first row of each view of a subset, and the number of rows.
    fn first_rows(&self, subset: &[ViewId]) -> (Vec<u32>, usize) {
        let mut rows = 0;
        let first = |view: &ViewId| {
            let first = rows;
            rows += self.layouts()[view.camera].window.len();
            first as u32
        };
        let firsts = subset.iter().map(first).collect();
        assert!(u32::try_from(rows).is_ok(), "{rows} pixels in one subset of views");
        (firsts, rows)
    }
}

impl ForwardModel for ExplicitModel {
    fn grid(&self) -> &VolumeGrid {
        self.source.grid()
    }

    fn layouts(&self) -> &[ViewLayout] {
        self.source.layouts()
    }

    fn projector(&self, voxels: &[u32]) -> Box<dyn Projector + '_> {
        Box::new(ExplicitProjector::new(self.source.as_ref(), voxels))
    }

    /// Bytes of the source, without matrices.
    fn memory_bytes(&self) -> usize {
        self.source.memory_bytes()
    }
}

/// The weight matrix of one subset of views.
#[derive(Debug)]
pub struct SubsetMatrix {
    matrix: Columns<f32>,
}

impl SubsetMatrix {
    /// The matrix itself: rows are pixels, columns voxels; CSC.
    pub fn matrix(&self) -> &CsMatI<f32, u32, usize> {
        &self.matrix
    }

    /// Bytes held.
    pub fn memory_bytes(&self) -> usize {
        bytes::<f32>(self.matrix.nnz(), self.matrix.cols())
    }

    /// `images = A volume`. `volume` has one value per voxel of the grid in z, y, x order, `images` those of
    /// the subset's views in sequence. Overwrites `images`.
    ///
    /// Panics if a length is wrong.
    pub fn project(&self, volume: &[f32], images: &mut [f32]) {
        assert_eq!((images.len(), volume.len()), self.matrix.shape());
        let per_part = volume.len().div_ceil(PARTS).max(1);
        let parts: Vec<Vec<f32>> = volume
            .par_chunks(per_part)
            .enumerate()
            .map(|(part, intensities)| {
                let mut image = vec![0.0; images.len()];
                for (n, &intensity) in intensities.iter().enumerate() {
                    add_column(&self.matrix, part * per_part + n, intensity, &mut image);
                }
                image
            })
            .collect();
        images.par_iter_mut().enumerate().for_each(|(pixel, sum)| {
            *sum = parts.iter().map(|part| part[pixel]).sum();
        });
    }

    /// `volume = Aᵀ images`. Overwrites `volume`.
    ///
    /// Panics if a length is wrong.
    pub fn back_project(&self, images: &[f32], volume: &mut [f32]) {
        assert_eq!((images.len(), volume.len()), self.matrix.shape());
        volume.par_iter_mut().enumerate().for_each(|(voxel, sum)| {
            *sum = column_sum(&self.matrix, voxel, images);
        });
    }
}

#[cfg(test)]
mod tests;
