//! The synchroniser on a thread of its own, which outlives whatever asks it.
//!
//! The run loop holds [`SynchroniserCalls`], and may panic. The thread belongs to whoever holds
//! [`SynchroniserThread`], outside the run loop's task: when nobody calls any more, or when it is
//! told to end, the thread makes the unit safe, reads that back and ends, and its owners wait for
//! it. So the process does not end in the middle of the commands that make the laser safe.

mod unit;

use std::{
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
        mpsc as std_mpsc,
    },
    thread::JoinHandle,
    time::{Duration, Instant},
};

use lfpiv_hw::device::{DeviceError, Synchroniser, WATCH_INTERVAL};
use parking_lot::{Condvar, Mutex};
use tokio::sync::{Notify, oneshot};

use self::unit::{Left, is_loss};
pub(super) use self::unit::{Unit, Unsafe};
use super::{AcquisitionError, Bench};

/// How late the thread notices that it should end.
const TICK: Duration = Duration::from_millis(50);
const THREAD_ENDED: &str = "its thread has ended";
/// For messages, and the thread's name.
const SYNCHRONISER: &str = "synchroniser";

/// Opens a synchroniser that was lost: disabled before anything else, as the first time.
pub type Reopen = Box<dyn FnMut() -> Result<Box<dyn Synchroniser>, DeviceError> + Send>;

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
pub(super) struct Shared {
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
    /// Puts the unit on the thread. From here on it is made safe whatever happens. `reopen` is how
    /// it is opened again once it is lost.
    pub(super) fn start(
        &self,
        device: Box<dyn Synchroniser>,
        reopen: Option<Reopen>,
    ) -> Result<SynchroniserCalls, AcquisitionError> {
        let (orders, inbox) = std_mpsc::channel();
        let shared = self.0.shared.clone();
        let unit = Unit::new(device, reopen, shared.clone());
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
                return Err(no_answer(format!("it was not read back within {seconds:.1} s")));
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
        joined.map_err(|error| no_answer(error.to_string()))?
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
            let reason = "its thread panicked".to_owned();
            self.shared.leave(Err(Unsafe { reason, is_lost: false }));
        }
        self.left()
    }

    fn left(&self) -> Result<(), AcquisitionError> {
        match &*self.shared.left.lock() {
            Some(Err(why)) => Err(not_safe(why.clone())),
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
        if let Err(Unsafe { reason, .. }) = &left {
            tracing::error!(reason, "the synchroniser was not left safe");
        }
        *self.left.lock() = Some(left);
        self.has_left.notify_all();
    }
}

fn not_safe(Unsafe { reason, is_lost }: Unsafe) -> AcquisitionError {
    tracing::error!(reason, "state unknown: use the hardware interlock");
    AcquisitionError::NotSafe { reason, is_lost, before: None }
}

/// There is nobody to ask, or no time.
fn no_answer(reason: String) -> AcquisitionError {
    not_safe(Unsafe { reason, is_lost: false })
}

/// Nobody may ask any more: the process was told to end at once.
pub(super) fn thread_ended() -> AcquisitionError {
    let (device, detail) = (SYNCHRONISER.to_owned(), THREAD_ENDED.to_owned());
    DeviceError::Lost { device, detail }.into()
}

/// What a unit says, or that it says nothing.
fn unit_error(error: DeviceError) -> AcquisitionError {
    if is_loss(&error) { AcquisitionError::SynchroniserLost(error) } else { error.into() }
}

type Order = Box<dyn FnOnce(&mut Unit) + Send>;

/// Obeys, and looks after the unit in between; safe state last.
fn serve(mut unit: Unit, inbox: std_mpsc::Receiver<Order>) {
    let mut look = Instant::now() + WATCH_INTERVAL;
    while !unit.shared().ending.load(Ordering::SeqCst) {
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
    let left = unit.leave();
    unit.shared().leave(left);
}

/// Makes the synchroniser safe and reads it back: the first thing a run does, before anything
/// that takes time. What an earlier run left behind must not fire while tables are built.
///
/// # Errors
///
/// [`AcquisitionError::NotSafe`].
pub async fn secure(mut bench: Bench) -> Result<Bench, AcquisitionError> {
    let secured = tokio::task::spawn_blocking(move || {
        let left = unit::make_safe(bench.synchroniser.as_mut());
        (bench, left)
    });
    let (bench, left) = secured.await.map_err(|error| no_answer(error.to_string()))?;
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
        answered.ok_or_else(thread_ended)?.map_err(unit_error)
    }

    /// Safe, and read back.
    pub async fn make_safe(&self) -> Result<(), AcquisitionError> {
        let made = self.order(Unit::make_safe).await;
        // A thread that has ended has done so before.
        let left = made.or_else(|| self.shared.left.lock().clone());
        left.ok_or_else(|| no_answer(THREAD_ENDED.to_owned()))?.map_err(not_safe)
    }

    /// Begins to look for a lost unit, once: [`Unit::reopen`]. The answer comes when it comes.
    ///
    /// # Errors
    ///
    /// Its thread has ended.
    pub fn look_for_it(
        &self,
    ) -> Result<oneshot::Receiver<Result<String, Unsafe>>, AcquisitionError> {
        self.begin(Unit::reopen).ok_or_else(thread_ended)
    }

    /// What watching found of a unit that is lost by now is of no more use.
    pub fn forget_fault(&self) {
        *self.shared.fault.lock() = None;
    }

    /// Completes once watching over the unit has found a fault; the unit has been made safe then,
    /// or the fault says that it has not.
    pub async fn fault(&self) -> AcquisitionError {
        loop {
            if let Some(fault) = self.shared.fault.lock().take() {
                return unit_error(fault);
            }
            self.shared.found_fault.notified().await;
        }
    }

    /// `None` when the thread has ended.
    async fn order<T: Send + 'static>(
        &self,
        order: impl FnOnce(&mut Unit) -> T + Send + 'static,
    ) -> Option<T> {
        self.begin(order)?.await.ok()
    }

    fn begin<T: Send + 'static>(
        &self,
        order: impl FnOnce(&mut Unit) -> T + Send + 'static,
    ) -> Option<oneshot::Receiver<T>> {
        let (answer, answered) = oneshot::channel();
        let order: Order = Box::new(move |unit| {
            // Nobody waits for the answer when the run is being torn down.
            let _ = answer.send(order(unit));
        });
        self.orders.send(order).ok().map(|()| answered)
    }
}
