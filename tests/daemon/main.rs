//! The daemon on the simulated bench: acquisition, pool, store and server together. Processing is
//! replaced where a test needs it to fail, to wait or to be quick.

// All of this crate is test; clippy's exception covers only the functions marked as such.
#![allow(clippy::unwrap_used)]

mod acquisition;
mod bench;
mod client;
mod control;
mod controlled;
mod document;
mod events;
mod faults;
mod fuzz;
mod heartbeat;
mod http;
mod limits;
mod measured;
mod page;
mod previews;
mod replayed;
mod run;
mod schema;
mod security;
mod server;
mod tls;
