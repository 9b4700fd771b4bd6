//! Coverage of the 95 % intervals: 92 to 98 %.

use super::{turbulence::Turbulence, *};

const ENSEMBLES: u64 = 200;
const SHOTS: u64 = 200;

/// Coverage of each statistic, from 200 ensembles of 200 shots of the known turbulent flow.
#[test]
fn intervals_have_the_stated_coverage() {
    let grid = grid([3, 4, 1]);
    let flow = Turbulence::new(&grid, 7);
    let mut held = [0_u32; Quantity::ALL.len()];
    let mut all = 0_u32;
    for seed in 0..ENSEMBLES {
        let mut random = Pcg64Mcg::seed_from_u64(1000 + seed);
        let mut ensemble = Ensemble::new(grid.clone());
        (0..SHOTS).for_each(|shot| ensemble.add(&flow.shot(shot, &mut random)));
        let found = ensemble.estimates();
        for (held, quantity) in held.iter_mut().zip(Quantity::ALL) {
            for (place, estimate) in found.of(quantity).iter().enumerate() {
                let [low, high] = estimate.unwrap().interval_95;
                *held += u32::from((low..=high).contains(&flow.truth(quantity, place)));
            }
        }
        all += grid.len() as u32;
    }
    let mut wrong = Vec::new();
    for (held, quantity) in held.iter().zip(Quantity::ALL) {
        let share = f64::from(*held) / f64::from(all);
        println!("{}: {:.1} %", quantity.name(), 100.0 * share);
        if !(0.92..=0.98).contains(&share) {
            wrong.push(format!("{} {:.1} %", quantity.name(), 100.0 * share));
        }
    }
    assert!(wrong.is_empty(), "{wrong:?}");
}

/// Uncertainties of flow and measurement are separated. They are averaged over many nodes, because a single
/// jackknife with 23 groups has an uncertainty of a third.
#[test]
fn uncertainties_of_flow_and_measurement_are_separated() {
    const PLACES: [usize; 3] = [10, 10, 1];
    let with = |flow: f64, noise: f64| {
        let mut random = Pcg64Mcg::seed_from_u64(5);
        let mut ensemble = Ensemble::new(grid(PLACES));
        for shot in 0..230 {
            let samples = (0..100).map(|_| {
                let velocity_m_s = [0; 3].map(|_| {
                    flow * turbulence::normal(&mut random) + noise * turbulence::normal(&mut random)
                });
                Some(Sample { velocity_m_s, uncertainty_m_s: [noise; 3] })
            });
            ensemble.add(&Snapshot { shot, samples: samples.collect() });
        }
        let found = ensemble.estimates();
        // Means over the nodes of the value and of both variances, times the number of shots.
        move |quantity: Quantity| {
            let places: Vec<Estimate> = found.of(quantity).iter().flatten().copied().collect();
            let over = |part: &dyn Fn(&Estimate) -> f64| {
                places.iter().map(part).sum::<f64>() / places.len() as f64
            };
            [
                over(&|e| e.value),
                230.0 * over(&|e| e.flow_uncertainty.powi(2)),
                230.0 * over(&|e| e.measurement_uncertainty.powi(2)),
            ]
        }
    };
    let turbulent = with(1.0, 0.5);
    let [_, flow, measurement] = turbulent(Quantity::Mean(0));
    assert!((flow - 1.0).abs() < 0.15, "{flow}");
    assert_near(measurement, 0.25, 1e-9, "noise in the mean");
    let [stress, flow, measurement] = turbulent(Quantity::Stress(0, 0));
    assert!((stress - 1.0).abs() < 0.05, "{stress}");
    // Flow: 2 σ⁴. Measurement: 4 · 1 · 0.25 + 2 · 0.0625.
    assert!((flow - 2.0).abs() < 0.6 && (measurement - 1.125).abs() < 0.1, "{flow} {measurement}");
    let [shear, ..] = turbulent(Quantity::Stress(0, 1));
    assert!(shear.abs() < 0.03, "{shear}");
    let quiet = with(0.0, 0.5);
    let [_, flow, measurement] = quiet(Quantity::Mean(0));
    assert!(flow < 0.4 * measurement, "{flow} {measurement}");
    let [stress, ..] = quiet(Quantity::Stress(0, 0));
    assert!(stress.abs() < 0.01, "{stress}");
}
