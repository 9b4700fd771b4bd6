//! A model of bench and daemon: exposures of the cameras, faults in transit, and the calls of the run
//! loop. It knows the true trigger of each frame and counts deliveries.

use std::{collections::BTreeSet, time::Duration};

use lfpiv_hw::{
    RawImage,
    device::{Frame, FrameStatus},
};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::camera::{FrameTruth, INTERVAL_NS, ModelCamera, PERIOD};
use crate::acquisition::{
    Ledger, Outcome, Shot,
    pairing::{Decision, Pairing, PairingSettings},
};

const PATIENCE: Duration = Duration::from_millis(400);
/// Time step of the run loop.
const TICK: Duration = Duration::from_millis(20);

/// Probabilities of faults.
#[derive(Debug, Clone, Copy)]
pub struct Faults {
    /// Per frame or trigger, each of: frame dropped, duplicated, late, damaged, lost to an underrun;
    /// trigger missed.
    pub share: f64,
    /// Share of triggers whose frames are overtaken by later ones.
    pub overtaking: f64,
    /// Per burst, each of: a camera restarts, a clock jumps, triggers are not given.
    pub burst_share: f64,
}

impl Faults {
    pub const NONE: Self = Self { share: 0.0, overtaking: 0.0, burst_share: 0.0 };
}

/// A frame in transit.
struct Flight {
    arrives: Duration,
    camera: usize,
    counter: u64,
    frame: Frame,
}

pub struct ModelBench {
    pub pairing: Pairing,
    pub ledger: Ledger,
    pub shots: Vec<Shot>,
    /// Triggers given.
    pub given: u64,
    /// Frames handed to pairing.
    pub delivered: u64,
    pub restarts: u64,
    pub withdrawn: u64,
    /// Triggers of bursts whose first trigger no camera saw.
    pub begun_unseen: BTreeSet<u64>,
    pub now: Duration,
    pub cameras: Vec<ModelCamera>,
    faults: Faults,
    flights: Vec<Flight>,
    random: Pcg64Mcg,
}

impl ModelBench {
    pub fn new(seed: u64, faults: Faults) -> Self {
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        let cameras: Vec<_> = (0..2).map(|_| ModelCamera::new(&mut random)).collect();
        let settings = PairingSettings {
            dt_us: 100.0,
            cameras: cameras.len(),
            period_ns: PERIOD.as_nanos() as u64,
            frame_interval_ns: INTERVAL_NS,
            frame_interval_tolerance_ns: 20_000,
            patience: PATIENCE,
        };
        Self {
            pairing: Pairing::new(settings),
            ledger: Ledger::new(cameras.len()),
            shots: Vec::new(),
            given: 0,
            delivered: 0,
            restarts: 0,
            withdrawn: 0,
            begun_unseen: BTreeSet::new(),
            now: Duration::ZERO,
            cameras,
            faults,
            flights: Vec::new(),
            random,
        }
    }

    /// A burst of random length with random faults, and the pause after it.
    pub fn random_burst(&mut self) {
        let asked = match self.pairing.has_reference(self.now) {
            true => self.random.random_range(1..=20),
            false => 1,
        };
        let cut = self.random.random_bool(self.faults.burst_share);
        let given = if cut { self.random.random_range(1..=asked) } else { asked };
        let vanishing = self.random.random_bool(self.faults.burst_share).then(|| {
            (self.random.random_range(0..self.cameras.len()), self.random.random_range(0..given))
        });
        self.burst(asked, given, vanishing);
        if self.random.random_bool(self.faults.burst_share) {
            let camera = self.random.random_range(0..self.cameras.len());
            self.cameras[camera].jump(&mut self.random);
        }
        let pause_ms = match self.random.random_range(0..100) {
            0 => self.random.random_range(200_000..2_000_000),
            1..10 => self.random.random_range(10_000..100_000),
            _ => self.random.random_range(1..3000),
        };
        self.advance(self.now + Duration::from_millis(pause_ms));
    }

    /// Fires `asked` triggers, of which `given` are given. `vanishing`: a camera, and the shot of the
    /// burst at which it is lost; the burst is aborted soon after.
    pub fn burst(&mut self, asked: u64, mut given: u64, vanishing: Option<(usize, u64)>) {
        let first = self.pairing.fired(asked, self.now);
        assert_eq!(first, self.given, "the numbers of withdrawn triggers are used again");
        let start = self.now;
        if let Some((camera, shot)) = vanishing {
            given = given.min(shot + 1 + self.random.random_range(0..3));
            self.cameras[camera].gone_at = Some(start + PERIOD * shot as u32);
        }
        for shot in 0..given {
            let at = start + PERIOD * shot as u32;
            let seen = [0, 1].map(|camera| self.trigger(camera, first + shot, at));
            if shot == 0 && seen == [false; 2] {
                self.begun_unseen.extend(first..first + given);
            }
        }
        self.given += given;
        self.advance(start + PERIOD * given as u32);
        let decisions = self.pairing.burst_ended(self.given).unwrap();
        self.apply(decisions);
        let patience_ends = self.now + 20 * PATIENCE;
        while self.pairing.open_triggers() > 0 {
            self.advance(self.now + TICK);
            assert!(self.now < patience_ends, "every trigger is settled in time");
        }
        if let Some((camera, _)) = vanishing {
            self.restarts += 1;
            self.flights.retain(|flight| flight.camera != camera);
            self.cameras[camera].restart(self.now, &mut self.random);
            self.pairing.camera_returned(camera);
        }
    }

    /// The end of the run.
    pub fn finish(&mut self) {
        let decisions = self.pairing.finish();
        self.apply(decisions);
    }

    /// Response of one camera to a trigger; whether it saw it.
    fn trigger(&mut self, camera: usize, trigger: u64, at: Duration) -> bool {
        let share = self.faults.share;
        let away = self.cameras[camera].gone_at.is_some_and(|gone| at >= gone);
        if away || self.random.random_bool(share) {
            return false;
        }
        let overtaken = self.random.random_bool(self.faults.overtaking);
        let transfer = Duration::from_micros(self.random.random_range(500..5000));
        let stamps = self.cameras[camera].expose(at, &mut self.random);
        for (half, (counter, device_timestamp_ns)) in stamps.into_iter().enumerate() {
            let truth = FrameTruth { trigger, camera, half };
            let image = RawImage::new(1, 1, vec![truth.count()]).unwrap();
            let status = match self.random.random_bool(share) {
                true => FrameStatus::MissingPackets,
                false => FrameStatus::Complete,
            };
            let (frame_id, host_timestamp_ns) = (0, 0);
            let frame = Frame { image, frame_id, device_timestamp_ns, host_timestamp_ns, status };
            let mut arrives = at + transfer * (1 + half as u32);
            if overtaken {
                arrives += Duration::from_millis(self.random.random_range(0..150));
            }
            self.send(Flight { arrives, camera, counter, frame });
        }
        true
    }

    /// Puts a frame in transit: it may be lost, duplicated or delayed.
    fn send(&mut self, mut flight: Flight) {
        let share = self.faults.share;
        if self.random.random_bool(share) {
            return;
        }
        if self.random.random_bool(share) {
            self.cameras[flight.camera].underruns += 1;
            return;
        }
        if self.random.random_bool(share) {
            flight.arrives += PATIENCE * self.random.random_range(50..1000) / 100;
        }
        if self.random.random_bool(share) {
            let again = Duration::from_micros(self.random.random_range(0..600_000));
            let frame = flight.frame.clone();
            self.flights.push(Flight { arrives: flight.arrives + again, frame, ..flight });
        }
        self.flights.push(flight);
    }

    /// Advances time: frames arrive, and the run loop ticks.
    pub fn advance(&mut self, end: Duration) {
        self.flights.sort_by_key(|flight| flight.arrives);
        while self.now < end {
            let arrival = self.flights.first().map_or(end, |flight| flight.arrives);
            let idle = self.pairing.open_triggers() == 0;
            let tick = if idle { end } else { self.now + TICK };
            self.now = self.now.max(arrival.min(tick).min(end));
            while self.flights.first().is_some_and(|flight| flight.arrives <= self.now) {
                let flight = self.flights.remove(0);
                self.arrive(flight);
            }
            let decisions = self.pairing.tick(self.now);
            self.apply(decisions);
        }
    }

    /// As the driver: unwraps the counter.
    fn arrive(&mut self, Flight { arrives, camera, counter, mut frame }: Flight) {
        let gone = self.cameras[camera].gone_at.is_some_and(|gone| arrives >= gone);
        let Some(number) = self.cameras[camera].ids.number(counter).filter(|_| !gone) else {
            return;
        };
        frame.frame_id = number;
        self.delivered += 1;
        self.pairing.underruns(camera, self.cameras[camera].underruns);
        let decisions = self.pairing.frame(camera, frame, self.now);
        self.apply(decisions);
    }

    /// As the run loop; checks both conservation laws after every decision.
    fn apply(&mut self, decisions: Vec<Decision>) {
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
                Decision::Withdrawn { trigger } => {
                    assert!(self.ledger.entry(trigger).is_none(), "it was counted");
                    self.withdrawn += 1;
                }
            }
            assert!(self.ledger.is_balanced());
        }
        let counted = self.pairing.counters();
        let placed = counted.paired + counted.unpaired + counted.duplicate + counted.stray;
        assert_eq!(counted.received, self.delivered);
        assert_eq!(counted.received, placed + self.pairing.held_frames());
    }
}
