//! A source of triggers that becomes too fast is seen in time whatever the run is doing: the safe
//! state is read back four seconds later at most, with the pacing and the speed of a real line.

use std::time::Duration;

use lfpiv_hw::{
    PulseSchedule, TimingSettings,
    device::{Synchroniser, SynchroniserState, WATCH_INTERVAL},
    synchroniser::{SynchroniserDriver, SynchroniserSettings},
    timing::{ExternalTrigger, TriggerEdge, TriggerSource},
};
use lfpiv_sim::wire::pulse_generator::PulseGeneratorOptions;

use crate::{
    bench::{external_timing, message},
    simulated_time::SimulatedTime,
};

/// From the first trigger that is too fast to the read-back of the safe state.
const LIMIT: Duration = Duration::from_secs(4);
/// A laser of 10 Hz.
const DECLARED_HZ: f64 = 10.0;
const HOUR: Duration = Duration::from_secs(3600);

struct Watched {
    time: SimulatedTime,
    unit: Box<dyn Synchroniser>,
}

impl Watched {
    /// A unit whose lamps go on after a burst, at the end of a slow line.
    fn armed(warm_up_s: f64, pacing_ms: u64) -> Self {
        let options = PulseGeneratorOptions {
            baud_rate: 9600,
            drops_off_after_burst: false,
            ..PulseGeneratorOptions::default()
        };
        let time = SimulatedTime::start(options);
        time.trigger_input(9.0);
        let settings = SynchroniserSettings {
            baud_rate: Some(9600),
            pacing_ms,
            ..SynchroniserSettings::at(SynchroniserDriver::Bnc575, "simulated time")
        };
        let source =
            ExternalTrigger { max_rate_hz: DECLARED_HZ, edge: TriggerEdge::Rising, level_v: 2.5 };
        let timing = TimingSettings {
            trigger: TriggerSource::External,
            external_trigger: Some(source),
            lamp_warm_up_s: warm_up_s,
            ..external_timing()
        };
        let mut unit = time.connect(&settings, &timing);
        unit.program(&PulseSchedule::plan(&timing, 100.0, 9.0).unwrap()).unwrap();
        unit.arm().unwrap();
        Self { time, unit }
    }

    /// Time passes, and the unit is watched as its owner watches it.
    fn pass(&mut self, time: Duration) {
        let end = self.time.now() + time;
        while self.time.now() < end {
            self.time.pass(WATCH_INTERVAL);
            self.unit.watch().unwrap();
        }
    }

    fn fire(&mut self, shots: u64) {
        let wait = self.unit.arm().unwrap();
        self.pass(wait);
        self.unit.fire(shots).unwrap();
    }

    fn finish_burst(&mut self) {
        while self.unit.state().unwrap() == SynchroniserState::Firing {
            self.pass(WATCH_INTERVAL);
        }
    }

    /// The source becomes too fast; the time until the safe state was read back.
    fn seconds_until_safe(mut self, rate_hz: f64) -> f64 {
        let [lamps, _] = self.time.pulses();
        assert!(lamps > 0, "lamps run");
        self.time.trigger_input(rate_hz);
        let begun = self.time.now();
        let refusal = loop {
            self.time.pass(WATCH_INTERVAL);
            assert!(self.time.now() < begun + 2 * LIMIT, "{rate_hz} Hz are not noticed");
            if let Err(error) = self.unit.watch() {
                break error.to_string();
            }
        };
        let taken = self.time.now() - begun;
        assert!(refusal.contains("at most 10 per second, as declared"), "{refusal}");
        assert!(self.time.all_is_off());
        assert_eq!(self.unit.state().unwrap(), SynchroniserState::Safe);
        let pulses = self.time.pulses();
        self.time.pass(Duration::from_secs(1));
        assert_eq!(self.time.pulses(), pulses);
        assert!(taken <= LIMIT, "{taken:?}");
        taken.as_secs_f64()
    }
}

/// The pacing that units need, from the quickest to the slowest.
fn each_pacing(state: &str, watched: impl Fn(u64) -> Watched) {
    for pacing_ms in [50, 60, 100] {
        for rate_hz in [13.0, 30.0, 300.0] {
            let seconds = watched(pacing_ms).seconds_until_safe(rate_hz);
            println!("{state}, {pacing_ms} ms pacing: {rate_hz} Hz, safe after {seconds:.2} s");
        }
    }
}

#[test]
fn armed_for_an_hour() {
    each_pacing("armed for an hour", |pacing_ms| {
        let mut watched = Watched::armed(0.0, pacing_ms);
        watched.pass(HOUR);
        watched
    });
}

#[test]
fn warming_up() {
    each_pacing("warming up", |pacing_ms| {
        let mut watched = Watched::armed(600.0, pacing_ms);
        watched.pass(Duration::from_secs(300));
        assert!(message(watched.unit.fire(1)).contains("the lamps are not warm"));
        watched
    });
}

/// Nothing is asked of the unit after its burst: the gate is shut, and the lamps go on.
#[test]
fn held_after_a_burst() {
    each_pacing("held", |pacing_ms| {
        let mut watched = Watched::armed(0.0, pacing_ms);
        watched.fire(20);
        watched.finish_burst();
        watched.pass(HOUR);
        assert_eq!(watched.time.pulses()[1], 20);
        watched
    });
}

#[test]
fn between_bursts() {
    each_pacing("between bursts", |pacing_ms| {
        let mut watched = Watched::armed(0.0, pacing_ms);
        for _ in 0..10 {
            watched.fire(20);
            watched.finish_burst();
        }
        watched
    });
}

#[test]
fn in_a_burst() {
    each_pacing("in a burst", |pacing_ms| {
        let mut watched = Watched::armed(0.0, pacing_ms);
        watched.pass(Duration::from_secs(600));
        watched.fire(50);
        watched.pass(Duration::from_secs(2));
        assert_eq!(watched.unit.state().unwrap(), SynchroniserState::Firing);
        watched
    });
}

/// A source at its limit for an hour, with bursts in between, is never taken for a faster one.
#[test]
fn a_source_at_its_limit_is_left_alone() {
    let mut watched = Watched::armed(0.0, 60);
    watched.time.trigger_input(DECLARED_HZ);
    for _ in 0..100 {
        watched.pass(Duration::from_secs(30));
        watched.fire(20);
        watched.finish_burst();
    }
    assert_eq!(watched.time.pulses()[1], 2000);
}
