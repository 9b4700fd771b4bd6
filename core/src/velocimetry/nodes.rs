//! Where the coefficients of a cubic B-spline field stand, and which of them make it at a place.

use super::{b_spline, layout::Layout};

/// The coefficients' places: one on every node of a lattice and one beyond each of its ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nodes {
    /// The coefficients in memory.
    pub layout: Layout,
    /// Place of coefficient (1, 1, 1), in voxels.
    pub first_vox: [f32; 3],
    /// From one to the next, in voxels.
    pub step_vox: f32,
}

/// The 4 × 4 × 4 coefficients that make a field at a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Taps {
    /// Index of the first of them.
    pub first: usize,
    /// Weights along x, y, z.
    pub weights: [[f32; 4]; 3],
}

impl Nodes {
    /// Nodes `step_vox` apart over a box from `low_vox` to `high_vox`, which they reach beyond evenly; at
    /// least two cells along every axis.
    pub fn covering(low_vox: [f32; 3], high_vox: [f32; 3], step_vox: f32) -> Self {
        let cells: [usize; 3] = std::array::from_fn(|axis| {
            (((high_vox[axis] - low_vox[axis]) / step_vox).ceil() as usize).max(2)
        });
        let first_vox = std::array::from_fn(|axis| {
            let length = cells[axis] as f32 * step_vox;
            (low_vox[axis] + high_vox[axis] - length) / 2.0
        });
        Self { layout: Layout { nodes: cells.map(|n| n + 3) }, first_vox, step_vox }
    }

    /// Cells between the nodes along an axis.
    pub fn cells(&self, axis: usize) -> usize {
        self.layout.nodes[axis] - 3
    }

    /// Cells between all nodes.
    pub fn all_cells(&self) -> usize {
        (0..3).map(|axis| self.cells(axis)).product()
    }

    /// What makes a field at a place, or at the nearest one between the nodes.
    pub fn taps(&self, at_vox: [f32; 3]) -> Taps {
        self.taps_by(at_vox, |_, t| b_spline::weights(t))
    }

    /// What makes the field's derivative along `along`, per voxel, at such a place.
    pub fn derivative_taps(&self, at_vox: [f32; 3], along: usize) -> Taps {
        self.taps_by(at_vox, |axis, t| {
            if axis == along {
                b_spline::slopes(t).map(|slope| slope / self.step_vox)
            } else {
                b_spline::weights(t)
            }
        })
    }

    /// Numbers of places, in the order of the coefficients that make the field there: those that are worked on one
    /// after the other are near to each other.
    pub fn order(&self, places_vox: impl Iterator<Item = [f32; 3]>) -> Vec<usize> {
        let firsts: Vec<usize> = places_vox.map(|at_vox| self.taps(at_vox).first).collect();
        let mut order: Vec<usize> = (0..firsts.len()).collect();
        order.sort_by_key(|&n| firsts[n]);
        order
    }

    /// Place of coefficient `n`, in voxels.
    pub fn place_vox(&self, n: usize) -> [f32; 3] {
        let place = self.layout.place(n);
        std::array::from_fn(|axis| {
            self.first_vox[axis] + self.step_vox * (place[axis] as f32 - 1.0)
        })
    }

    /// Index of the coefficient nearest to a place.
    pub fn nearest(&self, at_vox: [f32; 3]) -> usize {
        let at = self.coordinates(at_vox);
        self.layout.number(std::array::from_fn(|axis| {
            (at[axis] + 1.5).clamp(1.0, (self.layout.nodes[axis] - 2) as f32) as usize
        }))
    }

    /// Place in node distances from coefficient (1, 1, 1).
    pub fn coordinates(&self, at_vox: [f32; 3]) -> [f32; 3] {
        std::array::from_fn(|axis| (at_vox[axis] - self.first_vox[axis]) / self.step_vox)
    }

    fn taps_by(&self, at_vox: [f32; 3], weights: impl Fn(usize, f32) -> [f32; 4]) -> Taps {
        let at = self.coordinates(at_vox);
        let (mut first, mut all) = (0, [[0.0; 4]; 3]);
        for axis in 0..3 {
            let cells = self.cells(axis);
            let t = at[axis].clamp(0.0, cells as f32);
            let cell = (t as usize).min(cells - 1);
            first += cell * self.layout.stride(axis);
            all[axis] = weights(axis, t - cell as f32);
        }
        Taps { first, weights: all }
    }
}

impl Taps {
    /// Those of node `n` of a lattice of `nodes` whose spline's coefficients lie in `layout`.
    pub fn of_node(layout: Layout, nodes: [usize; 3], n: usize) -> Self {
        let place = Layout { nodes }.place(n);
        // The node's own coefficient is one further along every axis, the second of the taps.
        let (mut first, mut weights) = (layout.number(place), [b_spline::weights(0.0); 3]);
        for axis in 0..3 {
            // At the last cell's end the four taps begin one node before, so that they stay inside.
            if place[axis] + 1 == nodes[axis] {
                first -= layout.stride(axis);
                weights[axis] = b_spline::weights(1.0);
            }
        }
        Self { first, weights }
    }

    /// The field of interleaved coefficients.
    #[inline(always)]
    pub fn gather<const N: usize>(&self, layout: Layout, from: &[[f32; N]]) -> [f32; N] {
        let [wx, wy, wz] = self.weights;
        let mut sum = [0.0; N];
        for (k, wz) in wz.into_iter().enumerate() {
            for (j, wy) in wy.into_iter().enumerate() {
                let weight = wz * wy;
                let row = &from[self.first + row_of(layout, j, k)..][..4];
                for (i, wx) in wx.into_iter().enumerate() {
                    let weight = weight * wx;
                    for (sum, value) in sum.iter_mut().zip(row[i]) {
                        *sum += weight * value;
                    }
                }
            }
        }
        sum
    }

    /// The field of one component's coefficients, in double precision.
    #[inline(always)]
    pub fn gather_component(&self, layout: Layout, from: &[f64]) -> f64 {
        let [wx, wy, wz] = self.weights.map(|w| w.map(f64::from));
        // Summed along x last: four lanes that never meet until the end.
        let mut lanes = [0.0; 4];
        for (k, wz) in wz.into_iter().enumerate() {
            for (j, wy) in wy.into_iter().enumerate() {
                let weight = wz * wy;
                let row = &from[self.first + row_of(layout, j, k)..][..4];
                for (lane, value) in lanes.iter_mut().zip(row) {
                    *lane += weight * value;
                }
            }
        }
        let [a, b, c, d] = std::array::from_fn(|i| wx[i] * lanes[i]);
        (a + b) + (c + d)
    }

    /// Adds `value` times the weights to all coefficients of a component: the transpose of [`Self::gather_component`].
    #[inline(always)]
    pub fn scatter_component(&self, layout: Layout, value: f64, to: &mut [f64]) {
        let [wx, wy, wz] = self.weights.map(|w| w.map(f64::from));
        let along = wx.map(|wx| value * wx);
        for (k, wz) in wz.into_iter().enumerate() {
            for (j, wy) in wy.into_iter().enumerate() {
                let weight = wz * wy;
                let row = &mut to[self.first + row_of(layout, j, k)..][..4];
                for (to, along) in row.iter_mut().zip(along) {
                    *to += weight * along;
                }
            }
        }
    }

    /// Coefficients in memory from the first to the last of them.
    pub fn span(layout: Layout) -> usize {
        3 * (0..3).map(|axis| layout.stride(axis)).sum::<usize>() + 1
    }

    /// Adds `values` times the weights to the coefficients from the first of them on: the transpose of
    /// [`Self::gather`].
    #[inline(always)]
    pub fn scatter<const N: usize>(&self, layout: Layout, values: [f32; N], to: &mut [[f32; N]]) {
        let [wx, wy, wz] = self.weights;
        for (k, wz) in wz.into_iter().enumerate() {
            for (j, wy) in wy.into_iter().enumerate() {
                let weight = wz * wy;
                let row = &mut to[row_of(layout, j, k)..][..4];
                for (i, wx) in wx.into_iter().enumerate() {
                    let weight = weight * wx;
                    for (to, value) in row[i].iter_mut().zip(values) {
                        *to += weight * value;
                    }
                }
            }
        }
    }

    /// The squares of the weights, on the same coefficients.
    #[inline(always)]
    pub fn squared(&self) -> Self {
        Self { first: self.first, weights: self.weights.map(|w| w.map(|w| w * w)) }
    }
}

/// Coefficients from the first tap to the first one of row (j, k).
#[inline(always)]
fn row_of(layout: Layout, j: usize, k: usize) -> usize {
    j * layout.stride(1) + k * layout.stride(2)
}
