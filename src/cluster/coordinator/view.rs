//! What readers see of workers and shots.

use std::time::Instant;

use super::Coordinator;
use crate::cluster::{GivenUpView, Progress, ShotsView};

/// Shots that were given up and are listed with their reasons: the first ones.
const MOST_LISTED: usize = 100;

impl Coordinator {
    /// A worker gives a sign of life, or says that it ends.
    pub fn hear(&self, worker: &str, is_ending: bool) {
        let (mut state, now) = (self.state.lock(), Instant::now());
        match is_ending {
            true => state.crew.leave(worker, now),
            false => state.see(worker, now),
        }
    }

    /// Number of workers heard of.
    pub fn workers(&self) -> usize {
        self.state.lock().crew.len()
    }

    /// Workers as they are at `now`, and what has become of the shots.
    pub fn progress(&self, now: Instant) -> Progress {
        let state = self.state.lock();
        let workers = state.crew.view(now, &state.tally.tries_by_worker());
        let dead = state.tally.dead();
        let shots = ShotsView {
            backlog: state.tally.open().len() as u64,
            in_hand: workers.iter().map(|worker| worker.in_hand).sum(),
            given_up: dead.len() as u64,
            attempts: state.tally.attempts() as u64,
            lost_workers: state.tally.lost() as u64,
            refused_results: state.refused as u64,
        };
        let given_up = dead.into_iter().take(MOST_LISTED);
        let given_up = given_up.map(|(shot, reasons)| GivenUpView { shot, reasons }).collect();
        Progress { workers, shots, given_up }
    }
}
