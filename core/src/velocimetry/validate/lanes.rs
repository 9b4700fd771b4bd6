//! The normalised median test of several vectors at a time.
//!
//! Medians come from sorting networks (Batcher 1968), whose comparisons do not depend on the values
//! and so run in vector lanes, one vector of the lattice in each. What is missing is infinite and is
//! sorted to the end.

use multiversion::multiversion;

/// Vectors that are judged at a time.
pub const LANES: usize = 16;

/// One number per vector.
type Lane = [f32; LANES];

/// The components of the 3 × 3 × 3 vectors about each, infinite where one is missing; the middle one
/// counts as missing.
pub type Around = [[Lane; 27]; 3];

const MISSING: f32 = f32::INFINITY;

/// The middle of 27.
const MIDDLE: usize = 13;

/// Whether each of `own` passes; see `Candidates::passing`. Fewer than `least` neighbours say
/// nothing.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
pub fn judge(
    around: &Around,
    own: &[Lane; 3],
    threshold: f64,
    epsilon_vox: f64,
    least: usize,
) -> [bool; LANES] {
    let counts = present(&around[0]);
    let mut pass = [true; LANES];
    for (near, own) in around.iter().zip(own) {
        let spread = median_residual(near, &counts);
        let level = carried_to_centre(near);
        let middle = median::<32, 191>(&level, &counts, &NETWORK_32);
        for lane in 0..LANES {
            let residual = (own[lane] - middle[lane]).abs();
            let limit = threshold * (f64::from(spread[lane]) + epsilon_vox);
            pass[lane] &= counts[lane] < least || f64::from(residual) <= limit;
        }
    }
    pass
}

/// How many of the values are there.
#[inline(always)]
fn present(values: &[Lane]) -> [usize; LANES] {
    let mut counts = [0u32; LANES];
    for value in values {
        for lane in 0..LANES {
            counts[lane] += u32::from(value[lane] < MISSING);
        }
    }
    counts.map(|count| count as usize)
}

/// Median distance of the values from their median.
#[inline(always)]
fn median_residual(values: &[Lane; 27], counts: &[usize; LANES]) -> Lane {
    let middle = median::<32, 191>(values, counts, &NETWORK_32);
    let mut residuals = *values;
    for value in &mut residuals {
        for lane in 0..LANES {
            value[lane] = (value[lane] - middle[lane]).abs();
        }
    }
    median::<32, 191>(&residuals, counts, &NETWORK_32)
}

/// The values, each carried to the middle along their median gradient.
#[inline(always)]
fn carried_to_centre(near: &[Lane; 27]) -> [Lane; 27] {
    let gradient = [median_slope(near, 0), median_slope(near, 1), median_slope(near, 2)];
    let mut level = *near;
    for (index, value) in level.iter_mut().enumerate() {
        let (x, y, z) = (index % 3, index / 3 % 3, index / 9);
        let (x, y, z) = (x as f32 - 1.0, y as f32 - 1.0, z as f32 - 1.0);
        for lane in 0..LANES {
            let rise = 0.0 + gradient[0][lane] * x + gradient[1][lane] * y + gradient[2][lane] * z;
            value[lane] -= rise;
        }
    }
    level
}

/// Median difference of neighbours along `axis`; 0 where there are none.
#[inline(always)]
fn median_slope(near: &[Lane; 27], axis: usize) -> Lane {
    let stride = [1, 3, 9][axis];
    let mut slopes = [[MISSING; LANES]; 16];
    let low = (0..27).filter(|n| n / stride % 3 < 2 && *n != MIDDLE && n + stride != MIDDLE);
    for (slope, low) in slopes.iter_mut().zip(low) {
        let (low, high) = (&near[low], &near[low + stride]);
        for lane in 0..LANES {
            let both = low[lane] < MISSING && high[lane] < MISSING;
            slope[lane] = if both { high[lane] - low[lane] } else { MISSING };
        }
    }
    let counts = present(&slopes);
    median::<16, 63>(&slopes, &counts, &NETWORK_16)
}

/// The median of the first `counts` values in order; 0 where there are none.
#[inline(always)]
fn median<const N: usize, const M: usize>(
    values: &[Lane],
    counts: &[usize; LANES],
    network: &[(u8, u8); M],
) -> Lane {
    let mut sorted = [[MISSING; LANES]; N];
    sorted[..values.len()].copy_from_slice(values);
    for &(low, high) in network {
        let (a, b) = (sorted[low as usize], sorted[high as usize]);
        for lane in 0..LANES {
            let swap = b[lane] < a[lane];
            sorted[low as usize][lane] = if swap { b[lane] } else { a[lane] };
            sorted[high as usize][lane] = if swap { a[lane] } else { b[lane] };
        }
    }
    let mut medians = [0.0; LANES];
    for (lane, median) in medians.iter_mut().enumerate() {
        let n = counts[lane];
        if n > 0 {
            *median = (sorted[(n - 1) / 2][lane] + sorted[n / 2][lane]) / 2.0;
        }
    }
    medians
}

const NETWORK_16: [(u8, u8); 63] = odd_even_merge_sort(16);
const NETWORK_32: [(u8, u8); 191] = odd_even_merge_sort(32);

/// Batcher's odd-even merge sort of `n` values, a power of two: the pairs to be put in order.
const fn odd_even_merge_sort<const M: usize>(n: usize) -> [(u8, u8); M] {
    let mut network = [(0, 0); M];
    let mut count = 0;
    let mut merged = 1;
    while merged < n {
        let mut apart = merged;
        while apart >= 1 {
            let mut start = apart % merged;
            while start + apart < n {
                let mut i = 0;
                while i < apart && start + i + apart < n {
                    let (low, high) = (start + i, start + i + apart);
                    if low / (2 * merged) == high / (2 * merged) {
                        network[count] = (low as u8, high as u8);
                        count += 1;
                    }
                    i += 1;
                }
                start += 2 * apart;
            }
            apart /= 2;
        }
        merged *= 2;
    }
    assert!(count == M);
    network
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;

    #[test]
    fn medians_are_those_of_sorted_values() {
        let mut random = Pcg64Mcg::seed_from_u64(3);
        for _ in 0..200 {
            let values: [Lane; 27] =
                std::array::from_fn(|_| {
                    std::array::from_fn(|_| {
                        if random.random_bool(0.3) { MISSING } else { random.random() }
                    })
                });
            let found = median::<32, 191>(&values, &present(&values), &NETWORK_32);
            for (lane, found) in found.into_iter().enumerate() {
                let mut sorted: Vec<f32> =
                    values.iter().map(|v| v[lane]).filter(|v| *v < MISSING).collect();
                sorted.sort_by(f32::total_cmp);
                let n = sorted.len();
                assert_eq!(found, (sorted[(n - 1) / 2] + sorted[n / 2]) / 2.0);
            }
        }
    }
}
