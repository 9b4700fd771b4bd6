//! Tables of one-axis footprints for pairs of neighbouring voxels.

use rayon::prelude::*;

use super::row_shares::{RowShares, first_of_pair};
use crate::model::{footprint::RayMap, tables::AxisGeometry};

/// The microlenses that a pair of voxels covers along one axis, and the share of each voxel on
/// each of them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairTap<const L: usize> {
    /// Shares of the lower and the upper voxel on microlenses `first..first + L`, in units of
    /// [`SHARE_UNIT`]; 0 from `len` on. Half the size of floats keeps a view's tables in a core's
    /// second-level cache, and 1/32768 of a voxel's light is far below any noise.
    pub shares: [[u16; L]; 2],
    /// First microlens, counted from the start of the window.
    pub first: u16,
    /// Microlenses up to the last one that receives light.
    pub len: u16,
}

impl<const L: usize> PairTap<L> {
    /// No light on any microlens.
    pub const NONE: Self = Self { shares: [[0; L]; 2], first: 0, len: 0 };
}

/// One unit of a share in a [`PairTap`].
/// Shares may exceed 1: microlenses see a view through intervals that overlap.
pub const SHARE_UNIT: f32 = 1.0 / 32768.0;

/// One axis of one camera: a [`PairTap`] for every view index, depth and pair of voxels
/// across, in this order.
#[derive(Debug)]
pub struct PairTable<const L: usize> {
    reach: i32,
    depths: usize,
    pairs: usize,
    views: Vec<Vec<PairTap<L>>>,
}

impl<const L: usize> PairTable<L> {
    /// Computes every tap of `geometry`, whose positions are those of voxels. `None` when a pair reaches more than `L` microlenses.
    pub fn new(geometry: &AxisGeometry<'_>) -> Option<Self> {
        let reach = geometry.sampling.reach;
        let (depths, pairs) = (geometry.depths.count, geometry.positions.count.div_ceil(2));
        if geometry.pair_reach() > L {
            return None;
        }
        // A vector per view: nothing is written twice, and every thread fills its own pages.
        let views = (-reach..=reach).into_par_iter().map(|k| {
            let mut row = RowShares::new(geometry);
            let mut taps = Vec::with_capacity(depths * pairs);
            (0..depths).for_each(|depth| row.push_taps(k, depth, &mut taps));
            taps
        });
        Some(Self { reach, depths, pairs, views: views.collect() })
    }

    /// The taps of view index `k`, addressed by `depth * pairs + pair`.
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

/// One tap by itself: what [`RowShares`] does for a whole row.
pub(super) fn pair_tap<const L: usize>(
    geometry: &AxisGeometry<'_>,
    map: RayMap,
    k: i32,
    pair: usize,
) -> PairTap<L> {
    // Beyond an odd grid's end the upper voxel is never lit; its shares do not matter.
    let shadow = |child| geometry.shadow_of(map, k, geometry.positions.at(2 * pair + child));
    let shadows = [shadow(0), shadow(1)];
    let first = geometry.first_reached(&shadows[0]).min(geometry.first_reached(&shadows[1]));
    let first = first_of_pair::<L>(geometry, first);
    let mut shares = [[0; L]; 2];
    let mut len = 0;
    for (shares, shadow) in shares.iter_mut().zip(&shadows) {
        for (n, share) in shares.iter_mut().enumerate() {
            let units = geometry.share(shadow, first + n) / f64::from(SHARE_UNIT);
            *share = (units + 0.5) as u16;
            if *share > 0 {
                len = len.max(n + 1);
            }
        }
    }
    PairTap { shares, first: (first - geometry.window.start) as u16, len: len as u16 }
}
