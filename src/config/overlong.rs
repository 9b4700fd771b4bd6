//! Finds arrays in a document that are longer than the setting they belong to, such as four numbers
//! for a point. The deserializer ignores the additional elements.

use toml::Value;

use super::location::{KeyPath, Step};

/// Paths of the arrays that are longer in `document` than in `read`, and the number of elements
/// read. `read` is the parsed document, serialized again.
pub(super) fn overlong_arrays(document: &Value, read: &Value) -> Vec<(KeyPath, usize)> {
    let mut found = Vec::new();
    compare(document, read, &KeyPath::default(), &mut found);
    found
}

fn compare(document: &Value, read: &Value, path: &KeyPath, found: &mut Vec<(KeyPath, usize)>) {
    match (document, read) {
        (Value::Table(document), Value::Table(read)) => {
            for (key, value) in document {
                if let Some(read) = read.get(key) {
                    compare(value, read, &path.then(Step::Key(key.clone())), found);
                }
            }
        }
        (Value::Array(document), Value::Array(read)) => {
            if document.len() > read.len() {
                found.push((path.clone(), read.len()));
            }
            for (index, (value, read)) in document.iter().zip(read).enumerate() {
                compare(value, read, &path.then(Step::Index(index)), found);
            }
        }
        _ => {}
    }
}
