//! Regions of the volume that are flow or not flow.

use std::sync::Arc;

use super::{ClosedSurface, VolumeGrid, VolumeMask};

/// A region of space.
#[derive(Debug, Clone, PartialEq)]
pub enum Region {
    /// Between two corners, in mm.
    Cuboid {
        /// Lowest x, y, z.
        low_mm: [f64; 3],
        /// Highest x, y, z.
        high_mm: [f64; 3],
    },
    /// Inside a closed surface.
    Body(Arc<ClosedSurface>),
}

impl Region {
    /// Whether a position (mm) is in it.
    pub fn contains(&self, at_mm: [f64; 3]) -> bool {
        match self {
            Self::Cuboid { low_mm, high_mm } => {
                (0..3).all(|axis| (low_mm[axis]..=high_mm[axis]).contains(&at_mm[axis]))
            }
            Self::Body(surface) => surface.contains(at_mm),
        }
    }

    /// Lowest and highest corner of the box around it, in mm.
    pub fn bounds_mm(&self) -> [[f64; 3]; 2] {
        match self {
            Self::Cuboid { low_mm, high_mm } => [*low_mm, *high_mm],
            Self::Body(surface) => surface.bounds_mm(),
        }
    }

    /// Whether the centre of each voxel of `grid` is in it, in the order z, y, x.
    pub fn voxels_inside(&self, grid: &VolumeGrid) -> Vec<bool> {
        match self {
            Self::Cuboid { .. } => (0..grid.len())
                .map(|n| self.contains(grid.centre_of(grid.indices(n as u32)).into()))
                .collect(),
            Self::Body(surface) => surface.voxels_inside(grid),
        }
    }
}

/// Definition of the flow: the union of the regions `keep`, or all of space if there are none, without the regions
/// `leave_out`.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct FlowRegions {
    /// Regions of interest.
    pub keep: Vec<Region>,
    /// Bodies, walls and other regions without flow.
    pub leave_out: Vec<Region>,
}

impl FlowRegions {
    /// Whether a position (mm) is in the flow.
    pub fn is_flow(&self, at_mm: [f64; 3]) -> bool {
        let within = |regions: &[Region]| regions.iter().any(|region| region.contains(at_mm));
        (self.keep.is_empty() || within(&self.keep)) && !within(&self.leave_out)
    }

    /// The voxels of `grid` whose centres are in the flow.
    pub fn mask(&self, grid: &VolumeGrid) -> VolumeMask {
        let within = |regions: &[Region]| {
            let mut any = vec![false; grid.len()];
            for region in regions {
                let inside = region.voxels_inside(grid);
                any.iter_mut().zip(inside).for_each(|(any, inside)| *any |= inside);
            }
            any
        };
        let kept = match self.keep.is_empty() {
            true => vec![true; grid.len()],
            false => within(&self.keep),
        };
        let left_out = within(&self.leave_out);
        let flow = kept.into_iter().zip(left_out).map(|(kept, left_out)| kept && !left_out);
        VolumeMask { grid: grid.clone(), flow: flow.collect() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_kept_less_what_is_left_out_is_flow() {
        let cuboid = |low: f64, high: f64| Region::Cuboid { low_mm: [low; 3], high_mm: [high; 3] };
        let regions = FlowRegions {
            keep: vec![cuboid(-1.0, 0.0), cuboid(-0.3, 0.8)],
            leave_out: vec![cuboid(-0.2, 0.2)],
        };
        let along = |at: f64| regions.is_flow([at; 3]);
        assert_eq!([-1.1, -0.9, 0.1, 0.5, 0.9].map(along), [false, true, false, true, false]);
        assert!(FlowRegions::default().is_flow([5.0; 3]));
        let grid = VolumeGrid { voxels: [12, 10, 11], voxel_mm: 0.17, centre_mm: [0.0; 3] };
        let mask = regions.mask(&grid);
        for n in 0..grid.len() {
            let at: [f64; 3] = grid.centre_of(grid.indices(n as u32)).into();
            assert_eq!(mask.flow[n], regions.is_flow(at), "{at:?}");
        }
    }
}
