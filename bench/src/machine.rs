//! On what, with what and when: the facts without which a figure means nothing.

use std::fs;

use serde::Serialize;
use time::{OffsetDateTime, macros::format_description};

/// Where a row comes from.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Stamp {
    /// Processor model.
    pub machine: String,
    /// Logical processors that this process may use.
    pub cores: usize,
    /// Threads that the numerics run on.
    pub threads: usize,
    /// Package version and commit.
    pub version: String,
    /// Day and time of the run's start, UTC.
    pub date: String,
}

impl Stamp {
    /// This machine, this program, now.
    pub fn now() -> Self {
        let format = format_description!("[year]-[month]-[day] [hour]:[minute] UTC");
        Self {
            machine: processor_model(),
            cores: std::thread::available_parallelism().map_or(1, |n| n.get()),
            threads: rayon::current_num_threads(),
            version: lfpiv::CODE_VERSION.to_owned(),
            date: OffsetDateTime::now_utc().format(format).unwrap_or_default(),
        }
    }
}

/// The first processor's name as the kernel gives it; the architecture where it gives none.
fn processor_model() -> String {
    let listed = fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = listed.lines().find_map(|line| {
        let (key, value) = line.split_once(':')?;
        (key.trim() == "model name").then(|| value.trim().to_owned())
    });
    name.unwrap_or_else(|| std::env::consts::ARCH.to_owned())
}
