//! Extractors for request data, with JSON errors.

use axum::{
    Json,
    extract::{FromRequest, FromRequestParts, Path, Query, Request},
    http::{StatusCode, request::Parts},
};
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};

use super::ApiError;

/// Parameters of the path.
pub(super) struct Params<T>(pub T);

impl<S: Send + Sync, T: DeserializeOwned + Send> FromRequestParts<S> for Params<T> {
    type Rejection = ApiError;

    async fn from_request_parts(parts: &mut Parts, state: &S) -> Result<Self, ApiError> {
        let Path(params) = Path::from_request_parts(parts, state).await?;
        Ok(Self(params))
    }
}

/// Parameters of the query.
pub(super) struct Arguments<T>(pub T);

impl<S: Send + Sync, T: DeserializeOwned> FromRequestParts<S> for Arguments<T> {
    type Rejection = ApiError;

    async fn from_request_parts(parts: &mut Parts, state: &S) -> Result<Self, ApiError> {
        let Query(arguments) = Query::from_request_parts(parts, state).await?;
        Ok(Self(arguments))
    }
}

/// A JSON object as body. Only objects are accepted: otherwise `[50.0]` would be read as the first
/// field of a type.
pub(super) struct Body<T>(pub T);

impl<S: Send + Sync, T: DeserializeOwned> FromRequest<S> for Body<T> {
    type Rejection = ApiError;

    async fn from_request(request: Request, state: &S) -> Result<Self, ApiError> {
        let Json(object) = Json::<Map<String, Value>>::from_request(request, state).await?;
        T::deserialize(Value::Object(object)).map(Self).map_err(|error| {
            ApiError::new(StatusCode::UNPROCESSABLE_ENTITY, format!("the body: {error}"))
        })
    }
}

/// A shot number from a path.
pub(super) fn shot_number(text: &str) -> Result<u64, ApiError> {
    text.parse().map_err(|_| {
        ApiError::bad_request(format!("'{text}' is not a shot number: give an integer from 0"))
    })
}

/// Frame a (0) or b (1) from a path.
pub(super) fn frame_index(text: &str) -> Result<usize, ApiError> {
    match text {
        "a" => Ok(0),
        "b" => Ok(1),
        _ => Err(ApiError::bad_request(format!("'{text}' is not a frame: give a or b"))),
    }
}
