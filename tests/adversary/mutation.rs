//! Seeded damage to bytes and text.

use rand::{RngExt, seq::IndexedRandom};
use rand_pcg::Pcg64Mcg;

/// A kind of damage.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Damage {
    /// One bit is flipped.
    Flip,
    /// The end is missing.
    Truncate,
    /// The file is deleted.
    Delete,
    /// A part is duplicated.
    Duplicate,
    /// A part is overwritten with random bytes.
    Overwrite,
}

impl Damage {
    /// A random kind; half of them are flips.
    pub fn any(random: &mut Pcg64Mcg) -> Self {
        match random.random_range(0..10) {
            0..5 => Self::Flip,
            5..7 => Self::Truncate,
            7 => Self::Delete,
            8 => Self::Duplicate,
            _ => Self::Overwrite,
        }
    }

    /// The damaged content; `None` if the file is deleted.
    pub fn of(self, mut bytes: Vec<u8>, random: &mut Pcg64Mcg) -> Option<Vec<u8>> {
        if bytes.is_empty() {
            return (self != Self::Delete).then_some(bytes);
        }
        match self {
            Self::Flip => {
                let at = random.random_range(0..bytes.len());
                bytes[at] ^= 1 << random.random_range(0..8);
            }
            Self::Truncate => bytes.truncate(random.random_range(0..bytes.len())),
            Self::Delete => return None,
            Self::Duplicate => {
                let part = part(bytes.len(), random);
                let copy = bytes[part.clone()].to_vec();
                bytes.splice(part.end..part.end, copy);
            }
            Self::Overwrite => {
                let part = part(bytes.len(), random);
                random.fill(&mut bytes[part]);
            }
        }
        Some(bytes)
    }
}

/// A random range, with uniformly distributed magnitude of its length.
fn part(length: usize, random: &mut Pcg64Mcg) -> std::ops::Range<usize> {
    let at = random.random_range(0..length);
    let longest = (length - at).ilog2();
    let size = 1_usize << random.random_range(0..=longest);
    at..at + size
}

/// Replacements of numbers in a text.
const NUMBERS: [&str; 16] = [
    "0",
    "-1",
    "1",
    "3",
    "0.5",
    "1e308",
    "1e-308",
    "nan",
    "inf",
    "65536",
    "4294967295",
    "9223372036854775807",
    "18446744073709551616",
    "[]",
    "\"\"",
    "{}",
];

/// A text with one to three changes: a number, a line, some bytes.
pub fn spoiled(text: &str, random: &mut Pcg64Mcg) -> Vec<u8> {
    let mut bytes = text.as_bytes().to_vec();
    for _ in 0..random.random_range(1..4) {
        bytes = match random.random_range(0..4) {
            0 | 1 => with_another_number(&bytes, random),
            2 => with_another_line(&bytes, random),
            _ => Damage::any(random).of(bytes, random).unwrap_or_default(),
        };
    }
    bytes
}

fn with_another_number(bytes: &[u8], random: &mut Pcg64Mcg) -> Vec<u8> {
    let of_number = |byte: &u8| byte.is_ascii_digit() || b".-".contains(byte);
    let starts: Vec<usize> = (1..bytes.len())
        .filter(|at| bytes[*at].is_ascii_digit() && !of_number(&bytes[at - 1]))
        .collect();
    let Some(start) = starts.choose(random).copied() else { return bytes.to_vec() };
    let end = bytes[start..].iter().position(|byte| !of_number(byte));
    let end = end.map_or(bytes.len(), |length| start + length);
    let number = NUMBERS[random.random_range(0..NUMBERS.len())].as_bytes();
    [&bytes[..start], number, &bytes[end..]].concat()
}

/// Deletes, duplicates or moves a line.
fn with_another_line(bytes: &[u8], random: &mut Pcg64Mcg) -> Vec<u8> {
    let mut lines: Vec<&[u8]> = bytes.split_inclusive(|byte| *byte == b'\n').collect();
    if lines.is_empty() {
        return Vec::new();
    }
    let line = lines[random.random_range(0..lines.len())];
    match random.random_range(0..3) {
        0 => lines.retain(|other| *other != line),
        1 => lines.insert(random.random_range(0..=lines.len()), line),
        _ => {
            lines.retain(|other| *other != line);
            lines.insert(random.random_range(0..=lines.len()), line);
        }
    }
    lines.concat()
}
