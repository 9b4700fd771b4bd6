//! Views: the sub-aperture images contained in a raw light-field image.
//!
//! View (k, l) consists of one pixel of every microlens: the one whose pupil interval is near (k, l) pupil cells
//! from the centre. It is an image of the scene through that part of the main lens, with one value per microlens
//! (a sub-aperture image in the paper's Fig. 5).

use std::{ops::Range, sync::Arc};

use lfpiv_hw::{Optics, RawImage};
use rayon::prelude::*;

use super::{GridSampling, LightLevels, sampling::AxisSampling};

/// Least mean coverage of a view: views with less light are not worth their computing time.
const MIN_MEAN_COVERAGE: f64 = 0.3;

/// Chords per pupil cell for integrating its overlap with the round aperture.
const CHORDS: usize = 32;

/// Number of independent partial sums over a cell's chords; divides [`CHORDS`].
const SUMS: usize = 8;

/// The part of the microlens array that images the volume.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct MicrolensWindow {
    /// Microlens columns, along `right`.
    pub columns: Range<usize>,
    /// Microlens rows, along `up`.
    pub rows: Range<usize>,
}

impl MicrolensWindow {
    /// The whole array.
    pub fn whole(optics: &Optics) -> Self {
        Self { columns: 0..optics.microlens.columns, rows: 0..optics.microlens.rows }
    }

    /// Number of microlenses in the window.
    pub fn len(&self) -> usize {
        self.columns.len() * self.rows.len()
    }

    /// Whether the window is empty.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// One sub-aperture direction.
#[derive(Debug, Clone)]
pub struct View {
    /// Index of the pupil cell along `right`, from the centre.
    pub k: i32,
    /// Index of the pupil cell along `up`, from the centre.
    pub l: i32,
    /// Share of each pixel's pupil cell inside the aperture, 0 where the microlens has no pixel for
    /// this view; row-major over the window. `None`: 1 everywhere.
    pub coverage: Option<Arc<[f32]>>,
}

impl View {
    /// Whether the aperture's edge crosses the pupil cell of any pixel in the window. Microlenses without a
    /// pixel for this view are ignored.
    pub fn is_cut(&self) -> bool {
        let cut = |&open: &f32| open > 0.0 && open < 1.0;
        self.coverage.as_ref().is_some_and(|coverage| coverage.iter().any(cut))
    }
}

/// Treatment of views at the aperture's edge.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ApertureEdge {
    /// Whether partly open views are kept, with the open share of each pixel.
    pub partly_open_views: bool,
    /// Width of the pupil interval that contributes to a pixel, in mm: a pupil cell, or more with
    /// diffraction.
    pub interval_mm: f64,
}

impl ApertureEdge {
    /// Keeps all views; the interval of each pixel is its pupil cell.
    pub fn sharp(optics: &Optics) -> Self {
        Self { partly_open_views: true, interval_mm: optics.pupil_cell_mm() }
    }
}

/// Decomposition of one camera's raw image into views.
#[derive(Debug, Clone)]
pub struct ViewLayout {
    /// Sampling of the sensor's columns.
    pub columns: AxisSampling,
    /// Sampling of the sensor's rows.
    pub rows: AxisSampling,
    /// Sampling of an arbitrarily oriented array. If present, it replaces `columns` and `rows`, which then
    /// describe the nominal array.
    pub grid: Option<Arc<GridSampling>>,
    /// The used part of the array.
    pub window: MicrolensWindow,
    /// The views with enough light, ordered by l, then k.
    pub views: Vec<View>,
}

/// The views of one raw image: per view one value per microlens of the window, row-major, in counts
/// above the black level.
#[derive(Debug, Clone, PartialEq)]
pub struct ViewStack {
    view_len: usize,
    values: Vec<f32>,
}

impl ViewStack {
    /// A stack of `views` images of `view_len` values each.
    pub fn new(view_len: usize, values: Vec<f32>) -> Self {
        debug_assert!(view_len > 0 && values.len().is_multiple_of(view_len));
        Self { view_len, values }
    }

    /// One view, row-major over the microlens window.
    pub fn view(&self, index: usize) -> &[f32] {
        &self.values[index * self.view_len..(index + 1) * self.view_len]
    }

    /// Number of views.
    pub fn len(&self) -> usize {
        self.values.len() / self.view_len
    }

    /// Whether there is no view.
    pub fn is_empty(&self) -> bool {
        self.values.is_empty()
    }

    /// All values, view after view.
    pub fn values(&self) -> &[f32] {
        &self.values
    }
}

impl ViewLayout {
    /// The layout of a camera with these optics, restricted to `window`.
    pub fn new(optics: &Optics, window: MicrolensWindow) -> Self {
        Self::with_edge(optics, window, ApertureEdge::sharp(optics))
    }

    /// As [`Self::new`], with another treatment of the aperture's edge. If no view is fully open,
    /// partly open ones are always kept.
    pub fn with_edge(optics: &Optics, window: MicrolensWindow, edge: ApertureEdge) -> Self {
        let columns = AxisSampling::columns(optics);
        let rows = AxisSampling::rows(optics);
        let radius_mm = optics.pupil_diameter_mm() / 2.0;
        let aperture = Aperture { radius_mm, interval_mm: edge.interval_mm };
        let mut views: Vec<View> = (-columns.reach..=columns.reach)
            .into_par_iter()
            .flat_map_iter(|k| {
                let strips = aperture.strips(&columns, &window, k);
                let (aperture, rows, window) = (&aperture, &rows, &window);
                (-rows.reach..=rows.reach).filter_map(move |l| {
                    let coverage = aperture.coverage(&strips, rows, window, l)?;
                    bright_enough(k, l, coverage)
                })
            })
            .collect();
        views.sort_by_key(|view| (view.l, view.k));
        drop_cut_views(&mut views, edge);
        Self { columns, rows, grid: None, window, views }
    }

    /// The layout of a camera with the micro-image grid `grid`.
    pub fn on_grid(
        optics: &Optics,
        window: MicrolensWindow,
        edge: ApertureEdge,
        grid: GridSampling,
    ) -> Self {
        let radius_mm = optics.pupil_diameter_mm() / 2.0;
        let aperture = Aperture { radius_mm, interval_mm: edge.interval_mm };
        let indices = -grid.reach..=grid.reach;
        let mut views: Vec<View> = indices
            .clone()
            .into_par_iter()
            .flat_map_iter(|l| {
                let (aperture, window, grid) = (&aperture, &window, &grid);
                indices.clone().filter_map(move |k| {
                    let coverage = aperture.coverage_on_grid((k, l), grid, window)?;
                    bright_enough(k, l, coverage)
                })
            })
            .collect();
        views.sort_by_key(|view| (view.l, view.k));
        drop_cut_views(&mut views, edge);
        let (columns, rows) = (AxisSampling::columns(optics), AxisSampling::rows(optics));
        Self { columns, rows, grid: Some(Arc::new(grid)), window, views }
    }

    /// Decodes a raw image into views, in counts above its black level and uniform background.
    pub fn decode_above_black(&self, image: &RawImage, levels: &LightLevels) -> ViewStack {
        let black = (levels.offset_counts + levels.background_counts) as f32;
        self.decode(image, |_, _, count| f32::from(count) - black)
    }

    /// Decodes a raw image into views. Each count becomes `map(column, row, count)`, in counts
    /// above the black level; microlenses without a pixel for a view get 0.
    pub fn decode(&self, image: &RawImage, map: impl Fn(usize, usize, u16) -> f32) -> ViewStack {
        if let Some(grid) = &self.grid {
            return self.decode_on_grid(grid, image, map);
        }
        let view_len = self.window.len();
        let width = self.window.columns.len();
        let mut values = vec![0.0; view_len * self.views.len()];
        for (index, view) in self.views.iter().enumerate() {
            let columns: Vec<Option<u32>> = self
                .window
                .columns
                .clone()
                .map(|i| self.columns.sample(view.k, i).map(|s| s.pixel))
                .collect();
            let target = &mut values[index * view_len..(index + 1) * view_len];
            for (j, line) in self.window.rows.clone().zip(target.chunks_exact_mut(width)) {
                let Some(row) = self.rows.sample(view.l, j).map(|s| s.pixel as usize) else {
                    continue;
                };
                let counts = image.row(row);
                for (value, column) in line.iter_mut().zip(&columns) {
                    if let Some(c) = column {
                        *value = map(*c as usize, row, counts[*c as usize]);
                    }
                }
            }
        }
        ViewStack { view_len, values }
    }

    /// As [`Self::decode`], for an arbitrarily oriented array.
    fn decode_on_grid(
        &self,
        grid: &GridSampling,
        image: &RawImage,
        map: impl Fn(usize, usize, u16) -> f32,
    ) -> ViewStack {
        let MicrolensWindow { columns, rows } = &self.window;
        let lenses = rows.clone().flat_map(|j| columns.clone().map(move |i| (i, j)));
        let nearest: Vec<_> = lenses.map(|(i, j)| grid.nearest_pixel(i, j)).collect();
        let mut values = Vec::with_capacity(self.window.len() * self.views.len());
        for view in &self.views {
            let pixel = grid.pixels((view.k, view.l));
            values.extend(nearest.iter().map(|nearest| match pixel(nearest) {
                Some([column, row]) => map(column, row, image.row(row)[column]),
                None => 0.0,
            }));
        }
        ViewStack { view_len: self.window.len(), values }
    }
}

/// The view, if its mean coverage is sufficient.
fn bright_enough(k: i32, l: i32, coverage: Vec<f32>) -> Option<View> {
    let sum: f64 = coverage.iter().map(|&c| f64::from(c)).sum();
    let open = coverage.iter().all(|&c| c == 1.0);
    (sum >= MIN_MEAN_COVERAGE * coverage.len() as f64).then(|| View {
        k,
        l,
        coverage: (!open).then(|| coverage.into()),
    })
}

/// Drops partly open views if `edge` excludes them and fully open ones exist.
fn drop_cut_views(views: &mut Vec<View>, edge: ApertureEdge) {
    if !edge.partly_open_views && views.iter().any(|view| !view.is_cut()) {
        views.retain(|view| !view.is_cut());
    }
}

/// The round aperture of the main lens.
pub struct Aperture {
    /// Radius, in mm.
    pub radius_mm: f64,
    /// Width of the pupil interval that contributes to a pixel, in mm.
    pub interval_mm: f64,
}

impl Aperture {
    /// The strip of the aperture of each microlens column of the window, for views (k, ·). `None` if a column
    /// has no pixel for them.
    fn strips(
        &self,
        columns: &AxisSampling,
        window: &MicrolensWindow,
        k: i32,
    ) -> Vec<Option<Strip>> {
        let strip = |i| columns.sample(k, i).map(|sample| self.strip(sample.pupil_mm));
        window.columns.clone().map(strip).collect()
    }

    /// Coverage of view (k, l) over the window, row-major, from the strips of views (k, ·). `None` if the view is
    /// completely closed.
    fn coverage(
        &self,
        strips: &[Option<Strip>],
        rows: &AxisSampling,
        window: &MicrolensWindow,
        l: i32,
    ) -> Option<Vec<f32>> {
        let longest = strips.iter().flatten().map(|strip| strip.longest).fold(-1.0, f64::max);
        let nearest = window.rows.clone().filter_map(|j| rows.sample(l, j));
        let nearest = nearest.map(|row| row.pupil_mm.abs()).fold(f64::INFINITY, f64::min);
        if nearest - self.interval_mm / 2.0 >= longest {
            return None;
        }
        let mut coverage = Vec::with_capacity(window.len());
        for j in window.rows.clone() {
            let row = rows.sample(l, j);
            coverage.extend(strips.iter().map(|strip| match (strip, row) {
                (Some(strip), Some(row)) => strip.covered(row.pupil_mm, self.interval_mm) as f32,
                _ => 0.0,
            }));
        }
        Some(coverage)
    }

    /// Coverage of view (k, l) over the window, row-major. `None` if the view is completely closed.
    fn coverage_on_grid(
        &self,
        (k, l): (i32, i32),
        grid: &GridSampling,
        window: &MicrolensWindow,
    ) -> Option<Vec<f32>> {
        // A phase is at most half a cell.
        let nearest = |n: i32| ((f64::from(n.abs()) - 0.5) * grid.cell_mm).max(0.0);
        let half_mm = self.interval_mm / 2.0;
        let near = [k, l].map(|n| (nearest(n) - half_mm).max(0.0));
        if near[0].hypot(near[1]) >= self.radius_mm {
            return None;
        }
        let lenses = window.rows.clone().flat_map(|j| window.columns.clone().map(move |i| (i, j)));
        let covered = |(i, j)| match grid.pixel((k, l), i, j) {
            Some(_) => self.covered(grid.pupil_mm((k, l), i, j)) as f32,
            None => 0.0,
        };
        Some(lenses.map(covered).collect())
    }

    /// Share of the pupil interval around a point that is inside the aperture.
    pub fn covered(&self, [u, v]: [f64; 2]) -> f64 {
        let half_mm = self.interval_mm / 2.0;
        let square = |u: f64, v: f64| u * u + v * v;
        let radius_square = self.radius_mm * self.radius_mm;
        // Fast path: nearly all cells are completely inside or outside.
        if square(u.abs() + half_mm, v.abs() + half_mm) <= radius_square {
            return 1.0;
        }
        let near = [u, v].map(|centre| (centre.abs() - half_mm).max(0.0));
        if square(near[0], near[1]) >= radius_square {
            return 0.0;
        }
        self.strip(u).covered(v, self.interval_mm)
    }

    /// The part of the aperture in a column of pupil intervals.
    fn strip(&self, centre_mm: f64) -> Strip {
        let cell_mm = self.interval_mm;
        let (near, far) = (centre_mm.abs() - cell_mm / 2.0, centre_mm.abs() + cell_mm / 2.0);
        Strip {
            shortest: self.half_chord(far),
            longest: self.half_chord(near.max(0.0)),
            chords: std::array::from_fn(|n| {
                self.half_chord(centre_mm + ((n as f64 + 0.5) / CHORDS as f64 - 0.5) * cell_mm)
            }),
        }
    }

    /// Half length of the aperture's chord at U, in mm; negative outside the aperture.
    fn half_chord(&self, u: f64) -> f64 {
        let square = self.radius_mm * self.radius_mm - u * u;
        if square > 0.0 { square.sqrt() } else { -1.0 }
    }
}

/// Half lengths of the aperture's chords across a column of pupil intervals, in mm; negative outside the aperture.
struct Strip {
    /// At evenly spaced U inside the column.
    chords: [f64; CHORDS],
    /// Extremes over the column.
    shortest: f64,
    longest: f64,
}

impl Strip {
    /// Share of the pupil interval around `centre_mm` that is inside the aperture.
    fn covered(&self, centre_mm: f64, cell_mm: f64) -> f64 {
        let (low, high) = (centre_mm - cell_mm / 2.0, centre_mm + cell_mm / 2.0);
        // Fast path: nearly all cells are completely inside or outside.
        if high <= self.shortest && -low <= self.shortest {
            return 1.0;
        }
        if low >= self.longest || -high >= self.longest {
            return 0.0;
        }
        // Several partial sums, because each addition would otherwise wait for the previous one.
        let mut lengths = [0.0f64; SUMS];
        for halves in self.chords.chunks_exact(SUMS) {
            for (length, &half) in lengths.iter_mut().zip(halves) {
                *length += (high.min(half) - low.max(-half)).max(0.0);
            }
        }
        lengths.iter().sum::<f64>() / (cell_mm * CHORDS as f64)
    }
}

#[cfg(test)]
mod tests;
