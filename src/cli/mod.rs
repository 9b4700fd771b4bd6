//! The command line: `lfpiv init | check | plan | timing | simulate | calibrate | process | correlate | run |
//! replay | serve | compare | statistics | export | merge | sim-bench | devices | doctor | bench | peers`.
//!
//! Results and tables go to standard output, logs, progress and errors to standard error. The
//! exit code is 0 when everything asked for was done, 1 when not, 2 for a wrong command line, 3 when
//! everything was done that a damaged or incomplete record of a run allows.

mod beside;
mod calibrate;
mod card_file;
mod check;
mod compare;
mod correlate;
pub mod daemon;
mod daemon_plan;
mod demo_table;
mod devices;
mod doctor;
#[cfg(feature = "aravis")]
mod drive;
mod examples;
mod export;
mod finding;
mod init;
mod instruments;
mod ledger_file;
pub mod logging;
mod losses;
mod merge;
mod operator;
pub mod output;
mod plan;
mod process;
mod process_jobs;
mod process_parts;
mod process_run;
#[cfg(feature = "aravis")]
mod recorded_bench;
mod recorded_frames;
mod recorded_shots;
mod recording;
mod replay;
mod run;
mod run_folder;
mod run_info;
mod run_processor;
mod serve;
mod service;
mod shot_range;
mod sim_bench;
mod simulate;
mod solver;
mod statistics;
mod stop;
mod streamed;
mod timing;
mod volume_reader;

use std::process::ExitCode;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};

pub use beside::BesideArgs;
pub use calibrate::CalibrateArgs;
pub use check::CheckArgs;
pub use compare::CompareArgs;
pub use correlate::CorrelateArgs;
pub use doctor::DoctorArgs;
pub use export::ExportArgs;
pub use init::InitArgs;
pub use merge::MergeArgs;
pub use plan::PlanArgs;
pub use process::ProcessArgs;
pub use replay::ReplayArgs;
pub use run::RunArgs;
pub use serve::ServeArgs;
pub use sim_bench::SimBenchArgs;
pub use simulate::SimulateArgs;
pub use statistics::StatisticsArgs;
pub use streamed::Streamed;
pub use timing::TimingArgs;
pub use volume_reader::ReadVolumesArgs;

/// Dual-camera light-field particle image velocimetry.
#[derive(Debug, Parser)]
#[command(version, propagate_version = true)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Write a commented configuration, from what is asked about the bench.
    Init(InitArgs),
    /// Check a configuration and print what will be done with it.
    Check(CheckArgs),
    /// How well a bench will measure, before it is built, and what would improve it most.
    Plan(PlanArgs),
    /// Draw the timing diagram of a configuration, as text and as SVG.
    Timing(TimingArgs),
    /// Make image pairs of a known flow by ray tracing.
    Simulate(SimulateArgs),
    /// Find out from images made for it what a camera is.
    Calibrate(CalibrateArgs),
    /// Measure recorded image pairs.
    Process(ProcessArgs),
    /// Measure two volumes that are reconstructed already.
    Correlate(CorrelateArgs),
    /// Run the bench: acquire, measure, serve and store.
    Run(RunArgs),
    /// Play a recorded run again, through the same pipeline.
    Replay(ReplayArgs),
    /// Show a run that is over in a browser, as one under way.
    Serve(ServeArgs),
    /// Hold the results of a run played again against those of the run.
    Compare(CompareArgs),
    /// Mean, fluctuations, Reynolds stresses of a run, how sure they are, and how far fluctuations reach.
    Statistics(StatisticsArgs),
    /// Write a run's images or vectors in the files of other programs.
    Export(ExportArgs),
    /// Make few NetCDF files of the many that a run has sealed under way.
    Merge(MergeArgs),
    /// Put simulated instruments at the ends of real wires, for a daemon to run.
    SimBench(SimBenchArgs),
    /// List the cameras on the network.
    Devices,
    /// Look whether this machine is fit for the bench, and say what to do.
    Doctor(DoctorArgs),
    /// Measure speed against error of declared cases and methods, and write a report.
    #[command(disable_help_flag = true)]
    Bench(BesideArgs),
    /// Make cases that other programs can be timed on, and time this one (see bench/peers).
    #[command(disable_help_flag = true)]
    Peers(BesideArgs),
    /// Read volumes for a parent that must not die of them.
    #[command(hide = true)]
    ReadVolumes(ReadVolumesArgs),
}

/// Done, but some of the recorded data was damaged or missing.
const DAMAGED: u8 = 3;

/// Parses the command line, does what it says and reports errors.
pub fn main() -> ExitCode {
    let matches = examples::with_examples(Cli::command()).get_matches();
    let cli = Cli::from_arg_matches(&matches).unwrap_or_else(|error| error.exit());
    logging::start();
    let done = match cli.command {
        Command::Init(args) => init::init(&args),
        Command::Check(args) => check::check(&args),
        Command::Plan(args) => plan::plan(&args),
        Command::Timing(args) => timing::timing(&args),
        Command::Simulate(args) => simulate::simulate(&args),
        Command::Calibrate(args) => calibrate::calibrate(&args),
        Command::Process(args) => process::process(&args),
        Command::Correlate(args) => correlate::correlate(&args),
        Command::Run(args) => run::run(args),
        Command::Replay(args) => replay::replay_run(&args),
        Command::Serve(args) => serve::serve_run(&args),
        Command::Compare(args) => compare::compare_runs(&args),
        Command::Statistics(args) => statistics::statistics(&args),
        Command::Export(args) => export::export(&args),
        Command::Merge(args) => merge::merge(&args),
        Command::SimBench(args) => sim_bench::sim_bench(&args),
        Command::Devices => devices::devices(),
        Command::Doctor(args) => doctor::doctor(&args),
        Command::Bench(args) => beside::start("bench", &args),
        Command::Peers(args) => beside::start("peers", &args),
        Command::ReadVolumes(args) => volume_reader::read_for_parent(&args),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            logging::complain(&error);
            if error.is::<losses::DamagedRecord>() {
                ExitCode::from(DAMAGED)
            } else {
                ExitCode::FAILURE
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use clap::CommandFactory;

    #[test]
    fn the_command_line_is_consistent() {
        super::Cli::command().debug_assert();
    }
}
