//! Replaying cameras and synchroniser.

use std::{sync::Arc, time::Duration};

use lfpiv_hw::{
    CameraName,
    device::{Camera, DeviceError, Frame, StreamStatistics, Synchroniser, SynchroniserState},
    timing::PulseSchedule,
};

use super::script::{BurstState, Script, Turn};

/// Delivers the recorded frames of one camera.
pub(super) struct ReplayCamera {
    name: String,
    index: usize,
    script: Arc<Script>,
    /// Its step has been delivered, and ends with the next call.
    is_playing: bool,
    connected: bool,
    statistics: StreamStatistics,
}

impl ReplayCamera {
    pub fn new(index: usize, script: Arc<Script>) -> Self {
        Self {
            name: CameraName(index).to_string(),
            index,
            script,
            is_playing: false,
            connected: true,
            statistics: StreamStatistics::default(),
        }
    }

    fn finish_turn(&mut self) {
        if std::mem::take(&mut self.is_playing) {
            self.script.finish();
        }
    }
}

impl Camera for ReplayCamera {
    fn name(&self) -> &str {
        &self.name
    }

    fn start(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }

    fn next_frame(&mut self, timeout: Duration) -> Result<Option<Frame>, DeviceError> {
        self.finish_turn();
        match self.script.turn(self.index, timeout) {
            Turn::Frame { frame, statistics } => {
                (self.is_playing, self.statistics) = (true, statistics);
                Ok(Some(frame))
            }
            Turn::Stream { connected, statistics } => {
                (self.is_playing, self.statistics) = (true, statistics);
                self.connected = connected;
                Ok(None)
            }
            Turn::None => Ok(None),
        }
    }

    fn stop(&mut self) -> Result<(), DeviceError> {
        self.finish_turn();
        Ok(())
    }

    fn statistics(&self) -> StreamStatistics {
        self.statistics
    }

    fn is_connected(&self) -> bool {
        self.connected
    }
}

/// Replays the recorded bursts; there is no laser.
pub(super) struct ReplayUnit {
    script: Arc<Script>,
    state: SynchroniserState,
    /// A burst was fired, and its end has not been observed.
    is_burst_open: bool,
    /// It was made safe, and this has not been read back.
    is_safe_unread: bool,
}

impl ReplayUnit {
    pub fn new(script: Arc<Script>) -> Self {
        let state = SynchroniserState::Safe;
        Self { script, state, is_burst_open: false, is_safe_unread: false }
    }
}

impl Synchroniser for ReplayUnit {
    fn identify(&mut self) -> Result<String, DeviceError> {
        Ok("lfpiv,recorded run".to_owned())
    }

    fn program(&mut self, _: &PulseSchedule) -> Result<(), DeviceError> {
        self.state = SynchroniserState::Armed;
        Ok(())
    }

    fn fire(&mut self, shots: u64) -> Result<(), DeviceError> {
        self.script.fire(shots).map_err(|detail| DeviceError::Refused {
            device: "recorded synchroniser".to_owned(),
            detail,
        })?;
        self.is_burst_open = true;
        Ok(())
    }

    fn trigger_count(&mut self) -> Result<Option<u64>, DeviceError> {
        Ok(Some(self.script.given()))
    }

    fn state(&mut self) -> Result<SynchroniserState, DeviceError> {
        if !std::mem::take(&mut self.is_safe_unread) && self.is_burst_open {
            // However the burst ended, the record has the time at which the run loop noticed.
            let burst = self.script.burst_state();
            self.is_burst_open = burst == BurstState::Firing;
            match burst {
                BurstState::Firing => return Ok(SynchroniserState::Firing),
                BurstState::Lost => return Ok(SynchroniserState::Unknown),
                BurstState::Over => {}
            }
        }
        Ok(self.state)
    }

    fn make_safe(&mut self) -> Result<(), DeviceError> {
        self.state = SynchroniserState::Safe;
        self.is_safe_unread = true;
        Ok(())
    }
}
