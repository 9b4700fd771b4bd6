//! Detects tokens in URLs, which logs, histories and referrers store.

use axum::http::Uri;
use percent_encoding::percent_decode_str;

use super::tokens::{Tokens, is_strong};

/// Whether a URL contains a configured token, or anything that looks like a token.
pub(in crate::server) fn contains_token(uri: &Uri, tokens: Option<&Tokens>) -> bool {
    let is_token = |word: &str| {
        tokens.is_some_and(|tokens| tokens.scope_of(word).is_some()) || is_strong(word)
    };
    let in_path = uri.path().split('/');
    let in_query = uri.query().into_iter().flat_map(|query| query.split(['&', ';', '?']));
    let pieces = in_path.chain(in_query).map(|piece| percent_decode_str(piece).decode_utf8_lossy());
    pieces.flat_map(|piece| words(&piece)).any(|word| is_token(&word))
}

/// A piece of a URL as a whole, its value after `=`, and its single words, as in `auth=Bearer
/// TOKEN`.
fn words(piece: &str) -> Vec<String> {
    let value = piece.split_once('=').map(|(_, value)| value);
    let parts = [Some(piece), value, piece.split('=').next()].into_iter().flatten();
    // A plus may encode a space, but it also occurs in tokens.
    let in_words = parts.clone().flat_map(|part| {
        part.split([' ', '+', ',', ':', '"', '\'']).chain(part.split([' ', ',', ':', '"', '\'']))
    });
    parts.chain(in_words).map(str::to_owned).collect()
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    const TOKEN: &str = "d41f8c62b07e93a5146fe0c9837b2ad5";
    const PLUS: &str = "Zr8+qT1/vXo2Lk9wBe5HdM==";

    #[test]
    fn a_token_is_found_by_its_value_under_any_name() {
        let text = format!("read {TOKEN}\ncontrol {PLUS}\n");
        let tokens = Tokens::parse(Path::new("tokens"), &text).unwrap();
        for uri in [
            format!("/a?token={TOKEN}"),
            format!("/a?limit=1&x={TOKEN}"),
            format!("/a?{TOKEN}"),
            format!("/a?{TOKEN}=1"),
            format!("/a?auth=Bearer%20{TOKEN}"),
            format!("/a?auth=Bearer+{TOKEN}"),
            format!("/a?x=%64{}", &TOKEN[1..]),
            format!("/a/{TOKEN}"),
            format!("/a?q={PLUS}"),
            format!("/a?q={}", PLUS.replace('+', "%2B").replace('/', "%2f").replace('=', "%3D")),
        ] {
            let uri: Uri = uri.parse().unwrap();
            assert!(contains_token(&uri, Some(&tokens)), "{uri}");
            // A client may send the token of another server to this one, which has none.
            assert!(contains_token(&uri, None), "{uri}");
        }
        for uri in [
            "/token",
            "/a?limit=1000",
            "/a?token=1",
            "/a?format=binary&width=640",
            "/api/v1/results/latest/projections/a/xy.png",
            "/api/v1/shots/18446744073709551615",
        ] {
            assert!(!contains_token(&uri.parse().unwrap(), Some(&tokens)), "{uri}");
        }
    }
}
