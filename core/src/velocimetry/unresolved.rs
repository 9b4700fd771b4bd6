//! Whether correlation resolves the flow.
//!
//! Windows do not respond to waves shorter than themselves, and particle tracking based on the windows' field resolves
//! only slightly more. An unresolved flow has two signs. Vectors are invalid, because the displacements of the
//! particles in a window differ. And the field contains waves about as short as a window; a flow with such waves
//! usually contains shorter ones, too.

use std::fmt;

use super::{
    DisplacementField, Interrogation, VelocityField, layout::Layout, placed::NODES_PER_WINDOW,
    spline_field::FINEST_VOX, tracks::Spline,
};

/// Least share of valid vectors of a resolved flow.
const LEAST_VALID: f64 = 0.95;

/// Points along a window at which the field is compared. The third difference of four neighbouring ones is largest for
/// waves of half a window to a window.
const POINTS_PER_WINDOW: usize = 4;

/// Third difference above which the flow counts as rough, in voxels: several times the error of a vector in a smooth
/// flow.
const ROUGH_VOX: f64 = 0.05;

/// Sum of the squares of a third difference's weights, 1, 3, 3 and 1.
const SQUARED_WEIGHTS: f64 = 20.0;

/// Largest rough share of the volume of a resolved flow. The flow of `bench` is rough nowhere, a ring
/// vortex or a thin shear layer in a twentieth, turbulence with waves from one window on in about half of the volume
/// (docs/decisions.md).
const MOST_ROUGH: f64 = 0.1;

/// Why correlation does not resolve a flow.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Unresolved {
    /// Only this share of the vectors is valid.
    FewValid(f64),
    /// The flow is rough in this share of the volume.
    Rough(f64),
}

impl fmt::Display for Unresolved {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::FewValid(share) => {
                write!(f, "only {:.1} % of the vectors are valid", 100.0 * share)
            }
            Self::Rough(share) => {
                write!(f, "the flow is rough in {:.1} % of the volume", 100.0 * share)
            }
        }
    }
}

impl Interrogation {
    /// Why the vectors of `field`, with the field `everywhere` behind them, do not resolve the flow; `None` where they
    /// do. `None` as well where a field through placed particles could not show more, because its nodes would be as
    /// far apart as the windows, and where particles were not followed: a field between windows is rough itself.
    pub fn unresolved(
        &self,
        field: &VelocityField,
        everywhere: &DisplacementField,
    ) -> Option<Unresolved> {
        let DisplacementField::Particles(everywhere) = everywhere else { return None };
        let [_, window_vox] = self.windows_vox();
        if (window_vox as f32) < NODES_PER_WINDOW * FINEST_VOX {
            return None;
        }
        let valid = field.valid_share();
        if valid < LEAST_VALID {
            return Some(Unresolved::FewValid(valid));
        }
        let rough = self.rough_share(everywhere);
        (rough > MOST_ROUGH).then_some(Unresolved::Rough(rough))
    }

    /// Share of all third differences along x, y, z between points in the volume that are those of a rough flow.
    fn rough_share(&self, field: &Spline) -> f64 {
        let [_, window] = self.windows_vox();
        let step = (window / POINTS_PER_WINDOW).max(1);
        let [from, to] = self.volume_vox();
        let nodes = std::array::from_fn(|axis| (to[axis] - from[axis]) / step);
        let points = Layout { nodes };
        let at = |n: usize| -> [f64; 3] {
            let place = points.place(n);
            let at_vox = std::array::from_fn(|axis| (from[axis] + step * place[axis]) as f32);
            field.of(&field.taps(at_vox))
        };
        let values: Vec<[f64; 3]> = (0..points.len()).map(at).collect();
        let (mut rough, mut all) = (0, 0);
        for c in 0..3 {
            let component: Vec<f64> = values.iter().map(|value| value[c]).collect();
            for axis in 0..3 {
                let differences = points.third_differences(axis, &component);
                for n in (0..points.len()).filter(|&n| points.starts(axis, n)) {
                    let square = differences[n] * differences[n] / SQUARED_WEIGHTS;
                    rough += usize::from(square > ROUGH_VOX * ROUGH_VOX);
                    all += 1;
                }
            }
        }
        rough as f64 / all.max(1) as f64
    }
}

#[cfg(test)]
mod tests {
    use std::f32::consts::TAU;

    use super::*;
    use crate::{
        model::VolumeGrid,
        velocimetry::{
            VectorStatus, VelocimetrySettings,
            judge::{Vector, field_of},
            lattice::Lattice,
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

    /// Transverse waves along all axes.
    fn waves(length_vox: f32, amplitude_vox: f32) -> DisplacementField {
        const STEP_VOX: f32 = 2.0;
        let edge = (EDGE_VOX + 8) / STEP_VOX as usize;
        let value = |n: usize| {
            let wave =
                |node: usize| amplitude_vox * (TAU * STEP_VOX * node as f32 / length_vox).sin();
            [wave(n / (edge * edge)), wave(n % edge), wave(n / edge % edge)]
        };
        let values = (0..edge.pow(3)).map(value).collect();
        let lattice = Lattice { nodes: [edge; 3], first_vox: [0.0; 3], step_vox: STEP_VOX, values };
        DisplacementField::Particles(Spline::through(&lattice, None))
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
    fn a_flow_with_waves_of_a_window_is_not_resolved() {
        let found = interrogation().unresolved(&vectors(100), &waves(16.0, 1.0));
        // Each component changes along one axis of three.
        assert!(
            matches!(found, Some(Unresolved::Rough(share)) if share > 0.3 && share < 0.34),
            "{found:?}"
        );
    }

    #[test]
    fn long_and_faint_waves_are() {
        for (length_vox, amplitude_vox) in [(100.0, 2.0), (16.0, 0.05)] {
            let field = waves(length_vox, amplitude_vox);
            assert_eq!(interrogation().unresolved(&vectors(97), &field), None);
        }
    }

    #[test]
    fn vectors_that_are_not_valid_do_not_resolve_a_flow() {
        let found = interrogation().unresolved(&vectors(80), &waves(100.0, 2.0));
        assert!(
            matches!(found, Some(Unresolved::FewValid(share)) if (share - 0.8).abs() < 0.05),
            "{found:?}"
        );
    }
}
