//! What a voxel does to a pixel.
//!
//! The reconstruction knows the optics only through [`ForwardModel`]: a set of views, and for any
//! set of active voxels a [`Projector`] that images intensities into one view and spreads one
//! view's values back onto the voxels. [`ThinLensModel`] does it with separable tables and stores
//! no matrix; [`ExplicitModel`] holds sparse matrices, subset by subset as the paper does, and is
//! the reference that the tables are tested against.

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

/// A pixel belongs to a voxel's support when it receives more than this share of its light, in a
/// view that sees most of it.
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
/// The intensity of a voxel is the count that it gives a pixel whose pupil cell is fully open and
/// that receives all of the voxel's light in that view: the weights of an inner voxel in an open
/// view sum to 1.
pub trait ForwardModel: Send + Sync {
    /// The voxels.
    fn grid(&self) -> &VolumeGrid;
    /// The views of every camera.
    fn layouts(&self) -> &[ViewLayout];
    /// A projector for the voxels at these positions of the grid's z, y, x order, ascending.
    fn projector(&self, voxels: &[u32]) -> Box<dyn Projector + '_>;
    /// Bytes held for the whole life of the model.
    fn memory_bytes(&self) -> usize;
}

/// A [`ForwardModel`] restricted to a list of active voxels.
pub trait Projector: Send + Sync {
    /// Images the voxels into a view: `image[i] = Σ_j w_ji intensity[j]`, row-major over the
    /// camera's microlens window. Overwrites `image`.
    fn project(&self, view: ViewId, intensity: &[f32], image: &mut [f32]);

    /// Spreads a view back: `out[j − range.start] += Σ_i w_ji image[i]` for voxels `j` in `range`.
    fn back_project(&self, view: ViewId, image: &[f32], range: Range<usize>, out: &mut [f32]);

    /// The brightest pixel that each voxel reaches: `out[j − range.start] = max_i image[i] / c_i`
    /// over the pixels that receive more than [`SUPPORT_SHARE`] of the voxel's light in this view
    /// (the tables ask for that share along each axis), with c_i the open share of the pixel's
    /// pupil cell; at least 0, for noise below the black level is no light. Infinite, that is no
    /// evidence, for a voxel with such a pixel less than half open or outside the view.
    fn brightest(&self, view: ViewId, image: &[f32], range: Range<usize>, out: &mut [f32]);

    /// Keeps only the voxels whose flag is set.
    fn retain(&mut self, keep: &[bool]);
}

/// Keeps the entries whose flag is set.
pub(crate) fn retain<T>(values: &mut Vec<T>, keep: &[bool]) {
    let mut flags = keep.iter();
    values.retain(|_| flags.next().copied().unwrap_or(false));
}

/// Why the optics cannot see the volume.
#[derive(Debug, Error, PartialEq)]
pub enum ModelError {
    /// No part of the volume is imaged.
    #[error(
        "{camera} does not see the volume: its image lies wholly outside the microlens \
         array; move [volume] or correct the pose of {camera}"
    )]
    VolumeOutOfView { camera: CameraName },
    /// The volume reaches the lens or lies behind it.
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
    /// Microlenses that do not stand in squares.
    #[error(
        "{camera}: the micro-images of its calibration do not stand in a square grid; hexagonal \
         arrays are calibrated but not reconstructed: use a camera with a square array"
    )]
    NotSquare { camera: CameraName },
    /// A voxel's shadow is wider than the tables hold.
    #[error(
        "{camera}: a voxel's light, {footprint_mm} mm wide, reaches over {pitches:.2} \
         microlens pitches at its deepest, allowed: {most}; use smaller voxels or a shallower \
         volume"
    )]
    FootprintTooWide { camera: CameraName, footprint_mm: f64, pitches: f64, most: usize },
    /// The light source that a voxel stands for has no size.
    #[error("a voxel's light of edge {footprint_mm} mm, allowed: a finite length of 0 or more")]
    FootprintOutOfRange { footprint_mm: f64 },
}
