//! A pulse generator, cameras connected to it, and an acquisition run.

use std::{
    collections::VecDeque,
    num::NonZeroU64,
    path::Path,
    sync::{Arc, mpsc},
    time::{Duration, Instant},
};

use lfpiv::acquisition::{
    AcquisitionError, AcquisitionLinks, AcquisitionReport, AcquisitionSettings, Bench, Control,
    Journal, Ledger, Mode, OverloadPolicy, Reconnection, Reopen, ShotReceiver, SynchroniserThread,
    acquire, control, shot_queue,
};
use lfpiv_hw::{
    PulseSchedule, RawImage, TimingSettings,
    device::{Camera, DeviceError, Frame, FrameStatus, StreamStatistics},
    synchroniser::{
        SynchroniserDriver, SynchroniserSettings,
        line::{RecordedLine, SerialLine, Transcript},
        open_on,
    },
    timing::{ExternalTrigger, TriggerEdge, TriggerSource},
};
use lfpiv_rawlog::{RawLog, RawLogSettings};
use lfpiv_sim::wire::{
    pty::Served,
    pulse_generator::{PulseGenerator, PulseGeneratorOptions},
};
use parking_lot::Mutex;
use tokio::{sync::Notify, task::JoinHandle};
use tokio_util::sync::CancellationToken;

/// Timeout of every wait, long enough for a loaded machine.
pub const PATIENCE: Duration = Duration::from_secs(300);
/// On a loaded machine the simulated unit may be delayed for seconds.
const REPLY_TIMEOUT_MS: u64 = 5000;
/// Slow enough that a process that does not wait would exit between the commands.
const PACING_MS: u64 = 10;
/// Outputs in the order in which they are switched off; 0 is T0.
const OUTPUTS: [u8; 9] = [2, 4, 1, 3, 0, 5, 6, 7, 8];
const CAMERAS: usize = 2;
/// Capacity of the shot queue.
pub const QUEUE: usize = 2;
const CAMERA_OUTPUT: u8 = 5;

/// A fast laser and fast cameras, warm after `warm_up_s`.
pub fn timing(warm_up_s: f64) -> TimingSettings {
    TimingSettings {
        laser_rate_limit_hz: 100.0,
        readout_us: 2000.0,
        lamp_warm_up_s: warm_up_s,
        ..TimingSettings::default()
    }
}

/// External triggers, declared with at most 20 per second.
pub fn external(warm_up_s: f64) -> TimingSettings {
    let source = ExternalTrigger { max_rate_hz: 20.0, edge: TriggerEdge::Rising, level_v: 2.5 };
    TimingSettings {
        trigger: TriggerSource::External,
        external_trigger: Some(source),
        ..timing(warm_up_s)
    }
}

/// A running unit whose lamps continue after a burst.
pub struct Laser {
    pub served: Served<PulseGenerator>,
    pub transcript: Transcript,
    /// Current port of the unit.
    port: Arc<Mutex<String>>,
    triggers: Mutex<Vec<mpsc::Receiver<u64>>>,
}

impl Laser {
    pub fn start() -> Self {
        let (senders, triggers): (Vec<_>, Vec<_>) = (0..CAMERAS).map(|_| mpsc::channel()).unzip();
        let options = PulseGeneratorOptions { drops_off_after_burst: false, ..Default::default() };
        let observer = move |period: lfpiv_sim::wire::PeriodOutputs| {
            if period.pulses.iter().any(|pulse| pulse.channel == CAMERA_OUTPUT) {
                // A camera whose run is over accepts no more.
                senders.iter().for_each(|camera| _ = camera.send(period.t0_ns));
            }
        };
        let served = Served::start(PulseGenerator::new(options), Box::new(observer)).unwrap();
        let port = Arc::new(Mutex::new(served.path().to_owned()));
        Self { served, transcript: Transcript::in_memory(), port, triggers: Mutex::new(triggers) }
    }

    /// Unplugs the cable.
    pub fn pull_line(&self) {
        self.port.lock().clear();
        self.served.cut_line();
    }

    /// Plugs it in again.
    pub fn plug_in_line(&self) {
        *self.port.lock() = self.served.plug_in_line().unwrap();
    }

    /// Opens the unit at its current port.
    fn opening(&self, timing: &TimingSettings) -> Reopen {
        let (port, transcript) = (self.port.clone(), self.transcript.clone());
        let timing = timing.clone();
        Box::new(move || {
            let port = port.lock().clone();
            let settings = SynchroniserSettings {
                pacing_ms: PACING_MS,
                reply_timeout_ms: REPLY_TIMEOUT_MS,
                ..SynchroniserSettings::at(SynchroniserDriver::Bnc575, port)
            };
            let line = SerialLine::open(&settings.port, settings.baud_rates()[0]);
            let line = line.map_err(|error| DeviceError::Lost {
                device: settings.port.clone(),
                detail: error.to_string(),
            })?;
            let line = RecordedLine::new(line, transcript.clone());
            open_on(Box::new(line), &settings, &timing)
        })
    }

    /// Driver and cameras, connected.
    pub fn connect(&self, plan: &Plan, frame_interval: Duration) -> Bench {
        let mut open = self.opening(&plan.timing);
        let synchroniser = open().unwrap();
        let reconnection = plan.after_loss.map(|AfterLoss { waits_for_operator, patience }| {
            Reconnection { open, patience, waits_for_operator }
        });
        let triggers = std::mem::take(&mut *self.triggers.lock());
        let cameras = triggers.into_iter().map(|triggers| {
            Box::new(TriggeredCamera {
                triggers,
                frame_interval_ns: frame_interval.as_nanos() as u64,
                exposed: VecDeque::new(),
                frames: 0,
            }) as Box<dyn Camera>
        });
        Bench { reconnection, ..Bench::new(cameras.collect(), synchroniser) }
    }

    /// Pulses of the lamp and of the Q-switch of head 1.
    pub fn pulses(&self) -> [u64; 2] {
        let unit = self.served.unit();
        [unit.pulses(1), unit.pulses(2)]
    }

    /// Commands sent so far.
    pub fn sent(&self) -> usize {
        self.transcript.sent_lines().len()
    }

    /// Checks that the last commands on the line switched everything off, most dangerous outputs
    /// first, that every output was read back afterwards, and that the unit is safe.
    pub fn assert_safe(&self) {
        let sent = self.transcript.sent_lines();
        let first = format!(":PULSE{}:STATE OFF", OUTPUTS[0]);
        let last_order = sent.iter().rposition(|line| *line == first).unwrap();
        let mut expected: Vec<String> =
            OUTPUTS.iter().map(|output| format!(":PULSE{output}:STATE OFF")).collect();
        expected.push("*IDN?".to_owned());
        expected.extend(OUTPUTS.iter().map(|output| format!(":PULSE{output}:STATE?")));
        let after = &sent[last_order..];
        assert!(after.starts_with(&expected), "{after:?}");
        assert!(after[expected.len()..].iter().all(|line| line.contains('?')), "{after:?}");
        let unit = self.served.unit();
        assert!(!unit.is_running() && (1..=8).all(|channel| !unit.is_enabled(channel)));
    }
}

/// Delivers two frames for each pulse of its output.
struct TriggeredCamera {
    triggers: mpsc::Receiver<u64>,
    frame_interval_ns: u64,
    exposed: VecDeque<Frame>,
    frames: u64,
}

impl Camera for TriggeredCamera {
    fn name(&self) -> &str {
        "triggered camera"
    }

    fn start(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }

    fn next_frame(&mut self, timeout: Duration) -> Result<Option<Frame>, DeviceError> {
        if let Some(frame) = self.exposed.pop_front() {
            return Ok(Some(frame));
        }
        let Ok(t0_ns) = self.triggers.recv_timeout(timeout) else { return Ok(None) };
        for exposure in 0..2 {
            let timestamp_ns = t0_ns + exposure * self.frame_interval_ns;
            self.exposed.push_back(Frame {
                image: RawImage::new(2, 2, vec![0; 4]).unwrap(),
                frame_id: self.frames,
                device_timestamp_ns: timestamp_ns,
                host_timestamp_ns: timestamp_ns,
                status: FrameStatus::Complete,
            });
            self.frames += 1;
        }
        Ok(self.exposed.pop_front())
    }

    fn stop(&mut self) -> Result<(), DeviceError> {
        Ok(())
    }

    fn statistics(&self) -> StreamStatistics {
        StreamStatistics { completed: self.frames, ..StreamStatistics::default() }
    }
}

/// How a run is started.
pub struct Plan {
    pub timing: TimingSettings,
    pub mode: Mode,
    pub overload: OverloadPolicy,
    pub journal: Journal,
    /// Whether the run survives a loss of its unit.
    pub after_loss: Option<AfterLoss>,
}

/// What it does after a loss.
#[derive(Debug, Clone, Copy)]
pub struct AfterLoss {
    pub waits_for_operator: bool,
    pub patience: Option<Duration>,
}

impl Plan {
    pub fn firing(timing: TimingSettings) -> Self {
        Self {
            timing,
            mode: Mode::Firing,
            overload: OverloadPolicy::Shed,
            journal: Journal::none(),
            after_loss: None,
        }
    }

    pub fn armed(timing: TimingSettings) -> Self {
        Self { mode: Mode::Armed, ..Self::firing(timing) }
    }
}

/// A journal on a disk without space; written until the writer is dropped.
pub fn without_room(folder: &Path) -> (Journal, impl Drop) {
    struct Writer(Option<lfpiv_rawlog::RawLogWriter>);
    impl Drop for Writer {
        fn drop(&mut self) {
            self.0.take().unwrap().close().unwrap();
        }
    }
    let settings = RawLogSettings { reserve_mb: 1 << 40, ..RawLogSettings::default() };
    let (log, writer) = RawLog::create(&folder.join("raw"), b"{}", &settings).unwrap();
    (Journal::new(log), Writer(Some(writer)))
}

type Ended = Result<AcquisitionReport, AcquisitionError>;

/// A run in progress, on its own task.
pub struct Run {
    pub control: Control,
    pub stop: CancellationToken,
    pub synchroniser: SynchroniserThread,
    pub ledger: Arc<Mutex<Ledger>>,
    panic: Arc<Notify>,
    task: JoinHandle<Ended>,
    /// Held, but never read.
    _shots: ShotReceiver,
}

impl Run {
    /// Starts a run whose synchroniser thread is also owned by the test.
    pub fn start(laser: &Laser, plan: Plan) -> Self {
        let synchroniser = SynchroniserThread::default();
        let (rate_hz, overload) = (15.0, plan.overload);
        let settings = AcquisitionSettings {
            schedule: PulseSchedule::plan(&plan.timing, 100.0, rate_hz).unwrap(),
            shots: None::<NonZeroU64>,
            overload,
            patience: PATIENCE,
            frame_bytes: 8,
        };
        let bench = laser.connect(&plan, settings.frame_interval());
        let (sender, shots) = shot_queue(QUEUE);
        let stop = CancellationToken::new();
        let (control, inbox) = control(plan.mode, 100.0, Box::new(|_| Err("fixed".to_owned())));
        let ledger = Arc::new(Mutex::new(Ledger::new(CAMERAS)));
        let links = AcquisitionLinks {
            control: inbox,
            journal: plan.journal,
            synchroniser: synchroniser.clone(),
            ..AcquisitionLinks::new(ledger.clone(), sender, stop.clone())
        };
        let panic = Arc::new(Notify::new());
        let told = panic.clone();
        let task = tokio::spawn(async move {
            tokio::select! {
                ended = acquire(bench, settings, links) => ended,
                () = told.notified() => panic!("injected"),
            }
        });
        Self { control, stop, synchroniser, ledger, panic, task, _shots: shots }
    }

    pub async fn until(&self, what: &str, reached: impl Fn() -> bool) {
        let begun = Instant::now();
        while !reached() {
            let waited = begun.elapsed();
            assert!(waited < PATIENCE, "{what}: not in {waited:?}: {:?}", self.control.state());
            assert!(!self.task.is_finished(), "{what}: the run is over");
            tokio::time::sleep(Duration::from_millis(2)).await;
        }
    }

    /// Makes the task panic.
    pub async fn panic(self) -> SynchroniserThread {
        self.panic.notify_one();
        assert!(self.task.await.unwrap_err().is_panic());
        self.synchroniser
    }

    pub async fn end(self) -> Ended {
        tokio::time::timeout(PATIENCE, self.task).await.expect("the run ends").unwrap()
    }
}
