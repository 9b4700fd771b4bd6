//! The footprint of a pair of neighbouring voxels along one axis.

use crate::model::{footprint::RayMap, tables::AxisGeometry};

/// The microlenses that `C` voxels cover along one axis, and the share of each voxel on each of
/// them: a pair along the axis or, with `C` = 4, two pairs at different depths.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairTap<const L: usize, const C: usize = 2> {
    /// Shares of the lower and the upper voxel on microlenses `first..first + L`, and those of the pair behind
    /// them, in units of [`SHARE_UNIT`]; 0 from `len` on. They have half the size of floats, so that a view's
    /// tables fit into the L2 cache, and 1/32768 of a voxel's light is far below any noise.
    pub shares: [[u16; L]; C],
    /// First microlens, relative to the window.
    pub first: u16,
    /// Number of microlenses up to the last one with light.
    pub len: u16,
}

impl<const L: usize, const C: usize> PairTap<L, C> {
    /// No light on any microlens.
    pub const NONE: Self = Self { shares: [[0; L]; C], first: 0, len: 0 };
}

/// Unit of a share in a [`PairTap`]. Shares may exceed 1, because the pupil intervals of microlenses in a view may
/// overlap.
pub const SHARE_UNIT: f32 = 1.0 / 32768.0;

/// The first microlens of a pair's tap, relative to the array. A footprint that extends beyond the
/// window keeps its true shares on the rest.
pub(super) fn first_of_pair<const L: usize>(geometry: &AxisGeometry<'_>, reached: i64) -> usize {
    let window = &geometry.window;
    let last_first = (window.end as i64 - L as i64).max(window.start as i64);
    reached.clamp(window.start as i64, last_first) as usize
}

/// Computes one tap; [`super::row_shares::RowShares`] does it for a whole row.
pub(super) fn pair_tap<const L: usize>(
    geometry: &AxisGeometry<'_>,
    map: RayMap,
    k: i32,
    pair: usize,
) -> PairTap<L> {
    // Outside an odd grid the upper voxel is never lit; its shares do not matter.
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
