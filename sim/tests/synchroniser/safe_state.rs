//! The safe state is reached in the right order, from anywhere, and read back.

use lfpiv_hw::{device::SynchroniserState, synchroniser::SynchroniserSettings};
use lfpiv_sim::wire::pulse_generator::PulseGeneratorOptions;

use crate::bench::{Bench, message, schedule, timing, wait_until};

#[test]
fn q_switches_go_off_first_then_lamps_then_t0_and_all_is_read_back() {
    let bench = Bench::usual();
    let (mut unit, transcript) = bench.connect();
    unit.program(&schedule()).unwrap();
    unit.fire(400).unwrap();
    wait_until("pulses", || bench.q_switch_pulses()[0] > 2);
    let before = transcript.sent_lines().len();
    unit.make_safe().unwrap();
    let sent = transcript.sent_lines().split_off(before);
    let outputs = [2, 4, 1, 3, 0, 5, 6, 7, 8];
    let orders = outputs.map(|n| format!(":PULSE{n}:STATE OFF"));
    let questions = outputs.map(|n| format!(":PULSE{n}:STATE?"));
    assert_eq!(sent[..9], orders);
    assert_eq!(sent[9], "*IDN?");
    assert_eq!(sent[10..], questions);
    assert_eq!(unit.state().unwrap(), SynchroniserState::Safe);
    unit.make_safe().unwrap();
    assert_eq!(unit.state().unwrap(), SynchroniserState::Safe);
}

/// Between the commands of the safe state the unit goes on. Cameras may see a trigger without light,
/// but the unit counts none that they did not see.
#[test]
fn the_unit_counts_the_triggers_of_the_cameras_when_a_burst_is_ended() {
    let bench = Bench::usual();
    let settings = SynchroniserSettings { pacing_ms: 30, ..bench.settings() };
    let mut unit = bench.try_connect(&settings, &timing()).0.unwrap();
    unit.program(&schedule()).unwrap();
    unit.fire(400).unwrap();
    wait_until("pulses", || bench.q_switch_pulses()[0] > 2);
    unit.make_safe().unwrap();
    let seen = bench.served.unit().pulses(5);
    // The commands are 30 ms apart and the period is 10 ms, so some were not lit.
    assert!(seen >= bench.q_switch_pulses()[0], "{seen}");
    assert_eq!(unit.trigger_count().unwrap(), Some(seen));
}

#[test]
fn the_first_order_on_the_line_switches_off() {
    let bench = Bench::usual();
    let (mut first, _) = bench.connect();
    first.program(&schedule()).unwrap();
    first.fire(500).unwrap();
    drop(first);
    assert!(bench.served.unit().is_running());
    let (mut second, transcript) = bench.connect();
    assert_eq!(transcript.sent_lines()[0], ":PULSE0:STATE OFF");
    assert_eq!(second.state().unwrap(), SynchroniserState::Safe);
    assert!(bench.q_switch_pulses()[0] < 500);
}

#[test]
fn a_unit_that_does_not_obey_is_not_called_safe() {
    let bench = Bench::usual();
    let mut settings = bench.settings();
    settings.reply_timeout_ms = 60;
    let (unit, _) = bench.try_connect(&settings, &crate::bench::timing());
    let mut unit = unit.unwrap();
    unit.program(&schedule()).unwrap();
    unit.fire(400).unwrap();
    // It takes two orders, those to the Q-switches, and no other.
    bench.served.unit().silence_after(2);
    let refusal = message(unit.make_safe());
    assert!(refusal.contains("use the hardware interlock"), "{refusal}");
    assert_eq!(unit.state().unwrap(), SynchroniserState::Unknown);
    let unit_now = bench.served.unit();
    assert!(!unit_now.is_enabled(2) && !unit_now.is_enabled(4) && unit_now.is_enabled(1));
    drop(unit_now);
    bench.served.unit().end_silence();
    unit.make_safe().unwrap();
    assert_eq!(unit.state().unwrap(), SynchroniserState::Safe);
}

#[test]
fn late_replies_pass_for_no_answer() {
    let bench = Bench::usual();
    let mut settings = bench.settings();
    settings.reply_timeout_ms = 400;
    let (unit, _) = bench.try_connect(&settings, &crate::bench::timing());
    let mut unit = unit.unwrap();
    unit.program(&schedule()).unwrap();
    unit.fire(400).unwrap();
    // The reply to one question comes after its time, in the middle of those that follow.
    bench.served.unit().options().reply_delay_ns = 450_000_000;
    let begun = std::thread::scope(|scope| {
        let state = scope.spawn(|| unit.state());
        std::thread::sleep(std::time::Duration::from_millis(300));
        bench.served.unit().options().reply_delay_ns = 0;
        state.join().unwrap()
    });
    assert!(
        matches!(begun, Ok(SynchroniserState::Firing | SynchroniserState::Unknown)),
        "{begun:?}"
    );
    unit.make_safe().unwrap();
    assert_eq!(unit.state().unwrap(), SynchroniserState::Safe);
    let unit_now = bench.served.unit();
    assert!((0..=8).all(|output| !unit_now.is_enabled(output)) && !unit_now.is_running());
}

#[test]
fn a_unit_that_drops_characters_is_made_safe_all_the_same() {
    let options =
        PulseGeneratorOptions { stray: b"\x00\xff\r\n\r\n".to_vec(), ..Default::default() };
    let bench = Bench::start(options);
    let (mut unit, _) = bench.connect();
    unit.program(&schedule()).unwrap();
    unit.fire(400).unwrap();
    unit.make_safe().unwrap();
    assert_eq!(unit.state().unwrap(), SynchroniserState::Safe);
}
