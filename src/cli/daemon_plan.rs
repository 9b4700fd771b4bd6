//! Settings of a run.

use std::{num::NonZeroU64, time::Duration};

use anyhow::Context;
use lfpiv_hw::{PulseSchedule, Sensor};
use lfpiv_rawlog::RawLogSettings;

use crate::{
    acquisition::{AcquisitionSettings, Mode, OverloadPolicy, Planner},
    config::ConfigFile,
};

/// Patience with a simulated bench, whose rendering may take a minute for a large volume.
const SIMULATED_PATIENCE: Duration = Duration::from_secs(120);

/// Settings of a run.
#[derive(Debug, Clone)]
pub struct DaemonPlan {
    /// The checked configuration.
    pub file: ConfigFile,
    /// Number of triggers to give; unlimited if `None`.
    pub shots: Option<NonZeroU64>,
    /// What happens when shots arrive faster than they are processed.
    pub overload: OverloadPolicy,
    /// Storage of the raw data; `None` for a replay.
    pub raw_log: Option<RawLogSettings>,
    /// Mode at the start.
    pub mode: Mode,
    /// Whether an operator at the bench allows clients to arm the laser over HTTP.
    pub remote_arming: bool,
}

impl DaemonPlan {
    /// A run that takes shots at once and stores its raw data as configured.
    pub fn new(file: ConfigFile, shots: Option<NonZeroU64>, overload: OverloadPolicy) -> Self {
        let raw_log = Some(file.config.raw_log.clone());
        Self { file, shots, overload, raw_log, mode: Mode::Firing, remote_arming: false }
    }

    /// Returns a function that plans the schedule for another time between the pulses.
    pub(super) fn planner(&self) -> Planner {
        let (timing, rate_hz) = (self.file.config.timing.clone(), self.file.config.shot.rate_hz);
        Box::new(move |dt_us| {
            PulseSchedule::plan(&timing, dt_us, rate_hz).map_err(|error| error.to_string())
        })
    }

    pub(super) fn acquisition(&self) -> anyhow::Result<AcquisitionSettings> {
        let (shot, timing) = (&self.file.config.shot, &self.file.config.timing);
        let schedule = PulseSchedule::plan(timing, shot.dt_us, shot.rate_hz)
            .with_context(|| format!("{}: [shot] cannot be timed", self.file.path.display()))?;
        let instruments = self.file.config.instruments.as_ref();
        Ok(AcquisitionSettings {
            schedule,
            shots: self.shots,
            overload: self.overload,
            patience: instruments.map_or(SIMULATED_PATIENCE, |instruments| {
                Duration::from_secs_f64(instruments.frame_patience_s)
            }),
            frame_bytes: frame_bytes(&self.file.config.optics.sensor),
        })
    }
}

/// Memory of one image, in bytes.
pub(super) fn frame_bytes(sensor: &Sensor) -> u64 {
    (sensor.columns * sensor.rows * size_of::<u16>()) as u64
}
