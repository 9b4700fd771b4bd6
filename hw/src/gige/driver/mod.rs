//! The camera driver, based on Aravis.
//!
//! The driver searches for a lost camera (cable, power, control lost) itself, so that its reader
//! continues: meanwhile [`Camera::next_frame`] returns `None` and [`Camera::is_connected`] `false`;
//! after the configured patience the error is [`DeviceError::Lost`]. When the camera returns, Aravis'
//! objects are recreated, and every setting is applied and read back. Frame numbers then continue with
//! the first frame of a new trigger: only the camera's clock shows how many triggers it missed, if it
//! kept running.
//!
//! A damaged frame whose leader packet was lost has no id; it is counted as failed and not delivered.
//! Numbering starts at the first frame of which any packet arrives. If a first frame is lost entirely,
//! the numbers are shifted by one, which pairing detects by the timestamps.

mod apply;
mod as_found;
mod connection;
mod features;
mod priority;
mod receive_buffer;
mod stream;

use std::{
    thread::sleep,
    time::{Duration, Instant},
};

use super::{CameraSettings, FrameIds, ImageSize};
use crate::{
    device::{Camera, DeviceError, Frame, StreamStatistics},
    frame::ImagePool,
};

use as_found::AsFound;
use connection::Connection;
pub(super) use connection::list_devices;
use features::Features;
use stream::{FrameStream, Received};

/// Control counts as lost after several unanswered heartbeats; 11 s were observed.
const LOSS_DETECTION_TIME: Duration = Duration::from_secs(20);
/// Interval between reconnection attempts.
const RECONNECT_RETRY: Duration = Duration::from_millis(500);

/// A GigE Vision camera.
pub(super) struct GigeCamera {
    name: String,
    settings: CameraSettings,
    size: ImageSize,
    images: ImagePool,
    link: Link,
    ids: FrameIds,
    /// Counters of earlier streams since `start`.
    earlier: StreamStatistics,
    exposing: Exposing,
    /// What a borrowed camera was set to.
    as_found: Option<AsFound>,
}

/// What starts an exposure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Exposing {
    /// The synchroniser's trigger.
    Triggered,
    /// The end of the one before.
    Freely,
}

/// Connection state.
enum Link {
    /// Under control. The stream exists between `start` and `stop`, and must be dropped before the
    /// connection.
    Connected { stream: Option<FrameStream>, connection: Connection },
    /// Lost while streaming.
    Lost { since: Instant, next_attempt: Instant },
    /// Lost for longer than the patience, or stopped while lost.
    GivenUp,
}

impl GigeCamera {
    /// Opens a camera; see [`super::open`].
    pub(super) fn open(
        name: &str,
        settings: &CameraSettings,
        size: ImageSize,
    ) -> Result<Self, DeviceError> {
        let connection = Connection::open(name, settings, size, Exposing::Triggered)?;
        Ok(Self::new(name, settings, size, Exposing::Triggered, connection))
    }

    /// Borrows a camera; see [`super::open_free_running`].
    pub(super) fn borrow(
        name: &str,
        settings: &CameraSettings,
        size: ImageSize,
    ) -> Result<Self, DeviceError> {
        let connection = Connection::control(name, settings)?;
        let as_found = AsFound::read(&Features { device: name, camera: &connection.camera });
        let mut camera = Self::new(name, settings, size, Exposing::Freely, connection);
        // From here on, what happens to this object gives the camera back.
        camera.as_found = Some(as_found);
        if let Link::Connected { connection, .. } = &camera.link {
            connection.apply(name, settings, size, Exposing::Freely)?;
        }
        Ok(camera)
    }

    fn new(
        name: &str,
        settings: &CameraSettings,
        size: ImageSize,
        exposing: Exposing,
        connection: Connection,
    ) -> Self {
        Self {
            name: name.to_owned(),
            settings: settings.clone(),
            size,
            images: ImagePool::new(size.columns, size.rows, settings.buffers as usize),
            link: Link::Connected { stream: None, connection },
            ids: FrameIds::starting_at(0),
            earlier: StreamStatistics::default(),
            exposing,
            as_found: None,
        }
    }

    fn refusal(&self, detail: &str) -> DeviceError {
        DeviceError::Refused { device: self.name.clone(), detail: detail.to_owned() }
    }

    /// Converts a frame; `None` if it has no valid number.
    fn frame(&mut self, received: Received) -> Option<Frame> {
        let Some(frame_id) = self.ids.number(received.counter) else {
            tracing::warn!(
                camera = self.name,
                counter = received.counter,
                "damaged frame dropped: the packet with its id was lost, or it is older than the \
                 stream"
            );
            return None;
        };
        Some(Frame {
            image: received.image,
            frame_id,
            device_timestamp_ns: received.device_timestamp_ns,
            host_timestamp_ns: received.host_timestamp_ns,
            status: received.status,
        })
    }

    /// Ends the stream, if there is one, and keeps its counters.
    fn end_stream(&mut self) {
        if let Link::Connected { stream, .. } = &mut self.link
            && let Some(stream) = stream.take()
        {
            self.earlier = sum(self.earlier, stream.statistics());
        }
    }

    /// Handles a lost connection.
    fn handle_loss(&mut self) {
        self.end_stream();
        tracing::warn!(
            camera = self.name,
            "connection lost: searching for it for up to {} s",
            self.settings.reconnect_patience_s
        );
        let now = Instant::now();
        self.link = Link::Lost { since: now, next_attempt: now };
    }

    /// Attempts to reconnect once, or waits until the next attempt is due.
    fn try_reconnect(
        &mut self,
        since: Instant,
        next_attempt: Instant,
        timeout: Duration,
    ) -> Result<(), DeviceError> {
        let wait = next_attempt.saturating_duration_since(Instant::now());
        if !wait.is_zero() {
            sleep(wait.min(timeout));
            return Ok(());
        }
        let failure = match self.connect_and_stream() {
            Ok(link) => {
                self.link = link;
                self.ids.resume(u64::from(self.settings.frames_per_trigger));
                self.earlier.reconnects += 1;
                tracing::warn!(
                    camera = self.name,
                    "back after {:.1} s: settings applied again, frames continue with number {}",
                    since.elapsed().as_secs_f64(),
                    self.ids.next()
                );
                return Ok(());
            }
            Err(failure) => failure,
        };
        tracing::debug!(camera = self.name, %failure, "still away");
        if since.elapsed().as_secs_f64() < self.settings.reconnect_patience_s {
            let next_attempt = Instant::now() + RECONNECT_RETRY;
            self.link = Link::Lost { since, next_attempt };
            return Ok(());
        }
        self.link = Link::GivenUp;
        Err(DeviceError::Lost {
            device: self.name.clone(),
            detail: format!(
                "lost {:.0} s ago and not back since ({failure}): check its power and cable",
                since.elapsed().as_secs_f64()
            ),
        })
    }

    fn connect_and_stream(&self) -> Result<Link, DeviceError> {
        // The camera may still believe in our old control; waiting for that is part of the
        // reconnect patience.
        let settings = CameraSettings { control_patience_s: 0.0, ..self.settings.clone() };
        let connection = Connection::open(&self.name, &settings, self.size, self.exposing)?;
        let stream = FrameStream::start(&self.name, &connection, &settings, self.size)?;
        Ok(Link::Connected { stream: Some(stream), connection })
    }
}

impl Camera for GigeCamera {
    fn name(&self) -> &str {
        &self.name
    }

    fn start(&mut self) -> Result<(), DeviceError> {
        let vanished = match &self.link {
            Link::Connected { connection, stream: None } => connection.is_lost(),
            Link::GivenUp => true,
            _ => return Err(self.refusal("it is already started")),
        };
        if vanished {
            // The old Aravis objects must be dropped before new ones are created.
            self.link = Link::GivenUp;
            let connection =
                Connection::open(&self.name, &self.settings, self.size, self.exposing)?;
            self.link = Link::Connected { stream: None, connection };
        }
        if let Link::Connected { stream, connection } = &mut self.link {
            *stream = Some(FrameStream::start(&self.name, connection, &self.settings, self.size)?);
        }
        self.ids = FrameIds::starting_at(0);
        self.earlier = StreamStatistics::default();
        Ok(())
    }

    fn next_frame(&mut self, timeout: Duration) -> Result<Option<Frame>, DeviceError> {
        match &mut self.link {
            Link::Connected { stream: Some(stream), connection } => {
                if let Some(received) = stream.next(&self.images, timeout) {
                    return Ok(self.frame(received));
                }
                // Frames that arrived before the loss are delivered first.
                if connection.is_lost() {
                    self.handle_loss();
                }
            }
            Link::Lost { since, next_attempt } => {
                let (since, next_attempt) = (*since, *next_attempt);
                self.try_reconnect(since, next_attempt, timeout)?;
            }
            Link::Connected { stream: None, .. } | Link::GivenUp => {
                return Err(self.refusal("it is not started"));
            }
        }
        Ok(None)
    }

    fn stop(&mut self) -> Result<(), DeviceError> {
        let stopped = match &self.link {
            Link::Connected { stream: Some(_), connection } if !connection.is_lost() => {
                let features = Features { device: &self.name, camera: &connection.camera };
                features.stop()
            }
            _ => Ok(()),
        };
        self.end_stream();
        if matches!(self.link, Link::Lost { .. }) {
            self.link = Link::GivenUp;
        }
        stopped
    }

    fn statistics(&self) -> StreamStatistics {
        match &self.link {
            Link::Connected { stream: Some(stream), .. } => sum(self.earlier, stream.statistics()),
            _ => self.earlier,
        }
    }

    fn is_connected(&self) -> bool {
        matches!(&self.link, Link::Connected { connection, .. } if !connection.is_lost())
    }

    fn loss_detection_time(&self) -> Duration {
        LOSS_DETECTION_TIME
    }
}

impl Drop for GigeCamera {
    fn drop(&mut self) {
        let stopped = self.stop();
        if let Err(error) = &stopped {
            tracing::warn!(camera = self.name, %error, "could not be stopped");
        }
        let Some(as_found) = &self.as_found else { return };
        match &self.link {
            // One that does not answer would be asked for minutes.
            Link::Connected { connection, .. } if stopped.is_ok() && !connection.is_lost() => {
                as_found.give_back(&Features { device: &self.name, camera: &connection.camera });
            }
            _ => tracing::warn!(
                camera = self.name,
                "connection lost, so its settings are not restored; a run sets its own"
            ),
        }
    }
}

fn sum(a: StreamStatistics, b: StreamStatistics) -> StreamStatistics {
    StreamStatistics {
        completed: a.completed + b.completed,
        failed: a.failed + b.failed,
        underruns: a.underruns + b.underruns,
        resent: a.resent + b.resent,
        missing: a.missing + b.missing,
        reconnects: a.reconnects + b.reconnects,
    }
}
