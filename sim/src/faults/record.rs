//! The injected faults, for comparison with the program's reports.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// An injected fault.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Injected<F> {
    /// The frame id of the wrapped camera, or the number of the command since the line was wrapped,
    /// from 0.
    pub number: u64,
    /// The kind of fault.
    pub fault: F,
}

/// All actions of an injector. Clones share it, so that a test can keep one while the daemon owns the
/// device.
#[derive(Debug, Clone)]
pub struct FaultRecord<F>(Arc<Mutex<Entries<F>>>);

#[derive(Debug)]
struct Entries<F> {
    taken: u64,
    given: u64,
    faults: Vec<Injected<F>>,
}

impl<F> Default for FaultRecord<F> {
    fn default() -> Self {
        Self(Arc::new(Mutex::new(Entries { taken: 0, given: 0, faults: Vec::new() })))
    }
}

impl<F: Copy> FaultRecord<F> {
    /// Frames received from the wrapped camera, or commands sent by the host.
    pub fn taken(&self) -> u64 {
        self.entries().taken
    }

    /// Frames delivered, or commands that reached the wrapped line.
    pub fn given(&self) -> u64 {
        self.entries().given
    }

    /// Every fault, in the order of injection.
    pub fn faults(&self) -> Vec<Injected<F>> {
        self.entries().faults.clone()
    }

    /// Number of faults that `choose` selects.
    pub fn count(&self, choose: impl Fn(&F) -> bool) -> u64 {
        self.entries().faults.iter().filter(|injected| choose(&injected.fault)).count() as u64
    }

    pub(super) fn take(&self) {
        self.entries().taken += 1;
    }

    pub(super) fn give(&self) {
        self.entries().given += 1;
    }

    pub(super) fn note(&self, number: u64, fault: F) {
        self.entries().faults.push(Injected { number, fault });
    }

    /// Every change is one statement, so a poisoned lock is consistent.
    fn entries(&self) -> MutexGuard<'_, Entries<F>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
