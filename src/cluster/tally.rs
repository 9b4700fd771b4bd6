//! Who was first, and how often a shot was tried.
//!
//! A function of the reports: their order decides which of several results is the first, and nothing else. A
//! report that arrives twice counts once.

#[cfg(test)]
mod properties;

use std::collections::{BTreeMap, BTreeSet, btree_map::Entry};

use serde::{Deserialize, Serialize};

/// Reported failures after which a shot is given up.
const MOST_FAILURES: usize = 3;
/// Lost workers after which a shot is given up: it may be what kills them.
const MOST_LOST: usize = 10;

/// One worker's try at a shot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub struct Attempt {
    /// How often the coordinator had offered the shot, from 1.
    pub issue: u32,
    /// How often the broker had handed this offer out, from 1.
    pub delivery: u32,
}

/// What is reported of a shot.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(tag = "report", rename_all = "snake_case")]
pub enum Report {
    /// A worker begins to measure it.
    Begun { attempt: Attempt, worker: String },
    /// A worker has measured it.
    Delivered { attempt: Attempt, worker: String, result_sha256: String },
    /// A worker could not measure it.
    Failed { attempt: Attempt, worker: String, reason: String },
    /// Its images cannot be read, by the coordinator itself.
    Unreadable { reason: String },
}

/// What a report means.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// The shot's first result, which counts.
    First,
    /// The same result once more.
    Duplicate,
    /// Another result of a shot that has one: the machines do not compute alike.
    Unequal,
    /// No result.
    Noted,
    /// No shot that is to be measured.
    Unknown,
}

/// Where a shot stands.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ShotState {
    /// It is to be measured.
    Open,
    /// It has a result.
    Done,
    /// It is on the dead-letter list, for these reasons.
    Dead(Vec<String>),
}

/// How often a worker has tried to measure a shot.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Tries {
    pub begun: u64,
    /// Of them: it has reported that it could not.
    pub failed: u64,
    /// Of them: the broker has handed the shot to another one since.
    pub not_ended: u64,
}

/// All shots to be measured and what was reported of them.
#[derive(Debug, Clone, Default)]
pub struct Tally {
    shots: BTreeMap<u64, ShotTally>,
    /// Those still to be measured: a long run has many that are not.
    open: BTreeSet<u64>,
}

#[derive(Debug, Clone, Default)]
struct ShotTally {
    attempts: BTreeMap<Attempt, Try>,
    /// Hash and maker of the first result.
    first: Option<(String, String)>,
    /// Hashes and makers of other results.
    unequal: BTreeSet<(String, String)>,
    unreadable: Option<String>,
}

#[derive(Debug, Clone, Default)]
struct Try {
    worker: String,
    failed: Option<String>,
    delivered: bool,
}

impl Tally {
    /// Of these shots, of which nothing was reported yet.
    pub fn of(shots: impl IntoIterator<Item = u64>) -> Self {
        let mut tally = Self::default();
        shots.into_iter().for_each(|shot| tally.add(shot));
        tally
    }

    /// Another shot is to be measured. What was reported of one that is there already stays.
    pub fn add(&mut self, shot: u64) {
        if let Entry::Vacant(place) = self.shots.entry(shot) {
            place.insert(ShotTally::default());
            self.open.insert(shot);
        }
    }

    /// Takes a report in.
    pub fn take(&mut self, shot: u64, report: &Report) -> Verdict {
        let Some(tally) = self.shots.get_mut(&shot) else { return Verdict::Unknown };
        let verdict = tally.take(report);
        match tally.is_open() {
            true => self.open.insert(shot),
            false => self.open.remove(&shot),
        };
        verdict
    }

    /// Where a shot stands; `None` if it is not to be measured.
    pub fn state(&self, shot: u64) -> Option<ShotState> {
        self.shots.get(&shot).map(ShotTally::state)
    }

    /// Shots that are still to be measured, in their order.
    pub fn open(&self) -> impl ExactSizeIterator<Item = u64> {
        self.open.iter().copied()
    }

    /// Shots whose images cannot be read, and why.
    pub fn unreadable(&self) -> BTreeMap<u64, String> {
        let unreadable = self.shots.iter().filter(|(_, tally)| tally.first.is_none());
        unreadable.filter_map(|(shot, tally)| Some((*shot, tally.unreadable.clone()?))).collect()
    }

    /// The dead-letter list: shots that were given up, and why.
    pub fn dead(&self) -> BTreeMap<u64, Vec<String>> {
        let dead = self.shots.iter().filter_map(|(shot, tally)| match tally.state() {
            ShotState::Dead(reasons) => Some((*shot, reasons)),
            _ => None,
        });
        dead.collect()
    }

    /// Shots with unequal results, and which machines have made them.
    pub fn unequal(&self) -> BTreeMap<u64, Vec<String>> {
        let several = self.shots.iter().filter(|(_, tally)| !tally.unequal.is_empty());
        let makers = |tally: &ShotTally| {
            let all = tally.first.iter().chain(&tally.unequal);
            all.map(|(sha256, worker)| format!("{worker} ({})", &sha256[..sha256.len().min(12)]))
                .collect()
        };
        several.map(|(shot, tally)| (*shot, makers(tally))).collect()
    }

    /// How many results each worker was first with.
    pub fn by_worker(&self) -> BTreeMap<String, usize> {
        let mut found = BTreeMap::new();
        for (_, worker) in self.shots.values().filter_map(|tally| tally.first.as_ref()) {
            *found.entry(worker.clone()).or_default() += 1;
        }
        found
    }

    /// What each worker has tried.
    pub fn tries_by_worker(&self) -> BTreeMap<&str, Tries> {
        let mut found: BTreeMap<&str, Tries> = BTreeMap::new();
        for tally in self.shots.values() {
            for of in tally.attempts.values() {
                let tries = found.entry(&of.worker).or_default();
                tries.begun += 1;
                tries.failed += u64::from(of.failed.is_some() && !of.delivered);
            }
            for of in tally.lost() {
                found.entry(&of.worker).or_default().not_ended += 1;
            }
        }
        found
    }

    /// Attempts that have begun.
    pub fn attempts(&self) -> usize {
        self.shots.values().map(|tally| tally.attempts.len()).sum()
    }

    /// Workers that were lost over a shot.
    pub fn lost(&self) -> usize {
        self.shots.values().map(|tally| tally.lost().count()).sum()
    }

    /// The largest number of offers that was reported.
    pub fn last_issue(&self) -> u32 {
        let attempts = self.shots.values().filter_map(|tally| tally.attempts.last_key_value());
        attempts.map(|(attempt, _)| attempt.issue).max().unwrap_or(0)
    }
}

impl ShotTally {
    fn take(&mut self, report: &Report) -> Verdict {
        match report {
            Report::Begun { attempt, worker } => drop(self.attempt(*attempt, worker)),
            Report::Failed { attempt, worker, reason } => {
                self.attempt(*attempt, worker).failed.get_or_insert_with(|| reason.clone());
            }
            Report::Unreadable { reason } => {
                self.unreadable.get_or_insert_with(|| reason.clone());
            }
            Report::Delivered { attempt, worker, result_sha256 } => {
                self.attempt(*attempt, worker).delivered = true;
                return self.deliver(result_sha256, worker);
            }
        }
        Verdict::Noted
    }

    fn attempt(&mut self, attempt: Attempt, worker: &str) -> &mut Try {
        let new = || Try { worker: worker.to_owned(), ..Try::default() };
        self.attempts.entry(attempt).or_insert_with(new)
    }

    fn deliver(&mut self, sha256: &str, worker: &str) -> Verdict {
        match &self.first {
            None => {
                self.first = Some((sha256.to_owned(), worker.to_owned()));
                Verdict::First
            }
            Some((first, _)) if first == sha256 => Verdict::Duplicate,
            Some(_) => {
                self.unequal.insert((sha256.to_owned(), worker.to_owned()));
                Verdict::Unequal
            }
        }
    }

    fn is_open(&self) -> bool {
        self.first.is_none() && !self.is_dead()
    }

    fn is_dead(&self) -> bool {
        self.unreadable.is_some()
            || self.failures().count() >= MOST_FAILURES
            || self.lost().count() >= MOST_LOST
    }

    fn failures(&self) -> impl Iterator<Item = String> {
        let failed = self.attempts.values().filter(|of| !of.delivered);
        failed.filter_map(|of| Some(format!("{}: {}", of.worker, of.failed.as_ref()?)))
    }

    /// Attempts without an end that the broker has handed out again since. The last one of an offer may still
    /// go on.
    fn lost(&self) -> impl Iterator<Item = &Try> {
        let is_superseded = |attempt: &Attempt| {
            let later = Attempt { delivery: attempt.delivery.saturating_add(1), ..*attempt };
            let last = Attempt { delivery: u32::MAX, ..*attempt };
            *attempt != last && self.attempts.range(later..=last).next().is_some()
        };
        let endless = self.attempts.iter().filter(|(_, of)| of.failed.is_none() && !of.delivered);
        endless.filter(move |(attempt, _)| is_superseded(attempt)).map(|(_, of)| of)
    }

    fn state(&self) -> ShotState {
        if self.first.is_some() {
            return ShotState::Done;
        }
        if !self.is_dead() {
            return ShotState::Open;
        }
        let lost = self.lost().map(|of| format!("{}: did not end", of.worker));
        ShotState::Dead(
            self.unreadable.iter().cloned().chain(self.failures()).chain(lost).collect(),
        )
    }
}
