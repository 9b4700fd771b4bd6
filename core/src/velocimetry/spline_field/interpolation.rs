//! Coefficients of a cubic B-spline field through given values.

use super::super::layout::Layout;

/// Coefficients of the field with these values at the nodes: values minus a sixth of their second difference along
/// each axis, which is exact for cubic polynomials (de Boor and Fix, J. Approx. Theory 8, 1973). Coefficients at the
/// ends of an axis, which have one neighbour, are the values along it.
///
/// With the values themselves as coefficients the field would be smoothed by the B-spline.
pub fn coefficients_through(layout: Layout, mut values: Vec<[f32; 3]>) -> Vec<[f32; 3]> {
    for axis in 0..3 {
        let (s, count) = (layout.stride(axis), layout.nodes[axis]);
        let before = values.clone();
        for (n, value) in values.iter_mut().enumerate() {
            let place = n / s % count;
            if (1..count - 1).contains(&place) {
                let (below, at, above) = (before[n - s], before[n], before[n + s]);
                *value = std::array::from_fn(|c| at[c] - (below[c] - 2.0 * at[c] + above[c]) / 6.0);
            }
        }
    }
    values
}

#[cfg(test)]
mod tests {
    use super::{super::super::nodes::Nodes, *};

    /// A polynomial with all cubic terms, in voxels.
    fn cubic([x, y, z]: [f32; 3]) -> [f32; 3] {
        [x * x * y, y * y * y - x, x * y * z + z * z].map(|value| value / 100.0)
    }

    #[test]
    fn a_cubic_polynomial_is_met_between_the_nodes() {
        let nodes = Nodes::covering([-6.0; 3], [6.0; 3], 1.5);
        let values = (0..nodes.layout.len()).map(|n| cubic(nodes.place_vox(n))).collect();
        let coefficients = coefficients_through(nodes.layout, values);
        for at_vox in [[0.0; 3], [1.1, -2.3, 0.7], [-3.9, 2.2, 3.3]] {
            let found = nodes.taps(at_vox).gather(nodes.layout, &coefficients);
            let close = |c: usize| (found[c] - cubic(at_vox)[c]).abs() < 1e-4;
            assert!((0..3).all(close), "{found:?} {:?}", cubic(at_vox));
        }
    }
}
