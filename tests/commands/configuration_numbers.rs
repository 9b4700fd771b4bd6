//! Every number of the shipped configurations is checked: infinite, NaN, negative and huge values
//! are refused.

use std::ops::Range;

use lfpiv::config::Config;
use toml::de::{DeTable, DeValue};

use crate::support::{SHIPPED, shipped};

/// Paths and byte ranges of all numbers in a document.
fn numbers(table: &DeTable<'_>, above: &str, found: &mut Vec<(String, Range<usize>)>) {
    for (key, value) in table.iter() {
        let path = format!("{above}{}", key.get_ref());
        numbers_in(value.get_ref(), value.span(), path, found);
    }
}

fn numbers_in(
    value: &DeValue<'_>,
    span: Range<usize>,
    path: String,
    found: &mut Vec<(String, Range<usize>)>,
) {
    match value {
        DeValue::Integer(_) | DeValue::Float(_) => found.push((path, span)),
        DeValue::Table(table) => numbers(table, &format!("{path}."), found),
        DeValue::Array(array) => {
            for (index, element) in array.iter().enumerate() {
                let path = format!("{path}[{index}]");
                numbers_in(element.get_ref(), element.span(), path, found);
            }
        }
        _ => {}
    }
}

/// Replaces every number of every shipped file by NaN or infinity.
#[test]
fn no_number_may_be_nan_or_infinite() {
    for name in SHIPPED {
        let text = shipped(name);
        let document = DeTable::parse(&text).unwrap();
        let mut found = Vec::new();
        numbers(document.get_ref(), "", &mut found);
        assert!(found.len() > 40, "{name}: {}", found.len());
        for (path, span) in found {
            for wrong in ["nan", "-nan", "inf", "+inf", "-inf"] {
                let changed = format!("{}{wrong}{}", &text[..span.start], &text[span.end..]);
                let message = match Config::parse("run.toml", &changed) {
                    Ok(_) => panic!("{name}: {path} = {wrong} was accepted"),
                    Err(error) => error.to_string(),
                };
                let line = text[..span.start].matches('\n').count() + 1;
                let place = format!("run.toml:{line}:");
                let named = format!("{path} = {wrong}");
                let told = message.lines().any(|line| {
                    line.starts_with(&place) && line.contains(&named) && line.contains("allowed")
                });
                assert!(told, "{path} = {wrong}: {message}");
            }
        }
    }
}

/// Numbers far outside any range are refused wherever a range is declared.
#[test]
fn no_length_or_count_may_be_negative_or_huge() {
    for key in [
        "focal_length_mm",
        "f_number",
        "object_distance_mm",
        "pitch_mm",
        "columns",
        "rows",
        "pixel_pitch_um",
        "voxel_mm",
        "dt_us",
        "rate_hz",
        "refinement",
        "window_mm",
        "overlap",
        "passes",
        "max_displacement_vox",
        "median_threshold",
        "median_epsilon_vox",
        "queue",
        "ppm",
        "intensity_spread",
        "wavelength_mm",
        "bits",
        "gain_counts_per_electron",
        "offset_counts",
        "background_electrons",
        "read_noise_electrons",
    ] {
        let text = shipped("bench");
        let start = text.find(&format!("\n{key} = ")).expect(key) + 1;
        let end = start + text[start..].find('\n').expect("end of line");
        for wrong in ["-7", "123456789123"] {
            let changed = format!("{}{key} = {wrong}{}", &text[..start], &text[end..]);
            let message = match Config::parse("run.toml", &changed) {
                Ok(_) => panic!("{key} = {wrong} was accepted"),
                Err(error) => error.to_string(),
            };
            assert!(message.contains(&format!("{key} = {wrong}: allowed")), "{message}");
        }
    }
}
