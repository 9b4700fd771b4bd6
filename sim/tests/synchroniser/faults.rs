//! Lines and units that misbehave.

use std::time::Duration;

use lfpiv_hw::device::{DeviceError, SynchroniserState};
use lfpiv_sim::wire::{
    olt_sync::OltSyncUnit,
    pty::Served,
    pulse_generator::{Pacing, PulseGeneratorOptions, TooSoon},
};

use crate::bench::{Bench, message, open, schedule, timing, wait_for_state, wait_until};

fn works(bench: &Bench) {
    let (mut unit, _) = bench.connect();
    unit.program(&schedule()).unwrap();
    unit.fire(2).unwrap();
    wait_for_state(unit.as_mut(), SynchroniserState::Armed);
    assert_eq!(unit.trigger_count().unwrap(), Some(2));
    unit.make_safe().unwrap();
    assert_eq!(bench.q_switch_pulses(), [2; 2]);
}

#[test]
fn echo_stray_bytes_slow_replies_and_few_digits_are_borne() {
    let usual = PulseGeneratorOptions::default;
    for options in [
        PulseGeneratorOptions { echo: true, ..usual() },
        PulseGeneratorOptions { stray: b"\r\n\x00~~\r\n\r\n\xf8".to_vec(), ..usual() },
        PulseGeneratorOptions { reply_delay_ns: 2_000_000, ..usual() },
        PulseGeneratorOptions { read_back_decimals: Some(9), ..usual() },
        PulseGeneratorOptions {
            echo: true,
            stray: b"noise\r\n".to_vec(),
            identity: "QC,9528,00123,2.1.0".into(),
            ..usual()
        },
    ] {
        works(&Bench::start(options));
    }
}

#[test]
fn a_unit_that_rounds_differently_is_refused_with_the_value() {
    let bench =
        Bench::start(PulseGeneratorOptions { time_step_ps: 1_000_000, ..Default::default() });
    let (mut unit, _) = bench.connect();
    let planned = lfpiv_hw::PulseSchedule::plan(&timing(), 100.5, 100.0).unwrap();
    let refusal = message(unit.program(&planned));
    // The lamp of head 2 at 200.5 us is the first that the unit cannot set.
    assert!(refusal.contains(":PULSE3:DEL 0.00020050000"), "{refusal}");
    assert!(refusal.contains("reads back \"0.00020100000\""), "{refusal}");
    assert!(message(unit.fire(1)).contains("no schedule is programmed"));
    assert_eq!(unit.state().unwrap(), SynchroniserState::Safe);
}

#[test]
fn silence_in_the_middle_of_a_burst_ends_it_all() {
    let bench = Bench::usual();
    let mut settings = bench.settings();
    settings.reply_timeout_ms = 60;
    let mut unit = bench.try_connect(&settings, &timing()).0.unwrap();
    unit.program(&schedule()).unwrap();
    unit.fire(50).unwrap();
    bench.served.unit().silence_after(0);
    assert_eq!(unit.state().unwrap(), SynchroniserState::Unknown);
    let lost = unit.trigger_count();
    assert!(matches!(lost, Err(DeviceError::Lost { .. })), "{lost:?}");
    assert!(message(lost).contains("state unknown: use the hardware interlock"));
    // The burst is not renewed, and the unit ends it by itself.
    assert!(unit.fire(50).is_err());
    wait_until("end of the burst", || !bench.served.unit().is_running());
    assert_eq!(bench.q_switch_pulses(), [50; 2]);
    // Even when it answers again: what it holds is not known any more.
    bench.served.unit().end_silence();
    assert!(message(unit.fire(50)).contains("no schedule is programmed"));
    unit.make_safe().unwrap();
    assert_eq!(unit.state().unwrap(), SynchroniserState::Safe);
    assert_eq!(bench.q_switch_pulses(), [50; 2]);
}

#[test]
fn a_write_that_is_not_answered_is_read_back() {
    let bench = Bench::usual();
    let mut settings = bench.settings();
    settings.reply_timeout_ms = 100;
    let (unit, transcript) = bench.try_connect(&settings, &timing());
    let mut unit = unit.unwrap();
    // One command in the middle of programming gets no reply in time.
    let begun = bench.served.unit().commands();
    std::thread::scope(|scope| {
        scope.spawn(|| {
            wait_until("programming", || bench.served.unit().commands() > begun + 60);
            bench.served.unit().silence_after(0);
            std::thread::sleep(Duration::from_millis(120));
            bench.served.unit().end_silence();
        });
        unit.program(&schedule()).unwrap();
    });
    // Somebody was asked who he is in between: that is how late replies are passed over.
    assert!(transcript.sent_lines().iter().filter(|line| *line == "*IDN?").count() > 2);
    unit.fire(2).unwrap();
    wait_for_state(unit.as_mut(), SynchroniserState::Armed);
    assert_eq!(bench.q_switch_pulses(), [2; 2]);
}

#[test]
fn a_line_that_is_cut_is_lost() {
    let mut bench = Bench::usual();
    let (mut unit, _) = bench.connect();
    unit.program(&schedule()).unwrap();
    unit.fire(3).unwrap();
    bench.served.cut();
    assert_eq!(unit.state().unwrap(), SynchroniserState::Unknown);
    for lost in [unit.make_safe(), unit.trigger_count().map(drop), unit.identify().map(drop)] {
        assert!(matches!(lost, Err(DeviceError::Lost { .. })), "{lost:?}");
        assert!(message(lost).contains("state unknown: use the hardware interlock"));
    }
    assert!(message(unit.fire(3)).contains("no schedule is programmed"));
}

#[test]
fn commands_are_paced_as_the_unit_needs_it() {
    let pacing = |too_soon| PulseGeneratorOptions {
        pacing: Some(Pacing { least_gap_ns: 40_000_000, too_soon }),
        ..Default::default()
    };
    let bench = Bench::start(pacing(TooSoon::Unavailable));
    let refusal = message(bench.try_connect(&bench.settings(), &timing()).0);
    assert!(refusal.contains("?8 (command unavailable"), "{refusal}");
    for too_soon in [TooSoon::Unavailable, TooSoon::Garbled] {
        let bench = Bench::start(pacing(too_soon));
        let mut settings = bench.settings();
        settings.pacing_ms = 50;
        let mut unit = bench.try_connect(&settings, &timing()).0.unwrap();
        unit.program(&schedule()).unwrap();
    }
}

#[test]
fn other_units_and_other_speeds_are_recognised() {
    let bench = Bench::start(PulseGeneratorOptions { baud_rate: 38_400, ..Default::default() });
    let mut settings = bench.settings();
    settings.reply_timeout_ms = 80;
    let refusal = message(bench.try_connect(&settings, &timing()).0);
    assert!(refusal.contains("no reply to \"*IDN?\""), "{refusal}");
    settings.probe_baud_rates = true;
    assert!(bench.try_connect(&settings, &timing()).0.is_ok());

    let bench = Bench::start(PulseGeneratorOptions { channels: 4, ..Default::default() });
    let refusal = message(bench.try_connect(&bench.settings(), &timing()).0);
    assert!(refusal.contains("names output E: the unit has 4 outputs"), "{refusal}");

    let identity = "KEYSIGHT,33500B,1,2".to_owned();
    let bench = Bench::start(PulseGeneratorOptions { identity, ..Default::default() });
    let refusal = message(bench.try_connect(&bench.settings(), &timing()).0);
    assert!(refusal.contains("a BNC 575 or 577 or a Quantum Composers"), "{refusal}");

    let other = Served::start(OltSyncUnit::new("S1"), Box::new(|_| ())).unwrap();
    let mut settings = bench.settings();
    (settings.port, settings.reply_timeout_ms) = (other.path().to_owned(), 60);
    assert!(message(open(&settings, &timing())).contains("no reply"));
}

#[test]
fn a_port_that_is_not_there_or_taken_is_named() {
    let bench = Bench::usual();
    let mut settings = bench.settings();
    let _first = open(&settings, &timing()).unwrap();
    let refusal = message(open(&settings, &timing()));
    assert!(refusal.contains(bench.served.path()) && refusal.contains("cannot open"), "{refusal}");
    settings.port = "/dev/no-such-port".into();
    let refusal = message(open(&settings, &timing()));
    assert!(refusal.contains("/dev/no-such-port: connection lost: cannot open"), "{refusal}");
}

/// The system numbers pseudo-terminals anew: a host that looks for a lost unit must not find another.
#[test]
fn the_port_of_a_unit_that_is_gone_leads_to_no_other_unit() {
    let gone = Bench::usual();
    let settings = gone.settings();
    drop(gone);
    let others: Vec<Bench> = (0..8).map(|_| Bench::usual()).collect();
    let refusal = message(open(&settings, &timing()));
    assert!(refusal.contains(&settings.port) && refusal.contains("cannot open"), "{refusal}");
    assert!(others.iter().all(|other| other.served.path() != settings.port));
}
