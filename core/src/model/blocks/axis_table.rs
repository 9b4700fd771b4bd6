//! Tables of one-axis footprints for pairs of neighbouring voxels.

use rayon::prelude::*;

use super::{pair_tap::PairTap, row_shares::RowShares};
use crate::model::tables::AxisGeometry;

/// One axis of one camera: a [`PairTap`] for every view index, depth and pair of voxels, in this order.
#[derive(Debug)]
pub struct PairTable<const L: usize> {
    reach: i32,
    depths: usize,
    pairs: usize,
    views: Vec<Vec<PairTap<L>>>,
}

impl<const L: usize> PairTable<L> {
    /// Computes every tap of `geometry`, whose positions are those of voxels. `None` if a pair
    /// reaches more than `L` microlenses.
    pub fn new(geometry: &AxisGeometry<'_>) -> Option<Self> {
        let reach = geometry.sampling.reach;
        let (depths, pairs) = (geometry.depths.count, geometry.positions.count.div_ceil(2));
        if geometry.pair_reach() > L {
            return None;
        }
        // One vector per view, so that every thread writes its own memory pages, and only once.
        let views = (-reach..=reach).into_par_iter().map(|k| {
            let mut row = RowShares::new(geometry);
            let mut taps = Vec::with_capacity(depths * pairs);
            (0..depths).for_each(|depth| row.push_taps(k, depth, &mut taps));
            taps
        });
        Some(Self { reach, depths, pairs, views: views.collect() })
    }

    /// The taps of view index `k`, with index `depth * pairs + pair`.
    pub fn of_view(&self, k: i32) -> &[PairTap<L>] {
        &self.views[(k + self.reach) as usize]
    }

    /// Number of pairs: the stride between depths in [`Self::of_view`].
    pub fn pairs(&self) -> usize {
        self.pairs
    }

    /// Number of depths.
    pub fn depths(&self) -> usize {
        self.depths
    }

    /// Bytes held.
    pub fn memory_bytes(&self) -> usize {
        self.views.len() * self.depths * self.pairs * size_of::<PairTap<L>>()
    }
}
