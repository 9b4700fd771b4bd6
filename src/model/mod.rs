//! What a voxel does to a pixel.

mod grid;

pub use grid::VolumeGrid;
