//! What whoever runs the bench may ask of a run under way.
//!
//! ```text
//! disarmed <-> armed (lamps fire) <-> firing
//! any of them -> lost (the synchroniser does not answer) -> disarmed, or what it was
//! ```
//!
//! Requests go through a channel to the run loop, which answers when it has taken them up; nothing
//! else touches the synchroniser.

use std::sync::Arc;

use lfpiv_hw::timing::PulseSchedule;
use parking_lot::Mutex;
use serde::Serialize;
use tokio::sync::{mpsc, oneshot};

/// A request.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "command", rename_all = "snake_case")]
pub enum Command {
    /// Take shots.
    Start,
    /// End the burst that runs, laser safe, and take no more shots; the lamps are warmed anew.
    Stop,
    /// Warm the lamps, fire nothing.
    Arm,
    /// Safe state: Q-switches off, lamps off.
    Disarm,
    /// After a loss of the bench: what the run did before.
    GoOn,
    /// Another time between the light pulses, from the next burst on.
    SetDt { dt_us: f64 },
    /// A remark for the run's record.
    Note { text: String },
}

/// What the run does.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Mode {
    /// Outputs off.
    Disarmed,
    /// Lamps warm, nothing fired.
    Armed,
    /// Shots are taken, or held for the reasons given.
    Firing,
    /// The synchroniser does not answer, nothing is fired, and it is looked for.
    Lost,
    /// The run is ending.
    Stopping,
}

/// What the run does, and why it may not.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ControlState {
    /// What it does.
    pub mode: Mode,
    /// Time between the light pulses of the next burst.
    pub dt_us: f64,
    /// Why nothing is fired although it should be; empty when all is well.
    pub held: Vec<String>,
}

/// A request was not taken up.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refusal {
    /// Why, one by one.
    pub reasons: Vec<String>,
}

impl Refusal {
    pub(super) fn because(reason: impl Into<String>) -> Self {
        Self { reasons: vec![reason.into()] }
    }
}

/// Plans the schedule for a time between the pulses in µs, or says why there is none.
pub type Planner = Box<dyn Fn(f64) -> Result<PulseSchedule, String> + Send + Sync>;

type Answer = Result<ControlState, Refusal>;

/// One request on its way to the run loop.
pub(super) struct Request {
    pub command: Command,
    pub answer: oneshot::Sender<Answer>,
}

/// Asks. Clones ask the same run.
#[derive(Clone)]
pub struct Control {
    requests: mpsc::Sender<Request>,
    state: Arc<Mutex<ControlState>>,
}

/// The run loop's end.
pub struct ControlInbox {
    pub(super) requests: mpsc::Receiver<Request>,
    pub(super) state: Arc<Mutex<ControlState>>,
    pub(super) plan: Planner,
}

/// Requests that may wait.
const REQUESTS: usize = 16;

/// Both ends of a control that begins in `mode`.
pub fn control(mode: Mode, dt_us: f64, plan: Planner) -> (Control, ControlInbox) {
    let (sender, requests) = mpsc::channel(REQUESTS);
    let state = Arc::new(Mutex::new(ControlState { mode, dt_us, held: Vec::new() }));
    (Control { requests: sender, state: state.clone() }, ControlInbox { requests, state, plan })
}

impl ControlInbox {
    /// The next request; never when nobody can ask.
    pub(super) async fn next(&mut self) -> Request {
        match self.requests.recv().await {
            Some(request) => request,
            None => std::future::pending().await,
        }
    }
}

impl Control {
    /// Asks, and waits until the run loop has taken it up.
    ///
    /// # Errors
    ///
    /// [`Refusal`], also when the run is over.
    pub async fn request(&self, command: Command) -> Answer {
        let over = || Refusal::because("the run is over");
        let (answer, answered) = oneshot::channel();
        self.requests.send(Request { command, answer }).await.map_err(|_| over())?;
        answered.await.map_err(|_| over())?
    }

    /// What the run does.
    pub fn state(&self) -> ControlState {
        self.state.lock().clone()
    }
}
