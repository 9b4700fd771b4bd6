//! The reference kernel: a fixed amount of work that tells how fast a machine is.
//!
//! Seconds of one machine say little on another; their ratio to this kernel, timed in the same run
//! on the same threads, says more. Half of its work is arithmetic on data in the first-level cache,
//! half is a stream through memory, in f32 and without anything that a compiler could leave out.
//! It must not change: ratios would no longer be comparable.

use std::{hint::black_box, time::Instant};

use rayon::prelude::*;

/// Tasks, each with buffers of its own; more than a machine of today has threads.
const TASKS: usize = 16;

/// y ← a·y + x over so many values in cache, so many times, in each task. In an unoptimised build, as of the tests, the
/// kernel would take minutes: it does about a hundredth of the work there, and ratios to it mean nothing.
const CACHED_VALUES: usize = 2048;
const CACHED_ROUNDS: usize = if cfg!(debug_assertions) { 600 } else { 60_000 };

/// The same over so many values in memory (32 MiB of x and y when optimised), so many times, in each task.
const STREAMED_VALUES: usize = if cfg!(debug_assertions) { 4 << 14 } else { 4 << 20 };
const STREAMED_ROUNDS: usize = 6;

/// Timed runs, of which the median counts.
const RUNS: usize = 5;

/// The kernel's time and what it did.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize)]
pub struct ReferenceKernel {
    /// Median wall-clock time, in s.
    pub seconds: f64,
    /// Multiply-adds in one run.
    pub multiply_adds: u64,
    /// Bytes read and written beyond the caches in one run.
    pub streamed_bytes: u64,
}

/// Times the reference kernel on the current threads: when optimised, about 2·10⁹ multiply-adds in cache and 4·10⁸
/// on 4.8 GB of streamed data.
pub fn reference_seconds() -> ReferenceKernel {
    let mut seconds: Vec<f64> = (0..RUNS)
        .map(|_| {
            let started = Instant::now();
            let sum: f32 = (0..TASKS).into_par_iter().map(task).sum();
            black_box(sum);
            started.elapsed().as_secs_f64()
        })
        .collect();
    seconds.sort_by(f64::total_cmp);
    let streamed = TASKS * STREAMED_VALUES * STREAMED_ROUNDS;
    ReferenceKernel {
        seconds: seconds[RUNS / 2],
        multiply_adds: (TASKS * CACHED_VALUES * CACHED_ROUNDS + streamed) as u64,
        streamed_bytes: (3 * size_of::<f32>() * streamed) as u64,
    }
}

fn task(number: usize) -> f32 {
    let start = 1.0 + number as f32;
    rounds(CACHED_VALUES, CACHED_ROUNDS, start) + rounds(STREAMED_VALUES, STREAMED_ROUNDS, start)
}

/// y ← 0.9·y + x, over and over; the sum of y.
fn rounds(values: usize, rounds: usize, start: f32) -> f32 {
    let x = black_box(vec![start; values]);
    let mut y = vec![0.0f32; values];
    for _ in 0..rounds {
        for (y, x) in y.iter_mut().zip(&x) {
            *y = 0.9 * *y + x;
        }
        black_box(&mut y);
    }
    y.iter().sum()
}
