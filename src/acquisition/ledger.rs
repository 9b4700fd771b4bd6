//! The ledger of triggers, per camera, with a conservation law.
//!
//! A trigger is entered once it is known to have been given, or to have been due where that cannot
//! be determined. From then on it counts: no count ever decreases. It ends, for each camera, with
//! exactly one [`Outcome`]. At any time and for every camera
//!
//! ```text
//! triggers = complete + missing packets + underrun + missed trigger + late + unpaired
//!          + shed + write failed + not fired + open
//! ```
//!
//! and at the end of a run `open` is zero. The ledger refuses any change that would break the law.

use std::collections::BTreeMap;

use lfpiv_hw::{CameraName, device::StreamStatistics};
use serde::Serialize;
use thiserror::Error;

use super::{Account, Outcome};
use crate::archive::ShotTime;

/// Entry of one trigger.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct TriggerEntry {
    /// Trigger number since the synchroniser was programmed, from 0. It is also the shot number.
    pub trigger: u64,
    /// When it was given; derived from the schedule alone until its frames are paired.
    pub time: Option<ShotTime>,
    /// Whether the shot was paired and queued.
    pub queued: bool,
    /// Evidence against the pairing; empty for a normal shot.
    pub suspect: Vec<String>,
    /// Outcome per camera; absent while open.
    pub cameras: Vec<Option<Outcome>>,
}

impl TriggerEntry {
    /// Whether every camera's outcome is known.
    pub fn is_settled(&self) -> bool {
        self.cameras.iter().all(Option::is_some)
    }

    /// Whether every camera's outcome is [`Outcome::Complete`].
    pub fn is_complete(&self) -> bool {
        self.cameras.iter().all(|outcome| *outcome == Some(Outcome::Complete))
    }
}

/// A refused change that would break the conservation law; the ledger is unchanged.
#[derive(Debug, Error, PartialEq, Eq)]
pub enum LedgerError {
    /// Already settled, or never entered.
    #[error("trigger {trigger}, {camera}: not open, cannot end as {}", outcome.name())]
    NotOpen { trigger: u64, camera: CameraName, outcome: Outcome },
    /// Already entered.
    #[error("trigger {trigger} was already entered")]
    Entered { trigger: u64 },
    /// A record names an impossible trigger number.
    #[error("the record names trigger {trigger} after trigger {last} without those in between")]
    FarAhead { trigger: u64, last: u64 },
}

/// Settled triggers whose entries are kept; their counts are kept for ever.
const HISTORY: usize = 10_000;

/// The accounts of a run, one per camera.
#[derive(Debug, Clone)]
pub struct Ledger {
    accounts: Vec<Account>,
    streams: Vec<StreamStatistics>,
    /// Whether each camera answers, as its driver says.
    connected: Vec<bool>,
    entries: BTreeMap<u64, TriggerEntry>,
    /// Entries below this may have been dropped, and cannot be entered again.
    dropped_below: u64,
}

impl Ledger {
    /// An empty ledger for `cameras` cameras.
    pub fn new(cameras: usize) -> Self {
        Self {
            accounts: vec![Account::default(); cameras],
            streams: vec![StreamStatistics::default(); cameras],
            connected: vec![true; cameras],
            entries: BTreeMap::new(),
            dropped_below: 0,
        }
    }

    /// Enters a trigger: from now on it is open for every camera.
    pub fn enter(&mut self, trigger: u64) -> Result<(), LedgerError> {
        if trigger < self.dropped_below || self.entries.contains_key(&trigger) {
            return Err(LedgerError::Entered { trigger });
        }
        let cameras = vec![None; self.accounts.len()];
        let (time, queued, suspect) = (None, false, Vec::new());
        self.entries.insert(trigger, TriggerEntry { trigger, time, queued, suspect, cameras });
        for account in &mut self.accounts {
            account.triggers += 1;
            account.open += 1;
        }
        self.forget_oldest();
        self.check_conservation();
        Ok(())
    }

    /// Marks a trigger as paired and queued.
    pub fn mark_queued(&mut self, trigger: u64, suspect: &[String]) {
        if let Some(entry) = self.entries.get_mut(&trigger) {
            entry.queued = true;
            entry.suspect = suspect.to_vec();
        }
    }

    /// Sets the time of a trigger, if it is known.
    pub fn set_time(&mut self, trigger: u64, time: Option<ShotTime>) {
        if let Some(entry) = self.entries.get_mut(&trigger) {
            entry.time = time.or(entry.time);
        }
    }

    /// Settles a trigger for one camera, once.
    pub fn settle(
        &mut self,
        trigger: u64,
        camera: usize,
        outcome: Outcome,
    ) -> Result<(), LedgerError> {
        let refused = LedgerError::NotOpen { trigger, camera: CameraName(camera), outcome };
        let slot = self.entries.get_mut(&trigger).and_then(|entry| entry.cameras.get_mut(camera));
        match slot {
            Some(slot @ None) => *slot = Some(outcome),
            _ => return Err(refused),
        }
        let account = &mut self.accounts[camera];
        account.settle(outcome);
        self.check_conservation();
        Ok(())
    }

    /// Settles a trigger for all cameras, or for none if one of them is already settled.
    pub fn settle_all(&mut self, trigger: u64, outcome: Outcome) -> Result<(), LedgerError> {
        let entry = self.entries.get(&trigger);
        let settled = entry.map_or(Some(0), |entry| entry.cameras.iter().position(Option::is_some));
        if let Some(camera) = settled {
            let camera = CameraName(camera);
            return Err(LedgerError::NotOpen { trigger, camera, outcome });
        }
        (0..self.accounts.len()).try_for_each(|camera| self.settle(trigger, camera, outcome))
    }

    /// Settles a trigger for the cameras for which it is open.
    pub fn settle_open(&mut self, trigger: u64, outcome: Outcome) {
        for camera in 0..self.accounts.len() {
            // A refusal means that it is already settled or unknown: it stays as it is.
            let _ = self.settle(trigger, camera, outcome);
        }
    }

    /// Records whether a camera answers.
    pub fn set_connected(&mut self, camera: usize, connected: bool) {
        self.connected[camera] = connected;
    }

    /// Whether each camera answers, as far as is known.
    pub fn connected(&self) -> &[bool] {
        &self.connected
    }

    /// Stores the counters of a camera's driver since the start of its stream.
    pub fn set_stream_statistics(&mut self, camera: usize, statistics: StreamStatistics) {
        self.streams[camera] = statistics;
    }

    /// The counters of each camera's driver: evidence besides the accounts, not part of the law.
    pub fn streams(&self) -> &[StreamStatistics] {
        &self.streams
    }

    /// One account per camera.
    pub fn accounts(&self) -> &[Account] {
        &self.accounts
    }

    /// The entry of a trigger; `None` before it is entered and after it is dropped.
    pub fn entry(&self, trigger: u64) -> Option<&TriggerEntry> {
        self.entries.get(&trigger)
    }

    /// The entries kept, oldest first.
    pub fn entries(&self) -> impl DoubleEndedIterator<Item = &TriggerEntry> {
        self.entries.values()
    }

    /// Shots queued or in process.
    pub fn in_pool(&self) -> u64 {
        self.unsettled(|entry| entry.queued)
    }

    /// Triggers whose frames are still awaited.
    pub fn awaiting_frames(&self) -> u64 {
        self.unsettled(|entry| !entry.queued)
    }

    fn unsettled(&self, choose: impl Fn(&TriggerEntry) -> bool) -> u64 {
        self.entries.values().filter(|entry| !entry.is_settled() && choose(entry)).count() as u64
    }

    /// Whether the conservation law holds for every camera.
    pub fn is_balanced(&self) -> bool {
        self.accounts.iter().all(Account::is_balanced)
    }

    /// Checks the law after every change. An imbalance is a bug of this program and must be reported.
    fn check_conservation(&self) {
        if !self.is_balanced() {
            debug_assert!(false, "the ledger does not balance: {:?}", self.accounts);
            tracing::error!(accounts = ?self.accounts, "the ledger does not balance");
        }
    }

    /// Open entries are kept: dropping one would break the law.
    fn forget_oldest(&mut self) {
        while self.entries.len() > HISTORY {
            match self.entries.first_entry() {
                Some(oldest) if oldest.get().is_settled() => {
                    self.dropped_below = oldest.remove().trigger + 1;
                }
                _ => break,
            }
        }
    }
}

#[cfg(test)]
mod properties;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_trigger_is_settled_once_per_camera() {
        let mut ledger = Ledger::new(2);
        ledger.enter(0).unwrap();
        ledger.settle(0, 1, Outcome::Late).unwrap();
        let again = ledger.settle(0, 1, Outcome::Complete).unwrap_err();
        assert_eq!(
            again,
            LedgerError::NotOpen { trigger: 0, camera: CameraName(1), outcome: Outcome::Complete }
        );
        assert_eq!((ledger.accounts()[0].open, ledger.accounts()[1].open), (1, 0));
        assert_eq!(ledger.accounts()[1].outcomes.of(Outcome::Late), 1);
        assert!(ledger.is_balanced());
    }

    #[test]
    fn history_is_bounded_and_never_drops_an_open_trigger() {
        let mut ledger = Ledger::new(1);
        for trigger in 0..HISTORY as u64 + 10 {
            ledger.enter(trigger).unwrap();
            if trigger != 3 {
                ledger.settle_all(trigger, Outcome::Complete).unwrap();
            }
        }
        assert!(ledger.entry(0).is_none() && ledger.entry(3).is_some());
        assert_eq!(ledger.enter(0), Err(LedgerError::Entered { trigger: 0 }), "forgotten, not new");
        ledger.settle(3, 0, Outcome::Shed).unwrap();
        assert_eq!(ledger.accounts()[0].triggers, HISTORY as u64 + 10);
        assert!(ledger.is_balanced());
    }
}
