use super::*;

const MS: u64 = 1_000_000;

fn unit(options: PulseGeneratorOptions) -> PulseGenerator {
    PulseGenerator::new(options)
}

fn usual() -> PulseGenerator {
    unit(PulseGeneratorOptions::default())
}

/// The bytes received by `now_ns`.
fn raw(unit: &mut PulseGenerator, command: &str, now_ns: u64) -> String {
    unit.receive(format!("{command}\r\n").as_bytes(), now_ns);
    String::from_utf8(unit.advance(now_ns).bytes).unwrap()
}

fn ask(unit: &mut PulseGenerator, command: &str) -> String {
    raw(unit, command, 0).trim().to_owned()
}

/// Lamp on channel 1, Q-switch on channel 2 with a burst of `shots`, 10 Hz.
fn program(unit: &mut PulseGenerator, shots: u64) {
    for command in [
        ":PULSE0:PER 0.1",
        ":PULSE1:STATE ON",
        ":PULSE2:DEL 0.00018",
        ":PULSE2:CMOD BURS",
        &format!(":PULSE2:BCO {shots}"),
        ":PULSE2:STATE ON",
    ] {
        assert_eq!(ask(unit, command), "ok", "{command}");
    }
}

#[test]
fn keywords_are_accepted_in_both_lengths_and_any_case() {
    let mut unit = usual();
    for (command, reply) in [
        ("*idn?", "BNC,575-8,31707,2.4.2-2.0.11"),
        (":INSTRUMENT:CATALOG?", "T0, CHA, CHB, CHC, CHD, CHE, CHF, CHG, CHH"),
        (":puls1:stat on", "ok"),
        (":PULSE1:STATE?", "1"),
        (":Pulse1:State 0", "ok"),
        (":PULS1:STAT?", "0"),
        (":PULSE1:DELAY 0.00028", "ok"),
        (":PULSE1:DEL?", "0.00028000000"),
        (":PULSE1:CMODE BURST", "ok"),
        (":PULSE1:CMOD?", "BURS"),
        (":PULSE0:TRIGGER:LEVEL 1.25", "ok"),
        (":PULSE0:TRIG:LEV?", "1.25"),
        (":PULS0:COUN:COUN? TCNTS", "0"),
    ] {
        assert_eq!(ask(&mut unit, command), reply, "{command}");
    }
}

#[test]
fn every_error_has_its_code() {
    let mut unit = usual();
    for (command, code) in [
        ("PULSE1:STATE ON", "?1"),
        ("hello", "?1"),
        (":", "?2"),
        (":PULSE1", "?2"),
        (":PULSE1:STAT1 ON", "?3"),
        (":PULSE9:STATE ON", "?3"),
        (":PULSE1:STATE", "?4"),
        (":PULSE1:STATE MAYBE", "?5"),
        (":PULSE1:DEL fast", "?5"),
        (":PULSE0:PER 5001", "?5"),
        (":INST:CAT", "?6"),
        ("*RST?", "?7"),
        ("*TRG", "?8"),
    ] {
        assert_eq!(ask(&mut unit, command), code, "{command}");
    }
    unit.options().knows_out_of_bounds = true;
    for command in [":PULSE0:PER 5001", ":PULSE1:DEL 1000", ":PULSE1:WIDT 1e-9", ":PULSE1:BCO 0"] {
        assert_eq!(ask(&mut unit, command), "?9", "{command}");
    }
}

#[test]
fn a_burst_gives_its_pulses_while_lamps_continue() {
    let mut unit =
        unit(PulseGeneratorOptions { drops_off_after_burst: false, ..Default::default() });
    program(&mut unit, 3);
    ask(&mut unit, ":PULSE0:STATE ON");
    let periods = unit.advance(1000 * MS).periods;
    // The first T0 came with the start.
    assert_eq!((periods.len(), unit.pulses(1), unit.pulses(2)), (10, 11, 3));
    let t0_ns: Vec<u64> = periods.iter().map(|period| period.t0_ns).collect();
    assert_eq!(t0_ns[0], 100 * MS);
    assert_eq!(t0_ns[9], 1000 * MS);
    assert!(unit.is_running());
}

#[test]
fn it_may_drop_to_off_after_a_burst() {
    let mut unit = usual();
    program(&mut unit, 3);
    ask(&mut unit, ":PULSE0:STATE ON");
    unit.advance(1000 * MS);
    assert_eq!((unit.pulses(1), unit.pulses(2), unit.is_running()), (3, 3, false));
    assert_eq!(raw(&mut unit, ":PULSE0:STATE?", 1000 * MS), "0\r\n");
    // A new start begins a new burst; the T0 count continues.
    raw(&mut unit, ":PULSE0:STATE ON", 2000 * MS);
    unit.advance(5000 * MS);
    assert_eq!((unit.pulses(2), unit.periods()), (6, 6));
}

#[test]
fn the_wait_counter_holds_back_bursts_or_does_not() {
    for (delays, first_pulse_at) in [(true, 2), (false, 0)] {
        let mut unit = unit(PulseGeneratorOptions {
            wait_counter_delays_bursts: delays,
            ..Default::default()
        });
        program(&mut unit, 1);
        ask(&mut unit, ":PULSE2:WCO 2");
        unit.receive(b":PULSE0:STATE ON\r\n", 0);
        let periods = unit.advance(1000 * MS).periods;
        let first = periods.iter().position(|p| p.pulses.iter().any(|p| p.channel == 2));
        assert_eq!(first, Some(first_pulse_at));
    }
}

#[test]
fn a_gate_of_the_wrong_polarity_lets_nothing_out() {
    let mut unit = unit(PulseGeneratorOptions { gate_open: false, ..Default::default() });
    program(&mut unit, 3);
    ask(&mut unit, ":PULSE0:STATE ON");
    unit.advance(1000 * MS);
    assert_eq!((unit.pulses(1), unit.pulses(2), unit.periods()), (0, 0, 3));
}

#[test]
fn writes_take_effect_one_by_one_while_it_runs() {
    let mut unit = usual();
    program(&mut unit, 10);
    ask(&mut unit, ":PULSE0:STATE ON");
    raw(&mut unit, ":PULSE1:DEL 0.0005", 150 * MS);
    let half_done = unit.advance(200 * MS).periods.remove(0);
    // The lamp has moved after its Q-switch, which is unchanged.
    let starts_us: Vec<f64> = half_done.pulses.iter().map(|pulse| pulse.start_us).collect();
    assert_eq!(starts_us, [500.0, 180.0]);
}

#[test]
fn commands_that_come_too_soon_suffer() {
    for (too_soon, reply) in [(TooSoon::Garbled, "?1\r\n"), (TooSoon::Unavailable, "?8\r\n")] {
        let pacing = Some(Pacing { least_gap_ns: 50 * MS, too_soon });
        let mut unit = unit(PulseGeneratorOptions { pacing, ..Default::default() });
        assert_eq!(raw(&mut unit, ":PULSE1:STATE ON", 0), "ok\r\n");
        assert_eq!(raw(&mut unit, ":PULSE2:STATE ON", 49 * MS), reply);
        assert_eq!(raw(&mut unit, ":PULSE2:STATE ON", 99 * MS), "ok\r\n");
    }
}

#[test]
fn echo_strays_and_slow_replies() {
    let mut unit = usual();
    unit.options().stray = b"\x07~\r\n".to_vec();
    assert_eq!(
        raw(&mut unit, ":SYST:COMM:SER:ECHO ON", 0),
        ":SYST:COMM:SER:ECHO ON\r\n\u{7}~\r\nok\r\n"
    );
    unit.options().stray.clear();
    assert_eq!(raw(&mut unit, "*IDN?", 0), "*IDN?\r\nBNC,575-8,31707,2.4.2-2.0.11\r\n");
    unit.options().echo = false;
    unit.options().reply_delay_ns = 30 * MS;
    assert_eq!(raw(&mut unit, ":PULSE1:STATE?", 0), "");
    assert_eq!(unit.advance(29 * MS).wake_ns, Some(30 * MS));
    assert_eq!(unit.advance(30 * MS).bytes, b"0\r\n");
    unit.silence_after(1);
    raw(&mut unit, ":PULSE1:STATE ON", 40 * MS);
    raw(&mut unit, ":PULSE1:STATE OFF", 40 * MS);
    assert_eq!(unit.advance(100 * MS).bytes, b"ok\r\n");
    assert!(unit.is_enabled(1));
}

#[test]
fn read_backs_are_rounded_to_the_configured_digits() {
    let mut unit = unit(PulseGeneratorOptions {
        time_step_ps: 10_000,
        read_back_decimals: Some(9),
        ..Default::default()
    });
    ask(&mut unit, ":PULSE1:DEL 0.00028000650");
    assert_eq!(ask(&mut unit, ":PULSE1:DEL?"), "0.000280010");
}

#[test]
fn triggers_come_from_outside_or_by_command() {
    let mut unit = usual();
    program(&mut unit, 5);
    for command in [":PULSE0:TRIG:MODE TRIG", ":PULSE0:MODE SING", ":PULSE0:STATE ON", "*TRG"] {
        assert_eq!(ask(&mut unit, command), "ok", "{command}");
    }
    assert_eq!(unit.periods(), 1);
    unit.trigger_input(Some(20.0));
    let periods = unit.advance(100 * MS).periods;
    assert_eq!(periods.len(), 1);
    unit.advance(250 * MS);
    assert_eq!((unit.periods(), unit.pulses(2), unit.is_running()), (5, 5, false));
    // *ARM restarts a burst; triggers do not count unless the unit is running.
    unit.advance(500 * MS);
    assert_eq!(unit.periods(), 5);
}

#[test]
fn a_reset_switches_off_and_may_leave_channels_enabled() {
    for enabled in [false, true] {
        let options =
            PulseGeneratorOptions { reset_enables_channels: enabled, ..Default::default() };
        let mut unit = unit(options);
        program(&mut unit, 5);
        ask(&mut unit, ":PULSE0:STATE ON");
        ask(&mut unit, "*RST");
        assert_eq!((unit.is_running(), unit.is_enabled(2)), (false, enabled));
        assert_eq!(ask(&mut unit, ":PULSE2:BCO?"), "1");
    }
}
