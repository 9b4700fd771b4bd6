//! `lfpiv run`: the daemon on the command line.

use std::{num::NonZeroU64, path::PathBuf, sync::Arc};

use anyhow::{Context, bail};
use indicatif::ProgressBar;
use lfpiv_sim::{Pacing, Scene, connect};
use parking_lot::Mutex;
use tokio::signal::unix::{SignalKind, signal};
use tokio_util::sync::CancellationToken;

use super::{
    daemon::{Daemon, DaemonPlan, DaemonReport},
    demo_table::{Row, table},
    output::{print, progress_bar},
};
use crate::{
    acquisition::{Bench, OverloadPolicy},
    config::ConfigFile,
    pipeline::{Observer, Processor, Stage},
};

/// Arguments of `lfpiv run`.
#[derive(Debug, clap::Args)]
pub struct RunArgs {
    /// Configuration file (TOML).
    #[arg(long, value_name = "FILE")]
    pub config: PathBuf,
    /// Stop after this many shots; without it, run until told to stop.
    #[arg(long, value_name = "N")]
    pub shots: Option<NonZeroU64>,
}

/// Runs the bench until its shots are done or it is told to stop by Ctrl-C or SIGTERM.
pub fn run(args: RunArgs) -> anyhow::Result<()> {
    let file = ConfigFile::load(&args.config)?;
    let Some(scene) = file.config.simulation.clone() else {
        bail!(
            "{} has no [simulation] table, and this build has no drivers for cameras and \
             synchroniser: add the table, or start from config/sim.toml",
            args.config.display()
        );
    };
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .enable_all()
        .build()
        .context("the runtime does not start")?;
    runtime.block_on(run_simulated(file, scene, args.shots))
}

async fn run_simulated(
    file: ConfigFile,
    scene: Scene,
    shots: Option<NonZeroU64>,
) -> anyhow::Result<()> {
    // A bounded run is there for its results: the simulated bench waits for them. An unbounded
    // one behaves as a real bench does.
    let (overload, pacing) = match shots {
        Some(_) => (OverloadPolicy::Wait, Pacing::AsFramesAreTaken),
        None => (OverloadPolicy::Shed, Pacing::RealTime),
    };
    let measurement = file.config.measurement();
    let bench = connect(scene.clone(), file.config.bench_geometry(), scene.seed, pacing);
    let bench = Bench { cameras: bench.cameras, synchroniser: bench.synchroniser };
    let stop = stop_on_signals()?;
    let daemon = Daemon::prepare(DaemonPlan { file, shots, overload }).await?;
    print(&format!("status:  http://{}/api/v1/status", daemon.address()))?;
    print(&format!("results: {}", daemon.folder().display()))?;

    let rows = Arc::new(Mutex::new(Vec::new()));
    let bar = shots.map(|shots| progress_bar(shots.get() as usize, "shots"));
    let observer = observer(scene, shots.is_some().then(|| rows.clone()), bar.clone());
    let processor = move || {
        let processor = Processor::new(measurement).context("this cannot be measured")?;
        Ok(move |pair: &_| processor.process(pair))
    };
    let ended = daemon.run(bench, processor, observer, stop.clone()).await;
    if let Some(bar) = bar {
        bar.finish_and_clear();
    }
    let rows = std::mem::take(&mut *rows.lock());
    if !rows.is_empty() {
        print(&table(&rows))?;
    }
    let report = ended?;
    print(&format!("results are in {}", report.folder.display()))?;
    complain(&report, &rows, stop.is_cancelled())
}

/// Collects a table row and moves the bar for every shot that leaves the pool. Only a bounded
/// run keeps rows.
fn observer(
    scene: Scene,
    rows: Option<Arc<Mutex<Vec<Row>>>>,
    bar: Option<ProgressBar>,
) -> Observer {
    Box::new(move |record, result| {
        let bar = bar.clone().unwrap_or_else(ProgressBar::hidden);
        bar.suspend(|| {
            for warning in &record.warnings {
                tracing::warn!(shot = record.shot, "{warning}");
            }
        });
        if let Some(rows) = &rows {
            rows.lock().push(Row::new(record, result, &scene.flow));
        }
        bar.inc(1);
    })
}

/// A token that is cancelled by the first Ctrl-C or SIGTERM. The second one ends the process
/// where it stands; by then the synchroniser has been made safe.
fn stop_on_signals() -> anyhow::Result<CancellationToken> {
    let mut interrupt = signal(SignalKind::interrupt()).context("cannot listen for Ctrl-C")?;
    let mut terminate = signal(SignalKind::terminate()).context("cannot listen for SIGTERM")?;
    let stop = CancellationToken::new();
    let told = stop.clone();
    tokio::spawn(async move {
        loop {
            tokio::select! {
                _ = interrupt.recv() => {}
                _ = terminate.recv() => {}
            }
            if told.is_cancelled() {
                eprintln!("stopped at once; the last results may be left as .part files");
                std::process::exit(130);
            }
            tracing::info!("stopping: the shot in hand is finished first");
            told.cancel();
        }
    });
    Ok(stop)
}

/// A run that was asked for shots and did not measure all of them has not done what it should.
fn complain(report: &DaemonReport, rows: &[Row], stopped: bool) -> anyhow::Result<()> {
    let triggers = report.acquisition.triggers;
    let measured = rows.iter().filter(|row| row.stage == Stage::Done).count() as u64;
    if rows.is_empty() || stopped || measured == triggers {
        return Ok(());
    }
    let ledger = report.folder.join("ledger.json");
    bail!("{} of {triggers} shots gave no result; see {}", triggers - measured, ledger.display())
}
