//! Approximate centre and radius of the micro-images, from the mean unit cell in the middle of the field.

use super::{WhiteImage, lattice::Basis};

/// Samples along each side of the cell.
const SIDE: usize = 32;

/// Half width of the averaged region around the image's centre, in pitches.
const REACH_PITCHES: f64 = 10.0;

/// Tested radii in units of `RADIUS_STEP`: from a closed stop to four overlapping micro-images.
const RADII: std::ops::RangeInclusive<usize> = 5..=18;
/// Step of the tested radii, in pitches.
const RADIUS_STEP: f64 = 0.05;

/// Width of the discs' rims, in pitches: about a pixel.
const RIM: f64 = 0.05;

/// Parameters of the mean micro-image.
#[derive(Debug, Clone, Copy)]
pub(super) struct UnitCell {
    /// Centre of a micro-image near the image's middle, in pixels.
    pub centre_px: [f64; 2],
    /// Radius of its disc, in pixels.
    pub radius_px: f64,
}

/// Averages the middle of the image over the unit cells of the lattice, and finds the periodic disc with the
/// highest correlation. Overlapping discs add up, which distinguishes round bright parts from round dark ones.
pub(super) fn find(image: &WhiteImage, basis: &Basis) -> UnitCell {
    let middle = [image.columns(), image.rows()].map(|pixels| (pixels as f64 - 1.0) / 2.0);
    let cell = normalised(fold(image, basis, middle));
    let pitch = basis.map(|[x, y]| x.hypot(y)).into_iter().fold(f64::INFINITY, f64::min);
    let mut best = (f64::NEG_INFINITY, 0, 0.0);
    for radius in RADII.map(|steps| steps as f64 * RADIUS_STEP * pitch) {
        let disc = normalised(render(basis, radius, RIM * pitch));
        for shift in 0..SIDE * SIDE {
            let correlation = correlation(&cell, &disc, shift);
            if correlation > best.0 {
                best = (correlation, shift, radius);
            }
        }
    }
    let (_, shift, radius_px) = best;
    let fraction = [shift % SIDE, shift / SIDE].map(|n| n as f64 / SIDE as f64);
    let centre_px = [0, 1]
        .map(|axis| middle[axis] + fraction[0] * basis[0][axis] + fraction[1] * basis[1][axis]);
    UnitCell { centre_px, radius_px }
}

/// Mean light of the unit cell, sampled at fractions of both lattice vectors from `middle`.
fn fold(image: &WhiteImage, basis: &Basis, middle: [f64; 2]) -> Vec<f64> {
    let [a, b] = basis;
    let determinant = a[0] * b[1] - a[1] * b[0];
    let reach = REACH_PITCHES * a[0].hypot(a[1]).max(b[0].hypot(b[1]));
    let span = |axis: usize, pixels: usize| {
        let first = (middle[axis] - reach).max(0.0) as usize;
        first..((middle[axis] + reach) as usize + 1).min(pixels)
    };
    let mut sums = vec![[0.0; 2]; SIDE * SIDE];
    for row in span(1, image.rows()) {
        for column in span(0, image.columns()) {
            let (x, y) = (column as f64 - middle[0], row as f64 - middle[1]);
            let fractions =
                [(b[1] * x - b[0] * y) / determinant, (a[0] * y - a[1] * x) / determinant];
            let [u, v] = fractions.map(|f| ((f - f.floor()) * SIDE as f64).round() as usize % SIDE);
            let sum = &mut sums[v * SIDE + u];
            *sum = [sum[0] + image.at(column, row), sum[1] + 1.0];
        }
    }
    let mean = sums.iter().map(|sum| sum[0]).sum::<f64>()
        / sums.iter().map(|sum| sum[1]).sum::<f64>().max(1.0);
    sums.iter().map(|[light, count]| if *count > 0.0 { light / count } else { mean }).collect()
}

/// The unit cell of an image with a disc on every lattice point; lengths in pixels.
fn render(basis: &Basis, radius: f64, rim: f64) -> Vec<f64> {
    let [a, b] = basis;
    let disc = |u: f64, v: f64| {
        let (x, y) = (u * a[0] + v * b[0], u * a[1] + v * b[1]);
        ((radius - x.hypot(y)) / rim + 0.5).clamp(0.0, 1.0)
    };
    let at = |n: usize| {
        let [u, v] = [n % SIDE, n / SIDE].map(|n| n as f64 / SIDE as f64);
        let around = (-2..=2).flat_map(|j| (-2..=2).map(move |i| [f64::from(i), f64::from(j)]));
        around.map(|[i, j]| disc(u - i, v - j)).sum()
    };
    (0..SIDE * SIDE).map(at).collect()
}

/// The cell with zero mean and unit norm.
fn normalised(mut cell: Vec<f64>) -> Vec<f64> {
    let mean = cell.iter().sum::<f64>() / cell.len() as f64;
    cell.iter_mut().for_each(|light| *light -= mean);
    let length = cell.iter().map(|light| light * light).sum::<f64>().sqrt().max(f64::MIN_POSITIVE);
    cell.iter_mut().for_each(|light| *light /= length);
    cell
}

/// The correlation coefficient of the cell with the disc moved by `shift`.
fn correlation(cell: &[f64], disc: &[f64], shift: usize) -> f64 {
    let (across, up) = (shift % SIDE, shift / SIDE);
    let rows = (0..SIDE).map(|row| {
        let disc = &disc[row * SIDE..][..SIDE];
        let cell = &cell[(row + up) % SIDE * SIDE..][..SIDE];
        let (left, right) = disc.split_at(SIDE - across);
        let first: f64 = left.iter().zip(&cell[across..]).map(|(d, c)| d * c).sum();
        let second: f64 = right.iter().zip(&cell[..across]).map(|(d, c)| d * c).sum();
        first + second
    });
    rows.sum()
}
