//! Vectors of a measured field at the requested positions.

use super::{
    VectorStatus, flow_geometry::FlowGeometry, judge::Vector, lattice::Lattice, layout::Layout,
    peak::Peak, tracks::Refined,
};

/// What was measured.
pub struct Report<'a> {
    /// The likeliest field behind the windows' vectors.
    pub windows: &'a Lattice,
    /// The vectors of the last pass.
    pub vectors: &'a [Vector],
    /// Their correlation peaks.
    pub peaks: &'a [Option<Peak>],
    /// The field fitted to tracked particles, if there is one.
    pub refined: Option<&'a Refined>,
    /// The flow, where the volume has a mask.
    pub flow: Option<&'a FlowGeometry>,
    /// Largest displacement component to expect, in voxels.
    pub max_displacement_vox: f64,
}

impl Report<'_> {
    /// The vector at a position, and the peak ratio of the nearest window. Its status is that of the nearest
    /// window's vector, or valid where particles measure it. Positions outside the flow are masked.
    pub fn at(&self, at_vox: [f32; 3]) -> (Vector, f32) {
        let without = |status| (Vector::without_value(status, self.max_displacement_vox), 0.0);
        if self.flow.is_some_and(|flow| !flow.is_flow(at_vox)) {
            return without(VectorStatus::Masked);
        }
        let Some(n) = self.nearest_window(at_vox) else { return without(VectorStatus::Invalid) };
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

    /// The nearest window in the same flow as a position: the nearest of all if the line to its centre is clear,
    /// otherwise the nearest of the surrounding eight with a clear line.
    fn nearest_window(&self, at_vox: [f32; 3]) -> Option<usize> {
        let windows = self.windows;
        let nearest = windows.nearest_node(at_vox);
        let Some(flow) = self.flow else { return Some(nearest) };
        let layout = Layout { nodes: windows.nodes };
        let centre = |n: usize| -> [f32; 3] {
            let node = layout.place(n);
            std::array::from_fn(|axis| {
                windows.first_vox[axis] + windows.step_vox * node[axis] as f32
            })
        };
        if flow.is_clear(centre(nearest), at_vox) {
            return Some(nearest);
        }
        let low = windows.coordinates(at_vox).map(|t| t.floor().max(0.0) as usize);
        let square = |n: usize| -> f32 {
            centre(n).iter().zip(at_vox).map(|(centre, at)| (centre - at).powi(2)).sum()
        };
        let about = (0..8).map(|corner| -> [usize; 3] {
            std::array::from_fn(|axis| {
                (low[axis] + (corner >> axis & 1)).min(windows.nodes[axis] - 1)
            })
        });
        about
            .map(|node| layout.number(node))
            .filter(|&n| flow.is_clear(centre(n), at_vox))
            .min_by(|&a, &b| square(a).total_cmp(&square(b)))
    }
}

/// The vector of the field fitted to particles near window `n`, whose vector is `nearest`. Invalid vectors are
/// unchanged.
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
