//! Requests to a run in progress.
//!
//! ```text
//! disarmed <-> armed (lamps fire) <-> firing
//! any of them -> lost (the synchroniser does not answer) -> disarmed, or what it was
//! ```
//!
//! Requests pass through a channel to the run loop, which answers after carrying them out. Nothing
//! else uses the synchroniser.

use std::sync::Arc;

use lfpiv_hw::timing::PulseSchedule;
use parking_lot::Mutex;
use serde::Serialize;
use tokio::sync::{mpsc, oneshot};

/// A request to the run.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "command", rename_all = "snake_case")]
pub enum Command {
    /// Takes shots.
    Start,
    /// Ends the current burst with the laser safe and takes no more shots. The lamps must warm up
    /// again.
    Stop,
    /// Warms up the lamps without firing.
    Arm,
    /// Safe state: Q-switches off, lamps off.
    Disarm,
    /// After a loss of the bench: resumes the previous mode.
    Resume,
    /// Changes the time between the light pulses from the next burst on.
    SetDt { dt_us: f64 },
    /// Adds a note to the record of the run.
    Note { text: String },
}

/// Mode of the run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Mode {
    /// Outputs off.
    Disarmed,
    /// Lamps warm, not firing.
    Armed,
    /// Taking shots, or holding for the stated reasons.
    Firing,
    /// The synchroniser does not answer. Nothing is fired, and the run searches for it.
    Lost,
    /// The run is ending.
    Stopping,
}

/// State of the run.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ControlState {
    /// The mode.
    pub mode: Mode,
    /// Time between the light pulses of the next burst.
    pub dt_us: f64,
    /// Reasons why firing is on hold; empty when it is not.
    pub held: Vec<String>,
}

/// A refused request.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refusal {
    /// All reasons.
    pub reasons: Vec<String>,
}

impl Refusal {
    pub(super) fn because(reason: impl Into<String>) -> Self {
        Self { reasons: vec![reason.into()] }
    }
}

/// Plans the schedule for a time between the pulses in µs; the error says why there is none.
pub type Planner = Box<dyn Fn(f64) -> Result<PulseSchedule, String> + Send + Sync>;

type Answer = Result<ControlState, Refusal>;

/// A request in transit to the run loop.
pub(super) struct Request {
    pub command: Command,
    pub answer: oneshot::Sender<Answer>,
}

/// Handle for requests. Clones address the same run.
#[derive(Clone)]
pub struct Control {
    requests: mpsc::Sender<Request>,
    state: Arc<Mutex<ControlState>>,
}

/// Receiving end, owned by the run loop.
pub struct ControlInbox {
    pub(super) requests: mpsc::Receiver<Request>,
    pub(super) state: Arc<Mutex<ControlState>>,
    pub(super) plan: Planner,
}

/// Capacity of the request channel.
const REQUESTS: usize = 16;

/// Creates both ends of a control that starts in `mode`.
pub fn control(mode: Mode, dt_us: f64, plan: Planner) -> (Control, ControlInbox) {
    let (sender, requests) = mpsc::channel(REQUESTS);
    let state = Arc::new(Mutex::new(ControlState { mode, dt_us, held: Vec::new() }));
    (Control { requests: sender, state: state.clone() }, ControlInbox { requests, state, plan })
}

impl ControlInbox {
    /// The next request; pending for ever when all handles are gone.
    pub(super) async fn next(&mut self) -> Request {
        match self.requests.recv().await {
            Some(request) => request,
            None => std::future::pending().await,
        }
    }
}

impl Control {
    /// Sends a request and waits until the run loop has carried it out.
    ///
    /// # Errors
    ///
    /// [`Refusal`], including when the run is over.
    pub async fn request(&self, command: Command) -> Answer {
        let over = || Refusal::because("the run is over");
        let (answer, answered) = oneshot::channel();
        self.requests.send(Request { command, answer }).await.map_err(|_| over())?;
        answered.await.map_err(|_| over())?
    }

    /// The current state.
    pub fn state(&self) -> ControlState {
        self.state.lock().clone()
    }
}
