//! Projection with the tables, one view at a time.

use std::ops::Range;

use super::{Place, ThinLensModel};
use crate::model::{Projector, SUPPORT_SHARE, ViewId, tables::Tap};

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

/// The `W` values from pixel `at`, 0 beyond the image's end: taps of weight 0 reach there where
/// the window is narrower than they are.
fn line<const W: usize>(image: &[f32], at: usize) -> [f32; W] {
    // The known length is what lets the loops over taps unroll.
    match image.get(at..at + W).and_then(|line| <[f32; W]>::try_from(line).ok()) {
        Some(line) => line,
        None => std::array::from_fn(|n| image.get(at + n).copied().unwrap_or(0.0)),
    }
}

/// Adds to the values from pixel `at`; what lies beyond the image's end is dropped, see [`line`].
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
            // Written as loops: iterator sums cost ten times as much in the dev profile.
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
        for (place, out) in self.places[view.camera][range].iter().zip(out) {
            let column = &columns[place.column as usize];
            let row = &rows[place.row as usize];
            let mut at = row.first as usize * width + column.first as usize;
            let mut most: Option<f32> = None;
            for weight in row.weights {
                if weight > SUPPORT_SHARE {
                    let line: [f32; W] = line(image, at);
                    for (pixel, share) in line.into_iter().zip(column.weights) {
                        if share > SUPPORT_SHARE {
                            most = Some(most.unwrap_or(0.0).max(pixel));
                        }
                    }
                }
                at += width;
            }
            *out = most.unwrap_or(f32::INFINITY);
        }
    }

    fn retain(&mut self, keep: &[bool]) {
        for places in &mut self.places {
            let mut flags = keep.iter();
            places.retain(|_| flags.next().copied().unwrap_or(false));
        }
    }
}
