//! The numbered events of a run.
//!
//! One log of the latest events serves all readers. Each reader keeps its own position, so that no
//! reader delays another reader or the publisher. A reader that falls too far behind is told how many
//! events it has missed.

use std::{
    collections::VecDeque,
    sync::Arc,
    time::{SystemTime, UNIX_EPOCH},
};

use parking_lot::Mutex;
use serde::Serialize;
use tokio::sync::watch;

/// Capacity of the log: more than a minute of shots at 15 Hz.
pub const EVENTS_IN_MEMORY: usize = 2048;

/// Subject of an event.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EventKind {
    /// The run's state or the queue has changed.
    Status,
    /// A shot has ended in the pool; carries its record.
    Shot,
    /// A result is available.
    Result,
    /// The watermarks have advanced.
    Watermarks,
    /// A control request was granted.
    Control,
}

impl EventKind {
    /// Every kind.
    pub const ALL: [Self; 5] =
        [Self::Status, Self::Shot, Self::Result, Self::Watermarks, Self::Control];

    /// Name in the HTTP interface.
    pub fn name(self) -> &'static str {
        match self {
            Self::Status => "status",
            Self::Shot => "shot",
            Self::Result => "result",
            Self::Watermarks => "watermarks",
            Self::Control => "control",
        }
    }
}

/// One event.
#[derive(Debug, Clone)]
pub struct Event {
    /// Number within the run, from 1, without gaps.
    pub id: u64,
    /// Its subject.
    pub kind: EventKind,
    /// Payload, in JSON.
    pub data: Arc<str>,
}

/// Events returned by one read.
#[derive(Debug, Clone, Default)]
pub struct Batch {
    /// Number of events before `events` that the log no longer holds.
    pub missed: u64,
    /// In order.
    pub events: Vec<Event>,
}

/// See the module.
#[derive(Debug)]
pub struct EventLog {
    run: u64,
    events: Mutex<VecDeque<Event>>,
    /// Number of the last event; 0 before the first.
    last: watch::Sender<u64>,
}

impl Default for EventLog {
    fn default() -> Self {
        let run = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
        Self {
            run: u64::try_from(run.as_micros()).unwrap_or(u64::MAX),
            events: Mutex::default(),
            last: watch::Sender::new(0),
        }
    }
}

impl EventLog {
    /// Identifies the run: its start, in µs since 1970.
    pub fn run(&self) -> u64 {
        self.run
    }

    /// Adds an event. Never waits for a reader.
    pub fn publish(&self, kind: EventKind, data: &impl Serialize) {
        let data: Arc<str> = match serde_json::to_string(data) {
            Ok(json) => json.into(),
            Err(error) => {
                tracing::error!(%error, kind = kind.name(), "cannot serialise an event");
                return;
            }
        };
        let mut events = self.events.lock();
        let id = self.last_id() + 1;
        events.push_back(Event { id, kind, data });
        if events.len() > EVENTS_IN_MEMORY {
            events.pop_front();
        }
        // Under the lock: readers never see the numbers out of order.
        self.last.send_replace(id);
    }

    /// Number of the last event; 0 before the first.
    pub fn last_id(&self) -> u64 {
        *self.last.borrow()
    }

    /// Notified at every event.
    pub fn watch(&self) -> watch::Receiver<u64> {
        self.last.subscribe()
    }

    /// At most `most` of the events after number `id`, the oldest first.
    pub fn after(&self, id: u64, most: usize) -> Batch {
        let events = self.events.lock();
        let Some(oldest) = events.front().map(|event| event.id) else { return Batch::default() };
        let missed = oldest.saturating_sub(id.saturating_add(1));
        let seen = usize::try_from(id.saturating_add(1).saturating_sub(oldest));
        let seen = seen.unwrap_or(usize::MAX);
        Batch { missed, events: events.iter().skip(seen).take(most).cloned().collect() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers(batch: &Batch) -> Vec<u64> {
        batch.events.iter().map(|event| event.id).collect()
    }

    #[test]
    fn readers_continue_at_their_position() {
        let log = EventLog::default();
        assert_eq!(numbers(&log.after(0, 10)), [0u64; 0]);
        for shot in 0..5 {
            log.publish(EventKind::Result, &shot);
        }
        assert_eq!(numbers(&log.after(0, 10)), [1, 2, 3, 4, 5]);
        assert_eq!(numbers(&log.after(2, 2)), [3, 4]);
        assert_eq!(numbers(&log.after(5, 10)), [0u64; 0]);
        assert_eq!(numbers(&log.after(u64::MAX, 10)), [0u64; 0]);
        assert_eq!(log.after(0, 1).events[0].data.as_ref(), "0");
    }

    #[test]
    fn memory_is_bounded_and_a_lagging_reader_is_told_how_many_events_it_missed() {
        let log = EventLog::default();
        let published = EVENTS_IN_MEMORY as u64 + 7;
        for shot in 0..published {
            log.publish(EventKind::Shot, &shot);
        }
        let batch = log.after(3, 1);
        assert_eq!((batch.missed, numbers(&batch)), (4, vec![8]));
        assert_eq!(log.after(7, 1).missed, 0);
        assert_eq!(log.after(0, usize::MAX).events.len(), EVENTS_IN_MEMORY);
        assert_eq!((log.last_id(), *log.watch().borrow()), (published, published));
    }
}
