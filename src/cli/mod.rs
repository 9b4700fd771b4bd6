//! The command line: `lfpiv init | check | plan | timing | simulate | calibrate | process | work | scale | correlate |
//! run | replay | serve | compare | statistics | export | merge | sim-bench | devices | doctor | bench | validate |
//! peers`.
//!
//! Results and tables go to standard output; logs, progress and errors go to standard error. Exit
//! codes: 0 when everything requested was done, 1 when not, 2 for a wrong command line, 3 when
//! everything was done that a damaged or incomplete record of a run allows.

mod bench_program;
mod broker_args;
mod calibrate;
mod card_file;
mod check;
mod cluster_run;
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
mod live_cluster;
pub mod logging;
mod losses;
mod measuring;
mod merge;
mod operator;
pub mod output;
mod plan;
mod process;
mod process_cluster;
mod process_jobs;
mod process_parts;
mod process_run;
#[cfg(feature = "aravis")]
mod processor_time;
mod recorded_bench;
mod recorded_frames;
mod recorded_shots;
mod recording;
mod replay;
mod result_writer;
mod run;
mod run_folder;
mod run_info;
mod run_processor;
mod scale;
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
mod work;

use std::process::ExitCode;

use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};

pub use bench_program::ForwardedArgs;
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
pub use scale::ScaleArgs;
pub use serve::ServeArgs;
pub use sim_bench::SimBenchArgs;
pub use simulate::SimulateArgs;
pub use statistics::StatisticsArgs;
pub use streamed::Streamed;
pub use timing::TimingArgs;
pub use volume_reader::ReadVolumesArgs;
pub use work::WorkArgs;

/// Dual-camera light-field particle image velocimetry.
#[derive(Debug, Parser)]
#[command(version, propagate_version = true)]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Write a commented configuration from answers about the bench.
    Init(InitArgs),
    /// Check a configuration and show what a run will do.
    Check(CheckArgs),
    /// Forecast how well a bench will measure, and what would improve it most.
    Plan(PlanArgs),
    /// Draw the timing diagram of a configuration, as text and as SVG.
    Timing(TimingArgs),
    /// Make image pairs of a known flow by ray tracing.
    Simulate(SimulateArgs),
    /// Calibrate cameras from images made for it.
    Calibrate(CalibrateArgs),
    /// Measure recorded image pairs.
    Process(ProcessArgs),
    /// Measure shots on this machine, for `lfpiv run` or `lfpiv process --cluster`, until stopped.
    Work(WorkArgs),
    /// Forecast how many shots a second machines on a network would measure.
    Scale(ScaleArgs),
    /// Measure two volumes that are already reconstructed.
    Correlate(CorrelateArgs),
    /// Run the bench: acquire, measure, serve and store.
    Run(RunArgs),
    /// Replay a recorded run through the same pipeline.
    Replay(ReplayArgs),
    /// Show a finished run in a browser.
    Serve(ServeArgs),
    /// Compare the results of a replay with those of its run.
    Compare(CompareArgs),
    /// Compute a run's mean, fluctuations and Reynolds stresses with uncertainties, and correlation
    /// lengths.
    Statistics(StatisticsArgs),
    /// Export a run's images or vectors in the formats of other programs.
    Export(ExportArgs),
    /// Merge the many NetCDF files of a run into few.
    Merge(MergeArgs),
    /// Connect simulated instruments to real wires, for a daemon to run.
    SimBench(SimBenchArgs),
    /// List the cameras on the network.
    Devices,
    /// Check whether this machine is fit for the bench, and say what to do.
    Doctor(DoctorArgs),
    /// Measure speed against error of declared cases and methods, and write a report.
    #[command(disable_help_flag = true)]
    Bench(ForwardedArgs),
    /// Compare one and two light-field cameras and planar PIV on a simulated round jet, as the paper does.
    #[command(disable_help_flag = true)]
    Validate(ForwardedArgs),
    /// Make cases for timing other programs, and time this one (see bench/peers).
    #[command(disable_help_flag = true)]
    Peers(ForwardedArgs),
    /// Read volumes for a parent process, which must survive crashes of the library.
    #[command(hide = true)]
    ReadVolumes(ReadVolumesArgs),
}

/// Exit code when some of the recorded data was damaged or missing.
const DAMAGED: u8 = 3;

/// Parses the command line, runs the command and reports errors.
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
        Command::Work(args) => work::work(&args),
        Command::Scale(args) => scale::scale(&args),
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
        Command::Bench(args) => bench_program::start("bench", &args),
        Command::Validate(args) => bench_program::start("validate", &args),
        Command::Peers(args) => bench_program::start("peers", &args),
        Command::ReadVolumes(args) => volume_reader::read_for_parent(&args),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            logging::print_error(&error);
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
