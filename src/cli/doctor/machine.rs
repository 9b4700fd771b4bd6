//! Checks processor, memory and limits.

use std::fs;

use lfpiv_hw::gige::{RECEIVING_NICE, RECEIVING_REALTIME_PRIORITY};
use rustix::process::{Resource, getrlimit};

use super::{
    Finding, Need,
    need::{cores, mb},
};
use crate::{config::ServerSettings, server::open_files_needed};

/// Memory for tables and volumes of a large bench.
const PROGRAM_BYTES: f64 = 512e6;
/// A run needs at least this many open files.
const LEAST_FILES: u64 = 256;

/// Checks of the machine; a configuration, if given, makes them more exact.
pub fn examine(need: Option<&Need>, server: &ServerSettings) -> Vec<Finding> {
    let available = free_memory_bytes();
    let governor = fs::read_to_string("/sys/devices/system/cpu/cpu0/cpufreq/scaling_governor");
    vec![
        processor(cores(), &instruction_sets()),
        memory(available, need),
        power(governor.ok().as_deref().map(str::trim)),
        priority(&Priorities::of_this_process()),
        files(getrlimit(Resource::Nofile).maximum, server),
    ]
}

fn processor(cores: usize, sets: &[&str]) -> Finding {
    const CHECK: &str = "processor";
    let words = if sets.is_empty() { "no known vector instructions" } else { &sets.join(", ") };
    let found = format!("{cores} cores, {words}");
    let fast = sets.iter().any(|set| ["avx2", "avx512f", "neon"].contains(set));
    let finding = if !fast {
        Finding::advice(
            CHECK,
            found,
            "the reconstruction runs several times slower without AVX2: use a newer machine, or \
             let the hypervisor pass through the host's processor",
        )
    } else if cores < 2 {
        let todo = "acquisition and processing share a core: give at least two";
        Finding::advice(CHECK, found, todo)
    } else {
        Finding::ok(CHECK, found)
    };
    finding.with("cores", cores as f64)
}

/// Vector instructions that the code can use.
fn instruction_sets() -> Vec<&'static str> {
    #[cfg(target_arch = "x86_64")]
    let sets = [
        ("sse4.1", std::arch::is_x86_feature_detected!("sse4.1")),
        ("avx2", std::arch::is_x86_feature_detected!("avx2")),
        ("fma", std::arch::is_x86_feature_detected!("fma")),
        ("avx512f", std::arch::is_x86_feature_detected!("avx512f")),
    ];
    #[cfg(target_arch = "aarch64")]
    let sets = [("neon", std::arch::is_aarch64_feature_detected!("neon"))];
    #[cfg(not(any(target_arch = "x86_64", target_arch = "aarch64")))]
    let sets: [(&str, bool); 0] = [];
    sets.into_iter().filter(|(_, there)| *there).map(|(name, _)| name).collect()
}

/// Available memory in bytes, if the system reports it.
pub fn free_memory_bytes() -> Option<f64> {
    fs::read_to_string("/proc/meminfo").ok().and_then(|text| available(&text))
}

/// `MemAvailable` of /proc/meminfo, in bytes.
fn available(meminfo: &str) -> Option<f64> {
    let line = meminfo.lines().find_map(|line| line.strip_prefix("MemAvailable:"))?;
    let kib: f64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(kib * 1024.0)
}

fn memory(available: Option<f64>, need: Option<&Need>) -> Finding {
    const CHECK: &str = "memory";
    let Some(available) = available else {
        let todo = "make sure that some GB are free";
        return Finding::advice(CHECK, "/proc/meminfo cannot be read", todo);
    };
    let needed = PROGRAM_BYTES + need.map_or(0.0, Need::waiting_bytes);
    let found = format!("{} free, up to {} needed", mb(available), mb(needed));
    let todo = "close other programs, add memory or lower pipeline.queue";
    let finding = if available < needed {
        Finding::problem(CHECK, found, todo)
    } else if available < 2.0 * needed {
        Finding::advice(CHECK, found, todo)
    } else {
        Finding::ok(CHECK, found)
    };
    finding.with("available_mb", available / 1e6).with("needed_mb", needed / 1e6)
}

fn power(governor: Option<&str>) -> Finding {
    const CHECK: &str = "power governor";
    match governor {
        None => Finding::ok(CHECK, "none here (virtual machine, or fixed clock)"),
        Some(name @ ("performance" | "schedutil" | "ondemand")) => Finding::ok(CHECK, name),
        Some(name) => Finding::advice(
            CHECK,
            name,
            "it may slow down the processor during acquisition: sudo cpupower frequency-set -g \
             performance",
        ),
    }
}

/// Limits that decide whether receiving threads can have priority.
#[derive(Clone, Copy)]
struct Priorities {
    /// `CAP_SYS_NICE`, which allows any priority.
    capability: bool,
    /// Limit on real-time priority; `None` for no limit.
    realtime: Option<u64>,
    /// 20 minus the lowest nice level; `None` for no limit.
    nice: Option<u64>,
}

impl Priorities {
    fn of_this_process() -> Self {
        let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
        Self {
            capability: has_sys_nice(&status),
            realtime: getrlimit(Resource::Rtprio).current,
            nice: getrlimit(Resource::Nice).current,
        }
    }
}

/// `CAP_SYS_NICE` among the effective capabilities of /proc/self/status.
fn has_sys_nice(status: &str) -> bool {
    const CAP_SYS_NICE: u32 = 23;
    let line = status.lines().find_map(|line| line.strip_prefix("CapEff:"));
    let bits = line.and_then(|line| u64::from_str_radix(line.trim(), 16).ok());
    bits.is_some_and(|bits| bits >> CAP_SYS_NICE & 1 == 1)
}

/// Checks the priority of receiving threads. Real-time scheduling is best, because nice levels
/// count within a session only.
fn priority(may: &Priorities) -> Finding {
    const CHECK: &str = "priority";
    const TODO: &str = "frames may be lost while other programs are busy: run as the service \
        (packaging/lfpiv.service), or sudo setcap cap_sys_nice+ep on the program, or \
        `@video - rtprio 20` in /etc/security/limits.conf for a group of yours";
    let at_least = |limit: Option<u64>, wanted: i32| {
        limit.is_none_or(|limit| limit >= u64::from(wanted.unsigned_abs()))
    };
    if may.capability || at_least(may.realtime, RECEIVING_REALTIME_PRIORITY) {
        Finding::ok(CHECK, "threads that receive frames run before all others")
    } else if at_least(may.nice, 20 - RECEIVING_NICE) {
        Finding::advice(CHECK, "threads that receive frames run first within this session", TODO)
    } else {
        Finding::advice(CHECK, "threads that receive frames run like any other", TODO)
    }
}

/// A run raises its limit to what it needs, up to the hard one.
fn files(hard_limit: Option<u64>, server: &ServerSettings) -> Finding {
    const CHECK: &str = "open files";
    let needed = open_files_needed(server);
    let Some(limit) = hard_limit else { return Finding::ok(CHECK, "no limit") };
    let found = format!("at most {limit}, up to {needed} needed by the run and its connections");
    let todo = format!("ulimit -n {needed}, or LimitNOFILE={needed} in the service's unit");
    let finding = if limit < LEAST_FILES {
        Finding::problem(CHECK, found, todo)
    } else if limit < needed {
        let todo = format!("{todo}; until then fewer connections are allowed");
        Finding::advice(CHECK, found, todo)
    } else {
        Finding::ok(CHECK, found)
    };
    finding.with("limit", limit as f64).with("needed", needed as f64)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::doctor::Verdict;

    #[test]
    fn available_memory_is_compared_with_the_need_of_the_frames() {
        let text = "MemTotal:  16000000 kB\nMemAvailable:    2000000 kB\n";
        assert_eq!(available(text), Some(2_048_000_000.0));
        assert_eq!(available("MemTotal: 1 kB\n"), None);
        let need =
            Need { frame_bytes: vec![1, 1], rate_hz: 1.0, pixels: 1 << 22, shots_in_memory: 6 };
        let verdict = |bytes| memory(Some(bytes), Some(&need)).verdict;
        assert_eq!(verdict(4e9), Verdict::Ok);
        assert_eq!(verdict(1e9), Verdict::Advice);
        assert_eq!(verdict(0.6e9), Verdict::Problem);
        assert_eq!(memory(None, None).verdict, Verdict::Advice);
    }

    #[test]
    fn receiving_threads_need_a_capability_or_a_limit() {
        let none = Priorities { capability: false, realtime: Some(0), nice: Some(0) };
        assert_eq!(priority(&none).verdict, Verdict::Advice);
        assert_eq!(priority(&Priorities { capability: true, ..none }).verdict, Verdict::Ok);
        let realtime = Priorities { realtime: Some(10), ..none };
        assert_eq!(priority(&realtime).verdict, Verdict::Ok);
        let nice = Priorities { nice: Some(30), ..none };
        assert!(priority(&nice).found.contains("within this session"));
        assert!(has_sys_nice("Name: lfpiv\nCapEff:\t0000000000800000\n"));
        assert!(!has_sys_nice("CapEff:\t000000ffff7fffff\n") && !has_sys_nice(""));
    }

    #[test]
    fn limits_and_governors_have_their_verdicts() {
        let server = ServerSettings { tokens: Some("tokens".into()), ..ServerSettings::default() };
        let needed = open_files_needed(&server);
        let more = ServerSettings { connections: 8000, ..server.clone() };
        assert_eq!(files(Some(100), &server).verdict, Verdict::Problem);
        assert_eq!(files(Some(1024), &server).verdict, Verdict::Advice);
        assert_eq!(files(Some(1024), &ServerSettings::default()).verdict, Verdict::Ok);
        assert_eq!(files(Some(needed), &server).verdict, Verdict::Ok);
        assert_eq!(files(Some(needed), &more).verdict, Verdict::Advice);
        assert_eq!(files(None, &more).verdict, Verdict::Ok);
        assert_eq!(power(Some("powersave")).verdict, Verdict::Advice);
        assert_eq!(power(None).verdict, Verdict::Ok);
        assert_eq!(processor(1, &["avx2"]).verdict, Verdict::Advice);
        assert_eq!(processor(8, &["sse4.1"]).verdict, Verdict::Advice);
        assert_eq!(processor(2, &["avx2", "fma"]).found, "2 cores, avx2, fma");
    }
}
