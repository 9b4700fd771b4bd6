//! The run: its parts, start and end.

use std::{sync::Arc, thread::JoinHandle, time::Duration};

use lfpiv_hw::{device::Camera, synchroniser::line};
use parking_lot::Mutex;
use tokio::sync::mpsc;
use tokio_util::sync::{CancellationToken, DropGuard};

use super::{
    AcquisitionError, AcquisitionSettings, BurstScript, ControlInbox, Heartbeat, HostClock,
    Journal, Ledger, Mode, RunClock, ShotSender, SynchroniserThread,
    bench::{Bench, Reconnection, SearchPolicy},
    control::control,
    devices::{CameraEvent, join, spawn_camera},
    journal::Entry,
    loss::Loss,
    pairing::{FrameCounters, Pairing, PairingSettings},
    presence::Presence,
    synchroniser::SynchroniserCalls,
    trigger_times::TriggerTimes,
};

/// What acquisition shares with the rest of the daemon.
pub struct AcquisitionLinks {
    /// Receives the outcome of each trigger.
    pub ledger: Arc<Mutex<Ledger>>,
    /// Receives paired shots.
    pub queue: ShotSender,
    /// The record of the run.
    pub journal: Journal,
    /// Decides when frames are due and late.
    pub clock: Arc<dyn RunClock>,
    /// Decides the bursts of a replay; absent in a live run.
    pub bursts: Option<Arc<dyn BurstScript>>,
    /// Requests to the run.
    pub control: ControlInbox,
    /// Beats while the run loop is alive.
    pub heartbeat: Heartbeat,
    /// Owns the synchroniser's thread. A clone held outside the task of [`acquire`] can wait for
    /// the safe state whatever happens to that task.
    pub synchroniser: SynchroniserThread,
    /// Ends the run.
    pub stop: CancellationToken,
}

impl AcquisitionLinks {
    /// A run without record and control, on the host's clock.
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

/// Summary of a finished acquisition.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AcquisitionReport {
    /// The synchroniser's identity string.
    pub synchroniser: String,
    /// Triggers given.
    pub triggers: u64,
    /// Frames counted.
    pub frames: FrameCounters,
}

/// Capacity of the channel from a camera's thread to the run loop.
const EVENT_QUEUE: usize = 8;
/// Tolerance of a frame interval, in ns; camera timestamps are accurate to some µs.
const FRAME_INTERVAL_TOLERANCE_NS: u64 = 20_000;

/// Takes shots until `settings.shots` triggers are given or the run is stopped, and sends paired
/// shots to the queue. The ledger receives the outcome of each trigger and the journal every event;
/// the receiver of the queue settles the shots that it takes.
///
/// # Errors
///
/// See [`AcquisitionError`]. In every case the synchroniser is made safe first, then the cameras are
/// stopped, then open triggers are settled.
pub async fn acquire(
    bench: Bench,
    settings: AcquisitionSettings,
    links: AcquisitionLinks,
) -> Result<AcquisitionReport, AcquisitionError> {
    let mut run = Run::start(bench, settings, links)?;
    let ended = run.take_shots().await;
    let closed = run.close(ended.as_ref().err()).await;
    // The error that ended the run has precedence over later ones, except one about the laser.
    match (ended, closed) {
        (Err(error), Err(AcquisitionError::NotSafe { reason, is_lost, .. })) => {
            Err(AcquisitionError::NotSafe { reason, is_lost, before: Some(Box::new(error)) })
        }
        (Err(error), _) => Err(error),
        (Ok(()), closed) => closed,
    }
}

/// A run in progress. `burst.rs` fires, `requests.rs` handles requests, `decisions.rs` applies
/// pairing decisions, `record.rs` writes the journal, `absence.rs` and `bench_loss.rs` wait for lost
/// devices.
pub(super) struct Run {
    pub(super) settings: AcquisitionSettings,
    pub(super) ledger: Arc<Mutex<Ledger>>,
    pub(super) queue: ShotSender,
    pub(super) journal: Journal,
    /// The raw log has failed, which ends the run.
    pub(super) log_failed: bool,
    pub(super) clock: Arc<dyn RunClock>,
    pub(super) bursts: Option<Arc<dyn BurstScript>>,
    pub(super) control: ControlInbox,
    pub(super) transcript: Option<mpsc::UnboundedReceiver<line::TranscriptEntry>>,
    pub(super) heartbeat: Heartbeat,
    pub(super) stop: CancellationToken,
    pub(super) synchroniser: SynchroniserCalls,
    synchroniser_thread: SynchroniserThread,
    /// Not started yet: the laser is disabled before any camera is used.
    idle_cameras: Vec<Box<dyn Camera>>,
    cameras: Vec<JoinHandle<()>>,
    stop_cameras: CancellationToken,
    /// Stops the camera threads if the run is dropped early.
    _stop_on_drop: DropGuard,
    event_sender: Option<mpsc::Sender<CameraEvent>>,
    pub(super) events: mpsc::Receiver<CameraEvent>,
    pub(super) pairing: Pairing,
    pub(super) times: TriggerTimes,
    pub(super) identity: String,
    /// Time of the last event.
    pub(super) time: Duration,
    pub(super) last_frame: Duration,
    pub(super) fired: u64,
    /// Trigger count of the unit when it was programmed; `None` without a counter.
    pub(super) first_count: Option<u64>,
    /// Triggers given before that.
    pub(super) given_before: u64,
    /// False once the unit was made safe or another schedule was requested.
    pub(super) is_programmed: bool,
    /// A burst was fired, and its triggers have not been counted.
    pub(super) is_burst_open: bool,
    /// The unit was told to start it.
    pub(super) is_burst_accepted: bool,
    /// The lamps fire although no shots are taken.
    pub(super) is_armed: bool,
    /// The current burst was ended early.
    pub(super) is_aborted: bool,
    /// The unit was made safe during a burst, and pairing has not been told yet.
    pub(super) is_switching_off: bool,
    /// When the last burst should be over.
    pub(super) burst_ends: Duration,
    /// Connection state of each camera.
    pub(super) presence: Vec<Presence>,
    /// Whether and how to wait for a lost synchroniser.
    pub(super) waiting: Option<SearchPolicy>,
    /// Present while the synchroniser is lost.
    pub(super) loss: Option<Loss>,
    /// The mode to resume once an operator permits it.
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
                (Some(SearchPolicy { patience, waits_for_operator }), Some(open))
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
            is_burst_accepted: false,
            is_armed: false,
            is_aborted: false,
            is_switching_off: false,
            burst_ends: Duration::ZERO,
            presence: vec![Presence::default(); count],
            waiting,
            loss: None,
            awaits_operator: None,
        })
    }

    /// Takes all shots, surviving losses of the synchroniser.
    async fn take_shots(&mut self) -> Result<(), AcquisitionError> {
        let mut ended = self.begin().await;
        loop {
            ended = match ended {
                Ok(true) => self.turn().await,
                Ok(false) => return Ok(()),
                Err(error) if self.survives(&error) => self.await_bench(error).await,
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

    /// Runs one burst; false when there is none left.
    async fn turn(&mut self) -> Result<bool, AcquisitionError> {
        self.start_cameras().await?;
        let Some(shots) = self.next_burst().await? else { return Ok(false) };
        self.run_burst(shots).await?;
        Ok(true)
    }

    /// Programs the schedule; the unit's trigger count restarts here.
    pub(super) async fn program(&mut self) -> Result<(), AcquisitionError> {
        let schedule = self.settings.schedule.clone();
        self.synchroniser.call(move |unit| unit.program(&schedule)).await?;
        self.first_count = self.synchroniser.call(|unit| unit.trigger_count()).await?;
        self.given_before = self.fired;
        self.is_programmed = true;
        self.pairing.rescheduled(pairing_settings(&self.settings, self.presence.len()));
        let (identity, schedule) = (self.identity.clone(), self.settings.schedule.clone());
        self.record(Entry::Programmed { at_ns: self.at_ns(), identity, schedule }).await?;
        Ok(())
    }

    /// Starts a thread per camera, once; returns when all of them wait for triggers.
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

    /// Ends the run: laser first, cameras second, ledger last.
    async fn close(
        mut self,
        error: Option<&AcquisitionError>,
    ) -> Result<AcquisitionReport, AcquisitionError> {
        self.control.state.lock().mode = Mode::Stopping;
        let safe = self.make_safe().await;
        let noted = self.note_switching_off().await;
        self.stop_cameras.cancel();
        drop(self.event_sender.take());
        // The channel closes with the camera threads; frames in transit still count.
        while let Some(event) = self.events.recv().await {
            self.handle_leftover(event).await;
        }
        for camera in std::mem::take(&mut self.cameras) {
            join(camera).await;
        }
        // Triggers that were requested but not given do not count. If the unit cannot be asked, pairing
        // uses the frames and the schedule.
        if self.is_burst_open
            && self.loss.is_none()
            && safe.is_ok()
            && let Err(error) = self.try_end_burst().await
        {
            tracing::warn!(%error, "the last burst could not be counted");
        }
        let decisions = self.pairing.finish();
        let settled = self.apply(decisions).await;
        let error = error.map(ToString::to_string);
        let recorded = self.record(Entry::Ended { at_ns: self.at_ns(), error }).await;
        let left = self.synchroniser_thread.join().await;
        self.heartbeat.rest();
        safe.and(left).and(noted).and(settled).and(recorded.map(|_| ()))?;
        Ok(AcquisitionReport {
            synchroniser: self.identity,
            triggers: self.fired,
            frames: self.pairing.counters(),
        })
    }

    /// Makes the unit safe and reads it back. The schedule must be programmed again after this.
    pub(super) async fn make_safe(&mut self) -> Result<(), AcquisitionError> {
        (self.is_programmed, self.is_armed) = (false, false);
        // In a replay the record says when the laser was switched off.
        let is_live = self.bursts.is_none();
        self.is_switching_off |= is_live && self.is_burst_open && self.is_burst_accepted;
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
