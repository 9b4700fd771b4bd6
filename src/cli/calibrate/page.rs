//! The HTML page of a grid: a single file that loads nothing.

use std::fmt::Write;

use lfpiv_core::calibration::{GridCalibration, LensState, WhiteImage};

use super::{grid_file::GridFile, overlay};

pub(super) const STYLE: &str = "body{font:15px/1.45 sans-serif;margin:2em auto;max-width:1340px;color:#222}\
     figure{display:inline-block;margin:0 1em 1em 0;vertical-align:top}\
     svg{background:#111}svg image{image-rendering:pixelated}\
     .map{background:#eee}.stop,.second,.arrow{fill:none;stroke-width:0.16}.stop{stroke:#f80}\
     .second{stroke:#4af}.arrow{stroke:#06c;stroke-width:0.09}.warning{background:#fe9;padding:.5em}\
     td,th{text-align:left;padding:.1em 1.2em .1em 0}";

/// Displayed parts of the image with their relative positions.
const PIECES: [(&str, [f64; 2]); 5] = [
    ("top left", [0.0, 0.0]),
    ("top right", [1.0, 0.0]),
    ("middle", [0.5, 0.5]),
    ("bottom left", [0.0, 1.0]),
    ("bottom right", [1.0, 1.0]),
];

/// The whole page.
pub fn page(image: &WhiteImage, found: &GridCalibration, file: &GridFile) -> String {
    let mut page = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <title>Micro-image grid</title>\n<style>{STYLE}</style>\n</head>\n<body>\n\
         <h1>Micro-image grid</h1>\n"
    );
    for warning in &found.warnings {
        let warning = escaped(&warning.to_string());
        // Writing to a String does not fail.
        let _ = writeln!(page, "<p class=\"warning\">Warning: {warning}.</p>");
    }
    page += &table(found, file);
    page += "<h2>Fitted circles on the white image</h2>\n\
             <p>Orange: disc and centre of the stop (dashed where the lens is not valid). Blue: the \
             second aperture.</p>\n";
    for (name, at) in PIECES {
        let svg = overlay::piece(image, found, at);
        let _ = writeln!(page, "<figure>{svg}<figcaption>{name}</figcaption></figure>");
    }
    page += "<h2>Maps over the lenses</h2>\n\
             <p>Lens (0, 0) is at the bottom left. Unusable lenses: blue partly imaged, \
             red dark, yellow disturbed (dust, or off the grid).</p>\n";
    for (name, svg) in [
        ("Residuals of the centres", overlay::residuals(found)),
        ("Share left by vignetting", overlay::map(found, |lens| lens.open_share)),
        ("Light", overlay::map(found, |lens| lens.light)),
    ] {
        let _ = writeln!(page, "<figure>{svg}<figcaption>{name}</figcaption></figure>");
    }
    page + "</body>\n</html>\n"
}

fn table(found: &GridCalibration, file: &GridFile) -> String {
    let [columns, rows] = found.grid.microlenses;
    let pair = |[a, b]: [f64; 2], digits: usize| format!("{a:.digits$} and {b:.digits$}");
    let agreement = found.agreement.map_or("only one succeeded".into(), |agreement| {
        format!(
            "{:.3} px at 95 % of the lenses, {:.3} px at the worst",
            agreement.at_95_percent_px, agreement.worst_px
        )
    });
    let second = found.second_aperture.map_or("none seen".into(), |second| {
        format!(
            "radius {:.2} px, displaced by {:.2} px at the sensor's corner; leaves at least {:.0} \
             % of a micro-image",
            second.radius_px,
            second.shift_at_corner_px,
            100.0 * found.least_open_share()
        )
    });
    let white: Vec<String> =
        file.inputs.white.iter().map(|input| input.file.display().to_string()).collect();
    let rows = [
        ("White images", white.join(", ")),
        ("Micro-images", format!("{columns} x {rows}, {:?}", found.array).to_lowercase()),
        ("Pitch along i and j, px", pair(found.grid.pitch_px(), 4)),
        ("Turned, degrees", pair(found.grid.turned_deg(), 4)),
        ("Held-out residual, px rms", pair(found.heldout.rms_px, 4)),
        ("after subtracting a smooth displacement", pair(found.heldout.smooth_rms_px, 4)),
        ("Two estimators differ by", agreement),
        ("Radius and blur, px", pair([found.radius_px, found.blur_px], 3)),
        ("Second aperture", second),
        ("f-number", found.f_number.to_string()),
        (
            "Lenses",
            format!(
                "{} valid, {} partly imaged, {} dark, {} disturbed",
                found.count(LensState::Valid),
                found.count(LensState::PartlyImaged),
                found.count(LensState::Dark),
                found.count(LensState::Disturbed)
            ),
        ),
        ("SHA-256 of the grid", file.sha256.clone()),
    ];
    let lines =
        rows.map(|(name, value)| format!("<tr><th>{name}</th><td>{}</td></tr>", escaped(&value)));
    format!("<table>\n{}\n</table>\n", lines.join("\n"))
}

/// Escapes HTML markup.
pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
