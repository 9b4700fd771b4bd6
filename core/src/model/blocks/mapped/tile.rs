//! Photo-hull of a tile: up to 60 × 96 voxels of up to eight depths, for all views of a camera. Depths that a
//! view displaces little are evaluated as one layer of the tile. Layers have the same bits of a microlens and
//! differ in the lines.
//!
//! Relative to the array's columns and rows the voxels of a tile are almost evenly spaced, so a
//! view maps microlenses onto voxels by an affine function ([`TileView`]). A lit microlens corresponds to a
//! rectangle of voxels ([`super::lens_row`]): a few bits of a few lines. Each microlens has the phase of its own
//! pixel, so that rectangles need not be widened for phases.

use super::{
    lens_phases::LensPhases,
    lens_row::{LensRow, Lit, light},
    lit_bits::LitBits,
    places::ViewAddresses,
    support::Support,
    tile_place::{LENSES, TilePlace},
    tile_view::TileView,
};
use crate::model::blocks::dark_counts::DarkCounts;

/// The views of a camera.
#[derive(Clone, Copy)]
pub(super) struct Views<'a> {
    /// The selected views with images, in the order of `bits`.
    pub selected: &'a [ViewAddresses],
    /// All views, first those that contain most voxels.
    pub all: &'a [ViewAddresses],
    pub bits: &'a LitBits,
    pub phases: &'a LensPhases,
    /// Number of views in which a lit voxel may be dark.
    pub tolerated: usize,
}

/// Result for a tile.
#[derive(Debug, Clone)]
pub(super) struct TileResult {
    /// Per layer and line, the voxels that are dark in no more views than tolerated.
    pub possible: Vec<u64>,
    /// Those of them that are visible in any view; may contain others.
    pub visible: Vec<u64>,
}

impl TilePlace {
    fn full_line(&self) -> u64 {
        (1 << self.bits) - 1
    }

    /// Position of a layer's middle, from −1 at the first depth to 1 at the last.
    pub fn layer_middle(&self, layer: usize) -> f64 {
        let first = self.layer_share - 1.0;
        let between = -2.0 * first / (self.layers as f64 - 1.0).max(1.0);
        first + between * layer as f64
    }

    /// Zeroes the voxels of its lines.
    fn clear(&self, lit: &mut Lit) {
        lit.0[..self.layers].iter_mut().for_each(|lit| lit[..self.lines].fill(0));
    }

    /// The voxels of its layers, line by line.
    fn lines_of<'a>(&self, lit: &'a Lit) -> impl Iterator<Item = &'a u64> {
        let lines = self.lines;
        lit.0[..self.layers].iter().flat_map(move |lit| &lit[..lines])
    }

    /// Evaluates all views.
    pub fn evaluate(&self, views: &Views, support: &Support) -> TileResult {
        let Views { selected, all, bits, phases, tolerated } = *views;
        let full = self.full_line();
        let lines = self.layers * self.lines;
        let mut dark = DarkCounts::<1>::new(lines, [full], tolerated);
        let mut row = LensRow::default();
        let mut lit = Lit::default();
        for (image, addresses) in selected.iter().enumerate() {
            let Some(view) = TileView::new(self, addresses, support) else { continue };
            let rows = |j| bits.row(image, j, view.first) as u32;
            self.clear(&mut lit);
            light(&view, phases, rows, &mut row, &mut lit);
            for (line, lit) in self.lines_of(&lit).enumerate() {
                dark.count(line, &[[full & !lit]]);
            }
            if image % 8 == 7 && (0..lines).all(|line| !dark.is_open(line)) {
                break;
            }
        }
        let possible: Vec<u64> = dark.within().into_iter().map(|[line]| line & full).collect();
        let mut visible = vec![0; lines];
        let invisible = |visible: &[u64]| {
            possible.iter().zip(visible).any(|(line, visible)| line & !visible != 0)
        };
        for addresses in all {
            if !invisible(&visible) {
                break;
            }
            if let Some(view) = TileView::new(self, addresses, support) {
                self.add_visible(&view, addresses, phases, &mut row, &mut visible);
            }
        }
        TileResult { possible, visible }
    }

    /// Adds the voxels whose microlenses are all inside the window.
    fn add_visible(
        &self,
        view: &TileView,
        addresses: &ViewAddresses,
        phases: &LensPhases,
        row: &mut LensRow,
        visible: &mut [u64],
    ) {
        let full = self.full_line();
        let mut beyond = Lit::default();
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
        for (visible, beyond) in visible.iter_mut().zip(self.lines_of(&beyond)) {
            *visible |= full & !beyond;
        }
    }
}
