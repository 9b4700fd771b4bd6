//! Maps from lit microlenses to the voxels that may cause their light, along one axis.

use std::ops::Range;

use crate::model::{
    SUPPORT_SHARE,
    blocks::{
        axis_table::PairTable,
        dark_counts::Line,
        pair_tap::{PairTap, SHARE_UNIT},
    },
    tables::MIN_VISIBLE_SHARE,
};

/// Microlenses that are looked up together.
pub(super) const GROUP: usize = 6;

/// Map of one view index along the columns, for a line of voxels.
pub(super) struct ColumnMap<const W: usize> {
    words: [WordMap; W],
    /// The voxels with sufficient light in the view.
    pub evaluated: Line<W>,
}

/// The microlenses that can light the voxels of a word, in groups.
struct WordMap {
    groups: Range<usize>,
    /// Per group, the voxels lit by each subset of its microlenses.
    bits: Vec<[u64; 1 << GROUP]>,
}

/// The microlens rows `start..end` that a voxel's light reaches.
pub(super) struct RowSupport {
    pub voxel: usize,
    pub start: usize,
    pub end: usize,
}

impl<const W: usize> ColumnMap<W> {
    /// The voxels with a lit microlens of an image row in their support. `row` has one byte per
    /// [`GROUP`] of microlenses.
    #[inline(always)]
    pub fn light(&self, row: &[u8]) -> Line<W> {
        std::array::from_fn(|word| {
            let map = &self.words[word];
            let sets = row[map.groups.clone()].iter().zip(&map.bits);
            sets.fold(0, |lit, (&set, bits)| lit | bits[usize::from(set) % (1 << GROUP)])
        })
    }
}

/// The map for view index and depth `at`, for a strip of at most 64·`W` voxels.
pub(super) fn column_map<const W: usize, const L: usize>(
    table: &PairTable<L>,
    at: (i32, usize),
    strip: Range<usize>,
    lenses: usize,
) -> ColumnMap<W> {
    let mut voxels_of = vec![[usize::MAX, 0]; lenses];
    let mut evaluated = [0; W];
    for (voxel, support) in supports(table, at) {
        if !strip.contains(&voxel) {
            continue;
        }
        let bit = voxel - strip.start;
        evaluated[bit / 64] |= 1 << (bit % 64);
        for [low, high] in &mut voxels_of[support] {
            *low = (*low).min(bit);
            *high = (*high).max(bit + 1);
        }
    }
    ColumnMap { words: std::array::from_fn(|word| WordMap::new(&voxels_of, word)), evaluated }
}

/// The supports of at most `voxels` voxels along the rows, for view index and depth `at`, without voxels with
/// too little light in the view.
pub(super) fn row_supports<const L: usize>(
    table: &PairTable<L>,
    at: (i32, usize),
    voxels: usize,
) -> Vec<RowSupport> {
    supports(table, at)
        .filter(|&(voxel, _)| voxel < voxels)
        .map(|(voxel, Range { start, end })| RowSupport { voxel, start, end })
        .collect()
}

/// The support of each voxel with sufficient light in the view, along one axis.
pub(super) fn supports<const L: usize>(
    table: &PairTable<L>,
    (view, depth): (i32, usize),
) -> impl Iterator<Item = (usize, Range<usize>)> + '_ {
    let taps = &table.of_view(view)[depth * table.pairs()..][..table.pairs()];
    taps.iter().enumerate().flat_map(|(pair, tap)| {
        [0, 1].into_iter().filter_map(move |n| Some((2 * pair + n, support(tap, n)?)))
    })
}

/// The microlenses that receive a significant share of voxel `n` of a pair. `None` if the view contains too
/// little of its light.
fn support<const L: usize>(tap: &PairTap<L>, n: usize) -> Option<Range<usize>> {
    // In integer units of the table, nothing is rounded.
    const NOT_LIT: u16 = (SUPPORT_SHARE / SHARE_UNIT) as u16;
    const LEAST_SEEN: u32 = (MIN_VISIBLE_SHARE / SHARE_UNIT) as u32;
    let shares = &tap.shares[n];
    if shares.iter().map(|&share| u32::from(share)).sum::<u32>() < LEAST_SEEN {
        return None;
    }
    let lit = |share: &u16| *share > NOT_LIT;
    let (start, last) = (shares.iter().position(lit)?, shares.iter().rposition(lit)?);
    let first = usize::from(tap.first);
    Some(first + start..first + last + 1)
}

impl WordMap {
    /// From the range of voxels that each microlens lights; microlenses without voxels light none.
    fn new(voxels_of: &[[usize; 2]], word: usize) -> Self {
        let in_word = |&[low, high]: &[usize; 2]| low < 64 * (word + 1) && high > 64 * word;
        let first = voxels_of.iter().position(in_word).unwrap_or(0) / GROUP;
        let end = voxels_of.iter().rposition(in_word).map_or(first, |last| last / GROUP + 1);
        let of_group = |voxels_of| sets_of_group(voxels_of, word);
        let bits = voxels_of.chunks(GROUP).take(end).skip(first).map(of_group).collect();
        Self { groups: first..end, bits }
    }
}

/// The voxels of a word lit by each subset of a group's microlenses.
fn sets_of_group(voxels_of: &[[usize; 2]], word: usize) -> [u64; 1 << GROUP] {
    let mut each = [0u64; GROUP];
    for (bits, &[low, high]) in each.iter_mut().zip(voxels_of) {
        for voxel in low.max(64 * word)..high.min(64 * (word + 1)) {
            *bits |= 1 << (voxel % 64);
        }
    }
    let mut bits = [0; 1 << GROUP];
    for set in 1..bits.len() {
        bits[set] = bits[set & (set - 1)] | each[set.trailing_zeros() as usize];
    }
    bits
}
