//! What becomes of a measured field: vectors at the places that are asked for.

use super::{VectorStatus, judge::Vector, lattice::Lattice, peak::Peak, tracks::Refined};

/// What was measured.
pub struct Report<'a> {
    /// The likeliest field behind the windows' vectors.
    pub windows: &'a Lattice,
    /// The vectors of the last pass.
    pub vectors: &'a [Vector],
    /// Their correlation peaks.
    pub peaks: &'a [Option<Peak>],
    /// The field through particles, where they were followed.
    pub refined: Option<&'a Refined>,
}

impl Report<'_> {
    /// The vector at a place, and the height of the nearest window's peak over the next highest. It is worth
    /// what the nearest window's vector is, or is valid where particles measure it.
    pub fn at(&self, at_vox: [f32; 3]) -> (Vector, f32) {
        let n = self.windows.nearest_node(at_vox);
        let ratio = self.peaks[n].map_or(0.0, |peak| peak.ratio);
        let nearest = self.vectors[n];
        let by_windows = || match nearest.status {
            VectorStatus::Invalid => nearest,
            _ => Vector { displacement_vox: self.windows.at(at_vox), ..nearest },
        };
        let vector = self
            .refined
            .map_or_else(by_windows, |refined| of_particles(refined, n, nearest, at_vox));
        (vector, ratio)
    }
}

/// The vector of the field through particles, about window `n`, whose own vector is `nearest`. What is invalid
/// stays so.
fn of_particles(refined: &Refined, n: usize, nearest: Vector, at_vox: [f32; 3]) -> Vector {
    if nearest.status == VectorStatus::Invalid {
        return nearest;
    }
    let status = if refined.by_particles[n] { VectorStatus::Valid } else { nearest.status };
    let spline = &refined.spline;
    let displacement_vox = spline.of(&spline.taps(at_vox)).map(|v| v as f32);
    let about = refined.nodes.nearest_node(at_vox);
    let uncertainty_vox = match (status, refined.uncertainty_vox[about]) {
        (VectorStatus::Valid, Some(uncertainty_vox)) => uncertainty_vox,
        _ => nearest.uncertainty_vox,
    };
    Vector { displacement_vox, uncertainty_vox, status }
}
