//! Line and column of a key in a TOML document.

use std::{fmt, ops::Range};

use toml::{
    Spanned, Value,
    de::{DeTable, DeValue},
};

/// One step from a table or array to a value inside it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Step {
    /// To a key of a table.
    Key(String),
    /// To an element of an array.
    Index(usize),
}

/// The path from the document's root to a value, such as `camera[1].right`.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct KeyPath(pub Vec<Step>);

impl KeyPath {
    /// Parses a path as garde prints it.
    pub fn parse(text: &str) -> Self {
        let steps = text.split(['.', '[']).filter(|part| !part.is_empty()).map(|part| {
            let index = part.strip_suffix(']').and_then(|digits| digits.parse().ok());
            index.map_or_else(|| Step::Key(part.to_owned()), Step::Index)
        });
        Self(steps.collect())
    }

    /// The path as the document writes it. garde counts the field of an enum's variant as element
    /// 0; in the file the variant's keys are in the enum's own table.
    pub fn in_document(&self, document: &Value) -> Self {
        let mut at = Some(document);
        let mut steps = Vec::with_capacity(self.0.len());
        for step in &self.0 {
            at = match (at, step) {
                (Some(Value::Table(_)), Step::Index(_)) => continue,
                (Some(Value::Table(table)), Step::Key(key)) => table.get(key),
                (Some(Value::Array(array)), Step::Index(index)) => array.get(*index),
                _ => None,
            };
            steps.push(step.clone());
        }
        Self(steps)
    }

    /// This path extended by one step.
    pub fn then(&self, step: Step) -> Self {
        Self(self.0.iter().cloned().chain([step]).collect())
    }

    /// Whether `other` is this value or lies inside it.
    pub fn contains(&self, other: &Self) -> bool {
        other.0.starts_with(&self.0)
    }
}

impl fmt::Display for KeyPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (position, step) in self.0.iter().enumerate() {
            match step {
                Step::Key(key) if position == 0 => write!(f, "{key}")?,
                Step::Key(key) => write!(f, ".{key}")?,
                Step::Index(index) => write!(f, "[{index}]")?,
            }
        }
        Ok(())
    }
}

/// A value in the document and its location.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Entry {
    /// The value's path.
    pub path: KeyPath,
    /// Byte range of its key, or of the array element.
    pub key: Range<usize>,
    /// Byte range of its value.
    pub value: Range<usize>,
    /// Whether the value is NaN or infinite.
    pub not_finite: bool,
}

/// All keys and array elements of a document, parents before children.
pub(super) fn entries(document: &DeTable<'_>) -> Vec<Entry> {
    let mut found = Vec::new();
    collect_table(document, &KeyPath::default(), &mut found);
    found
}

fn collect_table(table: &DeTable<'_>, path: &KeyPath, found: &mut Vec<Entry>) {
    for (key, value) in table.iter() {
        let path = path.then(Step::Key(key.get_ref().to_string()));
        collect_value(value, path, key.span(), found);
    }
}

fn collect_value(
    value: &Spanned<DeValue<'_>>,
    path: KeyPath,
    key: Range<usize>,
    found: &mut Vec<Entry>,
) {
    let not_finite = match value.get_ref() {
        DeValue::Float(float) => {
            float.as_str().parse().is_ok_and(|number: f64| !number.is_finite())
        }
        _ => false,
    };
    found.push(Entry { path: path.clone(), key, value: value.span(), not_finite });
    match value.get_ref() {
        DeValue::Array(array) => {
            for (index, element) in array.iter().enumerate() {
                collect_value(element, path.then(Step::Index(index)), element.span(), found);
            }
        }
        DeValue::Table(table) => collect_table(table, &path, found),
        _ => {}
    }
}

/// Line and column of a byte, both counted from 1; columns count characters.
pub(super) fn line_and_column(text: &str, byte: usize) -> (usize, usize) {
    let before = text.get(..byte).unwrap_or(text);
    let line_start = before.rfind('\n').map_or(0, |newline| newline + 1);
    (before.matches('\n').count() + 1, before[line_start..].chars().count() + 1)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    #[test]
    fn paths_read_back_as_printed() {
        let path = KeyPath(vec![
            Step::Key("camera".into()),
            Step::Index(1),
            Step::Key("right".into()),
            Step::Index(0),
        ]);
        assert_eq!(path.to_string(), "camera[1].right[0]");
        assert_eq!(KeyPath::parse("camera[1].right[0]"), path);
        assert!(KeyPath::parse("camera[1]").contains(&path));
        assert!(!KeyPath::parse("camera[0]").contains(&path));
    }

    #[test]
    fn every_value_is_found_where_it_is_written() {
        let text = "[a]\nb = [1, -inf]\n[[c]]\nd = 'x'\n";
        let document = DeTable::parse(text).unwrap();
        let found = entries(document.get_ref());
        let text_of = |path: &str| {
            let entry = found.iter().find(|e| e.path == KeyPath::parse(path)).unwrap();
            (&text[entry.value.clone()], entry.not_finite)
        };
        assert_eq!(text_of("a.b"), ("[1, -inf]", false));
        assert_eq!(text_of("a.b[1]"), ("-inf", true));
        assert_eq!(text_of("c[0].d"), ("'x'", false));
    }

    proptest! {
        #[test]
        fn line_and_column_find_the_byte_again(text in "[a-zé\n]{0,60}", at in 0_usize..120) {
            let at = (0..=at.min(text.len())).rev().find(|b| text.is_char_boundary(*b)).unwrap();
            let (line, column) = line_and_column(&text, at);
            let start: usize = text.split_inclusive('\n').take(line - 1).map(str::len).sum();
            let within: usize = text[start..].chars().take(column - 1).map(char::len_utf8).sum();
            prop_assert_eq!(start + within, at);
        }
    }
}
