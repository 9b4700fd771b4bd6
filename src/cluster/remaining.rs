//! How many shots a coordinator still waits for, and who is told of it.

use tokio::sync::watch;

/// Shots that are to be measured, and results that were taken in but are not yet with the one who writes them.
///
/// Part of the coordinator's locked state, so that numbers are told in the order in which they arose: requests run
/// in parallel, and an older number told last would be waited for without end.
pub(super) struct Remaining {
    open: usize,
    in_transit: usize,
    told: watch::Sender<usize>,
}

impl Remaining {
    pub fn of(open: usize) -> Self {
        Self { open, in_transit: 0, told: watch::channel(open).0 }
    }

    /// So many shots are now to be measured.
    pub fn set_open(&mut self, open: usize) {
        self.open = open;
        self.tell();
    }

    /// A result was taken in. [`Self::set_open`] follows, then [`Self::handed_on`].
    pub fn take_in(&mut self) {
        self.in_transit += 1;
    }

    /// A result is with the one who writes it.
    pub fn handed_on(&mut self) {
        self.in_transit -= 1;
        self.tell();
    }

    /// The number, as it changes.
    pub fn subscribe(&self) -> watch::Receiver<usize> {
        self.told.subscribe()
    }

    /// Tells the number, even if it is the same: those who wait look again.
    pub fn tell(&self) {
        self.told.send_replace(self.open + self.in_transit);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Both of two last results are taken in before one is handed on; the second one overtakes the first.
    #[test]
    fn nothing_remains_once_every_result_is_handed_on_in_whatever_order() {
        let mut remaining = Remaining::of(2);
        let left = remaining.subscribe();
        remaining.take_in();
        remaining.set_open(1);
        assert_eq!(*left.borrow(), 2);
        remaining.take_in();
        remaining.set_open(0);
        assert_eq!(*left.borrow(), 2);
        remaining.handed_on();
        assert_eq!(*left.borrow(), 1);
        remaining.handed_on();
        assert_eq!(*left.borrow(), 0);
        remaining.set_open(1);
        assert_eq!(*left.borrow(), 1);
    }
}
