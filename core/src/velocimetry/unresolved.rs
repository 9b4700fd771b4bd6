//! Whether vectors by correlation leave the flow open.
//!
//! Windows do not show waves that are shorter than they are, and single particles that are followed near the
//! windows' field show hardly more. What is missing leaves two traces: vectors that are not valid, because
//! particles do not agree on one displacement, and a field that still changes much from one quarter of a window
//! to the next, for a flow with waves as short as the windows resolve has shorter ones as well.

use std::fmt;

use super::{
    DisplacementField, Interrogation, VectorStatus, VelocityField, placed::NODES_PER_WINDOW,
    spline_field::FINEST_VOX, tracks::Spline,
};

/// At least this share of the vectors is valid where correlation measures the flow.
const LEAST_VALID: f64 = 0.95;

/// Points along a window at which the field is compared. The third difference of four neighbouring ones is largest
/// for waves of a half to one window.
const POINTS_PER_WINDOW: usize = 4;

/// Root mean square of such waves, from which on the flow is rough, in voxels: some times a vector's error.
const ROUGH_VOX: f64 = 0.05;

/// Sum of the squares of a third difference's weights, 1, 3, 3 and 1.
const SQUARED_WEIGHTS: f64 = 20.0;

/// A flow is left open if it is rough in more than this share of the volume. Of the flow of `bench` none is, of a
/// ring vortex and of a jet's thin shear layer a twentieth, of turbulence with waves from one window on a third to
/// a half (docs/decisions.md).
const MOST_ROUGH: f64 = 0.1;

/// Why vectors by correlation leave a flow open.
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
            Self::FewValid(share) => write!(f, "{:.1} % of the vectors are valid", 100.0 * share),
            Self::Rough(share) => {
                write!(f, "the flow is rough in {:.1} % of the volume", 100.0 * share)
            }
        }
    }
}

impl Interrogation {
    /// Whether the vectors of `field`, and the field `everywhere` behind them, leave the flow open. Windows alone do
    /// not tell: between their vectors a field is too rough itself. Windows as small as the finest nodes of a field
    /// through placed particles leave nothing open.
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
        let count = |status| field.status.iter().filter(|&&own| own == status).count();
        let in_flow = field.status.len() - count(VectorStatus::Masked);
        let valid = count(VectorStatus::Valid) as f64 / in_flow.max(1) as f64;
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
        let points: [usize; 3] = std::array::from_fn(|axis| (to[axis] - from[axis]) / step);
        let at = |place: [usize; 3]| -> [f64; 3] {
            let at_vox = std::array::from_fn(|axis| (from[axis] + step * place[axis]) as f32);
            field.of(&field.taps(at_vox))
        };
        let [nx, ny, nz] = points;
        let places = (0..nx * ny * nz).map(|n| [n % nx, n / nx % ny, n / (nx * ny)]);
        let values: Vec<[f64; 3]> = places.clone().map(at).collect();
        let squares = |n: usize, stride: usize| -> [f64; 3] {
            let [a, b, c, d] = [0, 1, 2, 3].map(|k| values[n + k * stride]);
            let difference = |along: usize| d[along] - a[along] - 3.0 * (c[along] - b[along]);
            std::array::from_fn(|along| difference(along).powi(2) / SQUARED_WEIGHTS)
        };
        let (mut rough, mut all) = (0, 0);
        for (n, place) in places.enumerate() {
            for (axis, stride) in [1, nx, nx * ny].into_iter().enumerate() {
                if place[axis] + 3 < points[axis] {
                    let found = squares(n, stride);
                    rough += found.iter().filter(|&&s| s > ROUGH_VOX * ROUGH_VOX).count();
                    all += found.len();
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
            VelocimetrySettings,
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
    fn waves_of_a_window_leave_a_flow_open() {
        let found = interrogation().unresolved(&vectors(100), &waves(16.0, 1.0));
        // Each component changes along one axis of three.
        assert!(
            matches!(found, Some(Unresolved::Rough(share)) if share > 0.3 && share < 0.34),
            "{found:?}"
        );
    }

    #[test]
    fn long_or_faint_waves_do_not() {
        for (length_vox, amplitude_vox) in [(100.0, 2.0), (16.0, 0.05)] {
            let field = waves(length_vox, amplitude_vox);
            assert_eq!(interrogation().unresolved(&vectors(97), &field), None);
        }
    }

    #[test]
    fn vectors_that_are_not_valid_leave_a_flow_open() {
        let found = interrogation().unresolved(&vectors(80), &waves(100.0, 2.0));
        assert!(
            matches!(found, Some(Unresolved::FewValid(share)) if (share - 0.8).abs() < 0.05),
            "{found:?}"
        );
    }
}
