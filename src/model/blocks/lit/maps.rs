//! From lit microlenses to the voxels that they may light, along one axis.

use std::ops::Range;

use crate::model::{
    SUPPORT_SHARE,
    blocks::{
        axis_table::{PairTable, PairTap, SHARE_UNIT},
        dark_counts::{LINE_VOXELS, Line},
    },
    tables::LEAST_SEEN_SHARE,
};

/// Microlenses that are looked up together.
pub(super) const GROUP: usize = 6;

/// What one view index along the columns does to a line of voxels.
pub(super) struct ColumnMap {
    /// For every word of the line the groups of microlenses that can light its voxels.
    lit_by: [Vec<LitByGroup>; LINE_VOXELS / 64],
    /// The voxels that the view sees well enough to judge.
    pub judged: Line,
}

/// The bits of a word that each set of lit microlenses of a group sets.
struct LitByGroup {
    group: usize,
    bits: [u64; 1 << GROUP],
}

/// What one view index along the rows does to the voxels across them.
pub(super) struct RowMap {
    /// The voxels that the view sees well enough to judge.
    pub supports: Vec<RowSupport>,
    /// The microlens rows of all of them.
    pub reached: Range<usize>,
}

/// The microlens rows `start..end` that a voxel's light reaches.
pub(super) struct RowSupport {
    pub voxel: usize,
    pub start: usize,
    pub end: usize,
}

impl ColumnMap {
    /// The voxels in whose support one of the lit microlenses of an image row lies. `row` holds a
    /// set of [`GROUP`] microlenses per byte.
    pub fn light(&self, row: &[u8]) -> Line {
        self.lit_by.each_ref().map(|groups| {
            let bits = |by: &LitByGroup| by.bits[usize::from(row[by.group]) % (1 << GROUP)];
            groups.iter().fold(0, |lit, by| lit | bits(by))
        })
    }
}

/// The map of view index and depth `at`, for a strip of at most [`LINE_VOXELS`] voxels.
pub(super) fn column_map<const L: usize>(
    table: &PairTable<L>,
    at: (i32, usize),
    strip: Range<usize>,
    lenses: usize,
) -> ColumnMap {
    let mut voxels_of = vec![[usize::MAX, 0]; lenses];
    let mut judged = Line::default();
    for (voxel, support) in supports(table, at) {
        if !strip.contains(&voxel) {
            continue;
        }
        let bit = voxel - strip.start;
        judged[bit / 64] |= 1 << (bit % 64);
        for [low, high] in &mut voxels_of[support] {
            *low = (*low).min(bit);
            *high = (*high).max(bit + 1);
        }
    }
    let of_word = |word| {
        let groups = voxels_of.chunks(GROUP).enumerate();
        groups.filter_map(|(n, voxels_of)| LitByGroup::new(n, voxels_of, word)).collect()
    };
    ColumnMap { lit_by: std::array::from_fn(of_word), judged }
}

/// The map of view index and depth `at`, for `voxels` voxels.
pub(super) fn row_map<const L: usize>(
    table: &PairTable<L>,
    at: (i32, usize),
    voxels: usize,
) -> RowMap {
    let supports: Vec<RowSupport> = supports(table, at)
        .filter(|&(voxel, _)| voxel < voxels)
        .map(|(voxel, Range { start, end })| RowSupport { voxel, start, end })
        .collect();
    let start = supports.iter().map(|support| support.start).min().unwrap_or(0);
    let end = supports.iter().map(|support| support.end).max().unwrap_or(0);
    RowMap { supports, reached: start..end }
}

/// The microlenses of each voxel's support along one axis, where a view sees enough of it.
pub(super) fn supports<const L: usize>(
    table: &PairTable<L>,
    (view, depth): (i32, usize),
) -> impl Iterator<Item = (usize, Range<usize>)> + '_ {
    let taps = &table.of_view(view)[depth * table.pairs()..][..table.pairs()];
    taps.iter().enumerate().flat_map(|(pair, tap)| {
        [0, 1].into_iter().filter_map(move |n| Some((2 * pair + n, support(tap, n)?)))
    })
}

/// The microlenses that receive a notable share of voxel `n` of a pair; `None` where the view sees
/// too little of it.
fn support<const L: usize>(tap: &PairTap<L>, n: usize) -> Option<Range<usize>> {
    // In the table's whole units nothing is rounded.
    const NOT_LIT: u16 = (SUPPORT_SHARE / SHARE_UNIT) as u16;
    const LEAST_SEEN: u32 = (LEAST_SEEN_SHARE / SHARE_UNIT) as u32;
    let shares = &tap.shares[n];
    if shares.iter().map(|&share| u32::from(share)).sum::<u32>() < LEAST_SEEN {
        return None;
    }
    let lit = |share: &u16| *share > NOT_LIT;
    let (start, last) = (shares.iter().position(lit)?, shares.iter().rposition(lit)?);
    let first = usize::from(tap.first);
    Some(first + start..first + last + 1)
}

impl LitByGroup {
    /// From the range of voxels that each microlens of a group lights; microlenses without voxels
    /// light none. `None` where no voxel of the word is lit by the group.
    fn new(group: usize, voxels_of: &[[usize; 2]], word: usize) -> Option<Self> {
        let mut each = [0u64; GROUP];
        for (bits, &[low, high]) in each.iter_mut().zip(voxels_of) {
            for voxel in low.max(64 * word)..high.min(64 * (word + 1)) {
                *bits |= 1 << (voxel % 64);
            }
        }
        if each == [0; GROUP] {
            return None;
        }
        let mut bits = [0; 1 << GROUP];
        for set in 1..bits.len() {
            bits[set] = bits[set & (set - 1)] | each[set.trailing_zeros() as usize];
        }
        Some(Self { group, bits })
    }
}
