//! Light-field images to velocity: no files, no threads of its own, no devices.
//!
//! The rooms, lowest floor first: [`lightfield`] decodes images into views, [`model`] says which pixel
//! sees which voxel, [`reconstruction`] finds the volume behind the views, [`velocimetry`] the
//! displacement between two volumes, [`measurement`] does all of it for a pair of images.

pub mod lightfield;
pub mod measurement;
pub mod model;
pub mod reconstruction;
pub mod velocimetry;

#[cfg(test)]
mod test_bench;
