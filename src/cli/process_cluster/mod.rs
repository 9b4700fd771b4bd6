//! `lfpiv process RUN --cluster URL`: the shots of a recorded run, measured by workers on any machines.
//!
//! The coordinator measures the shot that decides the forward model, offers the others as jobs, serves records
//! and takes results in. It alone writes the run.

mod distribution;

use std::{
    net::{Ipv4Addr, SocketAddr},
    path::Path,
    time::Duration,
};

use anyhow::bail;
use tokio_util::sync::CancellationToken;

use super::{
    broker_args::BrokerArgs,
    process_run::UnfinishedRun,
    recorded_shots::{Finished, ShotProcessor},
};
use distribution::{Distribution, Outcome};

/// Where a coordinator listens unless told otherwise: workers of this machine only.
const THIS_MACHINE: SocketAddr = SocketAddr::new(std::net::IpAddr::V4(Ipv4Addr::LOCALHOST), 0);

/// Arguments of a coordinator.
#[derive(Debug, Clone, clap::Args)]
pub struct ClusterArgs {
    /// Let workers (`lfpiv work`) measure the shots of a recorded run, by way of the NATS server at this
    /// address, as nats://host:4222.
    #[arg(long, value_name = "URL", conflicts_with_all = ["part", "merge"])]
    pub cluster: Option<String>,
    /// Address of this machine at which workers read frames and deliver results.
    #[arg(long, value_name = "ADDRESS", default_value_t = THIS_MACHINE, requires = "cluster")]
    pub serve: SocketAddr,
    /// Address of this machine at which /api/v1/status and /metrics show workers, rates and backlog to programs on
    /// this machine, as 127.0.0.1:8641.
    #[arg(long, value_name = "ADDRESS", requires = "cluster")]
    pub status: Option<SocketAddr>,
    /// Seconds without a heartbeat of its worker after which a shot goes to another one.
    #[arg(long, value_name = "SECONDS", default_value_t = 30.0, value_parser = seconds, requires = "cluster")]
    pub heartbeat_timeout: f64,
    /// Seconds a worker may take over one shot.
    #[arg(long, value_name = "SECONDS", default_value_t = 600.0, value_parser = seconds, requires = "cluster")]
    pub deadline: f64,
    #[command(flatten)]
    pub broker: BrokerArgs,
}

fn seconds(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(seconds) if (0.1..=1e6).contains(&seconds) => Ok(seconds),
        _ => Err("give seconds, from 0.1 to 1000000".into()),
    }
}

/// Has the missing shots of the run in `folder` measured. When interrupted, it ends with what it has.
///
/// # Errors
/// The run or an address cannot be used; shots are left, failed or lost; workers do not compute alike.
pub(super) fn process_cluster(
    folder: &Path,
    args: &ClusterArgs,
    url: &str,
    stop: &CancellationToken,
) -> anyhow::Result<()> {
    if args.serve.ip().is_unspecified() {
        bail!(
            "--serve {}: workers are told this address; give one of this machine's that they can reach",
            args.serve
        );
    }
    if let Some(status) = args.status.filter(|status| !status.ip().is_loopback()) {
        bail!(
            "--status {status}: anybody could read it without a token; give an address as 127.0.0.1:8641"
        )
    }
    let (run, mut store) = UnfinishedRun::open(folder)?;
    let mut losses = run.losses();
    run.settle_ledger()?;
    let missing = run.missing();
    let mut finished = Finished { left: missing.len(), ..Finished::default() };
    let mut unequal = Vec::new();
    let mut reference = None;
    if !missing.is_empty() {
        let UnfinishedRun { config, recorded, index, stored, .. } = &run;
        let mut processor = ShotProcessor::prepare(config, recorded, index, stored)?;
        reference =
            processor.reference(index, &missing, &mut losses, &mut finished, (&mut store, stop))?;
    }
    let rest = &missing[missing.len() - finished.left..];
    match reference.filter(|_| !rest.is_empty()) {
        None => store.close()?,
        Some((shot, result)) => {
            let shots = rest.iter().map(|shot| (*shot).clone()).collect();
            let distribution = Distribution {
                folder,
                recorded: &run.recorded,
                config: &run.config,
                reference: (shot, result),
                broker: args.broker.broker(url),
                serve: args.serve,
                status: args.status,
                heartbeat_timeout: Duration::from_secs_f64(args.heartbeat_timeout),
                deadline: Duration::from_secs_f64(args.deadline),
            };
            let outcome = distribution.distribute(shots, store, stop)?;
            let Outcome { failed, lost, left, differing } = outcome;
            finished.failed.extend(failed);
            finished.left = left;
            lost.into_iter().for_each(|(shot, why)| losses.add(shot, why));
            unequal = differing;
        }
    }
    run.complete(stop)?;
    finished.conclude()?;
    losses.conclude()?;
    if !unequal.is_empty() {
        bail!(
            "workers have delivered unequal results; the first ones are stored\n  {}",
            unequal.join("\n  ")
        )
    }
    Ok(())
}
