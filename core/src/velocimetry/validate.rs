//! Detection of outliers, and interpolation of their replacements.

mod lanes;

use rayon::prelude::*;

use super::{
    flow_nodes::{FlowNodes, cube_index},
    layout::Layout,
};
use crate::statistics::median;

/// Least number of neighbours for the test.
const LEAST_NEIGHBOURS: usize = 4;

/// Vectors on a lattice, some of them missing.
#[derive(Debug)]
pub struct Candidates<'a> {
    /// Vectors along x, y, z.
    pub nodes: [usize; 3],
    /// Stored z, y, x.
    pub values: &'a [[f32; 3]],
    /// Whether each vector was measured.
    pub present: &'a [bool],
    /// Which neighbours belong to the same flow; all of them if absent.
    pub flow: Option<&'a FlowNodes>,
}

impl Candidates<'_> {
    /// The normalised median test (Westerweel and Scarano, Exp. Fluids 39, 2005): a vector fails
    /// when a component differs from its neighbours' median by more than `threshold` times
    /// (their median residual + `epsilon_vox`). Missing vectors fail.
    ///
    /// Neighbours are first extrapolated to the vector's position along the median gradient: at a face of the
    /// volume all neighbours lie on one side, and a plain median would reject every shear flow. The test runs
    /// twice, the second time without the neighbours that failed, so that one outlier does not invalidate those
    /// around it.
    pub fn passing(&self, threshold: f64, epsilon_vox: f64) -> Vec<bool> {
        let all: Vec<usize> = (0..self.values.len()).collect();
        let test = |nodes: &[usize], trusted: &[bool]| -> Vec<bool> {
            let judged = |some: &[usize]| self.judged(some, trusted, threshold, epsilon_vox);
            let all: Vec<_> = nodes.par_chunks(lanes::LANES).map(judged).collect();
            all.into_iter().flatten().take(nodes.len()).collect()
        };
        let once = test(&all, self.present);
        // The result is unchanged for vectors whose neighbours all passed.
        let mut beside_failed = vec![false; all.len()];
        for n in (0..all.len()).filter(|&n| !once[n]) {
            self.for_each_near(n, |_, other| beside_failed[other] = true);
        }
        let again: Vec<usize> = all.into_iter().filter(|&n| beside_failed[n]).collect();
        let mut pass = once.clone();
        for (&n, verdict) in again.iter().zip(test(&again, &once)) {
            pass[n] = verdict;
        }
        pass
    }

    /// The test of up to as many vectors as there are lanes.
    fn judged(
        &self,
        some: &[usize],
        trusted: &[bool],
        threshold: f64,
        epsilon_vox: f64,
    ) -> [bool; lanes::LANES] {
        let mut around: lanes::Around = [[[f32::INFINITY; lanes::LANES]; 27]; 3];
        let mut own = [[0.0; lanes::LANES]; 3];
        for (lane, &index) in some.iter().enumerate() {
            for (own, value) in own.iter_mut().zip(self.values[index]) {
                own[lane] = value;
            }
            self.for_each_near(index, |place, other| {
                if trusted[other] {
                    for (around, value) in around.iter_mut().zip(self.values[other]) {
                        around[place][lane] = value;
                    }
                }
            });
        }
        let mut pass = lanes::judge(&around, &own, threshold, epsilon_vox, LEAST_NEIGHBOURS);
        for (pass, &index) in pass.iter_mut().zip(some) {
            *pass &= self.present[index];
        }
        pass
    }

    /// Interpolation from the trusted neighbours of a vector: the mean of their values, each extrapolated to its
    /// position; `None` without neighbours.
    pub fn interpolated(&self, index: usize, trusted: &[bool]) -> Option<Interpolated> {
        let near = carried_to_centre(&self.neighbours(index, trusted));
        let count = near.len() as f32;
        (!near.is_empty()).then(|| {
            let mean = |of: &dyn Fn(&[f32; 3]) -> f32| near.iter().map(of).sum::<f32>() / count;
            let value: [f32; 3] = std::array::from_fn(|c| mean(&|v| v[c]));
            let spread_vox = std::array::from_fn(|c| mean(&|v| (v[c] - value[c]).powi(2)).sqrt());
            Interpolated { value, spread_vox, supported: near.len() >= LEAST_NEIGHBOURS }
        })
    }

    /// Indices of the up to 26 trusted vectors around one.
    pub fn near<'a>(
        &self,
        index: usize,
        trusted: &'a [bool],
    ) -> impl Iterator<Item = usize> + use<'a> {
        self.around(index).into_iter().filter(move |&other| trusted[other])
    }

    fn neighbours(&self, index: usize, trusted: &[bool]) -> Vec<Neighbour> {
        let at = self.place(index);
        self.near(index, trusted)
            .map(|other| {
                let to = self.place(other);
                let offset = std::array::from_fn(|axis| to[axis] as i32 - at[axis] as i32);
                Neighbour { offset, value: self.values[other] }
            })
            .collect()
    }

    /// The up to 26 nodes around one.
    fn around(&self, index: usize) -> Vec<usize> {
        let mut near = Vec::with_capacity(26);
        self.for_each_near(index, |_, other| near.push(other));
        near
    }

    /// Visits the up to 26 nodes around one that are of the same flow: their places in the cube about it
    /// (see [`cube_index`]) and their numbers.
    fn for_each_near(&self, index: usize, mut visit: impl FnMut(usize, usize)) {
        let [nx, ny, nz] = self.nodes;
        let [i, j, k] = self.place(index);
        let around = |c: usize, n: usize| c.saturating_sub(1)..(c + 2).min(n);
        for z in around(k, nz) {
            for y in around(j, ny) {
                for x in around(i, nx) {
                    let other = (z * ny + y) * nx + x;
                    let place = ((z + 1 - k) * 3 + y + 1 - j) * 3 + x + 1 - i;
                    if other != index && self.flow.is_none_or(|flow| flow.sees(index, place)) {
                        visit(place, other);
                    }
                }
            }
        }
    }

    fn place(&self, index: usize) -> [usize; 3] {
        Layout { nodes: self.nodes }.place(index)
    }
}

/// A vector made from its neighbours.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interpolated {
    /// The vector.
    pub value: [f32; 3],
    /// Standard deviation of the extrapolated neighbours from it.
    pub spread_vox: [f32; 3],
    /// Whether there are enough neighbours.
    pub supported: bool,
}

/// A vector near another one.
#[derive(Debug, Clone, Copy)]
struct Neighbour {
    /// Lattice steps to it along x, y, z.
    offset: [i32; 3],
    value: [f32; 3],
}

/// The values of neighbours, each extrapolated to the centre along their median gradient.
fn carried_to_centre(near: &[Neighbour]) -> Vec<[f32; 3]> {
    let gradient: [[f32; 3]; 3] = std::array::from_fn(|axis| {
        let mut by_place: [Option<&Neighbour>; 27] = [None; 27];
        for neighbour in near {
            by_place[cube_index(neighbour.offset)] = Some(neighbour);
        }
        let stride = 3usize.pow(axis as u32);
        let pairs: Vec<_> = (0..27)
            .filter(|n| n / stride % 3 < 2)
            .filter_map(|n| by_place[n].zip(by_place[n + stride]))
            .collect();
        std::array::from_fn(|c| {
            let slopes = pairs.iter().map(|(l, h)| h.value[c] - l.value[c]);
            median(slopes).unwrap_or_default() as f32
        })
    });
    let carried = |n: &Neighbour| {
        std::array::from_fn(|c| {
            let rise: f32 = (0..3).map(|a| gradient[a][c] * n.offset[a] as f32).sum();
            n.value[c] - rise
        })
    };
    near.iter().map(carried).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    impl Candidates<'_> {
        /// The definition, vector by vector.
        fn passes(&self, index: usize, trusted: &[bool], threshold: f64, epsilon_vox: f64) -> bool {
            self.present[index] && {
                let near = self.neighbours(index, trusted);
                let level = carried_to_centre(&near);
                near.len() < LEAST_NEIGHBOURS
                    || (0..3).all(|c| {
                        let spread = median_residual(near.iter().map(|n| n.value[c]));
                        let around = median(level.iter().map(|v| v[c])).expect("neighbours");
                        let residual = (self.values[index][c] - around as f32).abs();
                        f64::from(residual) <= threshold * (f64::from(spread) + epsilon_vox)
                    })
            }
        }
    }

    /// Median distance of values from their median.
    fn median_residual(values: impl Iterator<Item = f32>) -> f32 {
        let values: Vec<f32> = values.collect();
        let middle = median(values.iter().copied()).expect("neighbours") as f32;
        median(values.iter().map(|value| (value - middle).abs())).expect("neighbours") as f32
    }

    #[test]
    fn lanes_judge_as_the_definition_does() {
        use rand::{RngExt, SeedableRng};
        let mut random = rand_pcg::Pcg64Mcg::seed_from_u64(7);
        let nodes = [5, 4, 7];
        for missing in [0.0, 0.2, 0.7] {
            let noise = |random: &mut rand_pcg::Pcg64Mcg| random.random_range(-0.4..0.4);
            let values: Vec<[f32; 3]> = (0..140)
                .map(|n| {
                    let shear = (n / 20) as f32 * 0.5;
                    [shear + noise(&mut random), noise(&mut random), noise(&mut random)]
                })
                .collect();
            let present: Vec<bool> = (0..140).map(|_| !random.random_bool(missing)).collect();
            let field = Candidates { nodes, values: &values, present: &present, flow: None };
            let all: Vec<usize> = (0..140).collect();
            let lanes: Vec<bool> = all
                .chunks(lanes::LANES)
                .flat_map(|some| field.judged(some, &present, 1.5, 0.1))
                .take(140)
                .collect();
            let each: Vec<bool> =
                all.iter().map(|&n| field.passes(n, &present, 1.5, 0.1)).collect();
            assert_eq!(lanes, each);
            assert!(lanes.contains(&true) && lanes.contains(&false));
        }
    }

    #[test]
    fn one_outlier_in_a_shear_is_found_and_nothing_else() {
        let nodes = [5, 5, 5];
        let mut values: Vec<[f32; 3]> =
            (0..125).map(|n| [(n / 25) as f32 * 0.5, 1.0, 0.0]).collect();
        values[62] = [4.0, -3.0, 0.0];
        let present = vec![true; 125];
        let field = Candidates { nodes, values: &values, present: &present, flow: None };
        let pass = field.passing(2.0, 0.1);
        let failed: Vec<usize> = (0..125).filter(|&n| !pass[n]).collect();
        assert_eq!(failed, [62]);
        let replaced = field.interpolated(62, &pass).unwrap().value;
        assert!((replaced[0] - 1.0).abs() < 1e-5 && (replaced[1] - 1.0).abs() < 1e-5);
    }
}
