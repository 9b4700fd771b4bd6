//! The OpenAPI document, generated from the handlers, and a page that shows it without network
//! access.

use axum::{
    Json,
    extract::State,
    response::{IntoResponse, Response},
};
use utoipa::{
    Modify, OpenApi,
    openapi::{
        Content, Ref, RefOr, Response as Answer, ResponseBuilder,
        path::Operation,
        security::{HttpAuthScheme, HttpBuilder, SecurityScheme},
    },
};

use super::{
    app::App,
    page::{file, html},
};

const PAGE: &str = include_str!("../../web/openapi/index.html");
const SCRIPT: &str = include_str!("../../web/openapi/viewer.js");
const STYLE: &str = include_str!("../../web/openapi/viewer.css");

/// The parts of the document that do not belong to a handler.
#[derive(OpenApi)]
#[openapi(
    info(
        title = "lfpiv",
        version = "1",
        description = "A run of the light-field PIV bench: its state, its results and its \
                       controls. Units are part of the names. docs/http.md has the byte layouts.",
        license(name = "MIT OR Apache-2.0")
    ),
    tags(
        (name = "live", description = "State of the run"),
        (name = "shots", description = "State of each shot"),
        (name = "results", description = "Velocity fields, particles, volumes and their projections"),
        (name = "control", description = "Needs a token of scope control, also on loopback"),
        (name = "document", description = "This document, and the bench in a browser")
    ),
    components(schemas(super::error::ErrorBody)),
    modifiers(&Bearer)
)]
pub(super) struct Document;

struct Bearer;

impl Modify for Bearer {
    fn modify(&self, document: &mut utoipa::openapi::OpenApi) {
        let scheme = HttpBuilder::new().scheme(HttpAuthScheme::Bearer).description(Some(
            "A token of server.tokens; without that file, reading on loopback needs no token.",
        ));
        let components = document.components.get_or_insert_default();
        components.add_security_scheme("bearer", SecurityScheme::Http(scheme.build()));
        document.security =
            Some(vec![utoipa::openapi::SecurityRequirement::new("bearer", [] as [&str; 0])]);
    }
}

/// Adds the errors that can occur before the handler.
pub(super) fn with_common_errors(
    mut document: utoipa::openapi::OpenApi,
) -> utoipa::openapi::OpenApi {
    for item in document.paths.paths.values_mut() {
        for operation in [&mut item.get, &mut item.post].into_iter().flatten() {
            add_common_errors(operation);
        }
    }
    document
}

fn add_common_errors(operation: &mut Operation) {
    let open = operation.security.is_some();
    for (status, when, only_guarded) in [
        ("400", "The request cannot be parsed", false),
        ("401", "No token, or an unknown one", true),
        (
            "403",
            "The token's scope is insufficient, or the request comes from a page of another server",
            false,
        ),
        ("408", "The request took too long", false),
        ("421", "The host name is not one of this server's", false),
        ("429", "Too many requests", false),
    ] {
        let known = operation.responses.responses.contains_key(status);
        if !(known || open && only_guarded) {
            operation.responses.responses.insert(status.to_owned(), error(when));
        }
    }
}

fn error(when: &str) -> RefOr<Answer> {
    let body = Content::new(Some(Ref::from_schema_name("ErrorBody")));
    ResponseBuilder::new().description(when).content("application/json", body).build().into()
}

/// The document.
#[utoipa::path(get, path = "/api/v1/openapi.json", tag = "document", security(()),
    responses((status = 200, body = Object)))]
pub(super) async fn document(State(app): State<App>) -> Response {
    Json(app.document.as_ref()).into_response()
}

/// A page that shows the document.
#[utoipa::path(get, path = "/docs", tag = "document", security(()),
    responses((status = 200, content_type = "text/html", body = String)))]
pub(super) async fn page() -> Response {
    html(PAGE)
}

/// The page's script.
#[utoipa::path(get, path = "/docs/viewer.js", tag = "document", security(()),
    responses((status = 200, content_type = "text/javascript", body = String)))]
pub(super) async fn script() -> Response {
    file("text/javascript; charset=utf-8", SCRIPT)
}

/// The page's style.
#[utoipa::path(get, path = "/docs/viewer.css", tag = "document", security(()),
    responses((status = 200, content_type = "text/css", body = String)))]
pub(super) async fn style() -> Response {
    file("text/css; charset=utf-8", STYLE)
}
