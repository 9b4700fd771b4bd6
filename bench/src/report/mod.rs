//! The report: CSV and JSON for programs, one page for people.

pub(crate) mod chart;
mod columns;
mod csv;
mod figures;
pub(crate) mod heat;
mod html;
pub(crate) mod picture;
mod reach;
mod section;
mod surface;
mod tables;
pub(crate) mod text;

use std::{
    io::{self, Write},
    path::Path,
};

use lfpiv::archive::write_replacing;
use serde::Serialize;

use super::{Bar, BenchmarkError, Figure, Record, Row, Suite};

pub use reach::{Reached, Verdict};

/// A record, what was asked for, and what other programs did on the same images.
#[derive(Debug, Clone, Copy)]
pub struct Report<'a> {
    /// What was measured.
    pub suite: &'a Suite,
    /// What came out.
    pub record: &'a Record,
    /// Rows of other programs.
    pub peers: &'a [Row],
}

/// The JSON file.
#[derive(Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    record: &'a Record,
    peers: &'a [Row],
    reached: Vec<Reached>,
    suite: &'a Suite,
}

/// Files of a report.
pub const ROWS_CSV: &str = "rows.csv";
/// Curves, one point a line.
pub const CURVES_CSV: &str = "curves.csv";
/// Everything but the pictures.
pub const REPORT_JSON: &str = "report.json";
/// The page.
pub const REPORT_HTML: &str = "report.html";

impl Report<'_> {
    /// Writes all files into a folder, which exists.
    ///
    /// # Errors
    /// A file cannot be written.
    pub fn write(&self, folder: &Path) -> Result<(), BenchmarkError> {
        write_replacing(&folder.join(ROWS_CSV), |writer| {
            csv::rows(writer, self.record.rows.iter().chain(self.peers))
        })?;
        write_replacing(&folder.join(CURVES_CSV), |writer| {
            csv::curves(writer, &self.record.curves)
        })?;
        let document = Document {
            record: self.record,
            peers: self.peers,
            reached: self.reached(),
            suite: self.suite,
        };
        write_replacing(&folder.join(REPORT_JSON), |writer| {
            serde_json::to_writer_pretty(writer, &document).map_err(io::Error::from)
        })?;
        let page = html::page(self);
        write_replacing(&folder.join(REPORT_HTML), |writer| writer.write_all(page.as_bytes()))?;
        Ok(())
    }

    /// What the program must reach, and what it does.
    pub fn reached(&self) -> Vec<Reached> {
        reach::reached(self)
    }

    /// Rows of the cases that a figure shows, peers' rows of the same cases among them.
    fn shown_in(&self, figure: Figure) -> Vec<&Row> {
        let cases: Vec<&str> = self.suite.shown_in(figure).map(|case| case.name.as_str()).collect();
        self.rows_of(&cases)
    }

    /// Our rows of the cases held against a bar; every bar is for two cameras.
    fn held_against(&self, bar: Bar) -> Vec<&Row> {
        let cases: Vec<&str> =
            self.suite.held_against(bar).map(|case| case.name.as_str()).collect();
        self.rows_of(&cases)
            .into_iter()
            .filter(|row| row.peer.is_none() && row.cameras == 2)
            .collect()
    }

    fn rows_of(&self, cases: &[&str]) -> Vec<&Row> {
        let rows = self.record.rows.iter().chain(self.peers);
        rows.filter(|row| cases.contains(&row.case.as_str())).collect()
    }

    /// A row's method for a legend.
    fn label(&self, row: &Row) -> String {
        let method = self.suite.label_of(&row.method);
        row.peer.as_ref().map_or_else(|| method, |peer| format!("{peer} {}", row.method))
    }
}
