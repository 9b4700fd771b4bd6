//! The camera driver on top of Aravis.
//!
//! A camera that vanishes (cable, power, control lost) is looked for inside the driver, so that
//! the thread that reads it goes on: [`Camera::next_frame`] answers `None` meanwhile,
//! [`Camera::is_connected`] says `false`, and after the settings' patience it is
//! [`DeviceError::Lost`]. When it returns, Aravis' objects are made anew and every setting is
//! applied and read back again. Frame numbers then go on with the first frame of a new trigger:
//! how many triggers the camera missed only its clock can tell, and only if it kept running.
//!
//! A damaged frame whose leader packet was lost has no id, and is counted as failed but not
//! delivered. Frames are numbered from the first of which any packet arrives. A first frame that is lost
//! whole shifts the numbers by one, which its timestamps show to whoever pairs frames.

mod apply;
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

use connection::Connection;
pub(super) use connection::list_devices;
use stream::{FrameStream, Received};

/// Control counts as lost once several heartbeats have not been answered: 11 s were seen.
const NOTICES_ABSENCE_WITHIN: Duration = Duration::from_secs(20);
/// Pause after a failed attempt to find a vanished camera.
const RECONNECT_RETRY: Duration = Duration::from_millis(500);

/// A GigE Vision camera.
pub(super) struct GigeCamera {
    name: String,
    settings: CameraSettings,
    size: ImageSize,
    images: ImagePool,
    link: Link,
    ids: FrameIds,
    /// What earlier streams since `start` counted.
    earlier: StreamStatistics,
}

/// How things stand with the camera.
enum Link {
    /// Under control. The stream is there between `start` and `stop`; it ends before the
    /// connection does.
    Up { stream: Option<FrameStream>, connection: Connection },
    /// It vanished while streaming.
    Away { since: Instant, next_attempt: Instant },
    /// It vanished, and the patience with it has run out, or it was stopped meanwhile.
    Gone,
}

impl GigeCamera {
    /// Opens a camera; see [`super::open`].
    pub(super) fn open(
        name: &str,
        settings: &CameraSettings,
        size: ImageSize,
    ) -> Result<Self, DeviceError> {
        let connection = Connection::open(name, settings, size)?;
        Ok(Self {
            name: name.to_owned(),
            settings: settings.clone(),
            size,
            images: ImagePool::new(size.columns, size.rows, settings.buffers as usize),
            link: Link::Up { stream: None, connection },
            ids: FrameIds::starting_at(0),
            earlier: StreamStatistics::default(),
        })
    }

    fn refusal(&self, detail: &str) -> DeviceError {
        DeviceError::Refused { device: self.name.clone(), detail: detail.to_owned() }
    }

    /// A frame as the daemon knows it; `None` when its number is none.
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

    /// Ends the stream, if there is one, and keeps its counts.
    fn end_stream(&mut self) {
        if let Link::Up { stream, .. } = &mut self.link
            && let Some(stream) = stream.take()
        {
            self.earlier = sum(self.earlier, stream.statistics());
        }
    }

    /// The camera no longer answers.
    fn leave(&mut self) {
        self.end_stream();
        tracing::warn!(
            camera = self.name,
            "connection lost: looking for it for up to {} s",
            self.settings.reconnect_patience_s
        );
        let now = Instant::now();
        self.link = Link::Away { since: now, next_attempt: now };
    }

    /// Looks for the vanished camera once, or waits until the next look is due.
    fn look_for_it(
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
                    "back after {:.1} s: settings applied again, frames go on with number {}",
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
            self.link = Link::Away { since, next_attempt };
            return Ok(());
        }
        self.link = Link::Gone;
        Err(DeviceError::Lost {
            device: self.name.clone(),
            detail: format!(
                "vanished {:.0} s ago and did not come back ({failure}): check its power and cable",
                since.elapsed().as_secs_f64()
            ),
        })
    }

    fn connect_and_stream(&self) -> Result<Link, DeviceError> {
        // Its own old control may have to time out; that is part of the patience with it.
        let settings = CameraSettings { control_patience_s: 0.0, ..self.settings.clone() };
        let connection = Connection::open(&self.name, &settings, self.size)?;
        let stream = FrameStream::start(&self.name, &connection, &settings, self.size)?;
        Ok(Link::Up { stream: Some(stream), connection })
    }
}

impl Camera for GigeCamera {
    fn name(&self) -> &str {
        &self.name
    }

    fn start(&mut self) -> Result<(), DeviceError> {
        let vanished = match &self.link {
            Link::Up { connection, stream: None } => connection.is_lost(),
            Link::Gone => true,
            _ => return Err(self.refusal("it is started already")),
        };
        if vanished {
            // Aravis' objects for it must be gone before new ones are made.
            self.link = Link::Gone;
            let connection = Connection::open(&self.name, &self.settings, self.size)?;
            self.link = Link::Up { stream: None, connection };
        }
        if let Link::Up { stream, connection } = &mut self.link {
            *stream = Some(FrameStream::start(&self.name, connection, &self.settings, self.size)?);
        }
        self.ids = FrameIds::starting_at(0);
        self.earlier = StreamStatistics::default();
        Ok(())
    }

    fn next_frame(&mut self, timeout: Duration) -> Result<Option<Frame>, DeviceError> {
        match &mut self.link {
            Link::Up { stream: Some(stream), connection } => {
                if let Some(received) = stream.next(&self.images, timeout) {
                    return Ok(self.frame(received));
                }
                // Frames that arrived before the loss are delivered first.
                if connection.is_lost() {
                    self.leave();
                }
            }
            Link::Away { since, next_attempt } => {
                let (since, next_attempt) = (*since, *next_attempt);
                self.look_for_it(since, next_attempt, timeout)?;
            }
            Link::Up { stream: None, .. } | Link::Gone => {
                return Err(self.refusal("it is not started"));
            }
        }
        Ok(None)
    }

    fn stop(&mut self) -> Result<(), DeviceError> {
        let stopped = match &self.link {
            Link::Up { stream: Some(_), connection } if !connection.is_lost() => {
                let features =
                    features::Features { device: &self.name, camera: &connection.camera };
                features.stop()
            }
            _ => Ok(()),
        };
        self.end_stream();
        if matches!(self.link, Link::Away { .. }) {
            self.link = Link::Gone;
        }
        stopped
    }

    fn statistics(&self) -> StreamStatistics {
        match &self.link {
            Link::Up { stream: Some(stream), .. } => sum(self.earlier, stream.statistics()),
            _ => self.earlier,
        }
    }

    fn is_connected(&self) -> bool {
        matches!(&self.link, Link::Up { connection, .. } if !connection.is_lost())
    }

    fn loss_detection_time(&self) -> Duration {
        NOTICES_ABSENCE_WITHIN
    }
}

impl Drop for GigeCamera {
    fn drop(&mut self) {
        if let Err(error) = self.stop() {
            tracing::warn!(camera = self.name, %error, "could not be stopped");
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
