//! `lfpiv bench`, `lfpiv validate` and `lfpiv peers`. Benchmarks are a separate program in the same folder, so that
//! the daemon contains no charts and no code for other programs' files.

use std::{convert::Infallible, ffi::OsString, os::unix::process::CommandExt, process::Command};

use anyhow::{Context, bail};

/// The benchmark program.
const PROGRAM: &str = "lfpiv-bench";

/// Arguments passed on to the benchmark program.
#[derive(Debug, clap::Args)]
pub struct ForwardedArgs {
    /// See `lfpiv bench --help`, `lfpiv validate --help` and `lfpiv peers --help`.
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, value_name = "ARGUMENTS")]
    pub arguments: Vec<OsString>,
}

/// Replaces this process by `lfpiv-bench COMMAND ARGUMENTS`; returns only on failure.
pub fn start(command: &str, args: &ForwardedArgs) -> anyhow::Result<()> {
    replace_process(command, args).map(|never| match never {})
}

fn replace_process(command: &str, args: &ForwardedArgs) -> anyhow::Result<Infallible> {
    let own = std::env::current_exe().context("cannot find this program's own file")?;
    let other = own.with_file_name(PROGRAM);
    if !other.exists() {
        bail!(
            "lfpiv {command} needs {}, which does not exist: `cargo build --release` builds it",
            other.display()
        );
    }
    let error = Command::new(&other).arg(command).args(&args.arguments).exec();
    Err(error).with_context(|| format!("cannot start {}", other.display()))
}
