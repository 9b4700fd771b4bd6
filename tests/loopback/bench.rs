//! A bench on real wires, the drivers connected to it, and acquisition runs.

use std::{
    net::Ipv4Addr,
    num::NonZeroU64,
    path::Path,
    sync::Arc,
    time::{Duration, Instant},
};

use lfpiv::{
    acquisition::{
        AcquisitionError, AcquisitionLinks, AcquisitionReport, AcquisitionSettings, Bench, Ledger,
        Outcome, OverloadPolicy, Shot, acquire, shot_queue,
    },
    config::{Config, ConfigFile},
};
use lfpiv_hw::{
    PulseSchedule, RawImage, TimingSettings,
    gige::{self, CameraSettings, ImageSize, PixelFormat},
    synchroniser::{self, SynchroniserDriver, SynchroniserSettings, line::Transcript},
};
use lfpiv_sim::{
    LightPulse,
    wire::{Delivery, Pictures, WireSettings, bench::WireBench},
};
use parking_lot::Mutex;
use tokio_util::sync::CancellationToken;

/// Timeout of every wait, long enough for a busy machine.
pub const LONG: Duration = Duration::from_secs(300);

/// A quarter of the bench's sensor along each edge.
pub const SIZE: ImageSize = ImageSize { columns: 588, rows: 442 };

/// The bench of `tests/data/small.toml`.
pub fn small() -> Config {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/small.toml");
    ConfigFile::load(&path).expect("small.toml").config
}

/// A fast laser and fast cameras without warm-up.
pub fn timing() -> TimingSettings {
    TimingSettings {
        laser_rate_limit_hz: 40.0,
        readout_us: 5000.0,
        lamp_warm_up_s: 0.0,
        ..TimingSettings::default()
    }
}

/// Simulated instruments for [`timing`], with their port in `folder`.
pub fn wire(folder: &Path) -> WireSettings {
    WireSettings {
        port: folder.join("synchroniser"),
        readout_us: 5000.0,
        ..WireSettings::default()
    }
}

/// Settings of camera `index` for the loopback.
pub fn camera(index: usize) -> CameraSettings {
    CameraSettings {
        ip: Some(Ipv4Addr::new(127, 0, 0, index as u8 + 1)),
        pixel_format: PixelFormat::Mono12Packed,
        packet_size_bytes: 16_000,
        socket_buffer_bytes: 4 << 20,
        // Threads may be delayed for long while other programs build and test.
        packet_timeout_us: 200_000,
        frame_retention_us: 2_000_000,
        ..CameraSettings::default()
    }
}

/// The drivers, connected to what [`wire`] describes.
pub fn connect(wire: &WireSettings, size: ImageSize) -> Bench {
    connect_with(wire, size, camera)
}

/// The same, with `settings` for each camera's index.
pub fn connect_with(
    wire: &WireSettings,
    size: ImageSize,
    of_camera: impl Fn(usize) -> CameraSettings,
) -> Bench {
    connect_within(wire, size, of_camera, 5000)
}

/// The same, with this reply timeout of the synchroniser.
pub fn connect_within(
    wire: &WireSettings,
    size: ImageSize,
    of_camera: impl Fn(usize) -> CameraSettings,
    reply_timeout_ms: u64,
) -> Bench {
    let port = wire.port.to_str().expect("a UTF-8 path");
    let settings = SynchroniserSettings {
        pacing_ms: 0,
        reply_timeout_ms,
        ..SynchroniserSettings::at(SynchroniserDriver::Bnc575, port)
    };
    let synchroniser =
        synchroniser::open(&settings, &timing(), Transcript::in_memory()).expect("a synchroniser");
    let open = |index: usize| {
        let name = format!("cam{}", index + 1);
        gige::open(&name, &of_camera(index), size).expect("a camera")
    };
    Bench::new((0..2).map(open).collect(), synchroniser)
}

/// Images of 12-bit counts that encode shot, camera and exposure in every row, if exactly one pulse
/// of full energy lit the exposure; otherwise black.
pub struct Patterns(pub ImageSize);

impl Patterns {
    pub fn picture(&self, shot: u64, camera: usize, exposure: usize) -> RawImage {
        let number = 4 * shot + 2 * camera as u64 + exposure as u64;
        let key = 0x9e37_79b9_7f4a_7c15 ^ (number << 17 | number);
        let counts = (0..self.0.pixels() as u64)
            .map(|pixel| ((pixel + 1).wrapping_mul(key) >> 40 & 0xfff) as u16);
        RawImage::new(self.0.columns, self.0.rows, counts.collect()).expect("its own size")
    }

    /// What an image shows, for a message.
    fn described(&self, image: &RawImage) -> String {
        let pixels = image.counts();
        let count = |wanted: &[u16]| pixels.iter().zip(wanted).filter(|(a, b)| a == b).count();
        let dark = pixels.iter().filter(|count| **count == 0).count();
        let places = (0..200).flat_map(|shot| (0..4).map(move |n| (shot, n / 2, n % 2)));
        let alike = |(shot, camera, exposure)| {
            (count(self.picture(shot, camera, exposure).counts()), shot, camera, exposure)
        };
        let (most, shot, camera, exposure) = places.map(alike).max().expect("pictures");
        format!(
            "{dark} of {} pixels are dark, {most} are those of shot {shot}, camera {camera}, \
             exposure {exposure}",
            pixels.len()
        )
    }
}

impl Pictures for Patterns {
    fn of(&self, shot: u64, light: &[[Vec<LightPulse>; 2]], _: Option<f64>) -> Vec<Delivery> {
        let as_planned = |pulses: &[LightPulse]| matches!(pulses, [p] if p.energy > 0.99);
        let exposed = |camera: usize, exposure: usize| {
            if as_planned(&light[camera][exposure]) {
                return self.picture(shot, camera, exposure);
            }
            let black = vec![0; self.0.pixels()];
            RawImage::new(self.0.columns, self.0.rows, black).expect("its own size")
        };
        (0..light.len()).map(|camera| [exposed(camera, 0), exposed(camera, 1)].into()).collect()
    }
}

/// Instruments that show [`Patterns`].
pub fn patterns(wire: &WireSettings) -> WireBench {
    WireBench::start(wire, SIZE, 12, Arc::new(Patterns(SIZE))).expect("a bench")
}

/// Result of a run.
pub struct Taken {
    pub ended: Result<AcquisitionReport, AcquisitionError>,
    pub shots: Vec<Shot>,
    pub ledger: Ledger,
    pub seconds: f64,
}

impl Taken {
    pub fn complete(&self, camera: usize) -> u64 {
        self.ledger.accounts()[camera].outcomes.of(Outcome::Complete)
    }

    /// Whether a shot says that the laser was being switched off, so that it may be dark.
    fn may_be_dark(shot: &Shot) -> bool {
        shot.suspect.iter().any(|reason| reason.contains("switched off"))
    }

    /// Number of shots that may be dark.
    pub fn dark_shots(&self) -> u64 {
        self.shots.iter().filter(|shot| Self::may_be_dark(shot)).count() as u64
    }

    /// Checks that every frame of every shot is that shot's image, byte for byte, or black where the
    /// shot says that it may be dark.
    pub fn assert_pictures(&self, patterns: &Patterns) {
        for shot in &self.shots {
            for (camera, frames) in shot.cameras.iter().enumerate() {
                for (exposure, frame) in frames.iter().enumerate() {
                    let sent = patterns.picture(shot.trigger, camera, exposure);
                    let (trigger, id) = (shot.trigger, frame.frame_id);
                    let is_black = || frame.image.counts().iter().all(|count| *count == 0);
                    assert!(
                        frame.image == sent || Self::may_be_dark(shot) && is_black(),
                        "shot {trigger}, camera {camera}, exposure {exposure}, frame {id}: {}; \
                         suspect: {:?}",
                        patterns.described(&frame.image),
                        shot.suspect
                    );
                }
            }
        }
    }
}

/// Takes `shots` shots at `rate_hz` and settles each one that arrives as complete; calls `seen` for
/// each.
pub fn take(bench: Bench, shots: u64, rate_hz: f64, mut seen: impl FnMut(&Shot)) -> Taken {
    let settings = AcquisitionSettings {
        schedule: PulseSchedule::plan(&timing(), 100.0, rate_hz).expect("a schedule"),
        shots: NonZeroU64::new(shots),
        overload: OverloadPolicy::Wait,
        patience: Duration::from_secs(10),
        frame_bytes: 2 * SIZE.pixels() as u64,
    };
    let runtime = tokio::runtime::Builder::new_multi_thread().enable_all().build().expect("tokio");
    let ledger = Arc::new(Mutex::new(Ledger::new(2)));
    let began = Instant::now();
    let (ended, shots) = runtime.block_on(async {
        let (sender, mut receiver) = shot_queue(shots as usize);
        let stop = CancellationToken::new();
        let links = AcquisitionLinks::new(ledger.clone(), sender, stop);
        let acquiring = tokio::spawn(acquire(bench, settings, links));
        let mut shots = Vec::new();
        while let Some(shot) = receiver.recv().await {
            ledger.lock().settle_all(shot.trigger, Outcome::Complete).expect("an open trigger");
            seen(&shot);
            shots.push(shot);
        }
        (acquiring.await.expect("no panic"), shots)
    });
    let seconds = began.elapsed().as_secs_f64();
    let ledger = ledger.lock().clone();
    assert!(ledger.is_balanced(), "{ledger:?}");
    assert!(ledger.accounts().iter().all(|account| account.open == 0), "{ledger:?}");
    Taken { ended, shots, ledger, seconds }
}

/// The same image for every exposure, at no cost.
pub struct Repeated(RawImage);

impl Repeated {
    pub fn new(size: ImageSize) -> Self {
        Self(Patterns(size).picture(0, 0, 0))
    }
}

impl Pictures for Repeated {
    fn of(&self, _: u64, light: &[[Vec<LightPulse>; 2]], _: Option<f64>) -> Vec<Delivery> {
        light.iter().map(|_| [self.0.clone(), self.0.clone()].into()).collect()
    }
}
