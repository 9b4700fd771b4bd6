//! Single byte ranges of a response (RFC 9110, section 14).

use std::ops::Range;

/// Meaning of a `Range` header.
#[derive(Debug, PartialEq, Eq)]
pub enum RangeRequest {
    /// Not a single byte range; RFC 9110 allows to ignore it.
    Whole,
    /// These bytes.
    Part(Range<usize>),
    /// A range outside of the response.
    Unsatisfiable,
}

/// What a `Range` header asks of `length` bytes.
pub fn parse_range(header: &str, length: usize) -> RangeRequest {
    let Some((first, last)) = header.strip_prefix("bytes=").and_then(|range| range.split_once('-'))
    else {
        return RangeRequest::Whole;
    };
    let digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    if !digits(first) || !digits(last) || (first.is_empty() && last.is_empty()) {
        return RangeRequest::Whole;
    }
    // A number with too many digits is larger than any length.
    let number = |text: &str| text.parse::<usize>().unwrap_or(usize::MAX);
    let part = match (first, last) {
        ("", suffix) => length.saturating_sub(number(suffix))..length,
        (first, "") => number(first)..length,
        (first, last) if number(last) < number(first) => return RangeRequest::Whole,
        (first, last) => number(first)..number(last).saturating_add(1).min(length),
    };
    if part.start < part.end { RangeRequest::Part(part) } else { RangeRequest::Unsatisfiable }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn ranges_are_read_as_rfc_9110_says() {
        let cases = [
            ("bytes=0-0", RangeRequest::Part(0..1)),
            ("bytes=2-4", RangeRequest::Part(2..5)),
            ("bytes=2-", RangeRequest::Part(2..10)),
            ("bytes=-3", RangeRequest::Part(7..10)),
            ("bytes=-300", RangeRequest::Part(0..10)),
            ("bytes=9-99999999999999999999999", RangeRequest::Part(9..10)),
            ("bytes=10-", RangeRequest::Unsatisfiable),
            ("bytes=-0", RangeRequest::Unsatisfiable),
            ("bytes=99999999999999999999999-", RangeRequest::Unsatisfiable),
            ("bytes=4-2", RangeRequest::Whole),
            ("bytes=0-1,3-4", RangeRequest::Whole),
            ("bytes=-", RangeRequest::Whole),
            ("bytes=+1-2", RangeRequest::Whole),
            ("lines=1-2", RangeRequest::Whole),
            ("", RangeRequest::Whole),
        ];
        for (header, expected) in cases {
            assert_eq!(parse_range(header, 10), expected, "{header}");
        }
        assert_eq!(parse_range("bytes=0-", 0), RangeRequest::Unsatisfiable);
    }

    proptest! {
        #[test]
        fn every_parsed_range_lies_within_the_response(
            header in "(bytes=)?[0-9a-z,+ -]{0,30}",
            length in 0usize..50,
        ) {
            if let RangeRequest::Part(part) = parse_range(&header, length) {
                prop_assert!(part.start < part.end && part.end <= length);
            }
        }
    }
}
