//! The daemon: acquisition, worker pool, result store and server of one run.
//!
//! ```text
//! bench -> acquire -> queue -> pool -> results on disk
//!             |                 |
//!           ledger            board  <- server -> HTTP
//! ```
//!
//! Every task started here is awaited here. The run ends when all shots are done, when `stop` is
//! cancelled, or when acquisition or pool fail. In each case the laser is switched off before
//! anything else ends, shots in process are finished, and the ledger is written last.

use std::{
    fmt::Display,
    future::Future,
    net::SocketAddr,
    path::{Path, PathBuf},
    sync::Arc,
    time::{Duration, Instant},
};

use anyhow::{Context, anyhow};
use lfpiv_core::{lightfield::ImagePair, velocimetry::PairResult};
use parking_lot::Mutex;
use tokio::{net::TcpListener, task::JoinHandle};
use tokio_util::sync::CancellationToken;

pub use super::daemon_plan::DaemonPlan;
use super::{
    ledger_file::write_ledger,
    live_cluster::{LiveCluster, LiveRun},
    measuring::Measuring,
    recorded_frames::RecordedFrames,
    recording::{Recording, report_unfinished},
    run_folder::create_run_folder,
    run_info::{bench_settings, run_info},
    service::Service,
};
use crate::{
    acquisition::{
        AcquisitionError, AcquisitionLinks, AcquisitionReport, AcquisitionSettings, Bench,
        BurstScript, Control, ControlInbox, Heartbeat, HostClock, Ledger, RunClock,
        SynchroniserThread, acquire, control, panic_message, secure, shot_queue,
    },
    archive::{ResultStore, merge_segments},
    pipeline::{Board, Observer, Pool, PoolLinks, PoolSettings},
    server::{ApiState, Phase, Protection, raise_open_files, serve},
};

/// How long open HTTP connections may delay the end of the run.
const SERVER_GRACE: Duration = Duration::from_secs(2);
/// Time after the end of the run during which a new merged file may be started, so that stopping a
/// service does not take long. `lfpiv process RUN` merges the rest.
const MERGE_TIME: Duration = Duration::from_secs(20);

/// Determines times and bursts of a replayed run.
pub struct RunScript {
    /// Returns the recorded times.
    pub clock: Arc<dyn RunClock>,
    /// The bursts and when they are fired.
    pub bursts: Arc<dyn BurstScript>,
    /// Ends acquisition; the pool still measures the queued shots.
    pub stop: CancellationToken,
    /// Number of shots in the longest burst, which is the queue length needed to avoid shedding.
    pub longest_burst: usize,
}

/// A run whose server is listening but which takes no shots yet.
pub struct Daemon {
    plan: DaemonPlan,
    acquisition: AcquisitionSettings,
    folder: PathBuf,
    store: ResultStore,
    recording: Recording,
    /// Absent if the run measures its shots itself.
    cluster: Option<LiveCluster>,
    control: Control,
    inbox: ControlInbox,
    script: Option<RunScript>,
    synchroniser: SynchroniserThread,
    listener: TcpListener,
    address: SocketAddr,
    protection: Protection,
    state: ApiState,
    run_loop: Heartbeat,
    ledger: Arc<Mutex<Ledger>>,
    board: Arc<Board>,
}

/// Outcome of a run.
#[derive(Debug, Clone)]
pub struct DaemonReport {
    /// Folder of results and ledger.
    pub folder: PathBuf,
    /// Counts of the acquisition.
    pub acquisition: AcquisitionReport,
    /// The ledger with every trigger settled.
    pub ledger: Ledger,
}

impl Daemon {
    /// Checks the timing, creates the run's folder and binds the server's address.
    ///
    /// # Errors
    ///
    /// An impossible schedule, a server that would be open to others, a folder that cannot be
    /// created, or an address in use.
    pub async fn prepare(plan: DaemonPlan) -> anyhow::Result<Self> {
        let config = &plan.file.config;
        let acquisition = plan.acquisition()?;
        raise_open_files(&config.server);
        let protection = Protection::open(&config.server)?;
        let address = config.server.address;
        let listener = TcpListener::bind(address).await.with_context(|| {
            format!("cannot listen on {address}: is another lfpiv running? See server.address")
        })?;
        let address = listener.local_addr().context("the server has no address")?;
        // A replay measures its shots itself, as it is to show what this program does.
        let cluster = match config.cluster.as_ref().filter(|_| plan.raw_log.is_some()) {
            Some(settings) => Some(LiveCluster::prepare(settings).await?),
            None => None,
        };
        report_unfinished(&config.output.dir);
        let folder = create_run_folder(&config.output.dir)?;
        let store =
            ResultStore::create(&folder, &plan.file.text)?.for_paraview(config.output.paraview);
        let recording = Recording::begin(&folder, &plan, &acquisition)?;
        let (control, inbox) = control(plan.mode, acquisition.schedule.dt_us, plan.planner());
        let ledger = Arc::new(Mutex::new(Ledger::new(config.camera.len())));
        let run_loop = Heartbeat::default();
        let first_pair = Duration::from_secs_f64(config.pipeline.first_pair_patience_s);
        let board = Arc::new(Board::with_patience(first_pair));
        let state = ApiState::new(
            run_info(&plan, &folder),
            ledger.clone(),
            board.clone(),
            recording.journal.clone(),
        )
        .with_controls(Arc::new(control.clone()), plan.remote_arming)
        .with_frames(Arc::new(RecordedFrames::new(board.clone(), &folder)))
        .with_run_loop(run_loop.clone())
        .with_bench(bench_settings(&plan.file));
        let state = match &cluster {
            Some(cluster) => state.with_cluster(cluster.progress()),
            None => state,
        };
        Ok(Self {
            plan,
            acquisition,
            folder,
            store,
            recording,
            cluster,
            control,
            inbox,
            script: None,
            synchroniser: SynchroniserThread::default(),
            listener,
            address,
            protection,
            state,
            run_loop,
            ledger,
            board,
        })
    }

    /// The address that the server is bound to.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// The URL of the server.
    pub fn url(&self) -> String {
        self.plan.file.config.server.url(self.address)
    }

    /// The folder of the results.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Sends requests to the run, for an operator at this machine.
    pub fn control(&self) -> Control {
        self.control.clone()
    }

    /// Makes the run follow a script.
    pub fn follow(&mut self, script: RunScript) {
        self.script = Some(script);
    }

    /// Shares the thread of the run's synchroniser with `owner`.
    pub fn share_synchroniser(&mut self, owner: SynchroniserThread) {
        self.synchroniser = owner;
    }

    /// Runs to the end. `processor` builds the tables on a thread of its own; `observer` receives
    /// every shot that leaves the pool.
    ///
    /// # Errors
    ///
    /// What ended the run early; results and ledger are on disk even then.
    pub async fn run<P, E>(
        self,
        bench: Bench,
        processor: impl FnOnce() -> anyhow::Result<P> + Send + 'static,
        observer: Observer,
        stop: CancellationToken,
    ) -> anyhow::Result<DaemonReport>
    where
        P: Fn(&ImagePair) -> Result<PairResult, E> + Send + Sync + 'static,
        E: Display + 'static,
    {
        let stop_server = CancellationToken::new();
        let server = serve(self.listener, self.state.clone(), self.protection, stop_server.clone());
        let server = tokio::spawn(server);
        let clock: Arc<dyn RunClock> = match &self.script {
            Some(script) => script.clock.clone(),
            None => Arc::new(HostClock::start()),
        };
        let links = PoolLinks {
            clock: clock.clone(),
            ledger: self.ledger.clone(),
            journal: self.recording.journal.clone(),
            board: self.board.clone(),
            stop: stop.clone(),
        };
        let heartbeat = self.run_loop;
        let service = Service::new(&self.state, &self.ledger, &self.board, &heartbeat);
        let work = async {
            let bench = secure(bench).await?;
            let process = unpanicked(tokio::task::spawn_blocking(processor)).await??;
            let measuring = match self.cluster {
                None => {
                    let settings = PoolSettings::default();
                    Measuring::Here(Pool::new(settings, process, self.store, observer, links)?)
                }
                Some(cluster) => {
                    let (folder, config) = (self.folder.clone(), self.plan.file.config.clone());
                    let store = self.store;
                    let run = LiveRun { folder, config, process, store, observer, links };
                    Measuring::Elsewhere(Box::new((cluster, run)))
                }
            };
            self.state.set_phase(Phase::Running);
            let configured = self.plan.file.config.pipeline.queue;
            let queue = self.script.as_ref().map_or(configured, |script| script.longest_burst);
            let (sender, receiver) = shot_queue(queue);
            let links = AcquisitionLinks {
                journal: self.recording.journal.clone(),
                control: self.inbox,
                heartbeat,
                clock,
                synchroniser: self.synchroniser.clone(),
                ..AcquisitionLinks::new(self.ledger.clone(), sender, stop)
            };
            let links = match self.script {
                Some(RunScript { bursts, stop, .. }) => {
                    AcquisitionLinks { bursts: Some(bursts), stop, ..links }
                }
                None => links,
            };
            let acquiring = acquire(bench, self.acquisition, links);
            take_and_process(acquiring, &self.synchroniser, measuring.run(receiver), &self.state)
                .await
        };
        let worked = service.accompany(work).await;
        let recording = self.recording;
        let (lock, closing) = recording.end();
        let recorded = unpanicked(tokio::task::spawn_blocking(closing)).await;
        let worked = match (worked, recorded.and_then(|closed| closed)) {
            (Ok(_), Err(error)) => Err(error),
            (worked, _) => worked,
        };
        let written = write_ledger(&self.folder, &self.ledger.lock(), &self.board, &worked);
        self.state.set_phase(match &worked {
            Ok(_) => Phase::Finished,
            Err(error) => Phase::Failed(format!("{error:#}")),
        });
        stop_server.cancel();
        end_server(server).await;
        if let (Err(_), Err(error)) = (&worked, &written) {
            tracing::error!("{error:#}");
        }
        let acquisition = worked?;
        written?;
        merge(&self.folder).await;
        drop(lock);
        let ledger = self.ledger.lock().clone();
        Ok(DaemonReport { folder: self.folder, acquisition, ledger })
    }
}

/// Merges the run's segments into few files. A failure is only logged, because the results are
/// safe.
async fn merge(folder: &Path) {
    let (folder, until) = (folder.to_owned(), Instant::now() + MERGE_TIME);
    let merging = tokio::task::spawn_blocking(move || {
        merge_segments(&folder, || Instant::now() < until).context("some segments are not merged")
    });
    if let Err(error) = unpanicked(merging).await.and_then(|merged| merged) {
        tracing::warn!("{error:#}; lfpiv process merges them");
    }
}

/// Waits for pending requests, but not for a client that keeps its connection open.
async fn end_server(mut server: JoinHandle<()>) {
    match tokio::time::timeout(SERVER_GRACE, &mut server).await {
        Ok(Ok(())) => {}
        Ok(Err(error)) => tracing::error!(%error, "the server panicked"),
        Err(_) => server.abort(),
    }
}

/// Runs acquisition and the measurement of its shots until both have ended.
async fn take_and_process(
    acquiring: impl Future<Output = Result<AcquisitionReport, AcquisitionError>> + Send + 'static,
    synchroniser: &SynchroniserThread,
    measuring: impl Future<Output = anyhow::Result<()>> + Send + 'static,
    state: &ApiState,
) -> anyhow::Result<AcquisitionReport> {
    let pool = tokio::spawn(measuring);
    let acquired = unpanicked(tokio::spawn(acquiring)).await;
    // If the run loop panicked, the laser may not be safe yet.
    let acquired = match (acquired, synchroniser.join().await) {
        (Err(panic), Err(not_safe)) => Err(panic.context(not_safe)),
        (acquired, _) => acquired,
    };
    state.set_phase(Phase::Stopping);
    let processed = unpanicked(pool).await;
    let report = acquired?.context("acquisition ended early")?;
    processed?.context("processing ended early")?;
    Ok(report)
}

/// The result of a task; a panic becomes an error.
async fn unpanicked<T>(
    task: impl Future<Output = Result<T, tokio::task::JoinError>>,
) -> anyhow::Result<T> {
    task.await.map_err(|error| match error.try_into_panic() {
        Ok(panic) => anyhow!("a task panicked: {}", panic_message(panic.as_ref())),
        Err(error) => anyhow!(error),
    })
}
