//! Order statistics.

/// Standard deviation of a normal distribution over its median absolute deviation.
pub const NORMAL_OF_MEDIAN: f64 = 1.4826;

/// Median of the square of a normal distribution, in variances.
pub const MEDIAN_SQUARE: f64 = 0.454_936;

/// Median of the sum of squares of three standard normal variables: of chi-squared with three degrees of freedom.
pub const MEDIAN_OF_THREE_SQUARES: f64 = 2.366;

/// The median: the mean of the middle two of an even number; `None` of nothing.
pub fn median<T: Into<f64>>(values: impl IntoIterator<Item = T>) -> Option<f64> {
    let mut values: Vec<f64> = values.into_iter().map(Into::into).collect();
    let middle = values.len() / 2;
    if values.is_empty() {
        return None;
    }
    let upper = *values.select_nth_unstable_by(middle, f64::total_cmp).1;
    if !values.len().is_multiple_of(2) {
        return Some(upper);
    }
    let lower = values[..middle].iter().copied().fold(f64::NEG_INFINITY, f64::max);
    Some((lower + upper) / 2.0)
}

/// The lower quartile, one of the values; `None` of nothing.
pub fn lower_quartile<T: Into<f64>>(values: impl IntoIterator<Item = T>) -> Option<f64> {
    let mut values: Vec<f64> = values.into_iter().map(Into::into).collect();
    let place = values.len().checked_sub(1)? / 4;
    Some(*values.select_nth_unstable_by(place, f64::total_cmp).1)
}

/// The value on either side of which lies half of the weight; `None` of nothing. Values come first.
pub fn weighted_median(mut values: Vec<(f64, f64)>) -> Option<f64> {
    values.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
    let half = values.iter().map(|(_, weight)| weight).sum::<f64>() / 2.0;
    let mut below = 0.0;
    let middle = values.iter().find(|(_, weight)| {
        below += weight;
        below >= half
    });
    middle.map(|(value, _)| *value)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn the_median_is_that_of_sorted_values(
            values in proptest::collection::vec(-5f64..5.0, 1..30),
        ) {
            let mut sorted = values.clone();
            sorted.sort_by(f64::total_cmp);
            let n = sorted.len();
            let expected = (sorted[(n - 1) / 2] + sorted[n / 2]) / 2.0;
            prop_assert_eq!(median(values.iter().copied()), Some(expected));
            prop_assert_eq!(lower_quartile(values), Some(sorted[(n - 1) / 4]));
        }

        #[test]
        fn equal_weights_give_a_middle_value(
            values in proptest::collection::vec(-5f64..5.0, 1..30),
        ) {
            let found = weighted_median(values.iter().map(|&value| (value, 2.0)).collect()).unwrap();
            let side = |is: fn(&f64, &f64) -> bool| values.iter().filter(|v| is(v, &found)).count();
            let half = values.len() as f64 / 2.0;
            prop_assert!(side(f64::lt) as f64 <= half && side(f64::gt) as f64 <= half);
        }
    }

    #[test]
    fn nothing_has_no_median() {
        let none: [f32; 0] = [];
        assert_eq!(
            (median(none), lower_quartile(none), weighted_median(Vec::new())),
            (None, None, None)
        );
    }
}
