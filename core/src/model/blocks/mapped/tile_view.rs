//! The map from microlenses to voxels of a tile.

use super::{
    places::ViewAddresses,
    support::Support,
    tile_place::{LENSES, TilePlace},
};

/// Slope of a tile's axes relative to the array's above which it counts as skewed.
const SKEWED: f64 = 0.15;

/// The map from microlenses to voxels of a tile, in one view.
#[derive(Debug, Clone, Copy)]
pub(super) struct TileView {
    /// Position of the tile's middle in this view.
    pub place: [f32; 2],
    /// Voxels per microlens.
    pub voxels: [[f32; 2]; 2],
    pub middle: [f32; 2],
    /// Reach of a microlens' light, in voxels: along bits in any layer, along lines in its own.
    pub reach: [f32; 2],
    /// Number of layers, shift of the first one along bits and lines, and shift from one to the next.
    pub layers: usize,
    pub first_shift: [f32; 2],
    pub shift: [f32; 2],
    /// Reach across a gap of the microlenses beside it, in microlenses: half a microlens, and the
    /// displacement of the outermost depths: along bits in any layer, along lines in its own.
    pub beside_gap: [f32; 2],
    pub parallax: [f32; 2],
    /// First microlens of a row, and the rows.
    pub first: i32,
    pub rows: [i32; 2],
    /// Voxels of a line, and number of lines.
    pub bits: f32,
    pub lines: f32,
    /// Whether all of its microlenses are inside the window.
    pub inside: bool,
    /// As in [`Support`].
    pub lens_width: f32,
    pub gap_least: [f32; 2],
    pub gap_half: [f32; 2],
    pub gap_growth: [f32; 2],
    pub gaps: bool,
    /// For skewed tiles, where the bounding rectangle of a microlens' light contains many other
    /// voxels: reach of a microlens along i and j in bits, and its shift from line to line.
    pub bit_reach: [f32; 2],
    pub bits_per_line: [f32; 2],
    pub skewed: bool,
}

impl TileView {
    /// `None` if the tile is edge-on in the view, so that there is no affine map, or extends over too many
    /// microlenses.
    pub fn new(tile: &TilePlace, view: &ViewAddresses, support: &Support) -> Option<Self> {
        let pupil = view.pupil.map(f64::from);
        let by_voxel: [[f64; 2]; 2] = std::array::from_fn(|n| {
            std::array::from_fn(|v| tile.by_voxel[n][v] + tile.parallax_by_voxel[n][v] * pupil[n])
        });
        let [[a, b], [c, d]] = by_voxel;
        let determinant = a * d - b * c;
        if determinant.abs() < 1e-9 {
            return None;
        }
        let voxels = [[d / determinant, -b / determinant], [-c / determinant, a / determinant]];
        let place: [f64; 2] = std::array::from_fn(|n| tile.place[n] + tile.parallax[n] * pupil[n]);
        let to_outermost: [f64; 2] = std::array::from_fn(|n| {
            tile.to_outermost[n] + tile.parallax_to_outermost[n] * pupil[n]
        });
        // Depths are displaced in this view from the middle of the tile, and of their layer.
        let displacement = to_outermost.map(f64::abs);
        let in_layer = displacement.map(|displacement| displacement * tile.layer_share);
        let [lens_reach, layer_reach]: [[f64; 2]; 2] = [displacement, in_layer]
            .map(|displacement| std::array::from_fn(|n| support.reach[n] + displacement[n]));
        let shift_at = |layer: usize| -> [f32; 2] {
            let at = tile.layer_middle(layer);
            voxels.map(|[by_x, by_y]| {
                -(at * (by_x * to_outermost[0] + by_y * to_outermost[1])) as f32
            })
        };
        let (first_shift, next_shift) = (shift_at(0), shift_at(1));
        let half = [tile.bits as f64 / 2.0, tile.lines as f64 / 2.0];
        let [first, last]: [[f64; 2]; 2] = [-1.0, 1.0].map(|sign| {
            std::array::from_fn(|n| {
                let [by_bit, by_line] = by_voxel[n].map(f64::abs);
                let wide = by_bit * half[0] + by_line * half[1] + lens_reach[n] + support.phase[n];
                place[n] + sign * wide
            })
        });
        if last[0] - first[0] > LENSES as f64 - 1.0 {
            return None;
        }
        let lenses = view.axes.map(|axis| f64::from(axis.lenses));
        let reach = std::array::from_fn(|n| {
            let ([by_x, by_y], reach) = (voxels[n], [lens_reach, layer_reach][n]);
            (by_x.abs() * reach[0] + by_y.abs() * reach[1]) as f32
        });
        // Where lines are inclined, a displacement across the rows moves the bits, too.
        let bits_by_rows = (voxels[0][1] / voxels[0][0]).abs().min(1.0);
        let beside = [displacement[0] + bits_by_rows * displacement[1], in_layer[1]];
        // Bits along which the position does not change: a line has all of them or none.
        let by_bit = |n: usize| by_voxel[n][0].abs().max(1e-6).copysign(by_voxel[n][0]);
        Some(Self {
            place: place.map(|place| place as f32),
            voxels: voxels.map(|row| row.map(|voxels| voxels as f32)),
            middle: tile.middle.map(|middle| middle as f32),
            reach,
            layers: tile.layers,
            first_shift,
            shift: std::array::from_fn(|v| next_shift[v] - first_shift[v]),
            beside_gap: beside.map(|displacement| (0.5 + displacement) as f32),
            parallax: tile.parallax.map(|parallax| parallax as f32),
            first: first[0].ceil() as i32,
            rows: [first[1].ceil() as i32, last[1].floor() as i32 + 1],
            bits: tile.bits as f32,
            lines: tile.lines as f32,
            inside: (0..2).all(|n| first[n] >= 0.0 && last[n] <= lenses[n] - 1.0),
            lens_width: support.lens_width as f32,
            gap_least: support.gaps.map(|zone| zone.least as f32),
            gap_half: std::array::from_fn(|n| (support.gaps[n].half + beside[n]) as f32),
            gap_growth: support.gaps.map(|zone| zone.half_per_gap as f32),
            gaps: support.has_gaps(),
            bit_reach: std::array::from_fn(|n| (layer_reach[n] / by_bit(n).abs()) as f32),
            bits_per_line: std::array::from_fn(|n| (by_voxel[n][1] / by_bit(n)) as f32),
            skewed: (0..2).any(|n| voxels[n][1 - n].abs() > SKEWED * voxels[n][n].abs()),
        })
    }

    /// Shift of a layer's microlenses along bits and lines.
    #[inline(always)]
    pub fn shift_of(&self, layer: usize) -> [f32; 2] {
        [0, 1].map(|v| self.first_shift[v] + self.shift[v] * layer as f32)
    }

    /// Position of the first microlens of row `j` across the lines, without its phase.
    #[inline(always)]
    pub fn line_of(&self, j: i32) -> f32 {
        let [line_x, line_y] = self.voxels[1];
        let (x, y) = (self.first as f32 - self.place[0], j as f32 - self.place[1]);
        self.middle[1] + line_x * x + line_y * y
    }

    /// Whether a gap can hide too much, for this smallest and largest increase of the phase between
    /// neighbouring microlenses.
    pub fn has_gap(&self, axis: usize, steps: [f32; 2]) -> bool {
        let apart = steps.map(|step| -step * self.parallax[axis]);
        1.0 - self.lens_width + apart[0].max(apart[1]) > self.gap_least[axis]
    }

    /// Distance from its middle within which a gap of this width hides too much, in microlenses;
    /// negative if it is too narrow.
    #[inline(always)]
    pub fn gap_reach(&self, axis: usize, gap: f32) -> f32 {
        let half = self.gap_half[axis] + self.gap_growth[axis] * (gap - self.gap_least[axis]);
        if gap > self.gap_least[axis] { half } else { -1.0 }
    }
}
