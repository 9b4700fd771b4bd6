//! Replies to commands that set something.

use std::fmt;

/// `ok` or an error code.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Reply {
    /// `ok`: accepted.
    Done,
    /// `?n`.
    Refused(Refusal),
}

/// The unit's error codes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Refusal(pub u8);

impl Reply {
    /// Parses a line; `None` unless it is `ok` or `?1` to `?9`.
    pub fn parse(line: &str) -> Option<Self> {
        if line.eq_ignore_ascii_case("ok") {
            return Some(Self::Done);
        }
        match line.strip_prefix('?')?.as_bytes() {
            [digit @ b'1'..=b'9'] => Some(Self::Refused(Refusal(digit - b'0'))),
            _ => None,
        }
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let meaning = match self.0 {
            1 => "incorrect prefix: no colon or asterisk at the start",
            2 => "missing command keyword",
            3 => "invalid command keyword",
            4 => "missing parameter",
            5 => "invalid parameter",
            6 => "query only: a question mark is needed",
            7 => "invalid query: the command has no query form",
            8 => "command unavailable in the present state of the unit",
            9 => "value out of bounds",
            _ => "a code that the manual does not list",
        };
        write!(formatter, "?{} ({meaning})", self.0)
    }
}
