//! One thread per camera, because device calls block. The synchroniser has its own thread, too
//! ([`super::synchroniser`]).

use std::{
    any::Any,
    panic::{AssertUnwindSafe, catch_unwind},
    sync::Arc,
    thread::JoinHandle,
    time::Duration,
};

use lfpiv_hw::device::{Camera, DeviceError, Frame, StreamStatistics};
use tokio::sync::mpsc;
use tokio_util::sync::CancellationToken;

use super::{AcquisitionError, RunClock};

/// How long a camera thread waits for a frame before it checks for cancellation.
const FRAME_WAIT: Duration = Duration::from_millis(50);

/// What a camera thread reports.
#[derive(Debug)]
pub(super) enum CameraEvent {
    /// The camera waits for triggers; its driver detects a lost connection within this time.
    Started { camera: usize, loss_detection_time: Duration },
    /// A frame, its arrival time, and the stream's counters since the start.
    Frame { camera: usize, frame: Frame, arrived: Duration, statistics: StreamStatistics },
    /// The connection was lost or restored, or the stream ended; with the stream's counters.
    Stream { camera: usize, connected: bool, at: Duration, statistics: StreamStatistics },
    /// The camera has failed; its thread has ended.
    Failed { error: DeviceError },
}

/// Starts the camera on its own thread, which stops the camera once `stop` is cancelled.
pub(super) fn spawn_camera(
    index: usize,
    mut camera: Box<dyn Camera>,
    events: mpsc::Sender<CameraEvent>,
    clock: Arc<dyn RunClock>,
    stop: CancellationToken,
) -> Result<JoinHandle<()>, AcquisitionError> {
    let name = camera.name().to_owned();
    let thread = std::thread::Builder::new().name(format!("camera {name}"));
    let run = move || {
        let device = camera.name().to_owned();
        let streamed =
            guarded(&device, || stream(index, camera.as_mut(), &events, clock.as_ref(), &stop));
        let stopped = guarded(&device, || camera.stop());
        if let Err(error) = streamed.and(stopped) {
            // The receiver is gone: only the log remains.
            if events.blocking_send(CameraEvent::Failed { error }).is_err() {
                tracing::warn!(camera = device, "failed while the run was ending");
            }
        }
    };
    thread.spawn(run).map_err(|source| AcquisitionError::Thread { device: name, source })
}

fn stream(
    index: usize,
    camera: &mut dyn Camera,
    events: &mpsc::Sender<CameraEvent>,
    clock: &dyn RunClock,
    stop: &CancellationToken,
) -> Result<(), DeviceError> {
    camera.start()?;
    let loss_detection_time = camera.loss_detection_time();
    let started = CameraEvent::Started { camera: index, loss_detection_time };
    let mut listening = events.blocking_send(started).is_ok();
    let mut connected = true;
    while listening && !stop.is_cancelled() {
        let frame = camera.next_frame(FRAME_WAIT)?;
        let now = clock.now();
        if camera.is_connected() != connected {
            connected = !connected;
            listening = events.blocking_send(stream_event(index, camera, connected, now)).is_ok();
        }
        if let Some(frame) = frame {
            let statistics = camera.statistics();
            let event = CameraEvent::Frame { camera: index, frame, arrived: now, statistics };
            listening = events.blocking_send(event).is_ok();
        }
    }
    // No later frame reports the loss of the last ones.
    let _ = events.blocking_send(stream_event(index, camera, connected, clock.now()));
    Ok(())
}

fn stream_event(index: usize, camera: &dyn Camera, connected: bool, at: Duration) -> CameraEvent {
    CameraEvent::Stream { camera: index, connected, at, statistics: camera.statistics() }
}

/// Turns a driver's panic into an error: it must not leave the laser on or a thread silently dead.
pub(super) fn guarded<T>(
    device: &str,
    call: impl FnOnce() -> Result<T, DeviceError>,
) -> Result<T, DeviceError> {
    catch_unwind(AssertUnwindSafe(call)).unwrap_or_else(|panic| {
        let (device, message) = (device.to_owned(), panic_message(panic.as_ref()));
        Err(DeviceError::Panicked { device, message })
    })
}

/// The message of a panic.
pub fn panic_message(panic: &(dyn Any + Send)) -> String {
    let message = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
    message
        .or_else(|| panic.downcast_ref::<String>().cloned())
        .unwrap_or_else(|| "no message".to_owned())
}

/// Joins a thread without blocking the runtime.
pub(super) async fn join(thread: JoinHandle<()>) {
    let name = thread.thread().name().unwrap_or("unnamed").to_owned();
    let joined = tokio::task::spawn_blocking(move || thread.join()).await;
    if !matches!(joined, Ok(Ok(()))) {
        tracing::error!(thread = name, "ended by a panic");
    }
}
