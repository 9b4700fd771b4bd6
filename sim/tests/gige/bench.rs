//! Cameras, pictures and drivers that the tests share.

use std::{
    io::{self, Write},
    net::Ipv4Addr,
    sync::{Arc, Mutex},
    time::{Duration, Instant},
};

use lfpiv_hw::{
    RawImage,
    device::{Camera, DeviceError, Frame},
    gige::{CameraSettings, ImageSize, PixelFormat, open},
};
use lfpiv_sim::wire::camera::FakeGigeCamera;

pub const FIRST: Ipv4Addr = Ipv4Addr::new(127, 0, 0, 1);
pub const SECOND: Ipv4Addr = Ipv4Addr::new(127, 0, 0, 2);

/// Longer than anything takes that is going to happen, on a busy machine too.
pub const LONG: Duration = Duration::from_secs(60);

pub const SIZE: ImageSize = ImageSize { columns: 384, rows: 312 };

pub fn fake(address: Ipv4Addr, serial: &str, size: ImageSize) -> FakeGigeCamera {
    FakeGigeCamera::start(address, serial, size, 12).unwrap()
}

/// Settings for the loopback, whose packets may be large.
pub fn settings(ip: Ipv4Addr, pixel_format: PixelFormat) -> CameraSettings {
    CameraSettings {
        ip: Some(ip),
        pixel_format,
        packet_size_bytes: 16_000,
        // The loopback delivers a frame at once, where a line takes its time.
        socket_buffer_bytes: 32 << 20,
        frames_per_trigger: 1,
        // A thread may be kept off the processor for long while others build and test.
        packet_timeout_us: 200_000,
        frame_retention_us: 2_000_000,
        ..CameraSettings::default()
    }
}

pub fn connect(settings: &CameraSettings, size: ImageSize) -> Box<dyn Camera> {
    open("cam1", settings, size).unwrap()
}

pub fn error_of(opened: Result<Box<dyn Camera>, DeviceError>) -> DeviceError {
    opened.err().expect("a camera where an error should be")
}

/// A picture of 12-bit counts that no other number has: every row tells number and place.
pub fn picture(size: ImageSize, number: u64) -> Arc<RawImage> {
    let counts = (0..size.pixels() as u64).map(|pixel| {
        let mixed = (pixel + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15 ^ (number << 17 | number));
        (mixed >> 40 & 0xfff) as u16
    });
    Arc::new(RawImage::new(size.columns, size.rows, counts.collect()).unwrap())
}

/// What a picture's counts become in a pixel format.
pub fn as_sent(image: &RawImage, format: PixelFormat) -> Vec<u16> {
    let shift = 12 - format.significant_bits().min(12);
    image.counts().iter().map(|count| count >> shift).collect()
}

/// The next frame, waited for.
pub fn frame(camera: &mut dyn Camera) -> Frame {
    wait_for(|| camera.next_frame(Duration::from_millis(50)).unwrap())
}

/// What comes of asking again and again.
pub fn wait_for<T>(mut ask: impl FnMut() -> Option<T>) -> T {
    let asked = Instant::now();
    loop {
        if let Some(answer) = ask() {
            return answer;
        }
        assert!(asked.elapsed() < LONG, "waited {LONG:?} in vain");
    }
}

/// Everything that is logged in this process from now on.
#[derive(Clone, Default)]
pub struct Log(Arc<Mutex<Vec<u8>>>);

impl Log {
    pub fn begin() -> Self {
        let log = Self::default();
        let writer = log.clone();
        tracing_subscriber::fmt().with_ansi(false).with_writer(move || writer.clone()).init();
        log
    }

    pub fn says(&self, words: &str) -> bool {
        String::from_utf8_lossy(&self.0.lock().unwrap()).contains(words)
    }
}

impl Write for Log {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        io::stderr().write_all(bytes)?;
        self.0.lock().unwrap().write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}
