//! `lfpiv work`: measures shots for a coordinator, `lfpiv process RUN --cluster`.
//!
//! A worker keeps nothing: killed at any moment, its shots go to others. It measures a reference before its first
//! shot of a run, and refuses the run if it does not compute as the coordinator does.

mod frames;
mod prepared;
mod signs;
mod slot;

use std::{path::PathBuf, sync::Arc, time::Duration};

use anyhow::Context;
use tokio::task::JoinSet;

use super::{broker_args::BrokerArgs, output::print, stop::stop_on_signals};
use crate::{acquisition::SynchroniserThread, cluster::JobQueue, pipeline::run_after_acquisition};
use signs::Signs;
use slot::Worker;

/// How long measurements that nobody waits for are waited for at the end.
const SHUTDOWN_TIMEOUT: Duration = Duration::from_secs(1);

/// Arguments of `lfpiv work`.
#[derive(Debug, clap::Args)]
pub struct WorkArgs {
    /// Address of the NATS server, as nats://host:4222.
    #[arg(long, value_name = "URL")]
    pub url: String,
    /// Shots measured at a time. Each uses all cores where it can; more slots use more memory.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub slots: u16,
    /// Folder that this machine shares with the coordinator: that of the run, or the one that it is in. Frames
    /// are read there instead of over the network.
    #[arg(long, value_name = "FOLDER")]
    pub shared: Option<PathBuf>,
    /// Name in the coordinator's reports; default: this machine's name and the number of the process.
    #[arg(long, value_name = "NAME")]
    pub name: Option<String>,
    #[command(flatten)]
    pub broker: BrokerArgs,
}

/// Measures shots until it is told to stop, and then ends after those in hand.
///
/// # Errors
/// The broker's address cannot be used, or this worker cannot measure a run as its coordinator does.
pub fn work(args: &WorkArgs) -> anyhow::Result<()> {
    // All threads are started from this one: beside a run, no frame is lost to them.
    run_after_acquisition();
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .worker_threads(2)
        .enable_all()
        .build()
        .context("cannot start the runtime")?;
    let done = runtime.block_on(serve(args));
    runtime.shutdown_timeout(SHUTDOWN_TIMEOUT);
    done
}

async fn serve(args: &WorkArgs) -> anyhow::Result<()> {
    // There is no laser to wait for.
    let laser = SynchroniserThread::default();
    let stop = stop_on_signals(&laser, "its current shots go to other workers")?;
    let name = args.name.clone().unwrap_or_else(own_name);
    let broker = args.broker.broker(&args.url);
    let queue = JobQueue::connect(&broker, &name, "no shots can be fetched until then").await?;
    print(&format!("worker {name}: waits for shots from {}", queue.address()))?;
    let worker = Arc::new(Worker::new(name, queue, args.shared.clone()));
    let mut slots = JoinSet::new();
    for _ in 0..args.slots {
        slots.spawn(worker.clone().serve_slot(stop.clone()));
    }
    let telling = tokio::spawn(tell_for_ever(worker.signs()));
    let mut refused = Ok(());
    while let Some(ended) = slots.join_next().await {
        let ended = ended.context("a slot has failed")?;
        if ended.is_err() {
            stop.cancel();
        }
        refused = refused.and(ended);
    }
    telling.abort();
    let signs = worker.signs();
    let farewell = tokio::task::spawn_blocking(move || signs.end());
    let _ = tokio::time::timeout(SHUTDOWN_TIMEOUT, farewell).await;
    refused
}

/// Gives signs of life until it is aborted.
async fn tell_for_ever(signs: Arc<Signs>) {
    loop {
        tokio::time::sleep(signs::LOOK).await;
        let now = signs.clone();
        if tokio::task::spawn_blocking(move || now.tell()).await.is_err() {
            return;
        }
    }
}

/// The machine's name and the number of this process.
fn own_name() -> String {
    let system = rustix::system::uname();
    format!("{}-{}", system.nodename().to_string_lossy(), std::process::id())
}
