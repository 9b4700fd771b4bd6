//! The simulated bench: cameras and a synchroniser that share one scene and one clock.
//!
//! ```
//! use std::time::Duration;
//!
//! use lfpiv_hw::{PulseSchedule, TimingSettings};
//! use lfpiv_sim::{BenchGeometry, Pacing, Scene, connect};
//!
//! fn record(
//!     scene: Scene,
//!     geometry: BenchGeometry,
//!     shots: u64,
//! ) -> Result<(), Box<dyn std::error::Error>> {
//!     let mut bench = connect(scene, geometry, 1, Pacing::RealTime);
//!     for camera in &mut bench.cameras {
//!         camera.start()?;
//!     }
//!     bench.synchroniser.program(&PulseSchedule::plan(&TimingSettings::default(), 100.0, 10.0)?)?;
//!     bench.synchroniser.fire(shots)?;
//!     for _ in 0..2 * shots {
//!         for camera in &mut bench.cameras {
//!             if let Some(frame) = camera.next_frame(Duration::from_secs(1))? {
//!                 println!("{}: frame {}", camera.name(), frame.frame_id);
//!             }
//!         }
//!     }
//!     bench.synchroniser.make_safe()?;
//!     Ok(())
//! }
//! ```
//!
//! The bench has no threads: a frame is rendered by the call that requests it, and a waiting call
//! sleeps on the shared state. Shot n after programming shows `Scene::shot(geometry, seed, n)` with
//! the programmed pulse separation; [`Scene::truth`] with the same arguments returns the true flow.

use std::sync::Arc;

use lfpiv_hw::device::{Camera, Synchroniser};

use crate::{
    BenchGeometry, Scene, camera::SimulatedCamera, shared_bench::SharedBench,
    synchroniser::SimulatedSynchroniser, triggers::Pacing,
};

/// The devices of a simulated bench.
pub struct SimulatedBench {
    /// One camera per pose, named `cam1`, `cam2`, …
    pub cameras: Vec<Box<dyn Camera>>,
    /// The unit that triggers them.
    pub synchroniser: Box<dyn Synchroniser>,
}

/// Devices that show `scene`. The pulse separation of `geometry` is replaced by the programmed one;
/// `seed` determines particles and noise.
pub fn connect(scene: Scene, geometry: BenchGeometry, seed: u64, pacing: Pacing) -> SimulatedBench {
    let count = geometry.poses.len();
    let bench = Arc::new(SharedBench::new(scene, geometry, seed, pacing));
    let cameras = (0..count)
        .map(|index| Box::new(SimulatedCamera::new(index, Arc::clone(&bench))) as Box<dyn Camera>)
        .collect();
    SimulatedBench { cameras, synchroniser: Box::new(SimulatedSynchroniser::new(bench)) }
}

#[cfg(test)]
mod tests;
