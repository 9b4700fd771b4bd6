//! The bench page: built by `web/bench/build.mjs`, embedded in the program, served at `/`.
//!
//! [`POLICY`] restricts all pages: they run only scripts of this server, none of them inline,
//! connect only to this server, and cannot be framed.

use axum::{
    http::{HeaderValue, header},
    response::{IntoResponse, Response},
};

const PAGE: &str = include_str!("../../web/bench/dist/index.html");
const SCRIPT: &str = include_str!("../../web/bench/dist/bench.js");
const STYLE: &str = include_str!("../../web/bench/dist/bench.css");
const ICON: &str = include_str!("../../web/bench/dist/icon.svg");

/// Content security policy of the pages.
const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self'; connect-src 'self'; \
                      img-src 'self' blob:; base-uri 'none'; form-action 'none'; \
                      frame-ancestors 'none'; require-trusted-types-for 'script'; \
                      trusted-types 'none'";

/// An HTML response with the policy.
pub(super) fn html(text: &'static str) -> Response {
    let policy = (header::CONTENT_SECURITY_POLICY, HeaderValue::from_static(POLICY));
    ([policy], file("text/html; charset=utf-8", text)).into_response()
}

/// A response with an embedded file.
pub(super) fn file(media_type: &'static str, text: &'static str) -> Response {
    ([(header::CONTENT_TYPE, media_type)], text).into_response()
}

/// The bench in a browser.
#[utoipa::path(get, path = "/", tag = "document", security(()),
    responses((status = 200, content_type = "text/html", body = String)))]
pub(super) async fn page() -> Response {
    html(PAGE)
}

/// The bench page's script.
#[utoipa::path(get, path = "/bench/bench.js", tag = "document", security(()),
    responses((status = 200, content_type = "text/javascript", body = String)))]
pub(super) async fn script() -> Response {
    file("text/javascript; charset=utf-8", SCRIPT)
}

/// The bench page's style.
#[utoipa::path(get, path = "/bench/bench.css", tag = "document", security(()),
    responses((status = 200, content_type = "text/css", body = String)))]
pub(super) async fn style() -> Response {
    file("text/css; charset=utf-8", STYLE)
}

/// The bench page's icon.
#[utoipa::path(get, path = "/bench/icon.svg", tag = "document", security(()),
    responses((status = 200, content_type = "image/svg+xml", body = String)))]
pub(super) async fn icon() -> Response {
    file("image/svg+xml", ICON)
}
