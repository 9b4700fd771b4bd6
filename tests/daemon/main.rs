//! The daemon on the simulated bench: acquisition, pool, store and server together, with
//! processing replaced where a test needs it to fail, to wait or to be quick.

mod acquisition;
mod bench;
mod http;
mod run;
