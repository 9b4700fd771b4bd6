//! What comes out of the unit is what was planned, in bounded bursts.

use std::{thread, time::Duration};

use lfpiv_hw::{PulseSchedule, TimingSettings, device::SynchroniserState};
use lfpiv_sim::wire::{
    exposure::{CameraFacts, LaserFacts, OpticalBench, Wiring},
    pulse_generator::PulseGeneratorOptions,
};

use crate::bench::{Bench, arm_and_fire, message, schedule, timing, wait_for_state, wait_until};

#[test]
fn the_planned_pulses_come_out_and_light_both_exposures() {
    let bench = Bench::usual();
    let (mut unit, _) = bench.connect();
    unit.program(&schedule()).unwrap();
    unit.fire(3).unwrap();
    wait_until("three periods", || bench.periods.lock().unwrap().len() >= 3);
    let periods = bench.periods.lock().unwrap().clone();
    let wiring = Wiring { lamps: [1, 3], q_switches: [2, 4], cameras: vec![5] };
    let camera = CameraFacts { readout_us: 2000.0, ..CameraFacts::default() };
    let mut optics = OpticalBench::new(wiring, LaserFacts::default(), camera);
    for (index, period) in periods.iter().take(3).enumerate() {
        let starts_us: Vec<f64> = period.pulses.iter().map(|pulse| pulse.start_us).collect();
        assert_eq!(starts_us, [100.0, 280.0, 200.0, 380.0, 126.0]);
        assert!(period.pulses.iter().all(|pulse| pulse.width_us == 50.0));
        assert_eq!(period.t0_ns, periods[0].t0_ns + index as u64 * 10_000_000);
        let exposures = optics.period(period);
        for light in &exposures[0].light {
            assert_eq!(light.len(), 1);
            assert_eq!(light[0].energy, 1.0);
        }
        assert_eq!(exposures[0].separation_s, Some(100.0 * 1e-6));
    }
}

#[test]
fn a_unit_that_drops_to_off_after_a_burst_fires_again() {
    let bench = Bench::usual();
    let (mut unit, _) = bench.connect();
    unit.program(&schedule()).unwrap();
    for burst in 1..=3 {
        arm_and_fire(unit.as_mut(), 4);
        wait_until("OFF", || !bench.served.unit().is_running());
        assert_eq!(unit.state().unwrap(), SynchroniserState::Armed);
        assert_eq!(unit.trigger_count().unwrap(), Some(4 * burst));
        assert_eq!(bench.q_switch_pulses(), [4 * burst; 2]);
    }
}

#[test]
fn a_unit_that_goes_on_with_the_lamps_fires_no_shot_more() {
    let options = PulseGeneratorOptions { drops_off_after_burst: false, ..Default::default() };
    let bench = Bench::start(options);
    let (mut unit, _) = bench.connect();
    unit.program(&schedule()).unwrap();
    for burst in 1..=2 {
        unit.fire(4).unwrap();
        wait_for_state(unit.as_mut(), SynchroniserState::Armed);
        let lamps = bench.lamp_pulses();
        wait_until("lamps go on", || bench.lamp_pulses() > lamps + 3);
        assert_eq!(bench.q_switch_pulses(), [4 * burst; 2]);
        assert_eq!(unit.trigger_count().unwrap(), Some(4 * burst));
    }
}

#[test]
fn while_a_burst_runs_nothing_else_is_begun() {
    let bench = Bench::usual();
    let (mut unit, _) = bench.connect();
    assert!(message(unit.fire(1)).contains("no schedule is programmed"));
    unit.program(&schedule()).unwrap();
    unit.fire(500).unwrap();
    assert_eq!(unit.state().unwrap(), SynchroniserState::Firing);
    assert!(message(unit.fire(1)).contains("a burst is running"));
    assert!(
        message(unit.program(&schedule())).contains("cannot be changed while a burst is running")
    );
    let counted = unit.trigger_count().unwrap().unwrap();
    assert!((1..500).contains(&counted), "{counted}");
    unit.make_safe().unwrap();
    assert_eq!(unit.state().unwrap(), SynchroniserState::Safe);
    let given = bench.q_switch_pulses();
    assert!(given[0] < 500);
    thread::sleep(Duration::from_millis(50));
    assert_eq!(bench.q_switch_pulses(), given);
}

#[test]
fn bursts_last_five_seconds_at_most() {
    let bench = Bench::usual();
    let (mut unit, _) = bench.connect();
    unit.program(&schedule()).unwrap();
    let refusal = message(unit.fire(501));
    assert!(refusal.contains("burst of 501 shots: allowed: 1 to 500, which take 5 s"), "{refusal}");
    assert!(message(unit.fire(0)).contains("allowed: 1 to 500"));
    assert_eq!(bench.q_switch_pulses(), [0; 2]);
    let slow = PulseSchedule::plan(&timing(), 100.0, 0.1).unwrap();
    unit.program(&slow).unwrap();
    assert!(message(unit.fire(2)).contains("allowed: 1 to 1"));
}

#[test]
fn q_switches_wait_for_warm_lamps() {
    let bench = Bench::usual();
    let warm_up = TimingSettings { lamp_warm_up_s: 0.6, ..timing() };
    let mut unit = bench.connect_with(&warm_up);
    unit.program(&schedule()).unwrap();
    assert!(message(unit.fire(1)).contains("the lamps are not warm"));
    assert_eq!(bench.lamp_pulses(), 0);
    let wait = unit.arm().unwrap();
    assert!(wait > Duration::from_millis(300) && wait <= Duration::from_millis(600), "{wait:?}");
    wait_until("lamps", || bench.lamp_pulses() > 5);
    assert_eq!(unit.state().unwrap(), SynchroniserState::Armed);
    assert_eq!(bench.q_switch_pulses(), [0; 2]);
    assert_eq!(bench.served.unit().pulses(5), 0, "cameras wait, too");
    thread::sleep(unit.arm().unwrap());
    unit.fire(2).unwrap();
    wait_for_state(unit.as_mut(), SynchroniserState::Armed);
    assert_eq!(bench.q_switch_pulses(), [2; 2]);
    // The lamps have not gone cold in between.
    assert_eq!(unit.arm().unwrap(), Duration::ZERO);
    unit.disarm().unwrap();
    unit.program(&schedule()).unwrap();
    assert!(unit.arm().unwrap() > Duration::from_millis(300));
}

#[test]
fn a_long_warm_up_passes_unwatched() {
    let bench = Bench::usual();
    let warm_up = TimingSettings { lamp_warm_up_s: 3.6, ..timing() };
    let mut unit = bench.connect_with(&warm_up);
    unit.program(&schedule()).unwrap();
    arm_and_fire(unit.as_mut(), 2);
    // After its burst this unit drops to OFF; a pause of less than 3 s keeps the lamps warm.
    wait_for_state(unit.as_mut(), SynchroniserState::Armed);
    assert_eq!(unit.arm().unwrap(), Duration::ZERO);
    unit.fire(2).unwrap();
    wait_for_state(unit.as_mut(), SynchroniserState::Armed);
    thread::sleep(Duration::from_millis(3300));
    assert!(unit.arm().unwrap() > Duration::from_secs(3));
    assert_eq!(bench.q_switch_pulses(), [4; 2]);
}

#[test]
fn outputs_that_a_reset_enables_give_no_pulse() {
    let options = PulseGeneratorOptions { reset_enables_channels: true, ..Default::default() };
    let bench = Bench::start(options);
    let (mut unit, _) = bench.connect();
    unit.program(&schedule()).unwrap();
    let enabled: Vec<u8> = (1..=8).filter(|n| bench.served.unit().is_enabled(*n)).collect();
    assert!(enabled.is_empty(), "{enabled:?}");
    assert_eq!(bench.served.unit().periods(), 0);
}
