//! Keeps the broker's jobs as they should be: one for each shot without a result.

use std::{collections::BTreeMap, sync::Arc, time::Duration};

use super::{ClusterError, Conditions, Coordinator, Job, JobQueue, PROTOCOL, Shot, Tokens};
use crate::acquisition::journal::RecordedShot;

/// Jobs in the broker at once. More would only make its lists longer.
const MOST_OFFERED: usize = 1000;
/// Pause between two looks at the broker's jobs.
const OFFER_INTERVAL: Duration = Duration::from_secs(1);

/// What all jobs of a run have in common.
pub(super) struct Offers {
    pub coordinator: Arc<Coordinator>,
    pub run: String,
    pub run_name: String,
    pub conditions: Conditions,
    pub model_sha256: String,
    pub address: String,
    pub tokens: Tokens,
    pub heartbeat_timeout: Duration,
    pub deadline: Duration,
    /// The number of the next offers of shots that were offered before.
    pub issues: BTreeMap<u64, u32>,
    pub first_issue: u32,
}

impl Offers {
    /// Offers for ever. The broker may come and go.
    pub async fn keep_up(mut self, queue: JobQueue) {
        let coordinator = self.coordinator.clone();
        let mut is_clean = false;
        let mut trouble = None;
        let mut looks = tokio::time::interval(OFFER_INTERVAL);
        looks.set_missed_tick_behavior(tokio::time::MissedTickBehavior::Delay);
        loop {
            let done = tokio::select! {
                _ = looks.tick() => self.refresh(&queue, &mut is_clean).await,
                () = queue.reconnected() => self.refresh(&queue, &mut is_clean).await,
                // What is offered for the first time needs no look at the others.
                () = coordinator.added(), if is_clean && trouble.is_none() => {
                    self.offer_new(&queue).await
                }
            };
            let now = done.err().map(|error| error.to_string());
            // Once, not every second.
            if let Some(words) = now.as_ref().filter(|_| trouble.is_none()) {
                tracing::warn!("{words}; it is tried again");
            }
            trouble = now;
        }
    }

    /// Offers what has neither a result nor a job.
    async fn refresh(&mut self, queue: &JobQueue, is_clean: &mut bool) -> Result<(), ClusterError> {
        if !*is_clean {
            // Those of an earlier coordinator name its address and token.
            queue.withdraw(&self.run, self.heartbeat_timeout).await?;
            *is_clean = true;
        }
        let open = self.coordinator.open_shots(MOST_OFFERED);
        let shots: Vec<u64> = open.iter().map(|shot| shot.trigger).collect();
        let (run, heartbeat_timeout) = (self.run.clone(), self.heartbeat_timeout);
        let missing = queue.missing(&run, &shots, heartbeat_timeout).await?;
        let mut offered = 0;
        for shot in open.iter().filter(|shot| missing.contains(&shot.trigger)) {
            // Its job may have gone since, with its result.
            if self.coordinator.is_open(shot.trigger) {
                offered += usize::from(self.offer(queue, shot).await?);
            }
        }
        if offered > 0 {
            tracing::info!("{offered} of {} open shots are offered to workers", shots.len());
        }
        Ok(())
    }

    /// Offers the shots that were never offered before.
    async fn offer_new(&mut self, queue: &JobQueue) -> Result<(), ClusterError> {
        for shot in self.coordinator.open_shots(MOST_OFFERED) {
            if !self.issues.contains_key(&shot.trigger) {
                self.offer(queue, &shot).await?;
            }
        }
        Ok(())
    }

    /// Whether there is a job now.
    async fn offer(&mut self, queue: &JobQueue, shot: &RecordedShot) -> Result<bool, ClusterError> {
        let (coordinator, shot) = (self.coordinator.clone(), shot.clone());
        // The record is on a disk.
        let described = tokio::task::spawn_blocking(move || {
            let described = Shot::of(coordinator.run(), &shot);
            // A damaged header is found again, and noted, by the coordinator itself.
            described.inspect_err(|error| coordinator.unreadable(shot.trigger, error)).ok()
        });
        let Ok(Some(described)) = described.await else { return Ok(false) };
        let job = self.job(described);
        queue.publish(&job).await?;
        Ok(true)
    }

    fn job(&mut self, shot: Shot) -> Job {
        // Counted even if the broker does not answer: perhaps it has the job.
        let next = self.issues.entry(shot.number).or_insert(self.first_issue);
        let issue = *next;
        *next += 1;
        Job {
            protocol: PROTOCOL,
            run: self.run.clone(),
            run_name: self.run_name.clone(),
            shot,
            issue,
            conditions: self.conditions.clone(),
            model_sha256: self.model_sha256.clone(),
            address: self.address.clone(),
            tokens: self.tokens.clone(),
            heartbeat_ms: u64::try_from(self.heartbeat_timeout.as_millis() / 4)
                .unwrap_or(u64::MAX)
                .max(10),
            deadline_ms: u64::try_from(self.deadline.as_millis()).unwrap_or(u64::MAX),
        }
    }
}
