//! The simulated bench of `tests/data/small.toml`, with faults on request.

use std::{path::Path, sync::Arc, time::Duration};

use lfpiv::{acquisition::Bench, config::ConfigFile};
use lfpiv_core::{
    lightfield::ImagePair,
    velocimetry::{PairResult, StageSeconds, VectorGrid, VectorStatus, VelocityField},
};
use lfpiv_hw::{
    PulseSchedule,
    device::{
        Camera, DeviceError, Frame, FrameStatus, StreamStatistics, Synchroniser, SynchroniserState,
    },
};
use lfpiv_sim::{Pacing, connect};
use parking_lot::Mutex;

/// A bench of a few pixels, so that tests need not wait for rendering; results go to `results_dir`.
pub fn configuration(results_dir: &Path) -> ConfigFile {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/small.toml");
    let mut file = ConfigFile::load(&path).unwrap();
    file.config.output.dir = results_dir.to_owned();
    let optics = &mut file.config.optics;
    (optics.microlens.columns, optics.microlens.rows) = (5, 5);
    (optics.sensor.columns, optics.sensor.rows) = (92, 92);
    file.config.volume.voxels = [4, 4, 4];
    file
}

/// What a camera does instead of delivering a frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Trick {
    Lose,
    Damage,
    Repeat,
    /// The connection breaks.
    Fail,
    /// The driver has a bug.
    Panic,
    /// The line to the synchroniser breaks.
    CutLine,
    /// It is unplugged for a while. Its driver reports that once the laser has been made safe.
    Unplug,
}

/// The calls that reached the devices, in order.
pub type CallLog = Arc<Mutex<Vec<String>>>;

/// The simulated bench; `tricks` lists (camera, frame id, trick).
pub fn bench(file: &ConfigFile, tricks: &[(usize, u64, Trick)]) -> (Bench, CallLog) {
    let log = CallLog::default();
    let scene = file.config.simulation.clone().unwrap();
    let seed = scene.seed;
    let inner = connect(scene, file.config.bench_geometry(), seed, Pacing::AsFramesAreTaken);
    let cameras = inner.cameras.into_iter().enumerate().map(|(index, inner)| {
        let tricks = tricks.iter().filter(|(camera, ..)| *camera == index);
        let tricks: Vec<_> = tricks.map(|(_, frame_id, trick)| (*frame_id, *trick)).collect();
        let log = log.clone();
        let unplugged = tricks.iter().any(|(_, trick)| *trick == Trick::Unplug);
        let loss_detection_time = if unplugged { LONGER_THAN_A_TEST } else { Duration::ZERO };
        let (repeated, plug) = (None, Plug::In);
        Box::new(TrickCamera { inner, tricks, repeated, plug, loss_detection_time, log })
            as Box<dyn Camera>
    });
    let cameras = cameras.collect();
    let synchroniser = Box::new(LoggedUnit { inner: inner.synchroniser, log: log.clone() });
    (Bench::new(cameras, synchroniser), log)
}

struct TrickCamera {
    inner: Box<dyn Camera>,
    tricks: Vec<(u64, Trick)>,
    repeated: Option<Frame>,
    plug: Plug,
    loss_detection_time: Duration,
    log: CallLog,
}

/// Whether a camera is plugged in.
enum Plug {
    In,
    /// Pulled when the devices had received `calls` calls; the driver has not noticed.
    Pulled {
        calls: usize,
    },
    /// The driver reports the loss while it is asked for this many more frames.
    Missed {
        asked: usize,
    },
}

/// Number of times that a driver that misses its camera is asked for frames.
const MISSED: usize = 5;

const LONGER_THAN_A_TEST: Duration = Duration::from_secs(60);

impl Plug {
    /// Goes on by one request for a frame.
    fn turn(&mut self, log: &CallLog) {
        *self = match *self {
            Self::Pulled { calls }
                if log.lock()[calls..].iter().any(|call| call == "make safe") =>
            {
                Self::Missed { asked: MISSED }
            }
            Self::Missed { asked: 0 } => Self::In,
            Self::Missed { asked } => Self::Missed { asked: asked - 1 },
            Self::In => Self::In,
            Self::Pulled { calls } => Self::Pulled { calls },
        }
    }
}

impl Camera for TrickCamera {
    fn name(&self) -> &str {
        self.inner.name()
    }

    fn start(&mut self) -> Result<(), DeviceError> {
        self.log.lock().push("camera start".to_owned());
        self.inner.start()
    }

    fn next_frame(&mut self, timeout: Duration) -> Result<Option<Frame>, DeviceError> {
        if let Some(frame) = self.repeated.take() {
            return Ok(Some(frame));
        }
        let frame = self.inner.next_frame(timeout)?;
        self.plug.turn(&self.log);
        let Some(mut frame) = frame.filter(|_| matches!(self.plug, Plug::In)) else {
            return Ok(None);
        };
        let trick = self.tricks.iter().find(|(id, _)| *id == frame.frame_id).map(|(_, t)| *t);
        match trick {
            None => {}
            Some(Trick::Lose) => return Ok(None),
            Some(Trick::Damage) => frame.status = FrameStatus::MissingPackets,
            Some(Trick::Repeat) => self.repeated = Some(frame.clone()),
            Some(Trick::Fail) => {
                let (device, detail) = (self.name().to_owned(), "no heartbeat".to_owned());
                return Err(DeviceError::Lost { device, detail });
            }
            Some(Trick::Panic) => panic!("driver bug"),
            Some(Trick::CutLine) => self.log.lock().push(CUT.to_owned()),
            Some(Trick::Unplug) => {
                self.plug = Plug::Pulled { calls: self.log.lock().len() };
                self.tricks.retain(|(_, trick)| *trick != Trick::Unplug);
                return Ok(None);
            }
        }
        Ok(Some(frame))
    }

    fn stop(&mut self) -> Result<(), DeviceError> {
        self.log.lock().push("camera stop".to_owned());
        self.inner.stop()
    }

    fn statistics(&self) -> StreamStatistics {
        self.inner.statistics()
    }

    fn is_connected(&self) -> bool {
        !matches!(self.plug, Plug::Missed { .. })
    }

    fn loss_detection_time(&self) -> Duration {
        self.loss_detection_time
    }
}

const CUT: &str = "line cut";

struct LoggedUnit {
    inner: Box<dyn Synchroniser>,
    log: CallLog,
}

impl LoggedUnit {
    /// Whether the line still answers.
    fn line(&self) -> Result<(), DeviceError> {
        if self.log.lock().iter().any(|call| call == CUT) {
            let (device, detail) = ("unit".to_owned(), "no answer".to_owned());
            return Err(DeviceError::Lost { device, detail });
        }
        Ok(())
    }
}

impl Synchroniser for LoggedUnit {
    fn identify(&mut self) -> Result<String, DeviceError> {
        self.line()?;
        self.inner.identify()
    }

    fn program(&mut self, schedule: &PulseSchedule) -> Result<(), DeviceError> {
        self.line()?;
        self.log.lock().push("program".to_owned());
        self.inner.program(schedule)
    }

    fn fire(&mut self, shots: u64) -> Result<(), DeviceError> {
        self.line()?;
        self.log.lock().push(format!("fire {shots}"));
        self.inner.fire(shots)
    }

    fn trigger_count(&mut self) -> Result<Option<u64>, DeviceError> {
        self.line()?;
        self.inner.trigger_count()
    }

    fn state(&mut self) -> Result<SynchroniserState, DeviceError> {
        self.line()?;
        let state = self.inner.state()?;
        if state == SynchroniserState::Safe {
            self.log.lock().push("reads back safe".to_owned());
        }
        Ok(state)
    }

    fn make_safe(&mut self) -> Result<(), DeviceError> {
        self.line()?;
        self.log.lock().push("make safe".to_owned());
        self.inner.make_safe()
    }
}

/// A result of two vectors that needs no measurement.
pub fn quick_result(_: &ImagePair) -> PairResult {
    PairResult {
        field: VelocityField {
            grid: VectorGrid { vectors: [2, 1, 1], first_mm: [0.1, 0.2, 0.3], spacing_mm: 0.8 },
            displacement_vox: vec![[1.0, -2.0, 0.5], [0.0; 3]],
            uncertainty_vox: vec![[0.25, 0.5, 0.125], [1.0; 3]],
            status: vec![VectorStatus::Valid, VectorStatus::Invalid],
            peak_ratio: vec![2.5, 0.0],
            vorticity: vec![[0.01, 0.0, -0.01], [0.0; 3]],
            divergence: vec![0.02, 0.0],
            has_gradient: vec![true, false],
            voxel_mm: 0.1,
            dt_s: 1e-4,
        },
        seconds: StageSeconds { decode_s: 0.1, reconstruct_s: 0.2, correlate_s: 0.3, judge_s: 0.1 },
        warnings: Vec::new(),
        model: Default::default(),
        fit: None,
        light: None,
        particles: None,
    }
}
