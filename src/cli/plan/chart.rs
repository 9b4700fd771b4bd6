//! Chart of the forecast: the uncertainty of u, v, w along each axis.

use std::fmt::Write;

use lfpiv_core::measurement::ForecastPlace;

use super::slabs;

const WIDTH: f64 = 300.0;
const HEIGHT: f64 = 220.0;
const MARGIN: f64 = 50.0;
/// Blue, orange and green, distinguishable for colour-blind readers.
const COLOURS: [&str; 3] = ["#0072b2", "#d55e00", "#009e73"];
const NAMES: [&str; 3] = ["u", "v", "w"];

/// Three charts side by side: x, y, z. `speed` is the velocity of one voxel per pair, in m/s.
pub(super) fn chart_svg(places: &[ForecastPlace], speed: f64) -> String {
    let all = [0, 1, 2].map(|axis| slabs(places, axis));
    let finite = all.iter().flatten().flat_map(|(_, slab)| slab).filter(|u| u.is_finite());
    let top = 1.1 * speed * finite.fold(0.0, |top: f64, u| top.max(*u)).max(f64::MIN_POSITIVE);
    let (width, height) = (3.0 * (WIDTH + MARGIN) + MARGIN, HEIGHT + 2.5 * MARGIN);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
         font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" \
         fill=\"white\"/>\n<text x=\"{MARGIN}\" y=\"20\">Expected standard uncertainty, m/s: root mean square \
         over planes across x, y, z</text>\n"
    );
    for (axis, slabs) in all.iter().enumerate() {
        let left = MARGIN + axis as f64 * (WIDTH + MARGIN);
        draw(&mut svg, left, ["x", "y", "z"][axis], slabs, top, speed);
    }
    svg.push_str("</svg>\n");
    svg
}

fn draw(svg: &mut String, left: f64, axis: &str, slabs: &[(f64, [f64; 3])], top: f64, speed: f64) {
    let (Some(first), Some(last)) = (slabs.first(), slabs.last()) else { return };
    let (low, high) = (first.0, last.0.max(first.0 + f64::MIN_POSITIVE));
    let bottom = MARGIN + HEIGHT;
    let across = |mm: f64| left + WIDTH * (mm - low) / (high - low);
    let up = |value: f64| bottom - HEIGHT * (value / top).min(1.0);
    // Writing to a String does not fail.
    let _ = writeln!(
        svg,
        "<path d=\"M{left} {MARGIN} V{bottom} H{}\" stroke=\"black\" fill=\"none\"/>\n<text \
         x=\"{left}\" y=\"{}\">{low:.1}</text><text x=\"{}\" y=\"{}\" \
         text-anchor=\"end\">{high:.1} mm</text><text x=\"{}\" y=\"{}\" \
         text-anchor=\"middle\">{axis}</text><text x=\"{}\" y=\"{}\" \
         text-anchor=\"end\">{top:.3}</text>",
        left + WIDTH,
        bottom + 16.0,
        left + WIDTH,
        bottom + 16.0,
        left + WIDTH / 2.0,
        bottom + 32.0,
        left - 4.0,
        MARGIN + 4.0
    );
    for component in 0..3 {
        let points = slabs.iter().filter(|(_, slab)| slab[component].is_finite());
        let line: String = points
            .map(|(mm, slab)| format!("{:.1},{:.1} ", across(*mm), up(slab[component] * speed)))
            .collect();
        let (colour, name) = (COLOURS[component], NAMES[component]);
        let _ = writeln!(
            svg,
            "<polyline points=\"{line}\" stroke=\"{colour}\" stroke-width=\"2\" \
             fill=\"none\"/>\n<text x=\"{}\" y=\"{}\" fill=\"{colour}\">{name}</text>",
            left + 20.0 + 20.0 * component as f64,
            MARGIN + 12.0
        );
    }
}
