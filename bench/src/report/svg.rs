//! The little SVG that the report needs. Colours are classes, so that the page's style sheet can
//! follow the reader's light or dark scheme.

use std::fmt::Write;

/// Classes `c0`, `c1`, ... of the page's style sheet.
pub const COLOURS: usize = 8;

/// An SVG picture that scales with the page.
pub struct Svg {
    width: f64,
    height: f64,
    body: String,
}

impl Svg {
    /// An empty picture in units of about a pixel.
    pub fn new(width: f64, height: f64) -> Self {
        Self { width, height, body: String::new() }
    }

    /// Adds an element as it is.
    pub fn raw(&mut self, element: &str) {
        self.body.push_str(element);
        self.body.push('\n');
    }

    /// A straight line.
    pub fn line(&mut self, class: &str, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2]) {
        self.raw(&format!(
            "<line class=\"{class}\" x1=\"{x1:.1}\" y1=\"{y1:.1}\" x2=\"{x2:.1}\" y2=\"{y2:.1}\"/>"
        ));
    }

    /// A path of straight lines.
    pub fn polyline(&mut self, class: &str, points: &[[f64; 2]]) {
        let points = points.iter().fold(String::new(), |mut text, [x, y]| {
            // Writing to a String does not fail.
            let _ = write!(text, "{x:.1},{y:.1} ");
            text
        });
        self.raw(&format!("<polyline class=\"{class}\" points=\"{}\"/>", points.trim_end()));
    }

    /// A dot, with a text that a pointer on it shows.
    pub fn dot(&mut self, class: &str, [x, y]: [f64; 2], radius: f64, title: &str) {
        self.raw(&format!(
            "<circle class=\"{class}\" cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"{radius}\">\
             <title>{}</title></circle>",
            escaped(title)
        ));
    }

    /// Text; `anchor` is `start`, `middle` or `end`.
    pub fn text(&mut self, class: &str, anchor: &str, [x, y]: [f64; 2], text: &str) {
        self.raw(&format!(
            "<text class=\"{class}\" text-anchor=\"{anchor}\" x=\"{x:.1}\" y=\"{y:.1}\">{}</text>",
            escaped(text)
        ));
    }

    /// Text that reads upwards, centred on a point.
    pub fn text_upwards(&mut self, class: &str, [x, y]: [f64; 2], text: &str) {
        self.raw(&format!(
            "<text class=\"{class}\" text-anchor=\"middle\" \
             transform=\"translate({x:.1} {y:.1}) rotate(-90)\">{}</text>",
            escaped(text)
        ));
    }

    /// The picture as an element of a page; `description` is what a reader who cannot see it gets.
    pub fn finish(self, description: &str) -> String {
        format!(
            "<svg viewBox=\"0 0 {w:.0} {h:.0}\" width=\"{w:.0}\" role=\"img\" \
             aria-label=\"{}\">\n{}</svg>\n",
            escaped(description),
            self.body,
            w = self.width,
            h = self.height,
        )
    }
}

/// Text with what HTML would take for markup replaced.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// A number with as many digits as a reader needs: three significant ones.
pub fn number(value: f64) -> String {
    let magnitude = value.abs();
    match magnitude {
        _ if !value.is_finite() => "–".to_owned(),
        0.0 => "0".to_owned(),
        _ if magnitude >= 1e5 => format!("{value:.2e}"),
        _ if magnitude >= 99.95 => format!("{value:.0}"),
        _ if magnitude >= 9.995 => format!("{value:.1}"),
        _ if magnitude >= 0.9995 => format!("{value:.2}"),
        _ if magnitude >= 0.09995 => format!("{value:.3}"),
        _ if magnitude >= 0.001 => format!("{value:.4}"),
        _ => format!("{value:.1e}"),
    }
}

/// A number without zeros that say nothing: for ticks.
pub fn round_number(value: f64) -> String {
    let text = number(value);
    match text.contains('.') && !text.contains('e') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_three_significant_digits() {
        let cases = [(0.0, "0"), (1234.5, "1234"), (12.345, "12.3"), (1.2345, "1.23")];
        for (value, text) in cases {
            assert_eq!(number(value), text);
        }
        assert_eq!(
            [0.12345, 0.012345, 1.2e-5, 3e9].map(number),
            ["0.123", "0.0123", "1.2e-5", "3.00e9"]
        );
        assert_eq!([10.0, 0.5, -2.5, 200.0].map(round_number), ["10", "0.5", "-2.5", "200"]);
    }

    #[test]
    fn text_is_no_markup() {
        let mut svg = Svg::new(10.0, 10.0);
        svg.text("label", "start", [0.0, 0.0], "<b> & \"c\"");
        assert!(svg.finish("x").contains("&lt;b&gt; &amp; &quot;c&quot;"));
    }
}
