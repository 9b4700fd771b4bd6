//! Mask of the measurement volume: the voxels that are flow.

use super::VolumeGrid;

/// The voxels of a grid that are flow. Positions beyond the grid have the value of the nearest voxel, so that the
/// margin around a volume continues its faces.
#[derive(Debug, Clone, PartialEq)]
pub struct VolumeMask {
    /// The voxel grid.
    pub grid: VolumeGrid,
    /// Whether each is flow, in the order z, y, x; one per voxel.
    pub flow: Vec<bool>,
}

/// Number of tested points per voxel along a line.
const TESTS_PER_VOXEL: f64 = 2.0;

impl VolumeMask {
    /// Share of the voxels that are flow, 0 to 1.
    pub fn flow_share(&self) -> f64 {
        let flow = self.flow.iter().filter(|flow| **flow).count();
        flow as f64 / self.flow.len().max(1) as f64
    }

    /// Whether the voxel at a position (mm), or the nearest one, is flow.
    pub fn is_flow(&self, at_mm: [f64; 3]) -> bool {
        let nearest = |axis: usize| {
            // The cast saturates negative numbers at zero.
            let index = self.grid.index_of(axis, at_mm[axis]).round() as usize;
            index.min(self.grid.voxels[axis].saturating_sub(1))
        };
        let voxel = self.grid.linear([nearest(0), nearest(1), nearest(2)]);
        self.flow.get(voxel).copied().unwrap_or(true)
    }

    /// Whether the straight line between two positions (mm) is completely in the flow, ends included.
    pub fn is_clear(&self, from_mm: [f64; 3], to_mm: [f64; 3]) -> bool {
        let longest = (0..3).map(|axis| (to_mm[axis] - from_mm[axis]).abs()).fold(0.0, f64::max);
        let steps = (TESTS_PER_VOXEL * longest / self.grid.voxel_mm).ceil().max(1.0) as usize;
        (0..=steps).all(|step| {
            let share = step as f64 / steps as f64;
            self.is_flow(std::array::from_fn(|axis| {
                from_mm[axis] + share * (to_mm[axis] - from_mm[axis])
            }))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A plate of two voxels across x.
    fn plate() -> VolumeMask {
        let grid = VolumeGrid { voxels: [10, 4, 4], voxel_mm: 0.5, centre_mm: [1.0, 0.0, 0.0] };
        let flow = (0..grid.len()).map(|n| ![4, 5].contains(&grid.indices(n as u32)[0])).collect();
        VolumeMask { grid, flow }
    }

    #[test]
    fn the_faces_go_on_beyond_the_volume() {
        let mask = plate();
        assert_eq!(mask.flow_share(), 0.8);
        assert!(!mask.is_flow([1.2, 0.0, 0.0]) && !mask.is_flow([0.9, 9.0, -9.0]));
        assert!(mask.is_flow([-50.0, 0.0, 0.0]) && mask.is_flow([50.0, 0.0, 0.0]));
    }

    #[test]
    fn a_line_through_a_plate_is_not_clear() {
        let mask = plate();
        assert!(!mask.is_clear([-1.0, 0.0, 0.0], [3.0, 0.3, -0.4]));
        assert!(mask.is_clear([-1.0, -0.9, 0.0], [-0.6, 0.8, 0.7]));
        assert!(mask.is_clear([2.0, 0.0, 0.0], [2.0, 0.0, 0.0]));
        assert!(!mask.is_clear([1.0, 0.0, 0.0], [2.0, 0.0, 0.0]));
    }
}
