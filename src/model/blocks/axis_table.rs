//! Tables of one-axis footprints for pairs of neighbouring voxels.

use rayon::prelude::*;

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
    taps: Vec<PairTap<L>>,
}

impl<const L: usize> PairTable<L> {
    /// Computes every tap of `geometry`, whose positions are those of voxels. `None` when a pair reaches more than `L` microlenses.
    pub fn new(geometry: &AxisGeometry<'_>) -> Option<Self> {
        let reach = geometry.sampling.reach;
        let (depths, pairs) = (geometry.depths.count, geometry.positions.count.div_ceil(2));
        if geometry.pair_reach() > L {
            return None;
        }
        let views = (2 * reach + 1) as usize;
        let mut taps =
            vec![PairTap { shares: [[0; L]; 2], first: 0, len: 0 }; views * depths * pairs];
        taps.par_chunks_mut(pairs).enumerate().for_each(|(n, row)| {
            let (k, depth) = ((n / depths) as i32 - reach, n % depths);
            let map = RayMap::at_depth(geometry.optics, geometry.depths.at(depth));
            for (pair, tap) in row.iter_mut().enumerate() {
                *tap = pair_tap(geometry, map, k, pair);
            }
        });
        Some(Self { reach, depths, pairs, taps })
    }

    /// The taps of view index `k`, addressed by `depth * pairs + pair`.
    pub fn of_view(&self, k: i32) -> &[PairTap<L>] {
        let len = self.depths * self.pairs;
        let start = (k + self.reach) as usize * len;
        &self.taps[start..start + len]
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
        self.taps.len() * size_of::<PairTap<L>>()
    }
}

fn pair_tap<const L: usize>(
    geometry: &AxisGeometry<'_>,
    map: RayMap,
    k: i32,
    pair: usize,
) -> PairTap<L> {
    // Beyond an odd grid's end the upper voxel is never lit; its shares do not matter.
    let shadow = |child| geometry.shadow_of(map, k, geometry.positions.at(2 * pair + child));
    let shadows = [shadow(0), shadow(1)];
    let first = geometry.first_reached(&shadows[0]).min(geometry.first_reached(&shadows[1]));
    let window = &geometry.window;
    // A footprint that leaves the window keeps its true shares on what remains of it.
    let last_first = (window.end as i64 - L as i64).max(window.start as i64);
    let first = first.clamp(window.start as i64, last_first) as usize;
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
    PairTap { shares, first: (first - window.start) as u16, len: len as u16 }
}
