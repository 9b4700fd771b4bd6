//! The simulated synchroniser.

use std::sync::Arc;

use lfpiv_hw::{
    PulseSchedule,
    device::{DeviceError, Synchroniser, SynchroniserState},
};

use crate::{shared_bench::SharedBench, triggers::NotFired};

/// Longest burst that the unit takes (BNC 575: `:BCO`).
const LONGEST_BURST: u64 = 9_999_999;

/// A synchroniser that triggers the simulated cameras of its bench.
pub(crate) struct SimulatedSynchroniser {
    bench: Arc<SharedBench>,
}

impl SimulatedSynchroniser {
    pub(crate) fn new(bench: Arc<SharedBench>) -> Self {
        Self { bench }
    }
}

fn refused(detail: impl Into<String>) -> DeviceError {
    DeviceError::Refused { device: "simulated synchroniser".into(), detail: detail.into() }
}

impl Synchroniser for SimulatedSynchroniser {
    fn identify(&mut self) -> Result<String, DeviceError> {
        Ok(concat!("lfpiv,simulated synchroniser,0,", env!("CARGO_PKG_VERSION")).into())
    }

    fn program(&mut self, schedule: &PulseSchedule) -> Result<(), DeviceError> {
        if !(schedule.period_us.is_finite() && schedule.period_us > 0.0) {
            return Err(refused(format!("period of {} us", schedule.period_us)));
        }
        let mut state = self.bench.lock();
        let now_ns = self.bench.now_ns();
        state.advance(now_ns);
        if state.triggers.firing(now_ns) {
            return Err(refused("timing cannot be changed while a burst is running"));
        }
        state.triggers.program(schedule);
        Ok(())
    }

    fn fire(&mut self, shots: u64) -> Result<(), DeviceError> {
        if !(1..=LONGEST_BURST).contains(&shots) {
            return Err(refused(format!("burst of {shots} shots: allowed: 1 to {LONGEST_BURST}")));
        }
        let mut state = self.bench.lock();
        let now_ns = self.bench.now_ns();
        state.advance(now_ns);
        state.triggers.fire(shots, now_ns).map_err(|reason| match reason {
            NotFired::NotProgrammed => refused("no schedule is programmed"),
            NotFired::StillFiring => refused("a burst is running"),
        })?;
        state.advance(now_ns);
        self.bench.notify();
        Ok(())
    }

    fn trigger_count(&mut self) -> Result<Option<u64>, DeviceError> {
        let mut state = self.bench.lock();
        state.advance(self.bench.now_ns());
        Ok(Some(state.triggers.given_since_programmed()))
    }

    fn state(&mut self) -> Result<SynchroniserState, DeviceError> {
        let mut state = self.bench.lock();
        let now_ns = self.bench.now_ns();
        state.advance(now_ns);
        Ok(if !state.triggers.is_programmed() {
            SynchroniserState::Safe
        } else if state.triggers.firing(now_ns) {
            SynchroniserState::Firing
        } else {
            SynchroniserState::Armed
        })
    }

    fn make_safe(&mut self) -> Result<(), DeviceError> {
        let mut state = self.bench.lock();
        state.advance(self.bench.now_ns());
        state.triggers.make_safe();
        self.bench.notify();
        Ok(())
    }
}
