//! The camera driver against fake GigE Vision cameras, over real GVCP and GVSP on the loopback.
#![cfg(feature = "aravis")]
#![allow(clippy::unwrap_used)]

#[path = "gige/bench.rs"]
mod bench;
#[path = "gige/faults.rs"]
mod faults;
#[path = "gige/free_run.rs"]
mod free_run;
#[path = "gige/network.rs"]
mod network;
#[path = "gige/streaming.rs"]
mod streaming;
#[path = "gige/throughput.rs"]
mod throughput;
