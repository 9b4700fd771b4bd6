//! The same work for other programs: what they are given, and what this program makes of it.
//!
//! A comparison is fair when both sides start from the same numbers. A case is simulated once and
//! written to a folder that NumPy reads without further packages; the peers in `bench/peers`
//! and the solvers here are then timed on that folder.
//!
//! - [`ReconstructionCase`]: the views of one frame as a vector b, the weights of the very model
//!   that the solver uses as a sparse matrix A ([`write_matrix`]), the photo-hull and the truth.
//! - [`CorrelationCase`]: a pair of volumes, and the true displacement of every window.
//! - [`FieldCase`]: true particles and their displacements, and places where there is none.
//! - [`Row`]: one line of the comparison.

mod correlation;
mod description;
mod error;
mod field;
mod matrix;
mod npy;
mod read;
mod reconstruction;
mod row;
#[cfg(test)]
mod tests;

pub use correlation::{CorrelationCase, Windows, time_correlation};
pub use error::PeersError;
pub use field::{Displacements, FieldCase, time_field};
pub use matrix::{MatrixSize, write_matrix};
pub use npy::{Element, NpyWriter, read_array, write_array};
pub use read::read_peers;
pub use reconstruction::{ReconstructionCase, time_reconstruction};
pub use row::Row;
