//! Data rates and memory that the configured bench needs.

use lfpiv_hw::gige::PixelFormat;

use crate::config::Config;

/// Packet headers add one per cent to the data.
const PACKET_OVERHEAD: f64 = 1.01;

/// Data that a bench produces.
#[derive(Debug, Clone, PartialEq)]
pub struct Need {
    /// Bytes of one frame of each camera, as sent.
    pub frame_bytes: Vec<usize>,
    /// Shots per second.
    pub rate_hz: f64,
    /// Pixels per frame.
    pub pixels: usize,
    /// Shots that may be in memory: queued or in process.
    pub shots_in_memory: usize,
}

impl Need {
    /// The need of this configuration. Pixels of a simulated camera are stored in 12 bits.
    pub fn of(config: &Config) -> Self {
        let pixels = config.optics.sensor.columns * config.optics.sensor.rows;
        let formats = match &config.instruments {
            Some(instruments) => instruments.camera.iter().map(|c| c.pixel_format).collect(),
            None => vec![PixelFormat::Mono12Packed; config.camera.len()],
        };
        Self {
            frame_bytes: formats.iter().map(|format| format.payload_bytes(pixels)).collect(),
            rate_hz: config.shot.rate_hz,
            pixels,
            shots_in_memory: config.pipeline.queue + cores(),
        }
    }

    /// Bytes of both frames of every camera.
    pub fn shot_bytes(&self) -> f64 {
        2.0 * self.frame_bytes.iter().sum::<usize>() as f64
    }

    /// Bytes per second written to disk.
    pub fn bytes_per_s(&self) -> f64 {
        self.shot_bytes() * self.rate_hz
    }

    /// Bytes per second on the line shared by these cameras.
    pub fn line_bytes_per_s(&self, cameras: &[usize]) -> f64 {
        let frames = cameras.iter().filter_map(|camera| self.frame_bytes.get(*camera));
        2.0 * frames.sum::<usize>() as f64 * self.rate_hz * PACKET_OVERHEAD
    }

    /// Memory of the frames that may wait, unpacked to 16 bits, in bytes.
    pub fn waiting_bytes(&self) -> f64 {
        let frames = 2 * self.frame_bytes.len() * self.shots_in_memory;
        (frames * self.pixels * size_of::<u16>()) as f64
    }
}

/// Formats bytes in MB.
pub fn mb(bytes: f64) -> String {
    format!("{:.0} MB", bytes / 1e6)
}

/// Processors that this process may use.
pub fn cores() -> usize {
    std::thread::available_parallelism().map_or(1, usize::from)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shot_has_two_packed_frames_per_camera() {
        let need = Need { frame_bytes: vec![6, 8], rate_hz: 10.0, pixels: 4, shots_in_memory: 3 };
        assert_eq!((need.shot_bytes(), need.bytes_per_s()), (28.0, 280.0));
        assert!((need.line_bytes_per_s(&[1]) - 161.6).abs() < 1e-9);
        assert_eq!(need.waiting_bytes(), 96.0);
    }
}
