//! Fault injection: middleware that wraps any camera or serial line.
//!
//! [`FaultyCamera`] wraps a [`Camera`](lfpiv_hw::device::Camera): dropped, late, reordered,
//! duplicated, truncated or corrupted frames, missed triggers, clock drift and jumps, a lost
//! connection. [`FaultyLine`] wraps a [`Line`](lfpiv_hw::synchroniser::line::Line): lost commands,
//! lost, slow or garbled replies, stray bytes, spurious `?8`, a cut cable. The synchroniser needs
//! no wrapper of its own: its faults occur on its line, where the real driver must handle them.
//! [`crate::wire`] applies both at the far ends of real wires.
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
//! Properties of both injectors:
//!
//! * Without faults they are transparent.
//! * The fault of a frame or command depends on the seed and its number alone, never on time: each
//!   has its own random stream.
//! * Every fault is in the [`FaultRecord`], so that a test can compare it with the program's
//!   reports, and `given = taken - dropped - missed - undelivered - held + duplicated`.
//! * Time comes from one [`Clock`], which a test may control.

mod camera;
mod clock;
mod line;
mod record;
mod settings;
#[cfg(test)]
mod tests;

pub use camera::{FaultyCamera, FrameFault};
pub use clock::{Clock, ManualClock, SystemClock};
pub use line::{FaultyLine, LineFault};
pub use record::{FaultRecord, Injected};
pub use settings::{
    CameraFaults, ClockJump, CommandShares, FaultSettings, FrameShares, LineFaults,
};

use rand::{Rng, RngExt};

/// Draws at most one of several mutually exclusive faults.
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
