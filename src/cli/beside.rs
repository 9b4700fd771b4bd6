//! `lfpiv bench` and `lfpiv peers`: what measures this program is a program of its own, beside it, so
//! that the one at the laser has no charts and no files for other programs.

use std::{convert::Infallible, ffi::OsString, os::unix::process::CommandExt, process::Command};

use anyhow::{Context, bail};

/// The program that measures this one.
const PROGRAM: &str = "lfpiv-bench";

/// Arguments that the other program reads.
#[derive(Debug, clap::Args)]
pub struct BesideArgs {
    /// See `lfpiv bench --help` and `lfpiv peers --help`.
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, value_name = "ARGUMENTS")]
    pub arguments: Vec<OsString>,
}

/// Becomes `lfpiv-bench COMMAND ARGUMENTS`; returns only when it cannot.
pub fn start(command: &str, args: &BesideArgs) -> anyhow::Result<()> {
    become_other(command, args).map(|never| match never {})
}

fn become_other(command: &str, args: &BesideArgs) -> anyhow::Result<Infallible> {
    let own = std::env::current_exe().context("cannot find this program's own file")?;
    let other = own.with_file_name(PROGRAM);
    if !other.exists() {
        bail!(
            "lfpiv {command} needs {}, which is not there: `cargo build --release` builds it",
            other.display()
        );
    }
    let error = Command::new(&other).arg(command).args(&args.arguments).exec();
    Err(error).with_context(|| format!("cannot start {}", other.display()))
}
