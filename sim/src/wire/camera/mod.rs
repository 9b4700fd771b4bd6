//! A simulated GigE Vision camera at a real network address: Aravis' in-process fake with our own
//! GenICam description, trigger line and images.
//!
//! ```text
//! synchroniser --expose--> FakeGigeCamera --GVSP--> driver
//!                               ^------------GVCP-----'
//! ```
//!
//! Differences from hardware: lost packets are not retransmitted (the fake has no resend), and a
//! trigger that comes before the last frames were sent waits, where a real camera would miss it. A
//! frame is sent in one burst instead of being spread over its transmission time.

mod callback;
mod feed;
mod pixels;

use std::{
    io::{self, Write},
    net::{Ipv4Addr, UdpSocket},
    sync::{Arc, Mutex, MutexGuard, PoisonError},
};

use lfpiv_hw::{
    RawImage,
    gige::{ImageSize, PixelFormat},
};
use thiserror::Error;

use callback::PoweredCamera;
use feed::Feed;

/// The GenICam description.
const GENICAM: &str = include_str!("genicam.xml");

/// UDP port of GigE Vision control.
const GVCP_PORT: u16 = 3956;

/// Value of Line1 in the GenICam description, to which the synchroniser is connected.
const WIRED_LINE: u32 = 1;

/// Default rate of the camera's line, in bytes/s: 2.5GBASE-T.
const LINE_BYTES_PER_S: f64 = 312.5e6;

/// Frame counter after power-on: shortly before its wrap, as in Aravis.
const FIRST_FRAME_ID: u16 = 65_400;

/// Registers of the fake that are accessed here; see `genicam.xml`.
mod register {
    /// 32-byte strings in discovery replies.
    pub(super) const VENDOR: u32 = 0x48;
    pub(super) const MODEL: u32 = 0x68;
    pub(super) const WIDTH: u32 = 0x100;
    pub(super) const HEIGHT: u32 = 0x104;
    pub(super) const SENSOR_HEIGHT: u32 = 0x118;
    pub(super) const SENSOR_WIDTH: u32 = 0x11c;
    pub(super) const ACQUISITION: u32 = 0x124;
    pub(super) const TRIGGER_MODE: u32 = 0x300;
    /// The fake's own trigger source, hidden from controllers.
    pub(super) const RELEASE_SOURCE: u32 = 0x304;
    /// 1 releases one frame.
    pub(super) const RELEASE_FRAME: u32 = 0x30c;
    pub(super) const TRIGGER_SOURCE: u32 = 0x400;
    pub(super) const BURST_FRAME_COUNT: u32 = 0x410;
}

/// Why a fake camera cannot be started.
#[derive(Debug, Error)]
pub enum FakeCameraError {
    /// The address is not local, or is in use.
    #[error(
        "fake camera {serial}: cannot listen at {address}:{GVCP_PORT}: is the address this \
         machine's (`ip addr add {address}/8 dev lo`), and is no other fake camera running?"
    )]
    Address { serial: String, address: Ipv4Addr, source: io::Error },
    /// The GenICam description could not be passed to Aravis.
    #[error("fake camera {serial}: its description cannot be written to a temporary file")]
    Description { serial: String, source: io::Error },
    /// Aravis did not start it.
    #[error(
        "fake camera {serial}: Aravis did not start it at {address}: is the address this machine's \
         (`ip addr add {address}/8 dev lo`)? ARV_DEBUG=all says more"
    )]
    NotStarted { serial: String, address: Ipv4Addr },
    /// The image does not have the sensor's size.
    #[error(
        "fake camera {serial}: picture of {columns} x {rows} pixels for a sensor of \
         {} x {}", sensor.columns, sensor.rows
    )]
    ImageSize { serial: String, columns: usize, rows: usize, sensor: ImageSize },
}

/// Why a trigger was ignored, as in hardware.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ignored {
    /// The camera is unplugged.
    Unplugged,
    /// No controller has started it.
    NotAcquiring,
    /// Its trigger mode is off.
    FreeRunning,
    /// It uses another line, or software triggers.
    OtherSource,
}

/// Whether a trigger produced a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Exposed {
    /// The frame was sent or is queued.
    Yes,
    /// The trigger was ignored.
    No(Ignored),
}

/// Number of exposures by fate: `exposures` is the sum of `sent`, `lost`, `ignored`, `abandoned`
/// and those held.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct FrameCounts {
    /// Trigger pulses.
    pub exposures: u64,
    /// Frames handed to the network with their image.
    pub sent: u64,
    /// Frames lost on purpose.
    pub lost: u64,
    /// Ignored trigger pulses.
    pub ignored: u64,
    /// Exposures held when the acquisition ended.
    pub abandoned: u64,
    /// Frames without a trigger: free run.
    pub untriggered: u64,
}

/// A camera on the network with simulated images.
pub struct FakeGigeCamera {
    address: Ipv4Addr,
    serial: String,
    sensor: ImageSize,
    count_bits: u32,
    state: Mutex<State>,
}

struct State {
    power: Option<PoweredCamera>,
    lost_packet_ratio: f64,
    line_bytes_per_s: f64,
    exact: bool,
    in_view: Option<Arc<RawImage>>,
    /// Counters from before the last power cycle.
    counts: FrameCounts,
}

impl FakeGigeCamera {
    /// Plugs a camera in. Its images have `count_bits` significant bits.
    ///
    /// # Errors
    /// The address is not available.
    pub fn start(
        address: Ipv4Addr,
        serial: &str,
        sensor: ImageSize,
        count_bits: u32,
    ) -> Result<Self, FakeCameraError> {
        let state = Mutex::new(State {
            power: None,
            lost_packet_ratio: 0.0,
            line_bytes_per_s: LINE_BYTES_PER_S,
            exact: false,
            in_view: None,
            counts: FrameCounts::default(),
        });
        let camera = Self { address, serial: serial.to_owned(), sensor, count_bits, state };
        camera.plug_in()?;
        Ok(camera)
    }

    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn feed(&self) -> Option<Arc<Feed>> {
        self.lock().power.as_ref().map(|camera| Arc::clone(camera.feed()))
    }

    /// One exposure: a trigger pulse arrives while the sensor sees `image`.
    ///
    /// Exactly one frame is sent, with this image, the camera's next frame id and the camera
    /// timestamp `device_timestamp_ns`, in the pixel format, region and packets that the controller
    /// chose. A camera that is not waiting for its trigger line ignores the pulse. If two exposures
    /// are already held, this waits until one has been sent.
    ///
    /// # Errors
    /// The image does not have the sensor's size.
    pub fn expose(
        &self,
        image: Arc<RawImage>,
        device_timestamp_ns: u64,
    ) -> Result<Exposed, FakeCameraError> {
        self.check_size(&image)?;
        let Some(feed) = self.feed() else { return Ok(self.unplugged()) };
        Ok(match feed.expose(image, device_timestamp_ns) {
            Ok(()) => Exposed::Yes,
            Err(reason) => Exposed::No(reason),
        })
    }

    /// What the sensor sees from now on when it runs freely; dark where that is never said.
    ///
    /// # Errors
    /// The image does not have the sensor's size.
    pub fn show(&self, image: Arc<RawImage>) -> Result<(), FakeCameraError> {
        self.check_size(&image)?;
        let mut state = self.lock();
        if let Some(camera) = &state.power {
            camera.feed().show(Arc::clone(&image));
        }
        state.in_view = Some(image);
        Ok(())
    }

    fn check_size(&self, image: &RawImage) -> Result<(), FakeCameraError> {
        let (columns, rows) = (image.columns(), image.rows());
        if (columns, rows) == (self.sensor.columns, self.sensor.rows) {
            return Ok(());
        }
        let (serial, sensor) = (self.serial.clone(), self.sensor);
        Err(FakeCameraError::ImageSize { serial, columns, rows, sensor })
    }

    /// One exposure whose frame is lost entirely: the camera counts it, and nothing arrives.
    /// Otherwise as [`Self::expose`].
    pub fn lose(&self) -> Exposed {
        let Some(feed) = self.feed() else { return self.unplugged() };
        match feed.lose() {
            Ok(()) => Exposed::Yes,
            Err(reason) => Exposed::No(reason),
        }
    }

    fn unplugged(&self) -> Exposed {
        let counts = &mut self.lock().counts;
        counts.exposures += 1;
        counts.ignored += 1;
        Exposed::No(Ignored::Unplugged)
    }

    /// Number of exposures by fate since the camera was created.
    pub fn counts(&self) -> FrameCounts {
        let state = self.lock();
        let now = state.power.as_ref().map(|camera| camera.feed().counts());
        sum(state.counts, now.unwrap_or_default())
    }

    /// The id of the last frame sent.
    pub fn last_frame_id(&self) -> u16 {
        self.feed().map_or(FIRST_FRAME_ID, |feed| feed.last_frame_id())
    }

    /// Drops this share of stream packets, 0 to 1, at random.
    pub fn set_lost_packet_ratio(&self, ratio: f64) {
        let mut state = self.lock();
        state.lost_packet_ratio = ratio.clamp(0.0, 1.0);
        if let Some(camera) = &state.power {
            camera.set_lost_packet_ratio(state.lost_packet_ratio);
        }
    }

    /// Rate of the camera's line in bytes/s, from the next time it is plugged in; faster frames
    /// wait. Default 312.5e6 (2.5GBASE-T); `f64::INFINITY` sends at the speed of the loopback,
    /// which is faster than a driver can receive. At least 1e6.
    pub fn set_line_rate(&self, bytes_per_s: f64) {
        self.lock().line_bytes_per_s = bytes_per_s.max(1e6);
    }

    /// From the next time it is plugged in: whether it offers only pixel formats that carry every
    /// bit of its counts. With smaller formats it sends the upper bits, as cameras do.
    pub fn set_exact(&self, exact: bool) {
        self.lock().exact = exact;
    }

    /// Pulls the cable, which also powers it: the camera disappears from the network and loses its
    /// settings, counter and held exposures.
    pub fn unplug(&self) {
        let mut state = self.lock();
        if let Some(camera) = state.power.take() {
            let feed = Arc::clone(camera.feed());
            drop(camera);
            feed.switch_off();
            state.counts = sum(state.counts, feed.counts());
        }
    }

    /// Plugs it in again, with the same address and serial number.
    ///
    /// # Errors
    /// The address is not available any more.
    pub fn plug_in(&self) -> Result<(), FakeCameraError> {
        let mut state = self.lock();
        if state.power.is_some() {
            return Ok(());
        }
        let camera = self.switch_on(state.line_bytes_per_s, state.exact)?;
        camera.set_lost_packet_ratio(state.lost_packet_ratio);
        if let Some(image) = &state.in_view {
            camera.feed().show(Arc::clone(image));
        }
        state.power = Some(camera);
        Ok(())
    }

    fn switch_on(
        &self,
        line_bytes_per_s: f64,
        exact: bool,
    ) -> Result<PoweredCamera, FakeCameraError> {
        let (serial, address) = (self.serial.clone(), self.address);
        // Aravis only warns if it cannot listen.
        if let Err(source) = UdpSocket::bind((address, GVCP_PORT)) {
            return Err(FakeCameraError::Address { serial, address, source });
        }
        let described = |source| FakeCameraError::Description { serial: serial.clone(), source };
        let mut file = tempfile::NamedTempFile::new().map_err(described)?;
        let description = if exact { self.exact_description() } else { GENICAM.to_owned() };
        file.write_all(description.as_bytes()).map_err(described)?;
        // The file is read only while the camera is being created.
        let device = aravis::GvFakeCamera::new_full(
            Some(&address.to_string()),
            Some(&serial),
            file.path().to_str(),
        );
        let registers = device.fake_camera().filter(|_| device.is_running());
        let Some(registers) = registers else {
            return Err(FakeCameraError::NotStarted { serial, address });
        };
        for (register, value) in self.power_on_values() {
            registers.write_register(register, value);
        }
        write_text(&registers, register::VENDOR, b"lfpiv");
        write_text(&registers, register::MODEL, b"simulated light field");
        let feed = Feed::new(registers, self.count_bits, line_bytes_per_s, FIRST_FRAME_ID);
        PoweredCamera::new(device, feed).ok_or(FakeCameraError::NotStarted { serial, address })
    }

    /// The GenICam description without pixel formats that would truncate counts.
    fn exact_description(&self) -> String {
        let narrow = PixelFormat::ALL
            .into_iter()
            .filter(|format| format.significant_bits() < self.count_bits)
            .map(|format| format!("<EnumEntry Name=\"{}\">", format.name()))
            .collect::<Vec<_>>();
        let offered = |line: &&str| !narrow.iter().any(|entry| line.contains(entry));
        GENICAM.lines().filter(offered).flat_map(|line| [line, "\n"]).collect()
    }

    fn power_on_values(&self) -> [(u32, u32); 6] {
        let [columns, rows] = [self.sensor.columns, self.sensor.rows].map(|pixels| pixels as u32);
        [
            (register::SENSOR_WIDTH, columns),
            (register::SENSOR_HEIGHT, rows),
            (register::WIDTH, columns),
            (register::HEIGHT, rows),
            (register::RELEASE_SOURCE, 1),
            (register::BURST_FRAME_COUNT, 1),
        ]
    }
}

/// Writes a string into 32 bytes of registers, padded with zeros.
fn write_text(registers: &aravis::FakeCamera, register: u32, text: &[u8]) {
    let mut bytes = [0; 32];
    bytes.iter_mut().zip(text).for_each(|(byte, letter)| *byte = *letter);
    for (address, word) in (register..).step_by(4).zip(bytes.chunks_exact(4)) {
        registers.write_register(address, u32::from_be_bytes([word[0], word[1], word[2], word[3]]));
    }
}

fn sum(a: FrameCounts, b: FrameCounts) -> FrameCounts {
    FrameCounts {
        exposures: a.exposures + b.exposures,
        sent: a.sent + b.sent,
        lost: a.lost + b.lost,
        ignored: a.ignored + b.ignored,
        abandoned: a.abandoned + b.abandoned,
        untriggered: a.untriggered + b.untriggered,
    }
}
