//! Triggers from outside: counted before a Q-switch is enabled, and watched while it is.

use std::{thread, time::Duration};

use lfpiv_hw::device::SynchroniserState;
use lfpiv_sim::wire::pulse_generator::PulseGeneratorOptions;

use crate::bench::{
    Bench, external_schedule, external_timing, message, wait_for_state, wait_until,
};

#[test]
fn a_source_at_the_declared_rate_fires_after_three_seconds() {
    let bench = Bench::usual();
    bench.served.unit().trigger_input(Some(20.0));
    let mut unit = bench.connect_with(&external_timing());
    unit.program(&external_schedule()).unwrap();
    let wait = unit.arm().unwrap();
    assert!(wait > Duration::from_millis(2500), "{wait:?}");
    let refusal = message(unit.fire(5));
    assert!(refusal.contains("is not confirmed yet"), "{refusal}");
    assert_eq!(bench.q_switch_pulses(), [0; 2]);
    thread::sleep(wait);
    unit.fire(5).unwrap();
    wait_for_state(unit.as_mut(), SynchroniserState::Armed);
    assert_eq!(unit.trigger_count().unwrap(), Some(5));
    assert_eq!(bench.q_switch_pulses(), [5; 2]);
}

#[test]
fn a_source_that_is_too_fast_is_refused_and_made_safe() {
    let bench = Bench::usual();
    bench.served.unit().trigger_input(Some(60.0));
    let mut unit = bench.connect_with(&external_timing());
    unit.program(&external_schedule()).unwrap();
    unit.arm().unwrap();
    wait_until("lamps", || bench.lamp_pulses() > 60);
    let refusal = message(unit.fire(5));
    assert!(refusal.contains("at most 20 per second, as declared"), "{refusal}");
    assert!(refusal.contains("switched off"), "{refusal}");
    assert_eq!(unit.state().unwrap(), SynchroniserState::Safe);
    assert_eq!(bench.q_switch_pulses(), [0; 2]);
    let lamps = bench.lamp_pulses();
    thread::sleep(Duration::from_millis(100));
    assert_eq!(bench.lamp_pulses(), lamps);
}

#[test]
fn a_source_that_becomes_too_fast_in_a_burst_is_seen_by_reading_the_state() {
    let bench =
        Bench::start(PulseGeneratorOptions { drops_off_after_burst: false, ..Default::default() });
    bench.served.unit().trigger_input(Some(18.0));
    let mut unit = bench.connect_with(&external_timing());
    unit.program(&external_schedule()).unwrap();
    thread::sleep(unit.arm().unwrap());
    unit.fire(100).unwrap();
    bench.served.unit().trigger_input(Some(100.0));
    let mut refusal = None;
    wait_until("refusal", || {
        refusal = unit.state().err();
        refusal.is_some()
    });
    let refusal = refusal.unwrap().to_string();
    assert!(refusal.contains("at most 20 per second"), "{refusal}");
    assert_eq!(unit.state().unwrap(), SynchroniserState::Safe);
    assert!(bench.q_switch_pulses()[0] < 100);
}

#[test]
fn a_source_that_gives_nothing_confirms_nothing() {
    let bench = Bench::usual();
    let mut unit = bench.connect_with(&external_timing());
    unit.program(&external_schedule()).unwrap();
    thread::sleep(unit.arm().unwrap());
    let refusal = message(unit.fire(5));
    assert!(refusal.contains("0 external triggers"), "{refusal}");
}
