//! Shots of a recorded run to results, all by one forward model.

use std::collections::BTreeMap;

use anyhow::bail;
use lfpiv_core::{
    lightfield::ImagePair,
    measurement::Processor,
    model::{ModelChoice, ModelMode},
    velocimetry::PairResult,
};
use serde::{Deserialize, Serialize};
use tokio_util::sync::CancellationToken;

use super::{
    losses::Losses,
    output::{count, progress_bar},
    run_processor::run_processor,
};
use crate::{
    acquisition::journal::{RecordedRun, RecordedShot, RunIndex},
    archive::{RawLevel, ResultStore, ShotResult, ShotTime, StoredResults},
    cluster::model_sha256,
    config::Config,
};

/// What came of the shots that had no result.
#[derive(Debug, Default)]
pub(super) struct Finished {
    /// Shots that could not be measured, and why.
    pub failed: BTreeMap<u64, String>,
    /// Shots that were not looked at.
    pub left: usize,
}

impl Finished {
    /// The end of a command that has written everything else.
    ///
    /// # Errors
    /// It was interrupted, or shots gave no result.
    pub fn conclude(self) -> anyhow::Result<()> {
        if self.left > 0 {
            bail!(
                "interrupted: {} without a result remain; repeat the command to measure them",
                count(self.left, "shot")
            );
        }
        if self.failed.is_empty() {
            return Ok(());
        }
        let failures = self.failed.iter();
        let listed: String =
            failures.map(|(shot, why)| format!("\n  shot {shot}: {why}")).collect();
        bail!("{} gave no result{listed}", count(self.failed.len(), "shot"))
    }
}

/// Which shot decided the forward model, and what it decided.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Decision {
    pub shot: u64,
    /// The hash of the choice with its numbers, as results have it.
    pub model_sha256: String,
}

impl Decision {
    /// Nothing where the shot showed no particles: another one decides.
    fn by(shot: u64, model: &ModelChoice) -> Option<Self> {
        model.scene.is_some().then(|| Self { shot, model_sha256: model_sha256(model) })
    }
}

/// Measures shots of a run.
pub(super) struct ShotProcessor<'a> {
    recorded: &'a RecordedRun,
    processor: Processor,
    /// Whether a shot decides the forward model; the configuration may.
    is_chosen: bool,
    decision: Option<Decision>,
}

impl<'a> ShotProcessor<'a> {
    /// The processor, with the forward model that the run's first result decided.
    pub fn prepare(
        config: &Config,
        recorded: &'a RecordedRun,
        index: &RunIndex,
        stored: &StoredResults,
    ) -> anyhow::Result<Self> {
        let processor = run_processor(config)?;
        let is_chosen = config.model.mode != ModelMode::Explicit;
        let mut prepared = Self { recorded, processor, is_chosen, decision: None };
        let candidates = stored.first.iter().chain(&stored.shots);
        let candidates = candidates.filter_map(|number| index.shots.get(number));
        for shot in candidates.filter(|_| is_chosen) {
            match recorded.pair(shot) {
                Ok(pair) => {
                    let model = prepared.processor.process(pair)?.model;
                    prepared.decision = Decision::by(shot.trigger, &model);
                    break;
                }
                Err(error) => tracing::warn!("{error}: another shot decides the forward model"),
            }
        }
        Ok(prepared)
    }

    /// What decided the forward model, as far as it is decided.
    pub fn decision(&self) -> Option<&Decision> {
        self.decision.as_ref()
    }

    /// Measures those of `missing` that are wanted, and stores their results. As long as no shot has decided
    /// the forward model, the others are looked at, too: the same one decides, whichever are wanted.
    pub fn measure(
        &mut self,
        missing: &[&RecordedShot],
        is_wanted: impl Fn(u64) -> bool,
        losses: &mut Losses,
        mut store: ResultStore,
        stop: &CancellationToken,
    ) -> anyhow::Result<Finished> {
        let left = missing.iter().filter(|shot| is_wanted(shot.trigger)).count();
        let bar = progress_bar(left, "shots");
        let mut finished = Finished { left, ..Finished::default() };
        for shot in missing {
            let wanted = is_wanted(shot.trigger);
            if !wanted && (!self.is_chosen || self.decision.is_some()) {
                continue;
            }
            if stop.is_cancelled() {
                break;
            }
            match self.recorded.pair(shot).map(|pair| self.measure_one(shot, pair)) {
                Err(error) if !wanted && error.is_damage() => {
                    tracing::warn!("{error}: another shot decides the forward model");
                    continue;
                }
                Ok(_) if !wanted => continue,
                Ok(Ok(result)) => {
                    store.append(shot.trigger, &result)?;
                }
                Ok(Err(error)) => {
                    finished.failed.insert(shot.trigger, format!("{error:#}"));
                }
                Err(error) => losses.note(shot.trigger, error)?,
            }
            finished.left -= 1;
            bar.inc(1);
        }
        bar.finish_and_clear();
        store.close()?;
        Ok(finished)
    }

    /// Measures a shot that can stand for all: the one that has decided the forward model, or decides it.
    /// Shots of `missing` before it are measured and stored, too, as it is itself if it is one of them; they
    /// are all those without a result in `left`. Nothing if no shot decides, or `stop` is cancelled.
    pub fn reference(
        &mut self,
        index: &RunIndex,
        missing: &[&RecordedShot],
        losses: &mut Losses,
        finished: &mut Finished,
        (store, stop): (&mut ResultStore, &CancellationToken),
    ) -> anyhow::Result<Option<(RecordedShot, ShotResult)>> {
        if let Some(shot) = self.decision.as_ref().and_then(|by| index.shots.get(&by.shot)) {
            let result = self.measure_one(shot, self.recorded.pair(shot)?)?;
            return Ok(Some((shot.clone(), result)));
        }
        for shot in missing {
            if stop.is_cancelled() {
                return Ok(None);
            }
            finished.left -= 1;
            match self.recorded.pair(shot).map(|pair| self.measure_one(shot, pair)) {
                Ok(Ok(result)) => {
                    store.append(shot.trigger, &result)?;
                    if !self.is_chosen || self.decision.is_some() {
                        return Ok(Some(((*shot).clone(), result)));
                    }
                }
                Ok(Err(error)) => {
                    finished.failed.insert(shot.trigger, format!("{error:#}"));
                }
                Err(error) => losses.note(shot.trigger, error)?,
            }
        }
        Ok(None)
    }

    fn measure_one(&mut self, shot: &RecordedShot, pair: ImagePair) -> anyhow::Result<ShotResult> {
        let measured = self.processor.process(pair)?;
        if self.is_chosen && self.decision.is_none() {
            self.decision = Decision::by(shot.trigger, &measured.model);
        }
        Ok(shot_result(measured, shot.dt_us, &shot.suspect, shot.time))
    }
}

/// The measurement of a recorded shot, with what the record says of it.
pub(super) fn shot_result(
    mut measured: PairResult,
    dt_us: f64,
    suspect: &[String],
    time: Option<ShotTime>,
) -> ShotResult {
    measured.field.dt_s = dt_us * 1e-6;
    let words = suspect.iter().map(|words| format!("suspect: {words}"));
    measured.warnings.extend(words);
    ShotResult { measured, time, raw: RawLevel::Synced }
}
