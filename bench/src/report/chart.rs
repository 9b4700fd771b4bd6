//! Charts of curves and dots on linear or logarithmic axes.

use super::svg::{COLOURS, Svg, number, round_number};

const WIDTH: f64 = 860.0;
const HEIGHT: f64 = 380.0;
const LEFT: f64 = 64.0;
const RIGHT: f64 = 300.0;
const TOP: f64 = 14.0;
const BOTTOM: f64 = 48.0;

/// Least ratio of the ends of a logarithmic axis.
const DECADE: f64 = 10.0;

/// Ticks wanted on a linear axis.
const TICKS: f64 = 6.0;

/// How values become lengths.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scale {
    /// In proportion.
    Linear,
    /// By the logarithm; what is not positive is left out.
    Log,
}

/// One axis of a chart.
#[derive(Debug, Clone)]
pub struct Axis {
    /// Quantity and unit.
    pub label: String,
    /// Its scale.
    pub scale: Scale,
    /// Ends; the data's own where absent.
    pub range: [Option<f64>; 2],
}

impl Axis {
    /// A linear axis from zero.
    pub fn from_zero(label: &str) -> Self {
        Self { label: label.to_owned(), scale: Scale::Linear, range: [Some(0.0), None] }
    }

    /// A linear axis with both ends given.
    pub fn between(label: &str, low: f64, high: f64) -> Self {
        Self { label: label.to_owned(), scale: Scale::Linear, range: [Some(low), Some(high)] }
    }

    /// A logarithmic axis.
    pub fn log(label: &str) -> Self {
        Self { label: label.to_owned(), scale: Scale::Log, range: [None; 2] }
    }
}

/// How a series is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Style {
    /// A line through the points.
    Line,
    /// A line and a dot on each point.
    Dots,
    /// Dots alone.
    Scatter,
    /// A dashed grey line: a bar, a reference.
    Reference,
    /// A full grey line: what no other point beats.
    Front,
}

/// Points that belong together.
#[derive(Debug, Clone)]
pub struct Series {
    /// Name in the legend.
    pub label: String,
    /// Points (x, y).
    pub points: Vec<[f64; 2]>,
    /// How they are drawn.
    pub style: Style,
}

impl Series {
    /// A series of this style.
    pub fn new(label: impl Into<String>, style: Style, points: Vec<[f64; 2]>) -> Self {
        Self { label: label.into(), points, style }
    }
}

/// A chart.
#[derive(Debug, Clone)]
pub struct Chart {
    /// Along the bottom.
    pub x: Axis,
    /// Along the left.
    pub y: Axis,
    /// What is shown; references and fronts take no colour.
    pub series: Vec<Series>,
}

/// An axis with its ends known.
struct Ruler {
    scale: Scale,
    low: f64,
    high: f64,
    from: f64,
    to: f64,
}

impl Chart {
    /// The chart as SVG; `description` says in words what it shows.
    pub fn svg(&self, description: &str) -> String {
        let mut svg = Svg::new(WIDTH, HEIGHT);
        let x = Ruler::new(&self.x, self.values(0), [LEFT, WIDTH - RIGHT]);
        let y = Ruler::new(&self.y, self.values(1), [HEIGHT - BOTTOM, TOP]);
        self.frame(&mut svg, &x, &y);
        let (mut colour, mut entry) = (0, 0);
        for series in &self.series {
            let class = match series.style {
                Style::Reference => "reference".to_owned(),
                Style::Front => "front".to_owned(),
                _ => {
                    colour += 1;
                    // When the colours are used up they come again, paler.
                    let again = if colour > COLOURS { " again" } else { "" };
                    format!("c{}{again}", (colour - 1) % COLOURS)
                }
            };
            draw(&mut svg, series, &class, &x, &y);
            let at = [WIDTH - RIGHT + 16.0, TOP + 12.0 + 18.0 * f64::from(entry)];
            legend(&mut svg, series, &class, at);
            entry += 1;
        }
        svg.finish(description)
    }

    fn values(&self, axis: usize) -> impl Iterator<Item = f64> {
        self.series.iter().flat_map(move |series| series.points.iter().map(move |p| p[axis]))
    }

    fn frame(&self, svg: &mut Svg, x: &Ruler, y: &Ruler) {
        for tick in x.ticks() {
            let at = x.place(tick);
            svg.line("grid", [at, TOP], [at, HEIGHT - BOTTOM]);
            svg.text("tick", "middle", [at, HEIGHT - BOTTOM + 16.0], &round_number(tick));
        }
        for tick in y.ticks() {
            let at = y.place(tick);
            svg.line("grid", [LEFT, at], [WIDTH - RIGHT, at]);
            svg.text("tick", "end", [LEFT - 6.0, at + 4.0], &round_number(tick));
        }
        svg.line("axis", [LEFT, HEIGHT - BOTTOM], [WIDTH - RIGHT, HEIGHT - BOTTOM]);
        svg.line("axis", [LEFT, TOP], [LEFT, HEIGHT - BOTTOM]);
        let middle = (LEFT + WIDTH - RIGHT) / 2.0;
        svg.text("label", "middle", [middle, HEIGHT - 10.0], &self.x.label);
        svg.text_upwards("label", [16.0, (TOP + HEIGHT - BOTTOM) / 2.0], &self.y.label);
    }
}

fn draw(svg: &mut Svg, series: &Series, class: &str, x: &Ruler, y: &Ruler) {
    let shown: Vec<([f64; 2], [f64; 2])> = series
        .points
        .iter()
        .filter(|point| x.shows(point[0]) && y.shows(point[1]))
        .map(|&point| (point, [x.place(point[0]), y.place(point[1])]))
        .collect();
    let places: Vec<[f64; 2]> = shown.iter().map(|&(_, place)| place).collect();
    if series.style != Style::Scatter {
        svg.polyline(class, &places);
    }
    if matches!(series.style, Style::Dots | Style::Scatter) {
        for ([vx, vy], place) in shown {
            let title = format!("{}: {}, {}", series.label, number(vx), number(vy));
            svg.dot(class, place, 4.0, &title);
        }
    }
}

fn legend(svg: &mut Svg, series: &Series, class: &str, [x, y]: [f64; 2]) {
    if series.style != Style::Scatter {
        svg.polyline(class, &[[x, y - 4.0], [x + 18.0, y - 4.0]]);
    }
    if matches!(series.style, Style::Dots | Style::Scatter) {
        svg.dot(class, [x + 9.0, y - 4.0], 4.0, &series.label);
    }
    svg.text("legend", "start", [x + 24.0, y], &series.label);
}

impl Ruler {
    fn new(axis: &Axis, values: impl Iterator<Item = f64>, [from, to]: [f64; 2]) -> Self {
        let usable = |v: &f64| v.is_finite() && (axis.scale == Scale::Linear || *v > 0.0);
        let (low, high) = values
            .filter(usable)
            .fold((f64::MAX, f64::MIN), |(low, high), value| (low.min(value), high.max(value)));
        let (low, high) = if low <= high { (low, high) } else { (0.1, 1.0) };
        let (low, high) = match axis.scale {
            Scale::Linear => {
                let room = 0.06 * (high - low).max(high.abs() * 1e-3).max(1e-9);
                (axis.range[0].unwrap_or(low - room), axis.range[1].unwrap_or(high + room))
            }
            Scale::Log => {
                // At least a decade, or there would be no ticks to read.
                let widen = (DECADE * low / high).max(1.0).sqrt().max(1.25);
                (axis.range[0].unwrap_or(low / widen), axis.range[1].unwrap_or(high * widen))
            }
        };
        let high = if high > low { high } else { low + 1.0 };
        Self { scale: axis.scale, low, high, from, to }
    }

    fn shows(&self, value: f64) -> bool {
        let slack = 1e-9 * (self.high - self.low);
        (self.low - slack..=self.high + slack).contains(&value)
    }

    fn place(&self, value: f64) -> f64 {
        let share = match self.scale {
            Scale::Linear => (value - self.low) / (self.high - self.low),
            Scale::Log => (value / self.low).ln() / (self.high / self.low).ln(),
        };
        self.from + share * (self.to - self.from)
    }

    fn ticks(&self) -> Vec<f64> {
        match self.scale {
            Scale::Linear => {
                let rough = (self.high - self.low) / TICKS;
                let power = 10f64.powf(rough.log10().floor());
                let step = [1.0, 2.0, 5.0, 10.0]
                    .into_iter()
                    .map(|n| n * power)
                    .find(|step| *step >= rough)
                    .unwrap_or(rough);
                let first = (self.low / step).ceil() as i64;
                let last = (self.high / step + 1e-9).floor() as i64;
                (first..=last).map(|n| n as f64 * step).collect()
            }
            Scale::Log => {
                let within_two_decades = self.high / self.low < 100.0;
                let steps: &[f64] = if within_two_decades { &[1.0, 2.0, 5.0] } else { &[1.0] };
                let first = self.low.log10().floor() as i32;
                let last = self.high.log10().ceil() as i32;
                (first..=last)
                    .flat_map(|power| steps.iter().map(move |step| step * 10f64.powi(power)))
                    .filter(|tick| self.shows(*tick))
                    .collect()
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_end_where_they_are_told_and_ticks_are_round() {
        let ruler = Ruler::new(&Axis::between("q", 0.0, 1.0), [0.3].into_iter(), [0.0, 100.0]);
        let ticks = ruler.ticks();
        assert_eq!((ticks.len(), ticks[0]), (6, 0.0));
        assert!((ticks[5] - 1.0).abs() < 1e-12 && (ruler.place(0.5) - 50.0).abs() < 1e-9);
        let ruler = Ruler::new(&Axis::log("s"), [0.9, 1100.0].into_iter(), [0.0, 300.0]);
        assert_eq!(ruler.ticks(), [1.0, 10.0, 100.0, 1000.0]);
    }

    #[test]
    fn a_chart_without_points_is_a_chart() {
        let chart = Chart { x: Axis::log("x"), y: Axis::from_zero("y"), series: Vec::new() };
        assert!(!chart.svg("nothing").contains("NaN"));
    }
}
