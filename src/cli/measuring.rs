//! Where a run's shots are measured.

use std::fmt::Display;

use lfpiv_core::{lightfield::ImagePair, velocimetry::PairResult};

use super::live_cluster::{LiveCluster, LiveRun};
use crate::{acquisition::ShotReceiver, pipeline::Pool};

/// By this program, or by workers.
pub(super) enum Measuring<P> {
    Here(Pool<P>),
    Elsewhere(Box<(LiveCluster, LiveRun<P>)>),
}

impl<P, E> Measuring<P>
where
    P: Fn(&ImagePair) -> Result<PairResult, E> + Send + Sync + 'static,
    E: Display + 'static,
{
    /// Measures the shots of `queue` until it is closed, and seals the results.
    pub async fn run(self, queue: ShotReceiver) -> anyhow::Result<()> {
        match self {
            Self::Here(pool) => Ok(pool.run(queue).await?),
            Self::Elsewhere(parts) => {
                let (cluster, run) = *parts;
                cluster.run(run, queue).await
            }
        }
    }
}
