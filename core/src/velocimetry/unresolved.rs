//! Whether correlation resolves the flow.
//!
//! Windows do not respond to waves shorter than themselves, and particle tracking based on the windows' field resolves
//! only slightly more. An unresolved flow has four signs. Vectors are invalid, because the displacements of the
//! particles in a window differ. Vectors are uncertain, because particles are few, or long between cameras whose axes are
//! few degrees apart. And neighbouring particles deviate from the windows' field in the same direction, or from the field
//! that follows them (`tracks::missed`).

use std::fmt;

use super::{
    DisplacementField, Interrogation, VectorStatus, VelocityField, placed::NODES_PER_WINDOW,
    spline_field::FINEST_VOX, tracks::Missed,
};
use crate::statistics::median;

/// Least share of valid vectors of a resolved flow.
const LEAST_VALID: f64 = 0.95;

/// Largest median standard uncertainty of the vectors of a resolved flow, in voxels: that between cameras 25 degrees
/// apart. Through placed particles it is a tenth (docs/decisions.md).
const MOST_UNCERTAIN_VOX: f64 = 0.025;

/// Largest standard deviation of what the windows miss of a resolved flow, in voxels: about half the error of a particle
/// in the volumes, and several times that of a vector in a smooth flow (docs/decisions.md).
const MOST_MISSED_BY_WINDOWS_VOX: f64 = 0.05;

/// Largest standard deviation of what the field through followed particles misses of a resolved flow, in voxels: about
/// the error of a vector in a smooth flow (docs/decisions.md).
const MOST_MISSED_BY_TRACKING_VOX: f64 = 0.006;

/// Why correlation does not resolve a flow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Unresolved {
    /// Only this share of the vectors is valid.
    FewValid(f64),
    /// This is the median standard uncertainty of the valid vectors, in voxels, of the component where it is largest.
    Uncertain(f64),
    /// The windows' field misses this standard deviation of the displacement, in voxels.
    MissedByWindows(f64),
    /// So does the field through followed particles.
    MissedByTracking(f64),
}

impl fmt::Display for Unresolved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::FewValid(share) => {
                write!(f, "only {:.1} % of the vectors are valid", 100.0 * share)
            }
            Self::Uncertain(vox) => {
                write!(f, "vectors are uncertain by {vox:.2} voxel (median)")
            }
            Self::MissedByWindows(vox) => {
                write!(f, "windows miss a displacement of {vox:.2} voxel (standard deviation)")
            }
            Self::MissedByTracking(vox) => {
                write!(
                    f,
                    "particle tracking misses a displacement of {vox:.3} voxel (standard deviation)"
                )
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
        let DisplacementField::Particles { missed, .. } = *everywhere else { return None };
        let [_, window_vox] = self.windows_vox();
        if (window_vox as f32) < NODES_PER_WINDOW * FINEST_VOX {
            return None;
        }
        let valid = field.valid_share();
        if valid < LEAST_VALID {
            return Some(Unresolved::FewValid(valid));
        }
        let uncertain_vox = median_uncertainty_vox(field);
        if uncertain_vox > MOST_UNCERTAIN_VOX {
            return Some(Unresolved::Uncertain(uncertain_vox));
        }
        let Missed { by_windows_vox, by_tracking_vox } = missed;
        if by_windows_vox > MOST_MISSED_BY_WINDOWS_VOX {
            return Some(Unresolved::MissedByWindows(by_windows_vox));
        }
        (by_tracking_vox > MOST_MISSED_BY_TRACKING_VOX)
            .then_some(Unresolved::MissedByTracking(by_tracking_vox))
    }
}

/// Median standard uncertainty of the valid vectors of `field`, in voxels, of the component where it is largest; 0 without
/// valid vectors.
fn median_uncertainty_vox(field: &VelocityField) -> f64 {
    let valid = || {
        let vectors = field.status.iter().zip(&field.uncertainty_vox);
        vectors.filter(|(status, _)| **status == VectorStatus::Valid)
    };
    let of = |component: usize| median(valid().map(|(_, vox)| f64::from(vox[component])));
    (0..3).filter_map(of).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        model::VolumeGrid,
        velocimetry::{
            VelocimetrySettings,
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

    /// A field at rest where windows and tracking miss so much.
    fn missed(by_windows_vox: f64, by_tracking_vox: f64) -> DisplacementField {
        let values = vec![[0.0; 3]; 8 * 8 * 8];
        let lattice = Lattice { nodes: [8; 3], first_vox: [0.0; 3], step_vox: 8.0, values };
        let spline = Spline::through(&lattice, None);
        DisplacementField::Particles { spline, missed: Missed { by_windows_vox, by_tracking_vox } }
    }

    /// Vectors of which so many in a hundred are valid.
    fn vectors(valid: usize) -> VelocityField {
        uncertain_vectors(valid, 0.01)
    }

    /// The same with this standard uncertainty along z.
    fn uncertain_vectors(valid: usize, uncertainty_vox: f32) -> VelocityField {
        let grid = interrogation().vector_grid();
        let vector = |n: usize| Vector {
            displacement_vox: [0.0; 3],
            uncertainty_vox: [0.01, 0.01, uncertainty_vox],
            status: if n % 100 < valid { VectorStatus::Valid } else { VectorStatus::Invalid },
        };
        let vectors: Vec<Vector> = (0..grid.len()).map(vector).collect();
        let ratios = vec![2.0; grid.len()];
        field_of(grid, &volume(), 1e-4, (&vectors, &ratios), None)
    }

    #[test]
    fn a_flow_of_which_windows_miss_much_is_not_resolved() {
        let found = interrogation().unresolved(&vectors(100), &missed(0.3, 0.0));
        assert_eq!(found, Some(Unresolved::MissedByWindows(0.3)));
        let found = interrogation().unresolved(&vectors(100), &missed(0.02, 0.01));
        assert_eq!(found, Some(Unresolved::MissedByTracking(0.01)));
        assert_eq!(interrogation().unresolved(&vectors(97), &missed(0.02, 0.005)), None);
    }

    #[test]
    fn uncertain_vectors_do_not_resolve_a_flow() {
        let found = interrogation().unresolved(&uncertain_vectors(100, 0.04), &missed(0.0, 0.0));
        assert_eq!(found, Some(Unresolved::Uncertain(f64::from(0.04_f32))));
    }

    #[test]
    fn vectors_that_are_not_valid_do_not_resolve_a_flow() {
        let found = interrogation().unresolved(&vectors(80), &missed(0.0, 0.0));
        assert!(
            matches!(found, Some(Unresolved::FewValid(share)) if (share - 0.8).abs() < 0.05),
            "{found:?}"
        );
    }

    #[test]
    fn small_windows_resolve_what_particles_do() {
        let settings = VelocimetrySettings { window_mm: 0.4, ..VelocimetrySettings::default() };
        let small = Interrogation::new(&volume(), 4, &settings);
        assert_eq!(small.unresolved(&vectors(80), &missed(0.3, 0.0)), None);
    }
}
