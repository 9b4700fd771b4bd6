//! Pictures by plotters, as elements of the page.

use plotters::{
    coord::Shift,
    drawing::{DrawingArea, DrawingAreaErrorKind},
    prelude::{IntoDrawingArea, IntoFont, RGBColor, SVGBackend},
    style::{Color, TextStyle},
};

use super::text::escaped;

/// Where a picture is drawn; its points are [`FINE`] to a unit of the page.
pub type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;
/// What a drawing comes to.
pub type Drawn = Result<(), DrawingAreaErrorKind<std::io::Error>>;

/// Steps of a unit, which is about a pixel of the screen: plotters places in whole steps.
pub const FINE: i32 = 4;

/// Text and axes.
pub const INK: RGBColor = RGBColor(60, 66, 72);
/// Lines of a grid, frames.
pub const RULE: RGBColor = RGBColor(217, 220, 223);

/// Height of letters in units.
const LETTERS: f64 = 12.0;
/// plotters makes letters smaller by this than it is told.
const FONT_RATIO: f64 = 1.24;

/// Draws a picture of a width and a height in units; `description` is what a reader who cannot see
/// it gets.
pub fn picture(
    [width, height]: [i32; 2],
    description: &str,
    draw: impl FnOnce(&Area) -> Drawn,
) -> String {
    let steps = (width * FINE, height * FINE);
    let mut svg = String::new();
    let area = SVGBackend::with_string(&mut svg, (steps.0 as u32, steps.1 as u32));
    let area = area.into_drawing_area();
    let drawn = draw(&area).and_then(|()| area.present());
    drop(area);
    if let Err(error) = drawn {
        return format!("<p class=\"missed\">Not drawn: {}</p>\n", escaped(&error.to_string()));
    }
    // The page says how large it is and what it shows; it needs no name space.
    let elements = svg.split_once('>').map_or("", |(_, elements)| elements);
    format!(
        "<svg viewBox=\"0 0 {} {}\" width=\"{width}\" role=\"img\" aria-label=\"{}\">{elements}",
        steps.0,
        steps.1,
        escaped(description)
    )
}

/// A picture as a file of its own, on white.
pub fn standalone(svg: &str) -> String {
    let start = "<svg xmlns=\"http://www.w3.org/2000/svg\" style=\"background:#fff\" ";
    svg.replacen("<svg ", start, 1)
}

/// A picture among others.
pub struct Panel {
    /// Written above it.
    pub title: String,
    /// By [`picture`].
    pub svg: String,
    /// A box that is drawn over it: left, right, bottom and top as shares of what is right of and above the names of
    /// the axes.
    pub marked: Option<[f64; 4]>,
}

/// Room for a title, for the names of axes, and between panels, in units.
const TITLE: f64 = 20.0;
const NAME: f64 = 24.0;
const BETWEEN: f64 = 16.0;

/// Least width of a panel: that of a title.
const LEAST_WIDTH: f64 = 190.0;

/// Panels in rows, as a file of its own. Edges are crisp, or cells of one colour would show seams between them.
pub fn panels(rows: &[Vec<Panel>]) -> String {
    let (mut inside, mut y, mut widest) = (String::new(), 0.0, 0.0_f64);
    for row in rows {
        let (mut x, mut tallest) = (BETWEEN, 0.0_f64);
        for panel in row {
            let [width, height] = size(&panel.svg);
            let top = y + TITLE;
            inside += &format!(
                "<text x=\"{x}\" y=\"{:.1}\" font-family=\"sans-serif\" font-size=\"{LETTERS}\">{}</text>\n",
                top - 6.0,
                escaped(&panel.title)
            );
            let placed = format!("<svg x=\"{x}\" y=\"{top}\" height=\"{height}\" ");
            inside += &panel.svg.replacen("<svg ", &placed, 1);
            if let Some([left, right, bottom, above]) = panel.marked {
                let [across, up] = [width - NAME, height - NAME];
                inside += &format!(
                    "<rect x=\"{:.1}\" y=\"{:.1}\" width=\"{:.1}\" height=\"{:.1}\" fill=\"none\" \
                     stroke=\"#000\" stroke-width=\"1.5\"/>\n",
                    x + NAME + left * across,
                    top + (1.0 - above) * up,
                    (right - left) * across,
                    (above - bottom) * up
                );
            }
            x += width.max(LEAST_WIDTH) + BETWEEN;
            tallest = tallest.max(height);
        }
        widest = widest.max(x);
        y += TITLE + tallest + BETWEEN;
    }
    let outer = format!(
        "<svg viewBox=\"0 0 {widest} {y}\" width=\"{widest}\" role=\"img\" \
         shape-rendering=\"crispEdges\">\n{inside}</svg>\n"
    );
    standalone(&outer)
}

/// Width and height of a picture, in units; zero where it could not be drawn.
fn size(svg: &str) -> [f64; 2] {
    let numbers = svg.split_once("viewBox=\"0 0 ").and_then(|(_, rest)| rest.split_once('"'));
    let steps = numbers.and_then(|(numbers, _)| numbers.split_once(' '));
    let units = |steps: &str| steps.parse::<f64>().unwrap_or(0.0) / f64::from(FINE);
    steps.map_or([0.0; 2], |(width, height)| [units(width), units(height)])
}

/// The style of all text.
pub fn letters() -> TextStyle<'static> {
    ("sans-serif", LETTERS * FONT_RATIO * f64::from(FINE)).into_font().color(&INK.to_rgba())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn panels_stand_beside_and_below_each_other() {
        let panel = |title: &str, marked| Panel {
            title: title.to_owned(),
            svg: picture([200, 100], title, |_| Ok(())),
            marked,
        };
        let rows = [
            vec![panel("a<b", None), panel("c", Some([0.0, 0.5, 0.25, 1.0]))],
            vec![panel("d", None)],
        ];
        let svg = panels(&rows);
        assert!(svg.starts_with("<svg xmlns="), "{svg}");
        assert!(svg.contains("viewBox=\"0 0 448 272\""), "{svg}");
        for part in [
            "<svg x=\"16\" y=\"20\" height=\"100\" viewBox=\"0 0 800 400\" width=\"200\"",
            "<svg x=\"232\" y=\"20\"",
            "<svg x=\"16\" y=\"156\"",
            "a&lt;b",
            "<rect x=\"256.0\" y=\"20.0\" width=\"88.0\" height=\"57.0\"",
        ] {
            assert!(svg.contains(part), "{part} in {svg}");
        }
    }

    #[test]
    fn text_is_no_markup() {
        let svg = picture([100, 20], "\"><script>", |area| {
            area.draw_text("<b> & \"c\"", &letters(), (0, 0))
        });
        assert!(svg.contains("&lt;b&gt; &amp; &quot;c&quot;"), "{svg}");
        assert!(svg.contains("aria-label=\"&quot;&gt;&lt;script&gt;\""), "{svg}");
        assert!(!svg.contains("http") && svg.ends_with("</svg>\n"), "{svg}");
    }
}
