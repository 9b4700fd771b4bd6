//! Outcomes of triggers, and their count per camera.

use serde::{Deserialize, Serialize, Serializer};

/// How a trigger ended for one camera.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Outcome {
    /// Both frames arrived intact, were paired and processed. Whether processing found vectors is a
    /// property of the shot, not of the trigger.
    Complete,
    /// A frame arrived damaged, or was sent and never arrived.
    MissingPackets,
    /// A frame was lost because the host had no free buffer.
    Underrun,
    /// The camera did not see the trigger.
    MissedTrigger,
    /// Both frames arrived intact, but after the deadline.
    Late,
    /// Both frames arrived intact, but another camera's did not.
    Unpaired,
    /// Not processed although intact: the queue was full or the run ended.
    Shed,
    /// The result or the raw images could not be written.
    WriteFailed,
    /// It was due, but there is no evidence that it was given: no camera saw it, and the synchroniser's
    /// trigger count could not be read.
    NotFired,
}

impl Outcome {
    /// Every outcome, in the order of their counters.
    pub const ALL: [Self; 9] = [
        Self::Complete,
        Self::MissingPackets,
        Self::Underrun,
        Self::MissedTrigger,
        Self::Late,
        Self::Unpaired,
        Self::Shed,
        Self::WriteFailed,
        Self::NotFired,
    ];

    /// Name in JSON and in metrics.
    pub fn name(self) -> &'static str {
        match self {
            Self::Complete => "complete",
            Self::MissingPackets => "missing_packets",
            Self::Underrun => "underrun",
            Self::MissedTrigger => "missed_trigger",
            Self::Late => "late",
            Self::Unpaired => "unpaired",
            Self::Shed => "shed",
            Self::WriteFailed => "write_failed",
            Self::NotFired => "not_fired",
        }
    }
}

/// How many triggers ended as each outcome.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct OutcomeCounts([u64; Outcome::ALL.len()]);

impl OutcomeCounts {
    /// Triggers that ended as `outcome`.
    pub fn of(&self, outcome: Outcome) -> u64 {
        self.0[outcome as usize]
    }

    fn total(&self) -> u64 {
        self.0.iter().sum()
    }
}

impl Serialize for OutcomeCounts {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(Outcome::ALL.map(|outcome| (outcome.name(), self.of(outcome))))
    }
}

/// The account of one camera.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize)]
pub struct Account {
    /// Triggers entered.
    pub triggers: u64,
    /// Triggers not settled yet.
    pub open: u64,
    /// Triggers settled.
    pub outcomes: OutcomeCounts,
}

impl Account {
    /// Settles one open trigger.
    pub(super) fn settle(&mut self, outcome: Outcome) {
        self.open -= 1;
        self.outcomes.0[outcome as usize] += 1;
    }

    /// Whether the conservation law holds.
    pub fn is_balanced(&self) -> bool {
        self.triggers == self.outcomes.total() + self.open
    }
}
