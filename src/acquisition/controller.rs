//! The run: its parts, its beginning and its end.

use std::{sync::Arc, thread::JoinHandle, time::Duration};

use lfpiv_hw::{
    device::{Camera, Synchroniser},
    synchroniser::line,
};
use parking_lot::Mutex;
use tokio::sync::mpsc;
use tokio_util::sync::{CancellationToken, DropGuard};

use super::{
    AcquisitionError, AcquisitionSettings, BurstScript, ControlInbox, Heartbeat, HostClock,
    Journal, Ledger, Mode, RunClock, ShotSender, SynchroniserThread,
    bench_loss::{Loss, Reconnection, Waiting},
    control::control,
    devices::{CameraEvent, join, spawn_camera},
    journal::Entry,
    pairing::{FrameCounters, Pairing, PairingSettings},
    presence::Presence,
    synchroniser::SynchroniserCalls,
    trigger_times::TriggerTimes,
};

/// The instruments, opened and idle.
pub struct Bench {
    /// In the order of the configuration.
    pub cameras: Vec<Box<dyn Camera>>,
    /// The unit that triggers them.
    pub synchroniser: Box<dyn Synchroniser>,
    /// What goes over the unit's line, to be recorded.
    pub transcript: Option<mpsc::UnboundedReceiver<line::Entry>>,
    /// How the unit is had again once it is lost; the run ends then when absent.
    pub reconnection: Option<Reconnection>,
}

impl Bench {
    /// A bench without a line that could be listened to, or be lost.
    pub fn new(cameras: Vec<Box<dyn Camera>>, synchroniser: Box<dyn Synchroniser>) -> Self {
        Self { cameras, synchroniser, transcript: None, reconnection: None }
    }
}

/// What acquisition shares with the rest of the daemon.
pub struct AcquisitionLinks {
    /// What becomes of each trigger.
    pub ledger: Arc<Mutex<Ledger>>,
    /// Where paired shots go.
    pub queue: ShotSender,
    /// The run's own record.
    pub journal: Journal,
    /// By which frames are due and late.
    pub clock: Arc<dyn RunClock>,
    /// Decides the bursts of a run that is played again; the run loop does when absent.
    pub bursts: Option<Arc<dyn BurstScript>>,
    /// What is asked of the run under way.
    pub control: ControlInbox,
    /// Beats while the run loop turns.
    pub heartbeat: Heartbeat,
    /// Owns the synchroniser's thread. Whoever keeps a clone outside the task of [`acquire`] can
    /// wait for the safe state whatever becomes of the task.
    pub synchroniser: SynchroniserThread,
    /// Ends the run.
    pub stop: CancellationToken,
}

impl AcquisitionLinks {
    /// A run that keeps no record, goes by the host's clock and cannot be controlled.
    pub fn new(ledger: Arc<Mutex<Ledger>>, queue: ShotSender, stop: CancellationToken) -> Self {
        let fixed = Box::new(|_| Err("the schedule of this run is fixed".to_owned()));
        let (_, control) = control(Mode::Firing, 0.0, fixed);
        Self {
            ledger,
            queue,
            journal: Journal::none(),
            clock: Arc::new(HostClock::start()),
            bursts: None,
            control,
            heartbeat: Heartbeat::default(),
            synchroniser: SynchroniserThread::default(),
            stop,
        }
    }
}

/// What acquisition has to tell when it ends.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AcquisitionReport {
    /// The synchroniser's identity string.
    pub synchroniser: String,
    /// Triggers given.
    pub triggers: u64,
    /// Frames counted.
    pub frames: FrameCounters,
}

/// Frames that may wait between a camera's thread and the run loop.
const EVENT_QUEUE: usize = 8;
/// How far a frame interval may be off, in ns: a camera's timestamps are good to some µs.
const FRAME_INTERVAL_TOLERANCE_NS: u64 = 20_000;

/// Takes shots until `settings.shots` triggers are given or the run is stopped, and sends them,
/// paired, into the queue. What becomes of each trigger is written to the ledger, and everything
/// that is seen to the journal; shots that were sent on are settled by whoever takes them from the
/// queue.
///
/// # Errors
///
/// See [`AcquisitionError`]. In every case the synchroniser is made safe first, then the cameras
/// are stopped, then the open triggers are ruled on.
pub async fn acquire(
    bench: Bench,
    settings: AcquisitionSettings,
    links: AcquisitionLinks,
) -> Result<AcquisitionReport, AcquisitionError> {
    let mut run = Run::start(bench, settings, links)?;
    let ended = run.take_shots().await;
    let closed = run.close(ended.as_ref().err()).await;
    // What ended the run matters more than what went wrong afterwards, except for the laser.
    match (ended, closed) {
        (Err(error), Err(AcquisitionError::NotSafe { reason, is_lost, .. })) => {
            Err(AcquisitionError::NotSafe { reason, is_lost, before: Some(Box::new(error)) })
        }
        (Err(error), _) => Err(error),
        (Ok(()), closed) => closed,
    }
}

/// A run under way; `burst.rs` fires, `requests.rs` obeys, `rulings.rs` deals with what comes of
/// it, `record.rs` writes it down, `absence.rs` and `bench_loss.rs` wait for what has vanished.
pub(super) struct Run {
    pub(super) settings: AcquisitionSettings,
    pub(super) ledger: Arc<Mutex<Ledger>>,
    pub(super) queue: ShotSender,
    pub(super) journal: Journal,
    /// The raw log has failed, and the run is ending for it.
    pub(super) log_failed: bool,
    pub(super) clock: Arc<dyn RunClock>,
    pub(super) bursts: Option<Arc<dyn BurstScript>>,
    pub(super) control: ControlInbox,
    pub(super) transcript: Option<mpsc::UnboundedReceiver<line::Entry>>,
    pub(super) heartbeat: Heartbeat,
    pub(super) stop: CancellationToken,
    pub(super) synchroniser: SynchroniserCalls,
    synchroniser_thread: SynchroniserThread,
    /// Not started yet: the laser is disabled before anything else is touched.
    idle_cameras: Vec<Box<dyn Camera>>,
    cameras: Vec<JoinHandle<()>>,
    stop_cameras: CancellationToken,
    /// Stops the cameras' threads when the run is dropped half-way.
    _stop_on_drop: DropGuard,
    event_sender: Option<mpsc::Sender<CameraEvent>>,
    pub(super) events: mpsc::Receiver<CameraEvent>,
    pub(super) pairing: Pairing,
    pub(super) times: TriggerTimes,
    pub(super) identity: String,
    /// The time of what was seen last.
    pub(super) time: Duration,
    pub(super) last_frame: Duration,
    pub(super) fired: u64,
    /// The unit's count when it was programmed; `None` from a unit that does not count.
    pub(super) first_count: Option<u64>,
    /// Triggers given before that.
    pub(super) given_before: u64,
    /// The unit was made safe since, or another schedule is asked for.
    pub(super) is_programmed: bool,
    /// A burst was fired, and its triggers have not been counted.
    pub(super) is_burst_open: bool,
    /// The unit was told to begin it.
    pub(super) is_burst_begun: bool,
    /// The lamps fire although no shots are taken.
    pub(super) is_armed: bool,
    /// The burst that runs was ended before its time.
    pub(super) broken_off: bool,
    /// When the burst that was fired last should be over.
    pub(super) burst_ends: Duration,
    /// Whether each camera is there.
    pub(super) presence: Vec<Presence>,
    /// Whether and how a synchroniser that is lost is waited for.
    pub(super) waiting: Option<Waiting>,
    /// It is lost.
    pub(super) loss: Option<Loss>,
    /// It was, and an operator has not said yet that the run may do this again.
    pub(super) awaits_operator: Option<Mode>,
}

impl Run {
    fn start(
        bench: Bench,
        settings: AcquisitionSettings,
        links: AcquisitionLinks,
    ) -> Result<Self, AcquisitionError> {
        let count = bench.cameras.len();
        let AcquisitionLinks {
            ledger,
            queue,
            journal,
            clock,
            bursts,
            control,
            heartbeat,
            synchroniser: synchroniser_thread,
            stop,
        } = links;
        // First of all: from here on the unit is made safe whatever happens.
        let (waiting, reopen) = match bench.reconnection {
            Some(Reconnection { open, patience, waits_for_operator }) => {
                (Some(Waiting { patience, waits_for_operator }), Some(open))
            }
            None => (None, None),
        };
        let synchroniser = synchroniser_thread.start(bench.synchroniser, reopen)?;
        let stop_cameras = CancellationToken::new();
        let (sender, events) = mpsc::channel(EVENT_QUEUE);
        let pairing = Pairing::new(pairing_settings(&settings, count));
        control.state.lock().dt_us = settings.schedule.dt_us;
        Ok(Self {
            settings,
            ledger,
            queue,
            journal,
            log_failed: false,
            clock,
            bursts,
            control,
            transcript: bench.transcript,
            heartbeat,
            stop,
            synchroniser,
            synchroniser_thread,
            idle_cameras: bench.cameras,
            cameras: Vec::new(),
            _stop_on_drop: stop_cameras.clone().drop_guard(),
            stop_cameras,
            event_sender: Some(sender),
            events,
            pairing,
            times: TriggerTimes::default(),
            identity: String::new(),
            time: Duration::ZERO,
            last_frame: Duration::ZERO,
            fired: 0,
            first_count: None,
            given_before: 0,
            is_programmed: false,
            is_burst_open: false,
            is_burst_begun: false,
            is_armed: false,
            broken_off: false,
            burst_ends: Duration::ZERO,
            presence: vec![Presence::default(); count],
            waiting,
            loss: None,
            awaits_operator: None,
        })
    }

    /// Everything up to the last shot, and beyond losses of the synchroniser.
    async fn take_shots(&mut self) -> Result<(), AcquisitionError> {
        let mut ended = self.begin().await;
        loop {
            ended = match ended {
                Ok(true) => self.turn().await,
                Ok(false) => return Ok(()),
                Err(error) if self.may_wait(&error) => self.await_bench(error).await,
                Err(error) => return Err(error),
            };
        }
    }

    async fn begin(&mut self) -> Result<bool, AcquisitionError> {
        self.make_safe().await?;
        self.identity = self.synchroniser.call(|unit| unit.identify()).await?;
        self.program().await?;
        Ok(true)
    }

    /// One burst; false when there is none left.
    async fn turn(&mut self) -> Result<bool, AcquisitionError> {
        self.start_cameras().await?;
        let Some(shots) = self.next_burst().await? else { return Ok(false) };
        self.run_burst(shots).await?;
        Ok(true)
    }

    /// Writes the schedule; from here on the unit's count starts anew.
    pub(super) async fn program(&mut self) -> Result<(), AcquisitionError> {
        let schedule = self.settings.schedule.clone();
        self.synchroniser.call(move |unit| unit.program(&schedule)).await?;
        self.first_count = self.synchroniser.call(|unit| unit.trigger_count()).await?;
        self.given_before = self.fired;
        self.is_programmed = true;
        self.pairing.rescheduled(pairing_settings(&self.settings, self.presence.len()));
        let (identity, schedule) = (self.identity.clone(), self.settings.schedule.clone());
        self.note(Entry::Programmed { at_ns: self.at_ns(), identity, schedule }).await?;
        Ok(())
    }

    /// A thread per camera, once; returns when all of them wait for triggers.
    async fn start_cameras(&mut self) -> Result<(), AcquisitionError> {
        let Some(events) = self.event_sender.take() else { return Ok(()) };
        for (index, camera) in std::mem::take(&mut self.idle_cameras).into_iter().enumerate() {
            let (events, clock) = (events.clone(), self.clock.clone());
            let stop = self.stop_cameras.clone();
            self.cameras.push(spawn_camera(index, camera, events, clock, stop)?);
        }
        drop(events);
        let mut waiting = self.cameras.len();
        while waiting > 0 {
            let event = self.events.recv().await;
            waiting -= usize::from(matches!(event, Some(CameraEvent::Started { .. })));
            self.handle(event).await?;
        }
        self.heartbeat.beat();
        Ok(())
    }

    /// Laser first, cameras second, books last.
    async fn close(
        mut self,
        error: Option<&AcquisitionError>,
    ) -> Result<AcquisitionReport, AcquisitionError> {
        self.control.state.lock().mode = Mode::Stopping;
        let safe = self.make_safe().await;
        self.stop_cameras.cancel();
        drop(self.event_sender.take());
        // The channel ends with the camera threads; what was on its way still counts.
        while let Some(event) = self.events.recv().await {
            self.handle_leftover(event).await;
        }
        for camera in std::mem::take(&mut self.cameras) {
            join(camera).await;
        }
        // What was asked for and not given any more is no trigger. Where the unit cannot be asked,
        // pairing goes by what the cameras saw, and by what was due.
        if self.is_burst_open
            && self.loss.is_none()
            && safe.is_ok()
            && let Err(error) = self.try_end_burst().await
        {
            tracing::warn!(%error, "the last burst could not be counted");
        }
        let rulings = self.pairing.finish();
        let ruled = self.apply(rulings).await;
        let error = error.map(ToString::to_string);
        let noted = self.note(Entry::Ended { at_ns: self.at_ns(), error }).await;
        let left = self.synchroniser_thread.join().await;
        self.heartbeat.rest();
        safe.and(left).and(ruled).and(noted.map(|_| ()))?;
        Ok(AcquisitionReport {
            synchroniser: self.identity,
            triggers: self.fired,
            frames: self.pairing.counters(),
        })
    }

    /// Safe, and read back. The schedule has to be programmed anew after this.
    pub(super) async fn make_safe(&mut self) -> Result<(), AcquisitionError> {
        (self.is_programmed, self.is_armed) = (false, false);
        self.synchroniser.make_safe().await
    }
}

fn pairing_settings(settings: &AcquisitionSettings, cameras: usize) -> PairingSettings {
    PairingSettings {
        cameras,
        period_ns: u64::try_from(settings.period().as_nanos()).unwrap_or(u64::MAX),
        frame_interval_ns: settings.frame_interval().as_nanos() as u64,
        frame_interval_tolerance_ns: FRAME_INTERVAL_TOLERANCE_NS,
        dt_us: settings.schedule.dt_us,
        patience: settings.patience,
    }
}
