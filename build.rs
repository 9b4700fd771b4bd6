//! Names the code version: results and reports carry the commit that made them.

use std::process::Command;

/// What the program is made from.
const SOURCES: [&str; 10] = [
    "build.rs",
    "Cargo.lock",
    "Cargo.toml",
    "core/src",
    "hw/src",
    "rawlog/src",
    "sim/src",
    "src",
    "web/bench/dist",
    "web/openapi",
];

fn main() {
    let version = env!("CARGO_PKG_VERSION");
    let commit = git(&["describe", "--always", "--dirty", "--abbrev=10", "--exclude=*"]);
    let code = commit.map_or_else(|| version.to_owned(), |commit| format!("{version} ({commit})"));
    println!("cargo:rustc-env=LFPIV_CODE_VERSION={code}");
    for source in SOURCES {
        println!("cargo:rerun-if-changed={source}");
    }
    if let Some(log) = git(&["rev-parse", "--git-path", "logs/HEAD"])
        && std::path::Path::new(&log).exists()
    {
        println!("cargo:rerun-if-changed={log}");
    }
}

/// What git says; nothing outside of a repository or without git.
fn git(arguments: &[&str]) -> Option<String> {
    let output = Command::new("git").args(arguments).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    (output.status.success() && !text.trim().is_empty()).then(|| text.trim().to_owned())
}
