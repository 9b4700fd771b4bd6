//! Projection of blocks with pair tables, one view at a time.
//!
//! A block's light is first summed over its two depths where they share their taps, then spread
//! over the microlenses along the columns, then along the rows. Rows are `L` values long whatever the
//! footprint: shares beyond it are 0, and the loops unroll into vector instructions. The kernels
//! are plain loops, not iterator chains: two of three instructions were calls otherwise.

use std::{borrow::Cow, ops::Range};

use multiversion::multiversion;

use super::{
    BlockLight, BlockProjector,
    aligned::{AlignedModel, Place, ViewTables},
    axis_table::SHARE_UNIT,
};
use crate::model::ViewId;

/// An [`AlignedModel`] restricted to active blocks.
pub(super) struct AlignedProjector<'a, const L: usize, const D: usize> {
    pub(super) model: &'a AlignedModel<L, D>,
    /// Per camera, per active block.
    pub(super) places: Vec<Vec<Place>>,
}

/// For row r and column c of a block as the camera sees it, the near and the far child.
type Children = [[[usize; 2]; 2]; 2];

impl<const L: usize, const D: usize> BlockProjector for AlignedProjector<'_, L, D> {
    fn project(&self, view: ViewId, light: &[BlockLight], image: &mut [f32]) {
        let tables = self.model.view(view);
        let children = self.model.cameras[view.camera].axes.children();
        image.fill(0.0);
        project_blocks::<L, D>(&tables, &children, &self.places[view.camera], light, image);
        for (pixel, &open) in image.iter_mut().zip(tables.coverage.unwrap_or(&[])) {
            *pixel *= open;
        }
    }

    fn back_project(
        &self,
        view: ViewId,
        image: &[f32],
        range: Range<usize>,
        out: &mut [BlockLight],
    ) {
        let tables = self.model.view(view);
        let children = self.model.cameras[view.camera].axes.children();
        let mut open = Cow::Borrowed(image);
        if let Some(coverage) = tables.coverage {
            open.to_mut().iter_mut().zip(coverage).for_each(|(pixel, open)| *pixel *= open);
        }
        gather_blocks::<L, D>(&tables, &children, &self.places[view.camera][range], &open, out);
    }

    fn retain(&mut self, keep: &[bool]) {
        for places in &mut self.places {
            let mut flags = keep.iter();
            places.retain(|_| flags.next().copied().unwrap_or(false));
        }
    }
}

/// A share along the columns times one along the rows, in the units of the tables.
const UNITS: f32 = SHARE_UNIT * SHARE_UNIT;

#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn project_blocks<const L: usize, const D: usize>(
    tables: &ViewTables<'_, L>,
    children: &Children,
    places: &[Place],
    light: &[BlockLight],
    image: &mut [f32],
) {
    for (place, light) in places.iter().zip(light) {
        for layer in 0..D {
            let column = &tables.columns[place.column as usize + layer * tables.column_pairs];
            let row = &tables.rows[place.row as usize + layer * tables.row_pairs];
            let of_layer = |depths: &[usize; 2]| match D {
                1 => light[depths[0] & 7] + light[depths[1] & 7],
                _ => light[depths[layer & 1] & 7],
            };
            let mut spread = [[0.0f32; L]; 2];
            for (spread, [low, high]) in spread.iter_mut().zip(children) {
                let (low, high) = (of_layer(low) * UNITS, of_layer(high) * UNITS);
                for (i, spread) in spread.iter_mut().enumerate() {
                    *spread = low * f32::from(column.shares[0][i])
                        + high * f32::from(column.shares[1][i]);
                }
            }
            let mut at = usize::from(row.first) * tables.width + usize::from(column.first);
            for j in 0..usize::from(row.len).min(L) {
                // Tables and image belong together; a wrong image length loses light, no more.
                let Some(pixels) = image.get_mut(at..at + L) else { break };
                let (low, high) = (f32::from(row.shares[0][j]), f32::from(row.shares[1][j]));
                for i in 0..L {
                    pixels[i] += low * spread[0][i] + high * spread[1][i];
                }
                at += tables.width;
            }
        }
    }
}

#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn gather_blocks<const L: usize, const D: usize>(
    tables: &ViewTables<'_, L>,
    children: &Children,
    places: &[Place],
    image: &[f32],
    out: &mut [BlockLight],
) {
    for (place, out) in places.iter().zip(out) {
        for layer in 0..D {
            let column = &tables.columns[place.column as usize + layer * tables.column_pairs];
            let row = &tables.rows[place.row as usize + layer * tables.row_pairs];
            let mut at = usize::from(row.first) * tables.width + usize::from(column.first);
            let mut sums = [[0.0f32; L]; 2];
            for j in 0..usize::from(row.len).min(L) {
                let Some(pixels) = image.get(at..at + L) else { break };
                let (low, high) = (f32::from(row.shares[0][j]), f32::from(row.shares[1][j]));
                for i in 0..L {
                    sums[0][i] += low * pixels[i];
                    sums[1][i] += high * pixels[i];
                }
                at += tables.width;
            }
            for (sums, children) in sums.iter().zip(children) {
                for (shares, depths) in column.shares.iter().zip(children) {
                    let sum = dot(sums, shares) * UNITS;
                    if D == 1 {
                        out[depths[0] & 7] += sum;
                        out[depths[1] & 7] += sum;
                    } else {
                        out[depths[layer & 1] & 7] += sum;
                    }
                }
            }
        }
    }
}

/// Σ a_i b_i, halves first: the order that vector units like. `L` is a power of two.
#[inline(always)]
fn dot<const L: usize>(a: &[f32; L], b: &[u16; L]) -> f32 {
    let mut products = [0.0f32; L];
    for i in 0..L {
        products[i] = a[i] * f32::from(b[i]);
    }
    let mut half = L / 2;
    while half > 0 {
        for i in 0..half {
            products[i] += products[i + half];
        }
        half /= 2;
    }
    products[0]
}
