//! Reads a configuration and reports every problem with its location and the allowed values.

use std::{
    fmt, io,
    ops::Range,
    path::{Path, PathBuf},
};

use garde::Validate;
use thiserror::Error;
use toml::{Table, Value, de::DeTable};

use super::{
    Config, calibration,
    consistency::{Purpose, inconsistencies},
    location::{Entry, KeyPath, Step, entries, line_and_column},
    mask,
    overlong::overlong_arrays,
    range::{allowed_range, is_bound},
};

/// Why a configuration could not be loaded.
#[derive(Debug, Error)]
pub enum ConfigError {
    /// The file cannot be read.
    #[error("cannot read the configuration {}: {reason}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        reason: io::Error,
    },
    /// The content of files that the configuration names could not be appended to its text.
    #[error("calibrations or mask cannot be written as TOML: {0}")]
    Stored(#[from] toml::ser::Error),
    /// The content is invalid; prints each [`Problem`] on a line of its own.
    #[error("{}", list(problems))]
    Invalid {
        /// At least one problem.
        problems: Vec<Problem>,
    },
}

fn list(problems: &[Problem]) -> String {
    problems.iter().map(Problem::to_string).collect::<Vec<_>>().join("\n")
}

/// One problem, such as `run.toml:7:15: volume.voxel_mm = -0.1: allowed 0.001 to 10`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problem {
    /// File name as given.
    pub file: String,
    /// Line, from 1.
    pub line: usize,
    /// Column in characters, from 1.
    pub column: usize,
    /// The key and, where it fits on the line, its value; empty for a syntax error.
    pub subject: String,
    /// What is wrong and what is allowed.
    pub message: String,
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { file, line, column, subject, message } = self;
        write!(f, "{file}:{line}:{column}: ")?;
        if !subject.is_empty() {
            write!(f, "{subject}: ")?;
        }
        write!(f, "{message}")
    }
}

/// Parses and checks a configuration. With a purpose and a folder it also checks the consistency of
/// the tables and loads the files that it names, whose paths are relative to the folder. `file`
/// appears in messages only.
pub(super) fn read(
    file: &str,
    text: &str,
    purpose: Option<(Purpose, &Path)>,
) -> Result<Config, Vec<Problem>> {
    let syntax = |error: toml::de::Error| {
        let byte = error.span().map_or(0, |span| span.start);
        vec![problem(file, text, byte, String::new(), format!("not TOML: {}", error.message()))]
    };
    let entries = entries(DeTable::parse(text).map_err(syntax)?.get_ref());
    let document: Table = toml::from_str(text).map_err(syntax)?;
    let reader = Reader { file, text, entries: &entries, document };
    let not_finite: Vec<_> = entries.iter().filter(|entry| entry.not_finite).collect();
    let mut problems: Vec<_> =
        not_finite.iter().map(|entry| reader.not_finite_problem(entry)).collect();
    let mut config = match toml::from_str::<Config>(text) {
        Ok(config) => config,
        Err(error) => {
            problems.push(reader.type_problem(&error));
            return Err(problems);
        }
    };
    if let Err(report) = config.validate() {
        let document = Value::Table(reader.document.clone());
        for (path, error) in report.iter() {
            let path = KeyPath::parse(&path.to_string()).in_document(&document);
            if !not_finite.iter().any(|entry| path.contains(&entry.path)) {
                problems.push(reader.rule_problem(&path, error.message()));
            }
        }
    }
    problems.extend(reader.overlong_arrays(&config));
    // Consistency is checked only when every value is in its range.
    if let (true, Some((purpose, folder))) = (problems.is_empty(), purpose) {
        if let Some(scene) = &mut config.simulation {
            scene.flow.in_folder(folder);
        }
        let mut found = inconsistencies(&config, purpose);
        // A stored configuration already contains its calibrations.
        if matches!(purpose, Purpose::Images | Purpose::Bench) && config.calibration.is_empty() {
            match calibration::load(&config, folder) {
                Ok(loaded) => config.calibration = loaded,
                Err(inconsistencies) => found.extend(inconsistencies),
            }
        }
        if config.mask.is_none() {
            match mask::load(&config.volume, folder) {
                Ok(loaded) => config.mask = loaded,
                Err(inconsistencies) => found.extend(inconsistencies),
            }
        }
        for inconsistency in found {
            problems.push(
                reader.rule_problem(&KeyPath::parse(&inconsistency.key), &inconsistency.message),
            );
        }
    }
    problems.sort_by_key(|problem| (problem.line, problem.column));
    if problems.is_empty() { Ok(config) } else { Err(problems) }
}

fn problem(file: &str, text: &str, byte: usize, subject: String, message: String) -> Problem {
    let (line, column) = line_and_column(text, byte);
    Problem { file: file.to_owned(), line, column, subject, message }
}

/// The document as text, as locations and as values.
struct Reader<'t> {
    file: &'t str,
    text: &'t str,
    entries: &'t [Entry],
    document: Table,
}

impl Reader<'_> {
    fn problem(&self, byte: usize, subject: String, message: String) -> Problem {
        problem(self.file, self.text, byte, subject, message)
    }

    fn not_finite_problem(&self, entry: &Entry) -> Problem {
        let allowed = allowed_range(&self.document, &entry.path)
            .unwrap_or_else(|| "allowed: a finite number".to_owned());
        self.problem(entry.value.start, self.subject(entry), allowed)
    }

    fn rule_problem(&self, path: &KeyPath, message: &str) -> Problem {
        let range = if is_bound(message) { allowed_range(&self.document, path) } else { None };
        let message = range.unwrap_or_else(|| message.to_owned());
        match self.nearest(path) {
            Some(entry) if entry.path == *path => {
                self.problem(entry.value.start, self.subject(entry), message)
            }
            // The value is a default: point at the table that lacks the key.
            Some(table) => self.problem(table.value.start, path.to_string(), message),
            None => self.problem(0, path.to_string(), message),
        }
    }

    /// Problems for arrays that are longer than the setting they belong to.
    fn overlong_arrays(&self, config: &Config) -> Vec<Problem> {
        let read = match Value::try_from(config) {
            Ok(read) => read,
            Err(error) => {
                let message =
                    format!("cannot compare the parsed configuration with the file: {error}");
                return vec![self.problem(0, String::new(), message)];
            }
        };
        let document = Value::Table(self.document.clone());
        let longer = overlong_arrays(&document, &read);
        let problem = |(path, length): &(KeyPath, usize)| {
            self.rule_problem(path, &format!("allowed: an array of {length}"))
        };
        longer.iter().map(problem).collect()
    }

    fn type_problem(&self, error: &toml::de::Error) -> Problem {
        let span = error.span().unwrap_or(0..0);
        let message = error.message();
        if let Some(name) = quoted_after("unknown field ", message) {
            return self.unknown_key(span, name, message);
        }
        let entry = self.innermost(|entry| entry.value == span);
        if let Some(name) = quoted_after("missing field ", message) {
            return self.missing_key(span.start, entry, name);
        }
        match entry {
            Some(entry) => {
                let range = allowed_range(&self.document, &entry.path);
                let message = range.unwrap_or_else(|| expectation(message));
                self.problem(span.start, self.subject(entry), message)
            }
            None => self.problem(span.start, String::new(), expectation(message)),
        }
    }

    /// Problem for an unknown key. The error's span is the key or, inside a table with `kind`, the
    /// whole table.
    fn unknown_key(&self, span: Range<usize>, name: &str, message: &str) -> Problem {
        let table = self.innermost(|entry| entry.value == span);
        let in_table = table.map(|table| table.path.then(Step::Key(name.to_owned())));
        let entry =
            self.innermost(|entry| entry.key == span || Some(&entry.path) == in_table.as_ref());
        let message = format!("unknown key; {}", allowed_names(message));
        match entry {
            Some(entry) => self.problem(entry.key.start, entry.path.to_string(), message),
            None => self.problem(span.start, name.to_owned(), message),
        }
    }

    fn missing_key(&self, byte: usize, table: Option<&Entry>, name: &str) -> Problem {
        let table = table.map(|table| table.path.clone()).unwrap_or_default();
        let path = table.then(Step::Key(name.to_owned()));
        let range = allowed_range(&self.document, &path).map(|range| format!("; {range}"));
        let message = format!("required key is missing{}", range.unwrap_or_default());
        self.problem(byte, path.to_string(), message)
    }

    /// The deepest entry that meets the condition; parents precede their children.
    fn innermost(&self, fits: impl Fn(&Entry) -> bool) -> Option<&Entry> {
        self.entries.iter().rev().find(|entry| fits(entry))
    }

    /// The entry at a path, or its closest existing ancestor.
    fn nearest(&self, path: &KeyPath) -> Option<&Entry> {
        let above = self.entries.iter().filter(|entry| entry.path.contains(path));
        above.max_by_key(|entry| entry.path.0.len())
    }

    /// The key with its value. Tables and long values are left out.
    fn subject(&self, entry: &Entry) -> String {
        const LONGEST_VALUE: usize = 60;
        let value = self.text.get(entry.value.clone()).unwrap_or_default();
        let is_table_header = entry.key.start >= entry.value.start && entry.key != entry.value;
        if value.len() > LONGEST_VALUE || value.contains('\n') || is_table_header {
            entry.path.to_string()
        } else {
            format!("{} = {value}", entry.path)
        }
    }
}

fn quoted_after<'m>(prefix: &str, message: &'m str) -> Option<&'m str> {
    message.strip_prefix(prefix)?.strip_prefix('`')?.split_once('`').map(|(name, _)| name)
}

/// Turns "`a`, expected one of `b`, `c`" into "allowed: b, c".
fn allowed_names(message: &str) -> String {
    match message.split_once("expected ") {
        Some((_, names)) => {
            format!("allowed: {}", names.trim_start_matches("one of ").replace('`', ""))
        }
        None => "no key is allowed here".to_owned(),
    }
}

/// Rewords serde's message on a wrong type or name in terms of TOML.
fn expectation(message: &str) -> String {
    if message.starts_with("unknown variant ") {
        return allowed_names(message);
    }
    if message.contains("socket address") {
        return "allowed: address and port in quotes, such as \"127.0.0.1:8640\"".to_owned();
    }
    let Some((_, expected)) = message.rsplit_once(", expected ") else {
        return message.to_owned();
    };
    let allowed = match expected {
        "f64" | "f32" => "a number",
        "usize" | "u64" | "u32" => "a whole number, 0 or more",
        "u16" => "a whole number from 0 to 65535",
        "u8" => "a whole number from 0 to 255",
        "a matrix array" => "an array of 3 numbers",
        "a sequence" => "an array",
        "a boolean" => "true or false",
        "a string" | "path string" => "text in quotes",
        other => return format!("wrong kind of value; allowed: {other}"),
    };
    format!("allowed: {allowed}")
}
