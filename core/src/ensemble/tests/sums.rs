//! Statistics compared with two-pass sums over all samples.

use super::*;

/// Samples at one node.
fn samples(snapshots: &[Snapshot], place: usize) -> Vec<Sample> {
    snapshots.iter().filter_map(|snapshot| snapshot.samples[place]).collect()
}

fn mean(numbers: impl Iterator<Item = f64> + Clone) -> f64 {
    numbers.clone().sum::<f64>() / numbers.count() as f64
}

fn naive(quantity: Quantity, samples: &[Sample]) -> f64 {
    let n = samples.len() as f64;
    let average = |c: usize| mean(samples.iter().map(|s| s.velocity_m_s[c]));
    let noise = |c: usize| mean(samples.iter().map(|s| s.uncertainty_m_s[c].powi(2)));
    let central = |c: usize, d: usize| {
        let products = samples
            .iter()
            .map(|s| (s.velocity_m_s[c] - average(c)) * (s.velocity_m_s[d] - average(d)));
        products.sum::<f64>() / (n - 1.0)
    };
    match quantity {
        Quantity::Mean(c) => average(c),
        Quantity::Rms(c) => (central(c, c) - noise(c)).sqrt(),
        Quantity::Stress(i, j) if i == j => central(i, i) - noise(i),
        Quantity::Stress(i, j) => central(i, j),
        Quantity::Skewness(c) => {
            let cubes: f64 = samples.iter().map(|s| (s.velocity_m_s[c] - average(c)).powi(3)).sum();
            cubes * n / ((n - 1.0) * (n - 2.0)) / (central(c, c) - noise(c)).powf(1.5)
        }
    }
}

#[test]
fn every_statistic_agrees_with_sums_over_samples() {
    let snapshots = snapshots([3, 2, 2], 60, 1);
    let found = ensemble([3, 2, 2], &snapshots).estimates();
    for place in 0..12 {
        let samples = samples(&snapshots, place);
        assert_eq!(found.counts[place], samples.len() as u64);
        for quantity in Quantity::ALL {
            let estimate = found.of(quantity)[place].unwrap();
            let expected = naive(quantity, &samples);
            assert_near(estimate.value, expected, 1e-10, &quantity.name());
            let [low, high] = estimate.interval_95;
            assert!(low <= estimate.value && estimate.value <= high, "{}", quantity.name());
        }
    }
}

/// With one sample per group, the result is the usual standard error of a mean.
#[test]
fn the_uncertainty_of_a_mean_is_the_scatter_over_the_root_of_the_number() {
    let snapshots = snapshots([1, 1, 1], 20, 2);
    let found = ensemble([1, 1, 1], &snapshots).estimates().of(Quantity::Mean(1))[0].unwrap();
    let samples = samples(&snapshots, 0);
    let n = samples.len() as f64;
    let average = mean(samples.iter().map(|s| s.velocity_m_s[1]));
    let squares: f64 = samples.iter().map(|s| (s.velocity_m_s[1] - average).powi(2)).sum();
    let expected = (squares / (n - 1.0) / n).sqrt();
    assert_near(found.uncertainty(), expected, 1e-10, "standard error");
    let noise = mean(samples.iter().map(|s| s.uncertainty_m_s[1].powi(2)));
    assert_near(found.measurement_uncertainty, (noise / n).sqrt(), 1e-12, "measurement's part");
}

#[test]
fn missing_and_non_finite_samples_are_not_used() {
    let good = Sample { velocity_m_s: [1.0, 2.0, 3.0], uncertainty_m_s: [0.1; 3] };
    let nan = Sample { velocity_m_s: [1.0, f64::NAN, 3.0], ..good };
    let infinite = Sample { uncertainty_m_s: [0.1, 0.1, f64::INFINITY], ..good };
    let mut ensemble = Ensemble::new(grid([4, 1, 1]));
    for shot in 0..5 {
        let samples = vec![Some(good), Some(nan), None, Some(infinite)];
        ensemble.add(&Snapshot { shot, samples });
    }
    let found = ensemble.estimates();
    assert_eq!((ensemble.shots(), found.counts), (5, vec![5, 0, 0, 0]));
    for values in &found.values {
        assert!(values[1..].iter().all(Option::is_none));
    }
    // Without fluctuations there are a mean, the negative variance of the measurement, and no skewness.
    let stress = ensemble.estimates().of(Quantity::Stress(0, 0))[0].unwrap();
    assert_near(stress.value, -0.01, 1e-12, "stress");
    assert_eq!(ensemble.estimates().of(Quantity::Rms(0))[0].unwrap().value, 0.0);
    assert!(ensemble.estimates().of(Quantity::Skewness(0))[0].is_none());
    assert!(ensemble.correlations()[0].coefficient[1][0].is_none());
}

#[test]
fn replaced_and_invalid_vectors_are_not_used() {
    use crate::velocimetry::VectorStatus::{Invalid, Replaced, Valid};
    let velocity = [[1.0; 3]; 3];
    let snapshot = Snapshot::new(4, &velocity, &[[0.1; 3]; 3], &[Replaced, Valid, Invalid]);
    let present: Vec<bool> = snapshot.samples.iter().map(Option::is_some).collect();
    assert_eq!(present, [false, true, false]);
}

#[test]
fn convergence_ends_with_all_shots_and_no_difference() {
    let snapshots = snapshots([3, 3, 3], 100, 3);
    let steps = ensemble([3, 3, 3], &snapshots).convergence();
    assert_eq!(steps.len(), 23);
    assert!(steps.is_sorted_by(|a, b| a.shots < b.shots));
    let last = steps[22];
    assert_eq!(last.shots, 100);
    for c in 0..3 {
        assert!(last.mean_difference_m_s[c] < 1e-12 && last.rms_difference_m_s[c] < 1e-12);
        // The difference of half of the shots agrees with the expectation for independent shots.
        let half = steps[11];
        let ratio = half.mean_difference_m_s[c] / half.mean_difference_expected_m_s[c];
        assert!((0.67..1.5).contains(&ratio), "{ratio}");
        assert!(half.mean_uncertainty_m_s[c] > last.mean_uncertainty_m_s[c]);
    }
}
