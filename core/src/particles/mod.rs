//! Particles placed in the images.
//!
//! The light of a reconstructed volume gives a particle's position to a tenth of a voxel, the images far
//! better. Candidates come from the light of the volume. Position and light of each are fitted to the pixels
//! of all cameras with the exact footprint of a point ([`crate::model::PointCamera`]), all against common
//! residual images (`fit`, `step`): iterative particle reconstruction (Wieneke, Measurement Science and Technology
//! 24, 2013; Jahn, Schanz and Schröder, Experiments in Fluids 62, 2021) for light fields. Both frames support
//! each other (`partners`; two pulses: Novara, Schanz and Schröder, 2023): a particle without a partner is
//! proposed to the other frame, and starts again from several positions (`restart`). Where the flow is wrong, pairs
//! are found by the agreement of neighbours (`consensus`). Blur (`blur`), the
//! cameras' shares of the light (`select`) and pixel noise (`noise`) are estimated from the images.

mod blur;
mod consensus;
mod disagreement;
mod fit;
mod flow;
mod image;
mod kernels;
mod neighbours;
mod noise;
mod normal;
mod order;
mod pair;
mod partners;
mod place;
mod prefetch;
mod restart;
mod select;
mod step;
#[cfg(test)]
mod test_data;

pub use blur::{FIRST_WIDTH_PX, blur_of_width};
pub use flow::{Flow, MovedParticle};
pub use image::ParticleImage;
pub use neighbours::Neighbours;
pub use noise::PixelNoise;
pub use normal::{CAMERAS, Particle};
pub use pair::{ExpectedDisplacement, Motion, ParticlePair};
pub use place::{FrameStart, PlacedParticles, place_pairs};
pub use select::Candidate;
