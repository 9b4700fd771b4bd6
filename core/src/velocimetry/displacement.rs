//! The displacement anywhere in the volume, to its faces and a little beyond.

use super::{
    lattice::Lattice,
    tracks::{Missed, Spline},
};

/// The field behind the vectors: that of the windows, whose lattice reaches to the volume's faces, or the one
/// through particles.
#[derive(Debug, Clone, PartialEq)]
pub enum DisplacementField {
    /// Between the windows' vectors by cubic convolution, beyond them linearly.
    Windows(Lattice),
    /// As a spline; beyond its nodes as on them.
    Particles {
        /// The field.
        spline: Spline,
        /// What fields by correlation miss of the flow.
        missed: Missed,
    },
}

impl DisplacementField {
    /// The displacement of the particle that is at `at_vox` in the middle of the pair; both in voxels of
    /// [`super::Interrogation::cloud_grid`].
    pub fn at(&self, at_vox: [f32; 3]) -> [f32; 3] {
        match self {
            Self::Windows(lattice) => lattice.at(at_vox),
            Self::Particles { spline, .. } => spline.of(&spline.taps(at_vox)).map(|vox| vox as f32),
        }
    }
}
