//! The result of a check.

use std::{collections::BTreeMap, fmt::Write};

use serde::Serialize;

/// Verdict of a check, best first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// Nothing to do.
    Ok,
    /// A run is possible but could be better, or something cannot be checked from here.
    Advice,
    /// A run would fail or lose shots.
    Problem,
}

impl Verdict {
    fn word(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::Advice => "advice",
            Self::Problem => "PROBLEM",
        }
    }
}

/// Result of one check.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Finding {
    /// Name of the check; names are stable.
    pub check: &'static str,
    /// The verdict.
    pub verdict: Verdict,
    /// What was found, in words.
    pub found: String,
    /// Measured values; their names include the unit.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub values: BTreeMap<&'static str, f64>,
    /// What to do, if anything.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub advice: Option<String>,
}

impl Finding {
    /// Nothing to do.
    pub fn ok(check: &'static str, found: impl Into<String>) -> Self {
        let (found, values) = (found.into(), BTreeMap::new());
        Self { check, verdict: Verdict::Ok, found, values, advice: None }
    }

    /// Something could be better.
    pub fn advice(check: &'static str, found: impl Into<String>, todo: impl Into<String>) -> Self {
        Self { verdict: Verdict::Advice, advice: Some(todo.into()), ..Self::ok(check, found) }
    }

    /// A run would fail or lose shots.
    pub fn problem(check: &'static str, found: impl Into<String>, todo: impl Into<String>) -> Self {
        Self { verdict: Verdict::Problem, advice: Some(todo.into()), ..Self::ok(check, found) }
    }

    /// Adds a measured value.
    pub fn with(mut self, name: &'static str, value: f64) -> Self {
        self.values.insert(name, value);
        self
    }
}

/// The findings as text: one line each, and one for its advice.
pub fn report(findings: &[Finding]) -> String {
    let width = findings.iter().map(|finding| finding.check.len()).max().unwrap_or(0);
    let mut text = String::new();
    for finding in findings {
        // Writing to a String does not fail.
        let _ = writeln!(
            text,
            "{:<7}  {:<width$}  {}",
            finding.verdict.word(),
            finding.check,
            finding.found
        );
        if let Some(advice) = &finding.advice {
            let _ = writeln!(text, "{:<7}  {:<width$}  -> {advice}", "", "");
        }
    }
    let of = |verdict| findings.iter().filter(|finding| finding.verdict == verdict).count();
    let _ = write!(
        text,
        "{} checks: {} ok, {} with advice, {} with a problem",
        findings.len(),
        of(Verdict::Ok),
        of(Verdict::Advice),
        of(Verdict::Problem)
    );
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn advice_is_printed_below_its_finding() {
        let findings = [
            Finding::ok("cores", "8"),
            Finding::problem("output folder", "read-only", "mount it rw"),
        ];
        assert_eq!(
            report(&findings),
            "ok       cores          8\n\
             PROBLEM  output folder  read-only\n\
             \u{20}                       -> mount it rw\n\
             2 checks: 1 ok, 0 with advice, 1 with a problem"
        );
    }
}
