//! lfpiv: light field -> volume -> velocity. See ARCHITECTURE.md for the rooms.

pub mod acquisition;
pub mod archive;
pub mod benchmark;
pub mod cli;
pub mod config;
pub mod lightfield;
pub mod model;
pub mod pipeline;
pub mod reconstruction;
pub mod server;
pub mod velocimetry;

#[cfg(test)]
mod test_bench;
