//! Keeps the broker's jobs as they should be: one for each shot without a result.

use std::{collections::BTreeMap, sync::Arc, time::Duration};

use crate::{
    acquisition::journal::RecordedRun,
    cluster::{ClusterError, Conditions, Coordinator, Job, JobQueue, PROTOCOL, Shot},
};

/// Jobs in the broker at once. More would only make its lists longer.
const MOST_OFFERED: usize = 1000;
/// Pause between two looks at the broker's jobs.
const OFFER_INTERVAL: Duration = Duration::from_secs(1);

/// What all jobs of a run have in common.
pub(super) struct Offers {
    pub coordinator: Arc<Coordinator>,
    pub recorded: RecordedRun,
    pub run: String,
    pub run_name: String,
    pub conditions: Conditions,
    pub model_sha256: String,
    pub address: String,
    pub token: String,
    pub heartbeat_timeout: Duration,
    pub deadline: Duration,
    /// The number of the next offers of shots that were offered before.
    pub issues: BTreeMap<u64, u32>,
    pub first_issue: u32,
}

impl Offers {
    /// Offers for ever. The broker may come and go.
    pub async fn keep_up(mut self, queue: JobQueue) {
        let mut is_clean = false;
        let mut trouble = None;
        loop {
            let done = self.refresh(&queue, &mut is_clean).await;
            let now = done.err().map(|error| error.to_string());
            // Once, not every second.
            if let Some(words) = now.as_ref().filter(|_| trouble.is_none()) {
                tracing::warn!("{words}; it is tried again");
            }
            trouble = now;
            tokio::select! {
                () = tokio::time::sleep(OFFER_INTERVAL) => {}
                () = queue.reconnected() => {}
            }
        }
    }

    async fn refresh(&mut self, queue: &JobQueue, is_clean: &mut bool) -> Result<(), ClusterError> {
        if !*is_clean {
            // Those of an earlier coordinator name its address and token.
            queue.withdraw(&self.run, self.heartbeat_timeout).await?;
            *is_clean = true;
        }
        let coordinator = self.coordinator.clone();
        let open = coordinator.open_shots(MOST_OFFERED);
        let shots: Vec<u64> = open.iter().map(|shot| shot.trigger).collect();
        let (run, heartbeat_timeout) = (self.run.clone(), self.heartbeat_timeout);
        let find = |shot: u64| open.iter().find(|open| open.trigger == shot);
        let offered = queue
            .offer(&run, &shots, heartbeat_timeout, |shot| {
                // A damaged header is found again, and noted, by the coordinator itself.
                match Shot::of(&self.recorded, find(shot)?) {
                    Ok(described) => Some(self.job(described)),
                    Err(error) => {
                        self.coordinator.unreadable(shot, &error);
                        None
                    }
                }
            })
            .await?;
        if offered > 0 {
            tracing::info!("{offered} of {} open shots are offered to workers", shots.len());
        }
        Ok(())
    }

    fn job(&mut self, shot: Shot) -> Job {
        let issue = self.issues.entry(shot.number).or_insert(self.first_issue);
        let offered = *issue;
        *issue += 1;
        Job {
            protocol: PROTOCOL,
            run: self.run.clone(),
            run_name: self.run_name.clone(),
            shot,
            issue: offered,
            conditions: self.conditions.clone(),
            model_sha256: self.model_sha256.clone(),
            address: self.address.clone(),
            token: self.token.clone(),
            heartbeat_ms: u64::try_from(self.heartbeat_timeout.as_millis() / 4)
                .unwrap_or(u64::MAX)
                .max(10),
            deadline_ms: u64::try_from(self.deadline.as_millis()).unwrap_or(u64::MAX),
        }
    }
}
