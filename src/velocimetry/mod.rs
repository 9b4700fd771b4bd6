//! From a pair of volumes to a velocity field.

mod cloud;
mod derived;
mod field;
mod judge;
mod lattice;
mod multipass;
mod peak;
mod result;
mod settings;
mod spectrum;
mod uncertainty;
mod validate;
mod window;

pub use cloud::PointCloud;
pub use field::{VectorGrid, VectorStatus, VelocityField};
pub use multipass::Interrogation;
pub use result::{PairResult, StageSeconds};
pub use settings::VelocimetrySettings;
