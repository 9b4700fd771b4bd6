//! One shot: what all cameras saw of one trigger.

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
    /// When the trigger was given, as far as that is known.
    pub time: Option<ShotTime>,
    /// When the trigger was due, by the run's clock.
    pub due: Duration,
    /// Time between the light pulses, in µs.
    pub dt_us: f64,
    /// Evidence that disagrees with the pairing, in words; empty for a shot in order. A suspect
    /// shot is kept and marked, and whoever reads its result must see the mark.
    pub suspect: Vec<String>,
    /// How far the timestamp of each camera's frame a is off its fitted clock, in ns: of the first
    /// against the triggers of the burst, of every other camera against the first. 0 for a clock
    /// that begins with this shot.
    pub residuals_ns: Vec<i64>,
}
