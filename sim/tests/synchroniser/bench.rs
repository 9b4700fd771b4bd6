//! A driver and its simulated unit, connected.

use std::{
    sync::{Arc, Mutex},
    thread,
    time::{Duration, Instant},
};

use lfpiv_hw::{
    PulseSchedule, TimingSettings,
    device::{DeviceError, Synchroniser, SynchroniserState},
    synchroniser::{
        SynchroniserDriver, SynchroniserSettings,
        line::{RecordedLine, SerialLine, Transcript},
        open_on,
    },
    timing::{ExternalTrigger, TriggerEdge, TriggerSource},
};
use lfpiv_sim::wire::{
    PeriodOutputs,
    pty::Served,
    pulse_generator::{PulseGenerator, PulseGeneratorOptions},
};

/// Opens a unit at its port; nobody listens to the line.
pub fn open(
    settings: &SynchroniserSettings,
    timing: &TimingSettings,
) -> Result<Box<dyn Synchroniser>, DeviceError> {
    lfpiv_hw::synchroniser::open(settings, timing, Transcript::in_memory())
}

/// Longest wait for anything that is sure to come, on a loaded machine.
pub const PATIENCE: Duration = Duration::from_secs(300);

pub struct Bench {
    pub served: Served<PulseGenerator>,
    pub periods: Arc<Mutex<Vec<PeriodOutputs>>>,
}

impl Bench {
    pub fn start(options: PulseGeneratorOptions) -> Self {
        let periods = Arc::new(Mutex::new(Vec::new()));
        let seen = Arc::clone(&periods);
        let observer = Box::new(move |period| seen.lock().unwrap().push(period));
        Self { served: Served::start(PulseGenerator::new(options), observer).unwrap(), periods }
    }

    pub fn usual() -> Self {
        Self::start(PulseGeneratorOptions::default())
    }

    /// Quick commands, patient with replies.
    pub fn settings(&self) -> SynchroniserSettings {
        SynchroniserSettings {
            pacing_ms: 0,
            reply_timeout_ms: 3000,
            ..SynchroniserSettings::at(SynchroniserDriver::Bnc575, self.served.path())
        }
    }

    pub fn connect(&self) -> (Box<dyn Synchroniser>, Transcript) {
        let (unit, transcript) = self.try_connect(&self.settings(), &timing());
        (unit.unwrap(), transcript)
    }

    pub fn connect_with(&self, timing: &TimingSettings) -> Box<dyn Synchroniser> {
        self.try_connect(&self.settings(), timing).0.unwrap()
    }

    pub fn try_connect(
        &self,
        settings: &SynchroniserSettings,
        timing: &TimingSettings,
    ) -> (Result<Box<dyn Synchroniser>, DeviceError>, Transcript) {
        let transcript = Transcript::in_memory();
        let line = SerialLine::open(&settings.port, settings.baud_rates()[0]).unwrap();
        let line = Box::new(RecordedLine::new(line, transcript.clone()));
        (open_on(line, settings, timing), transcript)
    }

    /// Pulses of both Q-switches.
    pub fn q_switch_pulses(&self) -> [u64; 2] {
        let unit = self.served.unit();
        [unit.pulses(2), unit.pulses(4)]
    }

    pub fn lamp_pulses(&self) -> u64 {
        self.served.unit().pulses(1)
    }
}

/// A quick laser and quick cameras: 100 Hz, no warm-up.
pub fn timing() -> TimingSettings {
    TimingSettings {
        laser_rate_limit_hz: 100.0,
        readout_us: 2000.0,
        lamp_warm_up_s: 0.0,
        ..TimingSettings::default()
    }
}

pub fn schedule() -> PulseSchedule {
    PulseSchedule::plan(&timing(), 100.0, 100.0).unwrap()
}

/// Triggers from outside, declared to come 20 times a second at most.
pub fn external_timing() -> TimingSettings {
    let source = ExternalTrigger { max_rate_hz: 20.0, edge: TriggerEdge::Rising, level_v: 2.5 };
    TimingSettings { trigger: TriggerSource::External, external_trigger: Some(source), ..timing() }
}

pub fn external_schedule() -> PulseSchedule {
    PulseSchedule::plan(&external_timing(), 100.0, 10.0).unwrap()
}

/// Arms, waits out what arming asks for, and fires.
pub fn arm_and_fire(unit: &mut dyn Synchroniser, shots: u64) {
    thread::sleep(unit.arm().unwrap());
    unit.fire(shots).unwrap();
}

pub fn wait_until(what: &str, mut reached: impl FnMut() -> bool) {
    let begun = Instant::now();
    while !reached() {
        assert!(begun.elapsed() < PATIENCE, "{what}: not within {PATIENCE:?}");
        thread::sleep(Duration::from_millis(2));
    }
}

pub fn wait_for_state(unit: &mut dyn Synchroniser, state: SynchroniserState) {
    wait_until(&format!("{state:?}"), || unit.state().unwrap() == state);
}

pub fn message<T>(result: Result<T, DeviceError>) -> String {
    match result {
        Ok(_) => panic!("this was not refused"),
        Err(error) => error.to_string(),
    }
}
