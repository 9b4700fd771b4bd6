//! The unit on its thread: what is asked of it, its safe state, and how it is opened again.

use std::{
    sync::Arc,
    time::{Duration, Instant},
};

use lfpiv_hw::device::{DeviceError, Synchroniser, SynchroniserState};

use super::{Reopen, SYNCHRONISER, Shared};
use crate::acquisition::devices::guarded;

/// How the unit was left: safe and read back so, or why not.
pub(super) type Left = Result<(), Unsafe>;

/// Why a unit is not known to be safe.
#[derive(Debug, Clone)]
pub(in crate::acquisition) struct Unsafe {
    pub reason: String,
    /// It does not answer at all.
    pub is_lost: bool,
}

/// For so long after a unit was looked for in vain it is not looked for only to make it safe: the
/// process may be waiting for its end.
const JUST_LOOKED: Duration = Duration::from_secs(1);

/// The unit.
pub(in crate::acquisition) struct Unit {
    /// `None` while it is lost.
    device: Option<Box<dyn Synchroniser>>,
    reopen: Option<Reopen>,
    /// It was read back as safe, and nothing has been asked of it since.
    is_safe: bool,
    /// When it was looked for in vain, and what came of it.
    missed: Option<(Instant, Unsafe)>,
    shared: Arc<Shared>,
}

impl Unit {
    pub fn new(device: Box<dyn Synchroniser>, reopen: Option<Reopen>, shared: Arc<Shared>) -> Self {
        Self { device: Some(device), reopen, is_safe: false, missed: None, shared }
    }

    pub fn shared(&self) -> &Shared {
        &self.shared
    }

    pub fn call<T>(
        &mut self,
        call: impl FnOnce(&mut dyn Synchroniser) -> Result<T, DeviceError>,
    ) -> Result<T, DeviceError> {
        if let Some(fault) = self.shared.fault.lock().take() {
            return Err(fault);
        }
        let Some(device) = &mut self.device else {
            let detail = "it is being looked for".to_owned();
            return Err(DeviceError::Lost { device: SYNCHRONISER.to_owned(), detail });
        };
        self.is_safe = false;
        guarded(SYNCHRONISER, || call(device.as_mut()))
    }

    /// What it finds is told to whoever calls next or waits for it.
    pub fn watch(&mut self) {
        let Some(device) = &mut self.device else { return };
        if let Err(fault) = guarded(SYNCHRONISER, || device.watch()) {
            *self.shared.fault.lock() = Some(fault);
            self.shared.found_fault.notify_one();
        }
    }

    pub fn make_safe(&mut self) -> Left {
        let left = match (&mut self.device, &self.missed) {
            (Some(device), _) => make_safe(device.as_mut()),
            (None, Some((at, why))) if at.elapsed() < JUST_LOOKED => Err(why.clone()),
            (None, _) => self.reopen().map(drop),
        };
        self.is_safe = left.is_ok();
        left
    }

    /// Makes it safe unless it is known to be.
    pub fn leave(&mut self) -> Left {
        if self.is_safe { Ok(()) } else { self.make_safe() }
    }

    /// Looks for a lost unit once: opens it again, makes it safe, reads that back; returns what it
    /// is.
    pub fn reopen(&mut self) -> Result<String, Unsafe> {
        // A port is open once at a time: the old line goes first.
        self.device = None;
        let opened = self.open_anew();
        self.is_safe = opened.is_ok();
        self.missed = opened.as_ref().err().map(|why| (Instant::now(), why.clone()));
        opened
    }

    fn open_anew(&mut self) -> Result<String, Unsafe> {
        let Some(reopen) = &mut self.reopen else {
            let reason = "nothing says how it is opened again".to_owned();
            return Err(Unsafe { reason, is_lost: true });
        };
        let mut device = guarded(SYNCHRONISER, reopen)?;
        make_safe(device.as_mut())?;
        let identity = guarded(SYNCHRONISER, || device.identify())?;
        // What watching found before was about what it did before.
        *self.shared.fault.lock() = None;
        self.device = Some(device);
        Ok(identity)
    }
}

/// Safe is what is read back as safe; an error on the way there is not.
pub(super) fn make_safe(device: &mut dyn Synchroniser) -> Left {
    let made = guarded(SYNCHRONISER, || device.make_safe());
    let state = guarded(SYNCHRONISER, || device.state());
    match (made, state) {
        (Ok(()), Ok(SynchroniserState::Safe)) => Ok(()),
        (Err(error), _) | (_, Err(error)) => Err(error.into()),
        (Ok(()), Ok(state)) => {
            let is_lost = state == SynchroniserState::Unknown;
            Err(Unsafe { reason: format!("it reads back {state:?}"), is_lost })
        }
    }
}

/// Whether the device did not answer: it may come back.
pub(super) fn is_loss(error: &DeviceError) -> bool {
    matches!(error, DeviceError::Lost { .. } | DeviceError::NotFound { .. })
}

impl From<DeviceError> for Unsafe {
    fn from(error: DeviceError) -> Self {
        Self { is_lost: is_loss(&error), reason: error.to_string() }
    }
}
