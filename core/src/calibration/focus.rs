//! How far something is from the plane in focus, from one image of it.

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

/// Slopes that are tried: so many, up to this, either way. At 200 mm and f/4 the last is 15 mm off.
const SLOPES: i32 = 40;
const STEEPEST: f64 = 0.08;

/// Views out to this share of the pupil's radius are used: the rim cuts the others.
const PUPIL_SHARE: f64 = 0.85;

/// Without so much more contrast in focus than in the mean there is nothing to focus on.
const LEAST_CONTRAST: f64 = 1.2;

/// A smaller share of what all views would have together, if they showed the same, is noise.
const LEAST_COHERENCE: f64 = 0.05;

/// Coarser structure, in waves across the image, is left out: the lamp's light and vignetting do not move from
/// view to view, and would be sharpest in the plane in focus.
const LEAST_WAVES: f64 = 3.0;

/// Finer structure, in waves per microlens, is left out: microlenses alias it.
const MOST_WAVES_PER_LENS: f64 = 0.3;

/// Rounds in which the part of each view that counts follows what moves.
const ROUNDS: usize = 3;

/// Where what a camera sees stands against its plane in focus.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Focus {
    /// How far it is from the plane in focus towards the camera, in air, in mm: by what the columns and
    /// by what the rows see.
    pub depth_mm: [f64; 2],
    /// Contrast of the picture focused there, relative to the mean over all depths that were tried.
    pub contrast: f64,
}

/// Refocuses an image by shifting and adding its views, and takes the sharpest.
///
/// `image` is that of something with structure, a card or lit particles, in one plane across the axis;
/// `white`, where there is one, divides the lens' own light out. `None` where no depth is sharper than the
/// others.
///
/// Views are shifted by their Fourier phases (Ng 2005 interpolates in space): interpolation takes contrast
/// from all shifts but those by whole microlenses, and so draws what is found towards the plane in focus.
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
    let still = spectra([0.0; 2]);
    let Sharpest { slope: both, contrast } = sharpest(|slope| power(&still, [slope; 2]))?;
    if power(&still, [both; 2]) < LEAST_COHERENCE * views.len() as f64 * still.power_of_each() {
        return None;
    }
    // Columns and rows on their own: what leans or looks through a tilted wall differs between them.
    let near = |own: Option<Sharpest>| own.map_or(both, |own| own.slope);
    let columns = near(sharpest(|slope| power(&still, [slope, both])));
    let mut slopes = [columns, near(sharpest(|slope| power(&still, [columns, slope])))];
    for _ in 0..ROUNDS {
        let moved = spectra(slopes);
        slopes[0] += nearer(|by| power(&moved, [slopes[0] + by, slopes[1]]));
        slopes[1] += nearer(|by| power(&moved, [slopes[0], slopes[1] + by]));
    }
    let EquivalentPoint { depth_mm, .. } = EquivalentPoint::of_rays(optics, [0.0; 2], slopes);
    Some(Focus { depth_mm, contrast })
}

const STEP: f64 = STEEPEST / SLOPES as f64;

/// The slope of greatest power, and that power relative to the mean.
struct Sharpest {
    slope: f64,
    contrast: f64,
}

/// Tries all slopes.
fn sharpest(power: impl Fn(f64) -> f64 + Sync) -> Option<Sharpest> {
    let slopes: Vec<f64> = (-SLOPES..=SLOPES).map(|n| f64::from(n) * STEP).collect();
    let powers: Vec<f64> = slopes.par_iter().map(|&slope| power(slope)).collect();
    // Few views overlap at the steepest slopes: noise alone makes power rise towards them.
    let is_top = |&n: &usize| powers[n] >= powers[n - 1] && powers[n] >= powers[n + 1];
    let best =
        (1..powers.len() - 1).filter(is_top).max_by(|&a, &b| powers[a].total_cmp(&powers[b]))?;
    let mean = powers.iter().sum::<f64>() / powers.len() as f64;
    (powers[best] > LEAST_CONTRAST * mean)
        .then(|| Sharpest { slope: slopes[best], contrast: powers[best] / mean })
}

/// What to add to a slope: to the top of a parabola through a step less, none and a step more.
fn nearer(power: impl Fn(f64) -> f64) -> f64 {
    STEP * parabola::maximum([-STEP, 0.0, STEP].map(power))
}

/// What one view shows: where it passes the pupil, in mm, and the light of every microlens relative to
/// the view's mean; NaN where it has no pixel.
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

/// Fourier amplitudes of all views, between the coarsest and the finest structure that count.
struct Spectra {
    /// Places of the views on the pupil, in mm.
    pupil_mm: Vec<[f64; 2]>,
    /// Waves across `edge` microlenses along columns and rows, in one half of the plane: the other is its
    /// conjugate.
    waves: Vec<[i32; 2]>,
    edge: usize,
    /// By view, then by wave.
    amplitudes: Vec<Vec<Complex<f64>>>,
}

impl Spectra {
    /// Transforms the views under a Hann window that is moved like a picture of `per_mm` microlenses per
    /// mm on the pupil, so that all views show the same part of it.
    fn new(views: &[View], [columns, rows]: [usize; 2], per_mm: [f64; 2]) -> Self {
        let edge = columns.max(rows);
        let signed = |n: usize| if 2 * n > edge { n as i32 - edge as i32 } else { n as i32 };
        let all = (0..edge * edge).map(|n| (n, [n % edge, n / edge].map(signed)));
        let least = LEAST_WAVES * edge as f64 / columns.min(rows) as f64;
        let counts = |&(_, [along_i, along_j]): &(usize, [i32; 2])| {
            let length = f64::from(along_i).hypot(f64::from(along_j));
            (along_i > 0 || (along_i == 0 && along_j > 0))
                && (least..=MOST_WAVES_PER_LENS * edge as f64).contains(&length)
        };
        let kept: Vec<(usize, [i32; 2])> = all.filter(counts).collect();
        let amplitudes = views
            .par_iter()
            .map(|view| {
                let moved = [0, 1].map(|axis| per_mm[axis] * view.pupil_mm[axis]);
                let mut values = windowed(view, [columns, rows], moved, edge);
                transform(&mut values, edge);
                kept.iter().map(|&(n, _)| values[n]).collect()
            })
            .collect();
        Self {
            pupil_mm: views.iter().map(|view| view.pupil_mm).collect(),
            waves: kept.iter().map(|&(_, waves)| waves).collect(),
            edge,
            amplitudes,
        }
    }

    /// Power of all views, each for itself. Where they show the same, they have so many times that power
    /// together as there are views; noise, which differs from view to view, has this one.
    fn power_of_each(&self) -> f64 {
        self.amplitudes.iter().flatten().map(Complex::norm_sqr).sum()
    }

    /// Power of the views added up, each moved by its place on the pupil times `per_mm`, in microlenses
    /// per mm.
    fn power_in_focus(&self, per_mm: [f64; 2]) -> f64 {
        let most = self.edge as i32 / 2;
        let turn =
            |n: i32, lenses: f64| Complex::cis(TAU * f64::from(n) * lenses / self.edge as f64);
        let mut sums = vec![Complex::<f64>::ZERO; self.waves.len()];
        for (pupil_mm, amplitudes) in self.pupil_mm.iter().zip(&self.amplitudes) {
            let turns = [0, 1].map(|axis| -> Vec<Complex<f64>> {
                (-most..=most).map(|n| turn(n, per_mm[axis] * pupil_mm[axis])).collect()
            });
            for ((sum, amplitude), waves) in sums.iter_mut().zip(amplitudes).zip(&self.waves) {
                let [along_i, along_j] =
                    [0, 1].map(|axis| turns[axis][(waves[axis] + most) as usize]);
                *sum += amplitude * along_i * along_j;
            }
        }
        sums.iter().map(Complex::norm_sqr).sum()
    }
}

/// A view less its mean under a Hann window that is moved by `moved` microlenses, in a square of zeros.
fn windowed(
    view: &View,
    [columns, rows]: [usize; 2],
    moved: [f64; 2],
    edge: usize,
) -> Vec<Complex<f64>> {
    let hann = |place: f64, length: usize| {
        let share = (place + 0.5) / length as f64;
        if (0.0..=1.0).contains(&share) { (0.5 * TAU * share).sin().powi(2) } else { 0.0 }
    };
    let along = |length: usize, moved: f64| -> Vec<f64> {
        (0..length).map(|n| hann(n as f64 - moved, length)).collect()
    };
    let (by_column, by_row) = (along(columns, moved[0]), along(rows, moved[1]));
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

    /// A card across the axis is found where it stands, in front of the plane in focus and behind it, on
    /// an array that is turned.
    #[test]
    fn a_card_is_found_where_it_stands() {
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
