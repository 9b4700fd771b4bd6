//! Geometry of one camera and the voxel grid: camera coordinates of the voxels, and the microlenses that their
//! light can reach.

use std::ops::Range;

use lfpiv_hw::{CameraName, Optics, Pose};
use nalgebra::Vector3;

use super::{
    ModelError, ModelParts, VolumeGrid,
    footprint::RayMap,
    tables::{AxisGeometry, Nodes},
};
use crate::lightfield::{AxisSampling, MicrolensWindow};

/// Lateral table nodes per voxel for a camera that is not along a grid axis. Each voxel uses the nearest node,
/// which is at most 1/32 of the voxel's edge away.
const OBLIQUE_LATERAL_NODES_PER_VOXEL: f64 = 16.0;

/// Depth nodes per voxel for such a camera. The shadow depends less on depth than on the lateral position: half a
/// voxel of 0.1 mm in depth moves it by 0.003 mm at the edge of the bench's pupil (da/ds U).
const OBLIQUE_DEPTH_NODES_PER_VOXEL: f64 = 1.0;

/// Largest displacement of a shadow by sharing a depth node between voxels of neighbouring depths, in microlenses.
const DEPTH_NODE_TOLERANCE: f64 = 1.0 / 64.0;

/// Largest distance of depth nodes for [`DEPTH_NODE_TOLERANCE`], in mm. A depth error d, at most half a step, moves
/// the shadow of a ray through the pupil's edge R by d R s_i/s² (da/ds).
fn depth_node_step_mm(optics: &Optics) -> f64 {
    let s = optics.object_distance_mm;
    let per_depth = optics.pupil_diameter_mm() / 2.0 * optics.image_distance_mm() / (s * s);
    2.0 * DEPTH_NODE_TOLERANCE * optics.microlens.pitch_mm / per_depth * (1.0 + 1e-9)
}

/// The grid in the coordinates of one camera.
#[derive(Debug, Clone)]
pub struct CameraView {
    /// The microlenses that light from the grid can reach.
    pub window: MicrolensWindow,
    /// Coordinate along `right`.
    pub xi: CameraAxis,
    /// Coordinate along `up`.
    pub eta: CameraAxis,
    /// Coordinate along `axis`.
    pub depth: CameraAxis,
}

/// One camera coordinate of the voxels: `at_origin + Σ per_index[a]·index[a]`, and its table nodes.
#[derive(Debug, Clone)]
pub struct CameraAxis {
    at_origin_mm: f64,
    per_index_mm: [f64; 3],
    /// Lowest and highest coordinate of a voxel's centre, in mm.
    range_mm: (f64, f64),
    /// The parallel or antiparallel grid axis, if there is one.
    pub along: Option<usize>,
    /// The tabulated coordinates.
    pub nodes: Nodes,
}

impl CameraAxis {
    fn new(
        direction: &Vector3<f64>,
        pose: &Pose,
        grid: &VolumeGrid,
        oblique_nodes_per_voxel: f64,
        voxels_per_aligned_node: usize,
    ) -> Self {
        let first = grid.centre_of([0, 0, 0]).coords - pose.origin_mm;
        let at_origin_mm = first.dot(direction);
        let per_index_mm: [f64; 3] = std::array::from_fn(|a| direction[a] * grid.voxel_mm);
        let along = (0..3).find(|&a| (direction[a].abs() - 1.0).abs() < 1e-9);
        let reach = |sign: f64| -> f64 {
            (0..3).map(|a| (sign * per_index_mm[a]).max(0.0) * (grid.voxels[a] - 1) as f64).sum()
        };
        let range_mm = (at_origin_mm - reach(-1.0), at_origin_mm + reach(1.0));
        let nodes = match along {
            Some(a) => Nodes {
                first_mm: at_origin_mm
                    + (voxels_per_aligned_node as f64 - 1.0) / 2.0 * per_index_mm[a],
                step_mm: voxels_per_aligned_node as f64 * per_index_mm[a],
                count: grid.voxels[a].div_ceil(voxels_per_aligned_node),
            },
            None => {
                let step_mm = grid.voxel_mm / oblique_nodes_per_voxel;
                let count = ((range_mm.1 - range_mm.0) / step_mm).ceil() as usize + 1;
                Nodes { first_mm: range_mm.0, step_mm, count }
            }
        };
        Self { at_origin_mm, per_index_mm, range_mm, along, nodes }
    }

    /// Largest distance of a voxel's points from its centre along this coordinate, in mm.
    fn half_voxel_mm(&self) -> f64 {
        self.per_index_mm.iter().map(|step| step.abs()).sum::<f64>() / 2.0
    }

    /// Coordinate of the centre of voxel (i, j, k), in mm.
    pub fn coordinate_mm(&self, ijk: [usize; 3]) -> f64 {
        self.at_origin_mm + (0..3).map(|a| self.per_index_mm[a] * ijk[a] as f64).sum::<f64>()
    }

    /// Nodes for pairs of voxels along grid axis `along`: with one layer in the middle of each pair, with two
    /// layers at both voxels.
    pub fn layer_nodes(&self, along: usize, voxels: usize, layers: usize) -> Nodes {
        let step_mm = self.per_index_mm[along];
        let per_node = 2.0 / layers as f64;
        Nodes {
            first_mm: self.at_origin_mm + (per_node - 1.0) / 2.0 * step_mm,
            step_mm: per_node * step_mm,
            count: layers * voxels.div_ceil(2),
        }
    }

    /// The node nearest to voxel (i, j, k).
    pub fn node_of(&self, ijk: [usize; 3]) -> usize {
        self.nodes.nearest(self.coordinate_mm(ijk))
    }
}

impl CameraView {
    /// The view of camera `camera`, from 0.
    ///
    /// # Errors
    /// The grid is not in the camera's field, or it extends to its lens.
    pub fn new(
        optics: &Optics,
        pose: &Pose,
        grid: &VolumeGrid,
        camera: usize,
    ) -> Result<Self, ModelError> {
        let axis =
            |direction, oblique, aligned| CameraAxis::new(direction, pose, grid, oblique, aligned);
        let xi = axis(&pose.right, OBLIQUE_LATERAL_NODES_PER_VOXEL, 1);
        let eta = axis(&pose.up, OBLIQUE_LATERAL_NODES_PER_VOXEL, 1);
        let shared_depth = (depth_node_step_mm(optics) / grid.voxel_mm).floor().max(1.0) as usize;
        let depth = axis(&pose.axis, OBLIQUE_DEPTH_NODES_PER_VOXEL, shared_depth);
        let camera = CameraName(camera);
        let (_, nearest_mm) = depth.range_mm;
        let limit_mm = optics.object_distance_mm - optics.focal_length_mm;
        if nearest_mm >= limit_mm {
            return Err(ModelError::TooDeep { camera, depth_mm: nearest_mm, limit_mm });
        }
        let columns = reached_microlenses(optics, &xi, &depth, optics.microlens.columns);
        let rows = reached_microlenses(optics, &eta, &depth, optics.microlens.rows);
        match (columns, rows) {
            (Some(columns), Some(rows)) => {
                Ok(Self { window: MicrolensWindow { columns, rows }, xi, eta, depth })
            }
            _ => Err(ModelError::VolumeOutOfView { camera }),
        }
    }

    /// Geometry of the tables along the sensor's columns and rows, for light sources of edge `footprint_mm` and
    /// with these parts of the model.
    pub fn geometries<'a>(
        &self,
        optics: &'a Optics,
        columns: &'a AxisSampling,
        rows: &'a AxisSampling,
        footprint_mm: f64,
        parts: &ModelParts,
    ) -> [AxisGeometry<'a>; 2] {
        let axis = |sampling, window: &Range<usize>, lateral: &CameraAxis| AxisGeometry {
            optics,
            sampling,
            window: window.clone(),
            positions: lateral.nodes,
            depths: self.depth.nodes,
            footprint_mm,
            blur: parts.blur(optics),
        };
        [axis(columns, &self.window.columns, &self.xi), axis(rows, &self.window.rows, &self.eta)]
    }
}

/// The microlenses that light from the grid can reach along one axis.
fn reached_microlenses(
    optics: &Optics,
    lateral: &CameraAxis,
    depth: &CameraAxis,
    microlenses: usize,
) -> Option<Range<usize>> {
    let (low, high) = lateral.range_mm;
    let (far, near) = depth.range_mm;
    let radius = optics.pupil_diameter_mm() / 2.0;
    let (mut first, mut last) = (f64::INFINITY, f64::NEG_INFINITY);
    for d in [far - depth.half_voxel_mm(), near + depth.half_voxel_mm()] {
        let map = RayMap::at_depth(optics, d);
        let blur = map.pupil.abs() * radius;
        for position in [low - lateral.half_voxel_mm(), high + lateral.half_voxel_mm()] {
            let x = map.position * position;
            first = first.min(x - blur);
            last = last.max(x + blur);
        }
    }
    let index = |x: f64| (x / optics.microlens.pitch_mm + (microlenses as f64 - 1.0) / 2.0).round();
    let (first, last) = (index(first), index(last));
    if last < 0.0 || first >= microlenses as f64 {
        return None;
    }
    Some(first.max(0.0) as usize..(last as usize + 1).min(microlenses))
}
