//! The ensemble: moments of every place, in groups of shots.

use rayon::prelude::*;

use super::{
    Convergence, Correlation, Estimates, Quantity, Snapshot,
    convergence::{self, GROUPS},
    estimate::estimates,
    moments::Moments,
    two_point::LinePairs,
};
use crate::velocimetry::VectorGrid;

/// Places that a thread takes at a time.
const PLACES_AT_ONCE: usize = 256;

/// Statistics of a run under way.
#[derive(Debug, Clone, PartialEq)]
pub struct Ensemble {
    grid: VectorGrid,
    /// Shots in each group.
    shots: [u64; GROUPS],
    /// Moments of each place, the groups of a place together: place · [`GROUPS`] + group.
    moments: Vec<Moments>,
    /// Pairs of places on the lines along x, y, z.
    lines: [LinePairs; 3],
}

impl Ensemble {
    /// No shots yet, on the places of `grid`.
    pub fn new(grid: VectorGrid) -> Self {
        let moments = vec![Moments::default(); grid.len() * GROUPS];
        let lines = [0, 1, 2].map(|axis| LinePairs::new(&grid, axis));
        Self { grid, shots: [0; GROUPS], moments, lines }
    }

    /// Where the places are.
    pub fn grid(&self) -> &VectorGrid {
        &self.grid
    }

    /// Shots so far.
    pub fn shots(&self) -> u64 {
        self.shots.iter().sum()
    }

    /// Adds a shot; each once. Samples beyond the places, or that are not finite, are left out.
    pub fn add(&mut self, snapshot: &Snapshot) {
        let group = self.begin(snapshot.shot);
        for (place, sample) in snapshot.samples.iter().take(self.grid.len()).enumerate() {
            if let Some(sample) = sample.as_ref().filter(|sample| sample.is_finite()) {
                self.moments[place * GROUPS + group].merge(&Moments::of(sample));
            }
        }
        self.lines.par_iter_mut().for_each(|lines| lines.add(&snapshot.samples));
    }

    /// Puts the shots of `other` to these; `false`, and nothing done, where its places are others.
    pub fn merge(&mut self, other: &Self) -> bool {
        if self.grid != other.grid {
            return false;
        }
        self.shots.iter_mut().zip(other.shots).for_each(|(shots, more)| *shots += more);
        self.moments.iter_mut().zip(&other.moments).for_each(|(own, more)| own.merge(more));
        self.lines.iter_mut().zip(&other.lines).for_each(|(own, more)| own.merge(more));
        true
    }

    /// The statistics of every place.
    pub fn estimates(&self) -> Estimates {
        let of_places: Vec<_> =
            self.moments.par_chunks(GROUPS).with_min_len(PLACES_AT_ONCE).map(estimates).collect();
        let values = (0..Quantity::ALL.len())
            .map(|quantity| of_places.iter().map(|place| place[quantity]).collect())
            .collect();
        Estimates { counts: self.counts(), values }
    }

    /// Samples of each place.
    pub fn counts(&self) -> Vec<u64> {
        let of_place = |groups: &[Moments]| groups.iter().map(|group| group.count).sum();
        self.moments.chunks(GROUPS).map(of_place).collect()
    }

    /// How mean and fluctuations settle with the number of shots.
    pub fn convergence(&self) -> Vec<Convergence> {
        convergence::convergence(&self.shots, &self.moments)
    }

    /// Two-point correlations along x, y, z.
    pub fn correlations(&self) -> [Correlation; 3] {
        let noise = self.mean_noise();
        [0, 1, 2].map(|axis| self.lines[axis].correlation(axis, self.grid.spacing_mm, noise))
    }

    /// Mean square of the standard uncertainties of all samples, m²/s².
    fn mean_noise(&self) -> [f64; 3] {
        let mut all = Moments::default();
        self.moments.iter().for_each(|moments| all.merge(moments));
        all.noise
    }

    /// Notes a shot; its group.
    fn begin(&mut self, shot: u64) -> usize {
        let group = (shot % GROUPS as u64) as usize;
        self.shots[group] += 1;
        group
    }
}
