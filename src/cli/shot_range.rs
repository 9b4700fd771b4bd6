//! Parses ranges of shots.

use std::ops::RangeInclusive;

/// Parses a number, or first and last as A..B.
pub fn shot_range(text: &str) -> Result<RangeInclusive<u64>, String> {
    let number = |text: &str| {
        text.trim().parse::<u64>().map_err(|_| format!("'{text}' is not a shot number"))
    };
    match text.split_once("..") {
        None => number(text).map(|shot| shot..=shot),
        Some((first, last)) => Ok(number(first)?..=number(last.trim_start_matches('='))?),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_include_first_and_last_shot() {
        assert_eq!(shot_range("7"), Ok(7..=7));
        assert_eq!(shot_range("3..5"), Ok(3..=5));
        assert_eq!(shot_range("3..=5"), Ok(3..=5));
        assert!(shot_range("3..x").unwrap_err().contains("'x'"));
    }
}
