//! Third differences along the axes of a lattice, and their penalty.

use super::{flow_nodes::FlowNodes, layout::Layout};

/// The penalty Σ p (Δ³d)² on a field d, with a weight p for each third difference.
#[derive(Debug, Clone, PartialEq)]
pub struct Penalty {
    /// Nodes of the values.
    pub layout: Layout,
    /// Per axis: p of the third difference that starts at each node; 0 where none does.
    pub stiffness: [Vec<f64>; 3],
}

impl Layout {
    /// Axes with third differences.
    fn long_axes(self) -> impl Iterator<Item = usize> {
        (0..3).filter(move |&axis| self.nodes[axis] > 3)
    }

    /// Whether a third difference along `axis` starts at node `n`.
    pub fn starts(self, axis: usize, n: usize) -> bool {
        n / self.stride(axis) % self.nodes[axis] + 3 < self.nodes[axis]
    }

    /// Number of unknown nodes among the four of the third difference along `axis` that starts at node `n`.
    fn gaps(self, axis: usize, n: usize, known: &[bool]) -> usize {
        let s = self.stride(axis);
        (0..4).filter(|k| !known[n + k * s]).count()
    }

    /// Nodes at which a third difference along `axis` starts whose nodes are all `known` and of the same flow.
    pub fn within<'a>(
        self,
        axis: usize,
        known: &'a [bool],
        flow: Option<&'a FlowNodes>,
    ) -> impl Iterator<Item = usize> + use<'a> {
        (0..known.len()).filter(move |&n| {
            self.starts(axis, n)
                && self.gaps(axis, n, known) == 0
                && !flow.is_some_and(|flow| flow.ties_flows(axis, n))
        })
    }

    /// Third differences along `axis` that start at the nodes. Where a row ends, the value spans two rows and is
    /// meaningless; the last nodes have none.
    pub fn third_differences(self, axis: usize, value: &[f64]) -> Vec<f64> {
        let later = |steps: usize| value.iter().skip(steps * self.stride(axis));
        let four = value.iter().zip(later(1)).zip(later(2)).zip(later(3));
        four.map(|(((first, second), third), last)| last - first + 3.0 * (second - third)).collect()
    }

    /// Sums over the nodes within one step along each axis.
    fn sums_around(self, values: &mut [f64]) {
        for axis in 0..3 {
            let s = self.stride(axis);
            let from = values.to_vec();
            for (n, sum) in values.iter_mut().enumerate() {
                let place = n / s % self.nodes[axis];
                if place > 0 {
                    *sum += from[n - s];
                }
                if place + 1 < self.nodes[axis] {
                    *sum += from[n + s];
                }
            }
        }
    }

    /// Local roughness: mean square of the third differences along `axis` around each node, with the mean over the
    /// lattice as one more of them. Only differences of `known` values of the same flow count. 0 where none
    /// starts.
    pub fn roughness(
        self,
        axis: usize,
        value: &[f64],
        known: &[bool],
        flow: Option<&FlowNodes>,
    ) -> Vec<f64> {
        let starts: Vec<bool> = (0..value.len()).map(|n| self.starts(axis, n)).collect();
        let (mut squares, mut counts) = (vec![0.0; value.len()], vec![0.0; value.len()]);
        let differences = self.third_differences(axis, value);
        for n in self.within(axis, known, flow) {
            (squares[n], counts[n]) = (differences[n] * differences[n], 1.0);
        }
        let mean = squares.iter().sum::<f64>() / counts.iter().sum::<f64>().max(1.0);
        self.sums_around(&mut squares);
        self.sums_around(&mut counts);
        (0..value.len())
            .map(|n| if starts[n] { (squares[n] + mean) / (counts[n] + 1.0) } else { 0.0 })
            .collect()
    }
}

impl Penalty {
    /// Removes the third differences over more than one unknown node. They would constrain known nodes by the
    /// smoothness of an unmeasured region. A difference with one unknown node bridges a gap; at the edge of the
    /// known nodes it determines the unknown one and does not constrain the others.
    pub fn drop_unknown(&mut self, known: &[bool]) {
        let layout = self.layout;
        for (axis, stiffness) in self.stiffness.iter_mut().enumerate() {
            for (n, stiffness) in stiffness.iter_mut().enumerate() {
                if layout.starts(axis, n) && layout.gaps(axis, n, known) > 1 {
                    *stiffness = 0.0;
                }
            }
        }
    }

    /// Removes the third differences across bodies, whose nodes belong to different flows.
    pub fn drop_across_bodies(&mut self, flow: &FlowNodes) {
        for (axis, stiffness) in self.stiffness.iter_mut().enumerate() {
            for (n, stiffness) in stiffness.iter_mut().enumerate() {
                if self.layout.starts(axis, n) && flow.ties_flows(axis, n) {
                    *stiffness = 0.0;
                }
            }
        }
    }

    /// Adds Δᵀ p Δ of `value` to `sum`.
    pub fn add_forces(&self, value: &[f64], sum: &mut [f64]) {
        for axis in self.layout.long_axes() {
            let s = self.layout.stride(axis);
            let mut force = self.layout.third_differences(axis, value);
            for (force, stiffness) in force.iter_mut().zip(&self.stiffness[axis]) {
                *force *= stiffness;
            }
            for (place, factor) in [-1.0, 3.0, -3.0, 1.0].into_iter().enumerate() {
                for (sum, force) in sum[place * s..].iter_mut().zip(&force) {
                    *sum += factor * force;
                }
            }
        }
    }

    /// Adds the diagonal of Δᵀ p Δ to `sum`.
    pub fn add_diagonal(&self, sum: &mut [f64]) {
        for axis in self.layout.long_axes() {
            let s = self.layout.stride(axis);
            for (place, square) in [1.0, 9.0, 9.0, 1.0].into_iter().enumerate() {
                let from = &self.stiffness[axis][..sum.len().saturating_sub(3 * s)];
                for (sum, stiffness) in sum[place * s..].iter_mut().zip(from) {
                    *sum += square * stiffness;
                }
            }
        }
    }
}
