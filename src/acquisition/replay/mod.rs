//! A recorded run played again: cameras and a synchroniser that do what their originals did, for
//! the same run loop.
//!
//! The record says in which order the run loop saw frames, bursts and their ends, and when. The
//! replay keeps that order, and its clock shows the recorded times; so every decision is the same,
//! at the speed of then or as fast as the frames can be read.

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

/// What is needed to play a run again.
pub struct Replay {
    /// What the run was.
    pub description: Description,
    /// The instruments.
    pub bench: Bench,
    /// Shows the recorded times.
    pub clock: Arc<dyn RunClock>,
    /// Which bursts are fired when.
    pub bursts: Arc<dyn BurstScript>,
    /// Shots in the longest burst: the queue must have room for them.
    pub longest_burst: u64,
    /// What could not be read, once the run has been played.
    pub unread: UnreadFrames,
}

/// Frames of a record whose images turned out to be damaged when they were played.
pub struct UnreadFrames(Arc<Script>);

impl UnreadFrames {
    /// Where they lie, and what is wrong there.
    pub fn take(&self) -> Vec<(Position, RecordedRunError)> {
        self.0.unread()
    }
}

/// Opens the record of the run in `run`. `stop` is cancelled where the record says that the run
/// was told to stop, or where it breaks off.
///
/// # Errors
///
/// There is no record, or it cannot be opened. A damaged one is played around what is lost.
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
        unread: UnreadFrames(script.clone()),
        bursts: script,
    })
}
