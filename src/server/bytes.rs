//! Responses that never change: strong `ETag`s, `If-None-Match`, and single byte ranges (RFC 9110,
//! sections 13 and 14).

use axum::{
    body::Bytes,
    http::{HeaderMap, HeaderValue, StatusCode, header},
    response::{IntoResponse, Response},
};

use super::ApiError;
use crate::cluster::{RangeRequest, parse_range};

/// Identifies one immutable response of one run.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct ETag(String);

impl ETag {
    /// `run` identifies the run; `name` identifies the response within the run.
    pub fn new(run: u64, name: &str) -> Self {
        Self(format!("\"{run:x}-{name}\""))
    }

    /// Whether the request's `If-None-Match` lists this tag.
    fn is_listed_in(&self, request: &HeaderMap) -> bool {
        let listed = request.get_all(header::IF_NONE_MATCH).iter();
        listed.filter_map(|list| list.to_str().ok()).flat_map(|list| list.split(',')).any(|tag| {
            let tag = tag.trim();
            tag == "*" || tag.strip_prefix("W/").unwrap_or(tag) == self.0
        })
    }

    /// Whether the request's `If-Range` allows a range of this response.
    fn allows_range(&self, request: &HeaderMap) -> bool {
        request.get(header::IF_RANGE).is_none_or(|tag| tag.as_bytes() == self.0.as_bytes())
    }

    fn headers(&self) -> HeaderMap {
        let mut headers = HeaderMap::new();
        // The tag consists of digits, letters and dashes.
        if let Ok(tag) = HeaderValue::from_str(&self.0) {
            headers.insert(header::ETAG, tag);
        }
        headers.insert(header::CACHE_CONTROL, HeaderValue::from_static("private, no-cache"));
        headers.insert(header::VARY, HeaderValue::from_static("Accept, Authorization"));
        headers
    }
}

/// Responds with 304 if the client has the response; otherwise calls `make` for the bytes and
/// additional headers, and sends all bytes or the requested range.
pub(super) async fn cacheable<F>(
    request: &HeaderMap,
    tag: &ETag,
    media_type: &'static str,
    make: impl FnOnce() -> F,
) -> Result<Response, ApiError>
where
    F: Future<Output = Result<(Bytes, HeaderMap), ApiError>>,
{
    let mut headers = tag.headers();
    if tag.is_listed_in(request) {
        return Ok((StatusCode::NOT_MODIFIED, headers).into_response());
    }
    let (bytes, more) = make().await?;
    headers.extend(more);
    headers.insert(header::CONTENT_TYPE, HeaderValue::from_static(media_type));
    headers.insert(header::ACCEPT_RANGES, HeaderValue::from_static("bytes"));
    let range = request.get(header::RANGE).filter(|_| tag.allows_range(request));
    let range = range.and_then(|range| range.to_str().ok());
    match range.map_or(RangeRequest::Whole, |range| parse_range(range, bytes.len())) {
        RangeRequest::Whole => Ok((headers, bytes).into_response()),
        RangeRequest::Part(part) => {
            let place = format!("bytes {}-{}/{}", part.start, part.end - 1, bytes.len());
            let place = [(header::CONTENT_RANGE, place)];
            Ok((StatusCode::PARTIAL_CONTENT, headers, place, bytes.slice(part)).into_response())
        }
        RangeRequest::Unsatisfiable => {
            let length = format!("bytes */{}", bytes.len());
            let error = format!("the range is outside of the {} bytes there are", bytes.len());
            let error = ApiError::new(StatusCode::RANGE_NOT_SATISFIABLE, error);
            Ok(([(header::CONTENT_RANGE, length)], error).into_response())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_tag_is_found_in_lists_and_as_weak_tag() {
        let tag = ETag::new(0xab, "field-7");
        let is_listed = |value: &'static str| {
            let mut headers = HeaderMap::new();
            headers.insert(header::IF_NONE_MATCH, HeaderValue::from_static(value));
            tag.is_listed_in(&headers)
        };
        for value in ["\"ab-field-7\"", "\"x\", W/\"ab-field-7\"", "*"] {
            assert!(is_listed(value), "{value}");
        }
        for value in ["\"ab-field-8\"", "ab-field-7", ""] {
            assert!(!is_listed(value), "{value}");
        }
    }
}
