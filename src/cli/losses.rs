//! What of a recorded run cannot be read any more, and how a command ends that read around it.

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

/// Shots behind the end of the record that are named: a ledger that is damaged itself may count any
/// number.
const MOST_NAMED: usize = 1_000_000;

/// Says of a run that nobody writes any more that it has not ended in order, where that is so.
pub(super) fn tell_cut_off(run: &Path, index: &RunIndex) {
    if index.end.is_none() {
        tracing::warn!(
            "{} was cut off: nothing says how many shots followed the last one that is there",
            run.display()
        );
    }
}

/// What is damaged or missing in the record of a run.
#[derive(Debug, Default)]
pub(super) struct Losses {
    run: PathBuf,
    /// Places in the record, in words.
    places: Vec<String>,
    /// Shots that were recorded and cannot be read, and why.
    shots: BTreeMap<u64, String>,
}

/// Everything was done that could be done with a record that is damaged or incomplete.
#[derive(Debug, Error)]
pub(super) struct DamagedRecord(Losses);

impl Losses {
    /// What the record itself shows, and what the run's ledger says beyond it. The record is of a
    /// run that nobody writes any more.
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
            losses.hold_against(ledger, index, &mut unknown);
        }
        for shot in unknown {
            if !ledger.as_ref().is_some_and(|ledger| ledger.without_images.contains(&shot)) {
                let why = "nothing of it is in the record: see what is damaged or missing there";
                losses.lose(shot, why);
            }
        }
        losses
    }

    /// A run that wrote its ledger and ended as it should has an end in its record, too.
    fn hold_against(&mut self, ledger: &RunLedger, index: &RunIndex, unknown: &mut BTreeSet<u64>) {
        if !ledger.has_ended {
            return;
        }
        if index.end.is_none() {
            self.places.push(
                "ledger.json says that the run ended as it should, and the record breaks off \
                 before that: its last records are missing"
                    .into(),
            );
        }
        if !self.places.is_empty() {
            let last = index.shots.last_key_value().map_or(0, |(shot, _)| shot + 1);
            unknown.extend((last..ledger.triggers).take(MOST_NAMED));
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

    /// Notes a shot that cannot be read.
    pub fn lose(&mut self, shot: u64, why: impl fmt::Display) {
        self.shots.entry(shot).or_insert_with(|| why.to_string());
    }

    /// Notes a shot whose images cannot be read.
    ///
    /// # Errors
    /// The error is of another kind.
    pub fn note(&mut self, shot: u64, error: RecordedRunError) -> Result<(), RecordedRunError> {
        if !error.is_damage() {
            return Err(error);
        }
        tracing::error!("shot {shot} is lost: {error}");
        self.lose(shot, error);
        Ok(())
    }

    /// Notes a place in the record that cannot be read and belongs to no shot.
    ///
    /// # Errors
    /// The error is of another kind.
    pub fn note_place(&mut self, error: RecordedRunError) -> Result<(), RecordedRunError> {
        if !error.is_damage() {
            return Err(error);
        }
        self.places.push(error.to_string());
        Ok(())
    }

    /// Whether this shot is among those lost.
    pub fn has(&self, shot: u64) -> bool {
        self.shots.contains_key(&shot)
    }

    /// Only these shots are of interest.
    pub fn only(&mut self, wanted: impl Fn(&u64) -> bool) {
        self.shots.retain(|shot, _| wanted(shot));
    }

    /// Whether nothing is damaged or missing.
    pub fn is_empty(&self) -> bool {
        self.places.is_empty() && self.shots.is_empty()
    }

    /// Says what the record lacks, before work on the rest begins.
    pub fn tell(&self) {
        for place in &self.places {
            tracing::error!("{place}");
        }
        for (shot, why) in &self.shots {
            tracing::error!("shot {shot} is lost: {why}");
        }
    }

    /// The end of a command that has done everything else.
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
            "done, except for what is damaged or missing in the record of {}: {} in it, {} lost",
            run.display(),
            count(places.len(), "place"),
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
    fn what_the_ledger_says_beyond_the_record_is_missing() {
        let run = tempfile::tempdir().unwrap();
        ledger(run.path(), "null");
        let losses = Losses::of(run.path(), &RunIndex::default());
        assert_eq!(losses.shots.keys().copied().collect::<Vec<_>>(), [0, 1, 3]);
        let words = losses.conclude().unwrap_err().to_string();
        assert!(words.contains("the record breaks off") && words.contains("shot 3:"), "{words}");
    }

    #[test]
    fn a_run_that_was_cut_off_or_has_its_end_lacks_nothing() {
        let run = tempfile::tempdir().unwrap();
        ledger(run.path(), r#""the disk was full""#);
        assert!(Losses::of(run.path(), &RunIndex::default()).is_empty());
        ledger(run.path(), "null");
        let index = RunIndex { end: Some(RunEnd { error: None }), ..RunIndex::default() };
        assert!(Losses::of(run.path(), &index).is_empty());
    }

    #[test]
    fn a_trigger_that_gave_no_images_is_no_lost_shot() {
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
