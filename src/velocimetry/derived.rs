//! Vorticity and divergence of a vector field on a lattice.

/// Curl and divergence of `values` (lattice of `nodes`, stored z, y, x), in value units per node
/// distance `step`: central differences inside, one-sided at the faces, zero along an axis with a
/// single node.
pub fn curl_and_divergence(
    nodes: [usize; 3],
    values: &[[f32; 3]],
    step: f64,
) -> (Vec<[f32; 3]>, Vec<f32>) {
    (0..values.len())
        .map(|index| {
            // gradient[a][c]: derivative of component c along axis a
            let gradient: [[f64; 3]; 3] =
                std::array::from_fn(|axis| derivative(nodes, values, index, axis, step));
            let curl = [
                gradient[1][2] - gradient[2][1],
                gradient[2][0] - gradient[0][2],
                gradient[0][1] - gradient[1][0],
            ];
            let divergence = gradient[0][0] + gradient[1][1] + gradient[2][2];
            (curl.map(|c| c as f32), divergence as f32)
        })
        .unzip()
}

fn derivative(
    nodes: [usize; 3],
    values: &[[f32; 3]],
    index: usize,
    axis: usize,
    step: f64,
) -> [f64; 3] {
    let stride = [1, nodes[0], nodes[0] * nodes[1]][axis];
    let place = index / stride % nodes[axis];
    let below = place.min(1);
    let above = (nodes[axis] - 1 - place).min(1);
    if below + above == 0 {
        return [0.0; 3];
    }
    let (low, high) = (values[index - below * stride], values[index + above * stride]);
    let distance = (below + above) as f64 * step;
    std::array::from_fn(|c| f64::from(high[c] - low[c]) / distance)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solid_rotation_has_twice_its_rate_as_vorticity_and_no_divergence() {
        let nodes = [4, 5, 3];
        let (rate, step) = (0.1, 8.0);
        let mut values = Vec::new();
        for _ in 0..3 {
            for j in 0..5 {
                for i in 0..4 {
                    let (x, y) = (f64::from(i) * step, f64::from(j) * step);
                    values.push([(-rate * y) as f32, (rate * x) as f32, 0.0]);
                }
            }
        }
        let (curl, divergence) = curl_and_divergence(nodes, &values, step);
        for (c, d) in curl.iter().zip(&divergence) {
            assert!(c[0].abs() < 1e-6 && c[1].abs() < 1e-6 && (c[2] - 0.2).abs() < 1e-5);
            assert!(d.abs() < 1e-6);
        }
    }

    #[test]
    fn a_single_layer_has_finite_derivatives() {
        let (curl, divergence) = curl_and_divergence([1, 1, 1], &[[1.0, 2.0, 3.0]], 1.0);
        assert_eq!((curl[0], divergence[0]), ([0.0; 3], 0.0));
    }
}
