//! What is written: a table for people, JSON and CSV for programs, pictures.

use std::{
    io::{self, Write},
    path::Path,
};

use lfpiv::archive::write_replacing;
use serde::Serialize;

use super::{
    Comparison, Difference, Instrument, ProfilePoint,
    figures::{Picture, pictures},
};
use crate::{BenchmarkError, report::text::escaped};

/// The page with table and pictures.
const PAGE: &str = "validation.html";

/// A profile's point in the CSV file.
#[derive(Serialize)]
struct Line<'a> {
    instrument: &'a str,
    axis: &'a str,
    place_mm: f64,
    place_over_d: f64,
    true_mean_m_s: f64,
    true_rms_m_s: f64,
    shots_mean_m_s: Option<f64>,
    shots_rms_m_s: Option<f64>,
    mean_m_s: Option<f64>,
    mean_low_95_m_s: Option<f64>,
    mean_high_95_m_s: Option<f64>,
    rms_m_s: Option<f64>,
}

/// An instrument in the JSON file: with its differences over the region.
#[derive(Serialize)]
struct Differences<'a> {
    instrument: &'a str,
    along: &'a str,
    #[serde(flatten)]
    difference: Difference,
}

#[derive(Serialize)]
struct Document<'a> {
    #[serde(flatten)]
    comparison: &'a Comparison,
    differences: Vec<Differences<'a>>,
}

/// Writes `validation.json`, `profiles.csv`, the pictures and `validation.html` into a folder that exists.
///
/// # Errors
/// A file cannot be written.
pub fn write(comparison: &Comparison, folder: &Path) -> Result<(), BenchmarkError> {
    let document = Document { comparison, differences: comparison.differences() };
    write_replacing(&folder.join("validation.json"), |writer| {
        serde_json::to_writer_pretty(writer, &document).map_err(io::Error::from)
    })?;
    write_replacing(&folder.join("profiles.csv"), |writer| csv_lines(comparison, writer))?;
    let pictures = pictures(comparison);
    for Picture { file, svg, .. } in &pictures {
        write_replacing(&folder.join(file), |writer| writer.write_all(svg.as_bytes()))?;
    }
    let page = page(comparison, &pictures);
    write_replacing(&folder.join(PAGE), |writer| writer.write_all(page.as_bytes()))?;
    Ok(())
}

fn csv_lines(comparison: &Comparison, writer: &mut dyn Write) -> io::Result<()> {
    let mut csv = csv::Writer::from_writer(writer);
    for Instrument { name, profiles, .. } in &comparison.instruments {
        for profile in profiles {
            for point in &profile.points {
                let ProfilePoint { mean_interval_95_m_s: interval, .. } = point;
                csv.serialize(Line {
                    instrument: name,
                    axis: &profile.axis,
                    place_mm: point.place_mm,
                    place_over_d: point.place_over_d,
                    true_mean_m_s: point.true_mean_m_s,
                    true_rms_m_s: point.true_rms_m_s,
                    shots_mean_m_s: point.shots_mean_m_s,
                    shots_rms_m_s: point.shots_rms_m_s,
                    mean_m_s: point.mean_m_s,
                    mean_low_95_m_s: interval.map(|[low, _]| low),
                    mean_high_95_m_s: interval.map(|[_, high]| high),
                    rms_m_s: point.rms_m_s,
                })?;
            }
        }
    }
    csv.flush()
}

impl Comparison {
    /// Differences of every profile over the common region, instrument by instrument.
    fn differences(&self) -> Vec<Differences<'_>> {
        let of_instrument = |instrument: &'_ Instrument| {
            let of = |axis: &str| {
                let range_mm = self.range_mm(axis);
                instrument.profile(axis).map(|profile| profile.difference(range_mm))
            };
            [("x", of("x")), ("z", of("z"))]
        };
        let mut all = Vec::new();
        for instrument in &self.instruments {
            for (along, difference) in of_instrument(instrument) {
                all.extend(difference.map(|difference| Differences {
                    instrument: &instrument.name,
                    along,
                    difference,
                }));
            }
        }
        all
    }

    fn range_mm(&self, axis: &str) -> [f64; 2] {
        self.region.range_mm[if axis == "x" { 0 } else { 2 }]
    }

    /// The root-mean-square differences from the truth as a table.
    pub fn table(&self) -> String {
        let mut lines = vec![
            format!(
                "{:46}{:>19}{:>30}",
                "root-mean-square differences, m/s", "from the jet", "from the jet in these shots"
            ),
            format!("{:46}{:>10}{:>9}{:>21}{:>9}", "", "mean", "rms", "mean", "rms"),
        ];
        let mut line = |name: &str, difference: &Difference| {
            let Difference { mean_m_s, rms_m_s, mean_from_shots_m_s, rms_from_shots_m_s, .. } =
                difference;
            lines.push(format!(
                "{name:46}{mean_m_s:>10.3}{rms_m_s:>9.3}{mean_from_shots_m_s:>21.3}{rms_from_shots_m_s:>9.3}"
            ));
        };
        for Differences { instrument, along, difference } in self.differences() {
            line(&format!("{instrument}, v along {along}"), &difference);
        }
        for instrument in &self.instruments {
            for difference in instrument.volume.iter().flatten() {
                let name = format!("{}, {} in the volume", instrument.name, difference.component);
                line(&name, difference);
            }
        }
        for instrument in &self.instruments {
            lines.push(format!(
                "{}: {:.1} % of the vectors valid, windows of {:.2} mm, {:.1} µs between the pulses",
                instrument.name,
                100.0 * instrument.valid_share,
                instrument.window_mm,
                instrument.dt_us
            ));
            for profile in &instrument.profiles {
                let [held, all] = profile.intervals_that_hold(self.range_mm(&profile.axis));
                lines.push(format!(
                    "  interval of 95 % of the mean holds the jet's at {held} of {all} places along {}",
                    profile.axis
                ));
            }
        }
        lines.join("\n")
    }
}

fn page(comparison: &Comparison, pictures: &[Picture]) -> String {
    let mut html = format!(
        "<!doctype html>\n<meta charset=\"utf-8\">\n<title>Validation on a round jet</title>\n\
         <style>body{{font-family:sans-serif;max-width:60rem;margin:2rem auto}}img{{max-width:100%}}</style>\n\
         <h1>Validation on a round jet, {} shots</h1>\n<pre>{}</pre>\n",
        comparison.shots,
        escaped(&comparison.table())
    );
    for Picture { file, caption, .. } in pictures {
        let caption = escaped(caption);
        html += &format!(
            "<figure><img src=\"{file}\" alt=\"{caption}\"><figcaption>{caption}</figcaption></figure>\n"
        );
    }
    html
}
