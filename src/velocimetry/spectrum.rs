//! Three-dimensional real Fourier transforms of cubes, and cross-correlation by them.

use std::sync::Arc;

use realfft::{ComplexToReal, RealFftPlanner, RealToComplex, num_complex::Complex};
use rustfft::{Fft, FftPlanner};

/// Plans for cubes of one size. Shared between threads; each thread brings its own [`Workspace`].
pub struct Correlator {
    n: usize,
    real: Arc<dyn RealToComplex<f32>>,
    real_inverse: Arc<dyn ComplexToReal<f32>>,
    forward: Arc<dyn Fft<f32>>,
    inverse: Arc<dyn Fft<f32>>,
}

/// Buffers for one correlation.
pub struct Workspace {
    /// First cube, then the correlation; n³ values, z, y, x.
    pub a: Vec<f32>,
    /// Second cube.
    pub b: Vec<f32>,
    spectrum_a: Vec<Complex<f32>>,
    spectrum_b: Vec<Complex<f32>>,
    turned: Vec<Complex<f32>>,
    scratch: Vec<Complex<f32>>,
}

impl Correlator {
    /// Plans for cubes of edge `n`.
    pub fn new(n: usize) -> Self {
        let mut real_planner = RealFftPlanner::new();
        let mut planner = FftPlanner::new();
        Self {
            n,
            real: real_planner.plan_fft_forward(n),
            real_inverse: real_planner.plan_fft_inverse(n),
            forward: planner.plan_fft_forward(n),
            inverse: planner.plan_fft_inverse(n),
        }
    }

    /// Edge of the cubes.
    pub fn edge(&self) -> usize {
        self.n
    }

    /// Zeroed buffers of the right size.
    pub fn workspace(&self) -> Workspace {
        let (n, half) = (self.n, self.n / 2 + 1);
        let spectrum = vec![Complex::default(); n * n * half];
        let scratch = [
            self.real.get_scratch_len(),
            self.real_inverse.get_scratch_len(),
            self.forward.get_inplace_scratch_len(),
            self.inverse.get_inplace_scratch_len(),
        ];
        Workspace {
            a: vec![0.0; n * n * n],
            b: vec![0.0; n * n * n],
            spectrum_a: spectrum.clone(),
            spectrum_b: spectrum.clone(),
            turned: spectrum,
            scratch: vec![Complex::default(); scratch.into_iter().max().unwrap_or(0)],
        }
    }

    /// Circular cross-correlation: `a[s] = Σ_x a[x] b[x + s]`, lags modulo n.
    pub fn correlate(&self, w: &mut Workspace) {
        let scratch = &mut w.scratch;
        self.transform(&mut w.a, &mut w.spectrum_a, &mut w.turned, scratch);
        self.transform(&mut w.b, &mut w.spectrum_b, &mut w.turned, scratch);
        let scale = 1.0 / (self.n * self.n * self.n) as f32;
        for (a, b) in w.spectrum_a.iter_mut().zip(&w.spectrum_b) {
            *a = a.conj() * b * scale;
        }
        self.transform_back(&mut w.spectrum_a, &mut w.a, &mut w.turned, scratch);
    }

    /// `cube` (destroyed) to its half spectrum, stored kx, ky, kz (kz fastest).
    fn transform(
        &self,
        cube: &mut [f32],
        spectrum: &mut [Complex<f32>],
        turned: &mut [Complex<f32>],
        scratch: &mut [Complex<f32>],
    ) {
        let (n, half) = (self.n, self.n / 2 + 1);
        for (row, out) in cube.chunks_exact_mut(n).zip(turned.chunks_exact_mut(half)) {
            // Lengths match the plan by construction.
            self.real.process_with_scratch(row, out, scratch).ok();
        }
        // z, y, kx -> z, kx, y
        for (from, to) in turned.chunks_exact(n * half).zip(spectrum.chunks_exact_mut(n * half)) {
            transpose(from, to, n, half);
        }
        self.forward.process_with_scratch(spectrum, scratch);
        // z, (kx, ky) -> (kx, ky), z
        transpose(spectrum, turned, n, n * half);
        self.forward.process_with_scratch(turned, scratch);
        spectrum.copy_from_slice(turned);
    }

    fn transform_back(
        &self,
        spectrum: &mut [Complex<f32>],
        cube: &mut [f32],
        turned: &mut [Complex<f32>],
        scratch: &mut [Complex<f32>],
    ) {
        let (n, half) = (self.n, self.n / 2 + 1);
        self.inverse.process_with_scratch(spectrum, scratch);
        transpose(spectrum, turned, n * half, n);
        self.inverse.process_with_scratch(turned, scratch);
        for (from, to) in turned.chunks_exact(n * half).zip(spectrum.chunks_exact_mut(n * half)) {
            transpose(from, to, half, n);
        }
        for (row, out) in spectrum.chunks_exact_mut(half).zip(cube.chunks_exact_mut(n)) {
            // Rounding leaves imaginary dust where a real spectrum has none; the transform
            // refuses it.
            row[0].im = 0.0;
            if n.is_multiple_of(2) {
                row[half - 1].im = 0.0;
            }
            self.real_inverse.process_with_scratch(row, out, scratch).ok();
        }
    }
}

/// `to[c][r] = from[r][c]`.
fn transpose<T: Copy>(from: &[T], to: &mut [T], rows: usize, columns: usize) {
    const TILE: usize = 16;
    for r0 in (0..rows).step_by(TILE) {
        for c0 in (0..columns).step_by(TILE) {
            for c in c0..(c0 + TILE).min(columns) {
                for r in r0..(r0 + TILE).min(rows) {
                    to[c * rows + r] = from[r * columns + c];
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    #[test]
    fn agrees_with_the_sum_that_defines_it() {
        let mut random = Pcg64Mcg::seed_from_u64(3);
        for n in [4, 6, 9] {
            let correlator = Correlator::new(n);
            let mut w = correlator.workspace();
            let mut cube = || -> Vec<f32> { (0..n * n * n).map(|_| random.random()).collect() };
            let (a, b) = (cube(), cube());
            w.a.copy_from_slice(&a);
            w.b.copy_from_slice(&b);
            correlator.correlate(&mut w);
            let at = |x: usize, y: usize, z: usize| ((z % n) * n + y % n) * n + x % n;
            for (s, &fast) in w.a.iter().enumerate() {
                let (sx, sy, sz) = (s % n, s / n % n, s / (n * n));
                let mut slow = 0.0f64;
                for z in 0..n {
                    for y in 0..n {
                        for x in 0..n {
                            slow += f64::from(a[at(x, y, z)] * b[at(x + sx, y + sy, z + sz)]);
                        }
                    }
                }
                assert!((f64::from(fast) - slow).abs() < 1e-4 * slow.abs(), "{n} {s}");
            }
        }
    }
}
