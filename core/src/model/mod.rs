//! The forward model: weights between voxels and pixels.
//!
//! The reconstruction accesses the optics only through [`ForwardModel`]: a set of views, and for any set of
//! active voxels a [`Projector`] that projects intensities into one view and back-projects one view onto the
//! voxels. [`ThinLensModel`] uses separable tables and stores no matrix. [`ExplicitModel`] stores sparse
//! matrices, subset by subset as in the paper, and is the reference in the tests of the tables.

mod blocks;
mod calibration;
mod camera;
mod choice;
mod closed_surface;
mod explicit;
mod explicit_projector;
pub mod footprint;
mod grid;
mod hull;
mod mapped_optics;
mod parts;
mod point_footprint;
mod point_image;
mod quadrature;
mod region;
mod settings;
mod sight;
mod sparse_columns;
mod table_weights;
mod tables;
mod thin_lens;
mod volume_map;
mod volume_mask;
mod weights;

use std::ops::Range;

use lfpiv_hw::CameraName;
use thiserror::Error;

pub use blocks::{
    BlockLight, BlockModel, BlockProjector, HullCriteria, LitBlocks, VoxelwiseBlocks, block_model,
    block_model_beside, blocks_along, child_voxel,
};
pub use calibration::CameraCalibration;
pub use choice::{ModelChoice, Part, PartChoice, SceneMeasure};
pub use closed_surface::{ClosedSurface, SurfaceError};
pub use explicit::{ExplicitModel, SubsetMatrix};
pub use grid::VolumeGrid;
pub use hull::{Hull, photo_hull};
pub use parts::{AIRY_SIGMA, Blur, ModelParts};
pub use point_footprint::{LANES, LensShares, PointBlur, PointCamera, PointFootprint};
pub use point_image::{LitPixel, PointImager};
pub use quadrature::QuadratureWeights;
pub use region::{FlowRegions, Region};
pub use settings::{ModelMode, ModelSettings, Switch, mode_or_table};
pub use sight::{Sight, degrees_apart};
pub use table_weights::TableWeights;
pub use thin_lens::{ThinLensModel, thin_lens_model, thin_lens_model_of};
pub use volume_map::{EquivalentPoint, MapResidual, VolumeMap};
pub use volume_mask::VolumeMask;
pub use weights::{Weight, WeightSource};

use crate::lightfield::ViewLayout;

/// Least share of a voxel's light on a pixel of its support, in a view that contains most of the light.
pub const SUPPORT_SHARE: f32 = 0.01;

/// One view of one camera.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ViewId {
    /// Camera, in the order of the configuration.
    pub camera: usize,
    /// View, in the order of that camera's layout.
    pub view: usize,
}

/// The linear map from voxel intensities to the pixels of every view.
///
/// The intensity of a voxel is the count in a pixel with an open pupil cell that receives all of the voxel's
/// light in its view. The weights of an inner voxel in an open view therefore sum to 1.
pub trait ForwardModel: Send + Sync {
    /// The voxel grid.
    fn grid(&self) -> &VolumeGrid;
    /// The views of every camera.
    fn layouts(&self) -> &[ViewLayout];
    /// A projector for the voxels at these positions of the grid's z, y, x order, ascending.
    fn projector(&self, voxels: &[u32]) -> Box<dyn Projector + '_>;
    /// Bytes of the model.
    fn memory_bytes(&self) -> usize;
}

/// A [`ForwardModel`] restricted to a list of active voxels.
pub trait Projector: Send + Sync {
    /// Projects the voxels into a view: `image[i] = Σ_j w_ji intensity[j]`, row-major over the
    /// camera's microlens window. Overwrites `image`.
    fn project(&self, view: ViewId, intensity: &[f32], image: &mut [f32]);

    /// Back-projects a view: `out[j − range.start] += Σ_i w_ji image[i]` for voxels `j` in `range`.
    fn back_project(&self, view: ViewId, image: &[f32], range: Range<usize>, out: &mut [f32]);

    /// The brightest pixel that each voxel reaches: `out[j − range.start] = max_i image[i] / c_i` over the
    /// pixels that receive more than [`SUPPORT_SHARE`] of the voxel's light in this view (in the tables: along
    /// each axis), with the open share c_i of the pixel's pupil cell. At least 0, because negative values are
    /// noise. Infinite, which means no evidence, if such a pixel is less than half open or outside the view.
    fn brightest(&self, view: ViewId, image: &[f32], range: Range<usize>, out: &mut [f32]);

    /// Keeps only the voxels whose flag is set.
    fn retain(&mut self, keep: &[bool]);
}

/// Keeps the entries whose flag is set.
pub(crate) fn retain<T>(values: &mut Vec<T>, keep: &[bool]) {
    let mut flags = keep.iter();
    values.retain(|_| flags.next().copied().unwrap_or(false));
}

/// Reasons for which no forward model exists.
#[derive(Debug, Error, PartialEq)]
pub enum ModelError {
    /// No part of the volume is imaged.
    #[error(
        "{camera} does not see the volume: its image lies wholly outside the microlens \
         array; move [volume] or correct the pose of {camera}"
    )]
    VolumeOutOfView { camera: CameraName },
    /// The volume extends to the lens or is behind it.
    #[error(
        "{camera}: the volume reaches to a depth of {depth_mm:.1} mm, allowed: less than \
         {limit_mm:.1} mm (object distance minus focal length); make [volume] smaller"
    )]
    TooDeep { camera: CameraName, depth_mm: f64, limit_mm: f64 },
    /// Calibrated cameras with a solver that supports nominal ones only.
    #[error(
        "{camera} is calibrated, and whole-volume solvers support uncalibrated cameras only; \
         leave out reconstruction.domain = \"volume\", or use the solver os-mart"
    )]
    CalibratedWholeVolume { camera: CameraName },
    /// A calibrated camera and voxels whose light reaches too far for its tables.
    #[error(
        "{camera} is calibrated, and a voxel's light, {footprint_mm} mm wide, reaches over more \
         than 8 microlenses; use smaller voxels or a shallower volume"
    )]
    CalibratedTooWide { camera: CameraName, footprint_mm: f64 },
    /// A microlens array that is not square.
    #[error(
        "{camera}: the micro-images of its calibration do not stand in a square grid; hexagonal \
         arrays are calibrated but not reconstructed: use a camera with a square array"
    )]
    NotSquare { camera: CameraName },
    /// A voxel's shadow is too wide for the tables.
    #[error(
        "{camera}: a voxel's light, {footprint_mm} mm wide, reaches over {pitches:.2} \
         microlens pitches at its deepest, allowed: {most}; use smaller voxels or a shallower \
         volume"
    )]
    FootprintTooWide { camera: CameraName, footprint_mm: f64, pitches: f64, most: usize },
    /// The edge of a voxel's light source is negative or not finite.
    #[error("a voxel's light of edge {footprint_mm} mm, allowed: a finite length of 0 or more")]
    FootprintOutOfRange { footprint_mm: f64 },
}
