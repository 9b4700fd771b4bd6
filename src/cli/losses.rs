//! Damaged or missing parts of a recorded run, and the end of commands that skip them.

use std::{
    collections::{BTreeMap, BTreeSet},
    fmt,
    path::{Path, PathBuf},
};

use thiserror::Error;

use super::{
    ledger_file::{RunLedger, read_ledger},
    output::count,
};
use crate::acquisition::journal::{RecordedRunError, RunIndex};

/// Largest number of listed shots after the end of the record: a damaged ledger may state any
/// number.
const MAX_LISTED: usize = 1_000_000;

/// Warns if a run that is no longer written to has not ended normally.
pub(super) fn warn_if_cut_off(run: &Path, index: &RunIndex) {
    if index.end.is_none() {
        tracing::warn!(
            "{} was cut off: it is unknown how many shots followed the last recorded one",
            run.display()
        );
    }
}

/// Damaged or missing parts in the record of a run.
#[derive(Debug, Default)]
pub(super) struct Losses {
    run: PathBuf,
    /// Damaged places in the record, in words.
    places: Vec<String>,
    /// Recorded shots that cannot be read, and the reasons.
    shots: BTreeMap<u64, String>,
}

/// The error of a command that has done everything possible with a damaged or incomplete record.
#[derive(Debug, Error)]
pub(super) struct DamagedRecord(Losses);

impl Losses {
    /// Losses found in the record, and those found by comparing it with the run's ledger. The run
    /// must no longer be written to.
    pub fn of(run: &Path, index: &RunIndex) -> Self {
        let mut losses =
            Self { run: run.into(), places: index.damaged.clone(), shots: index.lost.clone() };
        let ledger = match read_ledger(run) {
            Ok(ledger) => ledger,
            Err(error) => {
                losses.places.push(format!("{error:#}"));
                None
            }
        };
        let mut unknown = index.unknown.clone();
        if let Some(ledger) = &ledger {
            losses.compare_with_ledger(ledger, index, &mut unknown);
        }
        for shot in unknown {
            if !ledger.as_ref().is_some_and(|ledger| ledger.without_images.contains(&shot)) {
                let why = "the record does not contain it: see the damaged or missing parts";
                losses.add(shot, why);
            }
        }
        losses
    }

    /// Finds missing records: the record of a run that ended normally has an end, too.
    fn compare_with_ledger(
        &mut self,
        ledger: &RunLedger,
        index: &RunIndex,
        unknown: &mut BTreeSet<u64>,
    ) {
        if !ledger.has_ended {
            return;
        }
        if index.end.is_none() {
            self.places.push(
                "according to ledger.json the run ended normally, but the record breaks off \
                 before that: its last records are missing"
                    .into(),
            );
        }
        if !self.places.is_empty() {
            let last = index.shots.last_key_value().map_or(0, |(shot, _)| shot + 1);
            unknown.extend((last..ledger.triggers).take(MAX_LISTED));
            unknown.retain(|shot| !index.shots.contains_key(shot));
        }
    }

    /// Nothing, so far, of the shots of a run that are read.
    pub fn none_yet(run: &Path) -> Self {
        Self { run: run.into(), ..Self::default() }
    }

    /// Shots that were recorded and cannot be read, and why.
    pub fn shots(&self) -> &BTreeMap<u64, String> {
        &self.shots
    }

    /// Adds a shot that cannot be read.
    pub fn add(&mut self, shot: u64, why: impl fmt::Display) {
        self.shots.entry(shot).or_insert_with(|| why.to_string());
    }

    /// Adds a shot whose images cannot be read.
    ///
    /// # Errors
    /// The error is not one of damaged data.
    pub fn note(&mut self, shot: u64, error: RecordedRunError) -> Result<(), RecordedRunError> {
        if !error.is_damage() {
            return Err(error);
        }
        tracing::error!("shot {shot} is lost: {error}");
        self.add(shot, error);
        Ok(())
    }

    /// Adds a damaged place that belongs to no shot.
    ///
    /// # Errors
    /// The error is not one of damaged data.
    pub fn note_place(&mut self, error: RecordedRunError) -> Result<(), RecordedRunError> {
        if !error.is_damage() {
            return Err(error);
        }
        self.places.push(error.to_string());
        Ok(())
    }

    /// Whether this shot is lost.
    pub fn has(&self, shot: u64) -> bool {
        self.shots.contains_key(&shot)
    }

    /// Keeps only the given shots.
    pub fn only(&mut self, wanted: impl Fn(&u64) -> bool) {
        self.shots.retain(|shot, _| wanted(shot));
    }

    /// Whether nothing is damaged or missing.
    pub fn is_empty(&self) -> bool {
        self.places.is_empty() && self.shots.is_empty()
    }

    /// Logs the losses; called before work on the rest begins.
    pub fn log(&self) {
        for place in &self.places {
            tracing::error!("{place}");
        }
        for (shot, why) in &self.shots {
            tracing::error!("shot {shot} is lost: {why}");
        }
    }

    /// Ends a command that has done everything else.
    ///
    /// # Errors
    /// Something is damaged or missing: [`DamagedRecord`].
    pub fn conclude(self) -> anyhow::Result<()> {
        if self.is_empty() { Ok(()) } else { Err(DamagedRecord(self).into()) }
    }
}

impl fmt::Display for DamagedRecord {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Losses { run, places, shots } = &self.0;
        write!(
            formatter,
            "done, except for damaged or missing parts in the record of {}: {}, {} lost",
            run.display(),
            count(places.len(), "part"),
            count(shots.len(), "shot")
        )?;
        places.iter().try_for_each(|place| write!(formatter, "\n  {place}"))?;
        shots.iter().try_for_each(|(shot, why)| write!(formatter, "\n  shot {shot}: {why}"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::acquisition::journal::RunEnd;

    fn ledger(run: &Path, error: &str) {
        let text = format!(
            r#"{{"error": {error}, "cameras": [{{"triggers": 4}}], "exceptions": [
                {{"trigger": 2, "cameras": ["missed_trigger", "unpaired"]}},
                {{"trigger": 3, "cameras": ["shed", "shed"]}}]}}"#
        );
        std::fs::write(run.join("ledger.json"), text).unwrap();
    }

    #[test]
    fn shots_in_the_ledger_but_not_in_the_record_are_missing() {
        let run = tempfile::tempdir().unwrap();
        ledger(run.path(), "null");
        let losses = Losses::of(run.path(), &RunIndex::default());
        assert_eq!(losses.shots.keys().copied().collect::<Vec<_>>(), [0, 1, 3]);
        let words = losses.conclude().unwrap_err().to_string();
        assert!(words.contains("the record breaks off") && words.contains("shot 3:"), "{words}");
    }

    #[test]
    fn nothing_is_missing_after_a_cut_off_or_with_a_recorded_end() {
        let run = tempfile::tempdir().unwrap();
        ledger(run.path(), r#""the disk was full""#);
        assert!(Losses::of(run.path(), &RunIndex::default()).is_empty());
        ledger(run.path(), "null");
        let index = RunIndex { end: Some(RunEnd { error: None }), ..RunIndex::default() };
        assert!(Losses::of(run.path(), &index).is_empty());
    }

    #[test]
    fn a_trigger_without_images_is_not_a_lost_shot() {
        let run = tempfile::tempdir().unwrap();
        ledger(run.path(), r#""the disk was full""#);
        let index = RunIndex {
            damaged: vec!["a record".into()],
            unknown: BTreeSet::from([1, 2]),
            ..RunIndex::default()
        };
        let losses = Losses::of(run.path(), &index);
        assert!(losses.has(1) && !losses.has(2));
    }
}
