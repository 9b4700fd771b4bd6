//! Limits of units, and external triggers.

use proptest::prelude::*;

use super::*;

fn plan(settings: &TimingSettings, dt_us: f64, rate_hz: f64) -> Result<PulseSchedule, TimingError> {
    PulseSchedule::plan(settings, dt_us, rate_hz)
}

fn usual(dt_us: f64, rate_hz: f64) -> PulseSchedule {
    plan(&TimingSettings::default(), dt_us, rate_hz).unwrap()
}

fn external(max_rate_hz: f64) -> TimingSettings {
    let source = ExternalTrigger { max_rate_hz, edge: TriggerEdge::Rising, level_v: 2.5 };
    TimingSettings {
        trigger: TriggerSource::External,
        external_trigger: Some(source),
        ..TimingSettings::default()
    }
}

#[test]
fn the_usual_schedule_needs_no_rounding() {
    for dt_us in [4.0, 100.0, 1000.0] {
        let planned = usual(dt_us, 10.0);
        let UnitSchedule { schedule, roundings } = planned.for_unit(&UnitLimits::BNC_575).unwrap();
        assert!(roundings.is_empty(), "{roundings:?}");
        assert!((schedule.camera_trigger_us - planned.camera_trigger_us).abs() < 1e-9);
    }
}

#[test]
fn the_pulse_separation_is_refused_rather_than_rounded() {
    let error = usual(100.0001, 10.0).for_unit(&UnitLimits::BNC_575).unwrap_err().to_string();
    assert!(error.contains("dt = 100.0001 us: allowed: a multiple of 0.00025 us"), "{error}");
    let error = usual(100.5, 10.0).for_unit(&UnitLimits::OLT_SYNC).unwrap_err().to_string();
    assert!(error.contains("a multiple of 1 us, the step of a oltSync"), "{error}");
}

#[test]
fn rounding_is_reported() {
    // 3 Hz is not a whole number of 10 ns; the period is rounded up.
    let UnitSchedule { schedule, roundings } =
        usual(100.0, 3.0).for_unit(&UnitLimits::BNC_575).unwrap();
    assert_eq!(roundings.len(), 1, "{roundings:?}");
    assert_eq!(roundings[0].to_string(), "period: 333333.333333 us is set as 333333.340000 us");
    assert!(schedule.rate_hz() <= 3.0);
    // The gap of an odd separation is at half a microsecond; exposures shift with their trigger.
    let UnitSchedule { schedule, roundings } =
        usual(101.0, 10.0).for_unit(&UnitLimits::OLT_SYNC).unwrap();
    assert_eq!(roundings[0].quantity, "camera trigger");
    assert_eq!(schedule.exposure_1_us[0], schedule.camera_trigger_us + 3.0);
}

#[test]
fn rounding_must_not_break_the_rules() {
    // Q1 is 1.5 µs before the gap: rounding by half a microsecond would violate the margin.
    let settings = TimingSettings { margin_us: 1.4, ..TimingSettings::default() };
    let planned = plan(&settings, 5.0, 10.0).unwrap();
    let error = planned.for_unit(&UnitLimits::OLT_SYNC).unwrap_err().to_string();
    assert!(error.contains("must fall into exposure"), "{error}");
}

#[test]
fn values_beyond_the_unit_are_refused_with_its_limits() {
    let narrow = TimingSettings { pulse_width_us: 0.01, ..TimingSettings::default() };
    let error = plan(&narrow, 100.0, 10.0).unwrap().for_unit(&UnitLimits::OLT_SYNC).unwrap_err();
    let text = error.to_string();
    assert!(
        text.contains("pulse width = 0 us: allowed: 1 to 4294967295 us with a oltSync"),
        "{text}"
    );
    let mut endless = usual(100.0, 10.0);
    endless.period_us = 6e9;
    let text = endless.for_unit(&UnitLimits::BNC_575).unwrap_err().to_string();
    assert!(text.contains("period = 6000000000 us: allowed: 0.1 to 5000000000 us"), "{text}");
    let mut far = usual(100.0, 10.0);
    (far.period_us, far.q_switch_us[1], far.dt_us) = (4e9, 2e9 + 280.0, 2e9);
    far.exposure_2_us[1] = 3e9;
    let text = far.for_unit(&UnitLimits::BNC_575).unwrap_err().to_string();
    assert!(text.contains("delay of Q-switch 2 = 2000000280 us: allowed: -999999999.99"), "{text}");
    assert_eq!(UnitLimits::BNC_575.longest_burst, 9_999_999);
    assert_eq!(UnitLimits::QUANTUM_COMPOSERS_9530.longest_burst, 1_000_000);
}

#[test]
fn an_external_source_must_be_declared_and_slow_enough() {
    let undeclared = TimingSettings { external_trigger: None, ..external(10.0) };
    let text = plan(&undeclared, 100.0, 10.0).unwrap_err().to_string();
    assert!(text.contains("no external_trigger is declared"), "{text}");
    assert!(text.contains("at most 10 Hz"), "{text}");
    let text = plan(&external(12.0), 100.0, 10.0).unwrap_err().to_string();
    assert!(
        text.contains("external_trigger.max_rate_hz = 12 Hz: allowed: at most 10 Hz"),
        "{text}"
    );
    let text = plan(&external(5.0), 100.0, 10.0).unwrap_err().to_string();
    assert!(text.contains("at most external_trigger.max_rate_hz = 5 Hz"), "{text}");
    assert!(plan(&external(f64::NAN), 100.0, 10.0).is_err());
    // An unused declaration has no effect.
    let unused = TimingSettings { trigger: TriggerSource::Internal, ..external(12.0) };
    assert_eq!(plan(&unused, 100.0, 10.0).unwrap().external_trigger, None);
}

#[test]
fn cameras_must_be_ready_for_the_fastest_source() {
    let settings = TimingSettings { readout_us: 60_000.0, ..external(10.0) };
    // The expected 5 Hz are fine, but the source may be twice as fast.
    let text = plan(&settings, 100.0, 5.0).unwrap_err().to_string();
    assert!(text.contains("cameras ready again at 120331.000 us"), "{text}");
    assert!(text.contains("100000.000 us"), "{text}");
}

#[test]
fn the_table_reads_external_triggers() {
    let read = |text: &str| toml::from_str::<TimingSettings>(text);
    assert_eq!(read("").unwrap(), TimingSettings::default());
    let text = "trigger = 'external'\nexternal_trigger = { max_rate_hz = 10.0, edge = 'falling' }";
    let source = read(text).unwrap().external_trigger.unwrap();
    assert_eq!((source.edge, source.level_v), (TriggerEdge::Falling, 2.5));
    assert!(read("external_trigger = { rate = 10.0 }").is_err());
    assert!(read("trigger = 'sometimes'").is_err());
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]
    /// Independent check in steps of 250 ps: every value is a multiple, none is off by more than
    /// half a step, and the separation is exact.
    #[test]
    fn rounded_schedules_are_whole_steps_near_the_plan(
        dt_quarters in 16_000_u64..8_000_000,
        lamp_1_us in 0.0..300.0_f64,
        latency_us in 0.0..3.0_f64,
        rate_hz in 0.5..10.0_f64,
    ) {
        let dt_us = dt_quarters as f64 / 4000.0;
        let settings = TimingSettings {
            lamp_1_us, camera_latency_us: latency_us, ..TimingSettings::default()
        };
        let Ok(planned) = plan(&settings, dt_us, rate_hz) else { return Ok(()) };
        let set = planned.for_unit(&UnitLimits::BNC_575).unwrap().schedule;
        for ((_, before_us), (_, after_us)) in planned.signals().into_iter().zip(set.signals()) {
            let quarters = after_us * 4000.0;
            prop_assert!((quarters - quarters.round()).abs() < 1e-6);
            // Q-switch 2 includes the rounding of Q-switch 1.
            prop_assert!((after_us - before_us).abs() < 0.000_126);
        }
        prop_assert!((set.q_switch_us[1] - set.q_switch_us[0] - dt_us).abs() < 1e-7);
        prop_assert!(set.period_us >= planned.period_us - 1e-6);
        prop_assert!(set.period_us < planned.period_us + 0.0101);
    }
}
