//! lfpiv: light field -> volume -> velocity. See ARCHITECTURE.md for the modules.

pub mod acquisition;
pub mod archive;
pub mod cli;
pub mod cluster;
pub mod config;
pub mod pipeline;
pub mod server;

/// Version and commit of this program.
pub const CODE_VERSION: &str = env!("LFPIV_CODE_VERSION");
