use garde::Validate;
use proptest::{prelude::*, strategy::ValueTree};

use super::*;

fn plan(dt_us: f64, rate_hz: f64) -> Result<PulseSchedule, TimingError> {
    PulseSchedule::plan(&TimingSettings::default(), dt_us, rate_hz)
}

fn refusal(settings: &TimingSettings, dt_us: f64, rate_hz: f64) -> String {
    PulseSchedule::plan(settings, dt_us, rate_hz).unwrap_err().to_string()
}

#[test]
fn the_figures_of_design_section_5() {
    for dt_us in [4.0, 100.0, 202.0] {
        let schedule = plan(dt_us, 10.0).unwrap();
        assert_eq!(schedule.period_us, 100_000.0);
        assert_eq!(schedule.lamp_us, [100.0, 100.0 + dt_us]);
        assert_eq!(schedule.q_switch_us, [280.0, 280.0 + dt_us]);
        assert_eq!(schedule.camera_trigger_us, 76.0 + dt_us / 2.0);
    }
    // Beyond 202 µs the gap starts half an exposure after Q1.
    let slow = plan(1000.0, 10.0).unwrap();
    assert_eq!(slow.camera_trigger_us, 280.0 + 100.0 - 200.0 - 3.0);
    assert_eq!(slow.exposure_1_us, [180.0, 380.0]);
    assert_eq!(slow.exposure_2_us, [382.0, 40_382.0]);
    assert_eq!(slow.camera_ready_us, 80_382.0);
}

#[test]
fn pulses_nearer_than_gap_and_margins_are_refused() {
    let error = plan(3.0, 10.0).unwrap_err();
    assert_eq!(error.violations.len(), 2, "{error}");
    let text = error.to_string();
    assert!(text.contains("Q1 = 280.000 us"), "{text}");
    assert!(text.contains("to 279.500 us"), "{text}");
    assert!(text.contains("Q2 = 283.000 us"), "{text}");
}

#[test]
fn fifteen_hertz_is_refused_by_laser_and_by_camera() {
    let text = refusal(&TimingSettings::default(), 100.0, 15.0);
    assert!(text.contains("laser rate = 15 Hz: allowed: at most 10 Hz"), "{text}");
    assert!(text.contains("80331.000 us"), "{text}");
    assert!(text.contains("66666.667 us"), "{text}");
}

#[test]
fn signals_must_stay_inside_the_period() {
    let early = TimingSettings { lamp_to_q_switch_us: [10.0, 250.0], ..TimingSettings::default() };
    let text = refusal(&early, 4.0, 10.0);
    // Q2 at 114, lamp 2 180 µs earlier; exposure 1 would start at −89.
    assert!(text.contains("lamp 2 lasts from -136.000 to -86.000 us"), "{text}");
    assert!(text.contains("camera trigger lasts from -92.000"), "{text}");
    let text = refusal(&TimingSettings::default(), 99_700.0, 10.0);
    assert!(text.contains("Q-switch 2 lasts from 99980.000 to 100030.000 us"), "{text}");
    assert!(text.contains("Q2 = 99980.000 us"), "{text}");
}

#[test]
fn nan_and_values_that_are_not_positive_are_refused() {
    for bad in [f64::NAN, f64::INFINITY, 0.0, -5.0] {
        assert!(refusal(&TimingSettings::default(), bad, 10.0).contains("dt_us"));
        assert!(refusal(&TimingSettings::default(), 100.0, bad).contains("rate_hz"));
    }
    let broken = TimingSettings { readout_us: f64::NAN, ..TimingSettings::default() };
    assert!(broken.validate().unwrap_err().to_string().contains("readout_us"));
    assert!(TimingSettings::default().validate().is_ok());
}

/// Independent implementation of the rules of docs/theory.md, section 7, in half-nanoseconds.
struct WholeNumbers {
    lamp_1: i64,
    lamp_to_q: [i64; 2],
    latency: i64,
    exposure_1: i64,
    gap: i64,
    readout: i64,
    margin: i64,
    width: i64,
    dt: i64,
    period: i64,
    /// Shortest period allowed by the laser.
    laser_period: i64,
    /// `None` for the unit's own clock; else the shortest period of the declared source, if declared.
    external: Option<Option<i64>>,
}

impl WholeNumbers {
    fn allowed(&self) -> bool {
        let q1 = self.lamp_1 + self.lamp_to_q[0];
        let q2 = q1 + self.dt;
        let close = self.dt - self.gap <= self.exposure_1;
        let trigger = if close {
            q1 + (self.dt - self.gap) / 2 - self.exposure_1 - self.latency
        } else {
            q1 - self.exposure_1 / 2 - self.latency
        };
        let opens = trigger + self.latency;
        let closes = opens + self.exposure_1;
        let opens_again = closes + self.gap;
        let closes_again = opens_again + self.readout;
        let (rate_allowed, shortest) = match self.external {
            None => (true, self.period),
            Some(None) => (false, self.period),
            Some(Some(source)) => (source >= self.laser_period && source <= self.period, source),
        };
        let signals = [self.lamp_1, q2 - self.lamp_to_q[1], q1, q2, trigger];
        (opens + self.margin..=closes - self.margin).contains(&q1)
            && (opens_again + self.margin..=closes_again - self.margin).contains(&q2)
            && closes_again + self.readout < shortest
            && signals.iter().all(|&start| start >= 0 && start + self.width <= shortest)
            && self.period >= self.laser_period
            && rate_allowed
    }

    fn settings(&self) -> TimingSettings {
        TimingSettings {
            laser_rate_limit_hz: 1e6 / us(self.laser_period),
            lamp_1_us: us(self.lamp_1),
            lamp_to_q_switch_us: self.lamp_to_q.map(us),
            camera_latency_us: us(self.latency),
            exposure_1_us: us(self.exposure_1),
            gap_us: us(self.gap),
            readout_us: us(self.readout),
            margin_us: us(self.margin),
            pulse_width_us: us(self.width),
            trigger: match self.external {
                None => TriggerSource::Internal,
                Some(_) => TriggerSource::External,
            },
            external_trigger: self.external.flatten().map(|source| ExternalTrigger {
                max_rate_hz: 1e6 / us(source),
                edge: TriggerEdge::Rising,
                level_v: 2.5,
            }),
            ..TimingSettings::default()
        }
    }
}

fn us(half_nanoseconds: i64) -> f64 {
    half_nanoseconds as f64 / 2000.0
}

/// Whole nanoseconds, as an even number of half-nanoseconds.
fn ns(range: std::ops::Range<i64>) -> impl Strategy<Value = i64> {
    range.prop_map(|nanoseconds| 2 * nanoseconds)
}

prop_compose! {
    fn cases()(
        lamp_1 in ns(0..300_000),
        lamp_to_q in [ns(50_000..300_000), ns(50_000..300_000)],
        latency in ns(0..10_000),
        exposure_1 in ns(5_000..300_000),
        gap in ns(0..4_000),
        readout in ns(20_000..2_000_000),
        margin in ns(0..3_000),
        width in ns(10..100_000),
        dt in ns(1..12_000),
        longer_dt in prop_oneof![Just(0), ns(0..3_000_000)],
        period in ns(100_000..4_000_000),
        laser_period in prop_oneof![Just(2_000), ns(100_000..4_000_000)],
        external in prop_oneof![
            3 => Just(None),
            1 => Just(Some(None)),
            3 => ns(100_000..4_000_000).prop_map(|source| Some(Some(source))),
        ],
    ) -> WholeNumbers {
        let dt = dt + longer_dt;
        WholeNumbers {
            lamp_1, lamp_to_q, latency, exposure_1, gap, readout, margin, width, dt, period,
            laser_period, external,
        }
    }
}

impl std::fmt::Debug for WholeNumbers {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(formatter, "{:?}, dt {}, period {}", self.settings(), us(self.dt), us(self.period))
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4096))]
    #[test]
    fn plans_agree_with_the_rules_in_whole_numbers(case in cases()) {
        let planned = PulseSchedule::plan(&case.settings(), us(case.dt), 1e6 / us(case.period));
        prop_assert_eq!(planned.is_ok(), case.allowed(), "{:?}", planned);
    }
}

#[test]
fn random_cases_break_the_rules_and_keep_them() {
    let mut runner = proptest::test_runner::TestRunner::deterministic();
    let strategy = cases();
    let allowed =
        (0..4096).filter(|_| strategy.new_tree(&mut runner).unwrap().current().allowed()).count();
    assert!((100..4000).contains(&allowed), "{allowed} of 4096");
}
