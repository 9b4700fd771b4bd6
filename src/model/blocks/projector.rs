//! Projection of blocks with pair tables, one view at a time.
//!
//! A block's light is first summed over its two depths, which share their taps, then spread over
//! the microlenses along the columns, then along the rows. Rows are `L` values long whatever the
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
pub(super) struct AlignedProjector<'a, const L: usize> {
    pub(super) model: &'a AlignedModel<L>,
    /// Per camera, per active block.
    pub(super) places: Vec<Vec<Place>>,
}

/// For row r and column c of a block as the camera sees it, the near and the far child.
type Children = [[[usize; 2]; 2]; 2];

impl<const L: usize> BlockProjector for AlignedProjector<'_, L> {
    fn project(&self, view: ViewId, light: &[BlockLight], image: &mut [f32]) {
        let tables = self.model.view(view);
        let children = self.model.cameras[view.camera].axes.children();
        image.fill(0.0);
        project_blocks(&tables, &children, &self.places[view.camera], light, image);
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
        gather_blocks(&tables, &children, &self.places[view.camera][range], &open, out);
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
fn project_blocks<const L: usize>(
    tables: &ViewTables<'_, L>,
    children: &Children,
    places: &[Place],
    light: &[BlockLight],
    image: &mut [f32],
) {
    for (place, light) in places.iter().zip(light) {
        let column = &tables.columns[place.column as usize];
        let row = &tables.rows[place.row as usize];
        let mut spread = [[0.0f32; L]; 2];
        for (spread, [low, high]) in spread.iter_mut().zip(children) {
            let low = (light[low[0] & 7] + light[low[1] & 7]) * UNITS;
            let high = (light[high[0] & 7] + light[high[1] & 7]) * UNITS;
            for (i, spread) in spread.iter_mut().enumerate() {
                *spread =
                    low * f32::from(column.shares[0][i]) + high * f32::from(column.shares[1][i]);
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

#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn gather_blocks<const L: usize>(
    tables: &ViewTables<'_, L>,
    children: &Children,
    places: &[Place],
    image: &[f32],
    out: &mut [BlockLight],
) {
    for (place, out) in places.iter().zip(out) {
        let column = &tables.columns[place.column as usize];
        let row = &tables.rows[place.row as usize];
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
            for (shares, [near, far]) in column.shares.iter().zip(children) {
                let sum = dot(sums, shares) * UNITS;
                out[near & 7] += sum;
                out[far & 7] += sum;
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
