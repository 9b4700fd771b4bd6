//! The HTML page of a volume calibration: a single file that loads nothing.

use std::fmt::Write;

use image::ExtendedColorType;
use lfpiv_core::calibration::{
    CalibratedCamera, CardLight, MarkResidual, ParameterEstimate, VolumeCalibration,
};
use lfpiv_hw::CameraName;

use super::{
    overlay::picture,
    page::{STYLE, escaped},
    volume_file::VolumeFile,
};

/// Width of a residual map and of a view, in CSS pixels.
const FIELD_WIDTH: f64 = 620.0;
const VIEW_WIDTH: f64 = 300.0;

/// Length of the longest arrow, in microlenses.
const LONGEST_ARROW: f64 = 6.0;

/// Residuals below this length, in microlenses, are not magnified further.
const LEAST_SCALE: f64 = 1e-3;

/// The whole page.
pub fn page(lights: &[Vec<CardLight<'_>>], found: &VolumeCalibration, file: &VolumeFile) -> String {
    let mut page = format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <title>Calibration of the volume</title>\n<style>{STYLE}\
         .mark{{fill:none;stroke:#f80;stroke-width:0.5}}.map .arrow{{stroke-width:0.35}}</style>\n\
         </head>\n<body>\n<h1>Calibration of the volume</h1>\n"
    );
    for warning in &found.warnings {
        let warning = escaped(&warning.to_string());
        // Writing to a String does not fail.
        let _ = writeln!(page, "<p class=\"warning\">Warning: {warning}.</p>");
    }
    page += &summary(found, file);
    for (camera, calibrated) in found.cameras.iter().enumerate() {
        let _ = writeln!(page, "<h2>{}</h2>", CameraName(camera));
        page += &parameters(&calibrated.parameters);
        let lenses = lights.first().map_or([1, 1], |lights| lights[camera].microlenses());
        let field = residual_field(calibrated, lenses, lights.len());
        let _ = writeln!(
            page,
            "<figure>{field}<figcaption>Measured minus expected positions of all marks over the \
             microlenses, by position of the card from blue (first) to red (last). Arrows must \
             show no common rotation or direction.</figcaption></figure>"
        );
        for (position, lights) in lights.iter().enumerate() {
            let marks = calibrated.marks.iter().filter(|mark| mark.position == position);
            let view = view_with_marks(&lights[camera], marks);
            let _ = writeln!(
                page,
                "<figure>{view}<figcaption>position {}</figcaption></figure>",
                position + 1
            );
        }
    }
    page + "</body>\n</html>\n"
}

fn summary(found: &VolumeCalibration, file: &VolumeFile) -> String {
    let held_out = &found.held_out;
    let moved: Vec<String> = found
        .stage_mm
        .iter()
        .map(|place_mm| {
            let [x, y, z] = place_mm.map(|mm| mm * 1e3);
            format!("({x:.1}, {y:.1}, {z:.1})")
        })
        .collect();
    let rows = [
        (
            "Marks at positions left out of the fit",
            format!(
                "{} marks, {:.4} microlens rms (mean over the views), {:.4} in a single view",
                held_out.marks, held_out.mean_microlenses, held_out.view_microlenses
            ),
        ),
        ("Condition number", format!("{:.2e}", found.condition_number)),
        ("Card's deviation from its stated positions, um", moved.join(" ")),
        ("SHA-256 of the calibration", file.sha256().to_owned()),
    ];
    let lines =
        rows.map(|(name, value)| format!("<tr><th>{name}</th><td>{}</td></tr>", escaped(&value)));
    format!("<table>\n{}\n</table>\n", lines.join("\n"))
}

fn parameters(parameters: &[ParameterEstimate]) -> String {
    let mut table =
        "<table>\n<tr><th>Parameter</th><th>deviation from nominal</th><th>standard deviation\
                     </th><th>prior standard deviation</th><th>unit</th></tr>\n"
            .to_owned();
    for ParameterEstimate { name, unit, value, standard_deviation, prior_standard_deviation } in
        parameters
    {
        let _ = writeln!(
            table,
            "<tr><td>{name}</td><td>{value:.6}</td><td>{standard_deviation:.1e}</td>\
             <td>{prior_standard_deviation}</td><td>{unit}</td></tr>"
        );
    }
    table + "</table>\n"
}

/// Residuals as arrows; the longest is as long as six microlenses.
fn residual_field(camera: &CalibratedCamera, [nx, ny]: [usize; 2], positions: usize) -> String {
    let length = |[x, y]: [f64; 2]| x.hypot(y);
    let longest = camera
        .marks
        .iter()
        .map(|mark| length(mark.residual_microlenses))
        .fold(LEAST_SCALE, f64::max);
    let scale = LONGEST_ARROW / longest;
    let mut svg = format!(
        "<svg class=\"map\" viewBox=\"-0.5 -0.5 {nx} {ny}\" width=\"{FIELD_WIDTH}\" \
         height=\"{:.0}\">",
        FIELD_WIDTH * ny as f64 / nx.max(1) as f64
    );
    for mark in &camera.marks {
        let [x, y] = [mark.lens[0], ny as f64 - 1.0 - mark.lens[1]];
        let [along, up] = mark.residual_microlenses;
        let hue = 240.0 - 240.0 * mark.position as f64 / (positions.max(2) as f64 - 1.0);
        let _ = write!(
            svg,
            "<path class=\"arrow\" style=\"stroke:hsl({hue:.0},80%,40%)\" \
             d=\"M{x:.2} {y:.2}l{:.2} {:.2}\"/>",
            along * scale,
            -up * scale
        );
    }
    svg + &format!("</svg><p>Longest arrow: {longest:.4} microlens.</p>")
}

/// The view through the centre of the pupil, with the marks that were used.
fn view_with_marks<'m>(
    light: &CardLight<'_>,
    marks: impl Iterator<Item = &'m MarkResidual>,
) -> String {
    let [nx, ny] = light.microlenses();
    let view = light.middle_view();
    let brightest = view.iter().copied().filter(|share| share.is_finite()).fold(0.01, f32::max);
    let grey = |n: usize| {
        let share = view[(ny - 1 - n / nx) * nx + n % nx] / brightest;
        // NaN becomes zero.
        (255.0 * share.clamp(0.0, 1.0)) as u8
    };
    let mut svg = format!(
        "<svg viewBox=\"-0.5 -0.5 {nx} {ny}\" width=\"{VIEW_WIDTH}\" height=\"{:.0}\">{}",
        VIEW_WIDTH * ny as f64 / nx.max(1) as f64,
        picture((0..nx * ny).map(grey).collect(), [nx, ny], ExtendedColorType::L8)
    );
    for mark in marks {
        let [x, y] = [mark.lens[0], ny as f64 - 1.0 - mark.lens[1]];
        let _ = write!(svg, "<circle class=\"mark\" cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"3\"/>");
    }
    svg + "</svg>"
}
