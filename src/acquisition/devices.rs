//! A thread per camera: device calls block, and nothing else may wait for them. The synchroniser
//! has one, too ([`super::synchroniser`]).

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

/// How long a camera thread waits for a frame before it looks whether it should stop.
const FRAME_WAIT: Duration = Duration::from_millis(50);

/// What a camera thread reports.
#[derive(Debug)]
pub(super) enum CameraEvent {
    /// The camera waits for triggers; it may be away for so long before that is noticed.
    Started { camera: usize, notices_absence_within: Duration },
    /// A frame came, when, and what the stream has counted since the start.
    Frame { camera: usize, frame: Frame, arrived: Duration, statistics: StreamStatistics },
    /// The camera has vanished or is back, or it has stopped: what its stream has counted.
    Stream { camera: usize, connected: bool, at: Duration, statistics: StreamStatistics },
    /// The camera is of no more use; its thread has ended.
    Failed { error: DeviceError },
}

/// Starts the camera on a thread of its own; the thread stops the camera once `stop` is cancelled.
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
            // With the receiver gone nobody is left to tell but the log.
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
    let notices_absence_within = camera.notices_absence_within();
    let started = CameraEvent::Started { camera: index, notices_absence_within };
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
    // Frames that were lost last have no frame behind them to tell.
    let _ = events.blocking_send(stream_event(index, camera, connected, clock.now()));
    Ok(())
}

fn stream_event(index: usize, camera: &dyn Camera, connected: bool, at: Duration) -> CameraEvent {
    CameraEvent::Stream { camera: index, connected, at, statistics: camera.statistics() }
}

/// A driver's panic must not leave the laser on or a thread silently dead.
pub(super) fn guarded<T>(
    device: &str,
    call: impl FnOnce() -> Result<T, DeviceError>,
) -> Result<T, DeviceError> {
    catch_unwind(AssertUnwindSafe(call)).unwrap_or_else(|panic| {
        let (device, words) = (device.to_owned(), panic_message(panic.as_ref()));
        Err(DeviceError::Panicked { device, words })
    })
}

/// The words of a panic.
pub fn panic_message(panic: &(dyn Any + Send)) -> String {
    let words = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
    words
        .or_else(|| panic.downcast_ref::<String>().cloned())
        .unwrap_or_else(|| "no message".to_owned())
}

/// Waits for a thread without blocking the runtime.
pub(super) async fn join(thread: JoinHandle<()>) {
    let name = thread.thread().name().unwrap_or("unnamed").to_owned();
    let joined = tokio::task::spawn_blocking(move || thread.join()).await;
    if !matches!(joined, Ok(Ok(()))) {
        tracing::error!(thread = name, "ended by a panic");
    }
}
