//! Text and numbers as the page shows them.

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
}
