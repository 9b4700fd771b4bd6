//! Results do not depend on the order of shots except for rounding, and ensembles can be merged.

use proptest::prelude::*;
use rand::seq::SliceRandom;

use super::*;

const VECTORS: [usize; 3] = [4, 2, 3];

fn assert_same(found: &Ensemble, expected: &Ensemble) {
    assert_eq!(found.shots(), expected.shots());
    assert_eq!(found.counts(), expected.counts());
    let (now, then) = (found.estimates(), expected.estimates());
    for (quantity, (now, then)) in Quantity::ALL.iter().zip(now.values.iter().zip(&then.values)) {
        for (now, then) in now.iter().zip(then) {
            assert_eq!(now.is_some(), then.is_some(), "{}", quantity.name());
            let (Some(now), Some(then)) = (now, then) else { continue };
            assert_near(now.value, then.value, 1e-9, &quantity.name());
            assert_near(now.uncertainty(), then.uncertainty(), 1e-7, &quantity.name());
        }
    }
    for (now, then) in found.correlations().iter().zip(&expected.correlations()) {
        for (now, then) in now.covariance_m2_s2.iter().zip(&then.covariance_m2_s2) {
            (0..3).for_each(|c| assert_near(now[c], then[c], 1e-9, "covariance"));
        }
    }
    for (now, then) in found.convergence().iter().zip(expected.convergence()) {
        assert_eq!(now.shots, then.shots);
        (0..3).for_each(|c| {
            assert_near(now.mean_difference_m_s[c], then.mean_difference_m_s[c], 1e-9, "mean");
            assert_near(now.rms_difference_m_s[c], then.rms_difference_m_s[c], 1e-9, "rms");
        });
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn shots_in_any_order_give_the_same(shots in 1u64..70, seed in any::<u64>()) {
        let mut snapshots = snapshots(VECTORS, shots, seed);
        let expected = ensemble(VECTORS, &snapshots);
        snapshots.shuffle(&mut Pcg64Mcg::seed_from_u64(!seed));
        assert_same(&ensemble(VECTORS, &snapshots), &expected);
    }

    #[test]
    fn merged_parts_equal_the_whole(shots in 1u64..70, cut in 0.0..1.0f64, seed in any::<u64>()) {
        let snapshots = snapshots(VECTORS, shots, seed);
        let expected = ensemble(VECTORS, &snapshots);
        let (first, second) = snapshots.split_at((cut * shots as f64) as usize);
        let mut whole = ensemble(VECTORS, first);
        prop_assert!(whole.merge(&ensemble(VECTORS, second)));
        assert_same(&whole, &expected);
    }
}

#[test]
fn different_lattices_cannot_be_merged() {
    let mut one = Ensemble::new(grid([2, 2, 2]));
    assert!(!one.merge(&Ensemble::new(grid([2, 2, 3]))));
}
