//! Charts of curves and points on linear or logarithmic axes.

use std::{iter, ops::Range};

use plotters::{
    coord::{
        combinators::{BindKeyPoints, LogCoord, WithKeyPoints},
        ranged1d::{AsRangedCoord, Ranged, ValueFormatter},
    },
    element::{DashedPathElement, DynElement, IntoDynElement},
    prelude::{
        ChartBuilder, Circle, Cross, IntoLogRange, PathElement, RGBColor, SVGBackend,
        SeriesLabelPosition, TriangleMarker,
    },
    style::{Color, RGBAColor, TRANSPARENT},
};

use super::{
    picture::{Area, Drawn, FINE, INK, RULE, letters, picture},
    text::round_number,
};

/// Width of the picture, height where the legend needs no more, in units.
const WIDTH: i32 = 900;
const HEIGHT: i32 = 380;
/// Width of the legend, and height of one of its lines.
const LEGEND: i32 = 340;
const LEGEND_LINE: i32 = 16;
/// Room for numbers and names of the axes.
const X_AXIS: i32 = 46;
const Y_AXIS: i32 = 62;

/// Numbers wanted on a linear axis, at most.
const NUMBERS: usize = 7;

/// Radius of a mark; length of a dash and of a legend's line.
const MARK: i32 = 4 * FINE;
const DASH: i32 = 5 * FINE;
const KEY: i32 = 20 * FINE;

/// Colours that most colour-blind readers can tell apart (Okabe and Ito, 2008), without the yellow,
/// which is too pale on white. Blue, vermillion, green, purple, orange, light blue, black.
pub const COLOURS: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(230, 159, 0),
    RGBColor(86, 180, 233),
    RGBColor(0, 0, 0),
];

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
    /// Ends of a linear axis; the data's own where absent.
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

    fn limits(&self, values: impl Iterator<Item = f64>) -> Range<f64> {
        let usable = |v: &f64| v.is_finite() && (self.scale == Scale::Linear || *v > 0.0);
        let (low, high) = values
            .filter(usable)
            .fold((f64::MAX, f64::MIN), |(low, high), value| (low.min(value), high.max(value)));
        let (low, high) = if low <= high { (low, high) } else { (0.1, 1.0) };
        match self.scale {
            Scale::Linear => {
                let length = high - self.range[0].unwrap_or(low);
                let room = 0.06 * length.max(high.abs() * 1e-3).max(1e-9);
                let low = self.range[0].unwrap_or(low - room);
                let high = self.range[1].unwrap_or(high + room);
                low..if high > low { high } else { low + 1.0 }
            }
            Scale::Log => {
                // At least a decade, or there would be few numbers to read.
                let room = (10.0 * low / high).max(1.0).sqrt().max(1.25);
                low / room..high * room
            }
        }
    }
}

/// A logarithmic axis with numbers at 1, 2 and 5 of every decade, or at the decades alone where
/// there are many. plotters' own begin with the first whole decade, of which there may be none.
fn log_scale(range: Range<f64>) -> WithKeyPoints<LogCoord<f64>> {
    let steps: &[f64] = if range.end / range.start < 100.0 { &[1.0, 2.0, 5.0] } else { &[1.0] };
    let decades = range.start.log10().floor() as i32..=range.end.log10().ceil() as i32;
    let numbers = decades.flat_map(|power| steps.iter().map(move |n| n * 10f64.powi(power)));
    let numbers = numbers.filter(|number| within(&range, *number)).collect();
    range.clone().log_scale().with_key_points(numbers)
}

/// How a series is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Style {
    /// A line through the points.
    Line,
    /// A line and a mark on each point.
    Dots,
    /// Marks alone.
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

/// What a series looks like. When the colours are used up they come again, paler and with another
/// mark.
#[derive(Clone, Copy)]
struct Look {
    style: Style,
    colour: RGBAColor,
    round: usize,
}

impl Chart {
    /// The chart as SVG; `description` says in words what it shows.
    pub fn svg(&self, description: &str) -> String {
        let height = HEIGHT.max((self.series.len() as i32 + 2) * LEGEND_LINE);
        picture([WIDTH, height], description, |area| {
            let (plot, legend) = area.split_horizontally((WIDTH - LEGEND) * FINE);
            let x = self.x.limits(self.values(0));
            let y = self.y.limits(self.values(1));
            match (self.x.scale, self.y.scale) {
                (Scale::Linear, Scale::Linear) => self.plot(&plot, x, y)?,
                (Scale::Linear, Scale::Log) => self.plot(&plot, x, log_scale(y))?,
                (Scale::Log, Scale::Linear) => self.plot(&plot, log_scale(x), y)?,
                (Scale::Log, Scale::Log) => self.plot(&plot, log_scale(x), log_scale(y))?,
            }
            self.legend(&legend)
        })
    }

    fn values(&self, axis: usize) -> impl Iterator<Item = f64> {
        self.series.iter().flat_map(move |series| series.points.iter().map(move |p| p[axis]))
    }

    fn plot<X, Y>(&self, area: &Area, x: X, y: Y) -> Drawn
    where
        X: AsRangedCoord<Value = f64>,
        Y: AsRangedCoord<Value = f64>,
        X::CoordDescType: Ranged<ValueType = f64> + ValueFormatter<f64>,
        Y::CoordDescType: Ranged<ValueType = f64> + ValueFormatter<f64>,
    {
        let mut chart = ChartBuilder::on(area)
            .margin(8 * FINE)
            .x_label_area_size(X_AXIS * FINE)
            .y_label_area_size(Y_AXIS * FINE)
            .build_cartesian_2d(x, y)?;
        chart
            .configure_mesh()
            .x_labels(NUMBERS)
            .y_labels(NUMBERS)
            .x_label_formatter(&|value| round_number(tick(*value)))
            .y_label_formatter(&|value| round_number(tick(*value)))
            .bold_line_style(RULE.stroke_width(FINE as u32))
            .light_line_style(TRANSPARENT)
            .axis_style(INK.stroke_width(FINE as u32))
            .set_all_tick_mark_size(3 * FINE)
            .label_style(letters())
            .x_desc(&self.x.label)
            .y_desc(&self.y.label)
            .draw()?;
        let (x, y) = (chart.x_range(), chart.y_range());
        for (series, look) in self.series.iter().zip(self.looks()) {
            let shown = |point: &&[f64; 2]| within(&x, point[0]) && within(&y, point[1]);
            let points = series.points.iter().filter(shown).map(|&[x, y]| (x, y));
            let points: Vec<(f64, f64)> = points.collect();
            chart.draw_series(look.line(points.clone()))?;
            chart.draw_series(points.into_iter().filter_map(|point| look.mark(point)))?;
        }
        Ok(())
    }

    /// The legend, as that of a chart without axes: plotters keeps a legend within its chart.
    fn legend(&self, area: &Area) -> Drawn {
        let mut chart = ChartBuilder::on(area).build_cartesian_2d(0..1, 0..1)?;
        for (series, look) in self.series.iter().zip(self.looks()) {
            chart
                .draw_series(iter::empty::<Circle<(i32, i32), i32>>())?
                .label(&series.label)
                .legend(move |at| look.key(at));
        }
        chart
            .configure_series_labels()
            .position(SeriesLabelPosition::UpperLeft)
            .legend_area_size(KEY + 6 * FINE)
            .margin(6 * FINE)
            .label_font(letters())
            .draw()
    }

    fn looks(&self) -> impl Iterator<Item = Look> {
        let mut coloured = 0;
        self.series.iter().map(move |&Series { style, .. }| {
            if matches!(style, Style::Reference | Style::Front) {
                return Look { style, colour: INK.mix(0.7), round: 0 };
            }
            let round = coloured / COLOURS.len();
            let colour = COLOURS[coloured % COLOURS.len()].mix(0.6f64.powi(round as i32));
            coloured += 1;
            Look { style, colour, round }
        })
    }
}

/// Something that plotters draws at points of a kind.
type Drawable<'a, At> = DynElement<'static, SVGBackend<'a>, At>;

impl Look {
    /// The line through points, where there is one.
    fn line<'a, At: Clone + 'static>(self, points: Vec<At>) -> Option<Drawable<'a, At>> {
        let steps = if matches!(self.style, Style::Line | Style::Dots) { 7 } else { 5 };
        let stroke = self.colour.stroke_width(steps);
        match self.style {
            Style::Scatter => None,
            Style::Reference => Some(DashedPathElement::new(points, DASH, DASH, stroke).into_dyn()),
            _ => Some(PathElement::new(points, stroke).into_dyn()),
        }
    }

    /// The mark on a point, where there is one.
    fn mark<'a, At: Clone + 'static>(self, at: At) -> Option<Drawable<'a, At>> {
        let style = self.colour.filled().stroke_width(2 * FINE as u32);
        matches!(self.style, Style::Dots | Style::Scatter).then(|| match self.round % 3 {
            0 => Circle::new(at, MARK, style).into_dyn(),
            1 => TriangleMarker::new(at, MARK + FINE, style).into_dyn(),
            _ => Cross::new(at, MARK, style).into_dyn(),
        })
    }

    /// What stands beside the name in the legend: the mark, or else the line.
    fn key<'a>(self, (x, y): (i32, i32)) -> Drawable<'a, (i32, i32)> {
        let line = || self.line(vec![(x, y), (x + KEY, y)]);
        let nothing = || PathElement::new([], TRANSPARENT).into_dyn();
        self.mark((x + KEY / 2, y)).or_else(line).unwrap_or_else(nothing)
    }
}

/// A number of an axis; steps of plotters that should end on zero miss it by rounding.
fn tick(value: f64) -> f64 {
    if value.abs() < 1e-12 { 0.0 } else { value }
}

fn within(range: &Range<f64>, value: f64) -> bool {
    let slack = 1e-9 * (range.end - range.start);
    (range.start - slack..=range.end + slack).contains(&value)
}

#[cfg(test)]
mod tests {
    use plotters::coord::ranged1d::BoldPoints;

    use super::*;

    fn chart(series: Vec<Series>) -> Chart {
        Chart { x: Axis::log("seconds"), y: Axis::between("Q", 0.0, 1.0), series }
    }

    #[test]
    fn every_point_has_its_mark_and_every_series_its_key() {
        let dots = |name: &str| Series::new(name, Style::Dots, vec![[1.0, 0.5], [3.0, 0.7]]);
        let mut series = vec![dots("a<b"), dots("b"), Series::new("c", Style::Reference, vec![])];
        let svg = chart(series.clone()).svg("test");
        let count = |svg: &str, element: &str, colour: &str| {
            let of = |line: &&str| line.starts_with(element) && line.contains(colour);
            svg.lines().filter(of).count()
        };
        for colour in ["#0072B2", "#D55E00"] {
            assert_eq!(count(&svg, "<circle", colour), 3, "{svg}");
            assert_eq!(count(&svg, "<polyline", colour), 1, "{svg}");
        }
        assert!(["a&lt;b", "b", "c", "seconds", "Q"].iter().all(|name| svg.contains(name)));
        assert!(!svg.contains("a<b"));
        // Outside of the axes nothing is drawn, and what has no logarithm neither.
        series[0].points.extend([[2.0, 1.5], [-1.0, 0.5], [0.0, 0.5], [f64::NAN, 0.5]]);
        assert_eq!(count(&chart(series).svg("test"), "<circle", "#0072B2"), 3);
    }

    #[test]
    fn used_up_colours_come_again_with_another_mark() {
        let series = (0..8).map(|n| Series::new(n.to_string(), Style::Scatter, vec![[1.0, 0.5]]));
        let svg = chart(series.collect()).svg("test");
        assert_eq!(svg.matches("<circle").count(), 2 * 7);
        assert_eq!(svg.matches("<polygon").count(), 2);
    }

    #[test]
    fn a_logarithmic_axis_has_round_numbers_within_a_decade_and_over_many() {
        let numbers = |low: f64, high: f64| {
            log_scale(Axis::log("s").limits([low, high].into_iter())).key_points(BoldPoints(7))
        };
        let near = |found: &[f64], expected: &[f64]| {
            found.iter().zip(expected).all(|(a, b)| (a / b - 1.0).abs() < 1e-9)
                && found.len() == expected.len()
        };
        assert!(near(&numbers(0.3, 0.4), &[0.2, 0.5, 1.0]), "{:?}", numbers(0.3, 0.4));
        assert!(near(&numbers(0.9, 1100.0), &[1.0, 10.0, 100.0, 1000.0]));
        let svg = chart(vec![Series::new("a", Style::Dots, vec![[0.03, 0.1], [0.4, 0.9]])]);
        let svg = svg.svg("test");
        assert!(["0.05", "0.1", "0.2", "0.5"].iter().all(|n| svg.contains(&format!("\n{n}\n"))));
    }

    #[test]
    fn a_chart_without_points_is_a_chart() {
        let svg = chart(Vec::new()).svg("nothing");
        assert!(svg.starts_with("<svg") && !svg.contains("NaN"), "{svg}");
    }
}
