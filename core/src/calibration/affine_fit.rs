//! Robust fit of an affine grid (six parameters) to the centres of micro-images.

use nalgebra::{Matrix6, SMatrix, SVector};

use crate::lightfield::MicroImageGrid;

/// Centres farther from the grid than this many robust standard deviations are outliers.
const OUTLIER: f64 = 5.0;

/// Centres closer to the grid than this, in pixels, are never outliers.
const NEVER_OUTLIER_PX: f64 = 0.02;

const ROUNDS: usize = 8;

/// One lens of this many is held out to measure the residual.
const HELD_OUT_OF: usize = 5;

/// The centre of one micro-image as an estimator found it.
#[derive(Debug, Clone, Copy)]
pub(super) struct LensCentre {
    /// Index (i, j) of the lens.
    pub lens: [usize; 2],
    /// Column and row of the centre, in pixels.
    pub centre_px: [f64; 2],
    /// Information matrix [xx, xy, yy] of the centre, up to a factor common to all lenses.
    pub information: [f64; 3],
}

/// A grid fitted to centres.
#[derive(Debug, Clone)]
pub(super) struct AffineFit {
    pub grid: MicroImageGrid,
    /// Root-mean-square residuals of held-out lenses along columns and rows, in pixels.
    pub heldout_px: [f64; 2],
    /// Number of held-out lenses.
    pub heldout_lenses: usize,
    /// The same after subtracting a smooth displacement, a third-order polynomial over the field.
    pub smooth_heldout_px: [f64; 2],
    /// For each centre: whether it is an inlier.
    pub kept: Vec<bool>,
}

/// The same lattice with lens `first` as lens (0, 0), and this number of lenses along i and j.
pub(super) fn renumbered(
    grid: &MicroImageGrid,
    first: [i64; 2],
    microlenses: [usize; 2],
) -> MicroImageGrid {
    let [column, row] = grid.centre_px(first[0] as f64, first[1] as f64);
    MicroImageGrid {
        microlenses,
        column_px: [column, grid.column_px[1], grid.column_px[2]],
        row_px: [row, grid.row_px[1], grid.row_px[2]],
    }
}

/// Fits all centres, and measures the residual of every fifth lens with a fit to the others. `None` if the centres
/// do not determine six parameters.
pub(super) fn fit(start: &MicroImageGrid, centres: &[LensCentre]) -> Option<AffineFit> {
    let (grid, kept) = robust(start, centres, |_| true)?;
    let (without_held_out, _) = robust(start, centres, |centre| !is_held_out(centre.lens))?;
    let mut squares = [0.0; 2];
    let mut heldout_lenses = 0;
    for (centre, kept) in centres.iter().zip(&kept) {
        if *kept && is_held_out(centre.lens) {
            let residual = residual(&without_held_out, centre);
            squares = [0, 1].map(|axis| squares[axis] + residual[axis] * residual[axis]);
            heldout_lenses += 1;
        }
    }
    let heldout_px = squares.map(|sum| (sum / f64::from(heldout_lenses.max(1))).sqrt());
    let smooth_heldout_px = smooth_heldout(&without_held_out, centres, &kept).unwrap_or(heldout_px);
    let heldout_lenses = heldout_lenses as usize;
    Some(AffineFit { grid, heldout_px, heldout_lenses, smooth_heldout_px, kept })
}

/// Number of terms of a third-order polynomial in two variables.
const CUBIC: usize = 10;

/// Root-mean-square residuals of held-out lenses after subtracting a third-order polynomial that is fitted to the
/// residuals of the other lenses.
fn smooth_heldout(
    grid: &MicroImageGrid,
    centres: &[LensCentre],
    kept: &[bool],
) -> Option<[f64; 2]> {
    let scale = grid.microlenses.map(|count| (count as f64 / 2.0).max(1.0));
    let terms = |centre: &LensCentre| {
        let [u, v] = [0, 1].map(|axis| centre.lens[axis] as f64 / scale[axis] - 1.0);
        SVector::<f64, CUBIC>::from([
            1.0,
            u,
            v,
            u * u,
            u * v,
            v * v,
            u * u * u,
            u * u * v,
            u * v * v,
            v * v * v,
        ])
    };
    let used = || centres.iter().zip(kept).filter(|(_, kept)| **kept).map(|(centre, _)| centre);
    let mut normal = SMatrix::<f64, CUBIC, CUBIC>::zeros();
    let mut right = SMatrix::<f64, CUBIC, 2>::zeros();
    for centre in used().filter(|centre| !is_held_out(centre.lens)) {
        let at = terms(centre);
        let [x, y] = residual(grid, centre);
        normal += at * at.transpose();
        right += at * SMatrix::<f64, 1, 2>::new(x, y);
    }
    let fit = normal.cholesky()?.solve(&right);
    let mut squares = [0.0; 2];
    let mut lenses = 0.0;
    for centre in used().filter(|centre| is_held_out(centre.lens)) {
        let smooth = fit.transpose() * terms(centre);
        let [x, y] = residual(grid, centre);
        squares = [squares[0] + (x - smooth[0]).powi(2), squares[1] + (y - smooth[1]).powi(2)];
        lenses += 1.0;
    }
    (lenses > 0.0).then(|| squares.map(|sum: f64| (sum / lenses).sqrt()))
}

/// Every fifth lens, distributed over all rows and columns.
fn is_held_out([i, j]: [usize; 2]) -> bool {
    (i + 2 * j) % HELD_OUT_OF == 0
}

fn residual(grid: &MicroImageGrid, centre: &LensCentre) -> [f64; 2] {
    let [column, row] = grid.centre_px(centre.lens[0] as f64, centre.lens[1] as f64);
    [centre.centre_px[0] - column, centre.centre_px[1] - row]
}

/// Least squares weighted by the information matrices, with iterated rejection of outliers.
fn robust(
    start: &MicroImageGrid,
    centres: &[LensCentre],
    takes_part: impl Fn(&LensCentre) -> bool,
) -> Option<(MicroImageGrid, Vec<bool>)> {
    let mut grid = start.clone();
    let mut kept = vec![true; centres.len()];
    for _ in 0..ROUNDS {
        let used = || centres.iter().zip(&kept).filter(|(c, kept)| **kept && takes_part(c));
        grid = weighted(&grid, used().map(|(centre, _)| centre))?;
        let distances: Vec<f64> = centres.iter().map(|c| misfit(&grid, c)).collect();
        let mut sorted = distances.clone();
        sorted.sort_by(f64::total_cmp);
        // Median of the Rayleigh distribution: 1.177 standard deviations.
        let deviation = sorted.get(sorted.len() / 2)? / 1.177;
        let before = kept.clone();
        for ((kept, centre), distance) in kept.iter_mut().zip(centres).zip(distances) {
            let [x, y] = residual(&grid, centre);
            *kept = distance <= OUTLIER * deviation || x.hypot(y) < NEVER_OUTLIER_PX;
        }
        if kept == before {
            break;
        }
    }
    Some((grid, kept))
}

/// Mahalanobis length of a residual, up to a factor common to all lenses.
fn misfit(grid: &MicroImageGrid, centre: &LensCentre) -> f64 {
    let [x, y] = residual(grid, centre);
    let [xx, xy, yy] = centre.information;
    (xx * x * x + 2.0 * xy * x * y + yy * y * y).max(0.0).sqrt()
}

fn weighted<'a>(
    grid: &MicroImageGrid,
    centres: impl Iterator<Item = &'a LensCentre>,
) -> Option<MicroImageGrid> {
    let mut normal = Matrix6::<f64>::zeros();
    let mut right = SVector::<f64, 6>::zeros();
    // Lens indices are scaled to ±1 over the array for a well-conditioned normal matrix.
    let scale = grid.microlenses.map(|count| (count as f64 / 2.0).max(1.0));
    for centre in centres {
        let [u, v] = [0, 1].map(|axis| centre.lens[axis] as f64 / scale[axis] - 1.0);
        let [x, y] = residual(grid, centre);
        let [xx, xy, yy] = centre.information;
        let at = [1.0, u, v];
        for a in 0..3 {
            right[a] += at[a] * (xx * x + xy * y);
            right[3 + a] += at[a] * (xy * x + yy * y);
            for b in 0..3 {
                let product = at[a] * at[b];
                normal[(a, b)] += product * xx;
                normal[(a, 3 + b)] += product * xy;
                normal[(3 + a, b)] += product * xy;
                normal[(3 + a, 3 + b)] += product * yy;
            }
        }
    }
    let step = normal.cholesky()?.solve(&right);
    let moved = |affine: [f64; 3], step: [f64; 3]| {
        let [first, by_u, by_v] = step;
        [affine[0] + first - by_u - by_v, affine[1] + by_u / scale[0], affine[2] + by_v / scale[1]]
    };
    Some(MicroImageGrid {
        microlenses: grid.microlenses,
        column_px: moved(grid.column_px, [step[0], step[1], step[2]]),
        row_px: moved(grid.row_px, [step[3], step[4], step[5]]),
    })
}
