//! Blocks for cameras along an axis of the grid.

use std::sync::Arc;

use lfpiv_hw::{Optics, Pose};

use super::{
    BlockModel, BlockProjector, HullCriteria, LitBlocks,
    aligned_tables::{AlignedCamera, AlignedModel, Axes},
    axis_table::PairTable,
    block_indices, lit,
    projector::AlignedProjector,
};
use crate::{
    lightfield::{ViewLayout, ViewStack},
    model::{
        ModelError, ModelParts, VolumeGrid,
        camera::CameraView,
        footprint::RayMap,
        tables::AxisGeometry,
        thin_lens::{camera_views, coverage_bytes},
    },
};

/// Number of tabulated depths per block.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum DepthsPerBlock {
    /// The depth of the block's centre for all voxels, if half a voxel of depth displaces shadows by less than
    /// [`SHARED_DEPTH_TOLERANCE`].
    One,
    /// One per layer of voxels.
    Two,
}

/// Largest displacement of a shadow at the pupil's edge by sharing a depth, relative to the
/// source's edge.
const SHARED_DEPTH_TOLERANCE: f64 = 1.0 / 16.0;

impl DepthsPerBlock {
    /// The depths needed for sources of edge `footprint_mm`. Points need separate depths, because they have no
    /// width: on voxels of 0.1 mm a shared depth reduced Q from 0.85 to 0.75 (particles on voxel centres, 1
    /// ppm).
    pub fn needed(optics: &Optics, grid: &VolumeGrid, footprint_mm: f64) -> Self {
        let s = optics.object_distance_mm;
        // da/ds R (docs/theory.md, section 4), converted to object space by 1/|b| = s/s_i.
        let per_depth = optics.pupil_diameter_mm() / 2.0 / s;
        let shift_mm = grid.voxel_mm / 2.0 * per_depth;
        if shift_mm <= SHARED_DEPTH_TOLERANCE * footprint_mm { Self::One } else { Self::Two }
    }
}

/// The views of all cameras, if they are along the grid's axes. Errors as for [`super::block_model`].
pub(super) fn aligned_views(
    optics: &Optics,
    poses: &[Pose],
    grid: &VolumeGrid,
    footprint_mm: f64,
) -> Result<Option<Vec<CameraView>>, ModelError> {
    let views = camera_views(optics, poses, grid, footprint_mm)?;
    let aligned = views.iter().all(|view| Axes::of(view).is_some());
    Ok(aligned.then_some(views))
}

impl<const L: usize, const D: usize> AlignedModel<L, D> {
    /// `None` if pairs of voxels reach more than `L` microlenses, if voxels are too small for the
    /// hull's bits, or if a camera is not aligned.
    pub fn new(
        optics: &Optics,
        views: &[CameraView],
        layouts: Vec<ViewLayout>,
        grid: &VolumeGrid,
        footprint_mm: f64,
        parts: &ModelParts,
    ) -> Option<Self> {
        if voxels_per_microlens(optics, grid) > lit::MAX_VOXELS_PER_MICROLENS {
            return None;
        }
        let mut cameras = Vec::with_capacity(views.len());
        let mut tables = SharedTables::default();
        for (view, layout) in views.iter().zip(&layouts) {
            let axes = Axes::of(view)?;
            let mut axis_geometries =
                view.geometries(optics, &layout.columns, &layout.rows, footprint_mm, parts);
            for geometry in &mut axis_geometries {
                geometry.depths = view.depth.layer_nodes(axes.depth, grid.voxels[axes.depth], D);
            }
            let [columns, rows] = axis_geometries;
            let (columns, rows) = (tables.of(columns)?, tables.of(rows)?);
            cameras.push(AlignedCamera { axes, columns, rows, width: view.window.columns.len() });
        }
        drop(tables);
        Some(Self { grid: grid.clone(), layouts, cameras })
    }
}

/// Tables by geometry: two cameras at right angles often have the same table along their common axis.
#[derive(Default)]
struct SharedTables<'a, const L: usize>(Vec<(AxisGeometry<'a>, Arc<PairTable<L>>)>);

impl<'a, const L: usize> SharedTables<'a, L> {
    /// The table of a geometry; `None` as in [`PairTable::new`].
    fn of(&mut self, geometry: AxisGeometry<'a>) -> Option<Arc<PairTable<L>>> {
        if let Some((_, table)) = self.0.iter().find(|(known, _)| *known == geometry) {
            return Some(table.clone());
        }
        let table = Arc::new(PairTable::new(&geometry)?);
        self.0.push((geometry, table.clone()));
        Some(table)
    }
}

/// Number of voxels per microlens, in focus.
fn voxels_per_microlens(optics: &Optics, grid: &VolumeGrid) -> f64 {
    let magnification = RayMap::at_depth(optics, 0.0).position.abs();
    optics.microlens.pitch_mm / (magnification * grid.voxel_mm)
}

impl<const L: usize, const D: usize> BlockModel for AlignedModel<L, D> {
    fn grid(&self) -> &VolumeGrid {
        &self.grid
    }

    fn layouts(&self) -> &[ViewLayout] {
        &self.layouts
    }

    fn projector(&self, blocks: &[u32]) -> Box<dyn BlockProjector + '_> {
        let places = |camera: &AlignedCamera<L>| {
            blocks.iter().map(|&block| camera.place(block_indices(&self.grid, block), D)).collect()
        };
        Box::new(AlignedProjector {
            model: self,
            places: self.cameras.iter().map(places).collect(),
        })
    }

    fn lit(&self, views: &[ViewStack], criteria: &HullCriteria) -> LitBlocks {
        lit::lit_blocks(self, views, criteria)
    }

    fn image_len(&self, camera: usize) -> usize {
        self.layouts[camera].window.len() + L
    }

    fn memory_bytes(&self) -> usize {
        let mut tables: Vec<&Arc<PairTable<L>>> = Vec::new();
        for table in self.cameras.iter().flat_map(|camera| [&camera.columns, &camera.rows]) {
            if !tables.iter().any(|known| Arc::ptr_eq(known, table)) {
                tables.push(table);
            }
        }
        let tables: usize = tables.iter().map(|table| table.memory_bytes()).sum();
        tables + self.layouts.iter().map(coverage_bytes).sum::<usize>()
    }
}
