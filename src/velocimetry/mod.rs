//! From a pair of volumes to a velocity field.

mod field;
mod settings;

pub use field::{VectorGrid, VectorStatus, VelocityField};
pub use settings::VelocimetrySettings;
