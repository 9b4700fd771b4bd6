//! Initial grid of both estimators, accurate to about half a pixel.

use std::f64::consts::TAU;

use super::{
    CalibrationError, WhiteImage, edge_arcs, lattice,
    lattice::Basis,
    rim_model::RimModel,
    rim_points::RimSearch,
    second_aperture::{Field, SecondAperture},
    unit_cell,
};
use crate::lightfield::MicroImageGrid;

/// Least pitch in pixels: smaller micro-images have too few pixels on their rims.
const LEAST_PITCH_PX: f64 = 6.0;

/// Width of the blocks for phase measurement, in pitches.
const BLOCK_PITCHES: f64 = 6.0;

/// Extents of the blocks' region, as shares of the half image. They increase, so that no shift is ambiguous by
/// a pitch. The edge of the image is left out, because mechanical vignetting biases the phase there.
const EXTENTS: [f64; 4] = [0.15, 0.3, 0.5, 0.7];

/// Largest number of lenses for the first fit of rims.
const RIM_LENSES: usize = 700;

/// Micro-images within this share of the half diagonal from the centre of the image are assumed to be uncut.
const UNCUT_SHARE: f64 = 0.35;

/// Initial values of both estimators.
#[derive(Debug, Clone)]
pub(super) struct Start {
    /// All lenses whose centres are on the image.
    pub grid: MicroImageGrid,
    /// Radius of the micro-images in the middle of the field, in pixels.
    pub radius_px: f64,
    /// Second aperture, if micro-images away from the middle are cut.
    pub second: Option<SecondAperture>,
}

/// Finds lattice, phase and radius in the middle of the image, and refines the lattice outwards.
pub(super) fn find(image: &WhiteImage) -> Result<Start, CalibrationError> {
    let basis = lattice::find(image).ok_or(CalibrationError::NotPeriodic)?;
    let pitch_px = pitch(&basis);
    if pitch_px < LEAST_PITCH_PX {
        return Err(CalibrationError::PitchTooSmall { pitch_px, least_px: LEAST_PITCH_PX });
    }
    let cell = unit_cell::find(image, &basis);
    let mut affine = Affine { origin: cell.centre_px, basis };
    for reach in EXTENTS {
        affine = refined(image, &affine, reach);
    }
    let mut start = Start { grid: affine.covering(image), radius_px: cell.radius_px, second: None };
    start.measure_rims(image);
    Ok(start)
}

impl Start {
    /// Model of the rims with these values.
    pub fn circles(&self) -> RimModel {
        RimModel { grid: self.grid.clone(), radius_px: self.radius_px, second: self.second }
    }

    /// Fits grid, radius and second aperture to the rims of some lenses: first a common radius in the middle,
    /// then circles as in the first estimator.
    fn measure_rims(&mut self, image: &WhiteImage) {
        let [nx, ny] = self.grid.microlenses;
        let stride = (nx * ny).div_ceil(RIM_LENSES) | 1;
        let lenses: Vec<[usize; 2]> =
            (0..nx * ny).step_by(stride).map(|n| [n % nx, n / nx]).collect();
        let field = Field::of(image.columns(), image.rows());
        let search = RimSearch::new(&self.grid, self.radius_px, None, field);
        let in_middle = lenses.iter().flat_map(|lens| {
            let stop_px = self.grid.centre_px(lens[0] as f64, lens[1] as f64);
            let [x, y] = field.share(stop_px);
            let rim =
                if x.hypot(y) < UNCUT_SHARE { search.points(image, stop_px) } else { Vec::new() };
            rim.into_iter().map(move |p| (p[0] - stop_px[0]).hypot(p[1] - stop_px[1]))
        });
        let radius = super::median(in_middle);
        if radius.is_finite() {
            self.radius_px = radius;
        }
        let circles = RimModel { second: None, ..self.circles() };
        if let Some(found) = edge_arcs::with_second_aperture(image, circles, &lenses, &field) {
            (self.grid, self.radius_px, self.second) = (found.grid, found.radius_px, found.second);
        }
    }
}

fn pitch(basis: &Basis) -> f64 {
    basis.map(|[x, y]| x.hypot(y)).into_iter().fold(f64::INFINITY, f64::min)
}

/// Lattice with points origin + i a + j b, in pixels.
#[derive(Debug, Clone)]
struct Affine {
    origin: [f64; 2],
    basis: Basis,
}

impl Affine {
    /// Reciprocal lattice vectors g: g·a = 1 and g·b = 0 for the first, g·a = 0 and g·b = 1 for the second.
    fn reciprocal(&self) -> [[f64; 2]; 2] {
        let [a, b] = self.basis;
        let determinant = a[0] * b[1] - a[1] * b[0];
        [[b[1] / determinant, -b[0] / determinant], [-a[1] / determinant, a[0] / determinant]]
    }

    /// The grid of all lenses with centres on the image; the first one is (0, 0).
    fn covering(&self, image: &WhiteImage) -> MicroImageGrid {
        let [a, b] = self.basis;
        let grid = MicroImageGrid {
            microlenses: [1, 1],
            column_px: [self.origin[0], a[0], b[0]],
            row_px: [self.origin[1], a[1], b[1]],
        };
        let (right, bottom) = (image.columns() as f64 - 1.0, image.rows() as f64 - 1.0);
        let corners = [[0.0, 0.0], [right, 0.0], [0.0, bottom], [right, bottom]]
            .map(|[column, row]| grid.lens_at(column, row));
        let [[first_i, last_i], [first_j, last_j]] = [0, 1].map(|axis| {
            let places = corners.map(|corner| corner[axis]);
            let low = places.into_iter().fold(f64::INFINITY, f64::min).ceil();
            let high = places.into_iter().fold(f64::NEG_INFINITY, f64::max).floor();
            [low, high.max(low)]
        });
        super::affine_fit::renumbered(
            &grid,
            [first_i as i64, first_j as i64],
            [(last_i - first_i) as usize + 1, (last_j - first_j) as usize + 1],
        )
    }
}

/// Refines the lattice by the phases of blocks within `reach`, a share of the half image. Phases are relative
/// to the middle block, whose offset is known from the unit cell.
fn refined(image: &WhiteImage, affine: &Affine, reach: f64) -> Affine {
    let half = [image.columns(), image.rows()].map(|pixels| pixels as f64 / 2.0);
    let side = BLOCK_PITCHES * pitch(&affine.basis);
    let counts = half.map(|half| ((half * reach / side) as i64).max(1));
    let middle = block_phases(image, affine, half, side);
    // Normal equations for shifts that are affine functions of the position.
    let mut normal = nalgebra::Matrix3::<f64>::zeros();
    let mut right = nalgebra::Matrix3x2::<f64>::zeros();
    for down in -counts[1]..=counts[1] {
        for across in -counts[0]..=counts[0] {
            let steps = [across as f64 / counts[0] as f64, down as f64 / counts[1] as f64];
            let place = [0, 1].map(|axis| half[axis] + steps[axis] * reach * (half[axis] - side));
            let phases = block_phases(image, affine, place, side);
            // Phase difference from the middle block, in periods from -1/2 to 1/2.
            let periods = [0, 1].map(|wave: usize| {
                let [re, im] = conjugate_product(phases[wave], middle[wave]);
                -im.atan2(re) / TAU
            });
            let weight = [0, 1]
                .map(|wave: usize| phases[wave][0].hypot(phases[wave][1]))
                .into_iter()
                .fold(f64::INFINITY, f64::min);
            let shift = [0, 1].map(|axis| {
                periods[0] * affine.basis[0][axis] + periods[1] * affine.basis[1][axis]
            });
            let at = nalgebra::Vector3::new(1.0, place[0] - half[0], place[1] - half[1]);
            normal += weight * at * at.transpose();
            right += weight * at * nalgebra::RowVector2::new(shift[0], shift[1]);
        }
    }
    let Some(fit) = normal.lu().solve(&right) else { return affine.clone() };
    let stretch =
        |v: [f64; 2]| [0, 1].map(|axis| v[axis] + v[0] * fit[(1, axis)] + v[1] * fit[(2, axis)]);
    // The constant term is not applied, because phases are relative to the middle block.
    let from_middle = [affine.origin[0] - half[0], affine.origin[1] - half[1]];
    let origin = [0, 1].map(|axis| {
        affine.origin[axis] + from_middle[0] * fit[(1, axis)] + from_middle[1] * fit[(2, axis)]
    });
    Affine { origin, basis: affine.basis.map(stretch) }
}

/// Fourier components Σ w I exp(−2πi g·(x − x₀)) of a square block at both reciprocal vectors g, with a Hann
/// window w and the lattice's origin x₀.
fn block_phases(image: &WhiteImage, affine: &Affine, centre: [f64; 2], side: f64) -> [[f64; 2]; 2] {
    let reciprocal = affine.reciprocal();
    let span = |axis: usize, pixels: usize| {
        let first = (centre[axis] - side / 2.0).ceil().max(0.0) as usize;
        first..((centre[axis] + side / 2.0).floor().max(0.0) as usize + 1).min(pixels)
    };
    let hann = |from_centre: f64| (std::f64::consts::PI * from_centre / side).cos().powi(2);
    let mut sums = [[0.0; 2]; 2];
    for row in span(1, image.rows()) {
        let down = hann(row as f64 - centre[1]);
        for column in span(0, image.columns()) {
            let light = image.at(column, row) * down * hann(column as f64 - centre[0]);
            let from = [column as f64 - affine.origin[0], row as f64 - affine.origin[1]];
            for (sum, wave) in sums.iter_mut().zip(reciprocal) {
                let (sine, cosine) = (-TAU * (wave[0] * from[0] + wave[1] * from[1])).sin_cos();
                *sum = [sum[0] + light * cosine, sum[1] + light * sine];
            }
        }
    }
    sums
}

/// Product of a and the complex conjugate of b.
fn conjugate_product(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] * b[0] + a[1] * b[1], a[1] * b[0] - a[0] * b[1]]
}
