//! A bench that is not there: known flows, particles that follow them, and the light-field images
//! two cameras would take, by ray tracing.
//!
//! It depends on the description of the bench (`lfpiv-hw`) alone. That is all it shares with the
//! reconstruction, whose accuracy it is there to judge: the optics' numbers, the poses, and the
//! conventions of axes, rows and columns. Rays are traced here and weights are computed there: a fault
//! of either shows when they are compared. A fault in what both are told does not show, such as a
//! lens that is not thin or a convention that a real bench does not follow.

pub mod bench;
mod camera;
pub mod faults;
pub mod flow;
pub mod geometry;
pub mod imaging;
pub mod particles;
pub mod planar;
pub mod scene;
pub mod sensor;
mod shared_bench;
mod stream;
mod synchroniser;
#[cfg(test)]
mod test_bench;
mod triggers;
pub mod wire;

pub use bench::{SimulatedBench, connect};
pub use flow::Flow;
pub use geometry::{BenchGeometry, EmptySpace, Volume};
pub use imaging::{CameraFlaws, ConventionalCamera, TrueMicroImageGrid};
pub use particles::{FrameOfPair, Placement, Tracer};
pub use planar::{PlanarScene, PlanarShot};
pub use scene::{CardErrors, LightPulse, Lighting, Scene, SceneError, SimulatedShot, Truth};
pub use sensor::SensorSettings;
pub use triggers::{LEAD, Pacing};
