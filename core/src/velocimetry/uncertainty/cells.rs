//! What small cells of a window contribute to its correlation peak.

use multiversion::multiversion;

use super::super::raster::Image;

/// Edge of the cells into which contributions are summed, in voxels. A particle's contributions
/// belong together: with the neighbouring cells a cell spans six voxels, a rendered particle four.
const CELL: usize = 2;

/// Sums over one cell: asymmetry and symmetric part along x, y, z, and light common to both frames.
pub type Cell = [f32; 7];
/// Place of the common light in a [`Cell`].
pub const COMMON: usize = 6;

/// Voxels that are multiplied at a time.
const LANES: usize = 8;

/// Cells of one window, stored z, y, x.
pub struct Cells {
    pub counts: [usize; 3],
    pub sums: Vec<Cell>,
    /// Σ a² and Σ b².
    pub energy: [f64; 2],
    /// Pairs of voxels at no distance, and at a distance of one along each axis.
    pub pairs: [f64; 4],
}

/// Memory for one window's light that is used again for the next.
#[derive(Debug, Default)]
pub struct Cutouts {
    a: Vec<f32>,
    b: Vec<f32>,
}

/// The voxels of both frames that have a partner in the other one, less their mean, with dark voxels
/// after the last one along each axis: those add nothing to any sum.
struct Window<'a> {
    a: &'a [f32],
    b: &'a [f32],
    /// Floats from row to row and from plane to plane.
    strides: [usize; 2],
    counts: [usize; 3],
}

impl Cells {
    /// Sums for a window of edge `window` at `corner` whose correlation a(x) b(x + s) peaks near
    /// `lag`.
    pub fn of(
        [a, b]: [Image; 2],
        corner: [i64; 3],
        window: usize,
        lag: [i64; 3],
        cutouts: &mut Cutouts,
    ) -> Self {
        let in_a = a.inside(corner, window);
        let in_b = b.inside(std::array::from_fn(|c| corner[c] + lag[c]), window);
        // Voxels of frame a whose partners in frame b are inside, too.
        let both: [[i64; 2]; 3] = std::array::from_fn(|c| {
            let low = in_a[c][0].max(in_b[c][0] - lag[c]);
            [low, in_a[c][1].min(in_b[c][1] - lag[c]).max(low)]
        });
        let edges = both.map(|[low, high]| (high - low) as usize);
        let counts = edges.map(|n| n.div_ceil(CELL).max(1));
        let width = (counts[0] * CELL).next_multiple_of(LANES) + LANES;
        let strides = [width, width * (counts[1] * CELL + 1)];
        let length = strides[1] * (counts[2] * CELL + 1);
        let moved = std::array::from_fn(|c| both[c].map(|end| end + lag[c]));
        cut_out(a, both, strides, length, &mut cutouts.a);
        cut_out(b, moved, strides, length, &mut cutouts.b);
        let (mut sums, mut energy) = (vec![[0.0; 7]; counts.iter().product()], [0.0; 2]);
        let window = Window { a: &cutouts.a, b: &cutouts.b, strides, counts };
        add_products(&window, &mut sums, &mut energy);
        let pairs = |apart: usize| -> f64 {
            let along = |c: usize| edges[c].saturating_sub(usize::from(apart == c + 1));
            (0..3).map(|c| along(c) as f64).product()
        };
        Self { counts, sums, energy, pairs: std::array::from_fn(pairs) }
    }
}

/// The part `[xs, ys, zs]` of a frame, less its mean, as [`Window`] wants it.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn cut_out(
    image: Image,
    [xs, ys, zs]: [[i64; 2]; 3],
    strides: [usize; 2],
    length: usize,
    light: &mut Vec<f32>,
) {
    light.clear();
    light.resize(length, 0.0);
    let row_length = (xs[1] - xs[0]) as usize;
    let rows = (zs[0]..zs[1]).flat_map(|z| (ys[0]..ys[1]).map(move |y| [y, z]));
    let start =
        |[y, z]: [i64; 2]| (z - zs[0]) as usize * strides[1] + (y - ys[0]) as usize * strides[0];
    let (mut sum, mut count) = (0.0f64, 0usize);
    for [y, z] in rows.clone() {
        let row = image.row(xs, y, z);
        light[start([y, z])..][..row_length].copy_from_slice(row);
        let mut lanes = [0.0f32; LANES];
        for part in row.chunks(LANES) {
            for (lane, value) in lanes.iter_mut().zip(part) {
                *lane += value;
            }
        }
        sum += f64::from(lanes.iter().sum::<f32>());
        count += row_length;
    }
    let mean = (sum / count.max(1) as f64) as f32;
    for at in rows {
        for value in &mut light[start(at)..][..row_length] {
            *value -= mean;
        }
    }
}

/// Adds every voxel's products to its cell, and the squares of both frames to `energy`.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn add_products(window: &Window, cells: &mut [Cell], energy: &mut [f64; 2]) {
    let [nx, ny, nz] = window.counts;
    let [row, plane] = window.strides;
    for (n, cells) in cells.chunks_exact_mut(nx).enumerate().take(ny * nz) {
        let corner = n % ny * CELL * row + n / ny * CELL * plane;
        for (tile, cells) in cells.chunks_mut(LANES / CELL).enumerate() {
            let mut sums = [[0.0f32; LANES]; 7];
            let mut squares = [[0.0f32; LANES]; 2];
            for within in 0..CELL * CELL {
                let at = corner + tile * LANES + within % CELL * row + within / CELL * plane;
                let [a, b] = [&window.a[at..], &window.b[at..]];
                for lane in 0..LANES {
                    sums[COMMON][lane] += a[lane] * b[lane];
                    squares[0][lane] += a[lane] * a[lane];
                    squares[1][lane] += b[lane] * b[lane];
                }
                for (axis, next) in [1, row, plane].into_iter().enumerate() {
                    let (next_a, next_b) = (&a[next..][..LANES], &b[next..][..LANES]);
                    for lane in 0..LANES {
                        let (forward, backward) = (a[lane] * next_b[lane], next_a[lane] * b[lane]);
                        sums[axis][lane] += forward - backward;
                        sums[3 + axis][lane] += forward + backward;
                    }
                }
            }
            for (place, cell) in cells.iter_mut().enumerate() {
                for (cell, sums) in cell.iter_mut().zip(&sums) {
                    *cell = sums[place * CELL..][..CELL].iter().sum();
                }
            }
            for (energy, squares) in energy.iter_mut().zip(squares) {
                *energy += f64::from(squares.iter().sum::<f32>());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;

    /// The definition, voxel by voxel.
    fn summed_directly(
        [a, b]: [Image; 2],
        corner: [i64; 3],
        window: usize,
        lag: [i64; 3],
    ) -> Cells {
        let end = corner.map(|c| c + window as i64);
        let known = |image: &Image, at: [i64; 3]| {
            (0..3).all(|c| image.lit[c][0] <= at[c] && at[c] < image.lit[c][1])
        };
        let shifted = |at: [i64; 3]| std::array::from_fn(|c| at[c] + lag[c]);
        let counted = |at: [i64; 3]| {
            (0..3).all(|c| corner[c] <= at[c] && at[c] < end[c])
                && known(&a, at)
                && known(&b, shifted(at))
        };
        let mut voxels = Vec::new();
        for z in corner[2]..end[2] {
            for y in corner[1]..end[1] {
                voxels.extend((corner[0]..end[0]).map(|x| [x, y, z]).filter(|&at| counted(at)));
            }
        }
        let light = |image: &Image, [x, y, z]: [i64; 3]| f64::from(image.row([x, x + 1], y, z)[0]);
        let mean = |of: &dyn Fn([i64; 3]) -> f64| {
            voxels.iter().map(|&at| of(at)).sum::<f64>() / voxels.len() as f64
        };
        let (mean_a, mean_b) = (mean(&|at| light(&a, at)), mean(&|at| light(&b, shifted(at))));
        let lit_a = |at| light(&a, at) - mean_a;
        let lit_b = |at| light(&b, shifted(at)) - mean_b;
        let first = voxels[0];
        let last = voxels[voxels.len() - 1];
        let counts: [usize; 3] =
            std::array::from_fn(|c| ((last[c] - first[c] + 1) as usize).div_ceil(CELL));
        let mut cells = Cells {
            counts,
            sums: vec![[0.0; 7]; counts.iter().product()],
            energy: [0.0; 2],
            pairs: [0.0; 4],
        };
        for &at in &voxels {
            let [i, j, k] = std::array::from_fn(|c| (at[c] - first[c]) as usize / CELL);
            let cell = &mut cells.sums[(k * counts[1] + j) * counts[0] + i];
            cell[COMMON] += (lit_a(at) * lit_b(at)) as f32;
            cells.energy[0] += lit_a(at).powi(2);
            cells.energy[1] += lit_b(at).powi(2);
            cells.pairs[0] += 1.0;
            for axis in 0..3 {
                let mut next = at;
                next[axis] += 1;
                if counted(next) {
                    let (forward, backward) = (lit_a(at) * lit_b(next), lit_a(next) * lit_b(at));
                    cell[axis] += (forward - backward) as f32;
                    cell[3 + axis] += (forward + backward) as f32;
                    cells.pairs[1 + axis] += 1.0;
                }
            }
        }
        cells
    }

    #[test]
    fn cells_are_the_sums_of_their_voxels() {
        let cells = [21, 19, 23];
        let mut random = Pcg64Mcg::seed_from_u64(5);
        let mut volume = || -> Vec<f32> {
            (0..cells.iter().product()).map(|_| random.random_range(0.0..4.0)).collect()
        };
        let (a, b) = (volume(), volume());
        let lit = [[1, 21], [0, 18], [2, 23]];
        let images = [&a, &b].map(|light| Image { light, cells, lit });
        let mut cutouts = Cutouts::default();
        for (corner, window, lag) in [
            ([3, 2, 4], 16, [0, 0, 0]),
            ([-4, 0, 10], 16, [1, -2, 0]),
            ([5, 5, 5], 9, [-1, 2, 1]),
            ([14, -3, 3], 12, [0, 1, -1]),
        ] {
            let found = Cells::of(images, corner, window, lag, &mut cutouts);
            let expected = summed_directly(images, corner, window, lag);
            assert_eq!((found.counts, found.pairs), (expected.counts, expected.pairs));
            for (found, expected) in found.sums.iter().flatten().zip(expected.sums.iter().flatten())
            {
                assert!((found - expected).abs() < 1e-3, "{found} {expected}");
            }
            for (found, expected) in found.energy.iter().zip(expected.energy) {
                assert!((found / expected - 1.0).abs() < 1e-4, "{found} {expected}");
            }
        }
    }
}
