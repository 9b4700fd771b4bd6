//! Extrema between equidistant samples.

/// Offset of the highest point of the parabola through three equidistant samples from the middle one, in sample
/// spacings, −1 to 1; 0 where the parabola has no maximum.
pub fn maximum([before, middle, after]: [f64; 3]) -> f64 {
    let curvature = before - 2.0 * middle + after;
    let offset = if curvature < 0.0 { (before - after) / (2.0 * curvature) } else { 0.0 };
    offset.clamp(-1.0, 1.0)
}

/// The same for the lowest point.
pub fn minimum(samples: [f64; 3]) -> f64 {
    maximum(samples.map(|sample| -sample))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn the_vertex_of_a_parabola_is_found(vertex in -0.9f64..0.9, width in 0.1f64..10.0) {
            let samples = [-1.0, 0.0, 1.0].map(|at: f64| 3.0 - ((at - vertex) / width).powi(2));
            prop_assert!((maximum(samples) - vertex).abs() < 1e-9);
            prop_assert!((minimum(samples.map(|value| -value)) - vertex).abs() < 1e-9);
            prop_assert_eq!(minimum(samples), 0.0);
        }
    }

    #[test]
    fn samples_on_a_line_and_distant_vertices_are_bounded() {
        assert_eq!(maximum([1.0, 2.0, 3.0]), 0.0);
        assert_eq!(maximum([1.0, 2.0, 2.9]), 1.0);
        assert_eq!(minimum([1.0, 2.0, 3.1]), -1.0);
    }
}
