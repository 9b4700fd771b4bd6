//! The forecast as a picture: what was measured beside its prediction, and what is extrapolated.

use std::fmt::Write as _;

use super::{
    checks::{Check, TOLERANCE},
    costs::Measured,
    report::{MACHINES, Machine, NETWORKS, RATES},
};

const SIZE: f64 = 320.0;
const MARGIN: f64 = 60.0;
/// Blue, orange and green, distinguishable for colour-blind readers.
const COLOURS: [&str; 3] = ["#0072b2", "#d55e00", "#009e73"];

/// Two charts side by side, in SVG.
pub(super) fn picture(measured: &Measured, machine: Machine, checks: &[Check]) -> String {
    let (width, height) = (2.0 * (SIZE + 2.0 * MARGIN), SIZE + 2.0 * MARGIN);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
         font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
    );
    compared(&mut svg, checks);
    extrapolated(&mut svg, measured, machine);
    svg.push_str("</svg>\n");
    svg
}

/// Logarithmic axes from `low` to `high` at `left`.
struct Axes {
    left: f64,
    x: [f64; 2],
    y: [f64; 2],
}

impl Axes {
    fn across(&self, x: f64) -> f64 {
        self.left + SIZE * (x / self.x[0]).ln() / (self.x[1] / self.x[0]).ln()
    }

    fn up(&self, y: f64) -> f64 {
        let share = (y / self.y[0]).ln() / (self.y[1] / self.y[0]).ln();
        MARGIN + SIZE * (1.0 - share.clamp(0.0, 1.0))
    }

    fn draw(&self, svg: &mut String, title: &str, [x, y]: [&str; 2]) {
        let (left, bottom) = (self.left, MARGIN + SIZE);
        // Writing to a String does not fail.
        let _ = writeln!(
            svg,
            "<text x=\"{left}\" y=\"{}\">{title}</text>\n<path d=\"M{left} {MARGIN} V{bottom} H{}\" stroke=\"black\" \
             fill=\"none\"/>\n<text x=\"{}\" y=\"{}\" text-anchor=\"middle\">{x}</text>\n<text x=\"{}\" y=\"{}\" \
             text-anchor=\"end\">{y}</text>",
            MARGIN - 24.0,
            left + SIZE,
            left + SIZE / 2.0,
            bottom + 36.0,
            left - 6.0,
            MARGIN - 8.0
        );
        for (value, at) in [(self.x[0], left), (self.x[1], left + SIZE)] {
            let _ = writeln!(
                svg,
                "<text x=\"{at}\" y=\"{}\" text-anchor=\"middle\">{}</text>",
                bottom + 18.0,
                short(value)
            );
        }
        for value in self.y {
            let _ = writeln!(
                svg,
                "<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>",
                left - 6.0,
                self.up(value) + 4.0,
                short(value)
            );
        }
    }
}

/// Measured over predicted, with the band in which they agree.
fn compared(svg: &mut String, checks: &[Check]) {
    let rates = checks.iter().flat_map(|check| [Some(check.predicted_per_s), check.measured_per_s]);
    let (low, high) = bounds(rates.flatten());
    let axes = Axes { left: MARGIN, x: [low, high], y: [low, high] };
    axes.draw(svg, "Measured, shots a second", ["predicted", ""]);
    for factor in [1.0 - TOLERANCE, 1.0, 1.0 + TOLERANCE] {
        // As far as it is within the axes.
        let (first, last) = (low.max(low / factor), high.min(high / factor));
        let _ = writeln!(
            svg,
            "<path d=\"M{:.1} {:.1} L{:.1} {:.1}\" stroke=\"#bbbbbb\"/>",
            axes.across(first),
            axes.up(first * factor),
            axes.across(last),
            axes.up(last * factor)
        );
    }
    for check in checks {
        let Some(rate) = check.measured_per_s else { continue };
        let _ = writeln!(
            svg,
            "<circle cx=\"{:.1}\" cy=\"{:.1}\" r=\"4\" fill=\"{}\"><title>{}</title></circle>",
            axes.across(check.predicted_per_s),
            axes.up(rate),
            COLOURS[0],
            check.what
        );
    }
}

/// Rates over machines. Nothing of it is measured: all lines are dashed.
fn extrapolated(svg: &mut String, measured: &Measured, machine: Machine) {
    let Machine { cores, slots } = machine;
    let rate = |network: f64, machines: usize| {
        measured.of_machine(cores, slots, network).shots_per_s(machines * slots)
    };
    let all = NETWORKS.iter().flat_map(|network| MACHINES.map(|machines| rate(*network, machines)));
    let (low, high) = bounds(all.chain(RATES));
    let axes = Axes { left: SIZE + 3.0 * MARGIN, x: [1.0, 64.0], y: [low, high] };
    let title = format!("Extrapolated, shots a second: machines of {cores} cores");
    axes.draw(svg, "", ["machines", ""]);
    let _ =
        writeln!(svg, "<text x=\"{}\" y=\"{}\">{title}</text>", axes.left - 24.0, MARGIN - 24.0);
    for rate in RATES {
        let _ = writeln!(
            svg,
            "<path d=\"M{:.1} {y:.1} H{:.1}\" stroke=\"#bbbbbb\"/>\n<text x=\"{:.1}\" y=\"{:.1}\" fill=\"#777777\">\
             {rate} Hz</text>",
            axes.left,
            axes.left + SIZE,
            axes.left + 4.0,
            axes.up(rate) - 4.0,
            y = axes.up(rate)
        );
    }
    for (number, network) in NETWORKS.into_iter().enumerate() {
        let points: String = MACHINES
            .iter()
            .map(|machines| {
                let (x, y) = (axes.across(*machines as f64), axes.up(rate(network, *machines)));
                format!("{x:.1},{y:.1} ")
            })
            .collect();
        let colour = COLOURS[number];
        let _ = writeln!(
            svg,
            "<polyline points=\"{points}\" stroke=\"{colour}\" stroke-width=\"2\" stroke-dasharray=\"{} 4\" \
             fill=\"none\"/>\n<text x=\"{}\" y=\"{}\" fill=\"{colour}\">{network} Gbit/s</text>",
            8 - 2 * number,
            axes.left + SIZE - 70.0,
            MARGIN + SIZE - 12.0 - 16.0 * number as f64
        );
    }
}

/// A number of an axis, in few digits.
fn short(value: f64) -> String {
    match value {
        10.0.. => format!("{value:.0}"),
        1.0.. => format!("{value:.1}"),
        _ => format!("{value:.2}"),
    }
}

/// Bounds of positive numbers, with some room.
fn bounds(numbers: impl Iterator<Item = f64>) -> (f64, f64) {
    let (mut low, mut high) = (f64::INFINITY, 0.0_f64);
    numbers.filter(|number| *number > 0.0 && number.is_finite()).for_each(|number| {
        low = low.min(number);
        high = high.max(number);
    });
    match low < high {
        true => (low / 1.3, high * 1.3),
        false => (0.1, 10.0),
    }
}
