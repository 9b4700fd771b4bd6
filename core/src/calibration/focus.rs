//! Distance of an object from the plane in focus, from one image of it.

use std::f64::consts::TAU;

use lfpiv_hw::Optics;
use rayon::prelude::*;
use rustfft::num_complex::Complex;

use super::{WhiteImage, fourier::transform};
use crate::{
    lightfield::{GridSampling, MicroImageGrid},
    model::EquivalentPoint,
    parabola,
};

/// Number of tested slopes on either side of zero.
const SLOPES: i32 = 40;

/// Largest tested slope: 15 mm from the plane in focus at 200 mm and f/4.
const STEEPEST: f64 = 0.08;

/// Radius of the used views as a share of the pupil's radius: outer views are cut by the rim.
const PUPIL_SHARE: f64 = 0.85;

/// Least ratio of the power in focus to the mean power over all slopes.
const LEAST_CONTRAST: f64 = 1.2;

/// Least ratio of the power in focus to that of identical views; below it, the image is noise.
const LEAST_COHERENCE: f64 = 0.05;

/// Least frequency, in cycles over the image. Illumination and vignetting have lower ones. They have no
/// parallax and would favour the plane in focus.
const LEAST_CYCLES: f64 = 3.0;

/// Largest frequency, in cycles per microlens: higher ones are aliased by the microlenses.
const MOST_CYCLES_PER_LENS: f64 = 0.3;

/// Iterations of the slope with windows that move with the object.
const ROUNDS: usize = 3;

/// Position of an object relative to the plane in focus.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Focus {
    /// Distance from the plane in focus towards the camera, in air, in mm: from the parallax along columns and
    /// along rows.
    pub depth_mm: [f64; 2],
    /// Power of the refocused image at this depth, relative to the mean over all tested depths.
    pub contrast: f64,
}

/// Refocuses an image by shift-and-add of its views, and returns the depth with the highest contrast.
///
/// `image` shows a structured object, a card or lit particles, in one plane perpendicular to the axis. An optional
/// `white` image corrects the light distribution of the micro-images. `None` if no depth has a distinct maximum of
/// contrast.
///
/// Views are shifted by Fourier phases. Spatial interpolation (Ng 2005) reduces the contrast of shifts by fractions
/// of a microlens, which biases the depth towards the plane in focus.
pub fn focus(
    optics: &Optics,
    grid: &MicroImageGrid,
    image: &WhiteImage,
    white: Option<&WhiteImage>,
) -> Option<Focus> {
    let views = views(optics, grid, image, white);
    let lenses_per_slope = 1.0 / optics.microlens.pitch_mm;
    let spectra = |slopes: [f64; 2]| {
        Spectra::new(&views, grid.microlenses, slopes.map(|s| s * lenses_per_slope))
    };
    let power = |spectra: &Spectra, slopes: [f64; 2]| {
        spectra.power_in_focus(slopes.map(|slope| slope * lenses_per_slope))
    };
    let unshifted = spectra([0.0; 2]);
    let Sharpest { slope: common, contrast } = sharpest(|slope| power(&unshifted, [slope; 2]))?;
    if power(&unshifted, [common; 2])
        < LEAST_COHERENCE * views.len() as f64 * unshifted.power_of_each()
    {
        return None;
    }
    // Columns and rows separately: they differ for an inclined object and behind a tilted wall.
    let slope_of = |found: Option<Sharpest>| found.map_or(common, |found| found.slope);
    let columns = slope_of(sharpest(|slope| power(&unshifted, [slope, common])));
    let mut slopes = [columns, slope_of(sharpest(|slope| power(&unshifted, [columns, slope])))];
    for _ in 0..ROUNDS {
        let shifted = spectra(slopes);
        slopes[0] += correction(|by| power(&shifted, [slopes[0] + by, slopes[1]]));
        slopes[1] += correction(|by| power(&shifted, [slopes[0], slopes[1] + by]));
    }
    let EquivalentPoint { depth_mm, .. } = EquivalentPoint::of_rays(optics, [0.0; 2], slopes);
    Some(Focus { depth_mm, contrast })
}

/// Step of the tested slopes.
const STEP: f64 = STEEPEST / SLOPES as f64;

/// The slope of maximum power, and that power relative to the mean.
struct Sharpest {
    slope: f64,
    contrast: f64,
}

/// Tests all slopes. `None` without a distinct maximum.
fn sharpest(power: impl Fn(f64) -> f64 + Sync) -> Option<Sharpest> {
    let slopes: Vec<f64> = (-SLOPES..=SLOPES).map(|n| f64::from(n) * STEP).collect();
    let powers: Vec<f64> = slopes.par_iter().map(|&slope| power(slope)).collect();
    // The maximum must not be at an end: few views overlap at the steepest slopes, where noise raises the power.
    let is_top = |&n: &usize| powers[n] >= powers[n - 1] && powers[n] >= powers[n + 1];
    let best =
        (1..powers.len() - 1).filter(is_top).max_by(|&a, &b| powers[a].total_cmp(&powers[b]))?;
    let mean = powers.iter().sum::<f64>() / powers.len() as f64;
    (powers[best] > LEAST_CONTRAST * mean)
        .then(|| Sharpest { slope: slopes[best], contrast: powers[best] / mean })
}

/// Correction of a slope by a parabola through the powers a step below, at and a step above it.
fn correction(power: impl Fn(f64) -> f64) -> f64 {
    STEP * parabola::maximum([-STEP, 0.0, STEP].map(power))
}

/// One view: its position on the pupil, in mm, and the light of every microlens relative to the view's mean; NaN
/// for microlenses without a pixel.
struct View {
    pupil_mm: [f64; 2],
    light: Vec<f32>,
}

fn views(
    optics: &Optics,
    grid: &MicroImageGrid,
    image: &WhiteImage,
    white: Option<&WhiteImage>,
) -> Vec<View> {
    let sampling = GridSampling::new(optics, grid);
    let [columns, rows] = grid.microlenses;
    let radius_mm = PUPIL_SHARE * optics.pupil_diameter_mm() / 2.0;
    let cell_mm = optics.pupil_cell_mm();
    let reach = (radius_mm / cell_mm).floor() as i32;
    let inside = |&(k, l): &(i32, i32)| f64::from(k).hypot(f64::from(l)) * cell_mm <= radius_mm;
    let all: Vec<(i32, i32)> = (-reach..=reach)
        .flat_map(|k| (-reach..=reach).map(move |l| (k, l)))
        .filter(inside)
        .collect();
    all.par_iter()
        .map(|&(k, l)| {
            let light: Vec<f32> = (0..columns * rows)
                .map(|lens| {
                    let pixel = sampling.pixel((k, l), lens % columns, lens / columns);
                    pixel.map_or(f32::NAN, |[column, row]| {
                        let n = row * image.columns() + column;
                        let seen = image.light()[n];
                        white.map_or(seen, |white| seen / white.light()[n].max(1.0))
                    })
                })
                .collect();
            let lit = light.iter().filter(|light| light.is_finite());
            let (sum, count) =
                lit.fold((0.0f64, 0.0f64), |(sum, n), &x| (sum + f64::from(x), n + 1.0));
            let mean = (sum / count.max(1.0)).max(1e-6) as f32;
            View {
                pupil_mm: [f64::from(k) * cell_mm, f64::from(l) * cell_mm],
                light: light.into_iter().map(|light| light / mean).collect(),
            }
        })
        .collect()
}

/// Fourier amplitudes of all views in the used range of frequencies.
struct Spectra {
    /// Positions of the views on the pupil, in mm.
    pupil_mm: Vec<[f64; 2]>,
    /// Frequencies along columns and rows, in cycles per `edge` microlenses, for one half-plane: the other half is
    /// its conjugate.
    cycles: Vec<[i32; 2]>,
    edge: usize,
    /// By view, then by frequency.
    amplitudes: Vec<Vec<Complex<f64>>>,
}

impl Spectra {
    /// Transforms the views with a Hann window that is shifted by `per_mm` microlenses per mm on the pupil, so that
    /// it selects the same part of the object in all views.
    fn new(views: &[View], [columns, rows]: [usize; 2], per_mm: [f64; 2]) -> Self {
        let edge = columns.max(rows);
        let signed = |n: usize| if 2 * n > edge { n as i32 - edge as i32 } else { n as i32 };
        let all = (0..edge * edge).map(|n| (n, [n % edge, n / edge].map(signed)));
        let least = LEAST_CYCLES * edge as f64 / columns.min(rows) as f64;
        let counts = |&(_, [along_i, along_j]): &(usize, [i32; 2])| {
            let length = f64::from(along_i).hypot(f64::from(along_j));
            (along_i > 0 || (along_i == 0 && along_j > 0))
                && (least..=MOST_CYCLES_PER_LENS * edge as f64).contains(&length)
        };
        let kept: Vec<(usize, [i32; 2])> = all.filter(counts).collect();
        let amplitudes = views
            .par_iter()
            .map(|view| {
                let shift = [0, 1].map(|axis| per_mm[axis] * view.pupil_mm[axis]);
                let mut values = windowed(view, [columns, rows], shift, edge);
                transform(&mut values, edge);
                kept.iter().map(|&(n, _)| values[n]).collect()
            })
            .collect();
        Self {
            pupil_mm: views.iter().map(|view| view.pupil_mm).collect(),
            cycles: kept.iter().map(|&(_, cycles)| cycles).collect(),
            edge,
            amplitudes,
        }
    }

    /// Sum of the powers of the single views. The sum of n identical views has n times this power, and the sum of
    /// uncorrelated noise has this power.
    fn power_of_each(&self) -> f64 {
        self.amplitudes.iter().flatten().map(Complex::norm_sqr).sum()
    }

    /// Power of the sum of all views, each shifted by its position on the pupil times `per_mm`, in microlenses per
    /// mm.
    fn power_in_focus(&self, per_mm: [f64; 2]) -> f64 {
        let most = self.edge as i32 / 2;
        let turn =
            |n: i32, lenses: f64| Complex::cis(TAU * f64::from(n) * lenses / self.edge as f64);
        let mut sums = vec![Complex::<f64>::ZERO; self.cycles.len()];
        for (pupil_mm, amplitudes) in self.pupil_mm.iter().zip(&self.amplitudes) {
            let turns = [0, 1].map(|axis| -> Vec<Complex<f64>> {
                (-most..=most).map(|n| turn(n, per_mm[axis] * pupil_mm[axis])).collect()
            });
            for ((sum, amplitude), cycles) in sums.iter_mut().zip(amplitudes).zip(&self.cycles) {
                let [along_i, along_j] =
                    [0, 1].map(|axis| turns[axis][(cycles[axis] + most) as usize]);
                *sum += amplitude * along_i * along_j;
            }
        }
        sums.iter().map(Complex::norm_sqr).sum()
    }
}

/// A view minus its mean, times a Hann window shifted by `shift` microlenses, zero-padded to a square.
fn windowed(
    view: &View,
    [columns, rows]: [usize; 2],
    shift: [f64; 2],
    edge: usize,
) -> Vec<Complex<f64>> {
    let hann = |place: f64, length: usize| {
        let share = (place + 0.5) / length as f64;
        if (0.0..=1.0).contains(&share) { (0.5 * TAU * share).sin().powi(2) } else { 0.0 }
    };
    let along = |length: usize, shift: f64| -> Vec<f64> {
        (0..length).map(|n| hann(n as f64 - shift, length)).collect()
    };
    let (by_column, by_row) = (along(columns, shift[0]), along(rows, shift[1]));
    let weight = |lens: usize| by_column[lens % columns] * by_row[lens / columns];
    let seen = || view.light.iter().enumerate().filter(|(_, light)| light.is_finite());
    let (sum, weights) = seen().fold((0.0, 0.0), |(sum, weights), (lens, &light)| {
        (sum + weight(lens) * f64::from(light), weights + weight(lens))
    });
    let mean = sum / f64::max(weights, f64::MIN_POSITIVE);
    let mut values = vec![Complex::ZERO; edge * edge];
    for (lens, &light) in seen() {
        let at = lens / columns * edge + lens % columns;
        values[at] = Complex::from(weight(lens) * (f64::from(light) - mean));
    }
    values
}

#[cfg(test)]
mod tests {
    use lfpiv_hw::{
        RawImage,
        card::{Card, Pattern},
    };
    use lfpiv_sim::{
        SensorSettings,
        imaging::{CameraFlaws, PlacedCard, RaySettings, RayTracer},
    };
    use nalgebra::{Point3, Vector3};

    use super::*;
    use crate::test_bench;

    /// The distance of a card perpendicular to the axis is found on both sides of the plane in focus, with a
    /// rotated array.
    #[test]
    fn the_distance_of_a_card_is_found() {
        let mut optics = test_bench::optics();
        (optics.microlens.columns, optics.microlens.rows) = (41, 33);
        (optics.sensor.columns, optics.sensor.rows) = (752, 608);
        let flaws = CameraFlaws { array_rotation_deg: 0.5, ..CameraFlaws::default() };
        let settings = RaySettings { rays_per_particle: 1, diffraction_nm: None };
        let pose = &test_bench::poses()[0];
        let tracer = RayTracer::imperfect(&optics, pose, [0.0; 3], &flaws, &settings);
        let lfpiv_sim::TrueMicroImageGrid { microlenses, column_px, row_px } =
            tracer.micro_image_grid();
        let grid = MicroImageGrid { microlenses, column_px, row_px };
        let card = Card {
            pattern: Pattern::Dots,
            spacing_mm: 0.9,
            dot_diameter_mm: 0.45,
            fiducial_diameter_mm: 0.6,
            marks: [7, 7],
            right: Vector3::x(),
            up: Vector3::y(),
            two_sided_mm: None,
        };
        let image = |depth_mm: f64| {
            let origin_mm = Point3::new(0.1, 0.2, depth_mm);
            let placed = PlacedCard { card: &card, origin_mm, bend_mm: [0.0; 3] };
            let light = tracer.trace_card(&placed, 1 << 12, 2000.0, &[1]).unwrap();
            let image: RawImage = SensorSettings::default().expose(&light, &[2]);
            WhiteImage::average(&[image], &[]).unwrap()
        };
        let diffuser = tracer.trace_white(1 << 12, 2000.0, &[3]);
        let grey: RawImage = SensorSettings::default().expose(&diffuser, &[4]);
        let found = focus(&optics, &grid, &WhiteImage::average(&[grey], &[]).unwrap(), None);
        assert!(found.is_none(), "{found:?} in a diffuser");
        for depth_mm in [-3.0, -0.4, 0.0, 1.3, 4.0] {
            let found = focus(&optics, &grid, &image(depth_mm), None).unwrap();
            for depth in found.depth_mm {
                assert!((depth - depth_mm).abs() < 0.1, "{found:?} at {depth_mm}");
            }
        }
    }
}
