use std::{collections::VecDeque, io, time::Duration};

use lfpiv_hw::synchroniser::line::Line;
use proptest::prelude::*;

use crate::faults::{
    Clock, CommandShares, FaultSettings, FaultyLine, LineFault, LineFaults, ManualClock,
};

/// Reply time of the unit.
const ANSWER: Duration = Duration::from_millis(4);

/// A unit that answers its n-th command with `n`, in two pieces.
struct Counter {
    commands: u64,
    pieces: VecDeque<(Duration, Vec<u8>)>,
    clock: ManualClock,
}

impl Line for Counter {
    fn name(&self) -> &str {
        "counter"
    }

    fn send(&mut self, _: &[u8]) -> io::Result<()> {
        let at = self.clock.now() + ANSWER;
        self.pieces.push_back((at, format!("{:04}", self.commands).into_bytes()));
        self.pieces.push_back((at, b"\r\n".to_vec()));
        self.commands += 1;
        Ok(())
    }

    fn receive(&mut self, at_most: Duration) -> io::Result<Vec<u8>> {
        let wait = match self.pieces.front() {
            Some((at, _)) => at.saturating_sub(self.clock.now()),
            None => Duration::MAX,
        };
        self.clock.sleep(wait.min(at_most));
        let piece = (wait <= at_most).then(|| self.pieces.pop_front()).flatten();
        Ok(piece.map(|(_, bytes)| bytes).unwrap_or_default())
    }

    fn set_baud_rate(&mut self, _: u32) -> io::Result<()> {
        Ok(())
    }
}

fn faulty(settings: &FaultSettings) -> (FaultyLine<Counter>, ManualClock) {
    let clock = ManualClock::default();
    let unit = Counter { commands: 0, pieces: VecDeque::new(), clock: clock.clone() };
    (FaultyLine::timed_by(unit, settings, clock.clone()), clock)
}

fn with(seed: u64, line: LineFaults) -> FaultSettings {
    FaultSettings { seed, line, ..FaultSettings::default() }
}

fn only(shares: CommandShares) -> FaultSettings {
    with(1, LineFaults { shares, ..LineFaults::default() })
}

/// Sends a command and listens for a while.
fn ask(line: &mut FaultyLine<Counter>, clock: &ManualClock, patience: Duration) -> Vec<u8> {
    line.send(b"next\r\n").unwrap();
    let end = clock.now() + patience;
    let mut heard = Vec::new();
    while clock.now() < end {
        heard.extend(line.receive(end - clock.now()).unwrap());
    }
    heard
}

const PATIENCE: Duration = Duration::from_millis(50);

fn any_shares() -> impl Strategy<Value = CommandShares> {
    prop::array::uniform6(0.0..0.16_f64).prop_map(|[a, b, c, d, e, f]| CommandShares {
        lost: a,
        silent: b,
        slow: c,
        stray: d,
        garbled: e,
        unavailable: f,
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn every_reply_is_unchanged_or_recorded_as_faulty(
        seed in any::<u64>(), shares in any_shares()
    ) {
        // Slow replies arrive long after the last command here.
        let line = LineFaults { shares, slow_ms: 100_000, ..LineFaults::default() };
        let (mut line, clock) = faulty(&with(seed, line));
        let mut heard = 0;
        let mut held_back = false;
        for number in 0..60 {
            let reply = ask(&mut line, &clock, PATIENCE);
            let faults = line.record().faults();
            let fault = faults.iter().find(|f| f.number == number).map(|f| f.fault);
            let whole = format!("{heard:04}\r\n").into_bytes();
            match fault {
                // Bytes are never reordered: replies after a slow one wait, too.
                Some(LineFault::Slow) => held_back = true,
                _ if held_back => prop_assert!(reply.is_empty()),
                None => prop_assert_eq!(&reply, &whole),
                Some(LineFault::Lost | LineFault::Silent) => prop_assert!(reply.is_empty()),
                Some(LineFault::Stray) => {
                    prop_assert!(reply.ends_with(&whole) && (7..=14).contains(&reply.len()));
                }
                Some(LineFault::Garbled) => {
                    let wrong = reply.iter().zip(&whole).filter(|(a, b)| a != b).count();
                    prop_assert_eq!((reply.len(), wrong), (6, 1));
                }
                Some(LineFault::Unavailable) => prop_assert_eq!(&reply, b"?8\r\n"),
                Some(LineFault::Cut) => prop_assert!(false, "nothing was cut"),
            }
            heard += u64::from(!matches!(fault, Some(LineFault::Lost | LineFault::Unavailable)));
        }
        let record = line.record();
        let kept_from_unit =
            record.count(|f| matches!(f, LineFault::Lost | LineFault::Unavailable));
        prop_assert_eq!((record.taken(), record.given()), (60, 60 - kept_from_unit));
        prop_assert_eq!(heard, record.given());
    }

    #[test]
    fn the_same_seed_gives_the_same_faults(seed in any::<u64>(), shares in any_shares()) {
        let settings = with(seed, LineFaults { shares, ..LineFaults::default() });
        let run = |patience| {
            let (mut line, clock) = faulty(&settings);
            (0..40).for_each(|_| drop(ask(&mut line, &clock, patience)));
            line.record().faults()
        };
        prop_assert_eq!(run(PATIENCE), run(Duration::from_millis(9)));
    }
}

#[test]
fn without_faults_every_byte_passes_at_its_time() {
    let (mut line, clock) = faulty(&FaultSettings::default());
    for number in 0..5 {
        let sent = clock.now();
        line.send(b"next\r\n").unwrap();
        assert_eq!(line.receive(PATIENCE).unwrap(), format!("{number:04}").into_bytes());
        assert_eq!(clock.now(), sent + ANSWER);
        assert_eq!(line.receive(PATIENCE).unwrap(), b"\r\n");
        assert!(line.receive(PATIENCE).unwrap().is_empty());
        assert_eq!(clock.now(), sent + ANSWER + PATIENCE);
    }
}

#[test]
fn a_slow_reply_comes_late_and_in_its_order() {
    let mut settings = only(CommandShares { slow: 1.0, ..CommandShares::default() });
    settings.line.slow_ms = 70;
    let (mut line, clock) = faulty(&settings);
    assert!(ask(&mut line, &clock, PATIENCE).is_empty());
    // The first reply arrives after the second command.
    line.send(b"next\r\n").unwrap();
    let mut heard = Vec::new();
    while heard.len() < 12 {
        heard.extend(line.receive(PATIENCE).unwrap());
    }
    assert_eq!(heard, b"0000\r\n0001\r\n");
    assert_eq!(clock.now(), PATIENCE + ANSWER + Duration::from_millis(70));
}

#[test]
fn a_cut_line_stays_lost() {
    let (mut line, clock) =
        faulty(&with(1, LineFaults { cut_after: Some(2), ..Default::default() }));
    assert_eq!(ask(&mut line, &clock, PATIENCE), b"0000\r\n");
    assert_eq!(ask(&mut line, &clock, PATIENCE), b"0001\r\n");
    assert_eq!(line.send(b"next\r\n").unwrap_err().kind(), io::ErrorKind::BrokenPipe);
    assert!(line.receive(PATIENCE).is_err() && line.set_baud_rate(9600).is_err());
    assert_eq!(line.record().count(|fault| *fault == LineFault::Cut), 1);
}
