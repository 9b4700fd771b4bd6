//! One line of the comparison.

use std::{fs, time::Instant};

use lfpiv_core::statistics::median;
use serde::Serialize;

use crate::child::high_water_bytes;

/// What one method took and reached on one case. Absent values do not apply.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    /// Name of the case's folder.
    pub case: String,
    /// What was done.
    pub method: String,
    /// Whose program.
    pub peer: &'static str,
    /// Its version.
    pub version: &'static str,
    /// Threads that worked.
    pub threads: usize,
    /// Median wall-clock seconds of what `seconds_of` says.
    pub seconds: f64,
    /// Mean processor seconds of the same, over all threads, where the system tells: what stays
    /// comparable on a busy machine.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cpu_seconds: Option<f64>,
    /// What the seconds are those of.
    pub seconds_of: &'static str,
    /// Seconds for what is made once for a bench: tables, plans, a matrix.
    pub assembly_seconds: f64,
    /// Reconstruction quality factor.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub q: Option<f64>,
    /// Passes over all views.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub iterations: Option<usize>,
    /// Vectors measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub vectors: Option<usize>,
    /// Mean absolute error along x, y, z, in voxels.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub mean_abs_error_vox: Option<[f64; 3]>,
    /// Peak memory of the whole process, in MB, where the system tells.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub peak_mb: Option<f64>,
}

impl Row {
    /// A row of this program, on the threads in force.
    pub(super) fn own(
        case: String,
        method: String,
        (assembly_seconds, cost): (f64, Cost),
        seconds_of: &'static str,
    ) -> Self {
        Self {
            case,
            method,
            peer: "lfpiv",
            version: env!("CARGO_PKG_VERSION"),
            threads: rayon::current_num_threads(),
            seconds: cost.median_seconds,
            cpu_seconds: cost.cpu_seconds,
            seconds_of,
            assembly_seconds,
            q: None,
            iterations: None,
            vectors: None,
            mean_abs_error_vox: None,
            peak_mb: peak_mb(),
        }
    }
}

/// What a work that was repeated costs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cost {
    /// Median wall-clock seconds.
    pub median_seconds: f64,
    /// Mean processor seconds over all threads, where the system tells.
    pub cpu_seconds: Option<f64>,
}

/// The result of `work`, and the seconds it took.
pub(super) fn timed<T>(work: impl FnOnce() -> T) -> (T, f64) {
    let started = Instant::now();
    let result = work();
    (result, started.elapsed().as_secs_f64())
}

/// The result of `work`, and what it cost when it was done `repeats` times (at least once).
pub(super) fn repeated<T>(repeats: usize, work: impl Fn() -> T) -> (T, Cost) {
    let cpu_before = cpu_seconds();
    let (mut result, first) = timed(&work);
    let mut seconds = vec![first];
    for _ in 1..repeats {
        let again = timed(&work);
        result = again.0;
        seconds.push(again.1);
    }
    let cpu_seconds = cpu_seconds().zip(cpu_before).map(|(now, before)| now - before);
    let cpu_seconds = cpu_seconds.map(|all| all / seconds.len() as f64);
    (result, Cost { median_seconds: median(seconds).unwrap_or_default(), cpu_seconds })
}

/// Processor seconds of all threads of this process that still run.
fn cpu_seconds() -> Option<f64> {
    let of_thread = |thread: fs::DirEntry| -> Option<f64> {
        let text = fs::read_to_string(thread.path().join("schedstat")).ok()?;
        let on_processor_ns: f64 = text.split_whitespace().next()?.parse().ok()?;
        Some(on_processor_ns * 1e-9)
    };
    fs::read_dir("/proc/self/task").ok()?.map(|thread| of_thread(thread.ok()?)).sum()
}

/// Largest resident memory of this process so far, in MB of 10⁶ bytes.
fn peak_mb() -> Option<f64> {
    Some(high_water_bytes(std::process::id())? as f64 / 1e6)
}
