//! The queue of exposures to send, shared between the trigger side and Aravis' sending thread.
//!
//! The fake sends a frame when its software-trigger register is 1. That register is set only while an
//! exposure is queued, first by the trigger side and then by the sending thread itself, so that every
//! frame carries the exposure that caused it.

use std::{
    collections::VecDeque,
    sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError},
    thread::sleep,
    time::{Duration, Instant},
};

use aravis::FakeCamera;
use lfpiv_hw::{RawImage, gige::PixelFormat};

use super::{
    FrameCounts, Ignored, WIRED_LINE,
    pixels::{Region, pack},
    register,
};

/// Exposures held before the next trigger must wait: those of one double exposure.
const HELD_EXPOSURES: usize = 2;

/// Poll rate of the fake for triggers while none is queued, in Hz. It sleeps for whole milliseconds and
/// busy-waits for the rest of each period, so a higher rate costs processor time.
const IDLE_POLL_HZ: f64 = 100.0;

/// Poll rate while an exposure is queued: practically at once.
const BUSY_POLL_HZ: f64 = 100_000.0;

/// Poll interval for the end of the acquisition while an exposure is queued.
const ACQUISITION_POLL: Duration = Duration::from_millis(20);

/// The exposures of a camera that are being sent.
pub(super) struct Feed {
    count_bits: u32,
    line_bytes_per_s: f64,
    state: Mutex<FeedState>,
    changed: Condvar,
}

struct FeedState {
    camera: FakeCamera,
    waiting: VecDeque<Exposure>,
    last_frame_id: u16,
    counts: FrameCounts,
    /// What the sensor sees in free run; dark where nothing is.
    in_view: Option<Arc<RawImage>>,
    /// When the line has transmitted all frames so far, at its rate.
    line_free: Instant,
}

enum Exposure {
    Sent {
        image: Arc<RawImage>,
        device_timestamp_ns: u64,
    },
    /// Counted by the camera, but lost entirely in transit.
    Lost,
}

/// Metadata of a frame.
pub(super) struct FrameLabel {
    pub(super) frame_id: u16,
    /// `None`: the value set by Aravis.
    pub(super) device_timestamp_ns: Option<u64>,
}

impl Feed {
    pub(super) fn new(
        camera: FakeCamera,
        count_bits: u32,
        line_bytes_per_s: f64,
        last_frame_id: u16,
    ) -> Self {
        camera.set_trigger_frequency(IDLE_POLL_HZ);
        let state = FeedState {
            camera,
            waiting: VecDeque::new(),
            last_frame_id,
            counts: FrameCounts::default(),
            in_view: None,
            line_free: Instant::now(),
        };
        Self { count_bits, line_bytes_per_s, state: Mutex::new(state), changed: Condvar::new() }
    }

    /// Every change is complete before the lock is released, so a poisoned lock can be used.
    fn lock(&self) -> MutexGuard<'_, FeedState> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn wait<'a>(&self, state: MutexGuard<'a, FeedState>) -> MutexGuard<'a, FeedState> {
        let woken = self.changed.wait_timeout(state, ACQUISITION_POLL);
        woken.unwrap_or_else(PoisonError::into_inner).0
    }

    /// A trigger pulse. Waits while earlier exposures are still held.
    pub(super) fn expose(
        &self,
        image: Arc<RawImage>,
        device_timestamp_ns: u64,
    ) -> Result<(), Ignored> {
        self.hold(Exposure::Sent { image, device_timestamp_ns })
    }

    /// As [`Self::expose`], for a frame that is lost entirely.
    pub(super) fn lose(&self) -> Result<(), Ignored> {
        self.hold(Exposure::Lost)
    }

    fn hold(&self, exposure: Exposure) -> Result<(), Ignored> {
        let mut state = self.lock();
        state.counts.exposures += 1;
        loop {
            if let Some(reason) = state.ignore_reason() {
                state.drop_waiting();
                state.counts.ignored += 1;
                return Err(reason);
            }
            if state.waiting.len() < HELD_EXPOSURES {
                break;
            }
            state = self.wait(state);
        }
        let is_idle = state.waiting.is_empty();
        state.waiting.push_back(exposure);
        state.count_lost();
        if is_idle && !state.waiting.is_empty() {
            state.camera.write_register(register::RELEASE_FRAME, 1);
        }
        Ok(())
    }

    /// Ends sending: held exposures are lost, and waiting callers return.
    pub(super) fn switch_off(&self) {
        let mut state = self.lock();
        state.camera.write_register(register::ACQUISITION, 0);
        state.drop_waiting();
        self.changed.notify_all();
    }

    /// What frames without an exposure show.
    pub(super) fn show(&self, image: Arc<RawImage>) {
        self.lock().in_view = Some(image);
    }

    pub(super) fn counts(&self) -> FrameCounts {
        self.lock().counts
    }

    pub(super) fn last_frame_id(&self) -> u16 {
        self.lock().last_frame_id
    }

    /// Writes the oldest exposure into a frame. Called on Aravis' thread for every frame it sends.
    /// A frame without an exposure (in free run) shows what is in view.
    pub(super) fn fill(&self, format: u32, region: Region, bytes: &mut [u8]) -> FrameLabel {
        self.wait_for_the_line(bytes.len());
        let (exposure, in_view, frame_id) = {
            let mut state = self.lock();
            let exposure = state.waiting.pop_front();
            state.count_frame();
            let frame_id = state.last_frame_id;
            state.count_lost();
            // This is the fake's thread, the only one that reads the rate.
            if state.waiting.is_empty() {
                state.camera.set_trigger_frequency(IDLE_POLL_HZ);
            } else {
                state.camera.set_trigger_frequency(BUSY_POLL_HZ);
                state.camera.write_register(register::RELEASE_FRAME, 1);
            }
            match exposure {
                Some(_) => state.counts.sent += 1,
                None => state.counts.untriggered += 1,
            }
            self.changed.notify_all();
            (exposure, state.in_view.clone(), frame_id)
        };
        let (image, device_timestamp_ns) = match exposure {
            Some(Exposure::Sent { image, device_timestamp_ns }) => {
                (Some(image), Some(device_timestamp_ns))
            }
            Some(Exposure::Lost) => (None, None),
            None => (in_view, None),
        };
        match image.zip(PixelFormat::from_code(format)) {
            Some((image, format)) => pack(format, &image, region, self.count_bits, bytes),
            None => bytes.fill(0),
        }
        FrameLabel { frame_id, device_timestamp_ns }
    }
}

impl Feed {
    /// Waits for the transmission time of a frame. Without this, frames would arrive at memory
    /// speed, and the loopback drops what the receiver cannot buffer.
    fn wait_for_the_line(&self, bytes: usize) {
        let wait = {
            let mut state = self.lock();
            let now = Instant::now();
            let begin = state.line_free.max(now);
            state.line_free = begin + Duration::from_secs_f64(bytes as f64 / self.line_bytes_per_s);
            begin - now
        };
        sleep(wait);
    }
}

impl FeedState {
    /// Why a trigger pulse would be ignored.
    fn ignore_reason(&self) -> Option<Ignored> {
        let read = |address| self.camera.read_register(address).unwrap_or(0);
        let controlled = self.camera.control_channel_privilege() != 0;
        if !controlled || self.camera.acquisition_status() == 0 {
            Some(Ignored::NotAcquiring)
        } else if read(register::TRIGGER_MODE) == 0 {
            Some(Ignored::FreeRunning)
        } else if read(register::TRIGGER_SOURCE) != WIRED_LINE {
            Some(Ignored::OtherSource)
        } else {
            None
        }
    }

    /// Counts a frame; 0 is not a valid id.
    fn count_frame(&mut self) {
        self.last_frame_id = self.last_frame_id.checked_add(1).unwrap_or(1);
    }

    /// Counts lost frames at the head of the queue: they only leave a gap in the ids.
    fn count_lost(&mut self) {
        while matches!(self.waiting.front(), Some(Exposure::Lost)) {
            self.waiting.pop_front();
            self.count_frame();
            self.counts.lost += 1;
        }
    }

    /// Drops queued exposures when the camera stops.
    fn drop_waiting(&mut self) {
        if !self.waiting.is_empty() {
            self.camera.write_register(register::RELEASE_FRAME, 0);
            self.counts.abandoned += self.waiting.len() as u64;
            self.waiting.clear();
        }
    }
}
