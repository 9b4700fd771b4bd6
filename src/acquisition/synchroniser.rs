//! The synchroniser on a thread of its own, which outlives whatever asks it.
//!
//! The run loop holds [`SynchroniserCalls`], and may panic. The thread belongs to whoever holds
//! [`SynchroniserThread`], outside the run loop's task: when nobody calls any more, or when it is
//! told to end, the thread makes the unit safe, reads that back and ends, and its owners wait for
//! it. So the process does not end in the middle of the commands that make the laser safe.

use std::{
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
        mpsc as std_mpsc,
    },
    thread::JoinHandle,
    time::{Duration, Instant},
};

use lfpiv_hw::device::{DeviceError, Synchroniser, SynchroniserState, WATCH_INTERVAL};
use parking_lot::{Condvar, Mutex};
use tokio::sync::{Notify, oneshot};

use super::{AcquisitionError, Bench, devices::guarded};

/// How late the thread notices that it should end.
const TICK: Duration = Duration::from_millis(50);
/// For messages, and the thread's name.
const SYNCHRONISER: &str = "synchroniser";

/// How the unit was left: safe and read back so, or why not.
type Left = Result<(), String>;

/// Owns the synchroniser's thread. Clones own the same one; the last to go waits for it.
#[derive(Clone, Default)]
pub struct SynchroniserThread(Arc<Owned>);

#[derive(Default)]
struct Owned {
    thread: Mutex<Option<JoinHandle<()>>>,
    shared: Arc<Shared>,
}

/// What the thread and its owners share.
#[derive(Default)]
struct Shared {
    started: AtomicBool,
    /// The thread should end.
    ending: AtomicBool,
    left: Mutex<Option<Left>>,
    has_left: Condvar,
    /// What [`Synchroniser::watch`] found, for the run loop.
    fault: Mutex<Option<DeviceError>>,
    found_fault: Notify,
}

impl SynchroniserThread {
    /// Puts the unit on the thread. From here on it is made safe whatever happens.
    pub(super) fn start(
        &self,
        device: Box<dyn Synchroniser>,
    ) -> Result<SynchroniserCalls, AcquisitionError> {
        let (orders, inbox) = std_mpsc::channel();
        let shared = self.0.shared.clone();
        let unit = Unit { device, is_safe: false, shared: shared.clone() };
        let thread = std::thread::Builder::new()
            .name(SYNCHRONISER.to_owned())
            .spawn(move || serve(unit, inbox))
            .map_err(|source| AcquisitionError::Thread { device: SYNCHRONISER.into(), source })?;
        *self.0.thread.lock() = Some(thread);
        self.0.shared.started.store(true, Ordering::SeqCst);
        Ok(SynchroniserCalls { orders, shared })
    }

    /// Ends the thread, safe state first, and waits for the read-back at most `limit`. At once
    /// where no unit was ever started.
    ///
    /// # Errors
    ///
    /// [`AcquisitionError::NotSafe`], also when it takes longer.
    pub fn make_safe_within(&self, limit: Duration) -> Result<(), AcquisitionError> {
        let shared = &self.0.shared;
        shared.ending.store(true, Ordering::SeqCst);
        if !shared.started.load(Ordering::SeqCst) {
            return Ok(());
        }
        let deadline = Instant::now() + limit;
        let mut left = shared.left.lock();
        while left.is_none() {
            if shared.has_left.wait_until(&mut left, deadline).timed_out() {
                let seconds = limit.as_secs_f64();
                return Err(not_safe(format!("it was not read back within {seconds:.1} s")));
            }
        }
        drop(left);
        self.0.left()
    }

    /// As [`Self::make_safe_within`], for as long as it takes and without blocking the runtime.
    ///
    /// # Errors
    ///
    /// [`AcquisitionError::NotSafe`].
    pub async fn join(&self) -> Result<(), AcquisitionError> {
        let owned = self.0.clone();
        let joined = tokio::task::spawn_blocking(move || owned.join()).await;
        joined.map_err(|error| not_safe(error.to_string()))?
    }
}

impl Owned {
    fn join(&self) -> Result<(), AcquisitionError> {
        self.shared.ending.store(true, Ordering::SeqCst);
        // Others may wait for it, too: the lock is held until it has ended.
        let mut thread = self.thread.lock();
        if let Some(thread) = thread.take()
            && thread.join().is_err()
        {
            tracing::error!(thread = SYNCHRONISER, "ended by a panic");
            self.shared.leave(Err("its thread panicked".to_owned()));
        }
        self.left()
    }

    fn left(&self) -> Result<(), AcquisitionError> {
        match &*self.shared.left.lock() {
            Some(Err(reason)) => Err(not_safe(reason.clone())),
            Some(Ok(())) | None => Ok(()),
        }
    }
}

impl Drop for Owned {
    /// Where a task is torn down, by its panic or with its runtime, nobody else waits.
    fn drop(&mut self) {
        // What came of it has been logged by the thread.
        let _ = self.join();
    }
}

impl Shared {
    fn leave(&self, left: Left) {
        if let Err(reason) = &left {
            tracing::error!(reason, "the synchroniser was not left safe");
        }
        *self.left.lock() = Some(left);
        self.has_left.notify_all();
    }
}

fn not_safe(reason: String) -> AcquisitionError {
    tracing::error!(reason, "state unknown: use the hardware interlock");
    AcquisitionError::NotSafe { reason, before: None }
}

/// The unit, on its thread.
struct Unit {
    device: Box<dyn Synchroniser>,
    /// It was read back as safe, and nothing has been asked of it since.
    is_safe: bool,
    shared: Arc<Shared>,
}

type Order = Box<dyn FnOnce(&mut Unit) + Send>;

/// Obeys, and looks after the unit in between; safe state last.
fn serve(mut unit: Unit, inbox: std_mpsc::Receiver<Order>) {
    let mut look = Instant::now() + WATCH_INTERVAL;
    while !unit.shared.ending.load(Ordering::SeqCst) {
        let wait = look.saturating_duration_since(Instant::now()).min(TICK);
        match inbox.recv_timeout(wait) {
            Ok(order) => order(&mut unit),
            Err(std_mpsc::RecvTimeoutError::Timeout) => {}
            Err(std_mpsc::RecvTimeoutError::Disconnected) => break,
        }
        if Instant::now() >= look {
            unit.watch();
            look = Instant::now() + WATCH_INTERVAL;
        }
    }
    let left = if unit.is_safe { Ok(()) } else { unit.make_safe() };
    unit.shared.leave(left);
}

impl Unit {
    fn call<T>(
        &mut self,
        call: impl FnOnce(&mut dyn Synchroniser) -> Result<T, DeviceError>,
    ) -> Result<T, DeviceError> {
        if let Some(fault) = self.shared.fault.lock().take() {
            return Err(fault);
        }
        self.is_safe = false;
        guarded(SYNCHRONISER, || call(self.device.as_mut()))
    }

    /// What it finds is told to whoever calls next or waits for it.
    fn watch(&mut self) {
        if let Err(fault) = guarded(SYNCHRONISER, || self.device.watch()) {
            *self.shared.fault.lock() = Some(fault);
            self.shared.found_fault.notify_one();
        }
    }

    fn make_safe(&mut self) -> Left {
        let left = make_safe(self.device.as_mut());
        self.is_safe = left.is_ok();
        left
    }
}

/// Safe is what is read back as safe; an error on the way there is not.
fn make_safe(device: &mut dyn Synchroniser) -> Left {
    let made = guarded(SYNCHRONISER, || device.make_safe());
    let state = guarded(SYNCHRONISER, || device.state());
    match (made, state) {
        (Ok(()), Ok(SynchroniserState::Safe)) => Ok(()),
        (Err(error), _) | (_, Err(error)) => Err(error.to_string()),
        (Ok(()), Ok(state)) => Err(format!("it reads back {state:?}")),
    }
}

/// Makes the synchroniser safe and reads it back: the first thing a run does, before anything
/// that takes time. What an earlier run left behind must not fire while tables are built.
///
/// # Errors
///
/// [`AcquisitionError::NotSafe`].
pub async fn secure(mut bench: Bench) -> Result<Bench, AcquisitionError> {
    let secured = tokio::task::spawn_blocking(move || {
        let left = make_safe(bench.synchroniser.as_mut());
        (bench, left)
    });
    let (bench, left) = secured.await.map_err(|error| not_safe(error.to_string()))?;
    left.map_err(not_safe).map(|()| bench)
}

/// Asks the synchroniser. When this goes, the thread ends, safe state first.
pub(super) struct SynchroniserCalls {
    orders: std_mpsc::Sender<Order>,
    shared: Arc<Shared>,
}

impl SynchroniserCalls {
    /// Runs one call on the synchroniser's thread and waits for its answer.
    pub async fn call<T: Send + 'static>(
        &self,
        call: impl FnOnce(&mut dyn Synchroniser) -> Result<T, DeviceError> + Send + 'static,
    ) -> Result<T, AcquisitionError> {
        let answered = self.order(|unit| unit.call(call)).await;
        let gone = || DeviceError::Lost {
            device: SYNCHRONISER.to_owned(),
            detail: "its thread has ended".to_owned(),
        };
        Ok(answered.ok_or_else(gone)??)
    }

    /// Safe, and read back.
    pub async fn make_safe(&self) -> Result<(), AcquisitionError> {
        let made = self.order(Unit::make_safe).await;
        // A thread that has ended has done so before.
        let left = made.or_else(|| self.shared.left.lock().clone());
        let left = left.unwrap_or_else(|| Err("its thread has ended".to_owned()));
        left.map_err(not_safe)
    }

    /// Completes once watching over the unit has found a fault; the unit has been made safe then,
    /// or the fault says that it has not.
    pub async fn fault(&self) -> AcquisitionError {
        loop {
            if let Some(fault) = self.shared.fault.lock().take() {
                return fault.into();
            }
            self.shared.found_fault.notified().await;
        }
    }

    /// `None` when the thread has ended.
    async fn order<T: Send + 'static>(
        &self,
        order: impl FnOnce(&mut Unit) -> T + Send + 'static,
    ) -> Option<T> {
        let (answer, answered) = oneshot::channel();
        let order: Order = Box::new(move |unit| {
            // Nobody waits for the answer when the run is being torn down.
            let _ = answer.send(order(unit));
        });
        self.orders.send(order).ok()?;
        answered.await.ok()
    }
}
