//! The frames of one camera for one trigger.

use std::time::Duration;

use lfpiv_hw::device::{Frame, FrameStatus};

use crate::acquisition::Outcome;

/// Frames a and b of one camera, and the state of missing ones.
#[derive(Debug, Default)]
pub(super) struct Slot {
    pub frames: [Option<Frame>; 2],
    /// The camera did not see this trigger.
    pub missed: bool,
    /// When the first frame of a later trigger arrived.
    pub passed_at: Option<Duration>,
    /// When the wait for the frames ended.
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

    /// Whether there is no evidence that the trigger was given.
    pub fn has_no_evidence(&self) -> bool {
        self.is_empty() && !self.settled && !self.missed && self.passed_at.is_none()
    }

    pub fn frames_missing(&self) -> u64 {
        self.frames.iter().filter(|frame| frame.is_none()).count() as u64
    }

    pub fn frames_held(&self) -> u64 {
        2 - self.frames_missing()
    }

    /// Stores a frame unless it is a duplicate. A frame of another number in this place was assigned to
    /// this half before the start of the numbering was known.
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

    /// Outcome of a complete slot in a shot that cannot be paired.
    pub fn outcome_without_partner(&self) -> Outcome {
        if self.is_damaged() {
            Outcome::MissingPackets
        } else if self.overdue_at.is_some() {
            Outcome::Late
        } else {
            Outcome::Unpaired
        }
    }

    /// Whether the wait is over: `patience` after the frame was due and after the camera's last
    /// frame, or after a frame of a later trigger.
    pub fn is_overdue(&self, due: Duration, now: Duration, patience: Duration) -> bool {
        now > self.deadline(due, patience)
    }

    /// When the wait ends.
    pub fn deadline(&self, due: Duration, patience: Duration) -> Duration {
        self.passed_at.unwrap_or(due) + patience
    }

    /// Drops the images to free memory; returns the number of frames.
    pub fn settle(&mut self) -> u64 {
        let held = self.frames_held();
        self.settled = true;
        self.frames = [None, None];
        held
    }
}
