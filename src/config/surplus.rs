//! Arrays in a document that are longer than what takes them, such as four numbers for a place in
//! space: the deserializer reads as many elements as it needs and passes over the others.

use toml::Value;

use super::location::{KeyPath, Step};

/// The arrays of `document` that are longer than in `read`, which is the same document written again
/// by what read it; and how many elements were read.
pub(super) fn longer_than_read(document: &Value, read: &Value) -> Vec<(KeyPath, usize)> {
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
