//! Every row of the command table goes over the wire and is answered.

use std::time::Duration;

use lfpiv_hw::synchroniser::{
    bnc575::{command::Command, reply::Reply},
    line::{Dialogue, Direction, SerialLine, Transcript},
};

use crate::bench::{
    Bench, arm_and_fire, external_schedule, external_timing, open, schedule, timing, wait_for_state,
};
use lfpiv_hw::device::SynchroniserState;

/// What the unit was sent and what it answered, command by command.
fn exchanges(transcript: &Transcript) -> Vec<(String, String)> {
    let mut exchanges: Vec<(String, String)> = Vec::new();
    for entry in transcript.entries() {
        let text = String::from_utf8(entry.bytes).unwrap();
        match (entry.direction, exchanges.last_mut()) {
            (Direction::ToUnit, _) => exchanges.push((text.trim().to_owned(), String::new())),
            (Direction::ToHost, Some((_, reply))) => reply.push_str(&text),
            (Direction::ToHost, None) => panic!("{text:?} answers nothing"),
        }
    }
    exchanges
}

fn answered(exchanges: &[(String, String)], command: &str, reply: &str) {
    let answers: Vec<_> = exchanges.iter().filter(|(sent, _)| sent == command).collect();
    assert!(!answers.is_empty(), "{command} was not sent");
    let reply = format!("{reply}\r\n");
    assert!(answers.iter().any(|(_, got)| *got == reply), "{command}: {answers:?}");
}

#[test]
fn rows_of_a_run_by_the_units_own_clock() {
    let bench = Bench::usual();
    let (mut unit, transcript) = bench.connect();
    unit.program(&schedule()).unwrap();
    arm_and_fire(unit.as_mut(), 3);
    wait_for_state(unit.as_mut(), SynchroniserState::Armed);
    assert_eq!(unit.trigger_count().unwrap(), Some(3));
    unit.make_safe().unwrap();
    let exchanges = exchanges(&transcript);
    answered(&exchanges, "*IDN?", "BNC,575-8,31707,2.4.2-2.0.11");
    answered(&exchanges, ":INST:CAT?", "T0, CHA, CHB, CHC, CHD, CHE, CHF, CHG, CHH");
    for command in [
        ":PULSE0:STATE OFF",
        ":PULSE8:STATE OFF",
        "*RST",
        ":PULSE0:PER 0.010000000",
        ":PULSE0:MODE NORM",
        ":PULSE0:TRIG:MODE DIS",
        ":PULSE1:SYNC T0",
        ":PULSE1:POL NORM",
        ":PULSE1:OUTP:MODE TTL",
        ":PULSE1:DEL 0.00010000000",
        ":PULSE2:DEL 0.00028000000",
        ":PULSE3:DEL 0.00020000000",
        ":PULSE4:DEL 0.00038000000",
        ":PULSE5:DEL 0.00012600000",
        ":PULSE2:WIDT 0.00005000000",
        ":PULSE1:CMOD NORM",
        ":PULSE2:CMOD BURS",
        ":PULSE4:CMOD BURS",
        ":PULSE5:CMOD BURS",
        ":PULSE2:BCO 3",
        ":PULSE2:WCO 0",
        ":PULSE2:STATE ON",
        ":PULSE0:STATE ON",
    ] {
        answered(&exchanges, command, "ok");
    }
    for (query, value) in [
        (":PULSE0:STATE?", "0"),
        (":PULSE2:STATE?", "1"),
        (":PULSE0:PER?", "0.010000000"),
        (":PULSE4:DEL?", "0.00038000000"),
        (":PULSE4:CMOD?", "BURS"),
    ] {
        answered(&exchanges, query, value);
    }
    // T0 counts on after the burst, until it is stopped: on a busy machine that may be some periods later.
    let asked = exchanges.iter().filter(|(sent, _)| sent == ":PULS0:COUN:COUN? TCNTS");
    let counts: Vec<u64> = asked.filter_map(|(_, count)| count.trim().parse().ok()).collect();
    assert!(counts.iter().any(|&count| count >= 3), "{counts:?}");
    // Nothing went unanswered but the first order, which is given before anybody is known to
    // listen; and no Q-switch was ever in the mode that follows every T0.
    let unanswered = exchanges.iter().filter(|(_, reply)| reply.is_empty()).count();
    assert!(unanswered <= 1, "{exchanges:?}");
    assert!(!exchanges.iter().any(|(sent, _)| sent == ":PULSE2:CMOD NORM"));
}

#[test]
fn rows_of_an_external_trigger() {
    let bench = Bench::usual();
    let (unit, transcript) = bench.try_connect(&bench.settings(), &external_timing());
    unit.unwrap().program(&external_schedule()).unwrap();
    let exchanges = exchanges(&transcript);
    for command in [
        ":PULSE0:TRIG:MODE TRIG",
        ":PULSE0:TRIG:EDGE RIS",
        ":PULSE0:TRIG:LEV 2.50",
        ":PULSE0:MODE SING",
    ] {
        answered(&exchanges, command, "ok");
    }
    for (query, value) in [(":PULSE0:TRIG:LEV?", "2.50"), (":PULSE0:MODE?", "SING")] {
        answered(&exchanges, query, value);
    }
}

#[test]
fn rows_that_no_run_needs() {
    let bench = Bench::usual();
    bench.connect_with(&external_timing()).program(&external_schedule()).unwrap();
    let line = SerialLine::open(bench.served.path(), 115_200).unwrap();
    let mut dialogue = Dialogue::new(Box::new(line), Duration::ZERO, Duration::from_secs(3));
    let mut send = |command: &str| {
        let reply = dialogue.ask(command, |line| Reply::parse(line).is_some()).unwrap();
        assert_eq!(Reply::parse(&reply), Some(Reply::Done), "{command}");
    };
    // No output is enabled: the trigger is counted and nothing fires.
    send(":PULSE0:STATE ON");
    send(&Command::Trigger.to_string());
    send(&Command::Arm.to_string());
    send(":PULSE0:STATE OFF");
    send(":PULSE2:WCO 100");
    let unit = bench.served.unit();
    assert_eq!((unit.periods(), unit.pulses(2)), (1, 0));
}

#[test]
fn the_transcript_file_holds_both_directions() {
    let bench = Bench::usual();
    let folder = std::env::temp_dir().join(format!("lfpiv-transcript-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("serial.txt");
    let mut settings = bench.settings();
    settings.transcript = Some(path.clone());
    open(&settings, &timing()).unwrap().program(&schedule()).unwrap();
    let text = std::fs::read_to_string(&path).unwrap();
    std::fs::remove_dir_all(&folder).unwrap();
    assert!(text.lines().next().unwrap().ends_with(r" > :PULSE0:STATE OFF\r\n"), "{text}");
    assert!(text.contains(r" > :PULSE2:DEL 0.00028000000\r\n"));
    assert!(text.contains(r" < BNC,575-8,31707,2.4.2-2.0.11\r\n"));
}
