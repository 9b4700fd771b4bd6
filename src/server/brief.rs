//! The run in short: what `/api/v1/status` and the event `status` have in common.

use serde::Serialize;
use utoipa::ToSchema;

use crate::{acquisition::ControlState, pipeline::Watermarks};

/// Summary of the run: the data of the event `status`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct Brief {
    pub state: &'static str,
    pub error: Option<String>,
    pub stage: String,
    pub shots: ShotCounts,
    pub watermarks: Option<Watermarks>,
    pub control: Option<ControlState>,
    pub cameras: Vec<CameraView>,
}

/// Number of shots by state; `triggered` is the sum of the others.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, ToSchema)]
pub(super) struct ShotCounts {
    pub triggered: u64,
    pub awaiting_frames: u64,
    pub queued: u64,
    pub processing: u64,
    pub done: u64,
    pub failed: u64,
    pub write_failed: u64,
    pub shed: u64,
    pub not_fired: u64,
    pub lost: u64,
}

/// State of a camera by its driver.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, ToSchema)]
pub(super) struct CameraView {
    pub camera: String,
    /// Whether the camera answers, as far as known.
    pub connected: bool,
    /// Completely received frames.
    pub frames: u64,
}
