//! The coordinator's state: it hands records out and takes results in.

mod view;

use std::{
    borrow::Cow,
    collections::BTreeMap,
    sync::Arc,
    time::{Duration, Instant},
};

use lfpiv_core::{model::ModelChoice, velocimetry::VectorGrid};
use lfpiv_rawlog::Position;
use parking_lot::Mutex;
use serde::{Deserialize, Serialize};
use tokio::sync::{Notify, watch};

use super::{
    Assignment, Attempt, ClusterError, Delivery, DeliveryLog, Report, ShotState, Tally, Verdict,
    crew::Crew, expected::Expected, remaining::Remaining,
};
use crate::{
    acquisition::journal::{RecordedRun, RecordedRunError, RecordedShot},
    archive::{ShotResult, sha256},
};

/// Takes the first result of a shot, and may wait until there is room. False: it cannot be stored.
pub type ResultTaker = Box<dyn Fn(u64, ShotResult) -> bool + Send + Sync>;

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
    /// A worker without a heartbeat for so long is lost.
    pub heartbeat_timeout: Duration,
    /// Voxels along x, y, z, where the projections of the light are wanted, to look at.
    pub light: Option<[usize; 3]>,
    /// Where first results go, to the one who writes them.
    pub sink: ResultTaker,
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
    assignment: Assignment,
    expected: Expected,
    state: Mutex<State>,
    /// Told of shots that were added.
    added: Notify,
}

struct State {
    shots: BTreeMap<u64, RecordedShot>,
    tally: Tally,
    remaining: Remaining,
    /// Both are gone once it is closed.
    log: Option<DeliveryLog>,
    sink: Option<Arc<ResultTaker>>,
    crew: Crew,
    refused: usize,
    /// Why nothing can be taken in any more.
    failure: Option<String>,
}

impl Coordinator {
    /// Ready for requests.
    pub fn open(setup: CoordinatorSetup) -> Self {
        let CoordinatorSetup {
            run,
            shots,
            assignment,
            model,
            grid,
            tally,
            log,
            heartbeat_timeout,
            light,
            sink,
        } = setup;
        let remaining = Remaining::of(tally.open().len());
        Self {
            run,
            expected: Expected {
                model,
                model_sha256: assignment.reference.model_sha256.clone(),
                grid,
                light,
            },
            assignment,
            state: Mutex::new(State {
                shots: shots.into_iter().map(|shot| (shot.trigger, shot)).collect(),
                remaining,
                tally,
                log: Some(log),
                sink: Some(Arc::new(sink)),
                crew: Crew::new(heartbeat_timeout),
                refused: 0,
                failure: None,
            }),
            added: Notify::new(),
        }
    }

    /// What workers are told of the run.
    pub fn assignment(&self) -> &Assignment {
        &self.assignment
    }

    /// The record.
    pub fn run(&self) -> &RecordedRun {
        &self.run
    }

    /// Another shot is to be measured: its record is on disk.
    pub fn add(&self, shot: RecordedShot) {
        let mut state = self.state.lock();
        state.tally.add(shot.trigger);
        state.shots.insert(shot.trigger, shot);
        state.count_open();
        self.added.notify_one();
    }

    /// Completes when a shot was added since the last call.
    pub async fn added(&self) {
        self.added.notified().await;
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
        state.see(worker, Instant::now());
        if state.tally.state(shot) != Some(ShotState::Open) {
            return Ok(Begin::Settled);
        }
        self.note(&mut state, shot, &report)?;
        // This attempt shows that earlier ones were lost, which may be one too many.
        Ok(match state.tally.state(shot) {
            Some(ShotState::Open) => {
                state.crew.begin(worker, shot);
                Begin::Measure
            }
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
        let recorded = self.recorded(shot);
        let damage = recorded.and_then(|shot| self.run.pair(&shot).err());
        let report = match damage.filter(RecordedRunError::is_damage) {
            Some(damage) => Report::Unreadable { reason: damage.to_string() },
            None => {
                Report::Failed { attempt, worker: worker.to_owned(), reason: reason.to_owned() }
            }
        };
        let mut state = self.state.lock();
        state.see(worker, Instant::now());
        state.crew.end(worker, shot);
        self.note(&mut state, shot, &report).map(|_| ())
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
        let mut delivery = self.checked(bytes).inspect_err(|error| {
            self.state.lock().refused += 1;
            tracing::error!("{error}");
        })?;
        let light = delivery.take_light();
        let logged = if light.is_some() { Cow::from(delivery.encode()) } else { bytes.into() };
        let (shot, report) = (delivery.shot, delivery.report());
        let mut state = self.state.lock();
        let (now, worker) = (Instant::now(), &delivery.worker);
        let verdict = state.tally.take(shot, &report);
        state.see(worker, now);
        state.crew.end(worker, shot);
        if verdict == Verdict::First {
            state.crew.count(worker, now);
        }
        let logged = match (verdict, state.log()?) {
            (Verdict::Unknown, _) => return Err(not_wanted(shot)),
            (Verdict::First, log) => log.deliver(&logged),
            (_, log) => log.report(shot, &report),
        };
        logged.inspect_err(|error| self.note_failure(&mut state, error))?;
        let sink = state.sink.clone();
        if verdict == Verdict::First {
            state.remaining.take_in();
            state.count_open();
        }
        // Who writes results may be slower than those who deliver them.
        drop(state);
        if verdict == Verdict::Unequal {
            tracing::error!(
                "shot {shot}: {} has delivered another result than the first: the machines do not \
                 compute alike",
                delivery.worker
            );
        }
        if verdict == Verdict::First {
            delivery.result.measured.light = light;
            self.hand_on(shot, delivery.result, sink)?;
        }
        Ok(verdict)
    }

    /// Gives a result to the one who writes it.
    fn hand_on(
        &self,
        shot: u64,
        result: ShotResult,
        sink: Option<Arc<ResultTaker>>,
    ) -> Result<(), ClusterError> {
        let is_stored = sink.is_some_and(|sink| sink(shot, result));
        let mut state = self.state.lock();
        if !is_stored {
            let error = ClusterError::Broken("results cannot be stored".into());
            self.note_failure(&mut state, &error);
            return Err(error);
        }
        state.remaining.handed_on();
        Ok(())
    }

    /// Decodes and checks a delivered result.
    fn checked(&self, bytes: &[u8]) -> Result<Delivery, ClusterError> {
        let delivery = self.expected.decode(bytes)?;
        let shot = delivery.shot;
        let recorded = self.recorded(shot).ok_or_else(|| not_wanted(shot))?;
        self.expected.check(delivery, &recorded)
    }

    fn recorded(&self, shot: u64) -> Option<RecordedShot> {
        self.state.lock().shots.get(&shot).cloned()
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
        state.count_open();
        Ok(verdict)
    }

    fn note_failure(&self, state: &mut State, error: &ClusterError) {
        state.failure.get_or_insert_with(|| error.to_string());
        state.remaining.tell();
    }

    /// The first shots that are still to be measured, at most `most`.
    pub fn open_shots(&self, most: usize) -> Vec<RecordedShot> {
        let state = self.state.lock();
        state.tally.open().filter_map(|shot| state.shots.get(&shot)).take(most).cloned().collect()
    }

    /// Whether a shot is still to be measured.
    pub fn is_open(&self, shot: u64) -> bool {
        self.state.lock().tally.state(shot) == Some(ShotState::Open)
    }

    /// Waits until every shot is settled, and its result with the one who writes it.
    ///
    /// # Errors
    /// Results can no longer be taken in.
    pub async fn settled(&self) -> Result<(), ClusterError> {
        self.wait(|left| left == 0).await
    }

    /// Waits for ever, unless it fails.
    ///
    /// # Errors
    /// Results can no longer be taken in.
    pub async fn failed(&self) -> Result<(), ClusterError> {
        self.wait(|_| false).await
    }

    async fn wait(&self, is_over: impl Fn(usize) -> bool) -> Result<(), ClusterError> {
        let mut left = self.left();
        loop {
            if let Some(failure) = &self.state.lock().failure {
                return Err(ClusterError::Broken(failure.clone()));
            }
            if is_over(*left.borrow_and_update()) {
                return Ok(());
            }
            // The sender lives as long as this.
            let _ = left.changed().await;
        }
    }

    /// Number of shots still to be measured or handed on, as it changes.
    pub fn left(&self) -> watch::Receiver<usize> {
        self.state.lock().remaining.subscribe()
    }

    /// Takes nothing in any more. The tally, the number of refused results, and the log.
    pub fn close(&self) -> (Tally, usize, Option<DeliveryLog>) {
        let mut state = self.state.lock();
        state.sink = None;
        (state.tally.clone(), state.refused, state.log.take())
    }
}

impl State {
    fn see(&mut self, worker: &str, now: Instant) {
        if self.crew.see(worker, now) {
            tracing::info!("{worker} has joined");
        }
    }

    /// Tells those who wait how many shots are now to be measured.
    fn count_open(&mut self) {
        self.remaining.set_open(self.tally.open().len());
    }

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

/// The hash by which a forward model's choice goes.
pub fn model_sha256(model: &ModelChoice) -> String {
    sha256(model.to_json().as_bytes())
}
