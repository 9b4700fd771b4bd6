//! lfpiv: light field -> volume -> velocity. See ARCHITECTURE.md for the rooms.

pub mod acquisition;
pub mod archive;
pub mod benchmark;
pub mod cli;
pub mod config;
pub mod pipeline;
pub mod server;
