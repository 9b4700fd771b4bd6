//! Two-point correlations and spectra.

use std::f64::consts::PI;

use super::{
    spectrum::window,
    turbulence::{Turbulence, normal},
    *,
};

/// Summed products and degrees of freedom of two nodes, by two passes over the shots with both samples.
fn naive(snapshots: &[Snapshot], places: [usize; 2], c: usize) -> Option<(f64, f64)> {
    let both = snapshots.iter().filter_map(|snapshot| {
        let [first, second] = places.map(|place| snapshot.samples[place]);
        Some((first?.velocity_m_s[c], second?.velocity_m_s[c]))
    });
    let both: Vec<(f64, f64)> = both.collect();
    let n = both.len() as f64;
    let (a, b) = both.iter().fold((0.0, 0.0), |(a, b), pair| (a + pair.0 / n, b + pair.1 / n));
    (both.len() > 1).then(|| (both.iter().map(|pair| (pair.0 - a) * (pair.1 - b)).sum(), n - 1.0))
}

#[test]
fn covariances_are_those_of_the_pairs_that_were_measured() {
    let vectors = [5, 3, 2];
    let snapshots = snapshots(vectors, 40, 11);
    let found = ensemble(vectors, &snapshots).correlations();
    let strides = [1, 5, 15];
    let noise = |c: usize| {
        let all = snapshots.iter().flat_map(|s| s.samples.iter().flatten());
        let squares: Vec<f64> = all.map(|sample| sample.uncertainty_m_s[c].powi(2)).collect();
        squares.iter().sum::<f64>() / squares.len() as f64
    };
    for axis in 0..3 {
        for lag in 0..vectors[axis] {
            for c in 0..3 {
                let (mut sum, mut weight) = (0.0, 0.0);
                for place in 0..30 {
                    if place / strides[axis] % vectors[axis] + lag < vectors[axis] {
                        let other = place + lag * strides[axis];
                        let (products, degrees) = naive(&snapshots, [place, other], c).unwrap();
                        sum += products - if lag == 0 { noise(c) * degrees } else { 0.0 };
                        weight += degrees;
                    }
                }
                let covariance = found[axis].covariance_m2_s2[lag][c];
                assert_near(covariance, sum / weight, 1e-10, "covariance");
            }
        }
        assert_eq!(found[axis].separation_mm[1], 0.5);
    }
}

#[test]
fn the_transform_is_the_sum_of_cosines_and_its_integral_the_variance() {
    let snapshots = snapshots([9, 1, 1], 50, 13);
    let correlation = &ensemble([9, 1, 1], &snapshots).correlations()[0];
    let spectrum = correlation.spectrum();
    let (lags, spacing) = (9, 0.5);
    for (k, energy) in spectrum.wavenumber_rad_mm.iter().zip(&spectrum.energy_m2_s2_mm) {
        for (c, energy) in energy.iter().enumerate() {
            let term = |lag: usize| {
                let twice = if lag == 0 { 1.0 } else { 2.0 };
                let covariance = correlation.covariance_m2_s2[lag][c];
                twice * window(lag, lags) * covariance * (k * lag as f64 * spacing).cos()
            };
            let expected = spacing / PI * (0..lags).map(term).sum::<f64>();
            assert_near(*energy, expected, 1e-10, "energy");
        }
    }
    let step = spectrum.wavenumber_rad_mm[1];
    for c in 0..3 {
        let energies = spectrum.energy_m2_s2_mm.iter().map(|energy| energy[c]);
        let ends = (spectrum.energy_m2_s2_mm[0][c] + spectrum.energy_m2_s2_mm[9][c]) / 2.0;
        let integral = step * (energies.sum::<f64>() - ends);
        assert_near(integral, correlation.covariance_m2_s2[0][c], 1e-10, "variance");
    }
}

/// Fluctuations of one wavelength, with gaps and noise: the spectrum has its peak there, and the coefficient is a
/// cosine.
#[test]
fn a_wave_has_its_spectral_peak_at_its_wavenumber() {
    let grid = grid([32, 1, 1]);
    let wavenumber = 2.0 * PI / 4.0;
    let mut random = Pcg64Mcg::seed_from_u64(17);
    let mut ensemble = Ensemble::new(grid.clone());
    for shot in 0..400 {
        let (a, b) = (normal(&mut random), normal(&mut random));
        let samples = (0..grid.len()).map(|place| {
            let phase = wavenumber * grid.position_mm(place)[0];
            let wave = a * phase.cos() + b * phase.sin();
            let velocity_m_s = [5.0 + wave + 0.3 * normal(&mut random), 0.0, 0.0];
            let uncertainty_m_s = [0.3, 0.1, 0.1];
            random.random_bool(0.7).then_some(Sample { velocity_m_s, uncertainty_m_s })
        });
        ensemble.add(&Snapshot { shot, samples: samples.collect() });
    }
    let correlation = &ensemble.correlations()[0];
    // The largest separations have few pairs of nodes.
    let half = correlation.separation_mm.iter().zip(&correlation.coefficient).take(16);
    for (separation, coefficient) in half {
        let expected = (wavenumber * separation).cos();
        assert!((coefficient[0].unwrap() - expected).abs() < 0.1, "{separation} {coefficient:?}");
        assert!(coefficient[1].is_none());
    }
    let spectrum = correlation.spectrum();
    let peak = (0..spectrum.wavenumber_rad_mm.len())
        .max_by(|a, b| spectrum.energy_m2_s2_mm[*a][0].total_cmp(&spectrum.energy_m2_s2_mm[*b][0]))
        .unwrap();
    let found = spectrum.wavenumber_rad_mm[peak];
    assert!((found - wavenumber).abs() <= spectrum.wavenumber_rad_mm[1], "{found}");
    // The integral of a cosine up to its first zero is the wavelength over 2π.
    let scale = correlation.integral_scale_mm()[0].unwrap();
    assert!((scale - 1.0 / wavenumber).abs() < 0.1 / wavenumber, "{scale}");
}

/// A steady flow with errors that are correlated between neighbours: without a limit the coefficient would be far
/// above 1.
#[test]
fn correlated_errors_are_not_attributed_to_the_flow() {
    let grid = grid([12, 1, 1]);
    for (fluctuation, is_flow) in [(0.05, false), (0.5, true)] {
        let mut random = Pcg64Mcg::seed_from_u64(23);
        let mut ensemble = Ensemble::new(grid.clone());
        for shot in 0..200 {
            let all = fluctuation * normal(&mut random);
            let errors: Vec<f64> = (0..=grid.len()).map(|_| normal(&mut random)).collect();
            let samples = errors.windows(2).map(|pair| {
                let velocity_m_s = [5.0 + all + 0.2 * (pair[0] + pair[1]) / 2f64.sqrt(); 3];
                Some(Sample { velocity_m_s, uncertainty_m_s: [0.2; 3] })
            });
            ensemble.add(&Snapshot { shot, samples: samples.collect() });
        }
        let correlation = &ensemble.correlations()[0];
        let coefficients = || correlation.coefficient.iter().map(|lag| lag[0]);
        assert_eq!(coefficients().all(|c| c.is_some()), is_flow, "{correlation:?}");
        assert!(coefficients().flatten().all(|c| (0.5..1.2).contains(&c)), "{correlation:?}");
        assert_eq!(correlation.integral_scale_mm()[0].is_some(), is_flow);
    }
}

/// A turbulent flow without intermittency, whose covariance is known.
#[test]
fn correlations_of_a_turbulent_flow_are_the_true_ones() {
    let grid = grid([16, 2, 2]);
    let flow = Turbulence::new(&grid, 3);
    let mut random = Pcg64Mcg::seed_from_u64(23);
    let mut ensemble = Ensemble::new(grid.clone());
    for shot in 0..1500 {
        let exact = |velocity_m_s| Some(Sample { velocity_m_s, uncertainty_m_s: [0.0; 3] });
        let samples = flow.turbulent(&mut random).into_iter().map(exact).collect();
        ensemble.add(&Snapshot { shot, samples });
    }
    let found = &ensemble.correlations()[0];
    for (separation, covariance) in found.separation_mm.iter().zip(&found.covariance_m2_s2) {
        for (c, covariance) in covariance.iter().enumerate() {
            let variance = flow.correlation(c, [0.0; 3]);
            let expected = flow.correlation(c, [*separation, 0.0, 0.0]);
            // Five standard errors of a correlation from 1500 shots.
            assert!((covariance - expected).abs() < 0.13 * variance, "{separation} {c}");
        }
    }
}
