//! A coordinator and workers on this machine, to be timed: all of it is real, except that workers may sleep instead of
//! measuring. The results that they deliver are the reference's, and go nowhere.

use std::{
    fs,
    net::SocketAddr,
    path::PathBuf,
    sync::Arc,
    time::{Duration, Instant},
};

use anyhow::Context;
use lfpiv_core::{lightfield::ImagePair, measurement::Processor};
use parking_lot::Mutex;
use tokio::task::JoinSet;
use tokio_util::sync::CancellationToken;

use super::proxy::SlowNetwork;
use crate::{
    acquisition::journal::{RecordedRun, RecordedShot},
    archive::ShotResult,
    cli::cluster_run::assignment,
    cluster::{
        Attempt, Begin, Broker, Coordinator, CoordinatorClient, CoordinatorSetup, Delivery,
        DeliveryLog, Job, JobQueue, ServiceSettings, TakenJob, Tally, WorkService, WorkersAddress,
        model_sha256,
    },
    config::Config,
};

/// Longer than any shot of a trial: nobody sends heartbeats.
const HEARTBEAT_TIMEOUT: Duration = Duration::from_secs(600);
/// Pause of a worker for which there is no job.
const NO_JOB_PAUSE: Duration = Duration::from_millis(10);
/// Shots of a worker before its time counts, and after.
const MARGIN: usize = 2;

/// What trials have in common.
pub(super) struct Rig {
    pub recorded: RecordedRun,
    pub config: Config,
    pub reference: (RecordedShot, ShotResult),
    pub processor: Processor,
    pub broker: Broker,
    /// Folder for what a coordinator writes.
    pub scratch: PathBuf,
}

/// Workers to be timed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Trial {
    pub workers: usize,
    /// Shots that each of them measures while it is timed.
    pub shots: usize,
    /// Mean time that a shot takes a worker.
    pub shot_s: f64,
    /// Whether shots are really measured, and the rest of the time slept; or all of it.
    pub measures: bool,
    /// Rate of the coordinator's network, if it is throttled.
    pub bytes_per_s: Option<f64>,
}

/// What was timed; times are medians of a shot, in s.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Timed {
    pub shots_per_s: f64,
    /// To get a job from the broker, and to give it back as done.
    pub broker_s: f64,
    /// To begin a shot, read its frames and deliver its result.
    pub coordinator_s: f64,
}

struct Worker {
    number: usize,
    rig: Arc<Rig>,
    trial: Trial,
    queue: JobQueue,
    /// Instead of the job's.
    address: Option<SocketAddr>,
    times: Arc<Mutex<Vec<Shot>>>,
}

struct Shot {
    worker: usize,
    ended: Instant,
    broker_s: f64,
    coordinator_s: f64,
}

impl Rig {
    /// Times the workers of a trial.
    ///
    /// # Errors
    /// The broker does not answer, or a file cannot be written.
    pub async fn time(self: &Arc<Self>, trial: Trial) -> anyhow::Result<Timed> {
        let _ = fs::remove_dir_all(&self.scratch);
        let coordinator = self.coordinator(trial)?;
        let at = WorkersAddress::bind(SocketAddr::from(([127, 0, 0, 1], 0))).await?;
        let server = at.address();
        let queue = JobQueue::connect(&self.broker, "lfpiv scale", "nothing is timed").await?;
        let settings = ServiceSettings {
            run_name: "scale".into(),
            heartbeat_timeout: HEARTBEAT_TIMEOUT,
            deadline: HEARTBEAT_TIMEOUT,
            first_issue: 1,
        };
        let service = WorkService::start(&coordinator, at, queue.clone(), settings)?;
        let network = match trial.bytes_per_s {
            Some(rate) => Some(SlowNetwork::to(server, rate).await?),
            None => None,
        };
        let (times, stop) = (Arc::<Mutex<Vec<Shot>>>::default(), CancellationToken::new());
        let mut workers = JoinSet::new();
        for number in 0..trial.workers {
            let worker = Worker {
                number,
                rig: self.clone(),
                trial,
                queue: queue.clone(),
                address: network.as_ref().map(SlowNetwork::address),
                times: times.clone(),
            };
            workers.spawn(Arc::new(worker).work(stop.clone()));
        }
        let settled = tokio::select! {
            settled = coordinator.settled() => settled.map_err(Into::into),
            failed = first_failure(&mut workers) => failed,
        };
        stop.cancel();
        while workers.join_next().await.is_some() {}
        service.end().await;
        drop(coordinator.close());
        settled?;
        fs::remove_dir_all(&self.scratch).context("the folder of the trial cannot be removed")?;
        let times = std::mem::take(&mut *times.lock());
        Ok(Timed::of(&times, trial.workers))
    }

    /// The shots of the run again and again, under new numbers.
    fn coordinator(&self, trial: Trial) -> anyhow::Result<Arc<Coordinator>> {
        let (shot, result) = &self.reference;
        let assignment = assignment(&self.recorded, &self.config, (shot, result), false)?;
        let model = result.measured.model.clone();
        fs::create_dir_all(&self.scratch)
            .with_context(|| format!("cannot create {}", self.scratch.display()))?;
        let (log, _) = DeliveryLog::open(&self.scratch, &assignment, &model)?;
        let count = trial.workers * (trial.shots + 2 * MARGIN);
        let shots: Vec<RecordedShot> =
            (0..count as u64).map(|trigger| RecordedShot { trigger, ..shot.clone() }).collect();
        Ok(Arc::new(Coordinator::open(CoordinatorSetup {
            run: self.recorded.clone(),
            tally: Tally::of(shots.iter().map(|shot| shot.trigger)),
            shots,
            assignment,
            model,
            grid: result.measured.field.grid.clone(),
            log,
            heartbeat_timeout: HEARTBEAT_TIMEOUT,
            light: None,
            sink: Box::new(|_, _| true),
        })))
    }
}

async fn first_failure(workers: &mut JoinSet<anyhow::Result<()>>) -> anyhow::Result<()> {
    while let Some(ended) = workers.join_next().await {
        ended.context("a worker has panicked")??;
    }
    // None ends before it is told to.
    std::future::pending().await
}

impl Worker {
    async fn work(self: Arc<Self>, stop: CancellationToken) -> anyhow::Result<()> {
        let mut shots = 0;
        while !stop.is_cancelled() {
            let began = Instant::now();
            match self.queue.take().await {
                Ok(Some(taken)) => {
                    let place = 0.414 * self.number as f64 + 0.618 * shots as f64;
                    self.clone().serve(taken, began, place).await?;
                    shots += 1;
                }
                _ => tokio::time::sleep(NO_JOB_PAUSE).await,
            }
        }
        Ok(())
    }

    async fn serve(
        self: Arc<Self>,
        taken: TakenJob,
        began: Instant,
        place: f64,
    ) -> anyhow::Result<()> {
        let taken_s = began.elapsed().as_secs_f64();
        let (worker, job, attempt) = (self.clone(), taken.job.clone(), taken.attempt);
        let served =
            tokio::task::spawn_blocking(move || worker.measure(&job, attempt, place)).await;
        let served = served.context("a thread has failed")??;
        let measured = Instant::now();
        taken.done().await?;
        let (worker, ended) = (self.number, Instant::now());
        let broker_s = taken_s + (ended - measured).as_secs_f64();
        if let Some(coordinator_s) = served {
            self.times.lock().push(Shot { worker, ended, broker_s, coordinator_s });
        }
        Ok(())
    }

    /// Time with the coordinator; `None` if the shot is settled already. Blocks.
    fn measure(&self, job: &Job, attempt: Attempt, place: f64) -> anyhow::Result<Option<f64>> {
        let through = self.address.map(|address| format!("http://{address}"));
        let client = CoordinatorClient::new(through.as_ref().unwrap_or(&job.address), &job.tokens);
        let began = Instant::now();
        if client.begin(job.shot.number, attempt, "scale")? == Begin::Settled {
            return Ok(None);
        }
        let mut frames = Vec::new();
        for frame in job.shot.frames.iter().flatten() {
            frames.push(client.packed(frame)?);
        }
        let read = Instant::now();
        if self.trial.measures {
            let pair = unpacked(&frames, job.shot.frames.len())?;
            self.rig.processor.process(pair)?;
        }
        // Shots differ: from 0.8 to 1.2 of the mean, in no order.
        let time = Duration::from_secs_f64(self.trial.shot_s * (0.8 + 0.4 * place.fract()));
        std::thread::sleep(time.saturating_sub(read.elapsed()));
        let measured = Instant::now();
        client.deliver(&self.delivery(job, attempt).encode())?;
        Ok(Some((read - began).as_secs_f64() + measured.elapsed().as_secs_f64()))
    }

    fn delivery(&self, job: &Job, attempt: Attempt) -> Delivery {
        let result = self.rig.reference.1.clone();
        Delivery {
            shot: job.shot.number,
            attempt,
            worker: "scale".into(),
            model_sha256: model_sha256(&result.measured.model),
            result,
        }
    }
}

/// The pair in packed frames a and b of each camera.
pub(super) fn unpacked(frames: &[Vec<u8>], cameras: usize) -> anyhow::Result<ImagePair> {
    let image = |bytes: &Vec<u8>| {
        let record = lfpiv_rawlog::unpack(bytes).map_err(anyhow::Error::msg)?;
        record.image.context("a frame has no image")
    };
    let pairs = frames.chunks_exact(2).take(cameras);
    let pairs = pairs.map(|ab| Ok([image(&ab[0])?, image(&ab[1])?]));
    Ok(ImagePair { cameras: pairs.collect::<anyhow::Result<_>>()? })
}

impl Timed {
    /// The rate is the sum of the workers' rates, each from its first shot that counts to its last one: all workers
    /// begin together, so that results come in waves.
    fn of(shots: &[Shot], workers: usize) -> Self {
        let rate = |worker: usize| {
            let ended = shots.iter().filter(|shot| shot.worker == worker).map(|shot| shot.ended);
            let mut ended: Vec<Instant> = ended.collect();
            ended.sort_unstable();
            let margin = MARGIN.min(ended.len().saturating_sub(2) / 2);
            match &ended[margin..ended.len() - margin] {
                [first, between @ .., last] => {
                    (between.len() + 1) as f64 / (*last - *first).as_secs_f64()
                }
                _ => 0.0,
            }
        };
        let median = |of: fn(&Shot) -> f64| {
            let mut all: Vec<f64> = shots.iter().map(of).collect();
            all.sort_unstable_by(f64::total_cmp);
            // Other programs may hold up some.
            all.get(all.len() / 2).copied().unwrap_or(0.0)
        };
        Self {
            shots_per_s: (0..workers).map(rate).sum(),
            broker_s: median(|shot| shot.broker_s),
            coordinator_s: median(|shot| shot.coordinator_s),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn waves_of_results_have_the_rate_of_their_workers() {
        let began = Instant::now();
        let shot = |worker: usize, ms: u64| Shot {
            worker,
            ended: began + Duration::from_millis(ms),
            broker_s: ms as f64,
            coordinator_s: 1.0,
        };
        // Two workers that take a second, one of which has shots at its ends that do not count.
        let mut shots: Vec<Shot> = (1..=8).map(|n| shot(0, 1000 * n)).collect();
        shots.extend([10, 20, 1000, 2000, 3000, 4000, 4001, 4002].map(|ms| shot(1, ms)));
        let timed = Timed::of(&shots, 3);
        assert_eq!((timed.shots_per_s, timed.coordinator_s), (2.0, 1.0));
    }
}
