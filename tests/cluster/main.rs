//! The shots of a recorded run, or of one that goes on, measured by several processes by way of a real NATS server.

#[path = "../recorded_run/bench.rs"]
#[allow(dead_code, reason = "not every program needs all of it")]
mod bench;
mod broker;
mod by_hand;
mod dying;
#[cfg(target_arch = "x86_64")]
mod instructions;
mod killed;
mod live;
mod live_light;
mod processes;
mod proxy;
mod recorded;
mod scale;
mod together;
mod unfit;
