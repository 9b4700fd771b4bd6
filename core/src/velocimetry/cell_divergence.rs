//! Divergence of a spline field in the middle of every cell between its nodes, and the transpose of this operator.
//! Its square is the penalty of an incompressible flow (Gesemann et al., From noisy particle tracks to velocity,
//! acceleration and pressure fields using B-splines and penalties, 18th Int. Symp. Lisbon, 2016).

use multiversion::multiversion;
use rayon::prelude::*;

use super::{
    b_spline::{HALFWAY, HALFWAY_SLOPES},
    layout::Layout,
};

/// Standard deviation of the divergence in an incompressible flow, in voxel per voxel. It is not zero, because
/// displacements are chords of curved paths, splines only approximate short waves, and errors of neighbouring
/// particles are correlated.
pub const DIVERGENCE_DEVIATION: f64 = 0.01;

/// A coefficient of one field, or of several fields side by side.
pub trait Coefficient: Copy + Default + Send + Sync {
    /// A factor in its own precision.
    type Weight: Copy + Send + Sync;

    fn weight(value: f64) -> Self::Weight;

    /// Adds `weight` times `value`.
    fn add(&mut self, weight: Self::Weight, value: &Self);
}

impl Coefficient for f64 {
    type Weight = f64;

    fn weight(value: f64) -> f64 {
        value
    }

    #[inline(always)]
    fn add(&mut self, weight: f64, value: &Self) {
        *self += weight * value;
    }
}

impl<const LANES: usize> Coefficient for [f32; LANES]
where
    [f32; LANES]: Default,
{
    type Weight = f32;

    fn weight(value: f64) -> f32 {
        value as f32
    }

    #[inline(always)]
    fn add(&mut self, weight: f32, value: &Self) {
        for l in 0..LANES {
            self[l] += weight * value[l];
        }
    }
}

/// The cells between the nodes of a spline field.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cells {
    /// The coefficients of one component.
    pub layout: Layout,
    /// Node spacing, in voxels.
    pub step_vox: f64,
}

impl Cells {
    /// Whether a cell is in the middle of the coefficients from `n` on.
    pub fn starts(&self, n: usize) -> bool {
        (0..3).all(|axis| self.layout.starts(axis, n))
    }

    /// D c: the divergence in the cell in the middle of the coefficients from each one on, in voxel per voxel.
    /// Meaningless where no cell [starts](Self::starts).
    pub fn divergence<T: Coefficient>(&self, components: [&[T]; 3]) -> Vec<T> {
        let derivative = |c: usize| {
            let mut along = components[c].to_vec();
            for axis in 0..3 {
                gather(self.layout.stride(axis), self.weights::<T>(c, axis), &mut along);
            }
            along
        };
        let derivatives: Vec<Vec<T>> = (0..3usize).into_par_iter().map(derivative).collect();
        let one = T::weight(1.0);
        let sum = |n: usize| {
            let mut sum = derivatives[0][n];
            sum.add(one, &derivatives[1][n]);
            sum.add(one, &derivatives[2][n]);
            sum
        };
        (0..self.layout.len()).map(sum).collect()
    }

    /// Adds Dᵀ d to the coefficients of the three components. `of_cells`, d, is zero where no cell starts.
    pub fn add_transposed<T: Coefficient>(&self, of_cells: &[T], sums: [&mut [T]; 3]) {
        let one = T::weight(1.0);
        sums.into_par_iter().enumerate().for_each(|(c, sum)| {
            let mut part = of_cells.to_vec();
            for axis in 0..3 {
                scatter(self.layout.stride(axis), self.weights::<T>(c, axis), &mut part);
            }
            sum.iter_mut().zip(&part).for_each(|(sum, part)| sum.add(one, part));
        });
    }

    /// The diagonal of Dᵀ D away from the faces, the same for all coefficients.
    pub fn diagonal(&self) -> f64 {
        let square = |weights: [f64; 4]| weights.iter().map(|w| w * w).sum::<f64>();
        (0..3).map(|axis| square(self.weights::<f64>(0, axis))).product()
    }

    /// Weights along `axis` of component `c`.
    fn weights<T: Coefficient>(&self, c: usize, axis: usize) -> [T::Weight; 4] {
        let weights =
            if axis == c { HALFWAY_SLOPES.map(|slope| slope / self.step_vox) } else { HALFWAY };
        weights.map(T::weight)
    }
}

/// Each value replaced by the weighted sum of itself and the three after it, `s` apart. Values beyond the end
/// count as zero.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn gather<T: Coefficient>(s: usize, weights: [T::Weight; 4], values: &mut [T]) {
    for n in 0..values.len() {
        let mut sum = T::default();
        for (place, weight) in weights.into_iter().enumerate() {
            if let Some(value) = values.get(n + place * s) {
                sum.add(weight, value);
            }
        }
        values[n] = sum;
    }
}

/// The transpose of [`gather`].
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn scatter<T: Coefficient>(s: usize, weights: [T::Weight; 4], values: &mut [T]) {
    for n in (0..values.len()).rev() {
        let mut sum = T::default();
        for (place, weight) in weights.into_iter().enumerate() {
            if place * s <= n {
                sum.add(weight, &values[n - place * s]);
            }
        }
        values[n] = sum;
    }
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;

    const CELLS: Cells = Cells { layout: Layout { nodes: [5, 6, 4] }, step_vox: 4.0 };

    /// Numbers and weights of the coefficients that make the divergence of the cell from `cell` on, written out.
    fn terms(cell: usize) -> Vec<(usize, usize, f64)> {
        let mut terms = Vec::new();
        for (c, tap) in (0..3).flat_map(|c| (0..64usize).map(move |tap| (c, tap))) {
            let at = [tap % 4, tap / 4 % 4, tap / 16];
            let along = |axis: usize| {
                let of = at[axis];
                if axis == c { HALFWAY_SLOPES[of] / CELLS.step_vox } else { HALFWAY[of] }
            };
            let offset: usize = (0..3).map(|axis| at[axis] * CELLS.layout.stride(axis)).sum();
            terms.push((c, cell + offset, (0..3).map(along).product()));
        }
        terms
    }

    fn random_field() -> [Vec<f64>; 3] {
        let mut random = Pcg64Mcg::seed_from_u64(3);
        [(); 3].map(|()| (0..CELLS.layout.len()).map(|_| random.random::<f64>() - 0.5).collect())
    }

    #[test]
    fn the_operator_and_its_transpose_are_those_written_out() {
        let field = random_field();
        let components = field.each_ref().map(|part| &part[..]);
        let mut found = CELLS.divergence(components);
        let mut expected = [(); 3].map(|()| vec![0.0; CELLS.layout.len()]);
        let mut diagonal = expected.clone();
        for (n, found) in found.iter_mut().enumerate() {
            if !CELLS.starts(n) {
                *found = 0.0;
                continue;
            }
            let value: f64 = terms(n).iter().map(|&(c, at, weight)| weight * field[c][at]).sum();
            assert!((*found - value).abs() < 1e-12, "{found} {value}");
            for (c, at, weight) in terms(n) {
                expected[c][at] += weight * value;
                diagonal[c][at] += weight * weight;
            }
        }
        let mut sums = [(); 3].map(|()| vec![0.0; CELLS.layout.len()]);
        CELLS.add_transposed(&found, sums.each_mut().map(|sum| &mut sum[..]));
        for (found, expected) in sums.iter().flatten().zip(expected.iter().flatten()) {
            assert!((found - expected).abs() < 1e-12, "{found} {expected}");
        }
        assert!(diagonal.iter().flatten().all(|own| *own <= 1.0001 * CELLS.diagonal()));
    }

    #[test]
    fn fields_side_by_side_have_the_divergence_of_each() {
        let field = random_field();
        let doubled = field.each_ref().map(|part| -> Vec<[f32; 2]> {
            part.iter().map(|&value| [value as f32, 2.0 * value as f32]).collect()
        });
        let one = CELLS.divergence(field.each_ref().map(|part| &part[..]));
        let two = CELLS.divergence(doubled.each_ref().map(|part| &part[..]));
        for (n, (one, two)) in one.iter().zip(two).enumerate().filter(|(n, _)| CELLS.starts(*n)) {
            let close = |factor: f64, found: f32| (factor * one - f64::from(found)).abs() < 1e-6;
            assert!(close(1.0, two[0]) && close(2.0, two[1]), "{n}: {one} {two:?}");
        }
    }

    #[test]
    fn a_rotation_has_none() {
        let place = |n: usize| CELLS.layout.place(n).map(|n| n as f64);
        let along = |of: fn([f64; 3]) -> f64| -> Vec<f64> {
            (0..CELLS.layout.len()).map(|n| of(place(n))).collect()
        };
        let [u, v, w] = [along(|[_, y, _]| 0.3 * y), along(|[x, _, _]| -0.3 * x), along(|_| 0.1)];
        let divergence = CELLS.divergence([&u, &v, &w]);
        let inside = (0..divergence.len()).filter(|&n| CELLS.starts(n));
        inside.for_each(|n| assert!(divergence[n].abs() < 1e-12, "{}", divergence[n]));
    }
}
