//! The program as started from a shell: output of its commands, and messages for bad input.

// All of this crate is test; clippy's exception covers only the functions marked as such.
#![allow(clippy::unwrap_used)]

#[path = "../support/mod.rs"]
#[allow(dead_code)]
mod support;

mod bad_input;
#[path = "../support/body.rs"]
mod body;
mod calibrate;
mod calibrate_volume;
mod calibrated_run;
mod check;
mod configuration;
mod configuration_numbers;
mod doctor;
mod malformed;
mod masks;
mod process;
mod run;
mod service;
mod simulate;
mod timing;
