//! The `lfpiv` command.

use std::process::ExitCode;

fn main() -> ExitCode {
    lfpiv::cli::main()
}
