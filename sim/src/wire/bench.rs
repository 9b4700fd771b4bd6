//! A whole bench on real wires: a synchroniser on a pseudo-terminal that triggers GigE Vision
//! cameras on the network.
//!
//! ```text
//! serial commands -> pulse generator -> pulses -> optics -> images -> cameras -> GVSP
//! ```
//!
//! The drivers at the other ends see what a real bench would show: the programmed schedule decides when
//! cameras are triggered and at what time of the flow each exposure is lit.

use std::{
    fs, io,
    os::unix::fs::symlink,
    path::PathBuf,
    sync::{Arc, Mutex, MutexGuard, PoisonError, mpsc},
    thread::{self, JoinHandle},
};

use lfpiv_hw::{CameraName, RawImage, gige::ImageSize, synchroniser::ChannelMap};
use thiserror::Error;

use super::{
    PeriodOutputs, Pictures, WireSettings,
    camera::{Exposed, FakeCameraError, FakeGigeCamera, FrameCounts},
    exposure::{CameraExposures, OpticalBench, Wiring},
    faulty_unit::FaultyUnit,
    frame_faults::{self, FrameFaults, Outgoing, UnsupportedFaults},
    pictures::Delivery,
    pty::Served,
    pulse_generator::PulseGenerator,
};
use crate::{
    camera::CLOCK_OFFSET_NS,
    faults::{FaultRecord, FaultSettings, FrameFault, Injected, LineFault},
};

/// Why the bench cannot be started.
#[derive(Debug, Error)]
pub enum WireError {
    /// A camera cannot be started.
    #[error(transparent)]
    Camera(#[from] FakeCameraError),
    /// Requested faults that the wires cannot produce.
    #[error(transparent)]
    Faults(#[from] UnsupportedFaults),
    /// The system provides no pseudo-terminal, thread or link.
    #[error("simulated bench: {what}")]
    System { what: String, source: io::Error },
}

/// A frame handed to the network.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SentFrame {
    /// From 0.
    pub camera: usize,
    /// Number of the shot, from 0.
    pub shot: u64,
    /// 1 or 2.
    pub exposure: u8,
    /// Start of the exposure on the camera's clock.
    pub device_timestamp_ns: u64,
    /// See [`RawImage::crc32`].
    pub crc32: u32,
}

/// Deviations from a normal bench.
#[derive(Debug, Clone, Default)]
pub struct WireOptions {
    /// Faults of cameras and serial line.
    pub faults: FaultSettings,
    /// Cameras offer only pixel formats that carry every bit of the images' counts.
    pub exact: bool,
}

/// Output of a bench so far.
#[derive(Debug, Clone, Default)]
pub struct WireReport {
    /// T0 pulses.
    pub periods: u64,
    /// Pulses at the outputs of Q-switches 1 and 2.
    pub q_switches: [u64; 2],
    /// Per camera.
    pub frames: Vec<FrameCounts>,
    /// Faults of each camera's frames, numbered from 0 in the order of the camera's exposures.
    pub frame_faults: Vec<Vec<Injected<FrameFault>>>,
    /// Faults of the serial line.
    pub line_faults: Vec<Injected<LineFault>>,
}

/// Running instruments; dropping them cuts every wire.
pub struct WireBench {
    cameras: Vec<Arc<FakeGigeCamera>>,
    unit: Served<FaultyUnit<PulseGenerator>>,
    frame_faults: Vec<FaultRecord<FrameFault>>,
    sent: Arc<Mutex<Vec<SentFrame>>>,
    link: PathBuf,
    threads: Vec<JoinHandle<()>>,
}

/// One trigger's frames for one camera.
struct Triggered {
    shot: u64,
    exposures: CameraExposures,
    /// A missing image is a frame lost in transit.
    images: [Option<RawImage>; 2],
}

impl WireBench {
    /// Starts everything. Images have the size `sensor` and `count_bits` significant bits.
    ///
    /// # Errors
    /// An address is not local or is in use; no pseudo-terminal, thread or link.
    pub fn start(
        settings: &WireSettings,
        sensor: ImageSize,
        count_bits: u32,
        pictures: Arc<dyn Pictures>,
    ) -> Result<Self, WireError> {
        Self::start_with(settings, sensor, count_bits, pictures, &WireOptions::default())
    }

    /// As [`Self::start`], with faults, or with cameras that never truncate counts.
    ///
    /// # Errors
    /// As [`Self::start`]; faults that the wires cannot produce.
    pub fn start_with(
        settings: &WireSettings,
        sensor: ImageSize,
        count_bits: u32,
        pictures: Arc<dyn Pictures>,
        options: &WireOptions,
    ) -> Result<Self, WireError> {
        frame_faults::check(&options.faults)?;
        let started = settings.camera_ips.iter().enumerate().map(|(index, &ip)| {
            let serial = format!("SIM{}", index + 1);
            let camera = FakeGigeCamera::start(ip, &serial, sensor, count_bits)?;
            camera.set_exact(options.exact);
            connected(camera, settings)
        });
        let cameras = started.collect::<Result<Vec<_>, _>>()?;
        let sent = Arc::new(Mutex::new(Vec::new()));
        let (periods, arriving) = mpsc::channel();
        let mut threads = Vec::new();
        let (mut triggers, mut frame_faults) = (Vec::new(), Vec::new());
        for (index, camera) in cameras.iter().enumerate() {
            let (trigger, triggered) = mpsc::channel();
            triggers.push(trigger);
            let (camera, sent) = (Arc::clone(camera), Arc::clone(&sent));
            let faults = FrameFaults::new(index, &options.faults);
            frame_faults.push(faults.record());
            let run = move || expose_all(index, &camera, faults, &triggered, &sent);
            threads.push(spawn(format!("fake {}", CameraName(index)), run)?);
        }
        let optics = OpticalBench::new(wiring(cameras.len()), settings.laser(), settings.camera());
        let run = move || take_pictures(optics, pictures.as_ref(), &arriving, &triggers);
        threads.push(spawn("optics".into(), run)?);
        let observer = Box::new(move |period| {
            // The optics thread lives as long as this sender.
            let _ = periods.send(period);
        });
        let unit = FaultyUnit::new(PulseGenerator::new(settings.unit()), &options.faults);
        let unit = Served::start(unit, observer).map_err(|source| {
            system("cannot open a pseudo-terminal for the synchroniser", source)
        })?;
        let link = settings.port.clone();
        make_link(unit.path(), &link)?;
        Ok(Self { cameras, unit, frame_faults, sent, link, threads })
    }

    /// A camera, to inject faults.
    pub fn camera(&self, index: usize) -> &FakeGigeCamera {
        &self.cameras[index]
    }

    /// The synchroniser, to inject faults. This holds a lock: do not call it twice in one statement.
    pub fn unit(&self) -> MutexGuard<'_, FaultyUnit<PulseGenerator>> {
        self.unit.unit()
    }

    /// Cuts the serial line; the unit continues.
    pub fn cut_line(&self) {
        self.unit.cut_line();
    }

    /// The frames handed to the network since the last call.
    pub fn take_sent(&self) -> Vec<SentFrame> {
        std::mem::take(&mut *self.sent.lock().unwrap_or_else(PoisonError::into_inner))
    }

    /// Output so far.
    pub fn report(&self) -> WireReport {
        let unit = self.unit.unit();
        let heads = ChannelMap::default().q_switches();
        WireReport {
            periods: unit.periods(),
            q_switches: heads.map(|channel| unit.pulses(channel.number())),
            frames: self.cameras.iter().map(|camera| camera.counts()).collect(),
            frame_faults: self.frame_faults.iter().map(FaultRecord::faults).collect(),
            line_faults: unit.record().faults(),
        }
    }
}

impl Drop for WireBench {
    fn drop(&mut self) {
        // It may have been removed already.
        let _ = fs::remove_file(&self.link);
        // Unplugging releases waiting threads. Dropping the unit's observer ends the optics thread
        // and then the cameras' threads.
        self.unit.cut();
        for camera in &self.cameras {
            camera.unplug();
        }
        for thread in self.threads.drain(..) {
            // The thread has printed its panic.
            let _ = thread.join();
        }
    }
}

/// Plugs the camera in, with the configured line.
fn connected(
    camera: FakeGigeCamera,
    settings: &WireSettings,
) -> Result<Arc<FakeGigeCamera>, FakeCameraError> {
    camera.unplug();
    camera.set_line_rate(settings.line_mbit_s * 1e6 / 8.0);
    camera.set_lost_packet_ratio(settings.lost_packets);
    camera.plug_in()?;
    Ok(Arc::new(camera))
}

/// The drivers' default assignment of outputs; one trigger output for all cameras.
fn wiring(cameras: usize) -> Wiring {
    let channels = ChannelMap::default();
    let trigger = channels.cameras.first().map_or(0, |channel| channel.number());
    Wiring {
        lamps: channels.lamps().map(|channel| channel.number()),
        q_switches: channels.q_switches().map(|channel| channel.number()),
        cameras: vec![trigger; cameras],
    }
}

/// Converts pulses to images, one period after another.
fn take_pictures(
    mut optics: OpticalBench,
    pictures: &dyn Pictures,
    periods: &mpsc::Receiver<PeriodOutputs>,
    cameras: &[mpsc::Sender<Triggered>],
) {
    let mut shot = 0;
    for period in periods {
        let triggered = optics.period(&period);
        if triggered.is_empty() {
            continue;
        }
        let mut light = vec![[Vec::new(), Vec::new()]; cameras.len()];
        for exposures in &triggered {
            light[exposures.camera] = exposures.light.clone();
        }
        let separation_s = triggered.iter().find_map(|exposures| exposures.separation_s);
        let mut deliveries: Vec<_> =
            pictures.of(shot, &light, separation_s).into_iter().map(Some).collect();
        for exposures in triggered {
            let camera = exposures.camera;
            let delivery = deliveries.get_mut(camera).and_then(Option::take);
            if let Some(Delivery::Frames(images)) = delivery {
                // A camera's thread outlives this one.
                let _ = cameras[camera].send(Triggered { shot, exposures, images });
            }
        }
        shot += 1;
    }
}

/// Hands a camera's images to the network.
fn expose_all(
    index: usize,
    camera: &FakeGigeCamera,
    mut faults: FrameFaults,
    triggered: &mpsc::Receiver<Triggered>,
    sent: &Mutex<Vec<SentFrame>>,
) {
    for Triggered { shot, exposures, images } in triggered {
        for (number, image) in images.into_iter().enumerate() {
            let start_ns = (exposures.exposures_us[number][0] * 1000.0).round() as u64;
            let at_ns = exposures.t0_ns + start_ns + CLOCK_OFFSET_NS * (index as u64 + 1);
            match faults.disturb(image, at_ns) {
                Outgoing::Nothing => {}
                Outgoing::Unplugged => camera.unplug(),
                Outgoing::Frame { lost_before, image, device_timestamp_ns } => {
                    for _ in 0..lost_before {
                        camera.lose();
                    }
                    let exposure = number as u8 + 1;
                    let crc32 = image.crc32();
                    let frame =
                        SentFrame { camera: index, shot, exposure, device_timestamp_ns, crc32 };
                    expose(camera, image, frame, sent);
                }
            }
        }
    }
}

fn expose(
    camera: &FakeGigeCamera,
    image: RawImage,
    frame: SentFrame,
    sent: &Mutex<Vec<SentFrame>>,
) {
    let (name, shot) = (CameraName(frame.camera), frame.shot);
    match camera.expose(Arc::new(image), frame.device_timestamp_ns) {
        Ok(Exposed::Yes) => sent.lock().unwrap_or_else(PoisonError::into_inner).push(frame),
        Ok(Exposed::No(reason)) => {
            tracing::debug!(camera = %name, shot, ?reason, "the camera ignored a trigger");
        }
        Err(error) => tracing::error!(camera = %name, shot, %error, "no picture"),
    }
}

fn spawn(name: String, run: impl FnOnce() + Send + 'static) -> Result<JoinHandle<()>, WireError> {
    let spawned = thread::Builder::new().name(name).spawn(run);
    spawned.map_err(|source| system("no thread", source))
}

fn make_link(path: &str, link: &PathBuf) -> Result<(), WireError> {
    let failed = |source| system(&format!("cannot link {} to {path}", link.display()), source);
    if let Some(folder) = link.parent() {
        fs::create_dir_all(folder).map_err(failed)?;
    }
    // Removes only a link left by a killed bench.
    if fs::symlink_metadata(link).is_ok_and(|data| data.file_type().is_symlink()) {
        fs::remove_file(link).map_err(failed)?;
    }
    symlink(path, link).map_err(failed)
}

fn system(what: &str, source: io::Error) -> WireError {
    WireError::System { what: what.to_owned(), source }
}
