//! Spectra from two-point covariances.

use std::f64::consts::PI;

use rustfft::{FftPlanner, num_complex::Complex};
use serde::{Deserialize, Serialize};

use super::Correlation;

/// One-dimensional, one-sided spectra along an axis. Their integral over the wavenumber is the variance (Pope 2000,
/// equation 6.206).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Spectrum {
    /// Axis; 0 is x.
    pub axis: usize,
    /// Wavenumbers from 0 to π/spacing, in rad/mm.
    pub wavenumber_rad_mm: Vec<f64>,
    /// Spectral energy density of u, v, w, in m²/s² per rad/mm.
    pub energy_m2_s2_mm: Vec<[f64; 3]>,
}

/// Fourier transform of the covariance with a Bartlett window (Blackman-Tukey method). In contrast to a
/// transform of the velocities, it does not need lines without gaps.
pub(super) fn spectrum(correlation: &Correlation) -> Spectrum {
    let lags = correlation.covariance_m2_s2.len();
    if lags < 2 {
        let (wavenumber_rad_mm, energy_m2_s2_mm) = (Vec::new(), Vec::new());
        return Spectrum { axis: correlation.axis, wavenumber_rad_mm, energy_m2_s2_mm };
    }
    let spacing_mm = correlation.separation_mm[1] - correlation.separation_mm[0];
    // Even periodic extension of the covariance: lags 0, 1, ..., n − 1, zero, n − 1, ..., 1.
    let period = 2 * lags;
    let fft = FftPlanner::<f64>::new().plan_fft_forward(period);
    let bins = lags + 1;
    let mut energy = vec![[0.0; 3]; bins];
    for c in 0..3 {
        let mut even = vec![Complex::default(); period];
        for (lag, covariance) in correlation.covariance_m2_s2.iter().enumerate() {
            let tapered = covariance[c] * window(lag, lags);
            even[lag].re = tapered;
            even[(period - lag) % period].re = tapered;
        }
        fft.process(&mut even);
        for (energy, value) in energy.iter_mut().zip(&even) {
            energy[c] = value.re * spacing_mm / PI;
        }
    }
    let step = 2.0 * PI / (period as f64 * spacing_mm);
    let wavenumber_rad_mm = (0..bins).map(|bin| bin as f64 * step).collect();
    Spectrum { axis: correlation.axis, wavenumber_rad_mm, energy_m2_s2_mm: energy }
}

/// The Bartlett window.
pub(super) fn window(lag: usize, lags: usize) -> f64 {
    1.0 - lag as f64 / lags as f64
}
