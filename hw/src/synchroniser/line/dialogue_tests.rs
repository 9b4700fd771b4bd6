use std::{
    collections::VecDeque,
    sync::{Arc, Mutex},
};

use super::*;
use crate::synchroniser::line::{Direction, RecordedLine, Transcript};

/// A line that returns prepared pieces after each command, one per call.
#[derive(Clone, Default)]
struct Prepared {
    replies: Arc<Mutex<VecDeque<Vec<&'static str>>>>,
    waiting: Arc<Mutex<VecDeque<&'static str>>>,
}

impl Prepared {
    fn reply(self, pieces: &[&'static str]) -> Self {
        self.replies.lock().unwrap().push_back(pieces.to_vec());
        self
    }

    fn dialogue(&self) -> Dialogue {
        Dialogue::new(Box::new(self.clone()), Duration::ZERO, Duration::from_millis(20))
    }
}

impl Line for Prepared {
    fn name(&self) -> &str {
        "prepared"
    }

    fn send(&mut self, _: &[u8]) -> io::Result<()> {
        let pieces = self.replies.lock().unwrap().pop_front().unwrap_or_default();
        self.waiting.lock().unwrap().extend(pieces);
        Ok(())
    }

    fn receive(&mut self, at_most: Duration) -> io::Result<Vec<u8>> {
        match self.waiting.lock().unwrap().pop_front() {
            Some(piece) => Ok(piece.as_bytes().to_vec()),
            None => {
                std::thread::sleep(at_most);
                Ok(Vec::new())
            }
        }
    }

    fn set_baud_rate(&mut self, _: u32) -> io::Result<()> {
        Ok(())
    }
}

fn is_ok(line: &str) -> bool {
    line == "ok"
}

#[test]
fn replies_are_found_among_echo_pieces_empty_lines_and_strays() {
    for pieces in [
        &["ok\r\n"][..],
        &["o", "k", "\r", "\n"],
        &["\r\n\r\nok\r\n"],
        &[":pulse1:state on\r\n", "ok\r\n"],
        &["\u{1}\u{7}ok\r\n"],
        &["noise\r\n", "ok\r\n"],
    ] {
        let mut dialogue = Prepared::default().reply(pieces).dialogue();
        assert_eq!(dialogue.ask(":PULSE1:STATE ON", is_ok).unwrap(), "ok", "{pieces:?}");
        assert_eq!(dialogue.echo(), Some(pieces.len() == 2 && pieces[0].starts_with(':')));
        assert!(!dialogue.is_out_of_step());
    }
}

#[test]
fn silence_is_reported_with_the_received_text() {
    let mut dialogue = Prepared::default().reply(&["huh\r\n", "o"]).dialogue();
    let error = dialogue.ask("*RST", is_ok).unwrap_err().to_string();
    assert_eq!(error, "no reply to \"*RST\" within 20 ms on prepared, but \"huh | o\"");
    assert!(dialogue.is_out_of_step());
}

#[test]
fn a_late_reply_answers_no_later_question() {
    let line = Prepared::default().reply(&[]).reply(&["ok\r\n", "me,1,2,3\r\n"]).reply(&["ok\r\n"]);
    let mut dialogue = line.dialogue();
    assert!(dialogue.ask("first", is_ok).is_err());
    // The reply to the first command arrives after the second was sent.
    let identity = dialogue.resynchronise("*IDN?", |line| line.starts_with("me")).unwrap();
    assert_eq!(identity, "me,1,2,3");
    assert!(!dialogue.is_out_of_step());
    // Pending input is discarded before a command is sent.
    line.waiting.lock().unwrap().push_back("0\r\n");
    assert_eq!(dialogue.ask("third", |_| true).unwrap(), "ok");
}

#[test]
fn the_transcript_holds_every_byte_both_ways_and_in_order() {
    let transcript = Transcript::in_memory();
    let line = Prepared::default().reply(&["o", "k\r\n"]);
    let recorded = RecordedLine::new(line, transcript.clone());
    let mut dialogue = Dialogue::new(Box::new(recorded), Duration::ZERO, Duration::from_millis(20));
    dialogue.ask("*RST", is_ok).unwrap();
    let entries = transcript.entries();
    let pieces: Vec<_> =
        entries.iter().map(|entry| (entry.direction, entry.bytes.as_slice())).collect();
    let expected: [(Direction, &[u8]); 3] = [
        (Direction::ToUnit, b"*RST\r\n"),
        (Direction::ToHost, b"o"),
        (Direction::ToHost, b"k\r\n"),
    ];
    assert_eq!(pieces, expected);
    assert!(entries.is_sorted_by_key(|entry| entry.host_time_ns));
    assert!(entries[0].to_string().ends_with(" > *RST\\r\\n"), "{}", entries[0]);
    assert_eq!(transcript.sent_lines(), ["*RST"]);
}

#[test]
fn commands_are_paced() {
    let line = Prepared::default().reply(&["ok\r\n"]).reply(&["ok\r\n"]);
    let pacing = Duration::from_millis(30);
    let mut dialogue = Dialogue::new(Box::new(line), pacing, Duration::from_millis(20));
    dialogue.ask("one", is_ok).unwrap();
    let answered = Instant::now();
    dialogue.ask("two", is_ok).unwrap();
    assert!(answered.elapsed() >= pacing - Duration::from_millis(1));
}
