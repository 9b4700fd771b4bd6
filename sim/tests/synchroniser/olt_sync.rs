//! The oltSync driver, and what it admits not to know.

use std::{thread, time::Duration};

use lfpiv_hw::{
    device::SynchroniserState,
    synchroniser::{SynchroniserDriver, SynchroniserSettings},
};
use lfpiv_sim::wire::{olt_sync::OltSyncUnit, pty::Served};

use crate::bench::{
    external_schedule, message, open, schedule, timing, wait_for_state, wait_until,
};

fn unit() -> Served<OltSyncUnit> {
    Served::start(OltSyncUnit::new("SYNC_1"), Box::new(|_| ())).unwrap()
}

fn settings(served: &Served<OltSyncUnit>) -> SynchroniserSettings {
    SynchroniserSettings {
        pacing_ms: 0,
        reply_timeout_ms: 3000,
        host_timed_bursts: true,
        ..SynchroniserSettings::at(SynchroniserDriver::OltSync, served.path())
    }
}

#[test]
fn it_fires_only_where_somebody_answers_for_it() {
    let served = unit();
    let careful = SynchroniserSettings { host_timed_bursts: false, ..settings(&served) };
    let mut unit = open(&careful, &timing()).unwrap();
    assert_eq!(unit.identify().unwrap(), "oltSync:SYNC_1");
    unit.program(&schedule()).unwrap();
    let refusal = message(unit.fire(1));
    assert!(refusal.contains("cannot count a burst"), "{refusal}");
    assert!(refusal.contains("host_timed_bursts = true"), "{refusal}");
    assert!(message(unit.program(&external_schedule())).contains("does not count triggers"));
    assert_eq!(served.unit().pulses(2), 0);
}

#[test]
fn bursts_end_by_the_hosts_clock_and_nothing_is_called_read_back() {
    let served = unit();
    let mut unit = open(&settings(&served), &timing()).unwrap();
    assert!(!unit.reads_back());
    assert_eq!(unit.state().unwrap(), SynchroniserState::Safe);
    unit.program(&schedule()).unwrap();
    assert_eq!(unit.trigger_count().unwrap(), None);
    unit.fire(40).unwrap();
    assert_eq!(unit.state().unwrap(), SynchroniserState::Firing);
    assert!(message(unit.fire(1)).contains("a burst is running"));
    wait_for_state(unit.as_mut(), SynchroniserState::Armed);
    assert!(!served.unit().is_running());
    let pulses = served.unit().pulses(2);
    // The host's clock and a slow line: about forty, and no more to come.
    assert!((38..60).contains(&pulses), "{pulses}");
    thread::sleep(Duration::from_millis(50));
    assert_eq!(served.unit().pulses(2), pulses);
    assert!(message(unit.fire(501)).contains("allowed: 1 to 500"));
}

#[test]
fn lamps_are_warmed_alone() {
    let served = unit();
    let warm_up = lfpiv_hw::TimingSettings { lamp_warm_up_s: 0.4, ..timing() };
    let mut unit = open(&settings(&served), &warm_up).unwrap();
    unit.program(&schedule()).unwrap();
    assert!(message(unit.fire(1)).contains("the lamps are not warm"));
    thread::sleep(unit.arm().unwrap());
    assert!(served.unit().pulses(1) > 3);
    let others = [2, 4, 5].map(|pin| served.unit().pulses(pin));
    assert_eq!(others, [0; 3]);
    unit.fire(5).unwrap();
    wait_until("pulses", || served.unit().pulses(2) > 0);
    unit.make_safe().unwrap();
    assert_eq!(unit.state().unwrap(), SynchroniserState::Safe);
}

#[test]
fn a_burst_ends_even_when_its_driver_is_dropped() {
    let served = unit();
    let mut unit = open(&settings(&served), &timing()).unwrap();
    unit.program(&schedule()).unwrap();
    unit.fire(30).unwrap();
    drop(unit);
    wait_until("stop", || !served.unit().is_running());
}

#[test]
fn silence_leaves_the_state_unknown() {
    let served = unit();
    let hasty = SynchroniserSettings { reply_timeout_ms: 1000, ..settings(&served) };
    let mut unit = open(&hasty, &timing()).unwrap();
    unit.program(&schedule()).unwrap();
    served.unit().set_silent(true);
    assert_eq!(unit.state().unwrap(), SynchroniserState::Unknown);
    let refusal = message(unit.make_safe());
    assert!(refusal.contains("state unknown: use the hardware interlock"), "{refusal}");
    served.unit().set_silent(false);
    unit.make_safe().unwrap();
    assert_eq!(unit.state().unwrap(), SynchroniserState::Safe);
}
