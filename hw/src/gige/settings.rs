//! Settings of a GigE Vision camera.

use std::net::Ipv4Addr;

use garde::Validate;
use serde::{Deserialize, Serialize};

use super::PixelFormat;
use crate::{Sensor, check::finite};

/// How a camera is found, configured and streamed. GenICam features have their SFNC names.
///
/// Given values are written to the camera and read back; absent ones keep the camera's value.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct CameraSettings {
    /// Address; either this or `serial`.
    #[garde(custom(one_way_to_find_it(&self.serial)))]
    pub ip: Option<Ipv4Addr>,
    /// Serial number; either this or `ip`. Needs discovery, so the camera must be on the same subnet.
    #[garde(inner(length(min = 1, max = 16)))]
    pub serial: Option<String>,
    /// Pixel format.
    #[garde(skip)]
    pub pixel_format: PixelFormat,
    /// Column and row of the sensor where the image starts. The image has the size of the configured
    /// sensor; without this setting the camera's sensor must have exactly that size.
    #[garde(skip)]
    pub offset_px: Option<[u32; 2]>,
    /// Exposure time, in µs: that of the first of a double exposure. The second lasts as long as the
    /// readout.
    #[garde(inner(custom(finite), range(min = 1.0, max = 1e7)))]
    pub exposure_us: Option<f64>,
    /// Analogue gain, in dB.
    #[garde(inner(custom(finite), range(min = -20.0, max = 60.0)))]
    pub gain_db: Option<f64>,
    /// Largest packet including the IP header, in bytes: at most the network's MTU.
    #[garde(range(min = 576, max = 65_535))]
    pub packet_size_bytes: u32,
    /// Pause between packets, in ns, so that two cameras can share a link.
    #[garde(range(max = 10_000_000))]
    pub inter_packet_delay_ns: u64,
    /// Input of the synchroniser's trigger.
    #[garde(length(min = 1, max = 32))]
    pub trigger_line: String,
    /// The triggering edge.
    #[garde(skip)]
    pub trigger_activation: Option<TriggerActivation>,
    /// Frames per trigger: 2 for double exposure.
    #[garde(range(min = 1, max = 2))]
    pub frames_per_trigger: u32,
    /// Additional features as `Name=value Name=value`, set before all others: for cameras with a
    /// vendor-specific double exposure.
    #[garde(length(max = 1000))]
    pub features: String,
    /// Synchronises the camera's clock with the network (IEEE 1588).
    #[garde(skip)]
    pub ptp: bool,
    /// Number of frame buffers in the host.
    #[garde(range(min = 2, max = 1000))]
    pub buffers: u32,
    /// Requested receive buffer of the socket, in bytes; limited by `net.core.rmem_max`.
    #[garde(range(min = 65_536, max = 1_073_741_824))]
    pub socket_buffer_bytes: u32,
    /// Receives packets from the network interface instead of a socket: more efficient, but needs the
    /// capability `cap_net_raw` and packets no larger than the MTU.
    #[garde(skip)]
    pub packet_socket: bool,
    /// Silence after which missing packets are requested again, in µs.
    #[garde(range(min = 100, max = 10_000_000))]
    pub packet_timeout_us: u32,
    /// Silence after which an incomplete frame is dropped, in µs.
    #[garde(range(min = 1000, max = 60_000_000))]
    pub frame_retention_us: u32,
    /// How long to wait, in s, while another program controls the camera. After a crash the camera
    /// stays controlled until its heartbeat times out, usually for 3 s.
    #[garde(custom(finite), range(min = 0.0, max = 600.0))]
    pub control_patience_s: f64,
    /// How long to wait for a lost camera, in s, before the run ends.
    #[garde(custom(finite), range(min = 0.0, max = 86_400.0))]
    pub reconnect_patience_s: f64,
}

impl Default for CameraSettings {
    /// Without an address: `ip` or `serial` must be set.
    fn default() -> Self {
        Self {
            ip: None,
            serial: None,
            pixel_format: PixelFormat::Mono12Packed,
            offset_px: None,
            exposure_us: None,
            gain_db: None,
            packet_size_bytes: 1500,
            inter_packet_delay_ns: 0,
            trigger_line: "Line1".into(),
            trigger_activation: None,
            frames_per_trigger: 2,
            features: String::new(),
            ptp: false,
            buffers: 32,
            socket_buffer_bytes: 8 << 20,
            packet_socket: false,
            packet_timeout_us: 20_000,
            frame_retention_us: 200_000,
            control_patience_s: 10.0,
            reconnect_patience_s: 60.0,
        }
    }
}

/// The edge of the trigger pulse that starts an exposure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum TriggerActivation {
    /// Low to high.
    RisingEdge,
    /// High to low.
    FallingEdge,
}

impl TriggerActivation {
    /// GenICam name.
    pub fn name(self) -> &'static str {
        match self {
            Self::RisingEdge => "RisingEdge",
            Self::FallingEdge => "FallingEdge",
        }
    }
}

/// Expected image size according to the optics, in pixels.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ImageSize {
    /// Pixel columns.
    pub columns: usize,
    /// Pixel rows.
    pub rows: usize,
}

impl ImageSize {
    /// Number of pixels.
    pub fn pixels(self) -> usize {
        self.columns * self.rows
    }
}

impl From<&Sensor> for ImageSize {
    fn from(sensor: &Sensor) -> Self {
        Self { columns: sensor.columns, rows: sensor.rows }
    }
}

fn one_way_to_find_it(
    serial: &Option<String>,
) -> impl FnOnce(&Option<Ipv4Addr>, &()) -> garde::Result + '_ {
    move |ip, _| match (ip, serial) {
        (Some(_), None) | (None, Some(_)) => Ok(()),
        (None, None) => Err(garde::Error::new("needed: the camera's ip or its serial")),
        (Some(_), Some(_)) => {
            Err(garde::Error::new("allowed: ip or serial, not both, because they might disagree"))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn problem(toml: &str) -> String {
        let settings: CameraSettings = toml::from_str(toml).unwrap();
        settings.validate().err().map_or(String::new(), |report| report.to_string())
    }

    #[test]
    fn an_address_is_enough() {
        assert_eq!(problem("ip = '192.168.10.11'"), "");
        assert_eq!(problem("serial = '23456'\npixel_format = 'Mono8'"), "");
    }

    #[test]
    fn exactly_one_address() {
        assert!(problem("ptp = true").contains("needed: the camera's ip or its serial"));
        assert!(problem("ip = '10.0.0.1'\nserial = '1'").contains("not both"));
        assert!(problem("serial = ''").contains("serial"));
    }

    #[test]
    fn values_out_of_range_are_refused_by_name() {
        for (line, name) in [
            ("exposure_us = nan", "exposure_us"),
            ("exposure_us = 0.0", "exposure_us"),
            ("gain_db = inf", "gain_db"),
            ("packet_size_bytes = 100", "packet_size_bytes"),
            ("packet_size_bytes = 65536", "packet_size_bytes"),
            ("frames_per_trigger = 3", "frames_per_trigger"),
            ("buffers = 1", "buffers"),
            ("reconnect_patience_s = -1.0", "reconnect_patience_s"),
            ("trigger_line = ''", "trigger_line"),
        ] {
            let words = problem(&format!("ip = '10.0.0.1'\n{line}"));
            assert!(words.contains(name), "{line}: {words}");
        }
    }

    #[test]
    fn unknown_keys_and_formats_are_refused() {
        for text in ["exposure_ms = 1.0", "pixel_format = 'RGB8'", "ip = 'camera-1'"] {
            assert!(toml::from_str::<CameraSettings>(text).is_err(), "{text}");
        }
    }
}
