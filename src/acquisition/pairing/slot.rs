//! What one camera has delivered of one trigger.

use std::time::Duration;

use lfpiv_hw::device::{Frame, FrameStatus};

use crate::acquisition::Outcome;

/// Frames a and b of one camera, and what is known about those that are not there.
#[derive(Debug, Default)]
pub(super) struct Slot {
    pub frames: [Option<Frame>; 2],
    /// The camera did not see this trigger.
    pub missed: bool,
    /// When a frame of a later trigger arrived first.
    pub passed_at: Option<Duration>,
    /// When the wait for the frames was given up.
    pub overdue_at: Option<Duration>,
    pub settled: bool,
    pub disagreement: Vec<String>,
}

impl Slot {
    pub fn is_full(&self) -> bool {
        self.frames.iter().all(Option::is_some)
    }

    pub fn is_empty(&self) -> bool {
        self.frames.iter().all(Option::is_none)
    }

    /// Whether nothing is known that shows that the trigger was given.
    pub fn is_untouched(&self) -> bool {
        self.is_empty() && !self.settled && !self.missed && self.passed_at.is_none()
    }

    pub fn frames_missing(&self) -> u64 {
        self.frames.iter().filter(|frame| frame.is_none()).count() as u64
    }

    pub fn frames_held(&self) -> u64 {
        2 - self.frames_missing()
    }

    /// Puts a frame in its place, unless it is there already. A frame of another number in that
    /// place was taken for this half before it was known where the numbers begin.
    pub fn put(&mut self, half: usize, frame: Frame) -> bool {
        if let Some(there) = self.frames[half].take() {
            let misplaced = there.frame_id != frame.frame_id && self.frames[1 - half].is_none();
            if !misplaced {
                self.frames[half] = Some(there);
                return false;
            }
            self.frames[1 - half] = Some(there);
        }
        self.frames[half] = Some(frame);
        true
    }

    pub fn is_damaged(&self) -> bool {
        self.frames.iter().flatten().any(|frame| frame.status == FrameStatus::MissingPackets)
    }

    /// Timestamp of frame a, once it is there.
    pub fn timestamp_ns(&self) -> Option<i128> {
        self.frames[0].as_ref().map(|frame| i128::from(frame.device_timestamp_ns))
    }

    /// What a full slot of a shot that cannot be paired ends as.
    pub fn outcome_without_partner(&self) -> Outcome {
        if self.is_damaged() {
            Outcome::MissingPackets
        } else if self.overdue_at.is_some() {
            Outcome::Late
        } else {
            Outcome::Unpaired
        }
    }

    /// Whether the wait is over: `patience` after the frame was due and the camera last spoke, or
    /// after the camera went on to a later trigger.
    pub fn is_overdue(&self, due: Duration, now: Duration, patience: Duration) -> bool {
        now > self.deadline(due, patience)
    }

    /// When the wait is over.
    pub fn deadline(&self, due: Duration, patience: Duration) -> Duration {
        self.passed_at.unwrap_or(due) + patience
    }

    /// Drops the pictures: what is settled needs no memory. Returns how many frames there were.
    pub fn settle(&mut self) -> u64 {
        let held = self.frames_held();
        self.settled = true;
        self.frames = [None, None];
        held
    }
}
