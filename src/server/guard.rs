//! What every request passes before a handler sees it, in this order: how often this client asks,
//! by which name it calls the server and from which page, how large the request is and how long it
//! takes, and what its token allows.

use std::time::{Duration, Instant};

use axum::{
    body::HttpBody,
    extract::{Request, State},
    http::{HeaderMap, HeaderValue, Method, StatusCode, header},
    middleware::Next,
    response::{IntoResponse, Response},
};

use super::{
    ApiError, BODY_BYTES,
    app::{App, Connection},
    protection::{Origin, Scope, holds_token},
    seats::SeatHandle,
};

/// Requests that make the bench safe are never turned away for their number.
const NEVER_LIMITED: [&str; 2] = ["/api/v1/control/stop", "/api/v1/control/disarm"];

/// Headers that keep browsers from guessing, framing, lending and remembering answers.
pub(super) async fn headers(request: Request, next: Next) -> Response {
    let mut response = next.run(request).await;
    let headers = response.headers_mut();
    for (name, value) in [
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (header::X_FRAME_OPTIONS, "DENY"),
        (header::REFERRER_POLICY, "no-referrer"),
        (header::HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
    ] {
        headers.insert(name, HeaderValue::from_static(value));
    }
    let no_store = HeaderValue::from_static("no-store");
    headers.entry(header::CACHE_CONTROL).or_insert(no_store);
    response
}

/// So many requests per client, except those that make the bench safe.
pub(super) async fn rate(
    State(app): State<App>,
    connection: axum::Extension<Connection>,
    request: Request,
    next: Next,
) -> Result<Response, ApiError> {
    if !makes_safe(&request)
        && let Err(wait) = app.protection.rates.take(connection.peer.ip(), Instant::now())
    {
        let seconds = wait.as_secs_f64().ceil().max(1.0) as u64;
        let error = "too many requests from this address; see server.requests_per_s";
        return Err(ApiError::new(StatusCode::TOO_MANY_REQUESTS, error)
            .header(header::RETRY_AFTER, HeaderValue::from(seconds)));
    }
    Ok(next.run(request).await)
}

/// By our own names and from our own pages only, and without secrets in the address.
pub(super) async fn origin(
    State(app): State<App>,
    connection: axum::Extension<Connection>,
    request: Request,
    next: Next,
) -> Result<Response, ApiError> {
    let hosts = &app.protection.hosts;
    let host = single(request.headers(), header::HOST)?
        .ok_or_else(|| ApiError::bad_request("the request has no Host header"))?;
    let named = [Some(host), request.uri().authority().map(|authority| authority.as_str())];
    if let Some(foreign) =
        named.into_iter().flatten().find(|host| !hosts.allows(host, connection.local.ip()))
    {
        let error = format!("'{foreign}' is not this server: list its names in server.hosts");
        return Err(ApiError::new(StatusCode::MISDIRECTED_REQUEST, error));
    }
    if let Some(origin) = single(request.headers(), header::ORIGIN)?
        && hosts.origin(origin, host) == Origin::Foreign
    {
        let error = "requests from pages of other servers are refused";
        return Err(ApiError::new(StatusCode::FORBIDDEN, error));
    }
    if holds_token(request.uri(), app.protection.tokens.as_ref()) {
        return Err(ApiError::bad_request(
            "there is a token in the address, where logs and histories keep it: send it as \
             'Authorization: Bearer TOKEN', and replace this one",
        ));
    }
    Ok(next.run(request).await)
}

/// The value of a header that may be there once, in ASCII.
fn single(headers: &HeaderMap, name: header::HeaderName) -> Result<Option<&str>, ApiError> {
    let mut values = headers.get_all(&name).iter();
    match (values.next(), values.next()) {
        (None, _) => Ok(None),
        (Some(value), None) => value
            .to_str()
            .map(Some)
            .map_err(|_| ApiError::bad_request(format!("the header {name} is not in ASCII"))),
        (Some(_), Some(_)) => {
            Err(ApiError::bad_request(format!("the header {name} is there more than once")))
        }
    }
}

/// A body that is said to be too large is refused before any of it is waited for; one that turns
/// out to be is cut off by the router's limit.
pub(super) async fn size(request: Request, next: Next) -> Result<Response, ApiError> {
    let length = single(request.headers(), header::CONTENT_LENGTH)?;
    let length = length.and_then(|length| length.parse::<u64>().ok()).unwrap_or_default();
    if length > BODY_BYTES as u64 {
        let error = format!("a body of {length} bytes; allowed: {BODY_BYTES}");
        return Err(ApiError::new(StatusCode::PAYLOAD_TOO_LARGE, error));
    }
    Ok(next.run(request).await)
}

/// Longest that a request without a body is worked on: what takes long is then this machine, not the
/// client.
const WORK: Duration = Duration::from_secs(60);

/// No request is worked on for ever: a client that sends its body too slowly is cut off here.
pub(super) async fn deadline(
    State(app): State<App>,
    request: Request,
    next: Next,
) -> Result<Response, ApiError> {
    let patience = match request.body().is_end_stream() {
        true => app.protection.patience.max(WORK),
        false => app.protection.patience,
    };
    tokio::time::timeout(patience, next.run(request)).await.map_err(|_| {
        let error = format!("the request was not complete after {} s", patience.as_secs_f64());
        ApiError::new(StatusCode::REQUEST_TIMEOUT, error)
    })
}

/// Reading: anybody on loopback without a file of tokens, otherwise any token of it.
pub(super) async fn may_read(
    State(app): State<App>,
    request: Request,
    next: Next,
) -> Result<Response, Response> {
    admit(&app, Scope::Read, request.headers()).map_err(IntoResponse::into_response)?;
    seated(&app, &request).map_err(IntoResponse::into_response)?;
    Ok(next.run(request).await)
}

/// Control: a token of that scope, in every case. Otherwise a page in the operator's browser could
/// fire a laser.
pub(super) async fn may_control(
    State(app): State<App>,
    request: Request,
    next: Next,
) -> Result<Response, Response> {
    admit(&app, Scope::Control, request.headers()).map_err(IntoResponse::into_response)?;
    if !makes_safe(&request) {
        seated(&app, &request).map_err(IntoResponse::into_response)?;
        return Ok(next.run(request).await);
    }
    if let Some(seat) = request.extensions().get::<SeatHandle>() {
        seat.make_safe();
    }
    let mut response = next.run(request).await;
    // Its seat is for the next one.
    response.headers_mut().insert(header::CONNECTION, HeaderValue::from_static("close"));
    Ok(response)
}

fn makes_safe(request: &Request) -> bool {
    request.method() == Method::POST && NEVER_LIMITED.contains(&request.uri().path())
}

/// A seat for the connection of a request that was let in.
fn seated(app: &App, request: &Request) -> Result<(), ApiError> {
    if request.extensions().get::<SeatHandle>().is_none_or(SeatHandle::admit) {
        return Ok(());
    }
    let key = if app.protection.tokens.is_some() { "connections" } else { "guests" };
    let error = format!("too many connections, from this address or in all; see server.{key}");
    Err(ApiError::busy(error))
}

fn admit(app: &App, needed: Scope, headers: &HeaderMap) -> Result<(), ApiError> {
    let Some(tokens) = &app.protection.tokens else {
        return match needed {
            Scope::Read => Ok(()),
            Scope::Control => Err(ApiError::new(
                StatusCode::FORBIDDEN,
                "control needs a token: name a file of tokens in server.tokens; see docs/http.md",
            )),
        };
    };
    let Some(presented) = bearer(headers)? else {
        let error = "a token is needed: send 'Authorization: Bearer TOKEN'";
        return Err(unauthorised(error, "Bearer realm=\"lfpiv\""));
    };
    match tokens.scope_of(presented) {
        Some(scope) if scope >= needed => Ok(()),
        Some(scope) => {
            let error =
                format!("the token's scope is {}, this needs {}", scope.name(), needed.name());
            let challenge = "Bearer realm=\"lfpiv\", error=\"insufficient_scope\"";
            Err(ApiError::new(StatusCode::FORBIDDEN, error)
                .header(header::WWW_AUTHENTICATE, HeaderValue::from_static(challenge)))
        }
        None => Err(unauthorised(
            "the token is not known here",
            "Bearer realm=\"lfpiv\", error=\"invalid_token\"",
        )),
    }
}

fn unauthorised(error: &str, challenge: &'static str) -> ApiError {
    ApiError::new(StatusCode::UNAUTHORIZED, error)
        .header(header::WWW_AUTHENTICATE, HeaderValue::from_static(challenge))
}

/// The token of an `Authorization` header (RFC 6750, section 2.1).
fn bearer(headers: &HeaderMap) -> Result<Option<&str>, ApiError> {
    let Some(value) = single(headers, header::AUTHORIZATION)? else { return Ok(None) };
    match value.split_once(' ') {
        Some((scheme, token)) if scheme.eq_ignore_ascii_case("bearer") => Ok(Some(token.trim())),
        _ => Err(unauthorised("only Bearer tokens are known here", "Bearer realm=\"lfpiv\"")),
    }
}
