//! `lfpiv serve`: shows a finished run on the same page and interface as a running one.

mod stored_results;
mod stored_statistics;

use std::{net::SocketAddr, path::PathBuf, sync::Arc};

use anyhow::{Context, bail};
use lfpiv_rawlog::regular_file::read_text;
use parking_lot::Mutex;
use serde_json::json;
use tokio::net::TcpListener;

use self::stored_results::StoredRun;
use super::{
    daemon_plan::DaemonPlan,
    output::{count, print},
    recorded_frames::RecordedFrames,
    recording::refuse_running,
    run_info::{bench_settings, run_info},
    stop::stop_on_signals,
};
use crate::{
    acquisition::{
        Journal, Ledger, Outcome, OverloadPolicy, SynchroniserThread,
        journal::{Entry, RAW_FOLDER, RecordedRun, ledger_of},
    },
    config::{Config, ConfigFile},
    pipeline::{Board, EventKind},
    server::{ApiState, Phase, Protection, serve},
};

/// Arguments of `lfpiv serve`.
#[derive(Debug, clap::Args)]
pub struct ServeArgs {
    /// Folder of a finished run.
    #[arg(value_name = "RUN")]
    pub run: PathBuf,
    /// Address to serve on, instead of the configured one.
    #[arg(long, value_name = "ADDRESS")]
    pub address: Option<SocketAddr>,
}

/// Serves the run until Ctrl-C or SIGTERM. Nothing in its folder is changed.
pub fn serve_run(args: &ServeArgs) -> anyhow::Result<()> {
    if !args.run.is_dir() {
        bail!("{} is not the folder of a run", args.run.display());
    }
    refuse_running(&args.run)?;
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .enable_all()
        .build()
        .context("cannot start the runtime")?;
    runtime.block_on(show(args))
}

async fn show(args: &ServeArgs) -> anyhow::Result<()> {
    let stop = stop_on_signals(&SynchroniserThread::default(), "nothing was being written")?;
    let path = args.run.join("configuration.toml");
    let text = read_text(&path).with_context(|| {
        format!("cannot read {}: is {} the folder of a run?", path.display(), args.run.display())
    })?;
    let mut config = Config::parse("the run's configuration", &text)?;
    if let Some(address) = args.address {
        config.server.address = address;
    }
    let settings = config.server.clone();
    let protection = Protection::open(&settings)?;
    let plan = DaemonPlan {
        raw_log: None,
        ..DaemonPlan::new(ConfigFile { path, text, config }, None, OverloadPolicy::Wait)
    };
    let stored = StoredRun::open(&args.run, plan.file.config.volume.voxel_mm)?;
    let RunHistory { ledger, phase, notes } = history(args, &plan, &stored)?;
    let board = Arc::new(Board::new());
    stored.fill(&board);
    for text in notes {
        let note = json!({ "command": "note", "text": text });
        board.events().publish(EventKind::Control, &note);
    }
    let (shots, shown) = (stored.len(), board.clone());
    let frames = RecordedFrames::new(board.clone(), &args.run).with_last(stored.last());
    let state = ApiState::new(
        run_info(&plan, &args.run),
        Arc::new(Mutex::new(ledger)),
        board.clone(),
        Journal::none(),
    )
    .with_frames(Arc::new(frames))
    .with_results(Arc::new(stored.with_board(board)))
    .with_bench(bench_settings(&plan.file));
    state.set_phase(phase);
    let listener = TcpListener::bind(settings.address).await.with_context(|| {
        format!("cannot listen on {}: give another --address", settings.address)
    })?;
    let address = listener.local_addr().context("the server has no address")?;
    print(&format!("{}: {} with a result", args.run.display(), count(shots, "shot")))?;
    print(&format!("bench:   {}/", settings.url(address)))?;
    let (folder, stopped) = (args.run.clone(), stop.clone());
    // It ends with the server: the runtime waits for it.
    tokio::task::spawn_blocking(move || stored_statistics::gather(&folder, &shown, &stopped));
    serve(listener, state, protection, stop).await;
    Ok(())
}

/// What the record of a run contains.
struct RunHistory {
    ledger: Ledger,
    phase: Phase,
    notes: Vec<String>,
}

fn history(args: &ServeArgs, plan: &DaemonPlan, stored: &StoredRun) -> anyhow::Result<RunHistory> {
    if !args.run.join(RAW_FOLDER).is_dir() {
        return Ok(RunHistory {
            ledger: ledger_of_results(plan, stored)?,
            phase: Phase::Finished,
            notes: Vec::new(),
        });
    }
    let recorded = RecordedRun::open(&args.run)?.finished();
    let ledger =
        ledger_of(&recorded, &stored.shots().collect()).context("the record contradicts itself")?;
    let (mut notes, mut error) = (Vec::new(), Some("the run was cut off".to_owned()));
    for placed in recorded.entries().flatten() {
        match placed.entry {
            Entry::Note { text, .. } => notes.push(text),
            Entry::Ended { error: reason, .. } => error = reason,
            _ => {}
        }
    }
    Ok(RunHistory { ledger, phase: error.map_or(Phase::Finished, Phase::Failed), notes })
}

/// The ledger of a run without raw data: every shot with a result counts as complete.
fn ledger_of_results(plan: &DaemonPlan, stored: &StoredRun) -> anyhow::Result<Ledger> {
    let mut ledger = Ledger::new(plan.file.config.camera.len());
    for shot in stored.shots() {
        ledger.enter(shot)?;
        ledger.mark_queued(shot, &[]);
        ledger.settle_all(shot, Outcome::Complete)?;
    }
    Ok(ledger)
}
