//! The unit on its thread: calls, safe state, and reopening.

use std::{
    sync::Arc,
    time::{Duration, Instant},
};

use lfpiv_hw::device::{DeviceError, Synchroniser, SynchroniserState};

use super::{Reopen, SYNCHRONISER, Shared};
use crate::acquisition::devices::guarded;

/// Final state of the unit: safe and read back, or the reason why not.
pub(super) type FinalState = Result<(), UnsafeState>;

/// Why a unit is not known to be safe.
#[derive(Debug, Clone)]
pub(in crate::acquisition) struct UnsafeState {
    pub reason: String,
    /// It does not answer at all.
    pub is_lost: bool,
}

/// After a failed search, the unit is not searched again within this time merely to make it safe: the
/// process may be waiting to exit.
const SEARCH_COOLDOWN: Duration = Duration::from_secs(1);

/// The unit, or its absence.
pub(in crate::acquisition) struct Unit {
    /// `None` while it is lost.
    device: Option<Box<dyn Synchroniser>>,
    reopen: Option<Reopen>,
    /// It was read back as safe, and no call was made since.
    is_safe: bool,
    /// Time and error of the last failed search.
    last_failed_search: Option<(Instant, UnsafeState)>,
    shared: Arc<Shared>,
}

impl Unit {
    pub fn new(device: Box<dyn Synchroniser>, reopen: Option<Reopen>, shared: Arc<Shared>) -> Self {
        Self { device: Some(device), reopen, is_safe: false, last_failed_search: None, shared }
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
            let detail = "a search for it is in progress".to_owned();
            return Err(DeviceError::Lost { device: SYNCHRONISER.to_owned(), detail });
        };
        self.is_safe = false;
        guarded(SYNCHRONISER, || call(device.as_mut()))
    }

    /// Watches the unit; a fault is reported to the next caller or waiter.
    pub fn watch(&mut self) {
        let Some(device) = &mut self.device else { return };
        if let Err(fault) = guarded(SYNCHRONISER, || device.watch()) {
            *self.shared.fault.lock() = Some(fault);
            self.shared.found_fault.notify_one();
        }
    }

    pub fn make_safe(&mut self) -> FinalState {
        let state = match (&mut self.device, &self.last_failed_search) {
            (Some(device), _) => make_safe(device.as_mut()),
            (None, Some((at, why))) if at.elapsed() < SEARCH_COOLDOWN => Err(why.clone()),
            (None, _) => self.reopen().map(drop),
        };
        self.is_safe = state.is_ok();
        state
    }

    /// Makes it safe unless it is known to be safe.
    pub fn ensure_safe(&mut self) -> FinalState {
        if self.is_safe { Ok(()) } else { self.make_safe() }
    }

    /// One attempt to reopen a lost unit: opens it, makes it safe, reads that back; returns its
    /// identity.
    pub fn reopen(&mut self) -> Result<String, UnsafeState> {
        // A port can be open only once: the old line is closed first.
        self.device = None;
        let opened = self.reopen_device();
        self.is_safe = opened.is_ok();
        self.last_failed_search = opened.as_ref().err().map(|why| (Instant::now(), why.clone()));
        opened
    }

    fn reopen_device(&mut self) -> Result<String, UnsafeState> {
        let Some(reopen) = &mut self.reopen else {
            let reason = "no way to reopen it is configured".to_owned();
            return Err(UnsafeState { reason, is_lost: true });
        };
        let mut device = guarded(SYNCHRONISER, reopen)?;
        make_safe(device.as_mut())?;
        let identity = guarded(SYNCHRONISER, || device.identify())?;
        // An earlier fault refers to the state before the loss.
        *self.shared.fault.lock() = None;
        self.device = Some(device);
        Ok(identity)
    }
}

/// Only a successful read-back counts as safe; errors before it do not matter.
pub(super) fn make_safe(device: &mut dyn Synchroniser) -> FinalState {
    let made = guarded(SYNCHRONISER, || device.make_safe());
    let state = guarded(SYNCHRONISER, || device.state());
    match (made, state) {
        (Ok(()), Ok(SynchroniserState::Safe)) => Ok(()),
        (Err(error), _) | (_, Err(error)) => Err(error.into()),
        (Ok(()), Ok(state)) => {
            let is_lost = state == SynchroniserState::Unknown;
            Err(UnsafeState { reason: format!("it reads back {state:?}"), is_lost })
        }
    }
}

/// Whether the device did not answer and may come back.
pub(super) fn is_loss(error: &DeviceError) -> bool {
    matches!(error, DeviceError::Lost { .. } | DeviceError::NotFound { .. })
}

impl From<DeviceError> for UnsafeState {
    fn from(error: DeviceError) -> Self {
        Self { is_lost: is_loss(&error), reason: error.to_string() }
    }
}

#[cfg(test)]
mod tests {
    use lfpiv_hw::timing::PulseSchedule;

    use super::*;

    /// A unit that is always safe.
    struct SafeUnit;

    impl Synchroniser for SafeUnit {
        fn identify(&mut self) -> Result<String, DeviceError> {
            Ok("safe unit".to_owned())
        }

        fn program(&mut self, _: &PulseSchedule) -> Result<(), DeviceError> {
            Ok(())
        }

        fn fire(&mut self, _: u64) -> Result<(), DeviceError> {
            Ok(())
        }

        fn trigger_count(&mut self) -> Result<Option<u64>, DeviceError> {
            Ok(None)
        }

        fn state(&mut self) -> Result<SynchroniserState, DeviceError> {
            Ok(SynchroniserState::Safe)
        }

        fn make_safe(&mut self) -> Result<(), DeviceError> {
            Ok(())
        }
    }

    #[test]
    fn a_lost_unit_is_searched_for_again_after_a_pause_to_be_made_safe() {
        let mut is_there = false;
        let reopen: Reopen = Box::new(move || {
            let detail = "unplugged".to_owned();
            let lost = DeviceError::NotFound { device: SYNCHRONISER.to_owned(), detail };
            let opened =
                if is_there { Ok(Box::new(SafeUnit) as Box<dyn Synchroniser>) } else { Err(lost) };
            is_there = true;
            opened
        });
        let mut unit = Unit::new(Box::new(SafeUnit), Some(reopen), Arc::default());
        assert!(unit.reopen().is_err());
        // A time ahead: the pause has not passed however slow this machine is.
        let failed_at =
            |unit: &mut Unit, at: Instant| unit.last_failed_search.as_mut().unwrap().0 = at;
        failed_at(&mut unit, Instant::now() + Duration::from_secs(3600));
        assert!(
            unit.make_safe().is_err_and(|why| why.is_lost),
            "it was searched for within the pause"
        );
        failed_at(&mut unit, Instant::now().checked_sub(SEARCH_COOLDOWN).unwrap());
        assert!(unit.make_safe().is_ok() && unit.device.is_some());
    }
}
