//! A vector field as a sum of cubic B-splines, with two continuous derivatives and an error of fourth
//! order in the distance of its nodes.

use super::super::{
    flow_nodes::FlowNodes,
    lattice::Lattice,
    layout::Layout,
    nodes::{Nodes, Taps},
};

/// A vector field on a lattice, which has a coefficient on every node and one beyond each end.
#[derive(Debug, Clone, PartialEq)]
pub struct Spline {
    /// The coefficients' places; node (0, 0, 0) of the lattice is coefficient (1, 1, 1).
    pub nodes: Nodes,
    /// Per component of the vector.
    pub coefficients: [Vec<f64>; 3],
}

impl Spline {
    /// The spline that has the values of `field` on its nodes, and no curvature across its faces.
    ///
    /// Where two flows meet in the middle of a body (`flow`, on the coefficients), each row ends there: the spline does
    /// not overshoot on either side of the jump, and does not have the nodes' values next to it.
    pub fn through(field: &Lattice, flow: Option<&FlowNodes>) -> Self {
        let layout = Layout { nodes: field.nodes.map(|n| n + 2) };
        let coefficients = std::array::from_fn(|c| {
            let mut values = vec![0.0; layout.len()];
            for (n, value) in field.values.iter().enumerate() {
                values[index_within(layout, field.nodes, n)] = f64::from(value[c]);
            }
            for axis in 0..3 {
                let is_linked = |n| flow.is_none_or(|flow| flow.is_linked(n, axis));
                interpolate_along(layout, axis, &mut values, is_linked);
            }
            values
        });
        let nodes = Nodes { layout, first_vox: field.first_vox, step_vox: field.step_vox };
        Self { nodes, coefficients }
    }

    /// The field's values on the nodes of the lattice `like` that it was made through.
    pub fn on_nodes(&self, like: &Lattice) -> Lattice {
        let values = (0..like.values.len())
            .map(|n| self.of(&Taps::of_node(self.nodes.layout, like.nodes, n)).map(|v| v as f32))
            .collect();
        Lattice { values, ..*like }
    }

    /// Whether a place lies between the nodes.
    pub fn contains(&self, at_vox: [f32; 3]) -> bool {
        let at = self.nodes.coordinates(at_vox);
        (0..3).all(|axis| (0.0..=self.nodes.cells(axis) as f32).contains(&at[axis]))
    }

    /// Interpolation weights at a position, or at the nearest one between the nodes.
    pub fn taps(&self, at_vox: [f32; 3]) -> Taps {
        self.nodes.taps(at_vox)
    }

    /// The vector of some taps, in voxels.
    pub fn of(&self, taps: &Taps) -> [f64; 3] {
        std::array::from_fn(|c| taps.gather_component(self.nodes.layout, &self.coefficients[c]))
    }

    /// Mid-pair position of light that is at `at_vox` in its own frame: half the displacement forwards from frame a
    /// (`sign` 1) or backwards from frame b (−1), along the curved path by the midpoint rule.
    pub fn middle_of_path(&self, at_vox: [f32; 3], sign: f32) -> [f32; 3] {
        let ahead = |by: [f64; 3], part: f32| {
            std::array::from_fn(|axis| at_vox[axis] + sign * part * by[axis] as f32)
        };
        let start = self.of(&self.taps(at_vox));
        ahead(self.of(&self.taps(ahead(start, 0.25))), 0.5)
    }
}

/// Index of the coefficient on node `n` of a lattice.
fn index_within(layout: Layout, nodes: [usize; 3], n: usize) -> usize {
    layout.number(Layout { nodes }.place(n).map(|along| along + 1))
}

/// Turns the values on the inner nodes of every row along `axis` into the coefficients of the
/// interpolating spline with straight ends: (c₋ + 4 c + c₊)/6 = y. A row ends where the next node is not linked.
fn interpolate_along(
    layout: Layout,
    axis: usize,
    values: &mut [f64],
    is_linked: impl Fn(usize) -> bool,
) {
    let (s, count) = (layout.stride(axis), layout.nodes[axis] - 2);
    let starts = (0..layout.len()).filter(|n| n / s % layout.nodes[axis] == 0);
    let (mut ratio, mut row) = (vec![0.0; count], vec![0.0; count]);
    for start in starts {
        let at = |i: usize| start + (i + 1) * s;
        let mut first = 0;
        for last in (0..count).filter(|&i| i + 1 == count || !is_linked(at(i))) {
            let length = last + 1 - first;
            for (i, value) in row[..length].iter_mut().enumerate() {
                *value = values[at(first + i)];
            }
            to_coefficients(&mut row[..length], &mut ratio[..length]);
            for (i, value) in row[..length].iter().enumerate() {
                values[at(first + i)] = *value;
            }
            first = last + 1;
        }
        values[start] = 2.0 * values[at(0)] - values[at(1)];
        values[at(count)] = 2.0 * values[at(count - 1)] - values[at(count - 2)];
    }
}

/// Solves for the coefficients of a row. At the ends they are the values; between, elimination and back
/// substitution. `ratio` is scratch memory.
fn to_coefficients(row: &mut [f64], ratio: &mut [f64]) {
    let count = row.len();
    ratio[0] = 0.0;
    for i in 1..count {
        let end = i + 1 == count;
        let (side, middle) = if end { (0.0, 6.0) } else { (1.0, 4.0) };
        let pivot = middle - side * ratio[i - 1];
        ratio[i] = if end { 0.0 } else { 1.0 / pivot };
        row[i] = (6.0 * row[i] - side * row[i - 1]) / pivot;
    }
    for i in (0..count.saturating_sub(1)).rev() {
        row[i] -= ratio[i] * row[i + 1];
    }
}
