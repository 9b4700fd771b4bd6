//! Whether correlation resolves the flow.
//!
//! Windows do not respond to waves shorter than themselves, and particle tracking based on the windows' field resolves
//! only slightly more. An unresolved flow has two signs. Vectors are invalid, because the displacements of the
//! particles in a window differ. And neighbouring particles deviate from the windows' field in the same direction
//! (`tracks::missed`).

use std::fmt;

use super::{
    DisplacementField, Interrogation, VelocityField, placed::NODES_PER_WINDOW,
    spline_field::FINEST_VOX,
};

/// Least share of valid vectors of a resolved flow.
const LEAST_VALID: f64 = 0.95;

/// Largest standard deviation of what the windows miss of a resolved flow, in voxels: about half the error of a particle
/// in the volumes, and several times that of a vector in a smooth flow (docs/decisions.md).
const MOST_MISSED_VOX: f64 = 0.05;

/// Why correlation does not resolve a flow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Unresolved {
    /// Only this share of the vectors is valid.
    FewValid(f64),
    /// The windows' field misses this standard deviation of the displacement, in voxels.
    Missed(f64),
}

impl fmt::Display for Unresolved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::FewValid(share) => {
                write!(f, "only {:.1} % of the vectors are valid", 100.0 * share)
            }
            Self::Missed(vox) => {
                write!(f, "windows miss a displacement of {vox:.2} voxel (standard deviation)")
            }
        }
    }
}

impl Interrogation {
    /// Why the vectors of `field`, with the field `everywhere` behind them, do not resolve the flow; `None` where they
    /// do. `None` as well where a field through placed particles could not show more, because its nodes would be as
    /// far apart as the windows, and where particles were not followed.
    pub fn unresolved(
        &self,
        field: &VelocityField,
        everywhere: &DisplacementField,
    ) -> Option<Unresolved> {
        let DisplacementField::Particles { missed_by_windows_vox: missed_vox, .. } = *everywhere
        else {
            return None;
        };
        let [_, window_vox] = self.windows_vox();
        if (window_vox as f32) < NODES_PER_WINDOW * FINEST_VOX {
            return None;
        }
        let valid = field.valid_share();
        if valid < LEAST_VALID {
            return Some(Unresolved::FewValid(valid));
        }
        (missed_vox > MOST_MISSED_VOX).then_some(Unresolved::Missed(missed_vox))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        model::VolumeGrid,
        velocimetry::{
            VectorStatus, VelocimetrySettings,
            judge::{Vector, field_of},
            lattice::Lattice,
            tracks::Spline,
        },
    };

    /// Edge of the volume, whose windows have 16 voxels, in voxels.
    const EDGE_VOX: usize = 60;

    fn volume() -> VolumeGrid {
        VolumeGrid { voxels: [EDGE_VOX; 3], voxel_mm: 0.1, centre_mm: [0.0; 3] }
    }

    fn interrogation() -> Interrogation {
        Interrogation::new(&volume(), 4, &VelocimetrySettings::default())
    }

    /// A field at rest of which windows miss so much.
    fn missed(missed_by_windows_vox: f64) -> DisplacementField {
        let values = vec![[0.0; 3]; 8 * 8 * 8];
        let lattice = Lattice { nodes: [8; 3], first_vox: [0.0; 3], step_vox: 8.0, values };
        let spline = Spline::through(&lattice, None);
        DisplacementField::Particles { spline, missed_by_windows_vox }
    }

    /// Vectors of which so many in a hundred are valid.
    fn vectors(valid: usize) -> VelocityField {
        let grid = interrogation().vector_grid();
        let vector = |n: usize| Vector {
            displacement_vox: [0.0; 3],
            uncertainty_vox: [0.01; 3],
            status: if n % 100 < valid { VectorStatus::Valid } else { VectorStatus::Invalid },
        };
        let vectors: Vec<Vector> = (0..grid.len()).map(vector).collect();
        let ratios = vec![2.0; grid.len()];
        field_of(grid, &volume(), 1e-4, (&vectors, &ratios), None)
    }

    #[test]
    fn a_flow_of_which_windows_miss_much_is_not_resolved() {
        let found = interrogation().unresolved(&vectors(100), &missed(0.3));
        assert_eq!(found, Some(Unresolved::Missed(0.3)));
        assert_eq!(interrogation().unresolved(&vectors(97), &missed(0.02)), None);
    }

    #[test]
    fn vectors_that_are_not_valid_do_not_resolve_a_flow() {
        let found = interrogation().unresolved(&vectors(80), &missed(0.0));
        assert!(
            matches!(found, Some(Unresolved::FewValid(share)) if (share - 0.8).abs() < 0.05),
            "{found:?}"
        );
    }

    #[test]
    fn small_windows_resolve_what_particles_do() {
        let settings = VelocimetrySettings { window_mm: 0.4, ..VelocimetrySettings::default() };
        let small = Interrogation::new(&volume(), 4, &settings);
        assert_eq!(small.unresolved(&vectors(80), &missed(0.3)), None);
    }
}
