//! `lfpiv-bench`, which `lfpiv bench`, `lfpiv validate` and `lfpiv peers` start.

mod peers_command;
mod report_command;
mod validate_command;

use std::process::ExitCode;

use clap::{Parser, Subcommand};
use lfpiv::cli::logging;

use peers_command::PeersCommand;
use report_command::BenchArgs;
use validate_command::ValidateArgs;

/// Speed against error of lfpiv, beside other programs.
#[derive(Debug, Parser)]
#[command(version, propagate_version = true)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Measure speed against error of declared cases and methods, and write a report.
    Bench(BenchArgs),
    /// Compare one and two light-field cameras and planar PIV on a simulated round jet, as the paper does.
    Validate(ValidateArgs),
    /// Make cases that other programs can be timed on, and time this one (see bench/peers).
    #[command(subcommand)]
    Peers(PeersCommand),
}

fn main() -> ExitCode {
    let cli = Cli::parse();
    logging::start();
    let done = match cli.command {
        Command::Bench(args) => report_command::bench(&args),
        Command::Validate(args) => validate_command::validate(&args),
        Command::Peers(command) => peers_command::peers(&command),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            logging::print_error(&error);
            ExitCode::FAILURE
        }
    }
}
