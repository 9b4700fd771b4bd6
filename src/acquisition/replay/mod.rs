//! Replay of a recorded run: cameras and a synchroniser that repeat recorded events, for the same run
//! loop.
//!
//! The record has the order and times in which the run loop saw frames, bursts and their ends. The
//! replay keeps this order, and its clock shows the recorded times. Every decision is therefore the
//! same, at the original speed or as fast as the frames can be read.

mod clock;
mod devices;
mod script;
mod steps;

use std::{path::Path, sync::Arc};

use lfpiv_hw::device::Camera;
use lfpiv_rawlog::Position;
use tokio_util::sync::CancellationToken;

use self::{clock::ReplayClock, script::Script};
use super::{
    Bench, BurstScript, RunClock,
    journal::{Description, RecordedRun, RecordedRunError},
};
pub use script::Speed;

/// The parts of a replay.
pub struct Replay {
    /// The description of the run.
    pub description: Description,
    /// The instruments.
    pub bench: Bench,
    /// Shows the recorded times.
    pub clock: Arc<dyn RunClock>,
    /// Which bursts are fired when.
    pub bursts: Arc<dyn BurstScript>,
    /// Shots in the longest burst: minimum capacity of the queue.
    pub longest_burst: u64,
    /// Frames that turned out to be unreadable, once the run has been replayed.
    pub unreadable: UnreadableFrames,
}

/// Frames of a record whose images turned out to be damaged during the replay.
pub struct UnreadableFrames(Arc<Script>);

impl UnreadableFrames {
    /// Their positions and errors.
    pub fn take(&self) -> Vec<(Position, RecordedRunError)> {
        self.0.unreadable()
    }
}

/// Opens the record of the run in `run`. `stop` is cancelled where the record was told to stop or is
/// cut off.
///
/// # Errors
///
/// There is no record, or it cannot be opened. Damage is skipped.
pub fn replay(
    run: &Path,
    speed: Speed,
    stop: CancellationToken,
) -> Result<Replay, RecordedRunError> {
    let recorded = RecordedRun::open(run)?.finished();
    let description = recorded.description().clone();
    let clock = Arc::new(ReplayClock::default());
    let script = Arc::new(Script::read(recorded, speed, clock.clone(), stop));
    let cameras = (0..description.cameras).map(|camera| {
        Box::new(devices::ReplayCamera::new(camera, script.clone())) as Box<dyn Camera>
    });
    let unit = devices::ReplayUnit::new(script.clone());
    Ok(Replay {
        bench: Bench::new(cameras.collect(), Box::new(unit)),
        description,
        clock,
        longest_burst: script.longest_burst(),
        unreadable: UnreadableFrames(script.clone()),
        bursts: script,
    })
}
