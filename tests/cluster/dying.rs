//! Workers of which one is killed now and then, and another one comes.

use std::{path::Path, time::Duration};

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use crate::processes::{Process, worker};

/// How many are there at a time.
const WORKERS: usize = 3;
/// Longest wait before a worker is killed, in ms.
const LONGEST_MS: u64 = 100;

/// See the module.
pub struct DyingWorkers<'a> {
    root: &'a Path,
    url: &'a str,
    random: Pcg64Mcg,
    /// Each has a name of its own.
    started: usize,
    workers: Vec<(String, Process)>,
}

impl<'a> DyingWorkers<'a> {
    /// Workers of the broker at `url`, which die at moments of the random numbers from `seed`.
    pub fn start(root: &'a Path, url: &'a str, seed: u64) -> Self {
        let random = Pcg64Mcg::seed_from_u64(seed);
        let mut all = Self { root, url, random, started: 0, workers: Vec::new() };
        (0..WORKERS).for_each(|_| all.start_another());
        all
    }

    /// One of them dies at some moment, and another one comes.
    pub fn kill_one(&mut self) {
        self.pause(LONGEST_MS);
        let victim = self.random.random_range(0..self.workers.len());
        self.kill(victim);
    }

    /// Some pause, shorter than `longest_ms`.
    pub fn pause(&mut self, longest_ms: u64) {
        std::thread::sleep(Duration::from_millis(self.random.random_range(0..longest_ms)));
    }

    /// One of them dies over a shot, and another one comes: it stands still, and `has_in_hand` tells, by its name, whether
    /// it has one then.
    pub fn kill_one_over_a_shot(&mut self, has_in_hand: impl Fn(&str) -> bool) {
        for victim in (0..WORKERS).cycle() {
            let (name, process) = &self.workers[victim];
            process.signal("STOP");
            // What it has sent already is taken in meanwhile.
            std::thread::sleep(Duration::from_millis(50));
            if has_in_hand(name) {
                return self.kill(victim);
            }
            process.signal("CONT");
            std::thread::sleep(Duration::from_millis(5));
        }
    }

    fn kill(&mut self, victim: usize) {
        self.workers.swap_remove(victim).1.kill();
        self.start_another();
    }

    fn start_another(&mut self) {
        let name = format!("worker {}", self.started);
        self.started += 1;
        let process = worker(self.root, self.url, &name, &[]);
        self.workers.push((name, process));
    }
}
