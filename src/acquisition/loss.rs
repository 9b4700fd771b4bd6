//! What the run knows of a synchroniser that it has lost.

use std::time::Instant;

use tokio::sync::oneshot;

use super::{Mode, synchroniser::UnsafeState};

/// A lost unit.
#[derive(Debug)]
pub(super) struct Loss {
    pub since: Instant,
    /// The mode in which the run continues once the unit is back.
    pub resume_mode: Mode,
    /// The last message, so that it is not repeated.
    pub last_message: String,
    pub next_attempt: Instant,
    pub attempt: Option<oneshot::Receiver<Result<String, UnsafeState>>>,
}
