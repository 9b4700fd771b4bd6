//! Standard output and the progress bar.

use std::io::{self, Write};

use anyhow::Context;
use indicatif::{ProgressBar, ProgressStyle};

/// Writes a line to standard output. A closed pipe (`lfpiv … | head`) is not an error.
pub fn print(line: &str) -> anyhow::Result<()> {
    print_while_read(line).map(|_| ())
}

/// As [`print`], for what goes on without end: whether there is still a reader.
pub fn print_while_read(line: &str) -> anyhow::Result<bool> {
    match writeln!(io::stdout(), "{line}") {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(false),
        written => written.context("cannot write to standard output").map(|()| true),
    }
}

/// A progress bar with the remaining time on standard error; hidden unless that is a terminal.
pub fn progress_bar(steps: usize, what: &str) -> ProgressBar {
    let style = ProgressStyle::with_template(&format!(
        "{{bar:30}} {{pos}} of {{len}} {what}, {{elapsed}} gone, {{eta}} left  {{msg}}"
    ));
    let bar = ProgressBar::new(steps as u64);
    // An invalid template only changes the appearance.
    bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

/// "1 shot", "2 shots".
pub fn count(number: usize, what: &str) -> String {
    if number == 1 { format!("1 {what}") } else { format!("{number} {what}s") }
}
