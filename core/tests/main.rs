//! What the numerics give, measured against ray-traced benches and explicit matrices: one program, so
//! that what they share is linked once.

// All of this crate is test; clippy's exception covers only the functions marked as such.
#![allow(clippy::unwrap_used)]

mod accuracy;
mod forecast;
mod forward_model;
mod hard_cases;
mod masked;
mod model_fit;
mod model_parts;
mod placed_particles;
mod point_image;
mod reconstruction_paper;
mod support;
#[path = "../src/test_bench.rs"]
mod test_bench;
