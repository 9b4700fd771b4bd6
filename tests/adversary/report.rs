//! Table of the campaigns' findings.

use std::{
    collections::BTreeMap,
    fmt::{self, Display, Formatter},
};

use crate::campaign::Plan;

/// Faults per campaign that are reported in full.
const MOST_TOLD: usize = 20;

/// Kinds of faults.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum FaultKind {
    /// Acknowledged data, or more than the damage hit, is lost.
    Lost,
    /// A loss is not reported.
    Unreported,
    /// A panic.
    Panic,
    /// A signal that ended a process.
    Crash,
    /// A process that did not end.
    Hang,
    /// Anything else.
    Wrong,
}

/// Statistics of a campaign.
#[derive(Debug, Default)]
pub struct Tally {
    /// Cases.
    pub cases: u64,
    /// Processes killed.
    pub kills: u64,
    /// Files damaged or malformed.
    pub mutations: u64,
    /// Shots acknowledged as synced and checked.
    pub acknowledged: u64,
    /// Peak memory of any process.
    pub peak_bytes: u64,
    /// Duration.
    pub seconds: f64,
    /// Remark of the campaign.
    pub remark: String,
    counts: BTreeMap<FaultKind, u64>,
    told: Vec<String>,
}

impl Tally {
    /// Counts a fault, and keeps the text of the first ones.
    pub fn add_fault(&mut self, kind: FaultKind, words: String) {
        *self.counts.entry(kind).or_default() += 1;
        if self.told.len() < MOST_TOLD {
            self.told.push(format!("{kind:?}: {words}"));
        }
    }

    /// Number of faults of a kind.
    pub fn count(&self, kind: FaultKind) -> u64 {
        self.counts.get(&kind).copied().unwrap_or(0)
    }
}

/// Results of all campaigns.
pub struct Report {
    seed: u64,
    tallies: Vec<(&'static str, Tally)>,
}

impl Report {
    /// An empty report.
    pub fn new(plan: &Plan) -> Self {
        Self { seed: plan.seed, tallies: Vec::new() }
    }

    /// Adds a completed campaign.
    pub fn add(&mut self, name: &'static str, tally: Tally) {
        println!("{name}: {} cases in {:.0} s", tally.cases, tally.seconds);
        self.tallies.push((name, tally));
    }

    /// Whether no fault was found.
    pub fn is_clean(&self) -> bool {
        self.tallies.iter().all(|(_, tally)| tally.counts.is_empty())
    }
}

const KINDS: [FaultKind; 6] = [
    FaultKind::Lost,
    FaultKind::Unreported,
    FaultKind::Panic,
    FaultKind::Crash,
    FaultKind::Hang,
    FaultKind::Wrong,
];

impl Display for Report {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "seed {}\n{:<10} {:>7} {:>7} {:>9} {:>7} {:>6} {:>6} {:>7} {:>7} {:>6} {:>6} {:>8} {:>8}",
            self.seed,
            "campaign",
            "cases",
            "kills",
            "mutations",
            "acked",
            "lost",
            "silent",
            "panics",
            "crashes",
            "hangs",
            "wrong",
            "peak MB",
            "seconds"
        )?;
        for (name, tally) in &self.tallies {
            let Tally { cases, kills, mutations, acknowledged, .. } = tally;
            let [lost, unsaid, panics, crashes, hangs, wrong] = KINDS.map(|kind| tally.count(kind));
            writeln!(
                f,
                "{name:<10} {cases:>7} {kills:>7} {mutations:>9} {acknowledged:>7} {lost:>6} \
                 {unsaid:>6} {panics:>7} {crashes:>7} {hangs:>6} {wrong:>6} {:>8.0} {:>8.0}  {}",
                tally.peak_bytes as f64 / 1e6,
                tally.seconds,
                tally.remark
            )?;
        }
        for words in self.tallies.iter().flat_map(|(_, tally)| &tally.told) {
            writeln!(f, "{words}")?;
        }
        if !self.is_clean() {
            writeln!(
                f,
                "one case alone: LFPIV_SOAK_SEED={} LFPIV_SOAK_CASE=NAME:NUMBER",
                self.seed
            )?;
        }
        Ok(())
    }
}
