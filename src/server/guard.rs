//! Checks of every request before its handler, in this order: rate of the client, host and origin,
//! size of the body, deadline, and the token's scope.

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
    connection_slots::SlotHandle,
    protection::{Origin, Scope, contains_token},
};

/// Requests that make the bench safe are exempt from the rate limit.
const NEVER_LIMITED: [&str; 2] = ["/api/v1/control/stop", "/api/v1/control/disarm"];

/// Adds headers against content sniffing, framing, referrers, cross-origin use and caching.
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

/// Limits the rate of requests per client, except those that make the bench safe.
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

/// Accepts only this server's names as host and its own pages as origin, and refuses URLs with
/// tokens.
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
        let error =
            format!("'{foreign}' is not a name of this server: list its names in server.hosts");
        return Err(ApiError::new(StatusCode::MISDIRECTED_REQUEST, error));
    }
    if let Some(origin) = single(request.headers(), header::ORIGIN)?
        && hosts.origin(origin, host) == Origin::Foreign
    {
        let error = "requests from pages of other servers are refused";
        return Err(ApiError::new(StatusCode::FORBIDDEN, error));
    }
    if contains_token(request.uri(), app.protection.tokens.as_ref()) {
        return Err(ApiError::bad_request(
            "the URL contains a token, and logs and histories store URLs: send it as \
             'Authorization: Bearer TOKEN', and replace this one",
        ));
    }
    Ok(next.run(request).await)
}

/// The value of a header that may occur once and must be ASCII.
fn single(headers: &HeaderMap, name: header::HeaderName) -> Result<Option<&str>, ApiError> {
    let mut values = headers.get_all(&name).iter();
    match (values.next(), values.next()) {
        (None, _) => Ok(None),
        (Some(value), None) => value
            .to_str()
            .map(Some)
            .map_err(|_| ApiError::bad_request(format!("the header {name} is not in ASCII"))),
        (Some(_), Some(_)) => {
            Err(ApiError::bad_request(format!("the header {name} occurs more than once")))
        }
    }
}

/// Refuses a body that is too large by its `Content-Length` before it is read. The router's limit
/// cuts off bodies that turn out to be larger.
pub(super) async fn size(request: Request, next: Next) -> Result<Response, ApiError> {
    let length = single(request.headers(), header::CONTENT_LENGTH)?;
    let length = length.and_then(|length| length.parse::<u64>().ok()).unwrap_or_default();
    if length > BODY_BYTES as u64 {
        let error = format!("the body has {length} bytes; allowed: at most {BODY_BYTES}");
        return Err(ApiError::new(StatusCode::PAYLOAD_TOO_LARGE, error));
    }
    Ok(next.run(request).await)
}

/// Deadline of a request without a body: a delay is then caused by this machine, not by the client.
const BODYLESS_DEADLINE: Duration = Duration::from_secs(60);

/// Ends requests after a deadline, for instance when the client sends its body too slowly.
pub(super) async fn deadline(
    State(app): State<App>,
    request: Request,
    next: Next,
) -> Result<Response, ApiError> {
    let patience = match request.body().is_end_stream() {
        true => app.protection.patience.max(BODYLESS_DEADLINE),
        false => app.protection.patience,
    };
    tokio::time::timeout(patience, next.run(request)).await.map_err(|_| {
        let error = format!("the request was not complete after {} s", patience.as_secs_f64());
        ApiError::new(StatusCode::REQUEST_TIMEOUT, error)
    })
}

/// Reading: needs a token if tokens are configured; otherwise every loopback client may read.
pub(super) async fn may_read(
    State(app): State<App>,
    request: Request,
    next: Next,
) -> Result<Response, Response> {
    admit(&app, Scope::Read, request.headers()).map_err(IntoResponse::into_response)?;
    take_slot(&app, &request).map_err(IntoResponse::into_response)?;
    Ok(next.run(request).await)
}

/// Control: always needs a token with this scope. Otherwise a page in the operator's browser could
/// fire the laser.
pub(super) async fn may_control(
    State(app): State<App>,
    request: Request,
    next: Next,
) -> Result<Response, Response> {
    admit(&app, Scope::Control, request.headers()).map_err(IntoResponse::into_response)?;
    if !makes_safe(&request) {
        take_slot(&app, &request).map_err(IntoResponse::into_response)?;
        return Ok(next.run(request).await);
    }
    if let Some(slot) = request.extensions().get::<SlotHandle>() {
        slot.make_safe();
    }
    let mut response = next.run(request).await;
    // The connection's slot is for the next client.
    response.headers_mut().insert(header::CONNECTION, HeaderValue::from_static("close"));
    Ok(response)
}

fn makes_safe(request: &Request) -> bool {
    request.method() == Method::POST && NEVER_LIMITED.contains(&request.uri().path())
}

/// Gives the connection of an accepted request a slot for admitted clients.
fn take_slot(app: &App, request: &Request) -> Result<(), ApiError> {
    if request.extensions().get::<SlotHandle>().is_none_or(SlotHandle::admit) {
        return Ok(());
    }
    let key = if app.protection.tokens.is_some() { "connections" } else { "guests" };
    let error = format!("too many connections, from this address or in total; see server.{key}");
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
            "the token is not known",
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
        _ => Err(unauthorised("only Bearer tokens are accepted", "Bearer realm=\"lfpiv\"")),
    }
}
