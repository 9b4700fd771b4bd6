//! The daemon as a systemd service. It reports when it is ready for shots, triggers the watchdog
//! while all loops run and no worker hangs, and sets the status line. Without systemd
//! (`NOTIFY_SOCKET`), hung workers are only logged.

use std::{
    future::Future,
    sync::Arc,
    time::{Duration, Instant},
};

use parking_lot::Mutex;
use sd_notify::NotifyState;

use crate::{
    acquisition::{Heartbeat, Ledger, Mode},
    pipeline::{Board, HungPair},
    server::{ApiState, Phase},
};

/// Interval at which the loops are checked.
const CHECK_INTERVAL: Duration = Duration::from_millis(100);
/// Smallest interval between changes of the status line.
const STATUS_INTERVAL: Duration = Duration::from_secs(1);

/// A message to the service manager.
#[derive(Debug, Clone, PartialEq)]
enum Message {
    Ready,
    Stopping,
    Alive,
    Status(String),
}

/// Decides which messages are sent. Time is passed in.
#[derive(Debug)]
struct Watch {
    acquisition: Heartbeat,
    writer: Heartbeat,
    /// The service manager kills the service after this time without a message.
    limit: Option<Duration>,
    ready: bool,
    stopping: bool,
    fed_at: Option<Instant>,
    hangs: bool,
    status: String,
    status_at: Option<Instant>,
}

impl Watch {
    fn new(acquisition: Heartbeat, writer: Heartbeat, limit: Option<Duration>) -> Self {
        Self {
            acquisition,
            writer,
            limit,
            ready: false,
            stopping: false,
            fed_at: None,
            hangs: false,
            status: String::new(),
            status_at: None,
        }
    }

    fn check(
        &mut self,
        now: Instant,
        phase: &Phase,
        hung: Option<HungPair>,
        status: String,
    ) -> Vec<Message> {
        let mut messages = Vec::new();
        if !self.ready && *phase == Phase::Running && self.acquisition.has_begun() {
            self.ready = true;
            messages.push(Message::Ready);
        }
        if *phase == Phase::Stopping {
            messages.extend(self.stop());
        }
        if self.may_feed(now, hung) {
            self.fed_at = Some(now);
            messages.push(Message::Alive);
        }
        let due = self.status_at.is_none_or(|at| now >= at + STATUS_INTERVAL);
        if due && status != self.status {
            self.status_at = Some(now);
            self.status.clone_from(&status);
            messages.push(Message::Status(status));
        }
        messages
    }

    /// The message is sent once.
    fn stop(&mut self) -> Option<Message> {
        (!std::mem::replace(&mut self.stopping, true)).then_some(Message::Stopping)
    }

    /// Whether the watchdog is to be triggered: it is due, every loop has run recently and no
    /// worker hangs. A loop may take half the limit; the other half is reserve.
    fn may_feed(&mut self, now: Instant, hung: Option<HungPair>) -> bool {
        let hanging = self.silent_loop(now).or_else(|| hung.map(|hung| hung.to_string()));
        let hung_before = std::mem::replace(&mut self.hangs, hanging.is_some());
        if let Some(words) = hanging.filter(|_| !hung_before) {
            let fed =
                if self.limit.is_some() { "; the watchdog is no longer triggered" } else { "" };
            tracing::error!("{words}{fed}");
        }
        let Some(limit) = self.limit.filter(|_| !self.hangs) else { return false };
        self.fed_at.is_none_or(|fed| now >= fed + limit / 4)
    }

    /// A loop that has been silent for too long, in words.
    fn silent_loop(&self, now: Instant) -> Option<String> {
        let limit = self.limit?;
        let loops = [("acquisition", &self.acquisition), ("the writer of results", &self.writer)];
        let silent = loops.map(|(name, beat)| (name, beat.silent_for(now)));
        let (name, silence) = silent.into_iter().find(|(_, silence)| *silence > limit / 2)?;
        Some(format!("{name} has been silent for {} s", silence.as_secs()))
    }
}

/// Reports the state of a run to the service manager.
pub(super) struct Service {
    watch: Watch,
    state: ApiState,
    ledger: Arc<Mutex<Ledger>>,
    board: Arc<Board>,
}

impl Service {
    /// For the given run; `acquisition` is the heartbeat of its loop.
    pub fn new(
        state: &ApiState,
        ledger: &Arc<Mutex<Ledger>>,
        board: &Arc<Board>,
        acquisition: &Heartbeat,
    ) -> Self {
        let limit = sd_notify::watchdog_enabled();
        let watch = Watch::new(acquisition.clone(), board.writing().clone(), limit);
        Self { watch, state: state.clone(), ledger: ledger.clone(), board: board.clone() }
    }

    /// Runs `work` and reports meanwhile.
    pub async fn accompany<T>(mut self, work: impl Future<Output = T>) -> T {
        let mut check = tokio::time::interval(CHECK_INTERVAL);
        tokio::pin!(work);
        loop {
            tokio::select! {
                done = &mut work => {
                    send(self.watch.stop().into_iter().collect());
                    return done;
                }
                _ = check.tick() => {
                    let (phase, status) = (self.state.phase(), self.status());
                    let now = Instant::now();
                    let hung = self.board.pair_times().hung(now);
                    send(self.watch.check(now, &phase, hung, status));
                }
            }
        }
    }

    /// The status line for `systemctl status`.
    fn status(&self) -> String {
        let what = match self.state.phase() {
            Phase::Starting => "preparing the measurement",
            Phase::Running if !self.watch.ready => "preparing the instruments",
            Phase::Running => match self.state.control() {
                Some(control) if control.mode == Mode::Lost => {
                    "bench lost, searching for the synchroniser"
                }
                Some(control) if control.mode == Mode::Disarmed && !control.held.is_empty() => {
                    "bench back, waiting for an operator"
                }
                _ => "taking shots",
            },
            Phase::Stopping => "finishing the shots in process",
            Phase::Finished => "finished",
            Phase::Failed(_) => "failed",
        };
        let triggers = self.ledger.lock().accounts().first().map_or(0, |account| account.triggers);
        let counts = self.board.counts();
        let (done, failed) = (counts.done, counts.failed + counts.write_failed);
        format!("{what}: {triggers} triggers, {done} shots measured, {failed} without result")
    }
}

fn send(messages: Vec<Message>) {
    if messages.is_empty() {
        return;
    }
    let states: Vec<NotifyState<'_>> = messages
        .iter()
        .map(|message| match message {
            Message::Ready => NotifyState::Ready,
            Message::Stopping => NotifyState::Stopping,
            Message::Alive => NotifyState::Watchdog,
            Message::Status(line) => NotifyState::Status(line),
        })
        .collect();
    if let Err(error) = sd_notify::notify(&states) {
        tracing::debug!(%error, "cannot notify the service manager");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pipeline::PairTimes;

    const LIMIT: Duration = Duration::from_secs(8);

    struct Watched {
        watch: Watch,
        acquisition: Heartbeat,
        writer: Heartbeat,
        pairs: PairTimes,
        began: Instant,
    }

    impl Watched {
        fn new() -> Self {
            let (acquisition, writer) = (Heartbeat::default(), Heartbeat::default());
            let watch = Watch::new(acquisition.clone(), writer.clone(), Some(LIMIT));
            let pairs = PairTimes::new(2 * LIMIT);
            Self { watch, acquisition, writer, pairs, began: Instant::now() }
        }

        /// The messages when no heartbeat has occurred for `seconds`.
        fn after(&mut self, seconds: u64, phase: &Phase) -> Vec<Message> {
            let now = self.began + Duration::from_secs(seconds);
            self.watch.check(now, phase, self.pairs.hung(now), String::new())
        }
    }

    #[test]
    fn ready_is_sent_once_and_only_when_the_run_loop_runs() {
        let mut run = Watched::new();
        assert_eq!(run.after(0, &Phase::Starting), [Message::Alive]);
        assert_eq!(run.after(0, &Phase::Running), []);
        run.acquisition.beat();
        assert_eq!(run.after(0, &Phase::Running), [Message::Ready]);
        assert_eq!(run.after(1, &Phase::Running), []);
        assert_eq!(run.after(2, &Phase::Stopping), [Message::Stopping, Message::Alive]);
        assert_eq!(run.after(3, &Phase::Stopping), []);
    }

    #[test]
    fn the_watchdog_stays_silent_while_a_loop_hangs() {
        for hung in 0..2 {
            let mut run = Watched::new();
            let beats = [run.acquisition.clone(), run.writer.clone()];
            beats.iter().for_each(Heartbeat::beat);
            assert!(run.after(1, &Phase::Running).contains(&Message::Alive));
            assert_eq!(run.after(2, &Phase::Running), [], "not due");
            assert_eq!(run.after(3, &Phase::Running), [Message::Alive]);
            // One loop rests, the other hangs.
            beats[1 - hung].rest();
            for seconds in 5..30 {
                assert_eq!(run.after(seconds, &Phase::Running), [], "{seconds} s");
            }
            // The slow loop continues.
            beats[hung].rest();
            assert_eq!(run.after(30, &Phase::Running), [Message::Alive]);
        }
    }

    #[test]
    fn the_watchdog_stays_silent_while_a_worker_hangs() {
        let mut run = Watched::new();
        run.pairs.begin(7, run.began);
        assert_eq!(run.after(16, &Phase::Running), [Message::Alive], "as long as is allowed");
        for phase in [Phase::Running, Phase::Stopping] {
            for seconds in 18..30 {
                assert!(!run.after(seconds, &phase).contains(&Message::Alive), "{seconds} s");
            }
        }
        run.pairs.end(7, run.began + 30 * LIMIT / 8, true);
        assert_eq!(run.after(31, &Phase::Running), [Message::Alive], "it was only slow");
        // From now on the duration of a pair is known.
        run.pairs.begin(8, run.began + 31 * LIMIT / 8);
        assert_eq!(run.after(331, &Phase::Running), [Message::Alive]);
        assert_eq!(run.after(340, &Phase::Running), []);
    }

    #[test]
    fn the_status_is_sent_when_it_changes_and_at_most_once_a_second() {
        let mut watch = Watch::new(Heartbeat::default(), Heartbeat::default(), None);
        let began = Instant::now();
        let mut check = |ms: u64, line: &str| {
            let now = began + Duration::from_millis(ms);
            !watch.check(now, &Phase::Running, None, line.to_owned()).is_empty()
        };
        let sent = [check(0, "a"), check(100, "b"), check(1000, "b"), check(2500, "b")];
        assert_eq!(sent, [true, false, true, false]);
    }
}
