//! `lfpiv replay`: replays a recorded run through the same run loop and pipeline.

use std::{
    net::{Ipv4Addr, SocketAddr},
    path::{Path, PathBuf},
};

use anyhow::{Context, bail};
use garde::Validate;
use lfpiv_hw::device::Camera;
use lfpiv_rawlog::{Position, regular_file::read_text};
use lfpiv_sim::faults::{FaultSettings, FaultyCamera};

use super::{
    compare::{Results, compare},
    daemon::{Daemon, RunScript},
    daemon_plan::DaemonPlan,
    losses::Losses,
    output::print,
    recording::refuse_running,
    run_processor::run_processor,
    stop::stop_on_signals,
};
use crate::{
    acquisition::{
        Bench, Mode, OverloadPolicy, SynchroniserThread,
        journal::{RecordedRun, RecordedRunError},
        replay::{Replay, Speed, replay},
    },
    config::{Config, ConfigFile},
};

/// Arguments of `lfpiv replay`.
#[derive(Debug, clap::Args)]
pub struct ReplayArgs {
    /// Folder of the recorded run.
    #[arg(value_name = "RUN")]
    pub run: PathBuf,
    /// Folder in which the replay creates its own folder.
    #[arg(long, value_name = "DIR", default_value = "results/replay")]
    pub out: PathBuf,
    /// Speed: that of the run (1), or as fast as frames can be read (max).
    #[arg(long, value_name = "1|max", default_value = "max", value_parser = speed)]
    pub speed: Speed,
    /// File of fault settings (TOML) to disturb the recorded frames.
    #[arg(long, value_name = "FILE")]
    pub faults: Option<PathBuf>,
    /// Address for status and results during the replay; default: a free port of this machine.
    #[arg(long, value_name = "ADDRESS")]
    pub address: Option<SocketAddr>,
}

/// Replays the run. Without faults, results and ledger are compared with the recorded ones, as far
/// as the record is undamaged.
pub fn replay_run(args: &ReplayArgs) -> anyhow::Result<()> {
    let faults = args.faults.as_deref().map(read_faults).transpose()?;
    refuse_running(&args.run)?;
    let mut recorded = Results::read(&args.run)?;
    let index = RecordedRun::open(&args.run)?.finished().index();
    let mut losses = Losses::of(&args.run, &index);
    losses.log();
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .enable_all()
        .build()
        .context("cannot start the runtime")?;
    let (folder, unreadable) = runtime.block_on(play(args, faults.as_ref()))?;
    print(&format!("results are in {}", folder.display()))?;
    for (place, error) in unreadable {
        let shot = index.shots.values().find(|shot| shot.frames.as_flattened().contains(&place));
        match shot {
            Some(shot) => losses.note(shot.trigger, error)?,
            None => losses.note_place(error)?,
        }
    }
    if faults.is_none() {
        let again = Results::read(&folder)?;
        if !losses.is_empty() {
            // The record that assigned frames to shots may be lost, too.
            recorded.leave_out(|shot| {
                losses.has(shot) || !index.shots.contains_key(&shot) || !again.has(shot)
            });
        }
        compare(&recorded, &again)?;
    }
    losses.conclude()
}

/// Frames that could not be read, and the reasons.
type Unread = Vec<(Position, RecordedRunError)>;

async fn play(
    args: &ReplayArgs,
    faults: Option<&FaultSettings>,
) -> anyhow::Result<(PathBuf, Unread)> {
    let stop =
        stop_on_signals(&SynchroniserThread::default(), "the last results may not be on disk")?;
    let acquired = stop.child_token();
    let Replay { description, bench, clock, bursts, longest_burst, unreadable } =
        replay(&args.run, args.speed, acquired.clone())?;
    let mut config = Config::parse("the run's configuration", &description.configuration)?;
    config.output.dir.clone_from(&args.out);
    config.server.address =
        args.address.unwrap_or_else(|| SocketAddr::from((Ipv4Addr::LOCALHOST, 0)));
    let measured = config.clone();
    let path = args.run.join("configuration.toml");
    let plan = DaemonPlan {
        file: ConfigFile { path, text: description.configuration, config },
        shots: None,
        overload: OverloadPolicy::Wait,
        raw_log: None,
        mode: Mode::Firing,
        remote_arming: false,
    };
    let mut daemon = Daemon::prepare(plan).await?;
    let longest_burst = usize::try_from(longest_burst).unwrap_or(usize::MAX);
    daemon.follow(RunScript { clock, bursts, stop: acquired, longest_burst });
    let processor = move || {
        let processor = run_processor(&measured)?;
        Ok(move |pair: &_| processor.process(pair))
    };
    let bench = match faults {
        Some(faults) => disturbed(bench, faults),
        None => bench,
    };
    let report = daemon.run(bench, processor, Box::new(|_, _| {}), stop).await?;
    Ok((report.folder, unreadable.take()))
}

fn disturbed(bench: Bench, faults: &FaultSettings) -> Bench {
    let wrap = |(index, camera): (usize, Box<dyn Camera>)| {
        Box::new(FaultyCamera::new(camera, index, faults)) as Box<dyn Camera>
    };
    Bench { cameras: bench.cameras.into_iter().enumerate().map(wrap).collect(), ..bench }
}

/// Reads and checks a file of fault settings.
pub(super) fn read_faults(path: &Path) -> anyhow::Result<FaultSettings> {
    let text = read_text(path).with_context(|| format!("cannot read {}", path.display()))?;
    let faults: FaultSettings =
        toml::from_str(&text).with_context(|| format!("{} is not a fault file", path.display()))?;
    if let Err(problems) = faults.validate() {
        bail!("{}: {problems}", path.display());
    }
    Ok(faults)
}

fn speed(text: &str) -> Result<Speed, String> {
    match text {
        "1" => Ok(Speed::Recorded),
        "max" => Ok(Speed::Max),
        other => Err(format!("'{other}': allowed: 1, max")),
    }
}
