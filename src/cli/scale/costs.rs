//! What a shot costs, measured on this machine.

use std::time::Instant;

use anyhow::Context;
use lfpiv_core::{measurement::Processor, statistics::median};

use super::{
    model::Costs,
    trial::{Timed, unpacked},
};
use crate::{
    acquisition::journal::{RecordedRun, RecordedShot},
    cli::processor_time::processor_s,
    cluster::Delivery,
};

/// Shots over which the time of measuring is taken.
const MEASURED_SHOTS: usize = 5;
/// Share of a link's rate that TCP over Ethernet leaves to content, with frames of 1500 bytes.
pub(super) const LINK_SHARE: f64 = 0.94;

/// The measurement of a shot itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct ShotCost {
    /// Processor time: seconds times cores.
    pub core_s: f64,
    /// Time on all cores of this machine.
    pub wall_s: f64,
    /// Bytes of its frames as they are on disk: to workers.
    pub frame_bytes: u64,
    /// Bytes of its result: from workers.
    pub result_bytes: u64,
}

impl ShotCost {
    /// Measures shots of a run, by the model that was decided. Medians: other programs may take time of some.
    ///
    /// # Errors
    /// A record cannot be read, or a shot cannot be measured.
    pub fn measure(
        recorded: &RecordedRun,
        processor: &Processor,
        shots: &[RecordedShot],
        delivery: &Delivery,
    ) -> anyhow::Result<Self> {
        let mut frame_bytes = 0;
        let (mut core_s, mut wall_s) = (Vec::new(), Vec::new());
        for shot in shots.iter().cycle().take(MEASURED_SHOTS) {
            let packed = shot.frames.iter().flatten().map(|place| recorded.packed(*place));
            let packed: Vec<Vec<u8>> = packed.collect::<Result<_, _>>()?;
            frame_bytes = packed.iter().map(|frame| frame.len() as u64).sum();
            let (began, before_s) = (Instant::now(), processor_s());
            // A worker unpacks what it has read.
            processor.process(unpacked(&packed, shot.frames.len())?)?;
            core_s.push(processor_s() - before_s);
            wall_s.push(began.elapsed().as_secs_f64());
        }
        Ok(Self {
            core_s: median(core_s).context("the run has no shots")?,
            wall_s: median(wall_s).context("the run has no shots")?,
            frame_bytes,
            result_bytes: delivery.encode().len() as u64,
        })
    }
}

/// All that a shot costs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Measured {
    pub shot: ShotCost,
    /// One worker that does not measure.
    pub alone: Timed,
    /// So many of them that the coordinator is busy.
    pub crowd: Timed,
}

impl Measured {
    /// Of a worker that takes `shot_s` for a shot, at a network of so many bytes a second, if it is limited.
    pub fn costs(&self, shot_s: f64, bytes_per_s: Option<f64>) -> Costs {
        let coordinator_s = 1.0 / self.crowd.shots_per_s;
        // What one worker waits for beyond that is no work of the coordinator.
        let waiting_s = (self.alone.coordinator_s - coordinator_s).max(0.0);
        Costs {
            apart_s: shot_s + self.alone.broker_s + waiting_s,
            network_s: bytes_per_s.map_or(0.0, |rate| self.shot.frame_bytes as f64 / rate),
            coordinator_s,
        }
    }

    /// Of a slot of a machine with so many cores and slots, at a network of so many Gbit/s.
    pub fn of_machine(&self, cores: usize, slots: usize, gbit_per_s: f64) -> Costs {
        let shot_s = slots as f64 * self.shot.core_s / cores as f64;
        let bytes_per_s = LINK_SHARE * gbit_per_s * 1e9 / 8.0;
        self.costs(shot_s, Some(bytes_per_s))
    }
}
