//! The bounded queue of shots for the workers, which sheds its oldest shot.
//!
//! Live results should be as recent as possible, and shed shots are measured later from the raw log.
//! A full queue therefore drops the shot that has waited longest, not the newest one.

use std::{collections::VecDeque, sync::Arc};

use parking_lot::Mutex;
use tokio::sync::Notify;

use super::Shot;

/// A queue for `capacity` shots, at least one.
pub fn shot_queue(capacity: usize) -> (ShotSender, ShotReceiver) {
    let shared = Arc::new(Shared {
        capacity: capacity.max(1),
        state: Mutex::default(),
        pushed: Notify::new(),
        taken: Notify::new(),
    });
    (ShotSender(shared.clone()), ShotReceiver(shared))
}

/// The receiver is gone.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Closed;

/// The only sending end.
pub struct ShotSender(Arc<Shared>);

/// The only receiving end.
pub struct ShotReceiver(Arc<Shared>);

struct Shared {
    capacity: usize,
    state: Mutex<State>,
    pushed: Notify,
    taken: Notify,
}

#[derive(Default)]
struct State {
    shots: VecDeque<Shot>,
    sender_gone: bool,
    receiver_gone: bool,
}

impl ShotSender {
    /// Adds a shot. Returns the oldest one if the queue is full.
    ///
    /// # Errors
    ///
    /// [`Closed`]: the receiver is gone, and the shot is dropped.
    pub fn push(&self, shot: Shot) -> Result<Option<Shot>, Closed> {
        let mut state = self.0.state.lock();
        if state.receiver_gone {
            return Err(Closed);
        }
        let full = state.shots.len() >= self.0.capacity;
        let shed = if full { state.shots.pop_front() } else { None };
        state.shots.push_back(shot);
        drop(state);
        self.0.pushed.notify_one();
        Ok(shed)
    }

    /// Number of shots that can be added without shedding. Waits until there are `least` free
    /// places, or until the queue is empty.
    ///
    /// # Errors
    ///
    /// [`Closed`].
    pub async fn free_places(&self, least: usize) -> Result<usize, Closed> {
        loop {
            {
                let state = self.0.state.lock();
                if state.receiver_gone {
                    return Err(Closed);
                }
                let room = self.0.capacity.saturating_sub(state.shots.len());
                if room >= least.clamp(1, self.0.capacity) {
                    return Ok(room);
                }
            }
            self.0.taken.notified().await;
        }
    }
}

impl Drop for ShotSender {
    fn drop(&mut self) {
        self.0.state.lock().sender_gone = true;
        self.0.pushed.notify_one();
    }
}

impl ShotReceiver {
    /// The oldest shot; `None` once the sender is gone and the queue is empty.
    pub async fn recv(&mut self) -> Option<Shot> {
        loop {
            {
                let mut state = self.0.state.lock();
                if let Some(shot) = state.shots.pop_front() {
                    drop(state);
                    self.0.taken.notify_one();
                    return Some(shot);
                }
                if state.sender_gone {
                    return None;
                }
            }
            self.0.pushed.notified().await;
        }
    }
}

impl Drop for ShotReceiver {
    fn drop(&mut self) {
        self.0.state.lock().receiver_gone = true;
        self.0.taken.notify_one();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shot(trigger: u64) -> Shot {
        let (cameras, suspect, residuals_ns) = (Vec::new(), Vec::new(), Vec::new());
        let due = std::time::Duration::ZERO;
        Shot { trigger, cameras, time: None, due, dt_us: 100.0, suspect, residuals_ns }
    }

    #[tokio::test]
    async fn the_oldest_makes_room() {
        let (sender, mut receiver) = shot_queue(2);
        let shed: Vec<Option<u64>> = (0..4)
            .map(|trigger| sender.push(shot(trigger)).unwrap().map(|shed| shed.trigger))
            .collect();
        assert_eq!(shed, [None, None, Some(0), Some(1)]);
        drop(sender);
        let mut left = Vec::new();
        while let Some(shot) = receiver.recv().await {
            left.push(shot.trigger);
        }
        assert_eq!(left, [2, 3]);
    }

    #[tokio::test]
    async fn room_is_waited_for() {
        let (sender, mut receiver) = shot_queue(2);
        assert_eq!(sender.free_places(1).await, Ok(2));
        assert!(sender.push(shot(0)).unwrap().is_none());
        assert!(sender.push(shot(1)).unwrap().is_none());
        let waiting = tokio::spawn(async move {
            let room = sender.free_places(1).await;
            (sender, room)
        });
        tokio::task::yield_now().await;
        assert!(!waiting.is_finished());
        assert_eq!(receiver.recv().await.map(|shot| shot.trigger), Some(0));
        let (sender, room) = waiting.await.unwrap();
        assert_eq!(room, Ok(1));
        drop(receiver);
        assert_eq!(sender.free_places(1).await, Err(Closed));
        assert_eq!(sender.push(shot(2)).map(|_| ()), Err(Closed));
    }
}
