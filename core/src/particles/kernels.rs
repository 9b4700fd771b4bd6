//! Loops over pixels: addition of a particle to an image, and its normal equations.

use multiversion::multiversion;

use super::noise::PixelNoise;
use crate::model::{LANES, PointFootprint};

type Lanes = [f32; LANES];

/// Unknowns of a particle in one camera: its light, and offset and parallax along columns and rows.
pub const UNKNOWNS: usize = 5;

/// Entries of a symmetric matrix of the unknowns.
const ENTRIES: usize = UNKNOWNS * (UNKNOWNS + 1) / 2;

/// Normal equations of one particle in one camera, per unit of light: every pixel weighs as the inverse of its
/// variance.
#[derive(Debug, Clone, PartialEq)]
pub struct Equations {
    /// Σ g r / v, with g the derivatives by the unknowns and r the residual.
    pub right: [f64; UNKNOWNS],
    /// Σ g gᵀ / v, its upper triangle row by row.
    pub matrix: [f64; ENTRIES],
}

impl Equations {
    /// The whole matrix.
    pub fn full(&self) -> [[f64; UNKNOWNS]; UNKNOWNS] {
        let mut full = [[0.0; UNKNOWNS]; UNKNOWNS];
        let mut entries = self.matrix.iter();
        for (i, j) in (0..UNKNOWNS).flat_map(|i| (i..UNKNOWNS).map(move |j| (i, j))) {
            let entry = entries.next().copied().unwrap_or_default();
            full[i][j] = entry;
            full[j][i] = entry;
        }
        full
    }
}

/// An image as kernels read it.
pub struct ImageSlices<'a> {
    pub counts: &'a [u16],
    pub model: &'a [f32],
    pub width: usize,
    pub black: f32,
    pub saturation: u16,
    pub noise: PixelNoise,
}

/// Adds a particle of `light` counts in an open pixel to rows of `width` pixels.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
pub fn add_image(
    pixels: &mut [f32],
    width: usize,
    open: &[u8],
    open_stride: usize,
    footprint: &PointFootprint,
    light: f32,
) {
    for patch in &footprint.patches {
        let columns = footprint.padded(0, &patch.columns);
        let mut at = patch.rows.first_px * width + patch.columns.first_px;
        let mut open_at = patch.open;
        for &row in footprint.of(0, &patch.rows) {
            let scale = row * light / 255.0;
            let lanes =
                pixels[at..].chunks_exact_mut(LANES).zip(open[open_at..].chunks_exact(LANES));
            for ((pixels, open), columns) in lanes.zip(columns.chunks_exact(LANES)) {
                for n in 0..LANES {
                    pixels[n] += scale * columns[n] * f32::from(open[n]);
                }
            }
            at += width;
            open_at += open_stride;
        }
    }
}

/// Contributions of adjacent pixels to the normal equations.
struct Pixels {
    /// Open share × residual / variance.
    pull: Lanes,
    /// Open share² / variance, or, of the gradient's covariance, open share² × residual² / variance².
    own: Lanes,
}

impl Pixels {
    /// From the pixels starting at `at`, if they are in the image. The loop is vectorised by the compiler.
    #[inline(always)]
    fn at<const SPREAD: bool>(view: &ImageSlices<'_>, at: usize, open: &[u8]) -> Option<Self> {
        let model: &Lanes = view.model.get(at..)?.first_chunk()?;
        let counts: &[u16; LANES] = view.counts.get(at..)?.first_chunk()?;
        let open: &[u8; LANES] = open.first_chunk()?;
        let mut pixels = Self { pull: [0.0; LANES], own: [0.0; LANES] };
        for n in 0..LANES {
            let (open, weight, residual) = weighted(view, counts[n], model[n], open[n]);
            pixels.pull[n] = weight * residual;
            pixels.own[n] = if SPREAD { pixels.pull[n] * pixels.pull[n] } else { open * weight };
        }
        Some(pixels)
    }
}

#[inline(always)]
fn add(sum: &mut Lanes, values: &Lanes, scale: f32) {
    for n in 0..LANES {
        sum[n] += scale * values[n];
    }
}

#[inline(always)]
fn add_product(sum: &mut Lanes, one: &Lanes, other: &Lanes) {
    for n in 0..LANES {
        sum[n] += one[n] * other[n];
    }
}

#[inline(always)]
fn times(one: &Lanes, other: &Lanes) -> Lanes {
    std::array::from_fn(|n| one[n] * other[n])
}

/// Sums over the rows of a patch, a lane per column: of residuals with the three shares of the rows, and of
/// open shares with their six products.
type ColumnSums = [Lanes; 9];

/// The normal equations of the particle with this footprint. With `SPREAD` the matrix is that of the
/// gradient's covariance instead, Σ g gᵀ r² / v², by the residuals themselves (White 1980).
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
pub fn equations<const SPREAD: bool>(
    view: &ImageSlices<'_>,
    open: &[u8],
    open_stride: usize,
    footprint: &PointFootprint,
) -> Equations {
    let mut right = [[0.0f32; LANES]; UNKNOWNS];
    let mut matrix = [[0.0f32; LANES]; ENTRIES];
    for patch in &footprint.patches {
        let columns = [0, 1, 2].map(|kind| footprint.padded(kind, &patch.columns));
        let rows = [0, 1, 2].map(|kind| footprint.of(kind, &patch.rows));
        for start in (0..columns[0].len()).step_by(LANES) {
            let lanes = start..start + LANES;
            let mut sums: ColumnSums = [[0.0; LANES]; 9];
            let mut at = patch.rows.first_px * view.width + patch.columns.first_px + start;
            let mut open_at = patch.open + start;
            for ((&row, &by_offset), &by_parallax) in rows[0].iter().zip(rows[1]).zip(rows[2]) {
                let Some(pixels) = Pixels::at::<SPREAD>(view, at, &open[open_at..]) else { break };
                let Pixels { pull, own } = &pixels;
                add(&mut sums[0], pull, row);
                add(&mut sums[1], pull, by_offset);
                add(&mut sums[2], pull, by_parallax);
                add(&mut sums[3], own, row * row);
                add(&mut sums[4], own, row * by_offset);
                add(&mut sums[5], own, row * by_parallax);
                add(&mut sums[6], own, by_offset * by_offset);
                add(&mut sums[7], own, by_offset * by_parallax);
                add(&mut sums[8], own, by_parallax * by_parallax);
                at += view.width;
                open_at += open_stride;
            }
            let column = [0, 1, 2].map(|kind| lanes_of(&columns[kind][lanes.clone()]));
            gather(&mut right, &mut matrix, &sums, column);
        }
    }
    Equations { right: right.map(total), matrix: matrix.map(total) }
}

/// Puts the sums of a patch together with the shares of its columns: derivatives by the unknowns are
/// products of both.
#[inline(always)]
fn gather(
    right: &mut [Lanes; UNKNOWNS],
    matrix: &mut [Lanes; ENTRIES],
    sums: &ColumnSums,
    columns: [&Lanes; 3],
) {
    // Which share of the columns and which of the rows makes the derivative by each unknown.
    const OF_COLUMN: [usize; UNKNOWNS] = [0, 1, 2, 0, 0];
    const OF_ROW: [usize; UNKNOWNS] = [0, 0, 0, 1, 2];
    const PRODUCT: [[usize; 3]; 3] = [[3, 4, 5], [4, 6, 7], [5, 7, 8]];
    let mut entry = 0;
    for i in 0..UNKNOWNS {
        let (column, sum) = (columns[OF_COLUMN[i]], &sums[OF_ROW[i]]);
        add_product(&mut right[i], column, sum);
        for j in i..UNKNOWNS {
            let (other, sum) = (columns[OF_COLUMN[j]], &sums[PRODUCT[OF_ROW[i]][OF_ROW[j]]]);
            add_product(&mut matrix[entry], &times(column, other), sum);
            entry += 1;
        }
    }
}

/// Σ g r / v and Σ g² / v with g the image per unit of light: the first entries of [`equations`].
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
pub fn light_equation(
    view: &ImageSlices<'_>,
    open: &[u8],
    open_stride: usize,
    footprint: &PointFootprint,
) -> [f64; 2] {
    let mut total_of = [[0.0f32; LANES]; 2];
    let (mut pull, mut own) = (Vec::new(), Vec::new());
    for patch in &footprint.patches {
        let columns = footprint.padded(0, &patch.columns);
        for sums in [&mut pull, &mut own] {
            sums.clear();
            sums.resize(columns.len(), 0.0);
        }
        let mut at = patch.rows.first_px * view.width + patch.columns.first_px;
        let mut open_at = patch.open;
        for &row in footprint.of(0, &patch.rows) {
            add_row(view, at, &open[open_at..], row, (&mut pull, &mut own));
            at += view.width;
            open_at += open_stride;
        }
        let sums = pull.chunks_exact(LANES).zip(own.chunks_exact(LANES));
        for (column, (pull, own)) in columns.chunks_exact(LANES).zip(sums) {
            for n in 0..LANES {
                total_of[0][n] += column[n] * pull[n];
                total_of[1][n] += column[n] * column[n] * own[n];
            }
        }
    }
    total_of.map(total)
}

/// Adds pixels of one row, from `at` on, to the sums of their columns. The compiler vectorises a loop over a whole
/// row; over [`LANES`] pixels with two sums it does not.
#[inline(always)]
fn add_row(
    view: &ImageSlices<'_>,
    at: usize,
    open: &[u8],
    row: f32,
    (pull, own): (&mut [f32], &mut [f32]),
) {
    let pixels = view.counts[at..].iter().zip(&view.model[at..]).zip(open);
    for (((&count, &model), &open), (pull, own)) in pixels.zip(pull.iter_mut().zip(own)) {
        let (open, weight, residual) = weighted(view, count, model, open);
        *pull += row * (weight * residual);
        *own += row * row * (open * weight);
    }
}

/// A pixel's open share, that over its variance, and its residual.
#[inline(always)]
fn weighted(view: &ImageSlices<'_>, count: u16, model: f32, open: u8) -> (f32, f32, f32) {
    let open = f32::from(open) * (1.0 / 255.0);
    let trust: f32 = if count < view.saturation { 1.0 } else { 0.0 };
    let weight = open * (trust / view.noise.variance(model));
    (open, weight, f32::from(count) - view.black - model)
}

#[inline(always)]
fn lanes_of(values: &[f32]) -> &Lanes {
    values.first_chunk().unwrap_or(&[0.0; LANES])
}

fn total(lanes: Lanes) -> f64 {
    lanes.iter().map(|&value| f64::from(value)).sum()
}

#[cfg(test)]
mod tests {
    use lfpiv_hw::CameraName;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;
    use crate::{
        model::{CameraCalibration, PointBlur, PointCamera, VolumeGrid},
        test_bench,
    };

    /// The naive reference: pixel by pixel, in double precision.
    fn reference(
        view: &ImageSlices<'_>,
        camera: &PointCamera,
        footprint: &PointFootprint,
    ) -> (Equations, [f64; 2]) {
        let mut sums = Equations { right: [0.0; 5], matrix: [0.0; 15] };
        // Σ w r² / v and Σ w, the scale of what is compared.
        let mut left = [0.0; 2];
        for patch in &footprint.patches {
            for r in 0..patch.rows.len {
                for c in 0..patch.columns.len {
                    let [a, b] = [(&patch.columns, c), (&patch.rows, r)].map(|(shares, n)| {
                        [0, 1, 2].map(|kind| f64::from(footprint.of(kind, shares)[n]))
                    });
                    let open = camera.open_shares()[patch.open + r * camera.open_stride() + c];
                    let open = f64::from(open) / 255.0;
                    let at = (patch.rows.first_px + r) * view.width + patch.columns.first_px + c;
                    let model = f64::from(view.model[at]);
                    let noise = view.noise;
                    let variance = f64::from(noise.dark)
                        + f64::from(noise.gain) * model.max(0.0)
                        + (f64::from(noise.misfit) * model.max(0.0)).powi(2);
                    let residual = f64::from(view.counts[at]) - f64::from(view.black) - model;
                    let by = [a[0] * b[0], a[1] * b[0], a[2] * b[0], a[0] * b[1], a[0] * b[2]];
                    let mut entry = 0;
                    for i in 0..5 {
                        sums.right[i] += by[i] * open * residual / variance;
                        for j in i..5 {
                            sums.matrix[entry] += by[i] * by[j] * open * open / variance;
                            entry += 1;
                        }
                    }
                    left[0] += by[0] * open * residual * residual / variance;
                    left[1] += by[0] * open;
                }
            }
        }
        (sums, left)
    }

    #[test]
    fn the_sums_are_those_of_the_reference() {
        let mut random = Pcg64Mcg::seed_from_u64(3);
        let volume = VolumeGrid { voxels: [40; 3], voxel_mm: 0.1, centre_mm: [0.0; 3] };
        let (optics, poses) = (test_bench::optics(), test_bench::poses());
        let blur = PointBlur { plane_mm: 2e-3, sensor_px: 0.3 };
        let uncalibrated = CameraCalibration::default();
        let camera =
            PointCamera::new(&optics, &poses[1], &uncalibrated, &volume, CameraName(1), blur)
                .unwrap();
        let [width, height] = camera.sensor_px();
        let pixels = width * height + LANES;
        let counts: Vec<u16> = (0..pixels).map(|_| random.random_range(50..300)).collect();
        let model: Vec<f32> = (0..pixels).map(|_| random.random_range(-5.0..200.0)).collect();
        let noise = PixelNoise { dark: 36.0, gain: 0.7, misfit: 0.1 };
        let view = ImageSlices {
            counts: &counts,
            model: &model,
            width,
            black: 64.0,
            saturation: u16::MAX,
            noise,
        };
        for at_mm in [[0.03, 0.01, 0.02], [1.21, -1.37, 0.4], [-1.6, 1.8, -1.7]] {
            let mut footprint = PointFootprint::default();
            camera.image_and_derivatives(at_mm, &mut footprint);
            let (expected, left) = reference(&view, &camera, &footprint);
            let (open, stride) = (camera.open_shares(), camera.open_stride());
            let found = equations::<false>(&view, open, stride, &footprint);
            let close = |found: &[f64], expected: &[f64], scale: &dyn Fn(usize) -> f64| {
                for (n, (found, expected)) in found.iter().zip(expected).enumerate() {
                    assert!((found - expected).abs() < 1e-3 * scale(n), "{n}: {found} {expected}");
                }
            };
            let diagonal = [0, 5, 9, 12, 14].map(|entry| expected.matrix[entry].sqrt());
            let residuals = (left[0] / left[1].max(1e-9)).sqrt() * 10.0;
            close(&found.right, &expected.right, &|n| diagonal[n] * residuals + 1e-6);
            let entries: Vec<f64> =
                (0..5).flat_map(|i| (i..5).map(move |j| diagonal[i] * diagonal[j])).collect();
            close(&found.matrix, &expected.matrix, &|n| entries[n] + 1e-6);
            let (mut added, mut expected) = (vec![0.0; pixels], vec![0.0; pixels]);
            add_image(&mut added, width, open, stride, &footprint, 90.0);
            for patch in &footprint.patches {
                let [columns, rows] =
                    [&patch.columns, &patch.rows].map(|shares| footprint.of(0, shares));
                for (r, c) in (0..rows.len()).flat_map(|r| (0..columns.len()).map(move |c| (r, c)))
                {
                    let at = (patch.rows.first_px + r) * width + patch.columns.first_px + c;
                    let share = f32::from(open[patch.open + r * stride + c]) / 255.0;
                    expected[at] += 90.0 * rows[r] * columns[c] * share;
                }
            }
            let off = |(added, expected): (&f32, &f32)| (added - expected).abs();
            assert!(added.iter().zip(&expected).map(off).fold(0.0, f32::max) < 1e-4);
            assert!(expected.iter().sum::<f32>() > 90.0);
            let light = light_equation(&view, open, stride, &footprint);
            assert!((light[0] - found.right[0]).abs() < 1e-3 * diagonal[0] * residuals);
            assert!((light[1] - found.matrix[0]).abs() < 1e-4 * found.matrix[0]);
        }
    }
}
