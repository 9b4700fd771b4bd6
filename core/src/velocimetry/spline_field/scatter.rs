//! Local ratio of particles' errors to the stated ones.

use rayon::prelude::*;

use super::{super::nodes::Nodes, Sample};
use crate::statistics::{MEDIAN_SQUARE, median};

/// Nodes on either side whose particles count for the local scatter.
const REACH: i64 = 1;

/// Weight of the stated variance, as a number of particles.
const PRIOR_PARTICLES: f64 = 10.0;

/// Largest factor.
const LARGEST: f64 = 1e4;

/// Factor, 1 or more, on the variance of each sample, from the residuals of its neighbours: `left` contains their
/// squares relative to the stated variance.
pub fn inflation(nodes: &Nodes, samples: &[Sample], left: &[f32]) -> Vec<f32> {
    let layout = nodes.layout;
    let mut about: Vec<Vec<u32>> = vec![Vec::new(); layout.len()];
    let nearest: Vec<usize> = samples.iter().map(|s| nodes.nearest(s.middle_vox)).collect();
    for (n, &node) in (0u32..).zip(&nearest) {
        let place = layout.place(node);
        let near = |axis: usize| {
            let at = place[axis] as i64;
            (at - REACH).max(0)..=(at + REACH).min(layout.nodes[axis] as i64 - 1)
        };
        for z in near(2) {
            for y in near(1) {
                for x in near(0) {
                    about[layout.number([x, y, z].map(|at| at as usize))].push(n);
                }
            }
        }
    }
    let of_node: Vec<f32> = about
        .par_iter()
        .map(|near| {
            let middle = median(near.iter().map(|&n| f64::from(left[n as usize])));
            let own = (middle.unwrap_or(MEDIAN_SQUARE) / MEDIAN_SQUARE).clamp(1.0, LARGEST);
            // Shrinkage of the logarithm, as for the variance of all particles.
            let count = near.len() as f64;
            libm::exp(libm::log(own) * count / (count + PRIOR_PARTICLES)) as f32
        })
        .collect();
    nearest.iter().map(|&node| of_node[node]).collect()
}
