//! Distributes shots among workers until every one is settled.

use std::{
    collections::BTreeMap,
    net::SocketAddr,
    path::Path,
    sync::{Arc, mpsc::SyncSender},
    time::{Duration, Instant},
};

use anyhow::{Context, anyhow};
use tokio::net::TcpListener;
use tokio_util::sync::CancellationToken;

use crate::{
    acquisition::journal::{RecordedRun, RecordedShot},
    archive::{ResultStore, ShotResult},
    cli::{
        cluster_run::{assignment, print_workers, run_name},
        output::{count, progress_bar},
        result_writer::ResultThread,
    },
    cluster::{
        Broker, ClusterProgress, Coordinator, CoordinatorSetup, Delivery, DeliveryLog, JobQueue,
        LoggedDeliveries, Report, ServiceSettings, ShotState, Tally, Verdict, WorkService,
        WorkersAddress,
    },
    config::Config,
    server::serve_cluster,
};

/// How long the last tasks are waited for.
const SHUTDOWN_TIMEOUT: Duration = Duration::from_secs(2);
/// Pause between lines about the progress in the log.
const LOG_INTERVAL: Duration = Duration::from_secs(30);

/// What is distributed, and how.
pub(super) struct Distribution<'a> {
    pub folder: &'a Path,
    pub recorded: &'a RecordedRun,
    pub config: &'a Config,
    /// The shot that decides the forward model, and its result.
    pub reference: (RecordedShot, ShotResult),
    pub broker: Broker,
    pub serve: SocketAddr,
    /// Where workers and backlog are shown, if so.
    pub status: Option<SocketAddr>,
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
        let (shot, result) = &self.reference;
        let model = result.measured.model.clone();
        let assignment = assignment(self.recorded, self.config, (shot, result), false)?;
        let (log, logged) = DeliveryLog::open(self.folder, &assignment, &model)?;
        let (sink, writer) = ResultThread::start(store).context("cannot start a thread")?;
        let tally = taken_up(&shots, logged, &sink)?;
        let setup = CoordinatorSetup {
            run: self.recorded.clone(),
            shots,
            assignment,
            model,
            grid: result.measured.field.grid.clone(),
            tally,
            log,
            heartbeat_timeout: self.heartbeat_timeout,
            light: None,
            sink: Box::new(move |shot, result| sink.send((shot, result)).is_ok()),
        };
        let first_issue = setup.tally.last_issue() + 1;
        let coordinator = Arc::new(Coordinator::open(setup));
        let served = self.serve_until_settled(&coordinator, first_issue, stop);
        let (tally, refused, log) = coordinator.close();
        // Whatever has failed: what was delivered is stored.
        writer.join()?;
        served?;
        print_workers(&tally, refused)?;
        let outcome = Outcome::of(&tally);
        if let Some(log) = log.filter(|_| outcome.left == 0) {
            log.remove()?;
        }
        Ok(outcome)
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
        let at = WorkersAddress::bind(self.serve).await?;
        let meanwhile = "no worker gets a shot until it is there";
        let queue = JobQueue::connect(&self.broker, "lfpiv process", meanwhile).await?;
        at.warn(&queue);
        let progress = Arc::new(ClusterProgress::new(queue.clone(), self.heartbeat_timeout));
        progress.follow(coordinator.clone());
        let closing = CancellationToken::new();
        let shown = self
            .status_listener()
            .await?
            .map(|listener| tokio::spawn(serve_cluster(listener, progress, closing.clone())));
        let settings = ServiceSettings {
            run_name: run_name(self.folder),
            heartbeat_timeout: self.heartbeat_timeout,
            deadline: self.deadline,
            first_issue,
        };
        let service = WorkService::start(coordinator, at, queue, settings)?;
        let showing = tokio::spawn(show_progress(coordinator.clone()));
        let settled = tokio::select! {
            settled = coordinator.settled() => settled,
            () = stop.cancelled() => Ok(()),
        };
        showing.abort();
        service.end().await;
        closing.cancel();
        if let Some(shown) = shown {
            // A reader may keep its connection open.
            let _ = tokio::time::timeout(SHUTDOWN_TIMEOUT, shown).await;
        }
        Ok(settled?)
    }

    /// Listens where workers and backlog are to be shown, if so.
    async fn status_listener(&self) -> anyhow::Result<Option<TcpListener>> {
        let Some(address) = self.status else { return Ok(None) };
        let listener = TcpListener::bind(address)
            .await
            .with_context(|| format!("cannot listen at --status {address}"))?;
        let address = listener.local_addr().context("no address")?;
        tracing::info!("workers and backlog are shown at http://{address}/api/v1/status");
        Ok(Some(listener))
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
