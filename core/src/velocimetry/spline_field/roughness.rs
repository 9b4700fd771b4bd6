//! How rough the field is about each place: the penalties of its third differences.
//!
//! A third difference d along an axis has the prior variance τ², and a penalty λ of it costs λ d². λ about a
//! place is what restricted likelihood asks for (MacKay, Neural Comput. 4, 1992; for penalties of several
//! kinds Wood and Fasiolo, Biometrics 73, 2017):
//!
//! ```text
//! λ = (λ ⟨d²⟩ under the prior  −  λ · variance of d's error) / (d of the field)²,  means about the place
//! ```
//!
//! Above is what the samples have told of d, in differences: 0 where they say nothing, so that a field that is
//! smooth for want of samples is not taken for a smooth flow.

use std::f64::consts::PI;

use super::{
    super::differences::Layout,
    lanes::{LANES, Lane},
};

/// Differences about a place on either side along every axis that tell how rough the field is there.
const REACH: usize = 2;

/// All of the field's count about each place as so many differences more.
const SHARED: f32 = 6.0;

/// A third difference that is not told from zero, in voxels.
const RESOLUTION_VOX: f32 = 2e-4;

/// Least part of a difference's prior variance that samples are taken to have told.
const LEAST_KNOWN: f32 = 0.02;

/// Largest change of a penalty in a step.
const LARGEST_FACTOR: f32 = 10.0;

/// Wave numbers along an axis that shares of the prior are means over.
const WAVES: usize = 4;

/// Penalties of one component's third differences along x, y, z, by their first coefficient.
pub type Stiffness = [Vec<f32>; 3];

/// The same penalty everywhere, of differences with standard deviation `difference_vox`.
pub fn even(layout: Layout, difference_vox: f32) -> Stiffness {
    let stiffness = 1.0 / (3.0 * difference_vox * difference_vox);
    std::array::from_fn(|axis| {
        let of = |n| if layout.starts(axis, n) { stiffness } else { 0.0 };
        (0..layout.len()).map(of).collect()
    })
}

/// One step of the iteration for a component whose field is lane 0 and whose errors are drawn in the others.
pub fn updated(layout: Layout, stiffness: &Stiffness, field: &[Lane]) -> Stiffness {
    let squares: [[Vec<f32>; 2]; 3] =
        std::array::from_fn(|axis| local_squares(layout, axis, field));
    let mut updated = stiffness.clone();
    for n in 0..layout.len() {
        let here: [f32; 3] = std::array::from_fn(|axis| stiffness[axis][n]);
        let shares = shares(here);
        for axis in 0..3 {
            if here[axis] > 0.0 {
                let [own, errors] = [0, 1].map(|part| squares[axis][part][n]);
                let share = shares[axis];
                let known = (share - here[axis] * errors).max(LEAST_KNOWN * share);
                let factor = known / (here[axis] * (own + RESOLUTION_VOX * RESOLUTION_VOX));
                updated[axis][n] = here[axis] * factor.clamp(1.0 / LARGEST_FACTOR, LARGEST_FACTOR);
            }
        }
    }
    updated
}

/// λ ⟨d²⟩ along x, y, z under the prior of penalties λ: each wave has its prior variance from all three. They
/// sum to 1, the one coefficient that comes with every three differences.
fn shares(stiffness: [f32; 3]) -> [f32; 3] {
    let largest = stiffness.iter().fold(0.0, |a: f32, b| a.max(*b));
    if largest == 0.0 {
        return [0.0; 3];
    }
    let relative = stiffness.map(|s| s / largest);
    let (mut sums, waves) = ([0.0f32; 3], squares_of_waves());
    for z in waves {
        for y in waves {
            for x in waves {
                let parts = [relative[0] * x, relative[1] * y, relative[2] * z];
                let scale = 1.0 / (parts[0] + parts[1] + parts[2]);
                for (sum, part) in sums.iter_mut().zip(parts) {
                    *sum += part * scale;
                }
            }
        }
    }
    sums.map(|sum| sum / WAVES.pow(3) as f32)
}

/// (2 sin k/2)⁶, the square of a wave's third difference.
fn squares_of_waves() -> [f32; WAVES] {
    std::array::from_fn(|n| {
        let k = (n as f64 + 0.5) * PI / WAVES as f64;
        (2.0 * (k / 2.0).sin()).powi(6) as f32
    })
}

/// Mean about each place of the square of the third differences along `axis` of the field, and of those of
/// its errors.
fn local_squares(layout: Layout, axis: usize, field: &[Lane]) -> [Vec<f32>; 2] {
    let s = layout.stride(axis);
    let mut squares = [vec![0.0f32; field.len()], vec![0.0f32; field.len()]];
    let mut counts = vec![0.0f32; field.len()];
    for n in (0..field.len()).filter(|&n| layout.starts(axis, n)) {
        let mut parts = [0.0f32; LANES];
        for l in 0..LANES {
            let d =
                field[n + 3 * s][l] - field[n][l] + 3.0 * (field[n + s][l] - field[n + 2 * s][l]);
            parts[l] = d * d;
        }
        let [own, errors @ ..] = parts;
        squares[0][n] = own;
        squares[1][n] = errors.iter().sum::<f32>() / (LANES - 1) as f32;
        counts[n] = 1.0;
    }
    let all = counts.iter().sum::<f32>().max(1.0);
    sums_within(layout, REACH, &mut counts);
    squares.map(|mut squares| {
        let mean = squares.iter().map(|s| f64::from(*s)).sum::<f64>() as f32 / all;
        sums_within(layout, REACH, &mut squares);
        let about = |(square, count): (f32, &f32)| (square + SHARED * mean) / (count + SHARED);
        squares.into_iter().zip(&counts).map(about).collect()
    })
}

/// Every value replaced by the sum of those within `reach` nodes along each axis.
pub fn sums_within(layout: Layout, reach: usize, values: &mut [f32]) {
    for axis in 0..3 {
        let (s, count) = (layout.stride(axis), layout.nodes[axis]);
        let mut row = vec![0.0; count];
        for start in (0..values.len()).filter(|n| n / s % count == 0) {
            for (i, entry) in row.iter_mut().enumerate() {
                *entry = values[start + i * s];
            }
            for i in 0..count {
                let (low, high) = (i.saturating_sub(reach), (i + reach).min(count - 1));
                values[start + i * s] = row[low..=high].iter().sum();
            }
        }
    }
}
