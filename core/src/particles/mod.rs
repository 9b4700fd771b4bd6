//! Particles placed in the images.
//!
//! A reconstructed volume knows a particle to a voxel's tenth, the images far better. Candidates come
//! from the light of the volume; each is fitted, place and light, to the pixels of all cameras
//! with the exact footprint of a point ([`crate::model::PointCamera`]), all against common
//! residual images (`fit`): iterative particle reconstruction (Wieneke, Measurement Science and Technology 24, 2013; Jahn,
//! Schanz and Schröder, Experiments in Fluids 62, 2021) for light fields. Both frames support each
//! other (`partners`; two pulses: Novara, Schanz and Schröder, 2023): where they do not agree, each gets
//! what the other has, and particles start again from several places (`restart`). How wide points are
//! (`blur`), how bright in which camera (`select`), and how far pixels can be believed (`noise`), the images
//! say.

mod blur;
mod fit;
mod flow;
mod image;
mod kernels;
mod neighbours;
mod noise;
mod normal;
mod partners;
mod place;
mod restart;
mod select;

pub use blur::{FIRST_WIDTH_PX, blur_of_width};
pub use flow::Flow;
pub use image::{ParticleImage, PixelNoise};
pub use neighbours::Neighbours;
pub use normal::{CAMERAS, Particle};
pub use place::{FrameStart, ParticlePair, PlacedParticles, place_pairs};
pub use select::Candidate;
