//! The ensemble compared with naive sums and with a turbulent flow of known statistics.

mod intervals;
mod order;
mod space;
mod sums;
mod turbulence;

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::*;
use crate::velocimetry::VectorGrid;

fn grid(vectors: [usize; 3]) -> VectorGrid {
    VectorGrid { vectors, first_mm: [-1.0, 0.0, 2.0], spacing_mm: 0.5 }
}

/// Shots with random fluctuations around a large mean; a fifth of the samples is missing.
fn snapshots(vectors: [usize; 3], shots: u64, seed: u64) -> Vec<Snapshot> {
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let mut shot = |shot| {
        let samples = (0..vectors.iter().product()).map(|place: usize| {
            let velocity_m_s = [10.0, -20.0, 0.0]
                .map(|mean| mean + place as f64 + random.random_range(-1.0..1.0f64).powi(2) * 3.0);
            let uncertainty_m_s = [0; 3].map(|_| random.random_range(0.05..0.1));
            random.random_bool(0.8).then_some(Sample { velocity_m_s, uncertainty_m_s })
        });
        Snapshot { shot, samples: samples.collect() }
    };
    (0..shots).map(&mut shot).collect()
}

fn ensemble(vectors: [usize; 3], snapshots: &[Snapshot]) -> Ensemble {
    let mut ensemble = Ensemble::new(grid(vectors));
    snapshots.iter().for_each(|snapshot| ensemble.add(snapshot));
    ensemble
}

fn assert_near(found: f64, expected: f64, tolerance: f64, what: &str) {
    let scale = expected.abs().max(1.0);
    assert!((found - expected).abs() <= tolerance * scale, "{what}: {found}, {expected}");
}
