//! Displacements of single particles among the nodes of a lattice.

use multiversion::multiversion;

use super::{
    super::differences::Layout,
    pairs::{PAIR_REACH_VOX, Pair},
    spline::{Spline, Taps},
};

/// Degrees of freedom of the distribution of particles' errors.
const FREEDOM: f64 = 3.0;

/// Least standard deviation of a particle's displacement, in voxels: what single precision and the
/// path's midpoint rule resolve.
const LEAST_SCALE_VOX: f64 = 2e-3;

/// The scale about a node is that of its own particles and of so many that are like all others.
const COMMON_PARTICLES: f64 = 10.0;

/// Particles seen in both frames, and where they are.
pub struct Samples<'a> {
    nodes: [usize; 3],
    pairs: &'a [Pair],
    taps: Vec<Taps>,
    nearest_node: Vec<usize>,
    /// Those in the cells that meet at each node.
    around: Vec<Vec<u32>>,
}

impl<'a> Samples<'a> {
    /// Places `pairs` among the `nodes` of the lattice whose field is `spline`.
    pub fn new(nodes: [usize; 3], spline: &Spline, pairs: &'a [Pair]) -> Self {
        let taps = pairs.iter().map(|pair| spline.taps(pair.middle_vox)).collect();
        let mut around = vec![Vec::new(); nodes.iter().product()];
        let index = |place: [usize; 3]| (place[2] * nodes[1] + place[1]) * nodes[0] + place[0];
        let mut nearest_node = Vec::with_capacity(pairs.len());
        for (number, pair) in (0u32..).zip(pairs) {
            let at = spline.node_coordinates(pair.middle_vox);
            let among = |count: usize, t: f32| (t.max(0.0) as usize).min(count - 1);
            let nearest = std::array::from_fn(|axis| among(nodes[axis], at[axis] + 0.5));
            nearest_node.push(index(nearest));
            let cell: [usize; 3] = std::array::from_fn(|axis| among(nodes[axis] - 1, at[axis]));
            for corner in 0..8 {
                let node = std::array::from_fn(|axis| cell[axis] + (corner >> axis & 1));
                around[index(node)].push(number);
            }
        }
        Self { nodes, pairs, taps, nearest_node, around }
    }

    /// How many particles are in the cells that meet at each node.
    pub fn counts(&self) -> Vec<f64> {
        self.around.iter().map(|near| near.len() as f64).collect()
    }

    /// What makes a field at each particle's place.
    pub fn taps(&self) -> &[Taps] {
        &self.taps
    }

    /// Component `c` of the displacements, in voxels.
    pub fn displacements(&self, c: usize) -> Vec<f64> {
        self.pairs.iter().map(|pair| f64::from(pair.displacement_vox[c])).collect()
    }

    /// Weights that make least squares follow most particles, for what a field leaves of their
    /// displacements: (ν + 1)/(ν + r²/s²)/s², s² the variance about the node nearest to each.
    pub fn weights(&self, residual: &[f64]) -> Vec<f64> {
        let square = self.scale_squares(residual);
        let weight = |(r, &node): (&f64, &usize)| {
            (FREEDOM + 1.0) / (FREEDOM + r * r / square[node]) / square[node]
        };
        residual.iter().zip(&self.nearest_node).map(weight).collect()
    }

    /// Variance of the particles about each node, by the median of what is left of them.
    fn scale_squares(&self, residual: &[f64]) -> Vec<f64> {
        /// Median of |r| of a normal distribution, in standard deviations.
        const MEDIAN: f64 = 0.6745;
        let common = median(residual.iter().map(|r| r.abs())).powi(2);
        self.around
            .iter()
            .map(|near| {
                let count = near.len() as f64;
                let own = median(near.iter().map(|&n| residual[n as usize].abs())).powi(2);
                let sum = count * own + COMMON_PARTICLES * common;
                let seen = sum / (count + COMMON_PARTICLES) / (MEDIAN * MEDIAN);
                beyond_reach(seen).max(LEAST_SCALE_VOX * LEAST_SCALE_VOX)
            })
            .collect()
    }

    /// Weight per cell about every node.
    pub fn density(&self, weights: &[f64]) -> Vec<f64> {
        let density = |(n, near): (usize, &Vec<u32>)| {
            near.iter().map(|&pair| weights[pair as usize]).sum::<f64>() / cells_at(self.nodes, n)
        };
        self.around.iter().enumerate().map(density).collect()
    }
}

/// Cells that meet at node `n`: eight, but fewer on faces.
pub fn cells_at(nodes: [usize; 3], n: usize) -> f64 {
    let at = |(place, nodes)| if place == 0 || place + 1 == nodes { 1.0 } else { 2.0 };
    Layout { nodes }.place(n).into_iter().zip(nodes).map(at).product()
}

/// The variance behind a scatter of variance `seen` among pairs that are no further apart than their
/// reach: the closer that is to the scatter of anything at all within reach, the less it says. The
/// fourth power is chosen, not derived: with the second, cameras 10 degrees apart are measured half
/// as well in depth as by windows alone.
fn beyond_reach(seen: f64) -> f64 {
    /// Standard deviation by the median of |x| of places all over a sphere, in radii.
    const ANYTHING: f64 = 0.515;
    let limit = (ANYTHING * f64::from(PAIR_REACH_VOX)).powi(2);
    seen / (1.0 - seen / limit).max(0.05).powi(4)
}

/// The lower median; 0 of nothing.
fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    let Some(middle) = values.len().checked_sub(1).map(|last| last / 2) else { return 0.0 };
    *values.select_nth_unstable_by(middle, f64::total_cmp).1
}

/// Values of a spline at all `taps`: B c.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
pub fn values_at(layout: Layout, taps: &[Taps], coefficients: &[f64]) -> Vec<f64> {
    taps.iter().map(|taps| taps.gather(layout, coefficients)).collect()
}

/// Adds Bᵀ of `values` at all `taps` to the coefficients `sum`.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
pub fn add_transposed(layout: Layout, taps: &[Taps], values: &[f64], sum: &mut [f64]) {
    for (taps, value) in taps.iter().zip(values) {
        taps.scatter(layout, *value, sum);
    }
}

/// Adds the diagonal of BᵀWB to `sum`.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
pub fn add_diagonal(layout: Layout, taps: &[Taps], weights: &[f64], sum: &mut [f64]) {
    for (taps, weight) in taps.iter().zip(weights) {
        taps.squared().scatter(layout, *weight, sum);
    }
}
