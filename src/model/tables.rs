//! Tables of one-axis footprints, per view index, depth and position.

use std::ops::Range;

use lfpiv_hw::Optics;

use super::footprint::{RayMap, Trapezoid};
use crate::lightfield::AxisSampling;

/// Evenly spaced coordinates: `first + n·step`.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nodes {
    /// Coordinate of node 0, in mm.
    pub first_mm: f64,
    /// Distance between nodes, in mm; may be negative.
    pub step_mm: f64,
    /// Number of nodes.
    pub count: usize,
}

impl Nodes {
    /// Coordinate of node `n`, in mm.
    pub fn at(&self, n: usize) -> f64 {
        self.first_mm + n as f64 * self.step_mm
    }

    /// The node nearest to a coordinate.
    pub fn nearest(&self, coordinate_mm: f64) -> usize {
        let n = ((coordinate_mm - self.first_mm) / self.step_mm).round();
        n.clamp(0.0, (self.count - 1) as f64) as usize
    }
}

/// The microlenses that a voxel covers along one axis, and its share on each.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tap<const W: usize> {
    /// First microlens, counted from the start of the window.
    pub first: u32,
    /// Shares on microlenses `first..first + W`.
    pub weights: [f32; W],
}

/// One axis of one camera: a [`Tap`] for every view index, depth node and position node.
///
/// Stored view index first, then depth, then position, because one view at a time is worked on
/// and neighbouring voxels share a depth.
#[derive(Debug)]
pub struct AxisTable<const W: usize> {
    reach: i32,
    depths: usize,
    positions: usize,
    taps: Vec<Tap<W>>,
}

/// What an [`AxisTable`] is made from.
#[derive(Debug)]
pub struct AxisGeometry<'a> {
    /// The camera's optics.
    pub optics: &'a Optics,
    /// Pixels and pupil intervals along this axis.
    pub sampling: &'a AxisSampling,
    /// Microlenses of the window along this axis.
    pub window: Range<usize>,
    /// Lateral positions of voxels, in camera coordinates.
    pub positions: Nodes,
    /// Depths of voxels, in camera coordinates.
    pub depths: Nodes,
    /// Edge of a voxel, in mm.
    pub voxel_mm: f64,
}

impl AxisGeometry<'_> {
    /// Width of the widest footprint, in microlens pitches.
    pub fn widest_pitches(&self) -> f64 {
        let width = |depth_mm: f64| {
            let map = RayMap::at_depth(self.optics, depth_mm);
            map.pupil.abs() * self.sampling.cell_mm + map.position.abs() * self.voxel_mm
        };
        let widest = width(self.depths.at(0)).max(width(self.depths.at(self.depths.count - 1)));
        widest / self.optics.microlens.pitch_mm
    }

    /// The share on each microlens `first..first + W` of a voxel at `position_mm` whose rays obey
    /// `map`, in view `k`; microlens numbers count from the start of the window.
    fn tap<const W: usize>(&self, map: RayMap, k: i32, position_mm: f64) -> Tap<W> {
        let pitch = self.optics.microlens.pitch_mm;
        let trapezoid = Trapezoid::new(
            map.pupil.abs() * self.sampling.cell_mm,
            map.position.abs() * self.voxel_mm,
        );
        let middle = (self.sampling.microlenses as f64 - 1.0) / 2.0;
        let nominal = map.pupil * f64::from(k) * self.sampling.cell_mm + map.position * position_mm;
        let start = (nominal / pitch + middle - (W as f64 - 1.0) / 2.0).round() as i64;
        // A footprint that leaves the window keeps its true shares on what remains of it.
        let last_first = self.window.end as i64 - W as i64;
        let first = start.clamp(self.window.start as i64, last_first.max(self.window.start as i64));
        let weights = std::array::from_fn(|n| {
            let i = first as usize + n;
            if i >= self.window.end {
                return 0.0;
            }
            let Some(sample) = self.sampling.sample(k, i) else { return 0.0 };
            let centre = map.pupil * sample.pupil_mm + map.position * position_mm;
            let edge = (i as f64 - middle) * pitch - centre;
            (trapezoid.below(edge + pitch / 2.0) - trapezoid.below(edge - pitch / 2.0)) as f32
        });
        Tap { first: (first - self.window.start as i64) as u32, weights }
    }
}

impl<const W: usize> AxisTable<W> {
    /// Computes every tap. Cost: about 40 ns per tap.
    pub fn new(geometry: &AxisGeometry<'_>) -> Self {
        let reach = geometry.sampling.reach;
        let (depths, positions) = (geometry.depths.count, geometry.positions.count);
        let mut taps = Vec::with_capacity((2 * reach + 1) as usize * depths * positions);
        for k in -reach..=reach {
            for depth in 0..depths {
                let map = RayMap::at_depth(geometry.optics, geometry.depths.at(depth));
                taps.extend((0..positions).map(|n| geometry.tap(map, k, geometry.positions.at(n))));
            }
        }
        Self { reach, depths, positions, taps }
    }

    /// The taps of view index `k`, addressed by `depth * positions + position`.
    pub fn of_view(&self, k: i32) -> &[Tap<W>] {
        let len = self.depths * self.positions;
        let start = (k + self.reach) as usize * len;
        &self.taps[start..start + len]
    }

    /// Number of position nodes: the stride between depths in [`Self::of_view`].
    pub fn positions(&self) -> usize {
        self.positions
    }

    /// Bytes held.
    pub fn memory_bytes(&self) -> usize {
        self.taps.len() * size_of::<Tap<W>>()
    }
}
