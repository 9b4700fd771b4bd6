//! Vorticity and divergence of a vector field on a lattice.

use super::flow_nodes::FlowNodes;

/// Derivatives of a vector field.
#[derive(Debug, Clone, PartialEq)]
pub struct Gradients {
    /// Its curl; zero where it is not known.
    pub vorticity: Vec<[f32; 3]>,
    /// Its divergence; zero where it is not known.
    pub divergence: Vec<f32>,
    /// Whether both are known.
    pub known: Vec<bool>,
}

/// Curl and divergence of `values` (lattice of `nodes`, stored z, y, x), in value units per node
/// distance `step`: central differences between neighbours that have a value, one-sided where only one
/// has, zero along an axis with a single node. Known where the vector itself has a value and, along
/// every axis, a neighbour has one.
pub fn curl_and_divergence(
    nodes: [usize; 3],
    values: &[[f32; 3]],
    has_value: &[bool],
    step: f64,
) -> Gradients {
    gradients_within(nodes, values, has_value, step, None)
}

/// [`curl_and_divergence`] with differences between nodes of one `flow` only.
pub fn gradients_within(
    nodes: [usize; 3],
    values: &[[f32; 3]],
    has_value: &[bool],
    step: f64,
    flow: Option<&FlowNodes>,
) -> Gradients {
    let found: Vec<Option<([f32; 3], f32)>> = (0..values.len())
        .map(|index| {
            if !has_value[index] {
                return None;
            }
            let along = |axis| {
                derivative(nodes, values, index, axis, step, |from, to| {
                    has_value[from]
                        && has_value[to]
                        && flow.is_none_or(|flow| flow.is_open(from, axis))
                })
            };
            // gradient[a][c]: derivative of component c along axis a
            let gradient = [along(0)?, along(1)?, along(2)?];
            let curl = [
                gradient[1][2] - gradient[2][1],
                gradient[2][0] - gradient[0][2],
                gradient[0][1] - gradient[1][0],
            ];
            let divergence = gradient[0][0] + gradient[1][1] + gradient[2][2];
            Some((curl.map(|c| c as f32), divergence as f32))
        })
        .collect();
    let known = found.iter().map(Option::is_some).collect();
    let (vorticity, divergence) = found.into_iter().map(Option::unwrap_or_default).unzip();
    Gradients { vorticity, divergence, known }
}

/// The derivative along an axis at a node that has a value; `is_open`: whether a node and the next one can be
/// compared.
fn derivative(
    nodes: [usize; 3],
    values: &[[f32; 3]],
    index: usize,
    axis: usize,
    step: f64,
    is_open: impl Fn(usize, usize) -> bool,
) -> Option<[f64; 3]> {
    if nodes[axis] == 1 {
        return Some([0.0; 3]);
    }
    let stride = [1, nodes[0], nodes[0] * nodes[1]][axis];
    let place = index / stride % nodes[axis];
    let below = usize::from(place > 0 && is_open(index - stride, index));
    let above = usize::from(place + 1 < nodes[axis] && is_open(index, index + stride));
    if below + above == 0 {
        return None;
    }
    let (low, high) = (values[index - below * stride], values[index + above * stride]);
    let distance = (below + above) as f64 * step;
    Some(std::array::from_fn(|c| f64::from(high[c] - low[c]) / distance))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A solid rotation of 0.1 per voxel about z, on nodes 8 voxels apart.
    fn rotation() -> Vec<[f32; 3]> {
        let place = |n: i32| [n % 4, n / 4 % 5].map(|i| 0.8 * i as f32);
        (0..60).map(place).map(|[x, y]| [-y, x, 0.0]).collect()
    }

    fn of_rotation(values: &[[f32; 3]], has_value: &[bool]) -> Gradients {
        curl_and_divergence([4, 5, 3], values, has_value, 8.0)
    }

    fn is_rotation(found: &Gradients, n: usize) -> bool {
        let [x, y, z] = found.vorticity[n];
        x.abs() < 1e-6
            && y.abs() < 1e-6
            && (z - 0.2).abs() < 1e-5
            && found.divergence[n].abs() < 1e-6
    }

    #[test]
    fn solid_rotation_has_twice_its_rate_as_vorticity_and_no_divergence() {
        let found = of_rotation(&rotation(), &[true; 60]);
        assert!((0..60).all(|n| found.known[n] && is_rotation(&found, n)));
    }

    #[test]
    fn vectors_without_value_are_in_no_difference() {
        let mut values = rotation();
        // The layers x = 0 and 1 have none, nor has a hole on the face x = 3.
        let has_value: Vec<bool> = (0..60).map(|n| n % 4 >= 2 && n != 31).collect();
        for (value, _) in values.iter_mut().zip(&has_value).filter(|(_, has)| !**has) {
            *value = [0.0; 3];
        }
        let found = of_rotation(&values, &has_value);
        for (n, &has) in has_value.iter().enumerate() {
            // Next to the hole along x and along z there is no other neighbour.
            assert_eq!(found.known[n], has && ![11, 30, 51].contains(&n), "{n}");
            assert!(!found.known[n] || is_rotation(&found, n), "{n}");
            assert!(found.known[n] || (found.vorticity[n], found.divergence[n]) == ([0.0; 3], 0.0));
        }
    }

    #[test]
    fn a_single_layer_has_finite_derivatives() {
        let found = curl_and_divergence([1, 1, 1], &[[1.0, 2.0, 3.0]], &[true], 1.0);
        assert_eq!((found.vorticity[0], found.divergence[0]), ([0.0; 3], 0.0));
        assert!(found.known[0]);
    }
}
