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

/// The style of all text.
pub fn letters() -> TextStyle<'static> {
    ("sans-serif", LETTERS * FONT_RATIO * f64::from(FINE)).into_font().color(&INK.to_rgba())
}

#[cfg(test)]
mod tests {
    use super::*;

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
