//! What a run is to do.

use std::{num::NonZeroU64, time::Duration};

use anyhow::Context;
use lfpiv_hw::{PulseSchedule, Sensor};
use lfpiv_rawlog::RawLogSettings;

use crate::{
    acquisition::{AcquisitionSettings, Mode, OverloadPolicy, Planner},
    config::ConfigFile,
};

/// Rendering sets the pace of a simulated bench, and may take a minute for a large volume.
const SIMULATED_PATIENCE: Duration = Duration::from_secs(120);

/// What a run is to do.
#[derive(Debug, Clone)]
pub struct DaemonPlan {
    /// The configuration, checked.
    pub file: ConfigFile,
    /// Triggers to give; unbounded when absent.
    pub shots: Option<NonZeroU64>,
    /// What happens when shots come faster than they are processed.
    pub overload: OverloadPolicy,
    /// How the raw data is kept; `None` for a run that is played again.
    pub raw_log: Option<RawLogSettings>,
    /// What it does first.
    pub mode: Mode,
    /// Whether an operator at the bench lets clients arm the laser over HTTP.
    pub remote_arming: bool,
}

impl DaemonPlan {
    /// A run that takes shots at once and keeps its raw data as its configuration says.
    pub fn new(file: ConfigFile, shots: Option<NonZeroU64>, overload: OverloadPolicy) -> Self {
        let raw_log = Some(file.config.raw_log.clone());
        Self { file, shots, overload, raw_log, mode: Mode::Firing, remote_arming: false }
    }

    /// Plans the schedule for another time between the pulses.
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

/// Memory of an image of the sensor.
pub(super) fn frame_bytes(sensor: &Sensor) -> u64 {
    (sensor.columns * sensor.rows * size_of::<u16>()) as u64
}
