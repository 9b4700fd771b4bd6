//! Errors that keep a server from starting.

use std::{io, net::SocketAddr, path::PathBuf};

use thiserror::Error;

/// Instruction for making a token.
pub(super) const MAKE_A_TOKEN: &str = "make one with: openssl rand -hex 32";

/// Why a server cannot start; each message says what to do.
#[derive(Debug, Error)]
pub enum ProtectionError {
    /// Reading would be open to the network.
    #[error(
        "server.address = {address} can be reached from the network, but there are no tokens: \
         name a file of tokens in server.tokens, or listen on 127.0.0.1"
    )]
    Exposed { address: SocketAddr },
    /// A file is missing or cannot be read.
    #[error("{what} {} cannot be read: {reason}; correct {key}", path.display())]
    Unreadable { what: &'static str, key: &'static str, path: PathBuf, reason: io::Error },
    /// A secret that other users can read.
    #[error(
        "{what} {} can be read by others (mode {mode:03o}): run: chmod 600 {}",
        path.display(), path.display()
    )]
    TooOpen { what: &'static str, path: PathBuf, mode: u32 },
    /// A secret file of another user.
    #[error(
        "{what} {} belongs to user {owner}, who can read and change it: run: chown {user} {}",
        path.display(), path.display()
    )]
    NotOurs { what: &'static str, path: PathBuf, owner: u32, user: u32 },
    /// A line that is not a valid token entry.
    #[error(
        "tokens {}, line {line}: {problem}; a line is 'read TOKEN' or 'control TOKEN', \
         {MAKE_A_TOKEN}",
        path.display()
    )]
    Token { path: PathBuf, line: usize, problem: &'static str },
    /// A token file without tokens.
    #[error(
        "tokens {} contains no token: add a line 'read TOKEN' or 'control TOKEN', {MAKE_A_TOKEN}",
        path.display()
    )]
    NoTokens { path: PathBuf },
    /// A file without a usable certificate or key.
    #[error("{what} {} cannot be used: {reason}; correct {key}", path.display())]
    Pem { what: &'static str, key: &'static str, path: PathBuf, reason: String },
    /// A certificate that does not match its key.
    #[error("[server.tls]: certificate and key cannot be used: {0}")]
    Tls(#[from] rustls::Error),
}
