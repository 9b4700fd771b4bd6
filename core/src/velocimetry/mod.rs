//! From a pair of volumes to a velocity field.

mod b_spline;
mod cloud;
mod conjugate_gradients;
mod correlation;
mod derived;
mod differences;
mod displacement;
mod field;
mod fill;
mod floor;
mod flow_geometry;
mod flow_nodes;
mod judge;
mod kernel;
mod lags;
mod lattice;
mod multipass;
mod nodes;
mod peak;
mod placed;
mod raster;
mod report;
mod result;
mod settings;
mod smoothing;
mod spline_field;
#[cfg(test)]
mod test_data;
mod tracks;
mod uncertainty;
mod validate;
mod volumes;
mod windows;

pub use cloud::PointCloud;
pub use derived::{Gradients, curl_and_divergence};
pub use displacement::DisplacementField;
pub use field::{VectorGrid, VectorStatus, VelocityField};
pub use floor::correlation_error_vox;
pub use flow_geometry::InFlow;
pub use multipass::Interrogation;
pub use placed::CorrectedField;
pub use result::{MeasuredParticle, PairResult, StageSeconds};
pub use settings::VelocimetrySettings;
pub use spline_field::Sample;
pub use tracks::{Particle, particles};
pub use volumes::VolumeInterrogation;
