//! The simulated camera.

use std::{
    sync::{Arc, MutexGuard},
    time::{Duration, Instant, SystemTime, UNIX_EPOCH},
};

use lfpiv_hw::{
    CameraName,
    device::{Camera, DeviceError, Frame, FrameStatus, StreamStatistics},
};

use crate::{
    shared_bench::{BenchState, RenderedShot, SharedBench, Stream},
    triggers::{Pacing, Trigger},
};

/// Cameras are switched on at different times: their clocks have the same rate but different origins.
pub(crate) const CLOCK_OFFSET_NS: u64 = 1_234_567_891;

/// Longest sleep before checking the clock again; a change of the bench ends it sooner.
const LONGEST_SLEEP: Duration = Duration::from_secs(3600);

/// A camera that shows the simulated scene, without underruns or packet loss.
pub(crate) struct SimulatedCamera {
    index: usize,
    name: String,
    bench: Arc<SharedBench>,
    /// Statistics of the last stream, once it was stopped.
    last: StreamStatistics,
}

/// State of the next frame.
enum Next {
    Due {
        trigger: Trigger,
        exposure: usize,
        frame_id: u64,
        shot: RenderedShot,
    },
    /// Available at this time on the bench's clock.
    At(u64),
    /// No trigger is scheduled.
    Unknown,
}

impl SimulatedCamera {
    pub(crate) fn new(index: usize, bench: Arc<SharedBench>) -> Self {
        let name = CameraName(index).to_string();
        Self { index, name, bench, last: StreamStatistics::default() }
    }

    fn not_started(&self) -> DeviceError {
        DeviceError::Refused { device: self.name.clone(), detail: "it is not started".into() }
    }

    /// Claims the next frame if it is available.
    fn look(&self, state: &mut MutexGuard<BenchState>) -> Result<Next, DeviceError> {
        let now_ns = self.bench.now_ns();
        state.advance(now_ns);
        let stream = state.streams[self.index].clone().ok_or_else(|| self.not_started())?;
        let number = stream.next_trigger();
        let Some(trigger) = state.triggers.find(number) else {
            return Ok(Next::Unknown);
        };
        let exposure = (stream.frames % 2) as usize;
        if state.triggers.pacing() == Pacing::RealTime {
            let ready_ns = trigger.at_ns(ready_us(&trigger, exposure));
            if now_ns < ready_ns {
                return Ok(Next::At(ready_ns));
            }
        }
        let shot = state.rendered(number);
        if let Some(stream) = &mut state.streams[self.index] {
            stream.frames += 1;
        }
        state.forget_delivered();
        state.advance(now_ns);
        self.bench.notify();
        Ok(Next::Due { trigger, exposure, frame_id: stream.frames, shot })
    }

    /// Renders the shot unless the other camera has done so, and takes this camera's image.
    fn deliver(
        &self,
        trigger: &Trigger,
        exposure: usize,
        frame_id: u64,
        shot: &RenderedShot,
    ) -> Frame {
        let shot = shot.get_or_init(|| self.bench.render(&trigger.schedule, trigger.shot));
        let exposed_us = match exposure {
            0 => trigger.schedule.exposure_1_us[0],
            _ => trigger.schedule.exposure_2_us[0],
        };
        if let Some(stream) = &mut self.bench.lock().streams[self.index] {
            stream.statistics.completed += 1;
        }
        Frame {
            image: shot.images[self.index][exposure].clone(),
            frame_id,
            device_timestamp_ns: trigger.at_ns(exposed_us)
                + CLOCK_OFFSET_NS * (self.index as u64 + 1),
            host_timestamp_ns: since_unix_epoch_ns(),
            status: FrameStatus::Complete,
        }
    }
}

/// When a frame has been read out, in µs after T0; the first is read out during exposure 2.
fn ready_us(trigger: &Trigger, exposure: usize) -> f64 {
    match exposure {
        0 => trigger.schedule.exposure_2_us[1],
        _ => trigger.schedule.camera_ready_us,
    }
}

fn since_unix_epoch_ns() -> u64 {
    SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default().as_nanos() as u64
}

impl Camera for SimulatedCamera {
    fn name(&self) -> &str {
        &self.name
    }

    fn start(&mut self) -> Result<(), DeviceError> {
        let mut state = self.bench.lock();
        if state.streams[self.index].is_some() {
            let detail = "it is already started".into();
            return Err(DeviceError::Refused { device: self.name.clone(), detail });
        }
        state.advance(self.bench.now_ns());
        let first_trigger = state.triggers.given();
        let statistics = StreamStatistics::default();
        state.streams[self.index] = Some(Stream { first_trigger, frames: 0, statistics });
        Ok(())
    }

    /// As in the trait; an available frame is rendered even if that takes longer than `timeout`.
    fn next_frame(&mut self, timeout: Duration) -> Result<Option<Frame>, DeviceError> {
        let called = Instant::now();
        let mut state = self.bench.lock();
        loop {
            let until_due = match self.look(&mut state)? {
                Next::Due { trigger, exposure, frame_id, shot } => {
                    drop(state);
                    return Ok(Some(self.deliver(&trigger, exposure, frame_id, &shot)));
                }
                Next::At(due_ns) => {
                    Duration::from_nanos(due_ns.saturating_sub(self.bench.now_ns()))
                }
                Next::Unknown => LONGEST_SLEEP,
            };
            let left = timeout.saturating_sub(called.elapsed());
            if left.is_zero() {
                return Ok(None);
            }
            state = self.bench.wait(state, until_due.min(left));
        }
    }

    fn stop(&mut self) -> Result<(), DeviceError> {
        let mut state = self.bench.lock();
        if let Some(stream) = state.streams[self.index].take() {
            self.last = stream.statistics;
        }
        state.forget_delivered();
        // A stopped camera does not limit the others.
        self.bench.notify();
        Ok(())
    }

    fn statistics(&self) -> StreamStatistics {
        let state = self.bench.lock();
        state.streams[self.index].as_ref().map_or(self.last, |stream| stream.statistics)
    }
}

impl Drop for SimulatedCamera {
    fn drop(&mut self) {
        let mut state = self.bench.lock();
        state.streams[self.index] = None;
        state.forget_delivered();
        self.bench.notify();
    }
}
