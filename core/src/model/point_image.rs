//! The image of a point of light in views, and its derivatives with respect to the point's position.
//!
//! The footprint is that of the tables, for any position instead of a table's nodes: the product of a share
//! along the columns, a share along the rows, and the open share of the pupil cell ([`super::footprint`]).

use std::ops::{Range, RangeInclusive};

use lfpiv_hw::{CameraPoint, Optics, Pose};

use super::{
    ModelError, ModelParts, VolumeGrid,
    camera::CameraView,
    footprint::RayMap,
    tables::{AxisGeometry, Shadow},
};
use crate::lightfield::{View, ViewLayout};

/// Number of evaluated microlenses along one axis.
const REACH: usize = 6;

/// Step of the central differences, as a share of the microlens pitch.
const DIFFERENCE_PITCHES: f64 = 0.1;

/// Imaging of points by one camera.
pub struct PointImager<'a> {
    optics: &'a Optics,
    layout: &'a ViewLayout,
    axes: [AxisGeometry<'a>; 2],
    /// Ranges of the view indices k and l.
    pupil: [RangeInclusive<i32>; 2],
}

/// The image of one point in all views.
///
/// Shares along the columns depend only on the view index k, and those along the rows only on l. They are computed
/// once for each k and l, not for each view.
pub struct PointImage<'a> {
    layout: &'a ViewLayout,
    shares: [Vec<Shares>; 2],
    first: [i32; 2],
}

/// A pixel of a view with light of a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LitPixel {
    /// Position in the view, row-major over the microlens window.
    pub at: usize,
    /// Share of the point's light.
    pub weight: f64,
    /// Derivatives of the weight with respect to the camera coordinates ξ, η and depth, per mm.
    pub gradient: [f64; 3],
}

/// Shares on consecutive microlenses, and their derivatives with respect to lateral position and depth.
struct Shares {
    first: i64,
    value: [f64; REACH],
    by_lateral: [f64; REACH],
    by_depth: [f64; REACH],
}

impl<'a> PointImager<'a> {
    /// The imaging by camera `camera`, from 0, of sources of edge `footprint_mm` in the volume of `grid`.
    ///
    /// # Errors
    /// The volume is not in the camera's field, or it extends to its lens.
    pub fn new(
        optics: &'a Optics,
        pose: &Pose,
        camera: usize,
        grid: &VolumeGrid,
        layout: &'a ViewLayout,
        footprint_mm: f64,
        parts: &ModelParts,
    ) -> Result<Self, ModelError> {
        let view = CameraView::new(optics, pose, grid, camera)?;
        let axes = view.geometries(optics, &layout.columns, &layout.rows, footprint_mm, parts);
        let range = |cell: fn(&View) -> i32| {
            let cells = || layout.views.iter().map(cell);
            cells().min().unwrap_or(0)..=cells().max().unwrap_or(0)
        };
        Ok(Self { optics, layout, axes, pupil: [range(|view| view.k), range(|view| view.l)] })
    }

    /// The image of a point at `point`.
    pub fn image(&self, point: &CameraPoint) -> PointImage<'a> {
        let lateral_mm = [point.xi_mm, point.eta_mm];
        let step = self.step_mm();
        let maps = [-step, 0.0, step]
            .map(|further| RayMap::at_depth(self.optics, point.depth_mm + further));
        let shares = |axis: usize| {
            let cells = self.pupil[axis].clone();
            cells.map(|k| self.shares(axis, k, lateral_mm[axis], maps)).collect()
        };
        PointImage {
            layout: self.layout,
            shares: [shares(0), shares(1)],
            first: self.pupil.each_ref().map(|cells| *cells.start()),
        }
    }

    /// Step of the central differences, in mm.
    fn step_mm(&self) -> f64 {
        DIFFERENCE_PITCHES * self.optics.microlens.pitch_mm
    }

    /// The shares in view `k` of a point at `lateral_mm`, from the ray maps a step behind its depth, at its
    /// depth and a step before it.
    fn shares(
        &self,
        axis: usize,
        k: i32,
        lateral_mm: f64,
        [behind, map, before]: [RayMap; 3],
    ) -> Shares {
        let geometry = &self.axes[axis];
        let step = self.step_mm();
        let shadow = geometry.shadow_of(map, k, lateral_mm);
        let first = geometry.first_reached(&shadow) - 1;
        let shares = |shadow: &Shadow| -> [f64; REACH] {
            std::array::from_fn(|n| match usize::try_from(first + n as i64) {
                Ok(microlens) => geometry.share(shadow, microlens),
                Err(_) => 0.0,
            })
        };
        let slope = |low: Shadow, high: Shadow| {
            let (low, high) = (shares(&low), shares(&high));
            std::array::from_fn(|n| (high[n] - low[n]) / (2.0 * step))
        };
        let shadow_of = |map, lateral_mm| geometry.shadow_of(map, k, lateral_mm);
        Shares {
            first,
            value: shares(&shadow),
            by_lateral: slope(shadow_of(map, lateral_mm - step), shadow_of(map, lateral_mm + step)),
            by_depth: slope(shadow_of(behind, lateral_mm), shadow_of(before, lateral_mm)),
        }
    }
}

impl PointImage<'_> {
    /// Calls `visit` with every lit pixel of view number `view`.
    pub fn pixels(&self, view: usize, mut visit: impl FnMut(LitPixel)) {
        let seen = &self.layout.views[view];
        let columns = &self.shares[0][(seen.k - self.first[0]) as usize];
        let rows = &self.shares[1][(seen.l - self.first[1]) as usize];
        let window = &self.layout.window;
        for (j, row) in rows.reached(&window.rows) {
            for (i, column) in columns.reached(&window.columns) {
                let at = row * window.columns.len() + column;
                let open = seen.coverage.as_ref().map_or(1.0, |coverage| f64::from(coverage[at]));
                let gradient = [
                    columns.by_lateral[i] * rows.value[j],
                    columns.value[i] * rows.by_lateral[j],
                    columns.by_depth[i] * rows.value[j] + columns.value[i] * rows.by_depth[j],
                ];
                let weight = columns.value[i] * rows.value[j];
                if weight != 0.0 || gradient != [0.0; 3] {
                    let gradient = gradient.map(|slope| slope * open);
                    visit(LitPixel { at, weight: weight * open, gradient });
                }
            }
        }
    }
}

impl Shares {
    /// The microlenses of the shares that are in `window`: index of the share, and index in the window.
    fn reached(&self, window: &Range<usize>) -> impl Iterator<Item = (usize, usize)> {
        let start = self.first - window.start as i64;
        let len = window.len() as i64;
        (0..REACH)
            .map(move |n| (n, start + n as i64))
            .filter(move |&(n, at)| self.is_lit(n) && (0..len).contains(&at))
            .map(|(n, at)| (n, at as usize))
    }

    fn is_lit(&self, n: usize) -> bool {
        self.value[n] != 0.0 || self.by_lateral[n] != 0.0 || self.by_depth[n] != 0.0
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::Point3;

    use super::*;
    use crate::{
        model::{ViewId, thin_lens_model},
        test_bench,
    };

    fn grid() -> VolumeGrid {
        VolumeGrid { voxels: [5, 5, 5], voxel_mm: 0.1, centre_mm: [2.0, -1.5, 2.5] }
    }

    fn image(imager: &PointImager<'_>, view: usize, point: &CameraPoint) -> Vec<LitPixel> {
        let mut pixels = Vec::new();
        imager.image(point).pixels(view, |pixel| pixels.push(pixel));
        pixels
    }

    #[test]
    fn a_source_as_large_as_a_voxel_has_the_image_that_the_tables_give_the_voxel() {
        let (optics, poses, grid) = (test_bench::optics(), test_bench::poses(), grid());
        let model = thin_lens_model(&optics, &poses, &grid, grid.voxel_mm).unwrap();
        let voxel = [3, 1, 2];
        let projector = model.projector(&[grid.linear(voxel) as u32]);
        for (camera, pose) in poses.iter().enumerate() {
            let layout = &model.layouts()[camera];
            let parts = ModelParts::default();
            let imager =
                PointImager::new(&optics, pose, camera, &grid, layout, grid.voxel_mm, &parts);
            let point = pose.to_camera(&grid.centre_of(voxel));
            for view in (0..layout.views.len()).step_by(7) {
                let mut of_tables = vec![0.0; layout.window.len()];
                projector.project(ViewId { camera, view }, &[1.0], &mut of_tables);
                let mut of_point = vec![0.0; layout.window.len()];
                for pixel in image(imager.as_ref().unwrap(), view, &point) {
                    of_point[pixel.at] = pixel.weight as f32;
                }
                for (table, point) in of_tables.iter().zip(&of_point) {
                    // The tables share a depth node between neighbouring voxels.
                    assert!((table - point).abs() < 0.02, "{camera} {view}: {table} {point}");
                }
            }
        }
    }

    #[test]
    fn a_small_step_changes_the_image_by_its_gradient() {
        let (optics, poses, grid) = (test_bench::optics(), test_bench::poses(), grid());
        let model = thin_lens_model(&optics, &poses, &grid, 0.05).unwrap();
        let layout = &model.layouts()[0];
        let parts = ModelParts::default();
        let imager = PointImager::new(&optics, &poses[0], 0, &grid, layout, 0.05, &parts).unwrap();
        let place = poses[0].to_camera(&Point3::new(2.013, -1.47, 2.52));
        for view in (0..layout.views.len()).step_by(11) {
            let gradients = image(&imager, view, &place);
            let step = DIFFERENCE_PITCHES * optics.microlens.pitch_mm;
            let weight = |point: &CameraPoint, at: usize| -> f64 {
                image(&imager, view, point).iter().find(|p| p.at == at).map_or(0.0, |p| p.weight)
            };
            for pixel in gradients {
                let [high, low] = [step, -step].map(|step| {
                    weight(&CameraPoint { xi_mm: place.xi_mm + step, ..place }, pixel.at)
                });
                let expected = (high - low) / (2.0 * step);
                assert!((pixel.gradient[0] - expected).abs() < 1e-9, "{pixel:?} {expected}");
            }
        }
    }
}
