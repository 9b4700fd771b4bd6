//! Logs to standard error: with time and colour on a terminal, with priorities in journald.

use std::{
    fmt, io,
    io::IsTerminal,
    os::fd::{AsFd, BorrowedFd},
};

use tracing::{Event, Level, Subscriber, level_filters::LevelFilter};
use tracing_subscriber::{
    filter::Targets,
    fmt::{FmtContext, FormatEvent, FormatFields, format::Writer},
    prelude::*,
    registry::LookupSpan,
};

/// Starts logging to standard error. `RUST_LOG` sets the filter (`warn`, `info,lfpiv=debug`). The
/// default is `info`, also if the variable is invalid.
pub fn start() {
    let wanted = std::env::var("RUST_LOG").ok().and_then(|wanted| wanted.parse::<Targets>().ok());
    let filter = wanted.unwrap_or_else(|| {
        // What the broker's client does is said in this program's own words.
        Targets::new().with_default(LevelFilter::INFO).with_target("async_nats", LevelFilter::WARN)
    });
    let lines = tracing_subscriber::fmt::layer().with_writer(io::stderr);
    let layer = if is_journal() {
        let format = tracing_subscriber::fmt::format().without_time().with_level(false);
        lines.with_ansi(false).event_format(WithPriority(format.with_ansi(false))).boxed()
    } else {
        lines.with_ansi(io::stderr().is_terminal()).boxed()
    };
    tracing_subscriber::registry().with(layer).with(filter).init();
}

/// Prints the error that ends the program.
pub fn print_error(error: &anyhow::Error) {
    let priority = if is_journal() { Priority::Error.prefix() } else { "" };
    eprintln!("{priority}error: {error:#}");
}

/// Whether standard error is the system's journal.
pub fn is_journal() -> bool {
    let named = std::env::var("JOURNAL_STREAM").ok();
    named.is_some_and(|named| is_stream(&named, io::stderr().as_fd()))
}

/// Whether `JOURNAL_STREAM` (device:inode) refers to this descriptor. Child processes inherit the
/// variable, but their standard error may go elsewhere.
fn is_stream(named: &str, descriptor: BorrowedFd<'_>) -> bool {
    rustix::fs::fstat(descriptor)
        .is_ok_and(|status| named == format!("{}:{}", status.st_dev, status.st_ino))
}

/// Priorities of syslog, written before each line as in sd-daemon(3).
#[derive(Clone, Copy)]
enum Priority {
    Error,
    Warning,
    Info,
    Debug,
}

impl Priority {
    fn of(level: Level) -> Self {
        match level {
            Level::ERROR => Self::Error,
            Level::WARN => Self::Warning,
            Level::INFO => Self::Info,
            _ => Self::Debug,
        }
    }

    fn prefix(self) -> &'static str {
        match self {
            Self::Error => "<3>",
            Self::Warning => "<4>",
            Self::Info => "<6>",
            Self::Debug => "<7>",
        }
    }
}

/// Formats events with a priority before each line.
struct WithPriority<F>(F);

impl<S, N, F> FormatEvent<S, N> for WithPriority<F>
where
    S: Subscriber + for<'a> LookupSpan<'a>,
    N: for<'a> FormatFields<'a> + 'static,
    F: FormatEvent<S, N>,
{
    fn format_event(
        &self,
        context: &FmtContext<'_, S, N>,
        mut writer: Writer<'_>,
        event: &Event<'_>,
    ) -> fmt::Result {
        let mut text = String::new();
        self.0.format_event(context, Writer::new(&mut text), event)?;
        let prefix = Priority::of(*event.metadata().level()).prefix();
        text.lines().try_for_each(|line| writeln!(writer, "{prefix}{line}"))
    }
}

#[cfg(test)]
mod tests {
    use std::{fs::File, os::unix::fs::MetadataExt, sync::Arc};

    use parking_lot::Mutex;

    use super::*;

    #[test]
    fn a_stream_is_identified_by_device_and_inode() {
        let file: File = tempfile::tempfile().unwrap();
        let status = file.metadata().unwrap();
        let (device, inode) = (status.dev(), status.ino());
        assert!(is_stream(&format!("{device}:{inode}"), file.as_fd()));
        for other in [format!("{device}:{}", inode + 1), "".into(), "8".into()] {
            assert!(!is_stream(&other, file.as_fd()), "{other}");
        }
    }

    #[derive(Clone, Default)]
    struct Sink(Arc<Mutex<Vec<u8>>>);

    impl io::Write for Sink {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            self.0.lock().extend(bytes);
            Ok(bytes.len())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn every_line_has_its_priority() {
        let sink = Sink::default();
        let writer = sink.clone();
        let format = tracing_subscriber::fmt::format().without_time().with_level(false);
        let layer = tracing_subscriber::fmt::layer()
            .with_writer(move || writer.clone())
            .with_ansi(false)
            .event_format(WithPriority(format.with_target(false)));
        tracing::subscriber::with_default(tracing_subscriber::registry().with(layer), || {
            tracing::error!(shot = 3, "lost\nfor good");
            tracing::warn!("slow");
            tracing::info!("begun");
            tracing::debug!("details");
        });
        let text = String::from_utf8(sink.0.lock().clone()).unwrap();
        let lines: Vec<&str> = text.lines().map(str::trim).collect();
        assert_eq!(lines[..2], ["<3>lost", "<3>for good shot=3"]);
        assert_eq!(lines[2..], ["<4>slow", "<6>begun", "<7>details"]);
    }
}
