//! Sparse matrices of the explicit model: assembly and products, column by column.

use rayon::prelude::*;
use sprs::CsMatI;

/// Entries indexed by 32 bits, columns by the machine's word: 8 bytes per entry.
pub(super) type Columns<N> = CsMatI<N, u32, usize>;

/// Number of columns per parallel task.
const COLUMNS_PER_TASK: usize = 256;

/// Bytes of a matrix with this many entries and columns.
pub(super) fn bytes<N>(entries: usize, columns: usize) -> usize {
    entries * (size_of::<u32>() + size_of::<N>()) + (columns + 1) * size_of::<usize>()
}

/// The row indices and values of a column.
pub(super) fn column<N>(matrix: &Columns<N>, index: usize) -> (&[u32], &[N]) {
    let range = matrix.indptr().outer_inds_sz(index);
    (&matrix.indices()[range.clone()], &matrix.data()[range])
}

/// `image += intensity · column`.
pub(super) fn add_column(matrix: &Columns<f32>, index: usize, intensity: f32, image: &mut [f32]) {
    let (pixels, weights) = column(matrix, index);
    for (&pixel, weight) in pixels.iter().zip(weights) {
        image[pixel as usize] += weight * intensity;
    }
}

/// The scalar product of a column with an image.
pub(super) fn column_sum(matrix: &Columns<f32>, index: usize, image: &[f32]) -> f32 {
    let (pixels, weights) = column(matrix, index);
    pixels.iter().zip(weights).map(|(&pixel, weight)| weight * image[pixel as usize]).sum()
}

/// Assembles a matrix. `append(n, indices, data)` appends the entries of column `n` in ascending order of rows.
pub(super) fn assemble<N: Send>(
    rows: usize,
    columns: usize,
    append: impl Fn(usize, &mut Vec<u32>, &mut Vec<N>) + Sync,
) -> Columns<N> {
    let tasks: Vec<(Vec<usize>, Vec<u32>, Vec<N>)> = (0..columns.div_ceil(COLUMNS_PER_TASK))
        .into_par_iter()
        .map(|task| {
            let first = task * COLUMNS_PER_TASK;
            let (mut ends, mut indices, mut data) = (Vec::new(), Vec::new(), Vec::new());
            for n in first..(first + COLUMNS_PER_TASK).min(columns) {
                append(n, &mut indices, &mut data);
                ends.push(indices.len());
            }
            (ends, indices, data)
        })
        .collect();
    let entries = tasks.iter().map(|(_, indices, _)| indices.len()).sum();
    let mut starts = Vec::with_capacity(columns + 1);
    starts.push(0);
    let (mut indices, mut data) = (Vec::with_capacity(entries), Vec::with_capacity(entries));
    // The result of each task is dropped after copying, so that peak memory is near one copy.
    for (ends, more_indices, more_data) in tasks {
        let first = indices.len();
        starts.extend(ends.iter().map(|end| first + end));
        indices.extend(more_indices);
        data.extend(more_data);
    }
    CsMatI::new_csc((rows, columns), starts, indices, data)
}
