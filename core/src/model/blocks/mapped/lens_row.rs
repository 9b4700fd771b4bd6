//! The voxels that correspond to the lit microlenses of a row, in one view of a tile.
//!
//! Each lit microlens sets bits around its own position in the lines around it. The bits are a word per
//! microlens. In nearly all lines, those in reach of all microlenses of the row, the union of the words is the
//! same and is computed once.

use std::ops::Range;

use multiversion::multiversion;

use super::{
    lens_phases::LensPhases,
    rounding::{nearest, whole},
    tile_place::{LENSES, MAX_LINES, MAX_THICKNESS},
    tile_view::TileView,
};

/// The lit voxels of every layer's lines.
pub(super) struct Lit(pub [[u64; MAX_LINES]; MAX_THICKNESS]);

impl Default for Lit {
    fn default() -> Self {
        Self([[0; MAX_LINES]; MAX_THICKNESS])
    }
}

/// One row of microlenses in a view of a tile.
pub(super) struct LensRow {
    /// Position of each microlens among the voxels.
    centre_bit: [f32; LENSES],
    centre_line: [f32; LENSES],
    /// Middle of the gap next to each microlens among the voxels, and the distance within which it hides too much;
    /// negative if there is no gap.
    gap_centre: [f32; LENSES],
    gap_reach: [f32; LENSES],
    /// For each microlens, the bits that it sets in the lines from the first to the last.
    zones: [u64; LENSES],
    first: [i32; LENSES],
    last: [i32; LENSES],
    /// Position of the first microlens across the lines, without its phase.
    line: f32,
    /// Smallest and largest displacement of a microlens across the lines by its phase.
    phase_lines: [f32; 2],
}

impl Default for LensRow {
    fn default() -> Self {
        Self {
            centre_bit: [0.0; LENSES],
            centre_line: [0.0; LENSES],
            gap_centre: [0.0; LENSES],
            gap_reach: [0.0; LENSES],
            zones: [0; LENSES],
            first: [0; LENSES],
            last: [0; LENSES],
            line: 0.0,
            phase_lines: [0.0; 2],
        }
    }
}

/// The bits or lines within `reach` of a position: first, and one past the last, as given by
/// [`nearest`]. Uses comparisons, because `f32::max` handles NaN, which prevents vectorisation.
#[inline(always)]
fn range(centre: f32, reach: f32, most: f32) -> [u32; 2] {
    // The next integer is the nearest one of half more.
    const HALF: f32 = 0.499_999;
    let within = |value: f32| {
        let value = if value > 0.0 { value } else { 0.0 };
        nearest(if value < most { value } else { most })
    };
    let (low, high) = (within(centre - (reach - HALF)), within(centre + (reach + (1.0 - HALF))));
    [low, if high > low { high } else { low }]
}

/// The first and the last of a range.
#[inline(always)]
fn ends([low, high]: [u32; 2]) -> [i32; 2] {
    [whole(low), whole(high) - 1]
}

/// The bits of a range, as given by [`range`].
#[inline(always)]
fn mask([low, high]: [u32; 2]) -> u64 {
    (1u64 << (high & 63)).wrapping_sub(1u64 << (low & 63))
}

/// All bits if the lowest bit is set, else none.
#[inline(always)]
fn spread(bit: u32) -> u32 {
    0u32.wrapping_sub(bit & 1)
}

impl LensRow {
    /// Sets the position of row `j` of microlenses across the lines.
    #[inline(always)]
    fn place(&mut self, view: &TileView, phases: &LensPhases, j: i32) {
        self.line = view.line_of(j);
        let [line_x, line_y] = view.voxels[1];
        let [by_x, by_y] = view.parallax;
        let [x, y] = phases.range(j);
        let ends =
            |by: f32, [low, high]: [f32; 2]| [(by * low).min(by * high), (by * low).max(by * high)];
        let (x, y) = (ends(-line_x * by_x, x), ends(-line_y * by_y, y));
        self.phase_lines = [x[0] + y[0], x[1] + y[1]];
    }

    /// Computes the positions of the microlenses of row `j`, whose position is set.
    #[inline(always)]
    fn fill(&mut self, view: &TileView, phases: &LensPhases, j: i32) {
        let [[bit_x, bit_y], [line_x, line_y]] = view.voxels;
        let (x, y) = (view.first as f32 - view.place[0], j as f32 - view.place[1]);
        let bit = view.middle[0] + bit_x * x + bit_y * y;
        let line = self.line;
        let [shift_x, shift_y] = phases.row(j, view.first);
        let [by_x, by_y] = view.parallax;
        let bits = [bit_x * by_x, bit_y * by_y];
        let lines = [line_x * by_x, line_y * by_y];
        for n in 0..LENSES {
            let (i, x, y) = (n as f32, shift_x[n], shift_y[n]);
            self.centre_bit[n] = bit + bit_x * i - (bits[0] * x + bits[1] * y);
            self.centre_line[n] = line + line_x * i - (lines[0] * x + lines[1] * y);
        }
    }

    /// Sets the voxels of the microlenses whose bit is set.
    #[inline(always)]
    fn light(&mut self, view: &TileView, lenses: u32, lit: &mut Lit) {
        let reach = [view.reach[0]; LENSES];
        self.zones = zones(&self.centre_bit, &reach, view.bits, lenses);
        if view.skewed {
            for (layer, lit) in lit.0.iter_mut().enumerate().take(view.layers) {
                let shift = view.shift_of(layer);
                self.fill_lines(view, view.reach[1], shift[1]);
                let [any, _] = self.lines(view, view.reach[1], shift[1]);
                self.light_skewed(view, any, shift, lit);
            }
        } else {
            self.light_within(view, view.reach[1], lit);
        }
    }

    /// Sets the zones in the lines within `reach` of their microlenses.
    #[inline(always)]
    fn light_within(&mut self, view: &TileView, reach: f32, lit: &mut Lit) {
        let zone = self.zones.iter().fold(0, |zone, of_lens| zone | of_lens);
        for (layer, lit) in lit.0.iter_mut().enumerate().take(view.layers) {
            let [_, shift] = view.shift_of(layer);
            let [any, all] = self.lines(view, reach, shift);
            if all.is_empty() {
                self.fill_lines(view, reach, shift);
                self.light_each(any, lit);
                continue;
            }
            for lit in &mut lit[all.clone()] {
                *lit |= zone;
            }
            if any != all {
                self.fill_lines(view, reach, shift);
                self.light_each(any.start..all.start, lit);
                self.light_each(all.end..any.end, lit);
            }
        }
    }

    /// The lines within `reach` of any microlens in a layer of this shift, and those within `reach`
    /// of all.
    #[inline(always)]
    fn lines(&self, view: &TileView, reach: f32, shift: f32) -> [Range<usize>; 2] {
        let ends = [self.line, self.line + view.voxels[1][0] * (LENSES - 1) as f32];
        let first = ends[0].min(ends[1]) + self.phase_lines[0];
        let last = ends[0].max(ends[1]) + self.phase_lines[1];
        let (centre, half) = ((first + last) / 2.0 + shift, (last - first) / 2.0);
        // A margin, so that rounding does not change the result.
        const LESS: f32 = 1e-3;
        [reach + half + LESS, reach - half - LESS].map(|reach| {
            let [low, high] = range(centre, reach, view.lines);
            whole(low) as usize..whole(high) as usize
        })
    }

    /// Computes the lines within `reach` of each microlens in a layer of this shift.
    #[inline(always)]
    fn fill_lines(&mut self, view: &TileView, reach: f32, shift: f32) {
        for n in 0..LENSES {
            let lines = ends(range(self.centre_line[n] + shift, reach, view.lines));
            [self.first[n], self.last[n]] = lines;
        }
    }

    /// All bits if zone `n` contains the line, else none.
    #[inline(always)]
    fn has(&self, line: i32, n: usize) -> u64 {
        // Negative only outside; a comparison would prevent vectorisation.
        let outside = (line - self.first[n]) | (self.last[n] - line);
        i64::from(!(outside >> 31)) as u64
    }

    /// Sets the zones line by line.
    #[inline(always)]
    fn light_each(&self, lines: Range<usize>, lit: &mut [u64; MAX_LINES]) {
        for line in lines {
            let mut zone = 0;
            for n in 0..LENSES {
                zone |= self.zones[n] & self.has(line as i32, n);
            }
            lit[line] |= zone;
        }
    }

    /// Sets the voxels of the zones line by line: those within reach along both columns and rows.
    #[inline(always)]
    fn light_skewed(
        &self,
        view: &TileView,
        lines: Range<usize>,
        shift: [f32; 2],
        lit: &mut [u64; MAX_LINES],
    ) {
        for line in lines {
            let mut zone = 0;
            for n in 0..LENSES {
                zone |= self.skewed(view, line as i32, shift, n);
            }
            lit[line] |= zone;
        }
    }

    /// The voxels of a line that a microlens sets in a skewed tile, in a layer of this shift.
    #[inline(always)]
    fn skewed(&self, view: &TileView, line: i32, shift: [f32; 2], n: usize) -> u64 {
        let beside = line as f32 - (self.centre_line[n] + shift[1]);
        let mut zone = self.zones[n] & self.has(line, n);
        for axis in 0..2 {
            let middle = self.centre_bit[n] + shift[0] - view.bits_per_line[axis] * beside;
            zone &= mask(range(middle, view.bit_reach[axis], view.bits));
        }
        zone
    }

    /// Sets the voxels in gaps between the microlenses' pupil intervals, which have too little light in the view
    /// ([`crate::model::tables::MIN_VISIBLE_SHARE`]), in this row and before it.
    #[inline(always)]
    fn light_gaps(&mut self, view: &TileView, phases: &LensPhases, j: i32, lit: &mut Lit) {
        let [along, across] = phases.steps(j);
        if view.has_gap(0, along) && self.find_gaps(view, phases, j) {
            self.zones = zones(&self.gap_centre, &self.gap_reach, view.bits, !0);
            self.light_within(view, view.beside_gap[1] * view.voxels[1][1].abs(), lit);
        }
        let follows = j > view.rows[0];
        if follows && view.has_gap(1, across) && self.find_gaps_before(view, phases, j) {
            let half = view.beside_gap[0] * view.voxels[0][0].abs();
            self.zones = zones(&self.centre_bit, &[half; LENSES], view.bits, !0);
            // The gap's middle is half a row away, and gaps are at most a row wide.
            let reach = (1.0 + view.beside_gap[1]) * view.voxels[1][1].abs();
            for (layer, lit) in lit.0.iter_mut().enumerate().take(view.layers) {
                let [_, shift] = view.shift_of(layer);
                for n in 0..LENSES {
                    let gap = range(self.gap_centre[n] + shift, self.gap_reach[n], view.lines);
                    [self.first[n], self.last[n]] = ends(gap);
                }
                let [any, _] = self.lines(view, reach, shift);
                self.light_each(any, lit);
            }
        }
    }

    /// Computes the bits in the gap after each microlens; returns whether there are any.
    #[inline(always)]
    fn find_gaps(&mut self, view: &TileView, phases: &LensPhases, j: i32) -> bool {
        let [bit_x, bit_y] = view.voxels[0];
        let [shift_x, shift_y] = phases.row(j, view.first);
        let [next_x, _] = phases.row(j, view.first + 1);
        for n in 0..LENSES {
            let (here, next) = (shift_x[n] * view.parallax[0], next_x[n] * view.parallax[0]);
            let gap = 1.0 - view.lens_width + here - next;
            let x = (view.first + n as i32) as f32 + 0.5 - (here + next) / 2.0 - view.place[0];
            let y = j as f32 - shift_y[n] * view.parallax[1] - view.place[1];
            self.gap_centre[n] = view.middle[0] + bit_x * x + bit_y * y;
            self.gap_reach[n] = view.gap_reach(0, gap) * bit_x.abs();
        }
        self.has_gaps()
    }

    /// Computes the lines in the gap before this row of microlenses; returns whether there are any.
    #[inline(always)]
    fn find_gaps_before(&mut self, view: &TileView, phases: &LensPhases, j: i32) -> bool {
        let line_y = view.voxels[1][1];
        let [_, shift_y] = phases.row(j, view.first);
        let [_, last_y] = phases.row(j - 1, view.first);
        for n in 0..LENSES {
            let (here, last) = (shift_y[n] * view.parallax[1], last_y[n] * view.parallax[1]);
            let gap = 1.0 - view.lens_width + last - here;
            // Half a microlens, and half the difference of both shifts, before this row's centre.
            self.gap_centre[n] = self.centre_line[n] + line_y * ((here - last) / 2.0 - 0.5);
            self.gap_reach[n] = view.gap_reach(1, gap) * line_y.abs();
        }
        self.has_gaps()
    }

    #[inline(always)]
    fn has_gaps(&self) -> bool {
        let mut any = false;
        for reach in &self.gap_reach {
            any |= *reach > 0.0;
        }
        any
    }
}

/// The bits within `reach` of the microlenses whose bit is set in `lenses`, of a line of `bits`.
#[inline(always)]
fn zones(centre: &[f32; LENSES], reach: &[f32; LENSES], bits: f32, lenses: u32) -> [u64; LENSES] {
    // Two loops, for vectors of numbers and for vectors of words.
    let (mut low, mut high) = ([0; LENSES], [0; LENSES]);
    for n in 0..LENSES {
        let [first, end] = range(centre[n], reach[n], bits);
        low[n] = first;
        high[n] = first + (end.wrapping_sub(first) & spread(lenses >> n));
    }
    let mut zones = [0; LENSES];
    for n in 0..LENSES {
        zones[n] = mask([low[n], high[n]]);
    }
    zones
}

/// Sets the voxels of the microlenses whose bit is set in `rows`, by row number, and the voxels with too little
/// light in the view.
#[inline(always)]
pub(super) fn light(
    view: &TileView,
    phases: &LensPhases,
    rows: impl Fn(i32) -> u32,
    row: &mut LensRow,
    lit: &mut Lit,
) {
    light_rows(view, phases, &rows, row, lit);
}

#[multiversion(targets("x86_64+avx512f+avx512dq+avx512vl", "x86_64+avx2"))]
fn light_rows<R: Fn(i32) -> u32>(
    view: &TileView,
    phases: &LensPhases,
    rows: &R,
    row: &mut LensRow,
    lit: &mut Lit,
) {
    for j in view.rows[0]..view.rows[1] {
        let lenses = rows(j);
        if lenses == 0 && !view.gaps {
            continue;
        }
        row.place(view, phases, j);
        row.fill(view, phases, j);
        row.light(view, lenses, lit);
        if view.gaps {
            row.light_gaps(view, phases, j, lit);
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// The voxels within reach of any lit microlens, one by one, with the tolerance `more`: an upper bound if it is
    /// positive, a lower bound if it is negative.
    fn naive(
        view: &TileView,
        phase: impl Fn(i32, i32) -> [f32; 2],
        rows: impl Fn(i32) -> u32,
        layer: usize,
        more: f32,
    ) -> Vec<u64> {
        let mut lit = vec![0u64; MAX_LINES];
        let layer_shift = view.shift_of(layer)[1];
        for j in view.rows[0]..view.rows[1] {
            for n in (0..LENSES as i32).filter(|n| rows(j) >> n & 1 == 1) {
                let i = view.first + n;
                let shift = phase(i, j);
                let x = i as f32 - view.place[0] - view.parallax[0] * shift[0];
                let y = j as f32 - view.place[1] - view.parallax[1] * shift[1];
                let at =
                    [0, 1].map(|v| view.middle[v] + view.voxels[v][0] * x + view.voxels[v][1] * y);
                for (line, lit) in lit.iter_mut().enumerate().take(view.lines as usize) {
                    for bit in 0..view.bits as usize {
                        let within = (bit as f32 - at[0]).abs() <= view.reach[0] + more
                            && (line as f32 - at[1] - layer_shift).abs() <= view.reach[1] + more;
                        *lit |= u64::from(within) << bit;
                    }
                }
            }
        }
        lit
    }

    proptest! {
        /// The naive reference, for rows that reach the same lines and for inclined ones.
        #[test]
        fn rows_light_the_voxels_within_reach_of_their_microlenses(
            place in [5.0..20.0f32, 5.0..20.0f32],
            along in [1.5..4.0f32, 1.5..4.0f32],
            sign in [prop_oneof![Just(-1.0f32), Just(1.0)], prop_oneof![Just(-1.0f32), Just(1.0)]],
            across in [prop_oneof![Just(0.0f32), -0.1..0.1f32], prop_oneof![Just(0.0f32), -0.1..0.1f32]],
            reach in [0.2..3.0f32, 0.2..3.0f32],
            parallax in -0.03..0.03f32,
            bits in 2usize..=30,
            lines in 1usize..=96,
            lenses in prop::collection::vec(any::<u32>(), 30),
            level in any::<bool>(),
            layers in 1..=MAX_THICKNESS,
            shift in [-2.0..2.0f32, -1.0..1.0f32],
        ) {
            let view = TileView {
                place,
                voxels: [[sign[0] * along[0], across[0]], [across[1], sign[1] * along[1]]],
                middle: [bits as f32, lines as f32 / 2.0],
                reach,
                layers,
                first_shift: [0.0, shift[0]],
                shift: [0.0, shift[1]],
                beside_gap: [0.5; 2],
                parallax: [parallax; 2],
                first: 1,
                rows: [0, 30],
                bits: 2.0 * bits as f32,
                lines: lines as f32,
                inside: true,
                lens_width: 1.0,
                gap_least: [f32::INFINITY; 2],
                gap_half: [0.0; 2],
                gap_growth: [0.0; 2],
                gaps: false,
                bit_reach: [0.0; 2],
                bits_per_line: [0.0; 2],
                skewed: false,
            };
            let phase = |i: i32, j: i32| {
                let turned = if level { 0 } else { 3 * i };
                [(7 * i + j) as f32 % 11.0 - 5.0, (5 * j + turned) as f32 % 13.0 - 6.0]
            };
            let rows = |j: i32| lenses[j as usize];
            let phases = LensPhases::with(40, 30, phase);
            let mut lit = Lit::default();
            light(&view, &phases, rows, &mut LensRow::default(), &mut lit);
            for (layer, lit) in lit.0[..layers].iter().enumerate() {
                let [least, most] =
                    [-2e-3, 2e-3].map(|more| naive(&view, phase, rows, layer, more));
                for (line, &lit) in lit.iter().enumerate() {
                    prop_assert_eq!(least[line] & !lit, 0, "missing in line {}", line);
                    prop_assert_eq!(lit & !most[line], 0, "too many in line {}", line);
                }
            }
        }
    }
}
