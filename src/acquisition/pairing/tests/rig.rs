//! Cameras that lose, damage, duplicate and delay frames and miss triggers, with the pairing under
//! test.

use std::time::Duration;

use lfpiv_hw::{
    RawImage,
    device::{Frame, FrameStatus},
};

use crate::acquisition::{
    Ledger, Outcome, Shot,
    pairing::{Decision, Pairing, PairingSettings},
};

pub const PERIOD_NS: u64 = 100_000_000;
pub const INTERVAL_NS: u64 = 202_000;
/// Initial reading of camera 0's clock.
pub const CLOCK_NS: u64 = 7_000_000_000_000;
pub const PATIENCE: Duration = Duration::from_millis(400);

/// Response of one camera to one trigger.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Fate {
    Delivered,
    Missed,
    LostFirst,
    LostSecond,
    LostBoth,
    Damaged,
    Repeated,
    Delayed,
}

pub fn settings(cameras: usize) -> PairingSettings {
    PairingSettings {
        cameras,
        period_ns: PERIOD_NS,
        frame_interval_ns: INTERVAL_NS,
        frame_interval_tolerance_ns: 20_000,
        dt_us: 100.0,
        patience: PATIENCE,
    }
}

/// A frame; `host_timestamp_ns` carries the true trigger, which pairing must not use.
pub fn frame(frame_id: u64, timestamp_ns: u64, true_trigger: u64) -> Frame {
    Frame {
        image: RawImage::new(1, 1, vec![0]).unwrap(),
        frame_id,
        device_timestamp_ns: timestamp_ns,
        host_timestamp_ns: true_trigger,
        status: FrameStatus::Complete,
    }
}

/// Two cameras with independent clocks, whose frames are fed in order of arrival.
pub struct Rig {
    pub pairing: Pairing,
    pub ledger: Ledger,
    pub shots: Vec<Shot>,
    pub now: Duration,
    pub next_id: Vec<u64>,
    pub given: u64,
    /// Accumulated jump of each camera's clock, in ns.
    pub jumped_ns: Vec<i64>,
}

impl Rig {
    pub fn new(cameras: usize) -> Self {
        Self {
            pairing: Pairing::new(settings(cameras)),
            ledger: Ledger::new(cameras),
            shots: Vec::new(),
            now: Duration::ZERO,
            next_id: vec![0; cameras],
            given: 0,
            jumped_ns: vec![0; cameras],
        }
    }

    pub fn apply(&mut self, decisions: Vec<Decision>) {
        for ruling in decisions {
            match ruling {
                Decision::Paired(shot) => {
                    self.ledger.settle_all(shot.trigger, Outcome::Complete).unwrap();
                    self.shots.push(shot);
                }
                Decision::Settled { trigger, camera, outcome } => {
                    self.ledger.settle(trigger, camera, outcome).unwrap();
                }
                Decision::Given { trigger } => self.ledger.enter(trigger).unwrap(),
                Decision::Withdrawn { trigger } => assert!(self.ledger.entry(trigger).is_none()),
            }
            assert!(self.ledger.is_balanced());
        }
    }

    pub fn fire(&mut self, shots: u64) -> u64 {
        self.pairing.fired(shots, self.now)
    }

    /// Fires a burst, of which the last `cut` triggers are not given, and waits until every trigger is
    /// settled. `fates[shot][camera]`, `jitter_ms[shot][camera]`.
    pub fn burst(&mut self, fates: &[Vec<Fate>], jitter_ms: &[Vec<u64>], cut: usize) {
        let first = self.fire((fates.len() + cut) as u64);
        let mut arrivals = Vec::new();
        for (shot, (fates, jitter)) in fates.iter().zip(jitter_ms).enumerate() {
            let at = self.now + Duration::from_nanos(PERIOD_NS) * shot as u32;
            for (camera, fate) in fates.iter().enumerate() {
                let delivered =
                    self.deliver(camera, *fate, first + shot as u64, at, jitter[camera]);
                arrivals.extend(delivered.into_iter().map(|(at, frame)| (at, camera, frame)));
            }
        }
        self.given += fates.len() as u64;
        arrivals.sort_by_key(|(at, ..)| *at);
        for (at, camera, frame) in arrivals {
            self.wait_until(at);
            let decisions = self.pairing.frame(camera, frame, self.now);
            self.apply(decisions);
        }
        let burst_over = self.now + Duration::from_nanos(PERIOD_NS) * fates.len() as u32;
        self.wait_until(burst_over);
        let decisions = self.pairing.burst_ended(self.given).unwrap();
        self.apply(decisions);
        self.wait_until(self.now + 4 * PATIENCE);
        assert_eq!(self.pairing.open_triggers(), 0, "every trigger is settled in time");
    }

    pub fn wait_until(&mut self, end: Duration) {
        while self.now < end {
            self.now = end.min(self.now + PATIENCE / 4);
            let decisions = self.pairing.tick(self.now);
            self.apply(decisions);
        }
    }

    pub fn deliver(
        &mut self,
        camera: usize,
        fate: Fate,
        trigger: u64,
        at: Duration,
        jitter_ms: u64,
    ) -> Vec<(Duration, Frame)> {
        if fate == Fate::Missed {
            return Vec::new();
        }
        let id = self.next_id[camera];
        self.next_id[camera] += 2;
        // The cameras' clocks have different offsets and differ by 50 ppm.
        let at_ns = at.as_nanos() as u64;
        let clock_ns = CLOCK_NS * (camera as u64 + 1) + at_ns + at_ns / 20_000 * camera as u64;
        let clock_ns = clock_ns.checked_add_signed(self.jumped_ns[camera]).unwrap();
        let mut a = frame(id, clock_ns, trigger);
        let b = frame(id + 1, clock_ns + INTERVAL_NS, trigger);
        if fate == Fate::Damaged {
            a.status = FrameStatus::MissingPackets;
        }
        let mut arrival = at + Duration::from_millis(jitter_ms);
        if fate == Fate::Delayed {
            arrival += PATIENCE * 3 / 2;
        }
        let (a, b) = ((arrival, a), (arrival + Duration::from_millis(jitter_ms % 7), b));
        match fate {
            Fate::LostFirst => vec![b],
            Fate::LostSecond => vec![a],
            Fate::LostBoth => Vec::new(),
            Fate::Repeated => vec![a.clone(), b, a],
            _ => vec![b, a],
        }
    }

    pub fn true_triggers(shot: &Shot) -> Vec<u64> {
        shot.cameras.iter().flatten().map(|frame| frame.host_timestamp_ns).collect()
    }
}
