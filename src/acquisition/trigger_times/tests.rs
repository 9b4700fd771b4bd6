use lfpiv_hw::{
    TimingSettings,
    device::{FrameStatus, StreamStatistics},
    timing::{ExternalTrigger, TriggerEdge, TriggerSource},
};

use super::*;
use crate::acquisition::journal::FrameHead;

/// UTC at the start of the run.
const BEGAN_NS: u64 = 1_700_000_000_000_000_000;
const MS: u64 = 1_000_000;
const PERIOD_NS: u64 = 100 * MS;
/// End of exposure 1 after T0, at 10 Hz and 100 µs between the pulses.
const EXPOSED_NS: u64 = 329_000;

/// A run with known true trigger times.
struct Run {
    times: TriggerTimes,
    /// Offset by which the host's clock was set wrong.
    clock_set_by_ns: i64,
}

impl Run {
    fn new() -> Self {
        Self::with(&TimingSettings::default())
    }

    fn with(settings: &TimingSettings) -> Self {
        let schedule = PulseSchedule::plan(settings, 100.0, 10.0).unwrap();
        assert_eq!((schedule.exposure_1_us[1] * 1e3).round() as u64, EXPOSED_NS);
        let mut times = TriggerTimes::default();
        times.see(&Entry::Programmed { at_ns: 0, identity: String::new(), schedule });
        Self { times, clock_set_by_ns: 0 }
    }

    fn utc_ns(&self, at_ns: u64) -> u64 {
        (BEGAN_NS + at_ns).checked_add_signed(self.clock_set_by_ns).unwrap()
    }

    fn fired(&mut self, at_ns: u64, first: u64, shots: u64) {
        self.times.see(&Entry::Fired { at_ns, first, shots });
    }

    /// The burst was accepted at `at_ns` and started no earlier than `not_before_ns`.
    fn started(&mut self, first: u64, not_before_ns: u64, at_ns: u64, error_ns: Option<u64>) {
        let utc_ns = self.utc_ns(at_ns);
        let clock = Some(ClockPair { at_ns, utc_ns, clock_error_ns: error_ns });
        self.times.see(&Entry::BurstStarted { first, start: BurstStart { not_before_ns, clock } });
    }

    /// The frames of a trigger at `t0_ns`, received and handled this long after exposure 1.
    fn shot(&mut self, trigger: u64, t0_ns: u64, received_ns: u64, taken_ns: u64) -> ShotTime {
        let host_ns = self.utc_ns(t0_ns + EXPOSED_NS + received_ns);
        self.frame(t0_ns + EXPOSED_NS + taken_ns, host_ns);
        self.times.of_shot(trigger, [host_ns, host_ns + 5 * MS]).unwrap()
    }

    fn frame(&mut self, at_ns: u64, host_timestamp_ns: u64) {
        let (frame_id, device_timestamp_ns, status) = (0, 0, FrameStatus::Complete);
        let frame = FrameHead { frame_id, device_timestamp_ns, host_timestamp_ns, status };
        let statistics = StreamStatistics::default();
        self.times.see(&Entry::Frame { at_ns, camera: 0, frame, statistics });
    }
}

/// Estimated minus true time, in ns.
fn error_ns(told: ShotTime, t0_ns: u64) -> f64 {
    (told.utc_ns - (BEGAN_NS + t0_ns) as i64) as f64
}

#[test]
fn a_trigger_lies_between_the_start_of_its_burst_and_its_frame() {
    let mut run = Run::new();
    run.fired(1000 * MS, 0, 3);
    run.started(0, 1400 * MS, 1420 * MS, None);
    // The first trigger came 8 ms after the command, the frame 2 ms after its exposure.
    for (trigger, t0_ns) in [(0, 1408 * MS), (1, 1508 * MS), (2, 1608 * MS)] {
        let told = run.shot(trigger, t0_ns, 2 * MS, 30 * MS);
        let expected_ns = (10 * MS) as f64 / 12.0_f64.sqrt();
        // Two quartz clocks may diverge by 10 µs per period, in either direction.
        let uncertainty_ns = told.uncertainty_ns as f64;
        assert!((uncertainty_ns - expected_ns).abs() < 20e3, "{told:?}");
        assert!((error_ns(told, t0_ns) + 3e6).abs() < 20e3, "{told:?}");
        assert!(!told.clock_synchronised);
    }
}

#[test]
fn a_frame_that_is_late_takes_the_bound_of_an_earlier_one() {
    let mut run = Run::new();
    run.fired(0, 0, 2);
    run.started(0, 50 * MS, 60 * MS, None);
    let first = run.shot(0, 52 * MS, MS, 2 * MS);
    let second = run.shot(1, 152 * MS, 700 * MS, 900 * MS);
    assert!((second.utc_ns - first.utc_ns).abs_diff(PERIOD_NS as i64) < 20_000);
    assert!(second.uncertainty_ns < first.uncertainty_ns + 20_000, "{second:?}");
}

#[test]
fn the_clocks_own_error_is_part_of_the_uncertainty() {
    let mut run = Run::new();
    run.fired(0, 0, 1);
    run.started(0, 50 * MS, 60 * MS, Some(20 * MS));
    let told = run.shot(0, 52 * MS, MS, 2 * MS);
    // Bounds 3 ms apart, and a clock error of ±20 ms.
    let expected_ns = 1.5e6_f64.hypot(20e6) / 3.0_f64.sqrt();
    assert!((told.uncertainty_ns as f64 - expected_ns).abs() < 20e3, "{told:?}");
    assert!(told.clock_synchronised);
}

#[test]
fn a_clock_that_is_set_during_a_burst_misplaces_no_shot() {
    for set_by_ns in [-3_600_000_000_000, 3_600_000_000_000, -(40 * MS as i64)] {
        let mut run = Run::new();
        run.fired(0, 0, 2);
        run.started(0, 50 * MS, 51 * MS, None);
        run.clock_set_by_ns = set_by_ns;
        let told = run.shot(0, 52 * MS, MS, 4 * MS);
        // The arrival on the run's clock is a bound that no clock setting moves.
        assert!(error_ns(told, 52 * MS).abs() <= 2.0 * MS as f64, "{set_by_ns}: {told:?}");
    }
}

#[test]
fn a_source_of_its_own_is_bounded_by_each_shots_frame_alone() {
    let external = ExternalTrigger { edge: TriggerEdge::Rising, level_v: 2.5, max_rate_hz: 10.0 };
    let mut run = Run::with(&TimingSettings {
        trigger: TriggerSource::External,
        external_trigger: Some(external),
        ..TimingSettings::default()
    });
    run.fired(0, 0, 3);
    run.started(0, 10 * MS, 11 * MS, None);
    assert_eq!(run.times.expected(1), None);
    run.shot(0, 40 * MS, MS, 2 * MS);
    // 240 ms later, where the fastest allowed source would take 100 ms.
    let told = run.shot(1, 280 * MS, MS, 2 * MS);
    assert!(error_ns(told, 280 * MS).abs() < 1.8 * told.uncertainty_ns as f64, "{told:?}");
    assert!(told.uncertainty_ns as f64 > (170 * MS) as f64 / 12.0_f64.sqrt(), "{told:?}");
}

#[test]
fn a_trigger_without_frames_is_expected_by_the_schedule() {
    let mut run = Run::new();
    run.fired(0, 7, 3);
    assert_eq!(run.times.expected(7), None, "not accepted yet");
    run.started(7, 50 * MS, 60 * MS, None);
    let told = run.times.expected(9).unwrap();
    // Between 250 ms and 360 ms.
    assert!(error_ns(told, 305 * MS).abs() < 50e3, "{told:?}");
    assert!((told.uncertainty_ns as f64 - 110e6 / 12.0_f64.sqrt()).abs() < 50e3, "{told:?}");
    assert_eq!(run.times.expected(6), None, "of another burst");
}

#[test]
fn frames_that_run_ahead_of_the_schedule_bound_their_triggers() {
    // As a simulated bench delivers them that runs without real time.
    let mut run = Run::new();
    run.fired(0, 0, 9);
    run.started(0, 50 * MS, 51 * MS, None);
    let mut last = i64::MIN;
    for trigger in 0..9 {
        let at_ns = 53 * MS + trigger * MS;
        let told = run.shot(trigger, at_ns, 0, MS);
        assert!(told.utc_ns > last, "{trigger}");
        assert!(error_ns(told, at_ns).abs() <= 1.8 * told.uncertainty_ns as f64, "{told:?}");
        last = told.utc_ns;
    }
}

#[test]
fn a_record_without_clock_pairs_goes_by_the_frames_host_times() {
    let mut run = Run::new();
    run.fired(50 * MS, 0, 2);
    for (trigger, t0_ns) in [(0, 55 * MS), (1, 155 * MS)] {
        let told = run.shot(trigger, t0_ns, MS, 3 * MS);
        // Frames were handled 2 ms after reception, which limits what is known of the run's clock.
        assert!(error_ns(told, t0_ns).abs() < 1.8 * told.uncertainty_ns as f64, "{told:?}");
        assert!(told.uncertainty_ns < 5 * MS, "{told:?}");
    }
}

#[test]
fn frames_without_a_host_time_give_none() {
    let mut run = Run::new();
    run.fired(50 * MS, 0, 1);
    run.frame(60 * MS, 0);
    assert_eq!(run.times.of_shot(0, [0, 0]), None);
}
