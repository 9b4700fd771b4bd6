//! Projection of blocks with pair tables, one view at a time.
//!
//! A block's light is first summed over its two depths, which share their taps, then spread over
//! the microlenses along the columns, then along the rows. Rows are `L` values long whatever the
//! footprint: shares beyond it are 0, and the loops unroll into vector instructions.

use std::{borrow::Cow, ops::Range};

use super::{
    BlockLight, BlockProjector,
    aligned::{AlignedModel, Place},
};
use crate::model::ViewId;

/// An [`AlignedModel`] restricted to active blocks.
pub(super) struct AlignedProjector<'a, const L: usize> {
    pub(super) model: &'a AlignedModel<L>,
    /// Per camera, per active block.
    pub(super) places: Vec<Vec<Place>>,
}

impl<const L: usize> BlockProjector for AlignedProjector<'_, L> {
    fn project(&self, view: ViewId, light: &[BlockLight], image: &mut [f32]) {
        let tables = self.model.view(view);
        let children = self.model.cameras[view.camera].axes.children();
        image.fill(0.0);
        for (place, light) in self.places[view.camera].iter().zip(light) {
            let column = &tables.columns[place.column as usize];
            let row = &tables.rows[place.row as usize];
            let spread: [[f32; L]; 2] = children.map(|row| {
                let [low, high] = row.map(|[near, far]| light[near & 7] + light[far & 7]);
                std::array::from_fn(|i| low * column.shares[0][i] + high * column.shares[1][i])
            });
            let mut at = usize::from(row.first) * tables.width + usize::from(column.first);
            for (low, high) in row.shares[0].iter().zip(&row.shares[1]).take(row.len.into()) {
                // Tables and image belong together; a wrong image length loses light, no more.
                let Some(pixels) = image.get_mut(at..at + L) else { break };
                for (i, pixel) in pixels.iter_mut().enumerate() {
                    *pixel += low * spread[0][i] + high * spread[1][i];
                }
                at += tables.width;
            }
        }
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
        let image = open.as_ref();
        for (place, out) in self.places[view.camera][range].iter().zip(out) {
            let column = &tables.columns[place.column as usize];
            let row = &tables.rows[place.row as usize];
            let mut at = usize::from(row.first) * tables.width + usize::from(column.first);
            let mut sums = [[0.0f32; L]; 2];
            for (low, high) in row.shares[0].iter().zip(&row.shares[1]).take(row.len.into()) {
                let Some(pixels) = image.get(at..at + L) else { break };
                for (i, pixel) in pixels.iter().enumerate() {
                    sums[0][i] += low * pixel;
                    sums[1][i] += high * pixel;
                }
                at += tables.width;
            }
            for (sums, row) in sums.iter().zip(children) {
                for (shares, [near, far]) in column.shares.iter().zip(row) {
                    let sum: f32 = sums.iter().zip(shares).map(|(sum, share)| sum * share).sum();
                    out[near & 7] += sum;
                    out[far & 7] += sum;
                }
            }
        }
    }

    fn retain(&mut self, keep: &[bool]) {
        for places in &mut self.places {
            let mut flags = keep.iter();
            places.retain(|_| flags.next().copied().unwrap_or(false));
        }
    }
}
