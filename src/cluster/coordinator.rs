//! The coordinator's state: it hands records out and takes results in.

use std::{
    collections::{BTreeMap, BTreeSet},
    sync::{Arc, mpsc::SyncSender},
};

use lfpiv_core::{
    model::ModelChoice,
    velocimetry::{VectorGrid, VelocityField},
};
use lfpiv_rawlog::Position;
use parking_lot::Mutex;
use serde::{Deserialize, Serialize};
use tokio::sync::watch;

use super::{
    Assignment, Attempt, ClusterError, Delivery, DeliveryLog, Report, ShotState, Tally, Verdict,
};
use crate::{
    acquisition::journal::{RecordedRun, RecordedRunError, RecordedShot},
    archive::{ShotResult, sha256},
};

/// What a coordinator starts with.
pub struct CoordinatorSetup {
    /// The record.
    pub run: RecordedRun,
    /// The shots to be measured.
    pub shots: Vec<RecordedShot>,
    /// What workers are told of the run.
    pub assignment: Assignment,
    /// The forward model, and where the vectors are, as the reference has them.
    pub model: Arc<ModelChoice>,
    pub grid: VectorGrid,
    /// What earlier coordinators have logged is in the tally already.
    pub tally: Tally,
    pub log: DeliveryLog,
    /// Where first results go, to the one who writes them.
    pub sink: SyncSender<(u64, ShotResult)>,
}

/// Whether a worker is to measure a shot.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Begin {
    /// Yes.
    Measure,
    /// It has a result or was given up, or is no shot of this run: the job is to be removed.
    Settled,
}

/// Hands records out and takes results in. Shared by all requests.
pub struct Coordinator {
    run: RecordedRun,
    shots: BTreeMap<u64, RecordedShot>,
    assignment: Assignment,
    model: Arc<ModelChoice>,
    grid: VectorGrid,
    state: Mutex<State>,
    /// Number of shots that are still to be measured.
    left: watch::Sender<usize>,
}

struct State {
    tally: Tally,
    /// Both are gone once it is closed.
    log: Option<DeliveryLog>,
    sink: Option<SyncSender<(u64, ShotResult)>>,
    workers: BTreeSet<String>,
    refused: usize,
    /// Why nothing can be taken in any more.
    failure: Option<String>,
}

impl Coordinator {
    /// Ready for requests.
    pub fn open(setup: CoordinatorSetup) -> Self {
        let CoordinatorSetup { run, shots, assignment, model, grid, tally, log, sink } = setup;
        let (left, _) = watch::channel(tally.open().count());
        Self {
            run,
            shots: shots.into_iter().map(|shot| (shot.trigger, shot)).collect(),
            assignment,
            model,
            grid,
            state: Mutex::new(State {
                tally,
                log: Some(log),
                sink: Some(sink),
                workers: BTreeSet::new(),
                refused: 0,
                failure: None,
            }),
            left,
        }
    }

    /// What workers are told of the run.
    pub fn assignment(&self) -> &Assignment {
        &self.assignment
    }

    /// A record as it is on disk; for [`lfpiv_rawlog::unpack`].
    ///
    /// # Errors
    /// There is no record.
    pub fn packed(&self, position: Position) -> Result<Vec<u8>, RecordedRunError> {
        self.run.packed(position)
    }

    /// A worker wants to measure a shot.
    ///
    /// # Errors
    /// The log has failed.
    pub fn begin(&self, shot: u64, attempt: Attempt, worker: &str) -> Result<Begin, ClusterError> {
        let report = Report::Begun { attempt, worker: worker.to_owned() };
        let mut state = self.state.lock();
        state.log()?;
        if state.workers.insert(worker.to_owned()) {
            tracing::info!("{worker} has joined");
        }
        if state.tally.state(shot) != Some(ShotState::Open) {
            return Ok(Begin::Settled);
        }
        self.note(&mut state, shot, &report)?;
        // This attempt shows that earlier ones were lost, which may be one too many.
        Ok(match state.tally.state(shot) {
            Some(ShotState::Open) => Begin::Measure,
            _ => Begin::Settled,
        })
    }

    /// A worker could not measure a shot. If its images cannot be read here either, it is lost.
    ///
    /// # Errors
    /// The log has failed.
    pub fn fail(
        &self,
        shot: u64,
        attempt: Attempt,
        worker: &str,
        reason: &str,
    ) -> Result<(), ClusterError> {
        tracing::warn!("{worker} could not measure shot {shot}: {reason}");
        let damage = self.shots.get(&shot).and_then(|shot| self.run.pair(shot).err());
        let report = match damage.filter(RecordedRunError::is_damage) {
            Some(damage) => Report::Unreadable { reason: damage.to_string() },
            None => {
                Report::Failed { attempt, worker: worker.to_owned(), reason: reason.to_owned() }
            }
        };
        self.note(&mut self.state.lock(), shot, &report).map(|_| ())
    }

    /// A shot turns out to be unreadable.
    pub fn unreadable(&self, shot: u64, error: &RecordedRunError) {
        let report = Report::Unreadable { reason: error.to_string() };
        // A failing log ends the coordinator, and the shot is looked at again.
        let _ = self.note(&mut self.state.lock(), shot, &report);
    }

    /// Takes a result in, as [`Delivery::encode`] made it. The first one of a shot is logged and handed on.
    ///
    /// # Errors
    /// [`ClusterError::Refused`]: it is damaged or not one of this run. The log, or the one who writes results,
    /// has failed.
    pub fn deliver(&self, bytes: &[u8]) -> Result<Verdict, ClusterError> {
        let delivery = self.checked(bytes).inspect_err(|error| {
            self.state.lock().refused += 1;
            tracing::error!("{error}");
        })?;
        let (shot, report) = (delivery.shot, delivery.report());
        let mut state = self.state.lock();
        let verdict = state.tally.take(shot, &report);
        let logged = match (verdict, state.log()?) {
            (Verdict::Unknown, _) => return Err(not_wanted(shot)),
            (Verdict::First, log) => log.deliver(bytes),
            (_, log) => log.report(shot, &report),
        };
        logged.inspect_err(|error| self.note_failure(&mut state, error))?;
        let (left, sink) = (state.tally.open().count(), state.sink.clone());
        // Who writes results may be slower than those who deliver them.
        drop(state);
        if verdict == Verdict::Unequal {
            tracing::error!(
                "shot {shot}: {} has delivered another result than the first: the machines do not \
                 compute alike",
                delivery.worker
            );
        }
        let handed_on = |sink: SyncSender<_>| sink.send((shot, delivery.result)).is_ok();
        if verdict == Verdict::First && !sink.is_some_and(handed_on) {
            let error = ClusterError::Broken("results cannot be stored".into());
            self.note_failure(&mut self.state.lock(), &error);
            return Err(error);
        }
        self.left.send_replace(left);
        Ok(verdict)
    }

    /// Decodes and checks a delivered result.
    fn checked(&self, bytes: &[u8]) -> Result<Delivery, ClusterError> {
        let model_sha256 = &self.assignment.reference.model_sha256;
        let delivery = Delivery::decode(bytes, &self.model, model_sha256)?;
        let (shot, field) = (delivery.shot, &delivery.result.measured.field);
        let refused = |what: &str| ClusterError::Refused(format!("shot {shot}: {what}"));
        let recorded = self.shots.get(&shot).ok_or_else(|| not_wanted(shot))?;
        if delivery.result.time != recorded.time || field.dt_s != recorded.dt_us * 1e-6 {
            return Err(refused("its times are not those of the record"));
        }
        if field.grid != self.grid {
            return Err(refused("its vectors are elsewhere than the reference's"));
        }
        match is_finite(field) {
            true => Ok(delivery),
            false => Err(refused("it has numbers that are not finite")),
        }
    }

    fn note(&self, state: &mut State, shot: u64, report: &Report) -> Result<Verdict, ClusterError> {
        let verdict = state.tally.take(shot, report);
        if verdict != Verdict::Unknown {
            let logged = state.log().and_then(|log| log.report(shot, report));
            logged.inspect_err(|error| self.note_failure(state, error))?;
            if let Some(ShotState::Dead(reasons)) = state.tally.state(shot) {
                tracing::error!("shot {shot} is given up: {}", reasons.join("; "));
            }
        }
        self.left.send_replace(state.tally.open().count());
        Ok(verdict)
    }

    fn note_failure(&self, state: &mut State, error: &ClusterError) {
        state.failure.get_or_insert_with(|| error.to_string());
        // Those who wait look again.
        self.left.send_modify(|_| {});
    }

    /// The first shots that are still to be measured, at most `most`.
    pub fn open_shots(&self, most: usize) -> Vec<&RecordedShot> {
        let state = self.state.lock();
        state.tally.open().filter_map(|shot| self.shots.get(&shot)).take(most).collect()
    }

    /// Waits until every shot is settled.
    ///
    /// # Errors
    /// Results can no longer be taken in.
    pub async fn settled(&self) -> Result<(), ClusterError> {
        let mut left = self.left.subscribe();
        loop {
            if let Some(failure) = &self.state.lock().failure {
                return Err(ClusterError::Broken(failure.clone()));
            }
            if *left.borrow_and_update() == 0 {
                return Ok(());
            }
            // The sender lives as long as this.
            let _ = left.changed().await;
        }
    }

    /// Number of shots still to be measured, as it changes.
    pub fn left(&self) -> watch::Receiver<usize> {
        self.left.subscribe()
    }

    /// Number of workers that have begun a shot.
    pub fn workers(&self) -> usize {
        self.state.lock().workers.len()
    }

    /// Takes nothing in any more. The tally, the number of refused results, and the log.
    pub fn close(&self) -> (Tally, usize, Option<DeliveryLog>) {
        let mut state = self.state.lock();
        state.sink = None;
        (state.tally.clone(), state.refused, state.log.take())
    }
}

impl State {
    fn log(&self) -> Result<&DeliveryLog, ClusterError> {
        match (&self.failure, &self.log) {
            (None, Some(log)) => Ok(log),
            (Some(failure), _) => Err(ClusterError::Broken(failure.clone())),
            (None, None) => Err(ClusterError::Broken("the coordinator has ended".into())),
        }
    }
}

fn not_wanted(shot: u64) -> ClusterError {
    ClusterError::Refused(format!("shot {shot} is not to be measured"))
}

/// Whether all numbers of a field are.
fn is_finite(field: &VelocityField) -> bool {
    let triples = [&field.displacement_vox, &field.uncertainty_vox, &field.vorticity];
    let numbers = [&field.peak_ratio, &field.divergence];
    triples.iter().all(|triples| triples.iter().flatten().all(|number| number.is_finite()))
        && numbers.iter().all(|numbers| numbers.iter().all(|number| number.is_finite()))
}

/// The hash by which a forward model's choice goes.
pub fn model_sha256(model: &ModelChoice) -> String {
    sha256(model.to_json().as_bytes())
}
