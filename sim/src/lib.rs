//! A bench that is not there: known flows, particles that follow them, and the light-field images
//! two cameras would take, by ray tracing.
//!
//! It depends on the description of the bench (`lfpiv-hw`) alone and shares no code with the
//! reconstruction, whose accuracy it is there to judge.

pub mod flow;
pub mod imaging;
pub mod particles;
pub mod scene;
mod stream;

pub use flow::Flow;
pub use particles::{Particle, Volume};
pub use scene::Scene;
