//! The two-dimensional Fourier transform of square images.

use rustfft::{FftPlanner, num_complex::Complex};

/// Discrete Fourier transform Σ f exp(−2πi kx/n) along both axes of an `edge` x `edge` image, in place. For an
/// even function it equals the inverse transform times n².
pub(super) fn transform(values: &mut [Complex<f64>], edge: usize) {
    let rows = FftPlanner::new().plan_fft_forward(edge);
    for _ in 0..2 {
        rows.process(values);
        transpose(values, edge);
    }
}

fn transpose(values: &mut [Complex<f64>], edge: usize) {
    for row in 0..edge {
        for column in row + 1..edge {
            values.swap(row * edge + column, column * edge + row);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_transform_equals_the_defining_sum() {
        let edge = 8;
        let place = |n: usize| Complex::new(((n * 7) % 11) as f64, ((n * 5) % 13) as f64 - 3.0);
        let mut values: Vec<Complex<f64>> = (0..edge * edge).map(place).collect();
        transform(&mut values, edge);
        for (k, found) in values.iter().enumerate() {
            let mut sum = Complex::ZERO;
            for n in 0..edge * edge {
                let turns = (n / edge) * (k / edge) + (n % edge) * (k % edge);
                let angle = -2.0 * std::f64::consts::PI * turns as f64 / edge as f64;
                sum += place(n) * Complex::cis(angle);
            }
            assert!((found - sum).norm() < 1e-9, "{k}");
        }
    }
}
