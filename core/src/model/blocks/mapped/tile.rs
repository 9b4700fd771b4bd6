//! Photo-hull of a tile: up to 60 × 96 voxels at one depth, for all views of a camera.
//!
//! Relative to the array's columns and rows the voxels of a tile are almost evenly spaced, so a
//! view maps microlenses onto voxels by an affine function. A lit microlens lights a rectangle of
//! voxels: a few bits of a few lines. Each microlens has the phase of its own pixel, so rectangles
//! need not be widened for phases.

use std::ops::Range;

use multiversion::multiversion;

use super::{
    lens_phases::LensPhases,
    lit_bits::LitBits,
    places::ViewAddresses,
    rounding::{nearest, whole},
    support::Support,
};
use crate::model::blocks::dark_counts::DarkCounts;

/// Words per line of voxels. Words, numbers and microlenses have the same width, so that vectors
/// hold equally many of each.
const WORDS: usize = 2;

/// Voxels per word: one bit is needed for the ends of ranges, and the number is even for whole blocks.
const WORD_BITS: usize = 30;

/// Voxels along the columns.
pub(super) const MAX_BITS: usize = WORDS * WORD_BITS;

/// Lines of voxels across the rows.
pub(super) const MAX_LINES: usize = 96;

/// Slope of a tile's axes relative to the array's above which it counts as skewed.
const SKEWED: f64 = 0.15;

/// Microlenses along a row of the array that are processed together.
pub(super) const LENSES: usize = 32;

/// Numbers in the widest vectors.
const LANES: usize = 16;

/// The lit voxels of a line, by microlens number modulo [`LANES`]; combined at the end.
type Lit = [[[u32; LANES]; WORDS]; MAX_LINES];

/// Linear positions of a tile's voxels relative to the microlenses, for voxel (bit, line) from the
/// tile's middle.
#[derive(Debug, Clone, Copy)]
pub(super) struct TilePlace {
    /// Position of the middle along columns and rows, in microlenses.
    pub place: [f64; 2],
    /// Change per bit and per line.
    pub by_voxel: [[f64; 2]; 2],
    /// Parallax of the middle, and its change per bit and per line.
    pub parallax: [f64; 2],
    pub parallax_by_voxel: [[f64; 2]; 2],
    /// Middle of the tile, in voxels from the first.
    pub middle: [f64; 2],
    pub bits: usize,
    pub lines: usize,
}

/// The views of a camera.
#[derive(Clone, Copy)]
pub(super) struct Views<'a> {
    /// The selected views with images, in the order of `bits`.
    pub selected: &'a [ViewAddresses],
    /// Other views, which may see voxels that the selected ones do not.
    pub others: &'a [ViewAddresses],
    pub bits: &'a LitBits,
    pub phases: &'a LensPhases,
    /// Number of views that may find a lit voxel dark.
    pub tolerated: usize,
}

/// Result for a tile.
#[derive(Debug, Clone)]
pub(super) struct TileResult {
    /// Per line, the voxels that no more views than tolerated find dark, and those that any view sees.
    pub possible: Vec<u64>,
    pub seen: Vec<u64>,
}

/// The map from microlenses to voxels of a tile, in one view.
#[derive(Debug, Clone, Copy)]
struct TileView {
    /// Position of the tile's middle in this view.
    place: [f32; 2],
    /// Voxels per microlens.
    voxels: [[f32; 2]; 2],
    middle: [f32; 2],
    /// Reach of a microlens' light, in voxels.
    reach: [f32; 2],
    parallax: [f32; 2],
    /// First microlens of a row, and the rows.
    first: i32,
    rows: [i32; 2],
    /// Voxels in a line's words, and number of lines.
    bits: [f32; WORDS],
    lines: f32,
    /// Largest displacement of microlenses across the lines by phases.
    phase_lines: f32,
    /// Whether all of its microlenses are inside the window.
    inside: bool,
    /// As in [`Support`].
    lens_width: f32,
    gap_least: [f32; 2],
    gap_half: [f32; 2],
    gap_growth: [f32; 2],
    gaps: bool,
    /// For skewed tiles, where the bounding rectangle of a microlens' light contains many other
    /// voxels: reach of a microlens along i and j in bits, and its shift from line to line.
    bit_reach: [f32; 2],
    bits_per_line: [f32; 2],
    skewed: bool,
}

/// One row of microlenses in a view of a tile.
struct LensRow {
    /// Position of each microlens among the voxels.
    centre_bit: [f32; LENSES],
    centre_line: [f32; LENSES],
    /// Middle of the gap beside each microlens among the voxels, and the distance within which it
    /// hides too much; negative if there is no gap.
    gap_centre: [f32; LENSES],
    gap_reach: [f32; LENSES],
    zones: Zones,
    /// Position of the first microlens across the lines, without its phase.
    line: f32,
}

/// Voxels for each microlens of a row: bits of the lines from the first to the last.
struct Zones {
    words: [[u32; LENSES]; WORDS],
    first: [i32; LENSES],
    last: [i32; LENSES],
}

impl TilePlace {
    /// `None` if a view sees the tile edge-on and has no affine map, or spans too many microlenses.
    fn view(&self, view: &ViewAddresses, support: &Support) -> Option<TileView> {
        let pupil = view.pupil.map(f64::from);
        let by_voxel: [[f64; 2]; 2] = std::array::from_fn(|n| {
            std::array::from_fn(|v| self.by_voxel[n][v] + self.parallax_by_voxel[n][v] * pupil[n])
        });
        let [[a, b], [c, d]] = by_voxel;
        let determinant = a * d - b * c;
        if determinant.abs() < 1e-9 {
            return None;
        }
        let voxels = [[d / determinant, -b / determinant], [-c / determinant, a / determinant]];
        let place: [f64; 2] = std::array::from_fn(|n| self.place[n] + self.parallax[n] * pupil[n]);
        let half = [self.bits as f64 / 2.0, self.lines as f64 / 2.0];
        let [first, last]: [[f64; 2]; 2] = [-1.0, 1.0].map(|sign| {
            std::array::from_fn(|n| {
                let [by_bit, by_line] = by_voxel[n].map(f64::abs);
                let wide =
                    by_bit * half[0] + by_line * half[1] + support.reach[n] + support.phase[n];
                place[n] + sign * wide
            })
        });
        if last[0] - first[0] > LENSES as f64 - 1.0 {
            return None;
        }
        let lenses = view.axes.map(|axis| f64::from(axis.lenses));
        let phase_lines =
            voxels[1][0].abs() * support.phase[0] + voxels[1][1].abs() * support.phase[1];
        let reach = std::array::from_fn(|n| {
            let [by_x, by_y]: [f64; 2] = voxels[n];
            (by_x.abs() * support.reach[0] + by_y.abs() * support.reach[1]) as f32
        });
        // Bits along which the position does not change: a line has all of them or none.
        let by_bit = |n: usize| by_voxel[n][0].abs().max(1e-6).copysign(by_voxel[n][0]);
        Some(TileView {
            place: place.map(|place| place as f32),
            voxels: voxels.map(|row| row.map(|voxels| voxels as f32)),
            middle: self.middle.map(|middle| middle as f32),
            reach,
            parallax: self.parallax.map(|parallax| parallax as f32),
            first: first[0].ceil() as i32,
            rows: [first[1].ceil() as i32, last[1].floor() as i32 + 1],
            bits: self.word_bits().map(|bits| bits as f32),
            phase_lines: phase_lines as f32,
            lines: self.lines as f32,
            inside: (0..2).all(|n| first[n] >= 0.0 && last[n] <= lenses[n] - 1.0),
            lens_width: support.lens_width as f32,
            gap_least: support.gaps.map(|zone| zone.least as f32),
            gap_half: support.gaps.map(|zone| zone.half as f32),
            gap_growth: support.gaps.map(|zone| zone.half_per_gap as f32),
            gaps: support.has_gaps(),
            bit_reach: std::array::from_fn(|n| (support.reach[n] / by_bit(n).abs()) as f32),
            bits_per_line: std::array::from_fn(|n| (by_voxel[n][1] / by_bit(n)) as f32),
            skewed: (0..2).any(|n| voxels[n][1 - n].abs() > SKEWED * voxels[n][n].abs()),
        })
    }

    /// Number of voxels in each word of a line.
    fn word_bits(&self) -> [usize; WORDS] {
        let first = self.bits.min(WORD_BITS);
        [first, self.bits - first]
    }

    /// A line's voxels as one integer.
    fn joined(&self, words: [u32; WORDS]) -> u64 {
        u64::from(words[0]) | u64::from(words[1]) << self.word_bits()[0]
    }

    fn full_line(&self) -> u64 {
        (1 << self.bits) - 1
    }

    /// Evaluates all views.
    pub fn evaluate(&self, views: &Views, support: &Support) -> TileResult {
        let Views { selected, others, bits, phases, tolerated } = *views;
        let full = self.full_line();
        let mut dark = DarkCounts::<1>::new(self.lines, [full], tolerated);
        let mut row = LensRow::default();
        let mut lit = [[[0; LANES]; WORDS]; MAX_LINES];
        let mut seen = vec![0; self.lines];
        for (image, addresses) in selected.iter().enumerate() {
            let Some(view) = self.view(addresses, support) else { continue };
            let rows = |j| bits.row(image, j, view.first) as u32;
            lit[..self.lines].fill([[0; LANES]; WORDS]);
            light(&view, phases, rows, &mut row, &mut lit);
            count(&lit[..self.lines], self.word_bits()[0], full, &mut dark);
            self.see(&view, addresses, phases, &mut row, &mut seen);
            if image % 8 == 7 && (0..self.lines).all(|line| !dark.is_open(line)) {
                break;
            }
        }
        let possible: Vec<u64> = dark.within().into_iter().map(|[line]| line & full).collect();
        let unseen = |seen: &[u64]| possible.iter().zip(seen).any(|(line, seen)| line & !seen != 0);
        for addresses in others {
            if !unseen(&seen) {
                break;
            }
            if let Some(view) = self.view(addresses, support) {
                self.see(&view, addresses, phases, &mut row, &mut seen);
            }
        }
        TileResult { possible, seen }
    }

    /// Adds the voxels whose microlenses are all inside the window.
    fn see(
        &self,
        view: &TileView,
        addresses: &ViewAddresses,
        phases: &LensPhases,
        row: &mut LensRow,
        seen: &mut [u64],
    ) {
        let full = self.full_line();
        if seen.iter().all(|&line| line == full) {
            return;
        }
        let mut beyond = [[[0; LANES]; WORDS]; MAX_LINES];
        if !view.inside {
            let [columns, rows] = addresses.axes.map(|axis| axis.lenses as i32);
            let outside = |j: i32| {
                if j < 0 || j >= rows {
                    return u32::MAX;
                }
                (0..LENSES).fold(0, |bits, n| {
                    let i = view.first + n as i32;
                    bits | u32::from(i < 0 || i >= columns) << n
                })
            };
            light(view, phases, outside, row, &mut beyond);
        }
        for (seen, beyond) in seen.iter_mut().zip(&beyond) {
            *seen |= full & !self.joined(beyond.map(any_lane));
        }
    }
}

/// Union over all lanes.
#[inline(always)]
fn any_lane(lanes: [u32; LANES]) -> u32 {
    let mut any = 0;
    for lane in lanes {
        any |= lane;
    }
    any
}

impl Default for LensRow {
    fn default() -> Self {
        Self {
            centre_bit: [0.0; LENSES],
            centre_line: [0.0; LENSES],
            gap_centre: [0.0; LENSES],
            gap_reach: [0.0; LENSES],
            line: 0.0,
            zones: Zones { words: [[0; LENSES]; WORDS], first: [0; LENSES], last: [0; LENSES] },
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

#[inline(always)]
fn mask([low, high]: [u32; 2]) -> u32 {
    (1u32 << (high & 31)).wrapping_sub(1u32 << (low & 31))
}

/// All bits if the lowest bit is set, else none.
#[inline(always)]
fn spread(bit: u32) -> u32 {
    0u32.wrapping_sub(bit & 1)
}

impl LensRow {
    /// Computes the positions of the microlenses of row `j`.
    #[inline(always)]
    fn fill(&mut self, view: &TileView, phases: &LensPhases, j: i32) {
        let [[bit_x, bit_y], [line_x, line_y]] = view.voxels;
        let (x, y) = (view.first as f32 - view.place[0], j as f32 - view.place[1]);
        let bit = view.middle[0] + bit_x * x + bit_y * y;
        let line = view.middle[1] + line_x * x + line_y * y;
        self.line = line;
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

    /// Lights the voxels of the microlenses whose bit is set.
    #[inline(always)]
    fn light(&mut self, view: &TileView, lenses: u32, lit: &mut Lit) {
        for n in 0..LENSES {
            let lines = ends(range(self.centre_line[n], view.reach[1], view.lines));
            [self.zones.first[n], self.zones.last[n]] = lines;
        }
        for word in 0..WORDS {
            for n in 0..LENSES {
                let centre = self.centre_bit[n] - (word * WORD_BITS) as f32;
                let zone = mask(range(centre, view.reach[0], view.bits[word]));
                self.zones.words[word][n] = zone & spread(lenses >> n);
            }
        }
        let [any, all] = self.lines(view, view.reach[1]);
        if view.skewed {
            self.light_skewed(view, any, lit);
        } else if all.is_empty() {
            self.zones.light(any, lit);
        } else {
            self.zones.light(any.start..all.start, lit);
            self.zones.light_all(all.clone(), lit);
            self.zones.light(all.end..any.end, lit);
        }
    }

    /// The lines within `reach` of any microlens, and those within `reach` of all.
    #[inline(always)]
    fn lines(&self, view: &TileView, reach: f32) -> [Range<usize>; 2] {
        let ends = [self.line, self.line + view.voxels[1][0] * (LENSES - 1) as f32];
        let first = ends[0].min(ends[1]) - view.phase_lines;
        let last = ends[0].max(ends[1]) + view.phase_lines;
        // Slightly fewer than all, so that rounding does not matter.
        const LESS: f32 = 1e-3;
        [[first - reach, last + reach], [last - reach + LESS, first + reach - LESS]].map(
            |[low, high]| {
                let low = low.max(0.0).ceil() as usize;
                low..((high + 1.0).clamp(0.0, view.lines) as usize).max(low)
            },
        )
    }

    /// Lights the voxels of the zones line by line: those within reach along both columns and rows.
    #[inline(always)]
    fn light_skewed(&self, view: &TileView, lines: Range<usize>, lit: &mut Lit) {
        for line in lines {
            for (word, lit) in lit[line].iter_mut().enumerate() {
                let mut lanes = *lit;
                for start in (0..LENSES).step_by(LANES) {
                    for (lane, lit) in lanes.iter_mut().enumerate() {
                        *lit |= self.skewed(view, line as i32, word, start + lane);
                    }
                }
                *lit = lanes;
            }
        }
    }

    /// The voxels of a line's word that a microlens lights in a skewed tile.
    #[inline(always)]
    fn skewed(&self, view: &TileView, line: i32, word: usize, n: usize) -> u32 {
        let beside = line as f32 - self.centre_line[n];
        let centre = self.centre_bit[n] - (word * WORD_BITS) as f32;
        let mut zone = self.zones.words[word][n] & self.zones.has(line, n);
        for axis in 0..2 {
            let middle = centre - view.bits_per_line[axis] * beside;
            zone &= mask(range(middle, view.bit_reach[axis], view.bits[word]));
        }
        zone
    }

    /// Lights the voxels that no microlens sees well, in the gaps between the microlenses' pupil
    /// intervals (see [`crate::model::tables::MIN_SEEN_SHARE`]), in this row and before it.
    #[inline(always)]
    fn light_gaps(&mut self, view: &TileView, phases: &LensPhases, j: i32, lit: &mut Lit) {
        let [along, across] = phases.steps(j);
        if view.has_gap(0, along) && self.find_gaps(view, phases, j) {
            let half = 0.5 * view.voxels[1][1].abs();
            for n in 0..LENSES {
                let own = range(self.centre_line[n], half, view.lines);
                [self.zones.first[n], self.zones.last[n]] = ends(own);
            }
            self.fill_words(view, self.gap_centre, self.gap_reach);
            let [any, _] = self.lines(view, half);
            self.zones.light(any, lit);
        }
        let follows = j > view.rows[0];
        if follows && view.has_gap(1, across) && self.find_gaps_before(view, phases, j) {
            let half = 0.5 * view.voxels[0][0].abs();
            for n in 0..LENSES {
                let gap = range(self.gap_centre[n], self.gap_reach[n], view.lines);
                [self.zones.first[n], self.zones.last[n]] = ends(gap);
            }
            self.fill_words(view, self.centre_bit, [half; LENSES]);
            // The gap's middle is half a row away, and gaps are at most a row wide.
            let reach = 1.5 * view.voxels[1][1].abs();
            let [any, _] = self.lines(view, reach);
            self.zones.light(any, lit);
        }
    }

    #[inline(always)]
    fn fill_words(&mut self, view: &TileView, centre: [f32; LENSES], reach: [f32; LENSES]) {
        for word in 0..WORDS {
            for n in 0..LENSES {
                let centre = centre[n] - (word * WORD_BITS) as f32;
                self.zones.words[word][n] = mask(range(centre, reach[n], view.bits[word]));
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

impl TileView {
    /// Whether a gap can hide too much, for this smallest and largest increase of the phase between
    /// neighbouring microlenses.
    fn has_gap(&self, axis: usize, steps: [f32; 2]) -> bool {
        let apart = steps.map(|step| -step * self.parallax[axis]);
        1.0 - self.lens_width + apart[0].max(apart[1]) > self.gap_least[axis]
    }

    /// Distance from its middle within which a gap of this width hides too much, in microlenses;
    /// negative if it is too narrow.
    #[inline(always)]
    fn gap_reach(&self, axis: usize, gap: f32) -> f32 {
        let half = self.gap_half[axis] + self.gap_growth[axis] * (gap - self.gap_least[axis]);
        if gap > self.gap_least[axis] { half } else { -1.0 }
    }
}

impl Zones {
    /// All bits if zone `n` contains the line, else none.
    #[inline(always)]
    fn has(&self, line: i32, n: usize) -> u32 {
        // Negative only outside; a comparison would prevent vectorisation.
        let outside = (line - self.first[n]) | (self.last[n] - line);
        !(outside >> 31) as u32
    }

    /// Lights the zones in lines that all of them contain.
    #[inline(always)]
    fn light_all(&self, lines: Range<usize>, lit: &mut Lit) {
        let mut any = [[0; LANES]; WORDS];
        for (any, zones) in any.iter_mut().zip(&self.words) {
            for start in (0..LENSES).step_by(LANES) {
                for (lane, any) in any.iter_mut().enumerate() {
                    *any |= zones[start + lane];
                }
            }
        }
        for line in lines {
            for (lit, any) in lit[line].iter_mut().zip(&any) {
                for (lit, any) in lit.iter_mut().zip(any) {
                    *lit |= any;
                }
            }
        }
    }

    #[inline(always)]
    fn light(&self, lines: Range<usize>, lit: &mut Lit) {
        for line in lines {
            let mut words = lit[line];
            for start in (0..LENSES).step_by(LANES) {
                let mut has = [0; LANES];
                for (lane, has) in has.iter_mut().enumerate() {
                    *has = self.has(line as i32, start + lane);
                }
                for (lit, zones) in words.iter_mut().zip(&self.words) {
                    for (lane, lit) in lit.iter_mut().enumerate() {
                        *lit |= zones[start + lane] & has[lane];
                    }
                }
            }
            lit[line] = words;
        }
    }
}

/// Lights the voxels of the microlenses whose bit is set in `rows`, by row number, and the voxels
/// of which the view sees too little.
#[inline(always)]
fn light(
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
        row.fill(view, phases, j);
        row.light(view, lenses, lit);
        if view.gaps {
            row.light_gaps(view, phases, j, lit);
        }
    }
}

/// Counts the voxels that are not lit; those of the second word follow the `first_bits` of the first.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn count(lit: &[[[u32; LANES]; WORDS]], first_bits: usize, full: u64, dark: &mut DarkCounts<1>) {
    for (line, [first, second]) in lit.iter().enumerate() {
        let lit = u64::from(any_lane(*first)) | u64::from(any_lane(*second)) << (first_bits & 63);
        dark.count(line, &[[full & !lit]]);
    }
}
