//! A list of delivered frames, to compare with the frames that were sent.

use std::{
    fs::File,
    io::{self, LineWriter, Write},
    path::{Path, PathBuf},
    time::Duration,
};

use crate::device::{Camera, DeviceError, Frame, FrameStatus, StreamStatistics};

/// Column names.
const HEADER: &str = "camera,frame_id,device_timestamp_ns,host_timestamp_ns,status,crc32";

/// A camera wrapper that lists each delivered frame in a file, as one line of comma-separated values.
pub struct RecordedCamera {
    inner: Box<dyn Camera>,
    file: LineWriter<File>,
    path: PathBuf,
}

impl RecordedCamera {
    /// Lists the frames of `inner` in a new file.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn new(inner: Box<dyn Camera>, path: &Path) -> io::Result<Self> {
        let mut file = LineWriter::new(File::create(path)?);
        writeln!(file, "{HEADER}")?;
        Ok(Self { inner, file, path: path.to_owned() })
    }

    fn list(&mut self, frame: &Frame) -> Result<(), DeviceError> {
        let status = match frame.status {
            FrameStatus::Complete => "complete",
            FrameStatus::MissingPackets => "missing packets",
        };
        let Frame { frame_id, device_timestamp_ns, host_timestamp_ns, image, .. } = frame;
        let (name, crc32) = (self.inner.name(), image.crc32());
        writeln!(
            self.file,
            "{name},{frame_id},{device_timestamp_ns},{host_timestamp_ns},{status},{crc32:08x}"
        )
        .map_err(|error| DeviceError::Refused {
            device: name.to_owned(),
            detail: format!(
                "its frame record {} cannot be written: {error}; free space or remove \
                 instruments.frame_record",
                self.path.display()
            ),
        })
    }
}

impl Camera for RecordedCamera {
    fn name(&self) -> &str {
        self.inner.name()
    }

    fn start(&mut self) -> Result<(), DeviceError> {
        self.inner.start()
    }

    fn next_frame(&mut self, timeout: Duration) -> Result<Option<Frame>, DeviceError> {
        let frame = self.inner.next_frame(timeout)?;
        if let Some(frame) = &frame {
            self.list(frame)?;
        }
        Ok(frame)
    }

    fn stop(&mut self) -> Result<(), DeviceError> {
        self.inner.stop()
    }

    fn statistics(&self) -> StreamStatistics {
        self.inner.statistics()
    }

    fn is_connected(&self) -> bool {
        self.inner.is_connected()
    }

    fn loss_detection_time(&self) -> Duration {
        self.inner.loss_detection_time()
    }
}
