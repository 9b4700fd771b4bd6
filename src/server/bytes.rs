//! Answers that never change: strong `ETag`s, `If-None-Match`, and one range of bytes
//! (RFC 9110, sections 13 and 14).

use std::ops::Range;

use axum::{
    body::Bytes,
    http::{HeaderMap, HeaderValue, StatusCode, header},
    response::{IntoResponse, Response},
};

use super::ApiError;

/// Names one unchanging answer of one run.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct ETag(String);

impl ETag {
    /// `run` tells this run from others; `name` tells answers of a run apart.
    pub fn new(run: u64, name: &str) -> Self {
        Self(format!("\"{run:x}-{name}\""))
    }

    /// Whether the client has this answer already.
    fn is_with_client(&self, request: &HeaderMap) -> bool {
        let listed = request.get_all(header::IF_NONE_MATCH).iter();
        listed.filter_map(|list| list.to_str().ok()).flat_map(|list| list.split(',')).any(|tag| {
            let tag = tag.trim();
            tag == "*" || tag.strip_prefix("W/").unwrap_or(tag) == self.0
        })
    }

    /// Whether a range of what the client has is a range of this.
    fn allows_range(&self, request: &HeaderMap) -> bool {
        request.get(header::IF_RANGE).is_none_or(|tag| tag.as_bytes() == self.0.as_bytes())
    }

    fn headers(&self) -> HeaderMap {
        let mut headers = HeaderMap::new();
        // The name is made of digits, letters and dashes.
        if let Ok(tag) = HeaderValue::from_str(&self.0) {
            headers.insert(header::ETAG, tag);
        }
        headers.insert(header::CACHE_CONTROL, HeaderValue::from_static("private, no-cache"));
        headers.insert(header::VARY, HeaderValue::from_static("Accept, Authorization"));
        headers
    }
}

/// 304 when the client has it, otherwise what `make` makes, or the range asked for.
pub(super) async fn unchanging<F>(
    request: &HeaderMap,
    tag: &ETag,
    media_type: &'static str,
    make: impl FnOnce() -> F,
) -> Result<Response, ApiError>
where
    F: Future<Output = Result<(Bytes, HeaderMap), ApiError>>,
{
    let mut headers = tag.headers();
    if tag.is_with_client(request) {
        return Ok((StatusCode::NOT_MODIFIED, headers).into_response());
    }
    let (bytes, more) = make().await?;
    headers.extend(more);
    headers.insert(header::CONTENT_TYPE, HeaderValue::from_static(media_type));
    headers.insert(header::ACCEPT_RANGES, HeaderValue::from_static("bytes"));
    let range = request.get(header::RANGE).filter(|_| tag.allows_range(request));
    let range = range.and_then(|range| range.to_str().ok());
    match range.map_or(Asked::All, |range| asked(range, bytes.len())) {
        Asked::All => Ok((headers, bytes).into_response()),
        Asked::Part(part) => {
            let place = format!("bytes {}-{}/{}", part.start, part.end - 1, bytes.len());
            let place = [(header::CONTENT_RANGE, place)];
            Ok((StatusCode::PARTIAL_CONTENT, headers, place, bytes.slice(part)).into_response())
        }
        Asked::Nothing => {
            let length = format!("bytes */{}", bytes.len());
            let error = format!("the range is outside of the {} bytes there are", bytes.len());
            let error = ApiError::new(StatusCode::RANGE_NOT_SATISFIABLE, error);
            Ok(([(header::CONTENT_RANGE, length)], error).into_response())
        }
    }
}

/// What a `Range` header asks for.
#[derive(Debug, PartialEq, Eq)]
enum Asked {
    /// No single range of bytes; RFC 9110 allows to ignore it.
    All,
    Part(Range<usize>),
    /// A range that is not there.
    Nothing,
}

fn asked(header: &str, length: usize) -> Asked {
    let Some((first, last)) = header.strip_prefix("bytes=").and_then(|range| range.split_once('-'))
    else {
        return Asked::All;
    };
    let digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
    if !digits(first) || !digits(last) || (first.is_empty() && last.is_empty()) {
        return Asked::All;
    }
    // More digits than fit in a number are more than any length.
    let number = |text: &str| text.parse::<usize>().unwrap_or(usize::MAX);
    let part = match (first, last) {
        ("", suffix) => length.saturating_sub(number(suffix))..length,
        (first, "") => number(first)..length,
        (first, last) if number(last) < number(first) => return Asked::All,
        (first, last) => number(first)..number(last).saturating_add(1).min(length),
    };
    if part.start < part.end { Asked::Part(part) } else { Asked::Nothing }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn ranges_are_read_as_rfc_9110_says() {
        let cases = [
            ("bytes=0-0", Asked::Part(0..1)),
            ("bytes=2-4", Asked::Part(2..5)),
            ("bytes=2-", Asked::Part(2..10)),
            ("bytes=-3", Asked::Part(7..10)),
            ("bytes=-300", Asked::Part(0..10)),
            ("bytes=9-99999999999999999999999", Asked::Part(9..10)),
            ("bytes=10-", Asked::Nothing),
            ("bytes=-0", Asked::Nothing),
            ("bytes=99999999999999999999999-", Asked::Nothing),
            ("bytes=4-2", Asked::All),
            ("bytes=0-1,3-4", Asked::All),
            ("bytes=-", Asked::All),
            ("bytes=+1-2", Asked::All),
            ("lines=1-2", Asked::All),
            ("", Asked::All),
        ];
        for (header, expected) in cases {
            assert_eq!(asked(header, 10), expected, "{header}");
        }
        assert_eq!(asked("bytes=0-", 0), Asked::Nothing);
    }

    #[test]
    fn a_tag_is_found_in_a_list_and_weakened() {
        let tag = ETag::new(0xab, "field-7");
        let with_client = |value: &'static str| {
            let mut headers = HeaderMap::new();
            headers.insert(header::IF_NONE_MATCH, HeaderValue::from_static(value));
            tag.is_with_client(&headers)
        };
        for value in ["\"ab-field-7\"", "\"x\", W/\"ab-field-7\"", "*"] {
            assert!(with_client(value), "{value}");
        }
        for value in ["\"ab-field-8\"", "ab-field-7", ""] {
            assert!(!with_client(value), "{value}");
        }
    }

    proptest! {
        #[test]
        fn any_header_gives_a_range_that_is_there(
            header in "(bytes=)?[0-9a-z,+ -]{0,30}",
            length in 0usize..50,
        ) {
            if let Asked::Part(part) = asked(&header, length) {
                prop_assert!(part.start < part.end && part.end <= length);
            }
        }
    }
}
