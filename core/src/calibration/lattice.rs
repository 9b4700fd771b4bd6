//! Pitch and angle of an unknown microlens array, by autocorrelation.

use rustfft::num_complex::Complex;

use super::{WhiteImage, fourier::transform};
use crate::parabola;

/// Largest edge of the evaluated square in the middle of the image, in pixels: it contains some tens of
/// micro-images and is far from vignetted edges.
const LARGEST_EDGE: usize = 1024;

/// Variations with fewer cycles over the square are shading, not micro-images.
const SHADING_CYCLES: usize = 4;

/// Least standard deviation of the light, relative to its mean.
const LEAST_CONTRAST: f64 = 1e-3;

/// Least height of a lattice peak, relative to the highest peak away from the origin.
const LEAST_PEAK: f64 = 0.6;

/// Least height of the highest peak away from the origin, relative to the origin, for a periodic image.
const LEAST_REPETITION: f64 = 0.25;

/// Least sine of the angle between two vectors that span the lattice.
const LEAST_SINE: f64 = 0.3;

/// Two lattice vectors, each along columns (right) and rows (down), in pixels.
pub(super) type Basis = [[f64; 2]; 2];

/// The lattice vectors along i (most nearly to the right) and along j (upwards). `None` if the image is not
/// periodic.
pub(super) fn find(image: &WhiteImage) -> Option<Basis> {
    let edge = square_edge(image)?;
    let correlation = Autocorrelation::of(image, edge)?;
    let peaks = correlation.peaks();
    let highest = peaks.iter().map(|peak| peak.height).fold(0.0, f64::max);
    if highest < LEAST_REPETITION {
        return None;
    }
    let mut near: Vec<&Peak> =
        peaks.iter().filter(|peak| peak.height >= LEAST_PEAK * highest).collect();
    near.sort_by(|a, b| length(a.lag).total_cmp(&length(b.lag)));
    let first = near.first()?.lag;
    let second = near
        .iter()
        .map(|peak| peak.lag)
        .find(|&lag| cross(first, lag).abs() > LEAST_SINE * length(first) * length(lag))?;
    let basis = orient(reduce([first, second]));
    Some(orient(basis.map(|vector| correlation.refine(vector))))
}

fn square_edge(image: &WhiteImage) -> Option<usize> {
    let smaller = image.columns().min(image.rows());
    let edge = 1 << smaller.checked_ilog2()?;
    (edge >= 32).then_some(edge.min(LARGEST_EDGE))
}

fn length([x, y]: [f64; 2]) -> f64 {
    x.hypot(y)
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// The two shortest vectors that span the same lattice (Lagrange-Gauss reduction).
fn reduce([mut short, mut long]: Basis) -> Basis {
    for _ in 0..16 {
        if length(long) < length(short) {
            std::mem::swap(&mut short, &mut long);
        }
        let times = (dot(short, long) / dot(short, short)).round();
        if times == 0.0 {
            break;
        }
        long = [0, 1].map(|axis| long[axis] - times * short[axis]);
    }
    [short, long]
}

/// Orders the vectors: i is the one closest to the rightward direction; j points upwards, at 60° to i in a
/// hexagonal array.
fn orient([a, b]: Basis) -> Basis {
    let minus = |v: [f64; 2]| [-v[0], -v[1]];
    let difference = [a[0] - b[0], a[1] - b[1]];
    let sum = [a[0] + b[0], a[1] + b[1]];
    let shortest = length(a).min(length(b));
    // A hexagonal array has three directions of neighbours.
    let third = if length(difference) < length(sum) { difference } else { sum };
    let mut directions = vec![a, b];
    if length(third) < 1.2 * shortest {
        directions.push(third);
    }
    let inclination = |v: &[f64; 2]| v[1].abs() / length(*v);
    directions.sort_by(|a, b| inclination(a).total_cmp(&inclination(b)));
    let i = if directions[0][0] < 0.0 { minus(directions[0]) } else { directions[0] };
    // Rows are counted downwards, so an upward j has cross(i, j) < 0.
    let others = directions[1..].iter().map(|&v| if cross(i, v) > 0.0 { minus(v) } else { v });
    let j = others.max_by(|a, b| dot(i, *a).total_cmp(&dot(i, *b)));
    [i, j.unwrap_or(b)]
}

struct Peak {
    lag: [f64; 2],
    height: f64,
}

/// Autocorrelation of the middle of the image by lag, normalised to 1 at the origin.
struct Autocorrelation {
    values: Vec<f64>,
    edge: usize,
}

impl Autocorrelation {
    fn of(image: &WhiteImage, edge: usize) -> Option<Self> {
        let first = [image.columns(), image.rows()].map(|pixels| (pixels - edge) / 2);
        let window: Vec<f64> = (0..edge)
            .map(|n| (std::f64::consts::PI * (n as f64 + 0.5) / edge as f64).sin().powi(2))
            .collect();
        let weight = |n: usize| window[n / edge] * window[n % edge];
        let light = |n: usize| image.at(first[0] + n % edge, first[1] + n / edge);
        let weights: f64 = (0..edge * edge).map(weight).sum();
        let mean = (0..edge * edge).map(|n| weight(n) * light(n)).sum::<f64>() / weights;
        let of_light = correlate(|n| weight(n) * (light(n) - mean), edge, SHADING_CYCLES);
        let of_window = correlate(weight, edge, 0);
        if of_light[0] < (LEAST_CONTRAST * mean).powi(2) * of_window[0] {
            return None;
        }
        let scale = of_window[0] / of_light[0].max(f64::MIN_POSITIVE);
        let values = of_light.iter().zip(&of_window).map(|(light, window)| {
            // Normalised by the window's own autocorrelation, which is limited where the overlap is small.
            light / window.max(0.01 * of_window[0]) * scale
        });
        Some(Self { values: values.collect(), edge })
    }

    fn at(&self, lag: [i64; 2]) -> f64 {
        let [column, row] = lag.map(|n| n.rem_euclid(self.edge as i64) as usize);
        self.values[row * self.edge + column]
    }

    /// Local maxima at lags up to a quarter of the square, on one side of the origin.
    fn peaks(&self) -> Vec<Peak> {
        let reach = self.edge as i64 / 4;
        let mut peaks = Vec::new();
        for row in 0..=reach {
            for column in -reach..=reach {
                if row == 0 && column <= 0 {
                    continue;
                }
                let here = self.at([column, row]);
                let around = (-1..=1).flat_map(|r| (-1..=1).map(move |c| [c, r]));
                if around
                    .filter(|&step| step != [0, 0])
                    .all(|[c, r]| self.at([column + c, row + r]) < here)
                {
                    peaks.push(Peak { lag: [column as f64, row as f64], height: here });
                }
            }
        }
        peaks
    }

    /// Refines a lattice vector by its multiples 2, 4, ..., whose peaks give smaller relative errors.
    fn refine(&self, vector: [f64; 2]) -> [f64; 2] {
        let reach = self.edge as f64 / 4.0;
        let mut times = 1.0;
        let mut found = self.vertex(vector);
        while 2.0 * times * length(found) < reach {
            times *= 2.0;
            found = self.vertex(found.map(|place| place * times)).map(|place| place / times);
        }
        found
    }

    /// Sub-pixel maximum near a lag: some steps of steepest ascent, then a parabola through three values per axis.
    fn vertex(&self, lag: [f64; 2]) -> [f64; 2] {
        let mut at = lag.map(|place| place.round() as i64);
        for _ in 0..4 {
            let steps = (-1..=1).flat_map(|r| (-1..=1).map(move |c| [c, r]));
            let places = steps.map(|[c, r]: [i64; 2]| [at[0] + c, at[1] + r]);
            let Some(best) = places.max_by(|a, b| self.at(*a).total_cmp(&self.at(*b))) else {
                break;
            };
            if best == at {
                break;
            }
            at = best;
        }
        [0, 1].map(|axis| {
            let beside = |step: i64| {
                let mut place = at;
                place[axis] += step;
                self.at(place)
            };
            at[axis] as f64 + parabola::maximum([beside(-1), beside(0), beside(1)])
        })
    }
}

/// The circular autocorrelation of a square image, without frequencies below `least_cycles` cycles.
fn correlate(value: impl Fn(usize) -> f64, edge: usize, least_cycles: usize) -> Vec<f64> {
    let mut values: Vec<Complex<f64>> = (0..edge * edge).map(|n| value(n).into()).collect();
    transform(&mut values, edge);
    for (n, value) in values.iter_mut().enumerate() {
        let [k, l] = [n % edge, n / edge].map(|k| k.min(edge - k));
        let kept = k.max(l) >= least_cycles;
        *value = if kept { value.norm_sqr().into() } else { Complex::ZERO };
    }
    transform(&mut values, edge);
    let scale = 1.0 / (edge * edge) as f64;
    values.iter().map(|value| value.re * scale).collect()
}
