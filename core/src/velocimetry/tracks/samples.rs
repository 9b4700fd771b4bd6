//! Displacements of single particles, and their weights, on the nodes of a lattice.

use multiversion::multiversion;
use rayon::prelude::*;

use super::{
    super::{layout::Layout, nodes::Taps},
    pairs::Pair,
    spline::Spline,
};
use crate::statistics::{lower_quartile, median};

/// Degrees of freedom of the distribution of particles' errors.
const DEGREES_OF_FREEDOM: f64 = 2.0;

/// Least standard deviation of a particle's displacement, in voxels: numerical error of single precision and of
/// the midpoint rule.
const SMALLEST_DEVIATION_VOX: f64 = 2e-3;

/// Weight of the prior for the variance at a node, in particles: the estimate is shrunk towards that of all
/// particles.
const PRIOR_PARTICLES: f64 = 10.0;

/// Largest standard deviation of a single particle's light along any axis, in voxels. Two particles that
/// overlap are wider. This and the two below: docs/decisions.md, "Fitted constants".
const SINGLE_SPREAD_VOX: f64 = 0.15;

/// Standard deviation of light along an axis above which it does not determine a particle's position, in voxels.
const BLURRED_SPREAD_VOX: f64 = 0.25;

/// Share of the median particle's light at which a particle's variance is doubled.
const FAINT: f64 = 0.7;

/// Largest variance of a reliable particle, relative to that of a bright single one.
const RELIABLE_VARIANCE: f64 = 5.0;

/// Least number of reliable particles near a node to accept its vector where the correlation had none,
const LEAST_RELIABLE_PARTICLES: usize = 10;

/// and largest ratio of their median residual to that of particles paired by chance.
const LARGEST_RESIDUAL_SHARE: f64 = 0.75;

/// Median residual of particles paired by chance, in search radii: the median of |x| of points uniformly
/// distributed in a sphere.
const CHANCE_RESIDUAL: f64 = 0.347;

/// Particles in both frames, and their weights.
pub struct Samples<'a> {
    nodes: [usize; 3],
    pairs: &'a [Pair],
    taps: Vec<Taps>,
    nearest_node: Vec<usize>,
    /// Indices of the particles in the cells that meet at each node.
    around: Vec<Vec<u32>>,
    /// Variance of each along x, y, z relative to that of a bright single particle.
    relative_variances: Vec<[f64; 3]>,
    /// See [`Self::variance_inflation`].
    variance_inflation: Vec<[f64; 3]>,
}

impl<'a> Samples<'a> {
    /// Places `pairs` among the `nodes` of the lattice whose field is `spline`.
    pub fn new(nodes: [usize; 3], spline: &Spline, pairs: &'a [Pair]) -> Self {
        let taps = pairs.iter().map(|pair| spline.taps(pair.middle_vox)).collect();
        let mut around = vec![Vec::new(); nodes.iter().product()];
        let layout = Layout { nodes };
        let mut nearest_node = Vec::with_capacity(pairs.len());
        for (number, pair) in (0u32..).zip(pairs) {
            let at = spline.nodes.coordinates(pair.middle_vox);
            let among = |count: usize, t: f32| (t.max(0.0) as usize).min(count - 1);
            let nearest = std::array::from_fn(|axis| among(nodes[axis], at[axis] + 0.5));
            nearest_node.push(layout.number(nearest));
            let cell: [usize; 3] = std::array::from_fn(|axis| among(nodes[axis] - 1, at[axis]));
            for corner in 0..8 {
                let node = std::array::from_fn(|axis| cell[axis] + (corner >> axis & 1));
                around[layout.number(node)].push(number);
            }
        }
        let (relative_variances, variance_inflation) =
            (relative_variances(pairs), variance_inflation(pairs, &around));
        Self { nodes, pairs, taps, nearest_node, around, relative_variances, variance_inflation }
    }

    /// Number of particles in the cells that meet at each node.
    pub fn counts(&self) -> Vec<f64> {
        self.around.iter().map(|near| near.len() as f64).collect()
    }

    /// Variance at each node relative to that of particles with compact light, along x, y, z.
    pub fn variance_inflation(&self) -> &[[f64; 3]] {
        &self.variance_inflation
    }

    /// Interpolation weights at each particle's position.
    pub fn taps(&self) -> &[Taps] {
        &self.taps
    }

    /// Component `c` of the displacements, in voxels.
    pub fn displacements(&self, c: usize) -> Vec<f64> {
        self.pairs.iter().map(|pair| f64::from(pair.displacement_vox[c])).collect()
    }

    /// Weights of iteratively reweighted least squares, from the residuals r of component `c`:
    /// (ν + 1)/(ν + r²/s²)/s², s² the variance of each.
    pub fn weights(&self, c: usize, residual: &[f64]) -> Vec<f64> {
        let scaled: Vec<f64> = residual
            .iter()
            .zip(&self.relative_variances)
            .map(|(r, relative_variance)| r.abs() / relative_variance[c].sqrt())
            .collect();
        let common = median(scaled.iter().copied()).unwrap_or_default().powi(2);
        let about: Vec<f64> = (0..self.around.len())
            .into_par_iter()
            .map(|node| self.variance_about(node, c, &scaled, common))
            .collect();
        let weight = |n: usize| {
            let square = about[self.nearest_node[n]] * self.relative_variances[n][c];
            (DEGREES_OF_FREEDOM + 1.0)
                / (DEGREES_OF_FREEDOM + residual[n] * residual[n] / square)
                / square
        };
        (0..residual.len()).map(weight).collect()
    }

    /// Variance of component `c` of a bright single particle at a node, from the median of the `scaled` residuals
    /// there and that of all particles, whose square is `common`.
    fn variance_about(&self, node: usize, c: usize, scaled: &[f64], common: f64) -> f64 {
        /// Median of |r| of a normal distribution, in standard deviations.
        const MEDIAN: f64 = 0.6745;
        let near = &self.around[node];
        let own = median(near.iter().map(|&n| scaled[n as usize])).unwrap_or_default().powi(2);
        let seen = shrunk(near.len(), own, common) / (MEDIAN * MEDIAN);
        (seen * self.variance_inflation[node][c])
            .max(SMALLEST_DEVIATION_VOX * SMALLEST_DEVIATION_VOX)
    }

    /// Whether enough reliable particles near each node agree with the field `spline` better than particles paired by
    /// chance within `reach_vox`.
    pub fn agree(&self, spline: &Spline, reach_vox: f32) -> Vec<bool> {
        let missed = |(taps, pair): (&Taps, &Pair)| -> [f64; 3] {
            let value = spline.of(taps);
            std::array::from_fn(|c| (f64::from(pair.displacement_vox[c]) - value[c]).abs())
        };
        let missed: Vec<[f64; 3]> = self.taps.iter().zip(self.pairs).map(missed).collect();
        let most = LARGEST_RESIDUAL_SHARE * CHANCE_RESIDUAL * f64::from(reach_vox);
        let follow = |near: &Vec<u32>, c: usize| {
            let clear = near
                .iter()
                .map(|&n| n as usize)
                .filter(|&n| self.relative_variances[n][c] < RELIABLE_VARIANCE);
            let missed: Vec<f64> = clear.map(|n| missed[n][c]).collect();
            missed.len() >= LEAST_RELIABLE_PARTICLES
                && median(missed).is_some_and(|missed| missed <= most)
        };
        self.around.iter().map(|near| (0..3).all(|c| follow(near, c))).collect()
    }

    /// Weight per cell at every node.
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

/// Shrinkage estimate: the value `own` of `count` particles, shrunk towards the `common` one.
fn shrunk(count: usize, own: f64, common: f64) -> f64 {
    let count = count as f64;
    (count * own + PRIOR_PARTICLES * common) / (count + PRIOR_PARTICLES)
}

/// Variance of particles along x, y, z relative to that of a bright single particle. It is larger for wide light,
/// which comes from two particles whose mixture differs between the frames, and for faint light, which is an
/// artefact of reconstruction.
pub fn relative_variances(pairs: &[Pair]) -> Vec<[f64; 3]> {
    let typical = median(pairs.iter().map(|pair| pair.light)).unwrap_or_default();
    let relative_variance = |pair: &Pair| {
        let faint = FAINT * typical / f64::from(pair.light);
        pair.spread_vox2.map(|spread| {
            let wide = f64::from(spread) / (SINGLE_SPREAD_VOX * SINGLE_SPREAD_VOX);
            (1.0 + faint * faint) * (1.0 + wide.powi(3))
        })
    };
    pairs.iter().map(relative_variance).collect()
}

/// Factor on the variance of all particles near each node along an axis on which even the narrowest quarter of them
/// is wide. Where the cameras do not resolve depth, the centre of the light in both frames is that of the region
/// between the lines of sight and depends little on the particle's position.
fn variance_inflation(pairs: &[Pair], around: &[Vec<u32>]) -> Vec<[f64; 3]> {
    let mut variance_inflation = vec![[1.0; 3]; around.len()];
    for c in 0..3 {
        let spread = |n: usize| f64::from(pairs[n].spread_vox2[c]);
        let common = lower_quartile((0..pairs.len()).map(spread)).unwrap_or_default();
        variance_inflation.par_iter_mut().zip(around).for_each(|(blur, near)| {
            let own = lower_quartile(near.iter().map(|&n| spread(n as usize))).unwrap_or_default();
            let seen = shrunk(near.len(), own, common);
            let told = 1.0 - seen / (BLURRED_SPREAD_VOX * BLURRED_SPREAD_VOX);
            blur[c] = told.max(0.1).powi(-3);
        });
    }
    variance_inflation
}

/// Values of a spline at all `taps`: B c.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
pub fn values_at(layout: Layout, taps: &[Taps], coefficients: &[f64]) -> Vec<f64> {
    taps.iter().map(|taps| taps.gather_component(layout, coefficients)).collect()
}

/// Adds Bᵀ of `values` at all `taps` to the coefficients `sum`.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
pub fn add_transposed(layout: Layout, taps: &[Taps], values: &[f64], sum: &mut [f64]) {
    for (taps, value) in taps.iter().zip(values) {
        taps.scatter_component(layout, *value, sum);
    }
}

/// Adds BᵀWB of the coefficients to `sum`.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
pub fn add_product(
    layout: Layout,
    taps: &[Taps],
    weights: &[f64],
    coefficients: &[f64],
    sum: &mut [f64],
) {
    for (taps, weight) in taps.iter().zip(weights) {
        let value = taps.gather_component(layout, coefficients);
        taps.scatter_component(layout, weight * value, sum);
    }
}

/// Adds the diagonal of BᵀWB to `sum`.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
pub fn add_diagonal(layout: Layout, taps: &[Taps], weights: &[f64], sum: &mut [f64]) {
    for (taps, weight) in taps.iter().zip(weights) {
        taps.squared().scatter_component(layout, *weight, sum);
    }
}
