//! Projection with the tables, one view at a time.

use std::ops::Range;

use super::{Place, ThinLensModel};
use crate::model::{Projector, ViewId, tables::Tap};

/// A [`ThinLensModel`] restricted to active voxels.
pub(super) struct ThinLensProjector<'a, const W: usize> {
    pub(super) model: &'a ThinLensModel<W>,
    /// Per camera, per active voxel.
    pub(super) places: Vec<Vec<Place>>,
}

impl<const W: usize> ThinLensProjector<'_, W> {
    /// The tables of a view: taps along columns, taps along rows, image width, coverage.
    fn tables(&self, id: ViewId) -> (&[Tap<W>], &[Tap<W>], usize, Option<&[f32]>) {
        let camera = &self.model.cameras[id.camera];
        let view = &self.model.layouts[id.camera].views[id.view];
        let columns = camera.columns.of_view(view.k);
        let rows = camera.rows.of_view(view.l);
        (columns, rows, camera.width, view.coverage.as_deref())
    }
}

/// The `W` values from pixel `at`; 0 beyond the image's end, which taps of weight 0 can reach if the window is
/// narrow.
fn line<const W: usize>(image: &[f32], at: usize) -> [f32; W] {
    // A constant length allows unrolling of the loops over taps.
    match image.get(at..at + W).and_then(|line| <[f32; W]>::try_from(line).ok()) {
        Some(line) => line,
        None => std::array::from_fn(|n| image.get(at + n).copied().unwrap_or(0.0)),
    }
}

/// Adds to the values from pixel `at`; values beyond the image's end are dropped, see [`line`].
fn add_line<const W: usize>(image: &mut [f32], at: usize, values: [f32; W]) {
    let add = |pixels: &mut [f32]| {
        for (pixel, value) in pixels.iter_mut().zip(values) {
            *pixel += value;
        }
    };
    if let Some(pixels) = image.get_mut(at..at + W) {
        add(pixels);
    } else if let Some(pixels) = image.get_mut(at..) {
        add(pixels);
    }
}

/// The maximum over every block of up to `W` × `W` pixels that starts at a pixel, for blocks of
/// `high` rows and `wide` columns at `((high − 1) W + wide − 1) · image.len()`. Blocks end at the
/// image's edges.
fn block_maxima<const W: usize>(image: &[f32], width: usize) -> Vec<f32> {
    let len = image.len();
    let mut blocks = vec![0.0; W * W * len];
    let block = |high: usize, wide: usize| ((high - 1) * W + wide - 1) * len;
    // Negative values are noise.
    for (to, &from) in blocks[block(1, 1)..][..len].iter_mut().zip(image) {
        *to = from.max(0.0);
    }
    for wide in 2..=W {
        let (before, after) = blocks.split_at_mut(block(1, wide));
        let narrower = before[block(1, wide - 1)..][..len].chunks_exact(width);
        let rows = after[..len].chunks_exact_mut(width).zip(narrower);
        for ((to, from), image) in rows.zip(image.chunks_exact(width)) {
            to.copy_from_slice(from);
            let reach = width.saturating_sub(wide - 1);
            for (to, &beside) in to[..reach].iter_mut().zip(&image[width - reach..]) {
                *to = to.max(beside);
            }
        }
    }
    for high in 2..=W {
        for wide in 1..=W {
            let (before, after) = blocks.split_at_mut(block(high, wide));
            let to = &mut after[..len];
            to.copy_from_slice(&before[block(high - 1, wide)..][..len]);
            let shift = (high - 1) * width;
            let below = before[block(1, wide)..][..len].get(shift..).unwrap_or(&[]);
            for (to, &below) in to.iter_mut().zip(below) {
                *to = to.max(below);
            }
        }
    }
    blocks
}

impl<const W: usize> Projector for ThinLensProjector<'_, W> {
    fn project(&self, view: ViewId, intensity: &[f32], image: &mut [f32]) {
        let (columns, rows, width, coverage) = self.tables(view);
        image.fill(0.0);
        for (place, &intensity) in self.places[view.camera].iter().zip(intensity) {
            let column = &columns[place.column as usize];
            let row = &rows[place.row as usize];
            let scaled = column.weights.map(|w| w * intensity);
            let mut at = row.first as usize * width + column.first as usize;
            for weight in row.weights {
                add_line(image, at, scaled.map(|scaled| weight * scaled));
                at += width;
            }
        }
        if let Some(coverage) = coverage {
            for (pixel, &share) in image.iter_mut().zip(coverage) {
                *pixel *= share;
            }
        }
    }

    fn back_project(&self, view: ViewId, image: &[f32], range: Range<usize>, out: &mut [f32]) {
        let (columns, rows, width, coverage) = self.tables(view);
        let open: Vec<f32>;
        let image = match coverage {
            None => image,
            Some(coverage) => {
                open = image.iter().zip(coverage).map(|(&i, &c)| i * c).collect();
                &open
            }
        };
        for (place, out) in self.places[view.camera][range].iter().zip(out) {
            let column = &columns[place.column as usize];
            let row = &rows[place.row as usize];
            let mut at = row.first as usize * width + column.first as usize;
            // Loops instead of iterator sums, which take ten times as long in the dev profile.
            let mut sums = [0.0f32; W];
            for weight in row.weights {
                let line: [f32; W] = line(image, at);
                for (sum, value) in sums.iter_mut().zip(line) {
                    *sum += weight * value;
                }
                at += width;
            }
            for (sum, weight) in sums.into_iter().zip(column.weights) {
                *out += sum * weight;
            }
        }
    }

    fn brightest(&self, view: ViewId, image: &[f32], range: Range<usize>, out: &mut [f32]) {
        let (columns, rows, width, coverage) = self.tables(view);
        let judged: Vec<f32>;
        let image = match coverage {
            None => image,
            Some(coverage) => {
                let judge = |(&i, &c): (&f32, &f32)| if c > 0.5 { i / c } else { f32::INFINITY };
                judged = image.iter().zip(coverage).map(judge).collect();
                &judged
            }
        };
        // Maxima over blocks of at most W x W pixels are computed once for all voxels.
        let blocks = block_maxima::<W>(image, width);
        for (place, out) in self.places[view.camera][range].iter().zip(out) {
            let column = &columns[place.column as usize];
            let row = &rows[place.row as usize];
            let (wide, high) = (usize::from(column.support_len), usize::from(row.support_len));
            let at = usize::from(row.first + u16::from(row.support_start)) * width
                + usize::from(column.first + u16::from(column.support_start));
            *out = if wide == 0 || high == 0 {
                f32::INFINITY
            } else {
                let block = (high - 1) * W + wide - 1;
                blocks.get(block * image.len() + at).copied().unwrap_or(f32::INFINITY)
            };
        }
    }

    fn retain(&mut self, keep: &[bool]) {
        for places in &mut self.places {
            let mut flags = keep.iter();
            places.retain(|_| flags.next().copied().unwrap_or(false));
        }
    }
}
