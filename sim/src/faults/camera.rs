//! A camera with injected frame faults.

mod damage;
mod device_clock;

use std::{collections::VecDeque, time::Duration};

use lfpiv_hw::{
    CameraName,
    device::{Camera, DeviceError, Frame, FrameStatus, StreamStatistics},
};
use rand::Rng;

use self::device_clock::DeviceClock;
use super::{CameraFaults, Clock, FaultRecord, FaultSettings, SystemClock, draw};
use crate::stream::{Purpose, random_stream};

/// A fault of a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum FrameFault {
    /// The camera did not see the trigger; recorded for both of its frames.
    MissedTrigger,
    /// It was lost.
    Dropped,
    /// It was delayed.
    Late,
    /// It was overtaken by later frames.
    Reordered,
    /// It was delivered twice.
    Duplicated,
    /// Its lower rows are zero, and its status says so.
    Truncated,
    /// Its lower rows are missing, and its status says complete.
    Cropped,
    /// Bits are flipped, and its status says complete.
    Corrupted,
    /// From this frame on the camera's clock is off by this much more, in ns.
    ClockJump(i64),
    /// It was delayed, and the camera was stopped before its time.
    Undelivered,
    /// It was the first one after the connection was lost.
    Disconnected,
}

/// Any camera, with the faults of [`CameraFaults`].
pub struct FaultyCamera<C> {
    camera: C,
    faults: CameraFaults,
    /// Selects this camera's random streams.
    stream: [u64; 2],
    clock: Box<dyn Clock>,
    device_clock: DeviceClock,
    record: FaultRecord<FrameFault>,
    /// Frames received from the camera, over all starts.
    taken: u64,
    /// Frames passed on without delay; duplicates count twice.
    passed: u64,
    /// Frames missing in the camera's numbering, for triggers that it did not see.
    uncounted: u64,
    /// Frame b of a missed trigger.
    missed_frame_b: Option<u64>,
    held: Vec<HeldFrame>,
    /// Frames that are due.
    ready: VecDeque<HeldFrame>,
    statistics: StreamStatistics,
    disconnected: bool,
}

/// A delayed frame.
struct HeldFrame {
    /// Its number at the wrapped camera.
    number: u64,
    frame: Frame,
    until: Until,
}

#[derive(Debug, Clone, Copy)]
enum Until {
    /// Until this time.
    Time(Duration),
    /// Until this many frames were passed on without delay.
    Passed(u64),
}

impl<C: Camera> FaultyCamera<C> {
    /// Wraps camera number `index` (from 0), which selects its random streams.
    pub fn new(camera: C, index: usize, settings: &FaultSettings) -> Self {
        Self::timed_by(camera, index, settings, SystemClock::default())
    }

    /// As [`Self::new`], with delays on `clock`.
    pub fn timed_by(
        camera: C,
        index: usize,
        settings: &FaultSettings,
        clock: impl Clock + 'static,
    ) -> Self {
        let spared =
            settings.camera.only.as_ref().is_some_and(|only| !only.contains(&CameraName(index)));
        let faults = if spared { CameraFaults::default() } else { settings.camera.clone() };
        Self {
            device_clock: DeviceClock::new(faults.clock_drift_ppm),
            camera,
            faults,
            stream: [settings.seed, index as u64],
            clock: Box::new(clock),
            record: FaultRecord::default(),
            taken: 0,
            passed: 0,
            uncounted: 0,
            missed_frame_b: None,
            held: Vec::new(),
            ready: VecDeque::new(),
            statistics: StreamStatistics::default(),
            disconnected: false,
        }
    }

    /// The injected faults so far.
    pub fn record(&self) -> FaultRecord<FrameFault> {
        self.record.clone()
    }

    /// Number of delayed frames.
    pub fn held(&self) -> usize {
        self.held.len() + self.ready.len()
    }

    fn check_connection(&self) -> Result<(), DeviceError> {
        if !self.disconnected {
            return Ok(());
        }
        Err(DeviceError::Lost {
            device: self.camera.name().to_owned(),
            detail: format!("disconnected on purpose after {} frames", self.taken),
        })
    }

    /// Receives a frame from the camera: drops, delays or passes it on.
    fn take(&mut self, mut frame: Frame) -> Result<(), DeviceError> {
        let number = frame.frame_id;
        self.record.take();
        if self.faults.disconnect_after.is_some_and(|after| self.taken >= after) {
            self.disconnected = true;
            self.record.note(number, FrameFault::Disconnected);
            return self.check_connection();
        }
        let ordinal = self.taken;
        self.taken += 1;
        for jump in self.faults.clock_jumps.iter().filter(|jump| jump.frame == ordinal) {
            self.device_clock.jump(jump.jump_ns);
            self.record.note(number, FrameFault::ClockJump(jump.jump_ns));
        }
        frame.device_timestamp_ns = self.device_clock.read(frame.device_timestamp_ns);
        if self.missed_frame_b.take() == Some(number) {
            self.record.note(number, FrameFault::MissedTrigger);
        } else {
            frame.frame_id = number.saturating_sub(self.uncounted);
            self.disturb(number, ordinal, frame);
        }
        self.release_overtaken();
        Ok(())
    }

    fn disturb(&mut self, number: u64, ordinal: u64, frame: Frame) {
        let [seed, index] = self.stream;
        let mut rng = random_stream(Purpose::CameraFaults, &[seed, index, ordinal]);
        let fault = self.draw_fault(number, &mut rng);
        let now = self.clock.now();
        match fault {
            Some(FrameFault::MissedTrigger) => {
                self.missed_frame_b = Some(number + 1);
                self.uncounted += 2;
            }
            Some(FrameFault::Dropped) => {}
            Some(FrameFault::Late) => {
                let until = Until::Time(now + Duration::from_millis(self.faults.late_ms));
                self.held.push(HeldFrame { number, frame, until });
            }
            Some(FrameFault::Reordered) => {
                let until = Until::Passed(self.passed + self.faults.reordered_by);
                self.held.push(HeldFrame { number, frame, until });
            }
            Some(FrameFault::Duplicated) => {
                self.be_ready(number, frame.clone());
                self.be_ready(number, frame);
            }
            damage => {
                let frame = damage::damaged(frame, damage, self.faults.corrupted_bits, &mut rng);
                self.be_ready(number, frame);
            }
        }
        if let Some(fault) = fault {
            self.record.note(number, fault);
        }
    }

    fn draw_fault(&self, number: u64, rng: &mut impl Rng) -> Option<FrameFault> {
        let mut shares = self.faults.shares.by_fault();
        for (fault, share) in &mut shares {
            // A trigger is missed as a whole, starting with frame a.
            if *fault == FrameFault::MissedTrigger && number % 2 == 1 {
                *share = 0.0;
            }
        }
        draw(&shares, rng)
    }

    fn be_ready(&mut self, number: u64, frame: Frame) {
        self.passed += 1;
        self.ready.push_back(HeldFrame { number, frame, until: Until::Passed(self.passed) });
    }

    /// Releases reordered frames after the frame that overtakes them.
    fn release_overtaken(&mut self) {
        let passed = self.passed;
        let overtaken =
            |held: &mut HeldFrame| matches!(held.until, Until::Passed(at) if at <= passed);
        self.ready.extend(self.held.extract_if(.., overtaken));
    }

    /// The next frame that is due.
    fn release(&mut self) -> Option<Frame> {
        let now = self.clock.now();
        let due = |held: &mut HeldFrame| matches!(held.until, Until::Time(at) if at <= now);
        self.ready.extend(self.held.extract_if(.., due));
        let frame = self.ready.pop_front()?.frame;
        self.record.give();
        match frame.status {
            FrameStatus::Complete => self.statistics.completed += 1,
            FrameStatus::MissingPackets => self.statistics.failed += 1,
        }
        Some(frame)
    }

    /// When the next delayed frame is due.
    fn next_due(&self) -> Option<Duration> {
        let times = self.held.iter().filter_map(|held| match held.until {
            Until::Time(time) => Some(time),
            Until::Passed(_) => None,
        });
        times.min()
    }

    fn drop_held(&mut self) {
        for held in self.ready.drain(..).chain(self.held.drain(..)) {
            self.record.note(held.number, FrameFault::Undelivered);
        }
    }
}

impl<C: Camera> Camera for FaultyCamera<C> {
    fn name(&self) -> &str {
        self.camera.name()
    }

    fn start(&mut self) -> Result<(), DeviceError> {
        self.check_connection()?;
        self.drop_held();
        self.statistics = StreamStatistics::default();
        // The camera counts frames from zero again.
        (self.uncounted, self.missed_frame_b) = (0, None);
        self.camera.start()
    }

    fn next_frame(&mut self, timeout: Duration) -> Result<Option<Frame>, DeviceError> {
        let deadline = self.clock.now() + timeout;
        loop {
            self.check_connection()?;
            if let Some(frame) = self.release() {
                return Ok(Some(frame));
            }
            let until = self.next_due().map_or(deadline, |due| due.min(deadline));
            let wait = until.saturating_sub(self.clock.now());
            match self.camera.next_frame(wait)? {
                Some(frame) => self.take(frame)?,
                // A camera that returns before the timeout may have no more frames.
                None => self.clock.sleep(until.saturating_sub(self.clock.now())),
            }
            if self.clock.now() >= deadline {
                return Ok(self.release());
            }
        }
    }

    fn stop(&mut self) -> Result<(), DeviceError> {
        self.drop_held();
        self.camera.stop()
    }

    /// Counts frames as delivered here; other counters are the wrapped camera's.
    fn statistics(&self) -> StreamStatistics {
        let StreamStatistics { completed, failed, .. } = self.statistics;
        StreamStatistics { completed, failed, ..self.camera.statistics() }
    }

    fn is_connected(&self) -> bool {
        !self.disconnected && self.camera.is_connected()
    }

    fn loss_detection_time(&self) -> Duration {
        self.camera.loss_detection_time()
    }
}
