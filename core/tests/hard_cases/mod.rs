//! Hard cases: what the instrument does where light, geometry or motion leave its range. Every case
//! says in words and numbers what is expected of it, from physics and not from what the program
//! happens to give. Two rules hold for all of them:
//!
//! - Errors degrade smoothly: a case twice as hard is not ten times as wrong.
//! - A vector that cannot be trusted is not marked valid. A valid vector that is wrong by more than
//!   [`bench::WRONG_VOX`] is a false one, and these are counted in every case.
//!
//! Figures are printed: `cargo test --package lfpiv-core --test capabilities hard_cases -- --nocapture`.

mod bench;
mod coverage;
mod geometry;
mod light;
mod motion;
mod precision;
mod seeding;
mod solver;
