//! Finds the allowed range of a key by probing the validation rules.
//!
//! A garde report names only the bound that was crossed. Instead of stating every range a second
//! time, this module sets the key to extreme values and validates again.

use garde::Validate;
use serde::Deserialize;
use toml::{Table, Value};

use super::{
    Config,
    location::{KeyPath, Step},
};

const LOWER: &str = "lower than ";
const GREATER: &str = "greater than ";

/// Whether a garde message reports a crossed bound.
pub(super) fn is_bound(message: &str) -> bool {
    message.starts_with(LOWER) || message.starts_with(GREATER)
}

/// `allowed 0.001 to 10`, `allowed 1 or more`, or the key's own rule. `None` if the key has no
/// numeric bounds or the rest of the document cannot be parsed.
pub(super) fn allowed_range(document: &Table, path: &KeyPath) -> Option<String> {
    let ask = |candidates: &[Value], prefix: &str| {
        candidates.iter().map(|candidate| probe(document, path, candidate, prefix)).find_map(
            |verdict| match verdict {
                Verdict::Unreadable => None,
                Verdict::Bound(bound) => Some(Ok(bound)),
                Verdict::Rule(rule) => Some(Err(rule)),
                Verdict::Accepted => Some(Ok(String::new())),
                // The next wider type could not be parsed: the type's limit is the bound.
                Verdict::AcceptedAtTypeLimit(limit) => Some(Ok(limit)),
            },
        )
    };
    let lowest = ask(&[f64::MIN.into(), i64::MIN.into(), 0.into()], LOWER)?;
    let highest = ask(
        &[f64::MAX.into(), i64::MAX.into(), i64::from(u32::MAX).into(), 65_535.into(), 255.into()],
        GREATER,
    )?;
    match (lowest, highest) {
        (Err(rule), _) | (_, Err(rule)) => Some(rule),
        (Ok(lowest), Ok(highest)) => match (lowest.is_empty(), highest.is_empty()) {
            (false, false) => Some(format!("allowed {lowest} to {highest}")),
            (false, true) => Some(format!("allowed {lowest} or more")),
            (true, false) => Some(format!("allowed up to {highest}")),
            (true, true) => None,
        },
    }
}

/// Result of validating one candidate value.
enum Verdict {
    /// The value has the wrong type for the key, or the document is wrong elsewhere.
    Unreadable,
    /// Allowed, and no larger value of the type is tried.
    Accepted,
    /// Allowed, and the largest value of the key's type.
    AcceptedAtTypeLimit(String),
    /// Refused because of this bound.
    Bound(String),
    /// Refused by a rule that is not a range.
    Rule(String),
}

fn probe(document: &Table, path: &KeyPath, candidate: &Value, prefix: &str) -> Verdict {
    let mut document = Value::Table(document.clone());
    match value_at(&mut document, path) {
        Some(value) => *value = candidate.clone(),
        None => return Verdict::Unreadable,
    }
    let Ok(config) = Config::deserialize(document.clone()) else {
        return Verdict::Unreadable;
    };
    let report = config.validate().err();
    let messages: Vec<&str> = report
        .iter()
        .flat_map(|report| report.iter())
        .filter(|(at, _)| KeyPath::parse(&at.to_string()).in_document(&document) == *path)
        .map(|(_, error)| error.message())
        .collect();
    let bound = messages.iter().find_map(|message| message.strip_prefix(prefix));
    match (bound, messages.first(), candidate) {
        (Some(bound), _, _) => Verdict::Bound(bound.to_owned()),
        (None, Some(rule), _) => Verdict::Rule((*rule).to_owned()),
        (None, None, Value::Integer(i64::MIN | i64::MAX) | Value::Float(_)) => Verdict::Accepted,
        (None, None, limit) => Verdict::AcceptedAtTypeLimit(limit.to_string()),
    }
}

/// The value at a path; a missing last key is inserted.
fn value_at<'v>(root: &'v mut Value, path: &KeyPath) -> Option<&'v mut Value> {
    path.0.iter().try_fold(root, |value, step| match (value, step) {
        (Value::Table(table), Step::Key(key)) => {
            Some(table.entry(key.as_str()).or_insert(Value::Boolean(false)))
        }
        (Value::Array(array), Step::Index(index)) => array.get_mut(*index),
        _ => None,
    })
}
