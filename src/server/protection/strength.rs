//! Estimates how hard a token is to guess from its characters.
//!
//! Random characters cannot be proved random, but patterns of humans and careless programs can be
//! detected: words, repetitions, sequences of the alphabet, and text encoded in hexadecimal or base
//! 64. Such parts count few bits, all other characters the logarithm of their alphabet's size.
//! Random tokens lose some bits by chance, mostly less than a third.

/// Bits of a repeated part or an alphabetic sequence: they describe its start and length.
const PIECE_BITS: f64 = 8.0;
/// Smallest length of such a part.
const PIECE: usize = 3;
/// Smallest length of a word.
const WORD: usize = 4;
/// Bits per letter of a word; English has 0.6 to 1.3 (Shannon 1951), other words more.
const LETTER_BITS: f64 = 2.0;
/// Smallest length of an encoded text.
const TEXT: usize = 12;

/// The estimated entropy of a token in bits.
pub(super) fn estimated_bits(token: &str) -> f64 {
    let token = token.trim_end_matches('=').as_bytes();
    let texts = [from_hexadecimal(token), from_base_64(token)];
    let texts = texts.into_iter().flatten().filter(|text| {
        text.len() >= TEXT && text.iter().all(|byte| byte.is_ascii_graphic() || *byte == b' ')
    });
    texts.map(|text| bits_of(&text)).fold(bits_of(token), f64::min)
}

fn bits_of(text: &[u8]) -> f64 {
    let character_bits = alphabet(text).log2();
    let in_word = words(text);
    let (mut bits, mut at) = (0.0, 0);
    while at < text.len() {
        let piece = repeated(text, at).max(run(&text[at..]));
        if piece >= PIECE {
            bits += PIECE_BITS;
            at += piece;
        } else {
            bits += if in_word[at] { LETTER_BITS } else { character_bits };
            at += 1;
        }
    }
    bits
}

/// Size of the alphabet, inferred from the kinds of characters used.
fn alphabet(text: &[u8]) -> f64 {
    if text.iter().all(u8::is_ascii_hexdigit) {
        return 16.0;
    }
    type Kind = (fn(&u8) -> bool, f64);
    let kinds: [Kind; 3] = [
        (u8::is_ascii_lowercase, 26.0),
        (u8::is_ascii_uppercase, 26.0),
        (u8::is_ascii_digit, 10.0),
    ];
    let letters: f64 =
        kinds.iter().filter(|(is_kind, _)| text.iter().any(is_kind)).map(|(_, count)| count).sum();
    letters + if text.iter().any(|byte| !byte.is_ascii_alphanumeric()) { 2.0 } else { 0.0 }
}

/// Whether each character belongs to a word: consecutive letters of one case that include a vowel.
fn words(text: &[u8]) -> Vec<bool> {
    let case = |byte: u8| (byte.is_ascii_lowercase(), byte.is_ascii_uppercase());
    let runs = text.chunk_by(|a, b| case(*a) == case(*b));
    let is_word = |run: &[u8]| {
        let has_vowel = run.iter().any(|byte| b"aeiouyAEIOUY".contains(byte));
        run.len() >= WORD && run[0].is_ascii_alphabetic() && has_vowel
    };
    runs.flat_map(|run| std::iter::repeat_n(is_word(run), run.len())).collect()
}

/// Number of characters from `at` on that repeat an earlier part.
fn repeated(text: &[u8], at: usize) -> usize {
    let same = |from: usize| {
        let pairs = text[from..].iter().zip(&text[at..]);
        pairs.take_while(|(before, now)| before.eq_ignore_ascii_case(now)).count()
    };
    (0..at).map(same).max().unwrap_or(0)
}

/// Number of characters that are equal, ascending or descending by one.
fn run(text: &[u8]) -> usize {
    let steps: Vec<i16> =
        text.windows(2).map(|pair| i16::from(pair[1]) - i16::from(pair[0])).collect();
    match steps.first() {
        Some(first) if first.abs() <= 1 => {
            1 + steps.iter().take_while(|step| *step == first).count()
        }
        _ => 1,
    }
}

fn from_hexadecimal(token: &[u8]) -> Option<Vec<u8>> {
    let digit = |byte: &u8| char::from(*byte).to_digit(16).map(|digit| digit as u8);
    let digits: Vec<u8> = token.iter().map(digit).collect::<Option<_>>()?;
    Some(digits.chunks_exact(2).map(|pair| pair[0] << 4 | pair[1]).collect())
}

/// Decodes either alphabet (RFC 4648, sections 4 and 5), without padding.
fn from_base_64(token: &[u8]) -> Option<Vec<u8>> {
    let value = |byte: &u8| {
        Some(match byte {
            b'A'..=b'Z' => byte - b'A',
            b'a'..=b'z' => byte - b'a' + 26,
            b'0'..=b'9' => byte - b'0' + 52,
            b'+' | b'-' => 62,
            b'/' | b'_' => 63,
            _ => return None,
        })
    };
    let values: Vec<u8> = token.iter().map(value).collect::<Option<_>>()?;
    let bytes = values.chunks(4).flat_map(|four| {
        let bits = four.iter().fold(0_u32, |bits, value| bits << 6 | u32::from(*value));
        let bits = bits << (6 * (4 - four.len()));
        let bytes = bits.to_be_bytes();
        bytes[1..].iter().copied().take(four.len() - 1).collect::<Vec<_>>()
    });
    Some(bytes.collect())
}

#[cfg(test)]
mod tests {
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    use super::*;
    use crate::server::protection::tokens::LEAST_BITS;

    const BASE_64: &[u8] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

    /// Number of refused tokens among `of` random ones.
    fn refused(alphabet: &[u8], length: usize, of: usize) -> usize {
        let mut random = Pcg64Mcg::seed_from_u64(5);
        let mut token = || -> String {
            (0..length)
                .map(|_| char::from(alphabet[random.random_range(0..alphabet.len())]))
                .collect()
        };
        (0..of).filter(|_| estimated_bits(&token()) < LEAST_BITS).count()
    }

    #[test]
    fn random_tokens_are_accepted() {
        // As the documentation recommends: 32 random bytes.
        assert_eq!(refused(b"0123456789abcdef", 64, 5000), 0);
        assert_eq!(refused(BASE_64, 43, 5000), 0);
        // The shortest tokens allowed: 16 random bytes.
        let shortest = [refused(b"0123456789abcdef", 32, 5000), refused(BASE_64, 22, 5000)];
        println!("{shortest:?} of 5000 random tokens of 16 bytes are refused");
        assert!(shortest.iter().all(|refused| *refused < 75), "{shortest:?}");
    }

    #[test]
    fn tokens_with_patterns_are_refused() {
        for token in [
            "0123456789abcdef0123456789abcdef",
            "0000000000000000ffffffffffffffff",
            "deadbeefdeadbeefdeadbeefdeadbeef",
            "abcdefghijklmnopqrstuvwxyz",
            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789",
            "qwertyuiopasdfghjklzxcvbnm",
            "correct-horse-battery-staple-lab",
            "PasswordPasswordPassword2026",
            "bGFzZXItbGFzZXItbGFzZXI0Mg==",
            "Y29ycmVjdC1ob3JzZS1iYXR0ZXJ5LXN0YXBsZQ==",
            "636f72726563742d686f7273652d62617474657279",
            "20261122202611222026112220261122",
        ] {
            let bits = estimated_bits(token);
            assert!(bits < LEAST_BITS, "{token}: {bits}");
        }
    }

    #[test]
    fn base_64_is_decoded() {
        assert_eq!(from_base_64(b"bGFzZXI0Mg").unwrap(), b"laser42");
        assert_eq!(from_base_64(b"_-8").unwrap(), [0xff, 0xef]);
        assert_eq!(from_base_64(b"a b"), None);
        assert_eq!(from_hexadecimal(b"6c6173").unwrap(), b"las");
    }
}
