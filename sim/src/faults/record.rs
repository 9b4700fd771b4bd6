//! What was injected, for comparison with what the program reports.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// One fault, and what it happened to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Injected<F> {
    /// A frame's id as the wrapped camera gave it, or a command's number since the line was
    /// wrapped, from 0.
    pub number: u64,
    /// What happened.
    pub fault: F,
}

/// Everything an injector did. Clones share it, so that a test can keep one while the daemon owns
/// the device.
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
    /// Frames that the wrapped camera delivered, or commands that the host sent.
    pub fn taken(&self) -> u64 {
        self.entries().taken
    }

    /// Frames that were delivered, or commands that reached the wrapped line.
    pub fn given(&self) -> u64 {
        self.entries().given
    }

    /// Every fault, in the order of injection.
    pub fn faults(&self) -> Vec<Injected<F>> {
        self.entries().faults.clone()
    }

    /// How many faults `choose` picks.
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

    /// Every change is one statement: a poisoned lock is whole.
    fn entries(&self) -> MutexGuard<'_, Entries<F>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
