//! Distributes shots among workers until every one is settled.

use std::{
    collections::BTreeMap,
    fmt::Write as _,
    net::SocketAddr,
    path::Path,
    sync::{Arc, mpsc::SyncSender},
    time::{Duration, Instant},
};

use anyhow::{Context, anyhow};
use ring::rand::{SecureRandom, SystemRandom};
use tokio::net::TcpListener;
use tokio_util::sync::CancellationToken;

use super::{offers::Offers, result_writer::ResultWriter};
use crate::{
    acquisition::journal::{RecordedRun, RecordedShot},
    archive::{ResultStore, ShotResult},
    cli::output::{count, print, progress_bar},
    cluster::{
        Assignment, Attempt, Broker, Conditions, Coordinator, CoordinatorSetup, Delivery,
        DeliveryLog, JobQueue, LoggedDeliveries, Reference, Report, Shot, ShotState, Tally,
        Verdict, coordinator_routes, model_sha256,
    },
};

/// How long jobs and connections are waited for at the end.
const SHUTDOWN_TIMEOUT: Duration = Duration::from_secs(2);
/// Pause between lines about the progress in the log.
const LOG_INTERVAL: Duration = Duration::from_secs(30);
/// Characters of the hash that identify a run to the broker.
const RUN_CHARACTERS: usize = 16;

/// What is distributed, and how.
pub(super) struct Distribution<'a> {
    pub folder: &'a Path,
    pub recorded: &'a RecordedRun,
    pub conditions: Conditions,
    /// The shot that decides the forward model, and its result.
    pub reference: (RecordedShot, ShotResult),
    pub broker: Broker,
    pub serve: SocketAddr,
    pub heartbeat_timeout: Duration,
    pub deadline: Duration,
}

/// What came of the shots.
pub(super) struct Outcome {
    /// The dead-letter list.
    pub failed: BTreeMap<u64, String>,
    /// Shots whose images cannot be read.
    pub lost: BTreeMap<u64, String>,
    /// Shots that are not settled.
    pub left: usize,
    /// Shots with unequal results, in words.
    pub differing: Vec<String>,
}

impl Distribution<'_> {
    /// Has these shots measured and stores their results.
    ///
    /// # Errors
    /// An address or a file cannot be used, or results cannot be stored. What is stored stays.
    pub fn distribute(
        self,
        shots: Vec<RecordedShot>,
        store: ResultStore,
        stop: &CancellationToken,
    ) -> anyhow::Result<Outcome> {
        let model = self.reference.1.measured.model.clone();
        let model_sha256 = model_sha256(&model);
        let (log, logged) =
            DeliveryLog::open(self.folder, &self.conditions, &model, &model_sha256)?;
        let (sink, writer) = ResultWriter::start(store).context("cannot start a thread")?;
        let tally = taken_up(&shots, logged, &sink)?;
        let setup = CoordinatorSetup {
            run: self.recorded.clone(),
            shots,
            assignment: self.assignment(model_sha256)?,
            model,
            grid: self.reference.1.measured.field.grid.clone(),
            tally,
            log,
            sink,
        };
        let first_issue = setup.tally.last_issue() + 1;
        let coordinator = Arc::new(Coordinator::open(setup));
        let served = self.serve_until_settled(&coordinator, first_issue, stop);
        let (tally, refused, log) = coordinator.close();
        // Whatever has failed: what was delivered is stored.
        writer.join()?;
        served?;
        report(&tally, refused)?;
        let outcome = Outcome::of(&tally);
        if let Some(log) = log.filter(|_| outcome.left == 0) {
            log.remove()?;
        }
        Ok(outcome)
    }

    fn assignment(&self, model_sha256: String) -> anyhow::Result<Assignment> {
        let (shot, result) = &self.reference;
        let measured = Delivery {
            shot: shot.trigger,
            attempt: Attempt { issue: 0, delivery: 0 },
            worker: String::new(),
            model_sha256: model_sha256.clone(),
            result: result.clone(),
        };
        Ok(Assignment {
            conditions: self.conditions.clone(),
            configuration: self.recorded.description().configuration.clone(),
            reference: Reference {
                shot: Shot::of(self.recorded, shot)?,
                result_sha256: measured.result_sha256(),
                model_sha256,
            },
        })
    }

    fn serve_until_settled(
        &self,
        coordinator: &Arc<Coordinator>,
        first_issue: u32,
        stop: &CancellationToken,
    ) -> anyhow::Result<()> {
        let runtime = tokio::runtime::Builder::new_multi_thread()
            .worker_threads(2)
            .enable_all()
            .build()
            .context("cannot start the runtime")?;
        let served = runtime.block_on(self.serve(coordinator, first_issue, stop));
        runtime.shutdown_timeout(SHUTDOWN_TIMEOUT);
        served
    }

    async fn serve(
        &self,
        coordinator: &Arc<Coordinator>,
        first_issue: u32,
        stop: &CancellationToken,
    ) -> anyhow::Result<()> {
        let listener = TcpListener::bind(self.serve)
            .await
            .with_context(|| format!("cannot listen at {}", self.serve))?;
        let address = format!("http://{}", listener.local_addr().context("no address")?);
        let token = random_token()?;
        let queue = JobQueue::connect(&self.broker, "lfpiv process").await?;
        let run = self.conditions.shots_sha256.chars().take(RUN_CHARACTERS).collect::<String>();
        let name = self.folder.canonicalize().unwrap_or_else(|_| self.folder.to_owned());
        let offers = Offers {
            coordinator: coordinator.clone(),
            recorded: self.recorded.clone(),
            run: run.clone(),
            run_name: name.file_name().unwrap_or_default().to_string_lossy().into_owned(),
            conditions: self.conditions.clone(),
            model_sha256: coordinator.assignment().reference.model_sha256.clone(),
            address: address.clone(),
            token: token.clone(),
            heartbeat_timeout: self.heartbeat_timeout,
            deadline: self.deadline,
            issues: BTreeMap::new(),
            first_issue,
        };
        warn_of_addresses(self.serve, &queue);
        tracing::info!("workers read frames and deliver results at {address}");
        let closing = CancellationToken::new();
        let server = axum::serve(listener, coordinator_routes(coordinator.clone(), &token))
            .with_graceful_shutdown(closing.clone().cancelled_owned());
        let server = tokio::spawn(async { server.await });
        let offering = tokio::spawn(offers.keep_up(queue.clone()));
        let showing = tokio::spawn(show_progress(coordinator.clone()));
        let settled = tokio::select! {
            settled = coordinator.settled() => settled,
            () = stop.cancelled() => Ok(()),
        };
        offering.abort();
        showing.abort();
        // Workers do not look at jobs that nobody waits for. Without a broker there are none.
        let _ =
            tokio::time::timeout(SHUTDOWN_TIMEOUT, queue.withdraw(&run, self.heartbeat_timeout))
                .await;
        closing.cancel();
        let _ = tokio::time::timeout(SHUTDOWN_TIMEOUT, server).await;
        Ok(settled?)
    }
}

impl Outcome {
    fn of(tally: &Tally) -> Self {
        let lost = tally.unreadable();
        let dead = tally.dead().into_iter().filter(|(shot, _)| !lost.contains_key(shot));
        let unequal = tally.unequal().into_iter();
        Self {
            failed: dead.map(|(shot, reasons)| (shot, reasons.join("; "))).collect(),
            left: tally.open().count(),
            differing: unequal
                .map(|(shot, makers)| format!("shot {shot}: {}", makers.join(", ")))
                .collect(),
            lost,
        }
    }
}

/// The tally of what earlier coordinators have logged; results that they did not store are stored.
fn taken_up(
    shots: &[RecordedShot],
    logged: LoggedDeliveries,
    sink: &SyncSender<(u64, ShotResult)>,
) -> anyhow::Result<Tally> {
    let mut tally = Tally::of(shots.iter().map(|shot| shot.trigger));
    let LoggedDeliveries { reports, mut results } = logged;
    results.reverse();
    let mut again = 0;
    for (shot, report) in reports {
        let is_result = results
            .last()
            .is_some_and(|delivery| delivery.shot == shot && delivery.report() == report);
        let result = if is_result { results.pop() } else { None };
        let says_so = matches!(report, Report::Delivered { .. });
        if says_so && result.is_none() && tally.state(shot) != Some(ShotState::Done) {
            // The first result is in a damaged record: the shot is measured again.
            continue;
        }
        if tally.take(shot, &report) == Verdict::First
            && let Some(Delivery { shot, result, .. }) = result
        {
            sink.send((shot, result)).map_err(|_| anyhow!("results cannot be stored"))?;
            again += 1;
        }
    }
    if again > 0 {
        tracing::info!("{} delivered to an earlier coordinator are stored", count(again, "result"));
    }
    Ok(tally)
}

/// On a terminal as a bar, and in the log now and then.
async fn show_progress(coordinator: Arc<Coordinator>) {
    let mut left = coordinator.left();
    let all = *left.borrow_and_update();
    let bar = progress_bar(all, "shots");
    let began = Instant::now();
    let mut lines =
        tokio::time::interval_at(tokio::time::Instant::now() + LOG_INTERVAL, LOG_INTERVAL);
    loop {
        tokio::select! {
            changed = left.changed() => match changed {
                Ok(()) => bar.set_position(all.saturating_sub(*left.borrow_and_update()) as u64),
                Err(_) => return,
            },
            _ = lines.tick() => {
                let settled = all.saturating_sub(*left.borrow());
                let rate = settled as f64 / began.elapsed().as_secs_f64();
                let workers = count(coordinator.workers(), "worker");
                tracing::info!("{settled} of {all} shots, {rate:.2} a second, {workers} so far");
            }
        }
    }
}

/// Says what the chosen addresses mean.
fn warn_of_addresses(serve: SocketAddr, queue: &JobQueue) {
    let own = ["127.0.0.1", "localhost", "[::1]"];
    let is_broker_here = own.iter().any(|host| queue.address().contains(&format!("//{host}:")));
    match serve.ip().is_loopback() {
        true if !is_broker_here => tracing::warn!(
            "only workers on this machine reach the coordinator at {serve}: --serve names an address for others"
        ),
        false => tracing::warn!("frames and results at {serve} are not encrypted"),
        true => {}
    }
}

/// Who has measured how much.
fn report(tally: &Tally, refused: usize) -> anyhow::Result<()> {
    for (worker, shots) in tally.by_worker() {
        print(&format!("{worker}: {}", count(shots, "shot")))?;
    }
    print(&format!(
        "{} begun, {} not ended by their workers, {} refused",
        count(tally.attempts(), "measurement"),
        tally.lost(),
        count(refused, "result")
    ))
}

/// 128 random bits.
fn random_token() -> anyhow::Result<String> {
    let mut bytes = [0u8; 16];
    SystemRandom::new()
        .fill(&mut bytes)
        .map_err(|_| anyhow!("the system has no random numbers"))?;
    let mut token = String::new();
    for byte in bytes {
        let _ = write!(token, "{byte:02x}");
    }
    Ok(token)
}
