//! Interpolation and extrapolation to the nodes of a lattice without values.

use super::{flow_nodes::FlowNodes, lattice::Lattice, layout::Layout};

impl Lattice {
    /// The field with values on nodes that are not `known`, filled outwards from the known ones: the mean between
    /// two known nodes, linear extrapolation from the last two beyond them, as in [`Self::at`]. Extrapolated
    /// values exceed the range of the known ones by at most its width. All zero where no node is known.
    ///
    /// Nodes in the `flow` are filled first from nodes of the same flow, then nodes in bodies from the flow that
    /// is nearest along an axis, then the remaining nodes from any.
    ///
    /// The result is a search position, not a measurement.
    pub fn filled(mut self, known: &[bool], flow: Option<&FlowNodes>) -> Self {
        let limits: [[f32; 2]; 3] = std::array::from_fn(|c| self.limits(c, known));
        let mut filled = known.to_vec();
        for (value, _) in self.values.iter_mut().zip(known).filter(|(_, known)| !**known) {
            *value = [0.0; 3];
        }
        if let Some(flow) = flow {
            self.fill(&mut filled, limits, |n, axis| flow.is_open(n, axis));
            self.fill(&mut filled, limits, |n, axis| flow.is_linked(n, axis));
        }
        self.fill(&mut filled, limits, |_, _| true);
        self
    }

    /// Fills nodes outwards, from a node to its neighbour along an axis where `is_open`, until none changes.
    fn fill(
        &mut self,
        filled: &mut [bool],
        limits: [[f32; 2]; 3],
        is_open: impl Fn(usize, usize) -> bool,
    ) {
        let layout = Layout { nodes: self.nodes };
        loop {
            let next: Vec<(usize, [f32; 3])> = (0..filled.len())
                .filter(|&n| !filled[n])
                .filter_map(|n| Some((n, self.continued(layout, n, filled, &is_open)?)))
                .collect();
            if next.is_empty() {
                return;
            }
            for (n, value) in next {
                let within = |c: usize| value[c].clamp(limits[c][0], limits[c][1]);
                self.values[n] = std::array::from_fn(within);
                filled[n] = true;
            }
        }
    }

    /// Limits of component `c`: the range of the known values, extended by its width on either side.
    fn limits(&self, c: usize, known: &[bool]) -> [f32; 2] {
        let values = self.values.iter().zip(known).filter(|(_, known)| **known).map(|(v, _)| v[c]);
        let none = [f32::INFINITY, f32::NEG_INFINITY];
        let [low, high] = values.fold(none, |[low, high], v| [low.min(v), high.max(v)]);
        if low > high { [0.0; 2] } else { [low - (high - low), high + (high - low)] }
    }

    /// Mean of the values of node `n` along every axis; `None` without a filled neighbour that can be reached.
    fn continued(
        &self,
        layout: Layout,
        n: usize,
        filled: &[bool],
        is_open: &impl Fn(usize, usize) -> bool,
    ) -> Option<[f32; 3]> {
        let place = layout.place(n);
        let said: Vec<[f32; 3]> = (0..3)
            .filter_map(|axis| {
                let s = layout.stride(axis);
                let below = |steps: usize| {
                    let other = (place[axis] >= steps).then(|| n - steps * s)?;
                    let is_open = (1..=steps).all(|step| is_open(n - step * s, axis));
                    (filled[other] && is_open).then(|| self.values[other])
                };
                let above = |steps: usize| {
                    let other =
                        (place[axis] + steps < layout.nodes[axis]).then(|| n + steps * s)?;
                    let is_open = (0..steps).all(|step| is_open(n + step * s, axis));
                    (filled[other] && is_open).then(|| self.values[other])
                };
                match (below(1), above(1)) {
                    (Some(low), Some(high)) => {
                        Some(std::array::from_fn(|c| (low[c] + high[c]) / 2.0))
                    }
                    (Some(next), None) => Some(straight(next, below(2))),
                    (None, Some(next)) => Some(straight(next, above(2))),
                    (None, None) => None,
                }
            })
            .collect();
        let share = 1.0 / said.len() as f32;
        (!said.is_empty())
            .then(|| std::array::from_fn(|c| said.iter().map(|v| v[c]).sum::<f32>() * share))
    }
}

/// One node further on the line through `beyond` and `next`; `next` itself without another.
fn straight(next: [f32; 3], beyond: Option<[f32; 3]>) -> [f32; 3] {
    let beyond = beyond.unwrap_or(next);
    std::array::from_fn(|c| 2.0 * next[c] - beyond[c])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lattice(f: impl Fn([f32; 3]) -> f32) -> Lattice {
        let nodes = [6, 5, 4];
        let at_rest =
            Lattice { nodes, first_vox: [0.0; 3], step_vox: 1.0, values: vec![[0.0; 3]; 120] };
        at_rest.sampling(|at| [f(at), -f(at), 1.0])
    }

    #[test]
    fn a_straight_flow_goes_on_where_nothing_is_known() {
        let flow = |[x, y, z]: [f32; 3]| x - 0.5 * y + 0.25 * z;
        let field = lattice(flow);
        let layout = Layout { nodes: field.nodes };
        let known: Vec<bool> = (0..120).map(|n| layout.place(n)[0] < 4).collect();
        let mut holes = field.clone();
        for (value, _) in holes.values.iter_mut().zip(&known).filter(|(_, known)| !**known) {
            *value = [99.0; 3];
        }
        for (filled, value) in holes.filled(&known, None).values.iter().zip(&field.values) {
            assert!((0..3).all(|c| (filled[c] - value[c]).abs() < 1e-5), "{filled:?} {value:?}");
        }
    }

    #[test]
    fn what_is_filled_stays_within_reach_of_what_is_known() {
        let field = lattice(|[x, _, _]| x);
        let layout = Layout { nodes: field.nodes };
        let known: Vec<bool> = (0..120).map(|n| layout.place(n)[0] < 2).collect();
        let filled = field.filled(&known, None);
        assert_eq!(filled.values[layout.number([5, 2, 2])], [2.0, -2.0, 1.0]);
        let none = lattice(|_| 3.0).filled(&[false; 120], None);
        assert!(none.values.iter().all(|value| *value == [0.0; 3]));
    }

    #[test]
    fn a_known_field_is_left_as_it_is() {
        let field = lattice(|[x, y, _]| x * y);
        assert_eq!(field.clone().filled(&[true; 120], None), field);
    }
}
