//! Faults on purpose: middleware that wraps any camera or serial line and disturbs what goes
//! through it.
//!
//! [`FaultyCamera`] wraps a [`Camera`](lfpiv_hw::device::Camera): frames that are dropped, late,
//! out of order, repeated, cut off or corrupted, triggers that are not seen, a clock that drifts
//! and jumps, a connection that is lost. [`FaultyLine`] wraps a
//! [`Line`](lfpiv_hw::synchroniser::line::Line): commands that are lost, replies that are lost,
//! slow or garbled, stray bytes, `?8` at the wrong time, a cable that is cut. There is no third one
//! for the synchroniser: whatever may go wrong with it goes wrong on its line, where the real
//! driver has to bear it. [`crate::wire`] has both at the far ends of real wires.
//!
//! ```
//! use std::time::Duration;
//!
//! use lfpiv_hw::device::{Camera, DeviceError};
//! use lfpiv_sim::faults::{FaultSettings, FaultyCamera, FrameFault};
//!
//! fn watch(cameras: Vec<Box<dyn Camera>>) -> Result<(), DeviceError> {
//!     let mut settings = FaultSettings { seed: 7, ..FaultSettings::default() };
//!     settings.camera.shares.dropped = 0.02;
//!     settings.camera.clock_drift_ppm = 100.0;
//!     for (index, camera) in cameras.into_iter().enumerate() {
//!         let mut camera = FaultyCamera::new(camera, index, &settings);
//!         let record = camera.record();
//!         camera.start()?;
//!         while let Some(frame) = camera.next_frame(Duration::from_secs(1))? {
//!             println!("{}: frame {}", camera.name(), frame.frame_id);
//!         }
//!         let dropped = record.count(|fault| *fault == FrameFault::Dropped);
//!         println!("{} of {} frames, {dropped} dropped", record.given(), record.taken());
//!     }
//!     Ok(())
//! }
//! ```
//!
//! What holds of every injector:
//!
//! * without faults it is transparent;
//! * what happens to a frame or command depends on the seed and on its number alone, never on
//!   time: each has a random stream of its own;
//! * every fault is in the [`FaultRecord`], so that a test can compare what was done with what the
//!   program says; what went in is what came out and what the record has:
//!   `given = taken - dropped - missed - undelivered - held + duplicated`;
//! * time comes from one [`Clock`], which a test may set by hand.

mod camera;
mod clock;
mod line;
mod record;
mod settings;
#[cfg(test)]
mod tests;

pub use camera::{FaultyCamera, FrameFault};
pub use clock::{Clock, HostClock, ManualClock};
pub use line::{FaultyLine, LineFault};
pub use record::{FaultRecord, Injected};
pub use settings::{
    CameraFaults, ClockJump, CommandShares, FaultSettings, FrameShares, LineFaults,
};

use rand::{Rng, RngExt};

/// Draws at most one of several faults that exclude each other.
fn draw<F: Copy>(shares: &[(F, f64)], rng: &mut impl Rng) -> Option<F> {
    let mut at: f64 = rng.random();
    for (fault, share) in shares {
        if at < *share {
            return Some(*fault);
        }
        at -= share;
    }
    None
}
