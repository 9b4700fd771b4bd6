//! The ensemble: moments at every node of the lattice, in groups of shots.

use rayon::prelude::*;

use super::{
    Convergence, Correlation, Estimates, Quantity, Snapshot,
    convergence::{self, GROUPS},
    estimate::estimates,
    moments::Moments,
    two_point::LinePairs,
};
use crate::velocimetry::VectorGrid;

/// Least number of nodes in a parallel task.
const NODES_PER_TASK: usize = 256;

/// Accumulated statistics of shots on a lattice.
#[derive(Debug, Clone, PartialEq)]
pub struct Ensemble {
    grid: VectorGrid,
    /// Number of shots in each group.
    shots: [u64; GROUPS],
    /// Moments of each node and group, at node · [`GROUPS`] + group.
    moments: Vec<Moments>,
    /// Pairs of nodes on the lines along x, y, z.
    lines: [LinePairs; 3],
}

impl Ensemble {
    /// An ensemble without shots, on the nodes of `grid`.
    pub fn new(grid: VectorGrid) -> Self {
        let moments = vec![Moments::default(); grid.len() * GROUPS];
        let lines = [0, 1, 2].map(|axis| LinePairs::new(&grid, axis));
        Self { grid, shots: [0; GROUPS], moments, lines }
    }

    /// The lattice.
    pub fn grid(&self) -> &VectorGrid {
        &self.grid
    }

    /// Number of shots.
    pub fn shots(&self) -> u64 {
        self.shots.iter().sum()
    }

    /// Adds a shot, which must not be added twice. Samples beyond the lattice or with non-finite numbers are left
    /// out.
    pub fn add(&mut self, snapshot: &Snapshot) {
        let group = self.count_shot(snapshot.shot);
        for (node, sample) in snapshot.samples.iter().take(self.grid.len()).enumerate() {
            if let Some(sample) = sample.as_ref().filter(|sample| sample.is_finite()) {
                self.moments[node * GROUPS + group].merge(&Moments::of(sample));
            }
        }
        self.lines.par_iter_mut().for_each(|lines| lines.add(&snapshot.samples));
    }

    /// Adds the shots of `other`. Returns `false`, without any change, if its lattice differs.
    pub fn merge(&mut self, other: &Self) -> bool {
        if self.grid != other.grid {
            return false;
        }
        self.shots.iter_mut().zip(other.shots).for_each(|(shots, more)| *shots += more);
        self.moments.iter_mut().zip(&other.moments).for_each(|(own, more)| own.merge(more));
        self.lines.iter_mut().zip(&other.lines).for_each(|(own, more)| own.merge(more));
        true
    }

    /// The statistics at every node.
    pub fn estimates(&self) -> Estimates {
        let of_nodes: Vec<_> =
            self.moments.par_chunks(GROUPS).with_min_len(NODES_PER_TASK).map(estimates).collect();
        let values = (0..Quantity::ALL.len())
            .map(|quantity| of_nodes.iter().map(|node| node[quantity]).collect())
            .collect();
        Estimates { counts: self.counts(), values }
    }

    /// Number of samples at each node.
    pub fn counts(&self) -> Vec<u64> {
        let of_node = |groups: &[Moments]| groups.iter().map(|group| group.count).sum();
        self.moments.chunks(GROUPS).map(of_node).collect()
    }

    /// Convergence of mean and fluctuations with the number of shots.
    pub fn convergence(&self) -> Vec<Convergence> {
        convergence::convergence(&self.shots, &self.moments)
    }

    /// Two-point correlations along x, y, z.
    pub fn correlations(&self) -> [Correlation; 3] {
        let noise = self.mean_noise();
        [0, 1, 2].map(|axis| self.lines[axis].correlation(axis, self.grid.spacing_mm, noise))
    }

    /// Mean squared standard uncertainty of all samples, in m²/s².
    fn mean_noise(&self) -> [f64; 3] {
        let mut all = Moments::default();
        self.moments.iter().for_each(|moments| all.merge(moments));
        all.noise
    }

    /// Counts a shot, and returns its group.
    fn count_shot(&mut self, shot: u64) -> usize {
        let group = (shot % GROUPS as u64) as usize;
        self.shots[group] += 1;
        group
    }
}
