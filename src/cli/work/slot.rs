//! One job after the other.

use std::{
    collections::HashMap,
    path::PathBuf,
    sync::Arc,
    time::{Duration, Instant},
};

use anyhow::{Context, bail};
use parking_lot::Mutex;
use tokio::task::JoinHandle;
use tokio_util::sync::CancellationToken;

use super::{prepared::Prepared, signs::Signs};
use crate::cluster::{
    Attempt, Begin, ClientError, CoordinatorClient, Delivery, Job, JobQueue, PROTOCOL, TakenJob,
    Tokens, Verdict,
};

/// Pause while there is no broker, and before a shot is tried again.
const PAUSE: Duration = Duration::from_millis(500);
/// How long a coordinator that does not answer is left alone. Jobs of others are not held up by it.
const UNREACHABLE_PAUSE: Duration = Duration::from_secs(5);
/// Tries at delivering a result that is made already, and the pause between them.
const DELIVERIES: usize = 5;

/// What all slots share.
pub(super) struct Worker {
    name: String,
    queue: JobQueue,
    shared: Option<PathBuf>,
    /// The run that was measured last, and its jobs' common part.
    prepared: Mutex<Option<(Common, Arc<Prepared>)>>,
    /// Coordinators that did not answer, and when.
    unreachable: Mutex<HashMap<String, Instant>>,
    signs: Arc<Signs>,
}

/// What jobs of one run and coordinator have in common.
type Common = (String, String, Tokens);

/// What became of a job.
enum Ended {
    /// Its shot is settled, or nobody knows it any more.
    Settled,
    /// Someone else, or this worker later, may have better luck.
    Later,
    /// Its coordinator does not answer.
    Unreachable,
}

impl Worker {
    pub fn new(name: String, queue: JobQueue, shared: Option<PathBuf>) -> Self {
        let signs = Arc::new(Signs::of(&name));
        let (prepared, unreachable) = (Mutex::new(None), Mutex::default());
        Self { name, queue, shared, prepared, unreachable, signs }
    }

    /// What its coordinators are told of it.
    pub fn signs(&self) -> Arc<Signs> {
        self.signs.clone()
    }

    /// Takes and does jobs until `stop` is cancelled.
    ///
    /// # Errors
    /// This worker is not fit for a run: others must have its jobs.
    pub async fn serve_slot(self: Arc<Self>, stop: CancellationToken) -> anyhow::Result<()> {
        while !stop.is_cancelled() {
            match self.queue.take().await {
                Ok(Some(taken)) => self.clone().serve_job(taken).await?,
                Ok(None) => {}
                Err(error) => {
                    tracing::debug!("{error}");
                    tokio::select! {
                        () = tokio::time::sleep(PAUSE) => {}
                        () = stop.cancelled() => {}
                    }
                }
            }
        }
        Ok(())
    }

    async fn serve_job(self: Arc<Self>, taken: TakenJob) -> anyhow::Result<()> {
        let (job, attempt) = (taken.job.clone(), taken.attempt);
        let shot = job.shot.number;
        let worker = self.clone();
        let measuring = tokio::task::spawn_blocking(move || worker.measure(&job, attempt));
        let measured = keep_alive(&taken, measuring).await;
        let ended = match measured {
            Ok(measured) => measured,
            Err(panic) => {
                let (job, worker) = (taken.job.clone(), self.clone());
                let reason = format!("the measurement has panicked: {panic}");
                let told = move || worker.tell_failure(&job, attempt, &reason);
                tokio::task::spawn_blocking(told).await.context("a thread has failed")
            }
        };
        let told = match &ended {
            Ok(Ended::Settled) => taken.done().await,
            Ok(Ended::Later) | Err(_) => taken.give_back(PAUSE).await,
            Ok(Ended::Unreachable) => taken.give_back(UNREACHABLE_PAUSE).await,
        };
        if let Err(error) = told {
            tracing::debug!("shot {shot}: {error}");
        }
        ended.map(|_| ())
    }

    /// Measures and delivers a shot. Blocks.
    ///
    /// # Errors
    /// This worker is not fit for the run.
    fn measure(&self, job: &Job, attempt: Attempt) -> anyhow::Result<Ended> {
        let is_recent = |since: &Instant| since.elapsed() < UNREACHABLE_PAUSE;
        if self.unreachable.lock().get(&job.address).is_some_and(is_recent) {
            return Ok(Ended::Unreachable);
        }
        let client = CoordinatorClient::new(&job.address, &job.tokens);
        let shot = job.shot.number;
        match self.try_measuring(job, attempt, &client) {
            Ok(verdict) => {
                if let Some(verdict) = verdict {
                    tracing::debug!("shot {shot} is delivered: {verdict:?}");
                }
                Ok(Ended::Settled)
            }
            Err(error) => match error.downcast::<Unfit>() {
                Ok(unfit) => Err(unfit.0.context(format!("this worker refuses {}", job.run_name))),
                Err(error) => Ok(self.ended(job, attempt, &error)),
            },
        }
    }

    fn ended(&self, job: &Job, attempt: Attempt, error: &anyhow::Error) -> Ended {
        match error.downcast_ref() {
            Some(ClientError::Stale(why)) => {
                tracing::debug!("shot {}: {why}", job.shot.number);
                Ended::Settled
            }
            Some(ClientError::Unreachable(why)) => {
                let known = self.unreachable.lock().insert(job.address.clone(), Instant::now());
                if known.is_none() {
                    tracing::warn!("shot {} at {}: {why}", job.shot.number, job.address);
                }
                Ended::Unreachable
            }
            _ => self.tell_failure(job, attempt, &format!("{error:#}")),
        }
    }

    fn tell_failure(&self, job: &Job, attempt: Attempt, reason: &str) -> Ended {
        let shot = job.shot.number;
        tracing::warn!("shot {shot} cannot be measured: {reason}");
        let client = CoordinatorClient::new(&job.address, &job.tokens);
        if let Err(error) = client.fail(shot, attempt, &self.name, reason) {
            tracing::warn!("shot {shot}: {error}");
        }
        Ended::Later
    }

    /// `None`: the shot was settled before.
    fn try_measuring(
        &self,
        job: &Job,
        attempt: Attempt,
        client: &CoordinatorClient,
    ) -> anyhow::Result<Option<Verdict>> {
        let prepared = self.prepare(job, client)?;
        let shot = &job.shot;
        if client.begin(shot.number, attempt, &self.name)? == Begin::Settled {
            return Ok(None);
        }
        self.unreachable.lock().remove(&job.address);
        self.signs.know(job);
        let result = prepared.measure(client, shot)?;
        let delivery = Delivery {
            shot: shot.number,
            attempt,
            worker: self.name.clone(),
            model_sha256: job.model_sha256.clone(),
            result,
        };
        let bytes = delivery.encode();
        let mut tries = 1;
        loop {
            match client.deliver(&bytes) {
                Err(ClientError::Unreachable(why)) if tries < DELIVERIES => {
                    tracing::debug!("shot {}: {why}", shot.number);
                    tries += 1;
                    std::thread::sleep(PAUSE);
                }
                delivered => return Ok(Some(delivered?)),
            }
        }
    }

    /// The job's run, ready to be measured. Other slots wait.
    fn prepare(&self, job: &Job, client: &CoordinatorClient) -> anyhow::Result<Arc<Prepared>> {
        let common = (job.run.clone(), job.address.clone(), job.tokens.clone());
        let mut prepared = self.prepared.lock();
        if let Some((of, prepared)) = prepared.as_ref()
            && *of == common
        {
            return Ok(prepared.clone());
        }
        let unfit = |error: anyhow::Error| match error.downcast::<ClientError>() {
            // That is the coordinator's trouble, or the network's.
            Ok(error) => anyhow::Error::from(error),
            Err(error) => Unfit(error).into(),
        };
        same_program(job).map_err(unfit)?;
        let assignment = client.assignment()?;
        if assignment.conditions != job.conditions {
            return Err(ClientError::Stale("the job is of another run".into()).into());
        }
        self.signs.know(job);
        tracing::info!("preparing run {}", job.run_name);
        let shared = self.shared.as_deref();
        let fresh = Arc::new(Prepared::new(job, &assignment, client, shared).map_err(unfit)?);
        *prepared = Some((common, fresh.clone()));
        Ok(fresh)
    }
}

/// Why a worker must not measure a run.
#[derive(Debug, thiserror::Error)]
#[error("{0:#}")]
struct Unfit(anyhow::Error);

fn same_program(job: &Job) -> anyhow::Result<()> {
    let own = env!("CARGO_PKG_VERSION");
    let its = &job.conditions.code_version;
    if job.protocol != PROTOCOL || its != own {
        bail!("its coordinator is lfpiv {its}, and this is {own}: use one version");
    }
    Ok(())
}

/// Tells the broker that a measurement goes on, up to the job's deadline, and waits for its end.
async fn keep_alive<T>(
    taken: &TakenJob,
    mut measuring: JoinHandle<T>,
) -> Result<T, tokio::task::JoinError> {
    let began = Instant::now();
    let deadline = Duration::from_millis(taken.job.deadline_ms);
    let mut signs = tokio::time::interval(Duration::from_millis(taken.job.heartbeat_ms.max(1)));
    loop {
        tokio::select! {
            measured = &mut measuring => return measured,
            _ = signs.tick(), if began.elapsed() < deadline => {
                if let Err(error) = taken.keep_alive().await {
                    tracing::debug!("{error}");
                }
            }
        }
    }
}
