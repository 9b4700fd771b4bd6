//! `lfpiv doctor`: checks whether this machine is fit for the bench. Each check gives a verdict,
//! measured values, and advice.

mod clock;
mod disk;
mod endpoint;
pub mod machine;
pub mod need;
mod network;
mod routes;
mod serial;

use std::path::{Path, PathBuf};

use anyhow::{Context, bail};

use super::{
    finding::{self, Finding, Verdict},
    output::{count, print},
};
use crate::config::{ConfigFile, Purpose};
pub use need::Need;

/// Arguments of `lfpiv doctor`.
#[derive(Debug, clap::Args)]
pub struct DoctorArgs {
    /// Configuration file (TOML) of the bench that the machine must serve. Without it, only the
    /// machine itself is checked.
    #[arg(long, value_name = "FILE")]
    pub config: Option<PathBuf>,
    /// Print one JSON object.
    #[arg(long)]
    pub json: bool,
}

/// Runs all checks and prints the findings; fails only if there is a problem.
pub fn doctor(args: &DoctorArgs) -> anyhow::Result<()> {
    let file = args.config.as_deref();
    let file = file.map(|path| ConfigFile::load_for(Purpose::Bench, path)).transpose()?;
    let findings = examine(file.as_ref());
    let text = if args.json { json(&findings)? } else { finding::report(&findings) };
    print(&text)?;
    let problems = findings.iter().filter(|f| f.verdict == Verdict::Problem).count();
    if problems > 0 {
        bail!("{} found; a run would fail or lose shots", count(problems, "problem"));
    }
    Ok(())
}

fn examine(file: Option<&ConfigFile>) -> Vec<Finding> {
    let need = file.map(|file| Need::of(&file.config));
    let output = file.map_or(Path::new("."), |file| file.config.output.dir.as_path());
    let mut findings = disk::examine(output, need.as_ref());
    let server = file.map(|file| file.config.server.clone()).unwrap_or_default();
    findings.extend(machine::examine(need.as_ref(), &server));
    findings.push(clock::examine());
    if let Some(file) = file {
        findings.push(endpoint::address(file.config.server.address));
        findings.extend(endpoint::tokens(&file.text));
    }
    if let Some(instruments) = file.and_then(|file| file.config.instruments.as_ref()) {
        findings.extend(network::examine(&instruments.camera, need.as_ref()));
        findings.push(serial::examine(Path::new(&instruments.synchroniser.port)));
    }
    findings
}

fn json(findings: &[Finding]) -> anyhow::Result<String> {
    let verdict = findings.iter().map(|finding| finding.verdict).max().unwrap_or(Verdict::Ok);
    let report = serde_json::json!({
        "code_version": env!("CARGO_PKG_VERSION"),
        "verdict": verdict,
        "checks": findings,
    });
    serde_json::to_string_pretty(&report).context("the findings cannot be written as JSON")
}
