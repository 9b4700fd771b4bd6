//! Six affine parameters through the centres of many micro-images.

use nalgebra::{Matrix6, SMatrix, SVector};

use crate::lightfield::MicroImageGrid;

/// Centres further from the grid than this many robust standard deviations have no weight.
const OUTLIER: f64 = 5.0;

/// A centre is never an outlier this close to the grid, in pixels.
const NEVER_OUTLIER_PX: f64 = 0.02;

const ROUNDS: usize = 8;

/// One lens of this many is kept out of the fit that is judged.
const HELD_OUT_OF: usize = 5;

/// The centre of one micro-image as an estimator found it.
#[derive(Debug, Clone, Copy)]
pub(super) struct LensCentre {
    /// The lens' number in its array.
    pub lens: [usize; 2],
    /// Column and row of the centre.
    pub centre_px: [f64; 2],
    /// How well it is known: the information matrix [xx, xy, yy], up to a factor.
    pub information: [f64; 3],
}

/// A grid through centres.
#[derive(Debug, Clone)]
pub(super) struct AffineFit {
    pub grid: MicroImageGrid,
    /// Root mean square of column and row residuals of lenses that took no part in the fit.
    pub heldout_px: [f64; 2],
    /// How many lenses that is of.
    pub heldout_lenses: usize,
    /// The same where centres may also be displaced smoothly over the field, by a polynomial of third order.
    pub smooth_heldout_px: [f64; 2],
    /// Of each centre: whether it is no outlier.
    pub kept: Vec<bool>,
}

/// The same lattice, counted from another lens.
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

/// Fits all centres, and again without every fifth lens, on which the residual is measured.
/// `None` with too few centres for six parameters.
pub(super) fn fit(start: &MicroImageGrid, centres: &[LensCentre]) -> Option<AffineFit> {
    let (grid, kept) = robust(start, centres, |_| true)?;
    let (judged, _) = robust(start, centres, |centre| !is_held_out(centre.lens))?;
    let mut squares = [0.0; 2];
    let mut heldout_lenses = 0;
    for (centre, kept) in centres.iter().zip(&kept) {
        if *kept && is_held_out(centre.lens) {
            let residual = residual(&judged, centre);
            squares = [0, 1].map(|axis| squares[axis] + residual[axis] * residual[axis]);
            heldout_lenses += 1;
        }
    }
    let heldout_px = squares.map(|sum| (sum / f64::from(heldout_lenses.max(1))).sqrt());
    let smooth_heldout_px = smooth_heldout(&judged, centres, &kept).unwrap_or(heldout_px);
    let heldout_lenses = heldout_lenses as usize;
    Some(AffineFit { grid, heldout_px, heldout_lenses, smooth_heldout_px, kept })
}

/// Terms of a polynomial of third order in two variables.
const CUBIC: usize = 10;

/// What is left at held-out lenses of the residuals' part that is no polynomial over the field.
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

/// Every fifth lens, not in rows or columns.
fn is_held_out([i, j]: [usize; 2]) -> bool {
    (i + 2 * j) % HELD_OUT_OF == 0
}

fn residual(grid: &MicroImageGrid, centre: &LensCentre) -> [f64; 2] {
    let [column, row] = grid.centre_px(centre.lens[0] as f64, centre.lens[1] as f64);
    [centre.centre_px[0] - column, centre.centre_px[1] - row]
}

/// Least squares weighted by information, repeated without outliers.
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
        // The median of a two-dimensional normal distribution's distance is 1.177 deviations.
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

/// Length of a residual in units of its own standard deviation, up to a factor.
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
    // Lens numbers near ±1, from the middle of the array: the equations are well conditioned.
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
