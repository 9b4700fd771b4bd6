//! The page: one file, nothing loaded from anywhere.

use std::fmt::Write;

use super::{
    Report, Verdict,
    columns::COLUMNS,
    figures::sections,
    section::{Compared, Section},
    text::{escaped, number},
};
use crate::Row;

/// The page's style sheet.
const STYLE: &str = include_str!("style.css");

/// A page under construction. Writing to a String does not fail: results are dropped.
struct Page(String);

/// The whole page.
pub fn page(report: &Report) -> String {
    let sections = sections(report);
    let mut page = Page(String::new());
    page.head(report);
    page.failures(report);
    page.contents(&sections);
    page.reached(report);
    for section in &sections {
        page.section(section);
    }
    page.peers(report);
    page.methods(report);
    page.rows(report);
    page.add("</body>\n</html>\n");
    page.0
}

impl Page {
    fn add(&mut self, html: &str) {
        self.0.push_str(html);
    }

    fn head(&mut self, report: &Report) {
        let stamp = &report.record.stamp;
        let kernel = &report.record.kernel;
        let _ = write!(
            self.0,
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <title>lfpiv: speed against error</title>\n<style>\n{STYLE}</style>\n</head>\n\
             <body>\n<h1>lfpiv: speed against error</h1>\n\
             <p class=\"facts\">{}, {} logical processors, {} threads. lfpiv {}. {}.<br>\n\
             Reference kernel: {} s for {:.1}·10⁹ multiply-adds and {:.1} GB of memory traffic on \
             these threads.<br>\n\
             Images are simulated by ray tracing. What that shares with the reconstruction is the \
             description of the bench: optics, poses and conventions. \
             Paper: Zhu, Xu, Hossain and Khoo, Physics of Fluids 35, 2023.</p>\n",
            escaped(&stamp.machine),
            stamp.cores,
            stamp.threads,
            escaped(&stamp.version),
            escaped(&stamp.date),
            number(kernel.seconds),
            kernel.multiply_adds as f64 / 1e9,
            kernel.streamed_bytes as f64 / 1e9,
        );
    }

    fn failures(&mut self, report: &Report) {
        for failure in &report.record.failures {
            let _ = writeln!(
                self.0,
                "<p class=\"missed\">Not measured to its end: {}</p>",
                escaped(failure)
            );
        }
    }

    fn contents(&mut self, sections: &[Section]) {
        self.add("<nav>\n<a href=\"#reached\">What it must reach</a>\n");
        for section in sections {
            let _ = writeln!(self.0, "<a href=\"#{}\">{}</a>", section.id, section.title);
        }
        self.add("<a href=\"#methods\">Methods</a>\n<a href=\"#rows\">All rows</a>\n</nav>\n");
    }

    fn reached(&mut self, report: &Report) {
        self.add(
            "<h2 id=\"reached\">What it must reach</h2>\n<div class=\"scroll\"><table>\n\
             <tr><th>Work</th><th>Bar</th><th>Measured</th><th>Verdict</th></tr>\n",
        );
        for reached in report.reached() {
            let (class, verdict) = match reached.verdict {
                Verdict::Met => ("met", "met"),
                Verdict::Missed => ("missed", "missed"),
                Verdict::NotMeasured => ("not-measured", "not in this run"),
            };
            let _ = writeln!(
                self.0,
                "<tr><td>{}</td><td>{}</td><td>{}</td><td class=\"{class}\">{verdict}</td></tr>",
                escaped(&reached.work),
                escaped(&reached.bar),
                escaped(&reached.measured),
            );
        }
        self.add(
            "</table></div>\n<p class=\"note\">True particles, windows only: the error of \
             correlating the true particles through the same windows and passes, without following \
             single ones; in bars no more than 0.068 voxel at 1 ppm and 0.095 at 0.3 ppm. True \
             particles, followed: the error when single ones are followed afterwards, as they are in \
             the images; a bar is never set against it, and the difference to it is what images and \
             reconstruction add. Where several methods were measured, up to three are named, the \
             nearest to the bar first.</p>\n",
        );
    }

    fn section(&mut self, section: &Section) {
        let _ =
            writeln!(self.0, "<h2 id=\"{}\">{}</h2>\n<figure>", section.id, escaped(section.title));
        let narrow = section.panels.iter().all(|panel| panel.narrow) && !section.panels.is_empty();
        if narrow {
            self.add("<div class=\"narrow\">\n");
        }
        for panel in &section.panels {
            self.add("<div>\n");
            if !panel.title.is_empty() {
                let _ = writeln!(self.0, "<h3>{}</h3>", escaped(&panel.title));
            }
            self.add(&panel.svg);
            self.add("</div>\n");
        }
        if narrow {
            self.add("</div>\n");
        }
        let _ =
            writeln!(self.0, "<figcaption>{}</figcaption>\n</figure>", escaped(&section.caption));
        self.compared(&section.compared);
    }

    fn compared(&mut self, compared: &[Compared]) {
        if compared.is_empty() {
            return;
        }
        // Where the paper says nothing it has no column.
        let paper = compared.iter().any(|line| !line.paper.is_empty());
        let column = |tag: &str, text: &str| match paper {
            true => format!("<{tag}>{}</{tag}>", escaped(text)),
            false => String::new(),
        };
        self.add("<div class=\"scroll\"><table>\n");
        let _ = writeln!(self.0, "<tr><th></th>{}<th>Ours</th></tr>", column("th", "Paper"));
        for line in compared {
            let _ = writeln!(
                self.0,
                "<tr><td>{}</td>{}<td>{}</td></tr>",
                escaped(&line.what),
                column("td", &line.paper),
                escaped(&line.ours)
            );
        }
        self.add("</table></div>\n");
    }

    fn peers(&mut self, report: &Report) {
        if report.peers.is_empty() {
            return;
        }
        self.add("<h2 id=\"peers\">Rows of the peers' run</h2>\n");
        let rows: Vec<&Row> = report.peers.iter().collect();
        self.table(report, &rows);
    }

    fn methods(&mut self, report: &Report) {
        self.add(
            "<h2 id=\"methods\">Methods</h2>\n<p class=\"note\">Each is a whole [reconstruction] \
             table; what is absent has its default.</p>\n",
        );
        for method in &report.suite.methods {
            let settings = toml::to_string(&method.reconstruction).unwrap_or_default();
            let _ = writeln!(
                self.0,
                "<details><summary>{} ({})</summary><pre>{}</pre></details>",
                escaped(&method.label),
                escaped(&method.name),
                escaped(&settings)
            );
        }
    }

    fn rows(&mut self, report: &Report) {
        self.add(
            "<h2 id=\"rows\">All rows</h2>\n<p class=\"note\">Also in rows.csv and report.json, \
             with more columns; curves in curves.csv.</p>\n",
        );
        let rows: Vec<&Row> = report.record.rows.iter().chain(report.peers).collect();
        self.add("<details open><summary>Show or hide</summary>\n");
        self.table(report, &rows);
        self.add("</details>\n");
    }

    fn table(&mut self, report: &Report, rows: &[&Row]) {
        self.add("<div class=\"scroll\"><table>\n<tr>");
        for (heading, _) in COLUMNS {
            let _ = write!(self.0, "<th>{}</th>", escaped(heading));
        }
        self.add("</tr>\n");
        for row in rows {
            self.add("<tr>");
            for (_, cell) in COLUMNS {
                let _ = write!(self.0, "<td>{}</td>", escaped(&cell(report, row)));
            }
            self.add("</tr>\n");
        }
        self.add("</table></div>\n");
    }
}
