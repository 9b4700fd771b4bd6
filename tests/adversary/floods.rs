//! Connections of every kind at the default limits: no shot is lost, and `disarm` is answered.

use std::{fs, path::PathBuf, time::Duration};

use rand::RngExt;
use tempfile::TempDir;

use crate::{
    bench::Running,
    campaign::{Campaign, Case},
    connections::{
        Flood, OPEN_FILES, OPERATOR, OTHER, READ, UNFINISHED, assert_nothing_lost, disarm, stream,
        with_tokens,
    },
    report::FaultKind,
};

/// Most connections of one kind.
const MOST: usize = 400;
/// Time limit of `disarm` on an otherwise idle machine.
const PROMPT: Duration = Duration::from_secs(1);

/// See the module.
pub struct Floods {
    root: TempDir,
    config: PathBuf,
    slowest: Duration,
}

impl Floods {
    /// Writes the configuration, with tokens.
    pub fn prepare() -> Self {
        let root = tempfile::tempdir().expect("a folder");
        let config = with_tokens(root.path());
        Self { root, config, slowest: Duration::ZERO }
    }
}

impl Campaign for Floods {
    fn run(&mut self, case: &mut Case<'_>) {
        let log = self.root.path().join("log");
        let file = fs::File::create(&log).expect("a file");
        let running = Running::limited(&self.config, OPEN_FILES, file).with_token(READ);
        running.wait_until(|status| status["shots"]["done"].as_u64() > Some(2));
        let mut flood = Flood::of(&running);
        for _ in 0..case.random.random_range(3..7) {
            let from = if case.random.random() { OPERATOR } else { OTHER };
            let count = case.random.random_range(1..=MOST);
            flood.pour(from, count, &request(case));
        }
        let took = disarm(&running);
        self.slowest = self.slowest.max(took);
        if took > PROMPT && case.is_soak {
            case.fault(FaultKind::Wrong, format!("disarm took {:.2} s", took.as_secs_f64()));
        }
        drop(flood);
        running.wait_until(|status| status["shots"]["awaiting_frames"] == 0);
        case.note_memory(running.child.id());
        let run = running.terminate();
        case.judge_log(&fs::read_to_string(&log).unwrap_or_default());
        let (triggers, kept) = assert_nothing_lost(&run);
        if triggers != kept {
            case.fault(FaultKind::Lost, format!("{kept} of {triggers} shots have images"));
        }
        case.tally.acknowledged += triggers;
        let _ = fs::remove_dir_all(run);
    }

    fn remark(&self) -> String {
        format!("slowest disarm {:.3} s", self.slowest.as_secs_f64())
    }
}

/// Request of a connection: an event stream, an incomplete header, garbage, or nothing.
fn request(case: &mut Case<'_>) -> String {
    match case.random.random_range(0..7) {
        0 => stream(READ),
        1 => stream("not-a-token"),
        2 => UNFINISHED.to_owned(),
        3 => String::new(),
        4 => format!(
            "GET /api/v1/results/1 HTTP/1.1\r\nHost: localhost\r\nAuthorization: Bearer {READ}\r\n\r\n"
        ),
        5 => {
            let length = case.random.random_range(1..9000);
            (0..length).map(|_| char::from(case.random.random_range(0..128_u8))).collect()
        }
        _ => {
            format!("POST /api/v1/control/disarm HTTP/1.1\r\nContent-Length: {}\r\n\r\n", u64::MAX)
        }
    }
}
