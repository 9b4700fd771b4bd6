//! The `[volume]` table: the voxels, and which of them are flow.

use std::path::PathBuf;

use garde::Validate;
use lfpiv_core::model::VolumeGrid;
use lfpiv_hw::check::finite;
use serde::{Deserialize, Serialize};

/// The measurement volume; the grid is that of [`VolumeGrid`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct VolumeTable {
    /// Voxel counts along x, y, z.
    #[garde(inner(range(min = 1, max = 2000)))]
    pub voxels: [usize; 3],
    /// Edge length of a voxel, in mm.
    #[garde(range(min = 0.001, max = 10.0))]
    pub voxel_mm: f64,
    /// World position of the volume's centre, in mm.
    #[serde(default)]
    #[garde(inner(range(min = -100.0, max = 100.0)))]
    pub centre_mm: [f64; 3],
    /// What is not flow; without it all of the volume is.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[garde(dive)]
    pub mask: Option<MaskTable>,
}

impl VolumeTable {
    /// The voxels.
    pub fn grid(&self) -> VolumeGrid {
        let Self { voxels, voxel_mm, centre_mm, .. } = *self;
        VolumeGrid { voxels, voxel_mm, centre_mm }
    }

    /// Lowest and highest corner, in mm.
    pub fn bounds_mm(&self) -> [[f64; 3]; 2] {
        [-0.5, 0.5].map(|side| {
            std::array::from_fn(|axis| {
                self.centre_mm[axis] + side * self.voxels[axis] as f64 * self.voxel_mm
            })
        })
    }
}

/// The `[volume.mask]` table: flow is what is in any region that is kept, or all of the volume if none is
/// listed, less all that is left out.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct MaskTable {
    /// Regions of interest.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[garde(dive)]
    pub keep: Vec<RegionTable>,
    /// Bodies, walls and what else is not flow.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    #[garde(custom(any_region(&self.keep)), dive)]
    pub leave_out: Vec<RegionTable>,
}

/// A box or a body, in the coordinates of the volume.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct RegionTable {
    /// An STL file (ASCII or binary, in mm) of a closed surface, relative to the configuration's folder.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[garde(custom(either_is_given(&self.low_mm, &self.high_mm)))]
    pub stl: Option<PathBuf>,
    /// Lowest x, y, z of a box, in mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[garde(inner(inner(custom(finite), range(min = -1000.0, max = 1000.0))))]
    pub low_mm: Option<[f64; 3]>,
    /// Highest x, y, z of a box, in mm.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[garde(
        inner(inner(custom(finite), range(min = -1000.0, max = 1000.0))),
        custom(above(&self.low_mm))
    )]
    pub high_mm: Option<[f64; 3]>,
}

fn any_region(keep: &[RegionTable]) -> impl FnOnce(&Vec<RegionTable>, &()) -> garde::Result + '_ {
    move |leave_out, _| match keep.is_empty() && leave_out.is_empty() {
        true => Err(garde::Error::new(
            "the mask has no region; allowed: at least one in keep or leave_out, or no \
             [volume.mask]",
        )),
        false => Ok(()),
    }
}

fn either_is_given(
    low_mm: &Option<[f64; 3]>,
    high_mm: &Option<[f64; 3]>,
) -> impl FnOnce(&Option<PathBuf>, &()) -> garde::Result {
    let corners = [low_mm, high_mm].map(|corner| corner.is_some());
    move |stl, _| match (stl.is_some(), corners) {
        (true, [false, false]) | (false, [true, true]) => Ok(()),
        _ => Err(garde::Error::new("allowed: either stl, or low_mm and high_mm")),
    }
}

fn above(low_mm: &Option<[f64; 3]>) -> impl FnOnce(&Option<[f64; 3]>, &()) -> garde::Result + '_ {
    move |high_mm, _| match (low_mm, high_mm) {
        (Some(low), Some(high)) if (0..3).any(|axis| low[axis] >= high[axis]) => {
            Err(garde::Error::new("allowed: more than low_mm along every axis"))
        }
        _ => Ok(()),
    }
}
