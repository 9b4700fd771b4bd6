//! Campaigns and their cases.

use std::{
    env, fs,
    panic::{AssertUnwindSafe, catch_unwind},
    time::{Duration, Instant},
};

use rand::SeedableRng;
use rand_pcg::Pcg64Mcg;

use crate::{
    child::Ended,
    report::{FaultKind, Report, Tally},
};

/// Default total duration in seconds.
const A_MINUTE: u64 = 60;

/// One kind of attack. A case reports its findings to its [`Case`].
pub trait Campaign {
    /// Runs one case.
    fn run(&mut self, case: &mut Case<'_>);

    /// A remark about the campaign as a whole.
    fn remark(&self) -> String {
        String::new()
    }
}

/// Parameters from the environment: `LFPIV_SOAK_SECONDS`, `LFPIV_SOAK_SEED`, `LFPIV_SOAK_CASE`.
pub struct Plan {
    /// Seconds for all campaigns together.
    pub seconds: u64,
    /// Seed of all random numbers.
    pub seed: u64,
    /// Runs only this case of this campaign.
    only: Option<(String, u64)>,
    /// A dedicated soak: limits that depend on the load of the machine are checked, too.
    pub is_soak: bool,
}

impl Plan {
    /// # Panics
    /// A variable has an invalid value.
    pub fn from_environment() -> Self {
        let number = |name: &str| {
            let text = env::var(name).ok().filter(|text| !text.is_empty())?;
            Some(text.parse::<u64>().unwrap_or_else(|_| panic!("{name}={text} is not a number")))
        };
        let only = env::var("LFPIV_SOAK_CASE").ok().filter(|text| !text.is_empty()).map(|text| {
            let case = text.split_once(':').and_then(|(name, n)| Some((name, n.parse().ok()?)));
            let (name, number): (&str, u64) =
                case.unwrap_or_else(|| panic!("LFPIV_SOAK_CASE={text}: like flips:123"));
            (name.to_owned(), number)
        });
        let seconds = number("LFPIV_SOAK_SECONDS");
        Self {
            seconds: seconds.unwrap_or(A_MINUTE),
            seed: number("LFPIV_SOAK_SEED").unwrap_or(1),
            only,
            is_soak: seconds.is_some(),
        }
    }

    /// Runs cases of a campaign for its share of the time, at least one.
    pub fn campaign<C: Campaign>(
        &self,
        report: &mut Report,
        name: &'static str,
        share: f64,
        prepare: impl FnOnce() -> C,
    ) {
        let only = match &self.only {
            Some((campaign, _)) if campaign != name => return,
            only => only.as_ref().map(|(_, number)| *number),
        };
        let began = Instant::now();
        let time = Duration::from_secs_f64(self.seconds as f64 * share);
        let mut campaign = prepare();
        let mut tally = Tally::default();
        let mut number = only.unwrap_or(0);
        loop {
            let random = Pcg64Mcg::seed_from_u64(self.case_seed(name, number));
            let mut case = Case { name, number, random, is_soak: self.is_soak, tally: &mut tally };
            let ran = catch_unwind(AssertUnwindSafe(|| campaign.run(&mut case)));
            if let Err(panic) = ran {
                let words = panic.downcast_ref::<String>().map(String::as_str);
                let words = words.or_else(|| panic.downcast_ref::<&str>().copied());
                case.fault(FaultKind::Wrong, words.unwrap_or("the case itself panicked"));
            }
            tally.cases += 1;
            number += 1;
            if only.is_some() || began.elapsed() >= time {
                break;
            }
        }
        tally.seconds = began.elapsed().as_secs_f64();
        tally.remark = campaign.remark();
        report.add(name, tally);
    }

    /// Seed of a case, independent of the cases before it.
    fn case_seed(&self, name: &str, number: u64) -> u64 {
        let campaign = u64::from(crc32fast::hash(name.as_bytes()));
        self.seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) ^ (campaign << 32) ^ number
    }
}

/// One attack: its random numbers and its report.
pub struct Case<'t> {
    name: &'static str,
    number: u64,
    /// The case's random generator.
    pub random: Pcg64Mcg,
    /// See [`Plan::is_soak`].
    pub is_soak: bool,
    /// Statistics of the campaign.
    pub tally: &'t mut Tally,
}

impl<'t> Case<'t> {
    /// A case without a campaign.
    pub fn alone(tally: &'t mut Tally) -> Self {
        Self { name: "alone", number: 0, random: Pcg64Mcg::seed_from_u64(0), is_soak: false, tally }
    }
}

impl Case<'_> {
    /// Reports a fault.
    pub fn fault(&mut self, kind: FaultKind, words: impl Into<String>) {
        let (name, number) = (self.name, self.number);
        self.tally.add_fault(kind, format!("{name}:{number}: {}", words.into()));
    }

    /// Runs `lfpiv` to its end and checks how it ended.
    pub fn lfpiv(&mut self, arguments: &[&str]) -> Ended {
        let ended = Ended::of(arguments);
        self.judge(arguments[0], &ended);
        ended
    }

    /// Reports panics, crashes, hangs, unknown exit codes and a library's diagnostics as faults.
    pub fn judge(&mut self, what: &str, ended: &Ended) {
        self.tally.peak_bytes = self.tally.peak_bytes.max(ended.peak_bytes);
        let words = |how: &str| format!("{what} {how}: {}", ended.last_words());
        if ended.has_hung {
            self.fault(FaultKind::Hang, words("did not end"));
        } else if let Some(signal) = ended.signal {
            self.fault(FaultKind::Crash, words(&format!("ended with signal {signal}")));
        }
        if ended.stderr.contains("panicked at") {
            self.fault(FaultKind::Panic, words("panicked"));
        } else if !matches!(ended.code, None | Some(0..=3)) {
            self.fault(FaultKind::Wrong, words("ended with a code of its own"));
        }
        if ended.stderr.contains("HDF5-DIAG") {
            self.fault(FaultKind::Wrong, words("printed a library's diagnostics"));
        }
    }

    /// Checks the log of a daemon that was killed.
    pub fn judge_log(&mut self, log: &str) {
        if log.contains("panicked at") {
            self.fault(FaultKind::Panic, format!("the daemon panicked: {log}"));
        }
    }

    /// Updates the peak memory with that of a running process.
    pub fn note_memory(&mut self, process: u32) {
        let status = fs::read_to_string(format!("/proc/{process}/status")).unwrap_or_default();
        let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let kilobytes = line.and_then(|line| line.trim().trim_end_matches(" kB").parse().ok());
        let bytes: u64 = kilobytes.unwrap_or(0) << 10;
        self.tally.peak_bytes = self.tally.peak_bytes.max(bytes);
    }
}
