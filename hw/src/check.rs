//! Validation rules that `garde` does not provide.

/// Refuses NaN and infinities. A `range` rule alone lets NaN through, since NaN is neither below
/// the minimum nor above the maximum.
pub fn finite(value: &f64, _: &()) -> garde::Result {
    if value.is_finite() { Ok(()) } else { Err(garde::Error::new("allowed: a finite number")) }
}
