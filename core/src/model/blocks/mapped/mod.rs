//! Blocks for arbitrarily oriented cameras with any smooth optics.
//!
//! [`super::AlignedModel`] addresses a block's taps by index, because every row of blocks is along a row of
//! microlenses. Here each block's position relative to the microlenses is stored (two multiply-adds convert it
//! to that in a view), and tables contain the footprint by depth, position between microlenses and phase
//! ([`share_table`]). Only the addressing differs; the kernels are the same.

mod arrangement;
mod lens_phases;
mod lens_row;
mod lit;
mod lit_bits;
mod places;
mod projector;
mod rounding;
mod share_table;
mod support;
#[cfg(test)]
mod tests;
mod tile;
mod tile_place;
mod tile_view;

use lfpiv_hw::{CameraName, Optics, Pose};
use nalgebra::Point3;

use super::{
    BlockModel, BlockProjector, HullCriteria, LitBlocks, aligned_tables::Axes, block_indices,
};
use crate::{
    lightfield::{View, ViewLayout, ViewStack},
    model::{
        CameraCalibration, ModelError, ModelParts, VolumeGrid,
        footprint::RayMap,
        mapped_optics::{MappedOptics, ProjectedPoint},
        tables::Nodes,
        thin_lens::coverage_bytes,
    },
};
use arrangement::{Arrangement, Layers};
use places::{AxisAddresses, BlockPlaces, ViewAddresses};
use projector::MappedProjector;
use share_table::{FootprintGeometry, ShareTable, TableLayout};
use support::Support;

/// Largest change of a shadow's width between depth nodes, in microlenses.
const DEPTH_TOLERANCE: f64 = 1.0 / 64.0;

/// The footprint of every block in every view, from tables of up to `L` microlenses per pair of
/// voxels and axis.
#[derive(Debug)]
pub(super) struct MappedModel<const L: usize> {
    grid: VolumeGrid,
    layouts: Vec<ViewLayout>,
    cameras: Vec<MappedCamera<L>>,
}

/// One camera's tables, and the orientation of its array relative to the grid.
#[derive(Debug)]
pub(super) struct MappedCamera<const L: usize> {
    optics: MappedOptics,
    axes: Axes,
    layers: Layers,
    geometries: [FootprintGeometry; 2],
    tables: CameraTables<L>,
}

/// A camera's tables along columns and rows.
#[derive(Debug)]
enum CameraTables<const L: usize> {
    /// Tables of pairs of voxels.
    Pairs([ShareTable<L, 2>; 2]),
    /// Tables of two pairs, one for each of a block's depths.
    Quads([ShareTable<L, 4>; 2]),
}

/// The model with the narrowest sufficient tables; `None` if no table is wide enough.
///
/// # Errors
/// The grid is not in the field of a camera or extends to its lens, or an array is not square.
pub(super) fn mapped_model(
    optics: &Optics,
    poses: &[Pose],
    calibrations: &[CameraCalibration],
    grid: &VolumeGrid,
    footprint_mm: f64,
    parts: &ModelParts,
    known: &[ViewLayout],
) -> Result<Option<Box<dyn BlockModel>>, ModelError> {
    let setup = Setup::new(optics, poses, calibrations, grid, footprint_mm, parts, known)?;
    Ok(setup.narrowest())
}

/// Layouts of the cameras' images; reuses the `known` layouts of another model of the same cameras
/// if the windows are the same.
fn layouts(mapped: &[MappedOptics], parts: &ModelParts, known: &[ViewLayout]) -> Vec<ViewLayout> {
    let mut layouts: Vec<ViewLayout> = Vec::with_capacity(mapped.len());
    for optics in mapped {
        let same = |layout: &&ViewLayout| {
            layout.window == optics.window && layout.grid.as_ref() == Some(&optics.sampling)
        };
        let layout = match known.iter().chain(&layouts).find(same) {
            Some(layout) => layout.clone(),
            None => parts.layout_on_grid(&optics.optics, &optics.window, &optics.sampling),
        };
        layouts.push(layout);
    }
    layouts
}

/// Inputs of a model.
struct Setup<'a> {
    mapped: Vec<MappedOptics>,
    arrangements: Vec<Arrangement>,
    layouts: Vec<ViewLayout>,
    grid: &'a VolumeGrid,
    footprint_mm: f64,
    parts: &'a ModelParts,
}

impl<'a> Setup<'a> {
    fn new(
        optics: &Optics,
        poses: &[Pose],
        calibrations: &[CameraCalibration],
        grid: &'a VolumeGrid,
        footprint_mm: f64,
        parts: &'a ModelParts,
        known: &[ViewLayout],
    ) -> Result<Self, ModelError> {
        if !(footprint_mm.is_finite() && footprint_mm >= 0.0) {
            return Err(ModelError::FootprintOutOfRange { footprint_mm });
        }
        let uncalibrated = CameraCalibration::default();
        let mapped: Vec<MappedOptics> = poses
            .iter()
            .enumerate()
            .map(|(n, pose)| {
                let calibration = calibrations.get(n).unwrap_or(&uncalibrated);
                MappedOptics::new(optics, pose, calibration, grid, CameraName(n))
            })
            .collect::<Result<_, _>>()?;
        let arrangements =
            mapped.iter().map(|optics| Arrangement::new(optics, grid, footprint_mm)).collect();
        let layouts = layouts(&mapped, parts, known);
        Ok(Self { mapped, arrangements, layouts, grid, footprint_mm, parts })
    }

    fn narrowest(&self) -> Option<Box<dyn BlockModel>> {
        if let Some(model) = self.model::<4>() {
            return Some(Box::new(model));
        }
        Some(Box::new(self.model::<8>()?))
    }

    fn model<const L: usize>(&self) -> Option<MappedModel<L>> {
        let cameras = self.mapped.iter().zip(&self.arrangements).map(|(optics, arrangement)| {
            let geometries = self.geometries(optics, arrangement);
            let tables = if arrangement.has_quads() {
                CameraTables::Quads(tables(&geometries)?)
            } else {
                CameraTables::Pairs(tables(&geometries)?)
            };
            Some(MappedCamera {
                optics: optics.clone(),
                axes: arrangement.axes,
                layers: arrangement.layers,
                geometries,
                tables,
            })
        });
        let cameras = cameras.collect::<Option<Vec<_>>>()?;
        Some(MappedModel { grid: self.grid.clone(), layouts: self.layouts.clone(), cameras })
    }

    /// Geometry of a camera's footprints along columns and rows.
    fn geometries(
        &self,
        optics: &MappedOptics,
        arrangement: &Arrangement,
    ) -> [FootprintGeometry; 2] {
        let (pitch_mm, lenses_per_cell) = (optics.pitch_mm(), optics.lenses_per_cell());
        let blur = self.parts.blur(&optics.optics);
        let grid = &optics.sampling.grid;
        let window = [optics.window.columns.len(), optics.window.rows.len()];
        let lens = &optics.optics;
        // da/ds = s_i/s² (docs/theory.md, section 4).
        let per_depth = lens.image_distance_mm() / lens.object_distance_mm.powi(2);
        [0, 1].map(|n| {
            let [low, high] = arrangement.depths_mm[n];
            let widest_mm = blur.pupil_mm.max(optics.sampling.cell_mm);
            let most_mm = 2.0 * DEPTH_TOLERANCE * pitch_mm[n] / (widest_mm * per_depth);
            let count = ((high - low) / most_mm).ceil() as usize + 1;
            let step_mm = (high - low) / count as f64;
            let on_axis = optics.on_axis()[n];
            let farthest = on_axis.abs().max((window[n] as f64 - on_axis).abs()) * pitch_mm[n];
            FootprintGeometry {
                optics: lens.clone(),
                pitch_mm: pitch_mm[n],
                lenses_per_cell: lenses_per_cell[n][n],
                phase_step_px: [grid.column_px[1], -grid.row_px[2]][n],
                depths: Nodes { first_mm: low + step_mm / 2.0, step_mm, count },
                pair_step: arrangement.pair_step[n],
                depth_step: arrangement.depth_step[n],
                footprint_mm: self.footprint_mm,
                blur,
                max_slope_mm: lens.pupil_diameter_mm() / 2.0
                    + farthest * lens.object_distance_mm / lens.image_distance_mm(),
            }
        })
    }
}

/// Tables along columns and rows; `None` if one is not wide enough.
fn tables<const L: usize, const C: usize>(
    geometries: &[FootprintGeometry; 2],
) -> Option<[ShareTable<L, C>; 2]> {
    let [columns, rows] = geometries;
    let (columns, rows) = rayon::join(|| ShareTable::new(columns), || ShareTable::new(rows));
    Some([columns?, rows?])
}

impl<const L: usize> CameraTables<L> {
    fn layouts(&self) -> [&TableLayout; 2] {
        match self {
            Self::Pairs(tables) => tables.each_ref().map(|table| &table.layout),
            Self::Quads(tables) => tables.each_ref().map(|table| &table.layout),
        }
    }

    fn memory_bytes(&self) -> usize {
        match self {
            Self::Pairs(tables) => tables.iter().map(ShareTable::memory_bytes).sum(),
            Self::Quads(tables) => tables.iter().map(ShareTable::memory_bytes).sum(),
        }
    }
}

impl<const L: usize> MappedCamera<L> {
    /// Projects a grid position, in voxels.
    fn project(&self, grid: &VolumeGrid, index: [f64; 3]) -> ProjectedPoint {
        let world: [f64; 3] = std::array::from_fn(|axis| grid.coordinate_mm(axis, index[axis]));
        self.optics.project(&Point3::from(world))
    }

    fn support(&self, depth_mm: [f64; 2]) -> Support {
        Support::new(&self.geometries, depth_mm, self.optics.lenses_per_cell())
    }

    fn pupil_radius(&self) -> [f64; 2] {
        self.optics.pupil_radius()
    }

    /// Parameters for computing the addresses of a view.
    fn view(&self, view: &View) -> ViewAddresses {
        let lenses_per_cell = self.optics.lenses_per_cell();
        let window = &self.optics.window;
        let first = [window.columns.start as f64, window.rows.start as f64];
        let grid = &self.optics.sampling.grid;
        let from_window = |[constant, by_i, by_j]: [f64; 3]| {
            [constant + by_i * first[0] + by_j * first[1], by_i, by_j].map(|px| px as f32)
        };
        let on_axis = self.optics.on_axis();
        let lenses = [window.columns.len(), window.rows.len()];
        let lens = &self.optics.optics;
        let magnification = -RayMap::at_depth(lens, 0.0).position;
        let layouts = self.tables.layouts();
        ViewAddresses {
            pupil: lenses_per_cell.map(|[by_right, by_up]| {
                (by_right * f64::from(view.k) + by_up * f64::from(view.l)) as f32
            }),
            lenses_per_cell: lenses_per_cell.map(|row| row.map(|lenses| lenses as f32)),
            column_px: from_window(grid.column_px),
            row_px: from_window(grid.row_px),
            axes: [0, 1].map(|n| AxisAddresses {
                layout: *layouts[n],
                on_axis: on_axis[n] as f32,
                lenses: lenses[n] as f32,
                object_per_place: (1.0 / magnification) as f32,
                slopes: layouts[n].leans_per_mm * self.geometries[n].pitch_mm as f32,
            }),
        }
    }
}

impl<const L: usize> MappedModel<L> {
    /// Positions of the blocks relative to a camera, for each of their layers.
    fn places(&self, camera: &MappedCamera<L>, blocks: &[u32]) -> Vec<BlockPlaces> {
        let layouts = camera.tables.layouts();
        let offsets = camera.layers.offsets(camera.axes);
        let place = |offset: [f64; 3]| {
            let mut places = BlockPlaces::default();
            for &block in blocks {
                let first = block_indices(&self.grid, block);
                let index = std::array::from_fn(|axis| 2.0 * first[axis] as f64 + offset[axis]);
                places.push(&camera.project(&self.grid, index), layouts);
            }
            places
        };
        offsets.into_iter().map(place).collect()
    }
}

impl<const L: usize> BlockModel for MappedModel<L> {
    fn grid(&self) -> &VolumeGrid {
        &self.grid
    }

    fn layouts(&self) -> &[ViewLayout] {
        &self.layouts
    }

    fn projector(&self, blocks: &[u32]) -> Box<dyn BlockProjector + '_> {
        Box::new(MappedProjector::new(self, blocks))
    }

    fn lit(&self, views: &[ViewStack], criteria: &HullCriteria) -> LitBlocks {
        lit::lit_blocks(self, views, criteria)
    }

    fn image_len(&self, camera: usize) -> usize {
        self.layouts[camera].window.len() + L
    }

    fn memory_bytes(&self) -> usize {
        self.cameras.iter().map(|camera| camera.tables.memory_bytes()).sum::<usize>()
            + self.layouts.iter().map(coverage_bytes).sum::<usize>()
    }
}
