//! The separable thin-lens model: tables per axis instead of a stored matrix.

mod projector;

use lfpiv_hw::{CameraName, Optics, Pose};

use super::{
    ForwardModel, ModelError, ModelParts, Projector, ViewId, VolumeGrid,
    camera::CameraView,
    tables::AxisTable,
    weights::{Weight, WeightSource},
};
use crate::lightfield::{AxisSampling, ViewLayout};
use projector::ThinLensProjector;

/// Largest width of compiled tables, in microlenses.
const MOST_TAPS: usize = 5;

/// Largest accepted share of a voxel's light outside of its taps, in any view.
const MOST_LOST_SHARE: f64 = 0.005;

/// Builds the thin-lens model of a bench with the narrowest sufficient tables.
///
/// `footprint_mm` is the edge of the light source of a voxel: the voxel's edge for a uniform voxel, 0 for a
/// point at its centre.
///
/// # Errors
/// `footprint_mm` is negative or not finite, the volume is not in the field of a camera or extends to its lens, or
/// footprints are too wide for the tables.
pub fn thin_lens_model(
    optics: &Optics,
    poses: &[Pose],
    grid: &VolumeGrid,
    footprint_mm: f64,
) -> Result<Box<dyn ForwardModel>, ModelError> {
    thin_lens_model_of(optics, poses, grid, footprint_mm, &ModelParts::default())
}

/// [`thin_lens_model`] with these parts instead of the default ones.
pub fn thin_lens_model_of(
    optics: &Optics,
    poses: &[Pose],
    grid: &VolumeGrid,
    footprint_mm: f64,
    parts: &ModelParts,
) -> Result<Box<dyn ForwardModel>, ModelError> {
    Ok(tabulated(optics, poses, grid, footprint_mm, parts)?)
}

/// A model by tables that also gives single weights.
pub(super) trait Tabulated: ForwardModel + WeightSource {}

impl<const W: usize> Tabulated for ThinLensModel<W> {}

/// As [`thin_lens_model_of`], with access to single weights.
pub(super) fn tabulated(
    optics: &Optics,
    poses: &[Pose],
    grid: &VolumeGrid,
    footprint_mm: f64,
    parts: &ModelParts,
) -> Result<Box<dyn Tabulated>, ModelError> {
    let views = camera_views(optics, poses, grid, footprint_mm)?;
    Ok(match taps_needed(optics, &views, footprint_mm, parts)? {
        ..=2 => Box::new(ThinLensModel::<2>::new(optics, views, grid, footprint_mm, parts)),
        3 => Box::new(ThinLensModel::<3>::new(optics, views, grid, footprint_mm, parts)),
        _ => Box::new(ThinLensModel::<MOST_TAPS>::new(optics, views, grid, footprint_mm, parts)),
    })
}

/// The views of all cameras. Errors as for [`thin_lens_model`].
pub(super) fn camera_views(
    optics: &Optics,
    poses: &[Pose],
    grid: &VolumeGrid,
    footprint_mm: f64,
) -> Result<Vec<CameraView>, ModelError> {
    if !(footprint_mm.is_finite() && footprint_mm >= 0.0) {
        return Err(ModelError::FootprintOutOfRange { footprint_mm });
    }
    let view = |(camera, pose)| CameraView::new(optics, pose, grid, camera);
    poses.iter().enumerate().map(view).collect()
}

/// Least number of taps per axis for [`MOST_LOST_SHARE`].
fn taps_needed(
    optics: &Optics,
    views: &[CameraView],
    footprint_mm: f64,
    parts: &ModelParts,
) -> Result<usize, ModelError> {
    let columns = AxisSampling::columns(optics);
    let rows = AxisSampling::rows(optics);
    let mut needed = 2;
    for (camera, view) in views.iter().enumerate() {
        for axis in view.geometries(optics, &columns, &rows, footprint_mm, parts) {
            let fits = |&taps: &usize| axis.most_lost(taps).0 <= MOST_LOST_SHARE;
            let taps =
                (needed..=MOST_TAPS).find(fits).ok_or_else(|| ModelError::FootprintTooWide {
                    camera: CameraName(camera),
                    footprint_mm,
                    pitches: axis.most_lost(MOST_TAPS).1,
                    most: MOST_TAPS - 1,
                })?;
            needed = needed.max(taps);
        }
    }
    Ok(needed)
}

/// The separable footprint of every voxel in every view, from tables with `W` taps per axis.
#[derive(Debug)]
pub struct ThinLensModel<const W: usize> {
    grid: VolumeGrid,
    layouts: Vec<ViewLayout>,
    cameras: Vec<CameraTables<W>>,
}

#[derive(Debug)]
struct CameraTables<const W: usize> {
    view: CameraView,
    columns: AxisTable<W>,
    rows: AxisTable<W>,
    /// Length of a row of a projected image, with space for every tap.
    width: usize,
}

impl<const W: usize> ThinLensModel<W> {
    fn new(
        optics: &Optics,
        views: Vec<CameraView>,
        grid: &VolumeGrid,
        footprint_mm: f64,
        parts: &ModelParts,
    ) -> Self {
        let layouts: Vec<_> = views.iter().map(|view| parts.layout(optics, &view.window)).collect();
        let cameras = views
            .into_iter()
            .zip(&layouts)
            .map(|(view, layout)| {
                let [columns, rows] =
                    view.geometries(optics, &layout.columns, &layout.rows, footprint_mm, parts);
                let (columns, rows) =
                    rayon::join(|| AxisTable::new(&columns), || AxisTable::new(&rows));
                let width = view.window.columns.len();
                CameraTables { view, columns, rows, width }
            })
            .collect();
        Self { grid: grid.clone(), layouts, cameras }
    }
}

impl<const W: usize> ForwardModel for ThinLensModel<W> {
    fn grid(&self) -> &VolumeGrid {
        &self.grid
    }

    fn layouts(&self) -> &[ViewLayout] {
        &self.layouts
    }

    fn projector(&self, voxels: &[u32]) -> Box<dyn Projector + '_> {
        let places = self
            .cameras
            .iter()
            .map(|camera| {
                voxels.iter().map(|&voxel| camera.place(self.grid.indices(voxel))).collect()
            })
            .collect();
        Box::new(ThinLensProjector { model: self, places })
    }

    fn memory_bytes(&self) -> usize {
        let tables: usize =
            self.cameras.iter().map(|c| c.columns.memory_bytes() + c.rows.memory_bytes()).sum();
        tables + self.layouts.iter().map(coverage_bytes).sum::<usize>()
    }
}

/// Indices of a voxel's taps in a camera's two tables.
#[derive(Debug, Clone, Copy)]
struct Place {
    column: u32,
    row: u32,
}

impl<const W: usize> CameraTables<W> {
    fn place(&self, ijk: [usize; 3]) -> Place {
        let depth = self.view.depth.node_of(ijk);
        Place {
            column: (depth * self.columns.positions() + self.view.xi.node_of(ijk)) as u32,
            row: (depth * self.rows.positions() + self.view.eta.node_of(ijk)) as u32,
        }
    }
}

/// Bytes of a layout's coverage.
pub(super) fn coverage_bytes(layout: &ViewLayout) -> usize {
    layout.views.iter().filter_map(|view| view.coverage.as_deref()).map(size_of_val).sum()
}

impl<const W: usize> WeightSource for ThinLensModel<W> {
    fn grid(&self) -> &VolumeGrid {
        &self.grid
    }

    fn layouts(&self) -> &[ViewLayout] {
        &self.layouts
    }

    fn weights(&self, view: ViewId, voxel: u32, out: &mut Vec<Weight>) {
        let camera = &self.cameras[view.camera];
        let place = camera.place(self.grid.indices(voxel));
        let window = &camera.view.window;
        let view = &self.layouts[view.camera].views[view.view];
        let column = &camera.columns.of_view(view.k)[place.column as usize];
        let row = &camera.rows.of_view(view.l)[place.row as usize];
        let lines = (row.first as usize..window.rows.len()).zip(row.weights).enumerate();
        for (m, (j, row_share)) in lines {
            let pixels = column.first as usize..window.columns.len();
            for (n, (i, share)) in pixels.zip(column.weights).enumerate() {
                if row_share * share > 0.0 {
                    let pixel = j * camera.width + i;
                    let open = view.coverage.as_ref().map_or(1.0, |coverage| coverage[pixel]);
                    out.push(Weight {
                        pixel: pixel as u32,
                        weight: row_share * share * open,
                        support: row.supports(m) && column.supports(n),
                    });
                }
            }
        }
    }

    fn memory_bytes(&self) -> usize {
        ForwardModel::memory_bytes(self)
    }
}
