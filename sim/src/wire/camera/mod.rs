//! A GigE Vision camera that is not there, on a network address that is: Aravis' in-process fake,
//! with a GenICam description, a trigger line and pictures of our own.
//!
//! ```text
//! synchroniser --expose--> FakeGigeCamera --GVSP--> driver
//!                               ^------------GVCP-----'
//! ```
//!
//! Where it differs from hardware: lost packets cannot be asked for again (the fake knows no
//! resend), and a trigger that comes before the frames of the last one have left waits for them,
//! where a camera would miss it. A frame leaves at once rather than spread over its time on the line.

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

/// What the camera says about itself.
const GENICAM: &str = include_str!("genicam.xml");

/// Where a GigE Vision device listens.
const GVCP_PORT: u16 = 3956;

/// The synchroniser's cable ends in Line1: its value in the GenICam description.
const WIRED_LINE: u32 = 1;

/// What a line carries by default, in bytes/s: 2.5GBASE-T.
const LINE_BYTES_PER_S: f64 = 312.5e6;

/// The frame counter of a camera that was just switched on: soon before its wrap, as in Aravis.
const FIRST_FRAME_ID: u16 = 65_400;

/// Registers of the fake that are written or read here; see `genicam.xml`.
mod register {
    /// Texts of 32 bytes that discovery answers with.
    pub(super) const VENDOR: u32 = 0x48;
    pub(super) const MODEL: u32 = 0x68;
    pub(super) const WIDTH: u32 = 0x100;
    pub(super) const HEIGHT: u32 = 0x104;
    pub(super) const SENSOR_HEIGHT: u32 = 0x118;
    pub(super) const SENSOR_WIDTH: u32 = 0x11c;
    pub(super) const ACQUISITION: u32 = 0x124;
    pub(super) const TRIGGER_MODE: u32 = 0x300;
    /// The fake's own trigger source, which is not the one that a controller sees.
    pub(super) const RELEASE_SOURCE: u32 = 0x304;
    /// 1 releases one frame.
    pub(super) const RELEASE_FRAME: u32 = 0x30c;
    pub(super) const TRIGGER_SOURCE: u32 = 0x400;
    pub(super) const BURST_FRAME_COUNT: u32 = 0x410;
}

/// Why a fake camera is not there.
#[derive(Debug, Error)]
pub enum FakeCameraError {
    /// The address is not this machine's, or something listens there already.
    #[error(
        "fake camera {serial}: cannot listen at {address}:{GVCP_PORT}: is the address this \
         machine's (`ip addr add {address}/8 dev lo`), and no other fake camera running?"
    )]
    Address { serial: String, address: Ipv4Addr, source: io::Error },
    /// The GenICam description could not be handed to Aravis.
    #[error("fake camera {serial}: its description cannot be written to a temporary file")]
    Description { serial: String, source: io::Error },
    /// Aravis did not start it.
    #[error(
        "fake camera {serial}: Aravis did not start it at {address}: is the address this machine's \
         (`ip addr add {address}/8 dev lo`)? ARV_DEBUG=all says more"
    )]
    NotStarted { serial: String, address: Ipv4Addr },
    /// A picture that is not the sensor's.
    #[error(
        "fake camera {serial}: picture of {columns} x {rows} pixels for a sensor of \
         {} x {}", sensor.columns, sensor.rows
    )]
    ImageSize { serial: String, columns: usize, rows: usize, sensor: ImageSize },
}

/// Why a trigger did nothing, as it would in hardware.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Ignored {
    /// The camera is unplugged.
    Unplugged,
    /// Nobody has started it.
    NotAcquiring,
    /// Its trigger mode is off.
    FreeRunning,
    /// It listens to another line, or to software.
    OtherSource,
}

/// Whether a trigger made a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Exposed {
    /// The frame is sent, or waits for its turn.
    Yes,
    /// It did nothing.
    No(Ignored),
}

/// Where exposures went: `exposures` is the sum of `sent`, `lost`, `ignored`, `abandoned` and those
/// held.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct FrameCounts {
    /// Pulses on the trigger line.
    pub exposures: u64,
    /// Frames that were handed to the network with their picture.
    pub sent: u64,
    /// Frames that were counted and got lost on purpose.
    pub lost: u64,
    /// Pulses that did nothing.
    pub ignored: u64,
    /// Exposures that were held when the acquisition ended.
    pub abandoned: u64,
    /// Frames that no exposure caused: free run.
    pub dark: u64,
}

/// A camera on the network whose pictures are made here.
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
    /// Counts of the times it was plugged in before.
    counts: FrameCounts,
}

impl FakeGigeCamera {
    /// Plugs a camera in. Its pictures have `count_bits` significant bits.
    ///
    /// # Errors
    /// The address is not to be had.
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

    /// One exposure: the synchroniser's pulse arrives while the sensor sees `image`.
    ///
    /// Exactly one frame goes out, with this picture, the camera's next frame id and the timestamp
    /// `device_timestamp_ns` of the camera's clock, in the pixel format, region and packets that
    /// the controller chose. A camera that is not waiting for its trigger line ignores the pulse.
    /// When two exposures are held already this waits until one has been sent.
    ///
    /// # Errors
    /// The picture is not of the sensor's size.
    pub fn expose(
        &self,
        image: Arc<RawImage>,
        device_timestamp_ns: u64,
    ) -> Result<Exposed, FakeCameraError> {
        let (columns, rows) = (image.columns(), image.rows());
        if (columns, rows) != (self.sensor.columns, self.sensor.rows) {
            let (serial, sensor) = (self.serial.clone(), self.sensor);
            return Err(FakeCameraError::ImageSize { serial, columns, rows, sensor });
        }
        let Some(feed) = self.feed() else { return Ok(self.unplugged()) };
        Ok(match feed.expose(image, device_timestamp_ns) {
            Ok(()) => Exposed::Yes,
            Err(reason) => Exposed::No(reason),
        })
    }

    /// One exposure whose frame gets lost with all its packets: the camera counts it, and nothing
    /// arrives. Otherwise as [`Self::expose`].
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

    /// Waits until every exposure has been handed to the network; `false` when the acquisition
    /// ended before that.
    pub fn wait_until_sent(&self) -> bool {
        self.feed().is_none_or(|feed| feed.drain())
    }

    /// Where exposures went since the camera was made.
    pub fn counts(&self) -> FrameCounts {
        let state = self.lock();
        let now = state.power.as_ref().map(|camera| camera.feed().counts());
        sum(state.counts, now.unwrap_or_default())
    }

    /// The id of the last frame that was sent, as the network sees it.
    pub fn last_frame_id(&self) -> u16 {
        self.feed().map_or(FIRST_FRAME_ID, |feed| feed.last_frame_id())
    }

    /// Loses this share of stream packets, 0 to 1, at random.
    pub fn set_lost_packet_ratio(&self, ratio: f64) {
        let mut state = self.lock();
        state.lost_packet_ratio = ratio.clamp(0.0, 1.0);
        if let Some(camera) = &state.power {
            camera.set_lost_packet_ratio(state.lost_packet_ratio);
        }
    }

    /// The rate of the line to the camera, in bytes/s, from the next time it is plugged in. Frames
    /// that come faster wait. 312.5e6 (2.5GBASE-T) at first; `f64::INFINITY` for as fast as the
    /// loopback takes packets, which is faster than a driver takes them off it. No less than 1e6.
    pub fn set_line_rate(&self, bytes_per_s: f64) {
        self.lock().line_bytes_per_s = bytes_per_s.max(1e6);
    }

    /// From the next time it is plugged in: whether it offers only pixel formats that carry every
    /// bit of its counts. With others it sends the upper bits, as cameras do.
    pub fn set_exact(&self, exact: bool) {
        self.lock().exact = exact;
    }

    /// Pulls the cable, which also powers it: the camera vanishes from the network and forgets its
    /// settings and its counter. Exposures that are held are lost.
    pub fn unplug(&self) {
        let mut state = self.lock();
        if let Some(camera) = state.power.take() {
            let feed = Arc::clone(camera.feed());
            drop(camera);
            feed.switch_off();
            state.counts = sum(state.counts, feed.counts());
        }
    }

    /// Plugs it in again, at the same address and with the same serial number.
    ///
    /// # Errors
    /// The address is not to be had any more.
    pub fn plug_in(&self) -> Result<(), FakeCameraError> {
        let mut state = self.lock();
        if state.power.is_some() {
            return Ok(());
        }
        let camera = self.switch_on(state.line_bytes_per_s, state.exact)?;
        camera.set_lost_packet_ratio(state.lost_packet_ratio);
        state.power = Some(camera);
        Ok(())
    }

    fn switch_on(
        &self,
        line_bytes_per_s: f64,
        exact: bool,
    ) -> Result<PoweredCamera, FakeCameraError> {
        let (serial, address) = (self.serial.clone(), self.address);
        // Aravis only warns when it cannot listen.
        if let Err(source) = UdpSocket::bind((address, GVCP_PORT)) {
            return Err(FakeCameraError::Address { serial, address, source });
        }
        let described = |source| FakeCameraError::Description { serial: serial.clone(), source };
        let mut file = tempfile::NamedTempFile::new().map_err(described)?;
        let description = if exact { self.exact_description() } else { GENICAM.to_owned() };
        file.write_all(description.as_bytes()).map_err(described)?;
        // The file is read while the camera is made, and not after.
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

    /// What the camera says about itself where it must not cut bits off.
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

/// A text into 32 bytes of registers, padded with zeros.
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
        dark: a.dark + b.dark,
    }
}
