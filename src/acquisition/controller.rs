//! The run loop: bursts out, frames in, shots on.

use std::{collections::VecDeque, sync::Arc, thread::JoinHandle, time::Instant};

use lfpiv_hw::device::{Camera, Synchroniser, SynchroniserState};
use parking_lot::Mutex;
use tokio::sync::mpsc;
use tokio_util::sync::{CancellationToken, DropGuard};

use super::{
    AcquisitionError, AcquisitionSettings, Ledger, Shot,
    absence::Presence,
    devices::{CameraEvent, SynchroniserThread, join, spawn_camera},
    pairing::{FrameCounters, Pairing, PairingSettings},
};

/// The instruments, opened and idle.
pub struct Bench {
    /// In the order of the configuration.
    pub cameras: Vec<Box<dyn Camera>>,
    /// The unit that triggers them.
    pub synchroniser: Box<dyn Synchroniser>,
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
/// Makes the synchroniser safe and reads it back: the first thing a run does, before anything
/// that takes time. What an earlier run left behind must not fire while tables are built.
///
/// # Errors
///
/// [`AcquisitionError::NotSafe`].
pub async fn secure(bench: Bench) -> Result<Bench, AcquisitionError> {
    let Bench { cameras, mut synchroniser } = bench;
    let secured = tokio::task::spawn_blocking(move || {
        let made = synchroniser.make_safe();
        let state = synchroniser.state();
        (synchroniser, made, state)
    });
    let (synchroniser, made, state) = secured.await.map_err(|error| not_safe(error.to_string()))?;
    confirm_safe(made, state)?;
    Ok(Bench { cameras, synchroniser })
}

/// Safe is what is read back as safe; an error on the way there is not.
fn confirm_safe<E: std::fmt::Display>(
    made: Result<(), E>,
    state: Result<SynchroniserState, E>,
) -> Result<(), AcquisitionError> {
    match (made, state) {
        (Ok(()), Ok(SynchroniserState::Safe)) => Ok(()),
        (Err(error), _) | (_, Err(error)) => Err(not_safe(error.to_string())),
        (Ok(()), Ok(state)) => Err(not_safe(format!("it reads back {state:?}"))),
    }
}

fn not_safe(reason: String) -> AcquisitionError {
    tracing::error!(reason, "state unknown: use the hardware interlock");
    AcquisitionError::NotSafe { reason, before: None }
}

/// Takes shots until `settings.shots` triggers are given or `stop` is cancelled, and sends them,
/// paired, into `queue`. What becomes of each trigger is written to `ledger`; shots that were sent
/// on are settled by whoever takes them from the queue.
///
/// # Errors
///
/// See [`AcquisitionError`]. In every case the synchroniser is made safe first, then the cameras
/// are stopped, then the open triggers are ruled on.
pub async fn acquire(
    bench: Bench,
    settings: AcquisitionSettings,
    ledger: Arc<Mutex<Ledger>>,
    queue: mpsc::Sender<Shot>,
    stop: CancellationToken,
) -> Result<AcquisitionReport, AcquisitionError> {
    let mut run = Run::start(bench, settings, ledger, queue, stop)?;
    let ended = run.take_shots().await;
    let closed = run.close().await;
    // What ended the run matters more than what went wrong afterwards, except for the laser.
    match (ended, closed) {
        (Err(error), Err(AcquisitionError::NotSafe { reason, .. })) => {
            Err(AcquisitionError::NotSafe { reason, before: Some(Box::new(error)) })
        }
        (Err(error), _) => Err(error),
        (Ok(()), closed) => closed,
    }
}

/// A run under way; `burst.rs` fires, `rulings.rs` deals with what comes of it.
pub(super) struct Run {
    pub(super) settings: AcquisitionSettings,
    pub(super) ledger: Arc<Mutex<Ledger>>,
    pub(super) queue: mpsc::Sender<Shot>,
    /// Places in the queue that are kept for triggers to come ([`OverloadPolicy::Wait`]).
    pub(super) places: VecDeque<mpsc::OwnedPermit<Shot>>,
    pub(super) stop: CancellationToken,
    pub(super) synchroniser: SynchroniserThread,
    /// Not started yet: the laser is disabled before anything else is touched.
    idle_cameras: Vec<Box<dyn Camera>>,
    cameras: Vec<JoinHandle<()>>,
    stop_cameras: CancellationToken,
    /// Stops the cameras' threads when the run is dropped half-way.
    _stop_on_drop: DropGuard,
    event_sender: Option<mpsc::Sender<CameraEvent>>,
    pub(super) events: mpsc::Receiver<CameraEvent>,
    pub(super) pairing: Pairing,
    pub(super) identity: String,
    pub(super) began: Instant,
    pub(super) last_frame: Instant,
    pub(super) fired: u64,
    /// The unit's count when it was programmed; `None` from a unit that does not count.
    pub(super) first_count: Option<u64>,
    /// Triggers given before that.
    pub(super) given_before: u64,
    /// Whether each camera is there.
    pub(super) presence: Vec<Presence>,
}

impl Run {
    fn start(
        bench: Bench,
        settings: AcquisitionSettings,
        ledger: Arc<Mutex<Ledger>>,
        queue: mpsc::Sender<Shot>,
        stop: CancellationToken,
    ) -> Result<Self, AcquisitionError> {
        let count = bench.cameras.len();
        // First of all: from here on the unit is made safe whatever happens.
        let synchroniser = SynchroniserThread::spawn(bench.synchroniser)?;
        let stop_cameras = CancellationToken::new();
        let (sender, events) = mpsc::channel(EVENT_QUEUE);
        let pairing = Pairing::new(PairingSettings {
            cameras: count,
            period_ns: u64::try_from(settings.period().as_nanos()).unwrap_or(u64::MAX),
            frame_interval_ns: settings.frame_interval().as_nanos() as u64,
            frame_interval_tolerance_ns: FRAME_INTERVAL_TOLERANCE_NS,
            patience: settings.patience,
        });
        Ok(Self {
            settings,
            ledger,
            queue,
            places: VecDeque::new(),
            stop,
            synchroniser,
            idle_cameras: bench.cameras,
            cameras: Vec::new(),
            _stop_on_drop: stop_cameras.clone().drop_guard(),
            stop_cameras,
            event_sender: Some(sender),
            events,
            pairing,
            identity: String::new(),
            began: Instant::now(),
            last_frame: Instant::now(),
            fired: 0,
            first_count: None,
            given_before: 0,
            presence: vec![Presence::default(); count],
        })
    }

    /// Everything up to the last shot.
    async fn take_shots(&mut self) -> Result<(), AcquisitionError> {
        self.make_safe().await?;
        self.identity = self.synchroniser.call(|unit| unit.identify()).await?;
        self.program().await?;
        self.start_cameras().await?;
        self.settings.heartbeat.beat();
        while let Some(shots) = self.next_burst().await? {
            self.run_burst(shots).await?;
        }
        Ok(())
    }

    /// Writes the schedule; from here on the unit's count starts anew.
    pub(super) async fn program(&mut self) -> Result<(), AcquisitionError> {
        let schedule = self.settings.schedule.clone();
        self.synchroniser.call(move |unit| unit.program(&schedule)).await?;
        self.first_count = self.synchroniser.call(|unit| unit.trigger_count()).await?;
        self.given_before = self.fired;
        Ok(())
    }

    /// A thread per camera; returns once all of them wait for triggers.
    async fn start_cameras(&mut self) -> Result<(), AcquisitionError> {
        let Some(events) = self.event_sender.take() else { return Ok(()) };
        for (index, camera) in std::mem::take(&mut self.idle_cameras).into_iter().enumerate() {
            self.cameras.push(spawn_camera(
                index,
                camera,
                events.clone(),
                self.stop_cameras.clone(),
            )?);
        }
        drop(events);
        for _ in 0..self.cameras.len() {
            let event = self.events.recv().await;
            self.handle(event)?;
        }
        Ok(())
    }

    /// Laser first, cameras second, books last.
    async fn close(mut self) -> Result<AcquisitionReport, AcquisitionError> {
        self.settings.heartbeat.beat();
        let safe = self.make_safe().await;
        self.stop_cameras.cancel();
        drop(self.event_sender.take());
        // The channel ends with the camera threads; what was on its way still counts.
        while let Some(event) = self.events.recv().await {
            self.handle_leftover(event);
        }
        for camera in std::mem::take(&mut self.cameras) {
            join(camera).await;
        }
        self.places.clear();
        let rulings = self.pairing.finish();
        let ruled = self.apply(rulings);
        self.synchroniser.close().await;
        self.settings.heartbeat.rest();
        safe.and(ruled)?;
        Ok(AcquisitionReport {
            synchroniser: self.identity,
            triggers: self.fired,
            frames: self.pairing.counters(),
        })
    }

    /// Safe, and read back.
    pub(super) async fn make_safe(&mut self) -> Result<(), AcquisitionError> {
        let made = self.synchroniser.call(|unit| unit.make_safe()).await;
        let state = self.synchroniser.call(|unit| unit.state()).await;
        confirm_safe(made, state)
    }
}
