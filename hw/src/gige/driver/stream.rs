//! A stream of frames: converts Aravis' buffers to images with a single copy.

use std::time::Duration;

use aravis::{Buffer, BufferStatus, GvStream, Stream, glib::prelude::*, prelude::*};

use super::{connection::Connection, features::Features, priority::create_stream, receive_buffer};
use crate::{
    device::{DeviceError, FrameStatus, StreamStatistics},
    frame::{ImagePool, RawImage},
    gige::{CameraSettings, ImageSize, PixelFormat},
};

/// No frame has this id.
const NO_FRAME_ID: u64 = 0;

/// A running stream. Aravis fills its buffers on a thread of its own; every buffer taken is returned.
pub(super) struct FrameStream {
    stream: GvStream,
    format: PixelFormat,
    size: ImageSize,
    /// Frames that Aravis reports as successful although they are incomplete.
    incomplete: u64,
}

/// Contents of a buffer.
pub(super) struct Received {
    pub(super) image: RawImage,
    pub(super) status: FrameStatus,
    /// The camera's frame counter, 16 bits unless it has extended ids; 0 if the leader packet was lost.
    pub(super) counter: u64,
    pub(super) device_timestamp_ns: u64,
    pub(super) host_timestamp_ns: u64,
}

impl FrameStream {
    /// Creates buffers and starts acquisition.
    pub(super) fn start(
        name: &str,
        connection: &Connection,
        settings: &CameraSettings,
        size: ImageSize,
    ) -> Result<Self, DeviceError> {
        let camera = &connection.camera;
        let features = Features { device: name, camera };
        // Without this, a stream may deliver nothing if another one preceded it.
        features.stop()?;
        let options = match settings.packet_socket {
            true => aravis::GvStreamOption::NONE,
            false => aravis::GvStreamOption::PACKET_SOCKET_DISABLED,
        };
        camera.gv_set_stream_options(options);
        let stream: Stream = features.check("stream", create_stream(camera))?;
        let stream = stream
            .downcast::<GvStream>()
            .map_err(|_| features.refusal("its stream is not GigE Vision's".to_owned()))?;
        enlarge_receive_buffer(name, &stream, settings);
        stream.set_packet_resend(aravis::GvStreamPacketResend::Always);
        stream.set_packet_timeout(settings.packet_timeout_us);
        stream.set_frame_retention(settings.frame_retention_us);
        let payload = settings.pixel_format.payload_bytes(size.pixels());
        for _ in 0..settings.buffers {
            return_buffer(&stream, Buffer::new_allocate(payload));
        }
        features.check("start", camera.start_acquisition())?;
        Ok(Self { stream, format: settings.pixel_format, size, incomplete: 0 })
    }

    /// The next frame, intact or damaged, or `None` on timeout.
    pub(super) fn next(&mut self, images: &ImagePool, timeout: Duration) -> Option<Received> {
        let timeout_us = u64::try_from(timeout.as_micros()).unwrap_or(u64::MAX);
        let buffer = self.stream.timeout_pop_buffer(timeout_us)?;
        let received = self.read(&buffer, images);
        return_buffer(&self.stream, buffer);
        received
    }

    /// `None` for a buffer returned unused by a stopping stream.
    fn read(&mut self, buffer: &Buffer, images: &ImagePool) -> Option<Received> {
        let status = match buffer.status() {
            BufferStatus::Cleared | BufferStatus::Aborted => return None,
            BufferStatus::Success if self.is_whole(buffer) => FrameStatus::Complete,
            BufferStatus::Success => {
                self.incomplete += 1;
                FrameStatus::MissingPackets
            }
            _ => FrameStatus::MissingPackets,
        };
        let image = match status {
            FrameStatus::Complete => {
                images.image(|counts| self.format.unpack(received_bytes(buffer), counts))
            }
            // Missing packets leave parts of an earlier frame in the buffer, at unknown places.
            FrameStatus::MissingPackets => images.image(|counts| counts.fill(0)),
        };
        Some(Received {
            image,
            status,
            counter: buffer.frame_id(),
            device_timestamp_ns: buffer.timestamp(),
            host_timestamp_ns: buffer.system_timestamp(),
        })
    }

    /// Whether every byte of the expected image arrived: `Success` was seen with a sixth of them.
    fn is_whole(&self, buffer: &Buffer) -> bool {
        received_bytes(buffer).len() == self.format.payload_bytes(self.size.pixels())
            && buffer.image_pixel_format().raw() == self.format.code()
            && usize::try_from(buffer.image_width()) == Ok(self.size.columns)
            && usize::try_from(buffer.image_height()) == Ok(self.size.rows)
    }

    /// Counters since the start of the stream.
    pub(super) fn statistics(&self) -> StreamStatistics {
        let (completed, failed, underruns) = StreamExt::statistics(&self.stream);
        let (resent, missing) = self.stream.statistics();
        StreamStatistics {
            completed: completed.saturating_sub(self.incomplete),
            failed: failed + self.incomplete,
            underruns,
            resent,
            missing,
            reconnects: 0,
        }
    }
}

/// Returns a buffer to Aravis, with its frame id cleared. The id comes with the leader packet: if that
/// is lost, the buffer would show the id of an earlier frame.
fn return_buffer(stream: &GvStream, buffer: Buffer) {
    buffer.set_frame_id(NO_FRAME_ID);
    stream.push_buffer(buffer);
}

/// Enlarges the receive buffer. A small one loses packets silently, so a warning says what to do.
fn enlarge_receive_buffer(name: &str, stream: &GvStream, settings: &CameraSettings) {
    let wanted = settings.socket_buffer_bytes as usize;
    match receive_buffer::enlarge(stream.port(), wanted) {
        Ok(granted) if granted >= wanted => {}
        Ok(granted) => tracing::warn!(
            camera = name,
            "receive buffer of {granted} bytes instead of {wanted}: packets may get lost. Allow \
             more: sysctl -w net.core.rmem_max={wanted}"
        ),
        Err(error) => {
            tracing::warn!(
                camera = name,
                %error,
                "cannot set the receive buffer; Aravis enlarges it during the first frame"
            );
            stream.set_socket_buffer(aravis::GvStreamSocketBuffer::Fixed);
            stream.set_socket_buffer_size(settings.socket_buffer_bytes as i32);
        }
    }
}

/// The received bytes.
#[allow(unsafe_code)]
fn received_bytes(buffer: &Buffer) -> &[u8] {
    let (data, length) = buffer.data();
    if data.is_null() || length == 0 {
        return &[];
    }
    // SAFETY: Aravis reports its own allocation and the number of received bytes, which is at most the
    // allocated size. A popped buffer belongs to us: the stream's thread does not access it until it is
    // pushed again, which consumes the buffer and ends this borrow.
    unsafe { std::slice::from_raw_parts(data, length) }
}
