//! Signs of life to the coordinators whose shots this worker measures: so that they show it while it waits, and miss
//! it when it is gone. Shots do not depend on them: the broker has heartbeats of its own.

use std::{
    collections::BTreeMap,
    time::{Duration, Instant},
};

use parking_lot::Mutex;

use crate::cluster::{ClientError, CoordinatorClient, Job};

/// A coordinator that has not answered for so long is over.
const FORGOTTEN_AFTER: Duration = Duration::from_secs(60);
/// Pause between two looks at what is due.
pub(super) const LOOK: Duration = Duration::from_millis(200);

/// See the module.
pub(super) struct Signs {
    worker: String,
    /// By address.
    coordinators: Mutex<BTreeMap<String, Known>>,
}

struct Known {
    client: CoordinatorClient,
    interval: Duration,
    told: Instant,
    answered: Instant,
}

impl Signs {
    pub fn of(worker: &str) -> Self {
        Self { worker: worker.to_owned(), coordinators: Mutex::default() }
    }

    /// A job has come from this coordinator, and it answers.
    pub fn know(&self, job: &Job) {
        let now = Instant::now();
        let known = Known {
            client: CoordinatorClient::new(&job.address, &job.tokens),
            interval: Duration::from_millis(job.heartbeat_ms.max(1)),
            told: now,
            answered: now,
        };
        self.coordinators.lock().insert(job.address.clone(), known);
    }

    /// Tells those for whom it is time. Blocks.
    pub fn tell(&self) {
        self.tell_those(false, |known| known.told.elapsed() >= known.interval);
    }

    /// Tells all of them that this worker ends. Blocks.
    pub fn end(&self) {
        self.tell_those(true, |_| true);
    }

    fn tell_those(&self, is_ending: bool, is_due: impl Fn(&Known) -> bool) {
        let due = |(address, known): (&String, &Known)| {
            is_due(known).then(|| (address.clone(), known.client.clone()))
        };
        let due: Vec<_> = self.coordinators.lock().iter().filter_map(due).collect();
        for (address, client) in due {
            let told = client.tell_of(&self.worker, is_ending);
            let (mut coordinators, now) = (self.coordinators.lock(), Instant::now());
            let Some(known) = coordinators.get_mut(&address) else { continue };
            known.told = now;
            match told {
                Ok(()) => known.answered = now,
                // Another one has its address, or it does not take signs of life.
                Err(ClientError::Stale(_) | ClientError::Refused(_)) => {
                    coordinators.remove(&address);
                }
                Err(_) if known.answered.elapsed() > FORGOTTEN_AFTER => {
                    coordinators.remove(&address);
                }
                Err(_) => {}
            }
        }
    }
}
