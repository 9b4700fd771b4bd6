//! The inner loops of correlation: compiled for several instruction sets, chosen at run time.
//!
//! Only sums along independent lanes are vectorised and none is contracted, so every machine gives
//! the same bits.

use multiversion::multiversion;

use super::{lags::Lags, windows::LANES};

/// For every lag s along x: `columns[s][x] = Σ_{y,z < edge} a(x + r − ⌊s/2⌋) b(x + r + ⌈s/2⌉)`, r the
/// border of the lags; `strides` along y and z.
pub fn product_columns(
    lags: Lags,
    frames: [&[f32]; 2],
    strides: [usize; 2],
    edge: usize,
    columns: &mut [f32],
) {
    let columns_of = match lags.reach {
        1 => columns_of::<3>,
        2 => columns_of::<5>,
        3 => columns_of::<7>,
        4 => columns_of::<9>,
        5 => columns_of::<11>,
        _ => columns_of::<13>,
    };
    columns_of(frames, strides, edge, columns);
}

/// [`product_columns`] for `N` lags: a constant number of them stays in registers, and lags that are
/// neighbours share the cells they read.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn columns_of<const N: usize>(
    frames: [&[f32]; 2],
    strides: [usize; 2],
    edge: usize,
    columns: &mut [f32],
) {
    let [a, b] = frames;
    let width = columns.len() / N;
    let reach = N / 2;
    let border = reach.div_ceil(2);
    for tile in (0..width).step_by(LANES) {
        let mut sums = [[0.0f32; LANES]; N];
        for z in 0..edge {
            for y in 0..edge {
                let start = tile + y * strides[0] + z * strides[1];
                let row = start..start + LANES + 2 * border;
                let (a, b) = (&a[row.clone()], &b[row]);
                for (lag, sum) in sums.iter_mut().enumerate() {
                    // ⌊s/2⌋ and ⌈s/2⌉ of s = lag − reach, both larger by the border.
                    let raised = lag + 2 * border - reach;
                    let (low, high) = (raised / 2, raised.div_ceil(2));
                    let (a, b) = (&a[2 * border - low..][..LANES], &b[high..][..LANES]);
                    for ((sum, a), b) in sum.iter_mut().zip(a).zip(b) {
                        *sum += a * b;
                    }
                }
            }
        }
        for (columns, sum) in columns.chunks_exact_mut(width).zip(&sums) {
            columns[tile..tile + LANES].copy_from_slice(sum);
        }
    }
}

/// Sums over `edge` columns from every multiple of `step`.
pub fn window_sums(columns: &[f32], edge: usize, step: usize, sums: &mut [f32]) {
    for (n, sum) in sums.iter_mut().enumerate() {
        let window = &columns[n * step..n * step + edge];
        let mut lanes = [0.0f32; 8];
        let (groups, rest) = window.as_chunks::<8>();
        for group in groups {
            for (lane, value) in lanes.iter_mut().zip(group) {
                *lane += value;
            }
        }
        *sum = lanes.iter().sum::<f32>() + rest.iter().sum::<f32>();
    }
}

/// Sums over the cube of `edge` cells that starts at each cell; of no use where the cube would leave
/// the image.
///
/// Along an axis, the sum over 2n cells is that of two sums over n, and over 2n + 1 one cell more:
/// a few additions per cell instead of `edge`.
pub fn box_sums(image: &[f32], cells: [usize; 3], edge: usize) -> Vec<f32> {
    let mut sums = image.to_vec();
    let mut longer = image.to_vec();
    for stride in [1, cells[0], cells[0] * cells[1]] {
        let single = if edge.is_power_of_two() { Vec::new() } else { sums.clone() };
        let mut length = 1;
        for digit in (0..edge.ilog2()).rev() {
            add_ahead(&sums, &sums, length * stride, &mut longer);
            std::mem::swap(&mut sums, &mut longer);
            length *= 2;
            if edge >> digit & 1 == 1 {
                add_ahead(&sums, &single, length * stride, &mut longer);
                std::mem::swap(&mut sums, &mut longer);
                length += 1;
            }
        }
    }
    sums
}

/// `to[n] = a[n] + b[n + ahead]`, where there is one.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn add_ahead(a: &[f32], b: &[f32], ahead: usize, to: &mut [f32]) {
    for ((to, a), b) in to.iter_mut().zip(a).zip(&b[ahead.min(b.len())..]) {
        *to = a + b;
    }
}
