//! The cubic B-spline (Unser, IEEE Signal Process. Mag. 16, 1999), nodes 1 apart.

/// Its values on its middle node and on the next one.
pub const ON_NODES: [f32; 2] = [2.0 / 3.0, 1.0 / 6.0];

/// Its value at a distance from its middle. Comparisons instead of `max`, whose handling of NaN needs
/// additional vector instructions.
#[inline(always)]
pub fn value(at: f32) -> f32 {
    let (wide, narrow) = (2.0 - at.abs(), 1.0 - at.abs());
    let wide = if wide > 0.0 { wide } else { 0.0 };
    let narrow = if narrow > 0.0 { narrow } else { 0.0 };
    (wide * wide * wide - 4.0 * narrow * narrow * narrow) * (1.0 / 6.0)
}

/// The values of the four splines that are not zero at a position `t`, 0 to 1, between the middle two:
/// [`value`] at `1 + t`, `t`, `1 − t` and `2 − t`.
#[inline(always)]
pub fn weights(t: f32) -> [f32; 4] {
    let s = 1.0 - t;
    [
        s * s * s / 6.0,
        2.0 / 3.0 - t * t * (2.0 - t) / 2.0,
        2.0 / 3.0 - s * s * (2.0 - s) / 2.0,
        t * t * t / 6.0,
    ]
}

/// The four splines of [`weights`], and their slopes, half way between two nodes.
pub const HALFWAY: [f64; 4] = [1.0 / 48.0, 23.0 / 48.0, 23.0 / 48.0, 1.0 / 48.0];
pub const HALFWAY_SLOPES: [f64; 4] = [-0.125, -0.625, 0.625, 0.125];

/// The slopes of the four splines of [`weights`].
#[inline(always)]
pub fn slopes(t: f32) -> [f32; 4] {
    let s = 1.0 - t;
    [-s * s / 2.0, t * (1.5 * t - 2.0), s * (2.0 - 1.5 * s), t * t / 2.0]
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn half_way_the_splines_are_those_of_any_place() {
        let close = |a: f32, b: f64| (f64::from(a) - b).abs() < 1e-7;
        assert!(weights(0.5).into_iter().zip(HALFWAY).all(|(a, b)| close(a, b)));
        assert!(slopes(0.5).into_iter().zip(HALFWAY_SLOPES).all(|(a, b)| close(a, b)));
    }

    proptest! {
        #[test]
        fn weights_are_values_that_sum_to_one_about_the_place(t in 0f32..=1.0) {
            let weights = weights(t);
            let values = [1.0 + t, t, 1.0 - t, 2.0 - t].map(value);
            for (weight, value) in weights.iter().zip(values) {
                prop_assert!((weight - value).abs() < 1e-6, "{weights:?} {values:?}");
            }
            prop_assert!((weights.iter().sum::<f32>() - 1.0).abs() < 1e-6);
            let mean: f32 = weights.iter().zip([-1.0, 0.0, 1.0, 2.0]).map(|(w, at)| w * at).sum();
            prop_assert!((mean - t).abs() < 1e-6);
        }

        #[test]
        fn slopes_are_differences_of_weights(t in 0.01f32..=0.99) {
            let (low, high) = (weights(t - 0.01), weights(t + 0.01));
            for (slope, (low, high)) in slopes(t).into_iter().zip(low.into_iter().zip(high)) {
                prop_assert!((slope - (high - low) / 0.02).abs() < 1e-3);
            }
        }
    }

    #[test]
    fn nodes_have_their_values_and_nothing_is_two_nodes_away() {
        assert_eq!([0.0, 1.0, -1.0].map(value), [ON_NODES[0], ON_NODES[1], ON_NODES[1]]);
        assert_eq!([2.0, -2.5, 1e9].map(value), [0.0; 3]);
    }
}
