//! One shot: the frames of all cameras for one trigger.

use std::time::Duration;

use lfpiv_hw::device::Frame;

use crate::archive::ShotTime;

/// The paired frames of one trigger.
#[derive(Debug, Clone)]
pub struct Shot {
    /// Trigger number since the synchroniser was programmed, from 0.
    pub trigger: u64,
    /// Exposures 1 and 2 of each camera, in the order of the configuration's cameras.
    pub cameras: Vec<[Frame; 2]>,
    /// When the trigger was given, if known.
    pub time: Option<ShotTime>,
    /// When the trigger was due, on the run's clock.
    pub due: Duration,
    /// Time between the light pulses, in µs.
    pub dt_us: f64,
    /// Evidence against the pairing or the light; empty for a normal shot. A suspect shot is kept and marked, and
    /// the mark is shown with its result.
    pub suspect: Vec<String>,
    /// Deviation of the timestamp of each camera's frame a from its fitted clock, in ns: of the first
    /// camera from the triggers of the burst, of every other camera from the first. 0 if the clock fit
    /// starts with this shot.
    pub residuals_ns: Vec<i64>,
}
