//! Bearer tokens and their scopes.
//!
//! Only digests are stored, and each check compares all of them in constant time. Neither memory
//! nor timing reveals a token, its length or its position in the file.

use std::{io, os::unix::fs::MetadataExt, path::Path};

use lfpiv_rawlog::regular_file::{open_regular, text_of};
use ring::digest::{SHA256, SHA256_OUTPUT_LEN, digest};
use rustix::process::geteuid;
use subtle::{ConditionallySelectable, ConstantTimeEq};

use super::{ProtectionError, strength::estimated_bits};

/// Smallest length of a hexadecimal token: 128 bits.
const FEWEST_HEX: usize = 32;
/// Smallest length of other tokens: 128 bits in base 64.
const FEWEST_BASE64: usize = 22;
/// Smallest number of different characters. Random tokens of the smallest length have more.
const FEWEST_DIFFERENT: usize = 8;
/// Smallest estimated entropy: 128 bits less what may look like a pattern by chance. One in a
/// hundred random 128-bit tokens falls below it.
pub(super) const LEAST_BITS: f64 = 85.0;

/// What a token allows. Control includes reading.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::server) enum Scope {
    Read = 1,
    Control = 2,
}

impl Scope {
    pub fn name(self) -> &'static str {
        match self {
            Self::Read => "read",
            Self::Control => "control",
        }
    }
}

type Digest = [u8; SHA256_OUTPUT_LEN];

/// The tokens of a file.
pub(in crate::server) struct Tokens {
    entries: Vec<(Scope, Digest)>,
}

impl Tokens {
    /// Reads a token file, which other users must not be able to read.
    pub fn load(path: &Path) -> Result<Self, ProtectionError> {
        let text = read_secret("tokens", "server.tokens", path, 0o077)?;
        Self::parse(path, &text)
    }

    /// Parses one token per line; empty lines and lines starting with `#` are skipped.
    pub(super) fn parse(path: &Path, text: &str) -> Result<Self, ProtectionError> {
        let mut entries = Vec::new();
        for (number, line) in text.lines().enumerate() {
            let line = line.trim();
            if line.is_empty() || line.starts_with('#') {
                continue;
            }
            let entry = entry(line).map_err(|problem| ProtectionError::Token {
                path: path.to_owned(),
                line: number + 1,
                problem,
            })?;
            entries.push(entry);
        }
        match entries.is_empty() {
            true => Err(ProtectionError::NoTokens { path: path.to_owned() }),
            false => Ok(Self { entries }),
        }
    }

    /// The scope of a token; `None` if it is unknown.
    pub fn scope_of(&self, presented: &str) -> Option<Scope> {
        let presented = hash(presented);
        let mut found = 0u8;
        for (scope, expected) in &self.entries {
            found.conditional_assign(&(*scope as u8).max(found), presented.ct_eq(expected));
        }
        [Scope::Read, Scope::Control].into_iter().find(|scope| *scope as u8 == found)
    }
}

fn hash(token: &str) -> Digest {
    let mut bytes = Digest::default();
    bytes.copy_from_slice(digest(&SHA256, token.as_bytes()).as_ref());
    bytes
}

fn entry(line: &str) -> Result<(Scope, Digest), &'static str> {
    let mut words = line.split_whitespace();
    let scope = match words.next() {
        Some("read") => Scope::Read,
        Some("control") => Scope::Control,
        _ => return Err("it starts neither with 'read' nor with 'control'"),
    };
    let (Some(token), None) = (words.next(), words.next()) else {
        return Err("the scope must be followed by exactly one token");
    };
    strong(token)?;
    Ok((scope, hash(token)))
}

/// Checks that a token may have 128 random bits.
fn strong(token: &str) -> Result<(), &'static str> {
    // RFC 6750, section 2.1.
    let allowed = |byte: u8| byte.is_ascii_alphanumeric() || b"-._~+/=".contains(&byte);
    if !token.bytes().all(allowed) {
        return Err("the token has characters other than letters, digits and -._~+/=");
    }
    let hexadecimal = token.bytes().all(|byte| byte.is_ascii_hexdigit());
    let fewest = if hexadecimal { FEWEST_HEX } else { FEWEST_BASE64 };
    let mut different: Vec<u8> = token.bytes().collect();
    different.sort_unstable();
    different.dedup();
    if token.len() < fewest
        || different.len() < FEWEST_DIFFERENT
        || estimated_bits(token) < LEAST_BITS
    {
        return Err("the token can be guessed: use at least 128 random bits");
    }
    Ok(())
}

/// Whether a word looks like a token. No other data in requests does.
pub(super) fn is_strong(word: &str) -> bool {
    strong(word).is_ok()
}

/// Reads a file, unless its mode has one of the `forbidden` bits. If `forbidden` is not 0, the file
/// is a secret and must belong to this user or root.
pub(super) fn read_secret(
    what: &'static str,
    key: &'static str,
    path: &Path,
    forbidden: u32,
) -> Result<String, ProtectionError> {
    read_secret_as(geteuid().as_raw(), what, key, path, forbidden)
}

fn read_secret_as(
    user: u32,
    what: &'static str,
    key: &'static str,
    path: &Path,
    forbidden: u32,
) -> Result<String, ProtectionError> {
    let unreadable = |reason: io::Error| {
        let path = path.to_owned();
        ProtectionError::Unreadable { what, key, path, reason }
    };
    // Check and read through the same handle.
    let file = open_regular(path).map_err(unreadable)?;
    let metadata = file.metadata().map_err(unreadable)?;
    let owner = metadata.uid();
    if forbidden != 0 && owner != user && owner != 0 {
        return Err(ProtectionError::NotOurs { what, path: path.to_owned(), owner, user });
    }
    let mode = metadata.mode() & 0o777;
    if mode & forbidden != 0 {
        return Err(ProtectionError::TooOpen { what, path: path.to_owned(), mode });
    }
    text_of(file).map_err(unreadable)
}

#[cfg(test)]
mod tests {
    use std::os::unix::fs::PermissionsExt;

    use super::*;

    const READ: &str = "5e0bd17c94a2f86331c7be905d48f2a6";
    const CONTROL: &str = "Zr8+qT1/vXo2Lk9wBe5HdM==";

    fn parse(text: &str) -> Result<Tokens, String> {
        Tokens::parse(Path::new("tokens"), text).map_err(|error| error.to_string())
    }

    #[test]
    fn only_the_exact_token_has_its_scope() {
        let tokens = parse(&format!("# lab\nread {READ}\n\n  control {CONTROL}\n")).unwrap();
        assert_eq!(tokens.scope_of(READ), Some(Scope::Read));
        assert_eq!(tokens.scope_of(CONTROL), Some(Scope::Control));
        for wrong in ["", &READ[1..], &READ.to_uppercase(), &format!("{READ} "), "read"] {
            assert_eq!(tokens.scope_of(wrong), None, "{wrong}");
        }
        assert!(Scope::Read < Scope::Control);
    }

    #[test]
    fn a_token_given_twice_has_the_wider_scope() {
        for order in [["read", "control"], ["control", "read"]] {
            let tokens = parse(&order.map(|scope| format!("{scope} {READ}")).join("\n")).unwrap();
            assert_eq!(tokens.scope_of(READ), Some(Scope::Control));
        }
    }

    #[test]
    fn an_invalid_token_is_refused_with_its_line() {
        let refusal = |text: &str| parse(text).err().unwrap();
        assert!(refusal("\nadmin abc").contains("line 2: it starts neither"));
        assert!(refusal("read").contains("exactly one token"));
        assert!(refusal(&format!("read {READ} {READ}")).contains("exactly one token"));
        let words = "correct-horse-battery-staple-lab";
        let sequence = "0123456789abcdef0123456789abcdef";
        let weak = [&READ[..31], &CONTROL[..21], &"ab".repeat(40), "password-of-the-lab"];
        for weak in weak.into_iter().chain([words, sequence]) {
            assert!(refusal(&format!("read {weak}")).contains("can be guessed"), "{weak}");
        }
        assert!(refusal(&format!("read {READ}ä")).contains("characters"));
        assert!(refusal("# none").contains("contains no token"));
        assert!(refusal("").contains("openssl rand -hex 32"));
    }

    #[test]
    fn a_file_that_others_can_read_is_refused_with_the_remedy() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("tokens");
        std::fs::write(&path, format!("read {READ}")).unwrap();
        for (mode, accepted) in
            [(0o600, true), (0o400, true), (0o640, false), (0o604, false), (0o620, false)]
        {
            std::fs::set_permissions(&path, PermissionsExt::from_mode(mode)).unwrap();
            match Tokens::load(&path) {
                Ok(_) => assert!(accepted, "{mode:o}"),
                Err(error) => {
                    let error = error.to_string();
                    assert!(!accepted && error.contains("chmod 600"), "{mode:o}: {error}");
                }
            }
        }
        let absent = Tokens::load(&folder.path().join("absent")).err().unwrap().to_string();
        assert!(absent.contains("absent cannot be read") && absent.contains("server.tokens"));
    }

    #[test]
    fn a_file_of_another_user_is_refused_with_the_remedy() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("tokens");
        std::fs::write(&path, format!("read {READ}")).unwrap();
        std::fs::set_permissions(&path, PermissionsExt::from_mode(0o600)).unwrap();
        let owner = std::fs::metadata(&path).unwrap().uid();
        let read_as = |user| read_secret_as(user, "tokens", "server.tokens", &path, 0o077);
        assert!(read_as(owner).is_ok());
        let others = read_as(owner + 1);
        // Root can read and change the file anyway.
        assert_eq!(others.is_ok(), owner == 0);
        if owner == 0 {
            std::os::unix::fs::chown(&path, Some(4242), None).unwrap();
        }
        let user = owner + 1;
        let refused = read_as(user).err().unwrap().to_string();
        assert!(refused.contains(&format!("chown {user}")), "{refused}");
        assert!(read_secret_as(user, "certificate", "", &path, 0).is_ok(), "not a secret");
    }

    #[test]
    fn a_pipe_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("tokens");
        let made = std::process::Command::new("mkfifo").arg("-m").arg("600").arg(&path).status();
        assert!(made.unwrap().success());
        let refused = Tokens::load(&path).err().unwrap().to_string();
        assert!(refused.contains("not a regular file"), "{refused}");
    }
}
