//! Benches of shipped configurations, and errors against the truth.

mod bench;
#[allow(dead_code, reason = "the tests of other crates use the rest")]
mod errors;

pub use bench::Bench;
pub use errors::{Deviation, errors_vox, mean_error_vox, true_particles};
