//! Flow region of an interrogation: the mask of the volume on the windows, on the nodes of the splines and at the
//! requested positions of vectors.

use std::sync::Arc;

use super::{
    VectorGrid, cloud::PointCloud, flow_nodes::FlowNodes, kernel::box_sums, lattice::Lattice,
    layout::Layout, peak::Peak, windows::Windows,
};
use crate::model::{VolumeGrid, VolumeMask};

/// Effect of a mask on an interrogation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct InFlow {
    /// Vectors in the flow.
    pub vectors: usize,
    /// Windows in the flow next to a body that is thinner than a window: they may include the flow on the other
    /// side.
    pub around_bodies: usize,
}

/// The flow in the volume of an interrogation.
#[derive(Debug, Clone)]
pub struct FlowGeometry {
    mask: Arc<VolumeMask>,
    /// The grid in whose voxels light is given.
    grid: VolumeGrid,
    /// The final windows' centres.
    pub windows: FlowNodes,
    /// Nodes on them and half as far apart.
    pub finer: FlowNodes,
    /// The coefficients of splines on the windows' nodes and on nodes half as far apart.
    pub splines: [FlowNodes; 2],
    /// Requested positions of vectors.
    pub vectors: FlowNodes,
    /// Share of the cells of each window of the search that are flow.
    pub search_shares: Vec<f32>,
    /// The same for the final windows.
    pub window_shares: Vec<f32>,
}

impl FlowGeometry {
    /// The flow in the voxels of `grid`, in whose units windows stand.
    pub fn new(
        mask: Arc<VolumeMask>,
        grid: VolumeGrid,
        [search, windows]: [&Windows; 2],
        vectors: &VectorGrid,
    ) -> Self {
        let in_mm = |at_vox: [f32; 3]| -> [f64; 3] {
            std::array::from_fn(|axis| grid.coordinate_mm(axis, f64::from(at_vox[axis])))
        };
        let on = |lattice: &Lattice, beyond: usize| {
            let layout = Layout { nodes: lattice.nodes.map(|n| n + 2 * beyond) };
            FlowNodes::new(layout, &mask, |place| {
                in_mm(std::array::from_fn(|axis| {
                    let steps = place[axis] as f32 - beyond as f32;
                    lattice.first_vox[axis] + lattice.step_vox * steps
                }))
            })
        };
        let centres = windows.at_rest();
        let at_vector = |place: [usize; 3]| {
            std::array::from_fn(|axis| {
                vectors.first_mm[axis] + place[axis] as f64 * vectors.spacing_mm
            })
        };
        let shares = |windows: &Windows| shares(windows, |at_vox| mask.is_flow(in_mm(at_vox)));
        Self {
            windows: on(&centres, 0),
            finer: on(&centres.finer(), 0),
            // A spline has a coefficient on every node and one beyond each end.
            splines: [on(&centres, 1), on(&centres.finer(), 1)],
            vectors: FlowNodes::new(Layout { nodes: vectors.vectors }, &mask, at_vector),
            search_shares: shares(search),
            window_shares: shares(windows),
            mask,
            grid,
        }
    }

    /// The mask of the volume.
    pub fn mask(&self) -> &Arc<VolumeMask> {
        &self.mask
    }

    /// Whether a place is in the flow.
    pub fn is_flow(&self, at_vox: [f32; 3]) -> bool {
        self.mask.is_flow(self.in_mm(at_vox))
    }

    /// Whether the line between two positions lies in the flow.
    pub fn is_clear(&self, from_vox: [f32; 3], to_vox: [f32; 3]) -> bool {
        self.mask.is_clear(self.in_mm(from_vox), self.in_mm(to_vox))
    }

    /// What of the vectors and of `windows`, which are those of this flow, is in it.
    pub fn in_flow(&self, windows: &Windows) -> InFlow {
        InFlow { vectors: self.vectors.count(), around_bodies: self.around_bodies(windows) }
    }

    /// Removes the results of windows with their centre outside the flow.
    pub fn drop_outside(&self, peaks: &mut [Option<Peak>]) {
        let outside = peaks.iter_mut().enumerate().filter(|(n, _)| !self.windows.is_flow(*n));
        outside.for_each(|(_, peak)| *peak = None);
    }

    /// How many of `windows`, which are those of this flow, have their centre in the flow and along an axis more
    /// flow less than a window away behind what is not flow: the light and the field on both sides are mixed there.
    fn around_bodies(&self, windows: &Windows) -> usize {
        let layout = Layout { nodes: windows.nodes };
        let reach = (windows.edge as f32 * windows.cell_vox) as usize;
        let goes_around = |n: usize| {
            let node = layout.place(n);
            (0..6).any(|side| {
                let mut is_behind = false;
                (1..reach).any(|steps| {
                    let mut at: [f32; 3] = std::array::from_fn(|axis| {
                        let steps = windows.step as f32 * windows.cell_vox * node[axis] as f32;
                        windows.first_vox[axis] + steps
                    });
                    at[side / 2] += if side % 2 == 0 { steps as f32 } else { -(steps as f32) };
                    let is_flow = self.is_flow(at);
                    is_behind |= !is_flow;
                    is_behind && is_flow
                })
            })
        };
        (0..layout.len()).filter(|&n| self.windows.is_flow(n) && goes_around(n)).count()
    }

    /// The light of a cloud that is in the flow.
    pub fn within(&self, cloud: &PointCloud) -> PointCloud {
        let points = cloud.position_vox.iter().zip(&cloud.light);
        let (position_vox, light) = points.filter(|(at, _)| self.is_flow(**at)).unzip();
        PointCloud { position_vox, light, grain_vox: cloud.grain_vox }
    }

    fn in_mm(&self, at_vox: [f32; 3]) -> [f64; 3] {
        std::array::from_fn(|axis| self.grid.coordinate_mm(axis, f64::from(at_vox[axis])))
    }
}

/// Share of the cells of each window for whose centres `is_flow`.
fn shares(windows: &Windows, is_flow: impl Fn([f32; 3]) -> bool) -> Vec<f32> {
    let raster = windows.raster(0);
    let cells = Layout { nodes: raster.cells };
    let flow: Vec<f32> = (0..raster.len())
        .map(|n| {
            let cell = cells.place(n);
            let centre = |axis: usize| raster.first_vox[axis] + raster.cell_vox * cell[axis] as f32;
            f32::from(u8::from(is_flow(std::array::from_fn(centre))))
        })
        .collect();
    let sums = box_sums(&flow, raster.cells, windows.edge);
    let whole = windows.edge.pow(3) as f32;
    let nodes = Layout { nodes: windows.nodes };
    let corner = |n: usize| cells.number(nodes.place(n).map(|node| node * windows.step));
    (0..nodes.len()).map(|n| sums[corner(n)] / whole).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_window_has_the_share_of_its_cells_in_the_flow() {
        let windows =
            Windows { nodes: [4, 2, 2], edge: 8, step: 4, cell_vox: 1.0, first_vox: [3.5; 3] };
        // Cells 0 to 7, 4 to 11, 8 to 15, 12 to 19 along x: flow begins at 6.
        let shares = shares(&windows, |at| at[0] > 5.5);
        for row in shares.chunks(4) {
            assert_eq!(row, [0.25, 0.75, 1.0, 1.0]);
        }
    }
}
