//! `lfpiv run`: the daemon on the command line.

use std::{
    io::{self, IsTerminal},
    num::NonZeroU64,
    path::PathBuf,
    sync::Arc,
};

use anyhow::{Context, bail};
use indicatif::ProgressBar;
use lfpiv_sim::{Flow, Pacing, connect};
use parking_lot::Mutex;

use super::{
    daemon::{Daemon, DaemonReport},
    daemon_plan::DaemonPlan,
    demo_table::{Row, Table, stream_table},
    instruments,
    logging::is_journal,
    operator::resume_on_signal,
    output::{count, print, progress_bar},
    run_processor::run_processor,
    stop::stop_on_signals,
};
use crate::{
    acquisition::{Account, Bench, Mode, Outcome, OverloadPolicy, SynchroniserThread},
    config::{Config, ConfigFile, Purpose},
    pipeline::{Observer, ShotRecord, Stage},
};

/// Arguments of `lfpiv run`.
#[derive(Debug, clap::Args)]
pub struct RunArgs {
    /// Configuration file (TOML).
    #[arg(long, value_name = "FILE")]
    pub config: PathBuf,
    /// Stop after this many shots; the default is to run until stopped.
    #[arg(long, value_name = "N")]
    pub shots: Option<NonZeroU64>,
    /// Configuration file with the true flow in its [simulation] table, for the table at the end of
    /// a bounded run; default: the run's configuration.
    #[arg(long, value_name = "FILE")]
    pub truth: Option<PathBuf>,
    /// Start with the laser safe; shots are taken when a client requests it.
    #[arg(long)]
    pub disarmed: bool,
    /// Allow clients with a control token to arm the laser and start in this run; the configuration
    /// must allow it as well (server.remote_arming).
    #[arg(long)]
    pub remote_arming: bool,
}

/// Runs the bench until its shots are done or it is stopped by Ctrl-C or SIGTERM.
pub fn run(args: RunArgs) -> anyhow::Result<()> {
    let file = ConfigFile::load_for(Purpose::Bench, &args.config)?;
    let truth = match &args.truth {
        Some(path) => ConfigFile::load_for(Purpose::Optics, path)?.config.simulation,
        None => file.config.simulation.clone(),
    };
    let bench = open_bench(&file.config, args.shots)
        .with_context(|| format!("{} cannot be run", args.config.display()))?;
    // Outlives the runtime and its tasks, so that the laser is made safe in any case.
    let synchroniser = SynchroniserThread::default();
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .enable_all()
        .build()
        .context("cannot start the runtime")?;
    // In a bounded run every shot is to be measured, so triggers wait for the results.
    let overload = match args.shots {
        Some(_) => OverloadPolicy::Wait,
        None => OverloadPolicy::Shed,
    };
    let plan = DaemonPlan {
        mode: if args.disarmed { Mode::Disarmed } else { Mode::Firing },
        remote_arming: args.remote_arming,
        ..DaemonPlan::new(file, args.shots, overload)
    };
    let run = run_bench(plan, bench, truth.map(|scene| scene.flow), &synchroniser);
    runtime.block_on(run)
}

/// Opens the configured instruments, or the simulated bench.
fn open_bench(config: &Config, shots: Option<NonZeroU64>) -> anyhow::Result<Bench> {
    if let Some(instruments) = &config.instruments {
        return instruments::open(config, instruments);
    }
    let Some(scene) = config.simulation.clone() else {
        bail!(
            "no [instruments] and no [simulation] table: add one, or start from config/sim.toml \
             or config/loopback.toml"
        );
    };
    // An unbounded simulated run keeps the rate of a real bench.
    let pacing = match shots {
        Some(_) => Pacing::AsFramesAreTaken,
        None => Pacing::RealTime,
    };
    let seed = scene.seed;
    scene.check(&config.bench_geometry())?;
    let bench = connect(scene, config.bench_geometry(), seed, pacing);
    Ok(Bench::new(bench.cameras, bench.synchroniser))
}

async fn run_bench(
    plan: DaemonPlan,
    bench: Bench,
    truth: Option<Flow>,
    synchroniser: &SynchroniserThread,
) -> anyhow::Result<()> {
    let shots = plan.shots;
    let config = plan.file.config.clone();
    let has_instruments = plan.file.config.instruments.is_some();
    let keeps_images = config.raw_log.keep;
    let stop = stop_on_signals(synchroniser, "the last results may not be on disk")?;
    let mut daemon = Daemon::prepare(plan).await?;
    daemon.share_synchroniser(synchroniser.clone());
    resume_on_signal(daemon.control())?;
    print(&format!("status:  {}/api/v1/status", daemon.url()))?;
    print(&format!("results: {}", daemon.folder().display()))?;
    print(&format!("bench:   {}/", daemon.url()))?;
    if let Some(cluster) = &config.cluster {
        print(&format!("workers: lfpiv work --url {}", cluster.url))?;
    }

    let table = Arc::new(Mutex::new(Table::default()));
    let bar = shots.map(|shots| progress_bar(shots.get() as usize, "shots"));
    let bounded_table = shots.is_some().then(|| table.clone());
    let observer = observer(truth, bounded_table, bar.clone(), prints_shots(shots));
    let processor = move || {
        let processor = run_processor(&config)?;
        Ok(move |pair: &_| processor.process_with_light(pair))
    };
    let ended = daemon.run(bench, processor, observer, stop.clone()).await;
    if let Some(bar) = bar {
        bar.finish_and_clear();
    }
    let table = std::mem::take(&mut *table.lock());
    if table.ended() > 0 {
        print(&table.text())?;
    }
    let report = ended?;
    if has_instruments && shots.is_some() {
        print(&stream_table(report.ledger.streams()))?;
    }
    print(&format!("results are in {}", report.folder.display()))?;
    if let Some(shed) = shed(&report, keeps_images) {
        print(&shed)?;
    }
    check_complete(&report, &table, stop.is_cancelled())
}

/// Whether a line is printed for every shot: yes if no progress bar is visible, but not in the
/// system's journal, which contains the log.
fn prints_shots(shots: Option<NonZeroU64>) -> bool {
    let shows_bar = shots.is_some() && io::stdout().is_terminal();
    !shows_bar && !is_journal()
}

/// Returns a function that adds a table row, advances the bar and prints a line for every shot that
/// leaves the pool. Only bounded runs have a table.
fn observer(
    truth: Option<Flow>,
    table: Option<Arc<Mutex<Table>>>,
    bar: Option<ProgressBar>,
    prints: bool,
) -> Observer {
    Box::new(move |record, result| {
        let bar = bar.clone().unwrap_or_else(ProgressBar::hidden);
        bar.suspend(|| {
            for warning in &record.warnings {
                tracing::warn!(shot = record.shot, "{warning}");
            }
            if prints && let Err(error) = print(&shot_line(record)) {
                tracing::warn!("{error:#}");
            }
        });
        if let Some(table) = &table {
            table.lock().push(Row::new(record, result, truth.as_ref()));
        }
        bar.inc(1);
    })
}

/// A line about the outcome of a shot.
fn shot_line(record: &ShotRecord) -> String {
    let shot = record.shot;
    match (record.stage, record.vectors, record.seconds) {
        (Stage::Done, Some(vectors), Some(seconds)) => format!(
            "shot {shot}: {}, {:.1} % valid, measured in {:.2} s",
            count(vectors, "vector"),
            100.0 * record.valid_share.unwrap_or(0.0),
            seconds.total_s()
        ),
        // The log gives the reason.
        (Stage::WriteFailed, ..) => format!("shot {shot}: measured, but not written"),
        _ => format!("shot {shot}: no result"),
    }
}

/// A line about shots that were taken but not measured, and how to measure them; `None` if there
/// are none.
fn shed(report: &DaemonReport, keeps_images: bool) -> Option<String> {
    let shed = |account: &Account| account.outcomes.of(Outcome::Shed);
    let shots = report.ledger.accounts().iter().map(shed).max().filter(|&shots| shots > 0)?;
    let of = report.acquisition.triggers;
    let folder = report.folder.display();
    Some(if keeps_images {
        format!("{shots} of {of} shots were not measured yet: lfpiv process {folder}")
    } else {
        format!(
            "{shots} of {of} shots were not measured, and their images were not kept (raw_log.keep)"
        )
    })
}

/// Fails if some requested shots have no result.
fn check_complete(report: &DaemonReport, table: &Table, stopped: bool) -> anyhow::Result<()> {
    let triggers = report.acquisition.triggers;
    let measured = table.measured();
    if table.ended() == 0 || stopped || measured == triggers {
        return Ok(());
    }
    let ledger = report.folder.join("ledger.json");
    bail!("{} of {triggers} shots gave no result; see {}", triggers - measured, ledger.display())
}
