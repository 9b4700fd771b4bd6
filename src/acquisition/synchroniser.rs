//! The synchroniser's thread, which outlives its callers.
//!
//! The run loop holds [`SynchroniserCalls`] and may panic. The thread is owned by the holders of
//! [`SynchroniserThread`], outside the run loop's task. When all callers are gone, or when it is told
//! to end, the thread makes the unit safe, reads that back and ends; its owners wait for it. So the
//! process never exits in the middle of the commands that make the laser safe.

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

use self::unit::{FinalState, is_loss};
pub(super) use self::unit::{Unit, UnsafeState};
use super::{
    AcquisitionError,
    bench::{Bench, Reopen},
};

/// Poll interval of the thread for its end.
const TICK: Duration = Duration::from_millis(50);
const THREAD_ENDED: &str = "its thread has ended";
/// Device name in messages, and the thread's name.
const SYNCHRONISER: &str = "synchroniser";

/// Owns the synchroniser's thread. Clones share it; dropping the last one joins the thread.
#[derive(Clone, Default)]
pub struct SynchroniserThread(Arc<Owned>);

#[derive(Default)]
struct Owned {
    thread: Mutex<Option<JoinHandle<()>>>,
    shared: Arc<Shared>,
}

/// State shared between the thread and its owners.
#[derive(Default)]
pub(super) struct Shared {
    started: AtomicBool,
    /// Tells the thread to end.
    ending: AtomicBool,
    final_state: Mutex<Option<FinalState>>,
    has_ended: Condvar,
    /// Fault found by [`Synchroniser::watch`], for the run loop.
    fault: Mutex<Option<DeviceError>>,
    found_fault: Notify,
}

impl SynchroniserThread {
    /// Moves the unit to the thread. From here on it is made safe whatever happens. `reopen` opens it
    /// again after a loss.
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

    /// Ends the thread, safe state first, and waits at most `limit` for the read-back. Returns at
    /// once if no unit was started.
    ///
    /// # Errors
    ///
    /// [`AcquisitionError::NotSafe`], also on timeout.
    pub fn make_safe_within(&self, limit: Duration) -> Result<(), AcquisitionError> {
        let shared = &self.0.shared;
        shared.ending.store(true, Ordering::SeqCst);
        if !shared.started.load(Ordering::SeqCst) {
            return Ok(());
        }
        let deadline = Instant::now() + limit;
        let mut state = shared.final_state.lock();
        while state.is_none() {
            if shared.has_ended.wait_until(&mut state, deadline).timed_out() {
                let seconds = limit.as_secs_f64();
                return Err(no_answer(format!(
                    "its state was not read back within {seconds:.1} s"
                )));
            }
        }
        drop(state);
        self.0.result()
    }

    /// As [`Self::make_safe_within`], without a limit and without blocking the runtime.
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
            tracing::error!(thread = SYNCHRONISER, "panicked");
            let reason = "its thread panicked".to_owned();
            self.shared.end(Err(UnsafeState { reason, is_lost: false }));
        }
        self.result()
    }

    fn result(&self) -> Result<(), AcquisitionError> {
        match &*self.shared.final_state.lock() {
            Some(Err(why)) => Err(not_safe(why.clone())),
            Some(Ok(())) | None => Ok(()),
        }
    }
}

impl Drop for Owned {
    /// When a task is dropped, by its panic or with its runtime, nothing else joins the thread.
    fn drop(&mut self) {
        // The thread has logged its result.
        let _ = self.join();
    }
}

impl Shared {
    fn end(&self, state: FinalState) {
        if let Err(UnsafeState { reason, .. }) = &state {
            tracing::error!(reason, "the synchroniser was not safe at the end");
        }
        *self.final_state.lock() = Some(state);
        self.has_ended.notify_all();
    }
}

fn not_safe(UnsafeState { reason, is_lost }: UnsafeState) -> AcquisitionError {
    tracing::error!(reason, "state unknown: use the hardware interlock");
    AcquisitionError::NotSafe { reason, is_lost, before: None }
}

/// The thread cannot be asked, or did not answer in time.
fn no_answer(reason: String) -> AcquisitionError {
    not_safe(UnsafeState { reason, is_lost: false })
}

/// The thread has ended because the process is exiting.
pub(super) fn thread_ended() -> AcquisitionError {
    let (device, detail) = (SYNCHRONISER.to_owned(), THREAD_ENDED.to_owned());
    DeviceError::Lost { device, detail }.into()
}

/// The error of a call, or a loss if the unit did not answer.
fn unit_error(error: DeviceError) -> AcquisitionError {
    if is_loss(&error) { AcquisitionError::SynchroniserLost(error) } else { error.into() }
}

type Order = Box<dyn FnOnce(&mut Unit) + Send>;

/// Main loop of the thread: executes calls, watches the unit in between, and makes it safe at the end.
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
    let state = unit.ensure_safe();
    unit.shared().end(state);
}

/// Makes the synchroniser safe and reads it back. A run does this first, before anything that takes
/// time: what an earlier run left behind must not fire while tables are built.
///
/// # Errors
///
/// [`AcquisitionError::NotSafe`].
pub async fn secure(mut bench: Bench) -> Result<Bench, AcquisitionError> {
    let secured = tokio::task::spawn_blocking(move || {
        let state = unit::make_safe(bench.synchroniser.as_mut());
        (bench, state)
    });
    let (bench, state) = secured.await.map_err(|error| no_answer(error.to_string()))?;
    state.map_err(not_safe).map(|()| bench)
}

/// Handle for calls. Dropping it ends the thread, safe state first.
pub(super) struct SynchroniserCalls {
    orders: std_mpsc::Sender<Order>,
    shared: Arc<Shared>,
}

impl SynchroniserCalls {
    /// Runs a closure on the synchroniser's thread and waits for its result.
    pub async fn call<T: Send + 'static>(
        &self,
        call: impl FnOnce(&mut dyn Synchroniser) -> Result<T, DeviceError> + Send + 'static,
    ) -> Result<T, AcquisitionError> {
        let answered = self.order(|unit| unit.call(call)).await;
        answered.ok_or_else(thread_ended)?.map_err(unit_error)
    }

    /// Makes the unit safe and reads it back.
    pub async fn make_safe(&self) -> Result<(), AcquisitionError> {
        let made = self.order(Unit::make_safe).await;
        // A thread that has ended has made it safe before.
        let state = made.or_else(|| self.shared.final_state.lock().clone());
        state.ok_or_else(|| no_answer(THREAD_ENDED.to_owned()))?.map_err(not_safe)
    }

    /// Starts one attempt to reopen a lost unit ([`Unit::reopen`]); the result arrives on the channel.
    ///
    /// # Errors
    ///
    /// The thread has ended.
    pub fn start_search(
        &self,
    ) -> Result<oneshot::Receiver<Result<String, UnsafeState>>, AcquisitionError> {
        self.begin(Unit::reopen).ok_or_else(thread_ended)
    }

    /// Discards a fault that was found before the unit was lost.
    pub fn forget_fault(&self) {
        *self.shared.fault.lock() = None;
    }

    /// Completes once watching the unit has found a fault. The unit has been made safe by then, or the
    /// fault says that it has not.
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
            // During shutdown nobody waits for the answer.
            let _ = answer.send(order(unit));
        });
        self.orders.send(order).ok().map(|()| answered)
    }
}
