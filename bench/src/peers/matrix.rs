//! The weight matrix as compressed rows.

use std::path::Path;

use lfpiv_core::model::{ExplicitModel, ForwardModel, ViewId};
use serde::{Deserialize, Serialize};

use super::{NpyWriter, PeersError, row::timed, write_array};

/// Shape of an exported matrix, and what it took.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MatrixSize {
    /// Views, in the order of the rows.
    pub views: usize,
    /// Rows that every view takes: the largest number of pixels of a view. Further rows of smaller
    /// views are empty, because a peer's geometry has projections of equal size.
    pub rows_per_view: usize,
    /// Columns: the voxels of the grid in z, y, x order.
    pub columns: usize,
    /// Weights above 0.
    pub entries: usize,
    /// Seconds to make the weights and to sort them into rows, without writing them.
    pub assembly_seconds: f64,
}

/// Writes the weights of these views as CSR: `matrix_data.npy` (f32), `matrix_indices.npy` (u32)
/// and `matrix_indptr.npy` (u64). Memory holds one view at a time.
pub fn write_matrix(
    model: &ExplicitModel,
    views: &[ViewId],
    folder: &Path,
) -> Result<MatrixSize, PeersError> {
    let mut data = NpyWriter::create(&folder.join("matrix_data.npy"))?;
    let mut indices = NpyWriter::create(&folder.join("matrix_indices.npy"))?;
    let rows_per_view = model.layouts().iter().map(|layout| layout.window.len()).max().unwrap_or(0);
    let mut ends = vec![0u64];
    let (mut entries, mut assembly_seconds) = (0, 0.0);
    for &view in views {
        let (rows, seconds) = timed(|| model.load(&[view]).matrix().to_csr());
        assembly_seconds += seconds;
        indices.append(rows.indices())?;
        data.append(rows.data())?;
        let starts = rows.indptr();
        ends.extend(starts.raw_storage()[1..].iter().map(|&end| (entries + end) as u64));
        entries += rows.nnz();
        ends.resize(ends.len() + rows_per_view - rows.rows(), entries as u64);
    }
    indices.finish()?;
    data.finish()?;
    write_array(&folder.join("matrix_indptr.npy"), &[ends.len()], &ends)?;
    let columns = model.grid().len();
    Ok(MatrixSize { views: views.len(), rows_per_view, columns, entries, assembly_seconds })
}
