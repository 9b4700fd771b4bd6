//! A vector field on the nodes of a regular lattice, and its value anywhere.

use super::{layout::Layout, peak::Peak};

/// Vectors on a regular lattice in voxel coordinates, stored z, y, x.
#[derive(Debug, Clone, PartialEq)]
pub struct Lattice {
    /// Nodes along x, y, z.
    pub nodes: [usize; 3],
    /// Position of node (0, 0, 0), in voxels.
    pub first_vox: [f32; 3],
    /// Distance between nodes, in voxels.
    pub step_vox: f32,
    /// The vectors.
    pub values: Vec<[f32; 3]>,
}

/// Fixed-point iterations for paths through a field. Each reduces the error by the displacement's gradient.
const PATH_STEPS: usize = 2;

impl Lattice {
    /// Adds the shift of each node's peak, where there is one, found on cells of `cell_vox` voxels.
    pub fn add(&mut self, peaks: &[Option<Peak>], cell_vox: f32) {
        for (value, peak) in self.values.iter_mut().zip(peaks) {
            for (value, shift) in value.iter_mut().zip(peak.map_or([0.0; 3], |p| p.shift)) {
                *value += shift * cell_vox;
            }
        }
    }

    /// Whether the nodes coincide with those of `other`.
    pub fn is_over(&self, other: &Self) -> bool {
        let place = |lattice: &Self| (lattice.nodes, lattice.first_vox, lattice.step_vox);
        place(self) == place(other)
    }

    /// The nodes of this lattice with the values of `field` at their positions.
    pub fn sampling(mut self, field: impl Fn([f32; 3]) -> [f32; 3]) -> Self {
        let layout = Layout { nodes: self.nodes };
        for (index, value) in self.values.iter_mut().enumerate() {
            let node = layout.place(index);
            let place = |axis: usize| self.first_vox[axis] + self.step_vox * node[axis] as f32;
            *value = field(std::array::from_fn(place));
        }
        self
    }

    /// A lattice of half the step on the same place, at rest.
    pub fn finer(&self) -> Self {
        let nodes = self.nodes.map(|n| 2 * n - 1);
        Self {
            nodes,
            first_vox: self.first_vox,
            step_vox: self.step_vox / 2.0,
            values: vec![[0.0; 3]; nodes.iter().product()],
        }
    }

    /// The way from where the light is in its own frame to where it is in the middle of the pair,
    /// if this field is the displacement: half of it, forwards for frame a (`sign` 1) and backwards
    /// for frame b (−1).
    ///
    /// The path is curved. It is integrated by the midpoint rule, so that the field is the velocity at mid-pair at
    /// that position. Half the chord has an error of (d·∇)d/8.
    pub fn half_paths(&self, sign: f32) -> Self {
        self.finer().sampling(|at| {
            let start = self.at(at);
            let halfway = std::array::from_fn(|c| at[c] + sign * start[c] / 4.0);
            self.at(halfway).map(|d| sign * d / 2.0)
        })
    }

    /// This displacement, whose vectors refer to positions in frame a, with vectors at mid-pair positions; along the
    /// same curved paths as [`Self::half_paths`].
    pub fn carried_to_middle(&self) -> Self {
        let mut middle = self.clone();
        for _ in 0..PATH_STEPS {
            middle = self.clone().sampling(|at| {
                let there = middle.at(at);
                let halfway = middle.at(std::array::from_fn(|c| at[c] - there[c] / 4.0));
                self.at(std::array::from_fn(|c| at[c] - halfway[c] / 2.0))
            });
        }
        middle
    }

    /// The vector of the node nearest to a position.
    pub fn nearest(&self, position_vox: [f32; 3]) -> [f32; 3] {
        self.values[self.nearest_node(position_vox)]
    }

    /// The node nearest to a position.
    pub fn nearest_node(&self, position_vox: [f32; 3]) -> usize {
        let at = self.coordinates(position_vox);
        // The cast takes what is below zero to zero.
        let node = |axis: usize| (at[axis].round() as usize).min(self.nodes[axis] - 1);
        Layout { nodes: self.nodes }.number(std::array::from_fn(node))
    }

    /// A position in node distances from the first node.
    pub fn coordinates(&self, position_vox: [f32; 3]) -> [f32; 3] {
        std::array::from_fn(|axis| (position_vox[axis] - self.first_vox[axis]) / self.step_vox)
    }

    /// The field at a position: cubic convolution (Keys 1981) between the nodes, linear outside.
    #[inline(always)]
    pub fn at(&self, position_vox: [f32; 3]) -> [f32; 3] {
        let along = |axis: usize| -> AxisTaps {
            let t = (position_vox[axis] - self.first_vox[axis]) / self.step_vox;
            axis_taps(t, self.nodes[axis])
        };
        let taps = [along(0), along(1), along(2)];
        let [nx, ny, _] = self.nodes;
        let mut sum = [0.0; 3];
        for (&k, wz) in taps[2].0.iter().zip(taps[2].1) {
            for (&j, wy) in taps[1].0.iter().zip(taps[1].1) {
                let row = &self.values[(k * ny + j) * nx..][..nx];
                let mut along = [0.0; 3];
                for (&i, wx) in taps[0].0.iter().zip(taps[0].1) {
                    for (sum, value) in along.iter_mut().zip(row[i]) {
                        *sum += wx * value;
                    }
                }
                for (sum, along) in sum.iter_mut().zip(along) {
                    *sum += wz * wy * along;
                }
            }
        }
        sum
    }
}

/// Four nodes along an axis and their weights.
pub type AxisTaps = ([usize; 4], [f32; 4]);

/// Four nodes and their weights at node coordinate `t`. A node beyond an end is replaced by the
/// linear extrapolation of the two nodes at that end.
#[inline(always)]
pub fn axis_taps(t: f32, count: usize) -> AxisTaps {
    if count == 1 {
        return ([0; 4], [1.0, 0.0, 0.0, 0.0]);
    }
    let last = count as i64 - 1;
    // Truncation is the floor of what is not negative; below, the first cell is meant anyway.
    let cell = (t as i64).clamp(0, last - 1);
    let u = t - cell as f32;
    let weights = if (0.0..=1.0).contains(&u) {
        [
            ((2.0 - u) * u - 1.0) * u / 2.0,
            ((3.0 * u - 5.0) * u * u + 2.0) / 2.0,
            ((4.0 - 3.0 * u) * u + 1.0) * u / 2.0,
            (u - 1.0) * u * u / 2.0,
        ]
    } else {
        [0.0, 1.0 - u, u, 0.0]
    };
    let mut nodes = [0; 4];
    let mut folded = weights;
    for (n, node) in nodes.iter_mut().enumerate() {
        let place = cell - 1 + n as i64;
        *node = place.clamp(0, last) as usize;
        if place < 0 {
            folded[0] = 0.0;
            folded[1] += 2.0 * weights[0];
            folded[2] -= weights[0];
        } else if place > last {
            folded[3] = 0.0;
            folded[2] += 2.0 * weights[3];
            folded[1] -= weights[3];
        }
    }
    (nodes, folded)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lattice(f: impl Fn([f32; 3]) -> f32) -> Lattice {
        let nodes = [5, 4, 6];
        let mut values = Vec::new();
        for k in 0..6 {
            for j in 0..4 {
                for i in 0..5 {
                    let v = f([i, j, k].map(|n| 7.5 + 8.0 * n as f32));
                    values.push([v, -v, 2.0 * v]);
                }
            }
        }
        Lattice { nodes, first_vox: [7.5; 3], step_vox: 8.0, values }
    }

    #[test]
    fn linear_fields_are_exact_inside_and_outside() {
        let plane = |p: [f32; 3]| 0.1 * p[0] - 0.2 * p[1] + 0.05 * p[2] + 1.0;
        let field = lattice(plane);
        for p in [[7.5, 7.5, 7.5], [20.0, 11.0, 30.0], [0.0, 40.0, 60.0], [44.0, 2.0, -4.0]] {
            let value = field.at(p);
            assert!((value[0] - plane(p)).abs() < 1e-4, "{p:?} {value:?}");
            assert!((value[2] - 2.0 * plane(p)).abs() < 2e-4);
        }
    }

    #[test]
    fn nodes_are_reproduced() {
        let field = lattice(|p| (p[0] * 0.1).sin() + p[1] * p[2] * 0.01);
        assert!(
            (field.at([23.5, 15.5, 31.5])[0] - field.values[(3 * 4 + 1) * 5 + 2][0]).abs() < 1e-5
        );
    }
}
