//! Tables of one-axis footprints, per view index, depth and position.

use std::ops::Range;

use lfpiv_hw::Optics;

use super::{
    Blur, SUPPORT_SHARE,
    footprint::{RayMap, Trapezoid},
};
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

/// Shares of a voxel's light on microlenses along one axis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tap<const W: usize> {
    /// First microlens, counted from the start of the window.
    pub first: u16,
    /// The microlenses of `first..first + W` that receive more than [`SUPPORT_SHARE`]: start and length of
    /// their range; empty if the view contains too little of the voxel's light.
    pub support_start: u8,
    pub support_len: u8,
    /// Shares on microlenses `first..first + W`.
    pub weights: [f32; W],
}

impl<const W: usize> Tap<W> {
    fn new(first: u16, weights: [f32; W]) -> Self {
        let lit = |weight: &f32| *weight > SUPPORT_SHARE;
        let visible: f32 = weights.iter().sum();
        let start = weights.iter().position(lit).unwrap_or(0);
        let end = weights.iter().rposition(lit).map_or(0, |last| last + 1);
        let len = if visible >= MIN_VISIBLE_SHARE { end - start } else { 0 };
        Self { first, support_start: start as u8, support_len: len as u8, weights }
    }

    /// Whether microlens `first + n` belongs to the support.
    pub fn supports(&self, n: usize) -> bool {
        let start = usize::from(self.support_start);
        (start..start + usize::from(self.support_len)).contains(&n)
    }
}

/// Least share of a voxel's light along each axis in a view that is used as evidence. The pupil intervals of
/// neighbouring microlenses in a view differ by up to a cell (see [`AxisSampling`]). The light of a voxel
/// between them can fall into the gap, so that a lit voxel is dark in the view.
pub const MIN_VISIBLE_SHARE: f32 = 0.75;

/// One axis of one camera: a [`Tap`] for every view index, depth node and position node.
///
/// Stored by view index, then depth, then position, because views are processed one at a time and neighbouring
/// voxels share a depth.
#[derive(Debug)]
pub struct AxisTable<const W: usize> {
    reach: i32,
    depths: usize,
    positions: usize,
    taps: Vec<Tap<W>>,
}

/// Input of an [`AxisTable`].
#[derive(Debug, Clone, PartialEq)]
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
    /// Edge of the light source of a voxel, in mm; 0 is a point.
    pub footprint_mm: f64,
    /// Blur of the shadow in addition to the source's size.
    pub blur: Blur,
}

impl AxisGeometry<'_> {
    /// The shadow on the microlens plane of a source through a pixel's pupil interval, with the lateral distance
    /// `slant_mm` between pupil point and source along this axis (U − ξ).
    ///
    /// The source's depth h moves the shadow by (s_i/s²)(U − ξ) per unit of depth, which is a third uniform
    /// variable. Diffraction at the main lens is a fourth ([`Blur`]). The widest is used directly; the others
    /// are replaced by one with the same variance. Without the third, a voxel in focus would be sharp, with an
    /// error of 2.3 % (L1) if its edges coincide with those of microlenses.
    fn shadow(&self, map: RayMap, slant_mm: f64) -> Trapezoid {
        let per_depth = map.position * map.position / self.optics.image_distance_mm();
        let mut widths = [
            map.pupil.abs() * self.blur.pupil_mm,
            map.position.abs() * self.footprint_mm,
            per_depth * slant_mm.abs() * self.footprint_mm,
            self.blur.plane_mm,
        ];
        widths.sort_unstable_by(f64::total_cmp);
        // `hypot` would increase the time of the tables by a tenth, because it prevents overflow.
        let narrow = widths[..3].iter().map(|width| width * width).sum::<f64>().sqrt();
        Trapezoid::new(widths[3], narrow)
    }

    /// The largest share of a voxel's light in one view outside of `taps` microlenses, and the width in pitches
    /// of the range of microlenses that the voxel reaches at that depth.
    ///
    /// The pupil interval of each microlens in a view deviates by up to half a cell from the nominal one. A
    /// shadow of width w is therefore within w/2 + φ of its nominal position, with φ = |a| cell/2. Taps start
    /// at the nearest microlens. The first microlens left out is at least W/2 pitches from the nominal
    /// position, and its edge (W − 1)/2 (see [`RayMap::spread`] for the correction of its width). Nothing is
    /// lost for w + 2φ ≤ W − 1; otherwise at most the trapezoid's tail of that overlap. (The overlap is on one
    /// side only if it is less than a pitch, so that shares above a few percent are approximate.)
    pub fn most_lost(&self, taps: usize) -> (f64, f64) {
        let pitch = self.optics.microlens.pitch_mm;
        let last = self.positions.at(self.positions.count - 1);
        let slant_mm = f64::from(self.sampling.reach) * self.sampling.cell_mm
            + self.positions.first_mm.abs().max(last.abs());
        (0..self.depths.count)
            .map(|depth| {
                let map = RayMap::at_depth(self.optics, self.depths.at(depth));
                let phases = map.pupil.abs() * self.sampling.cell_mm;
                let shadow = self.shadow(map, slant_mm);
                let reach = (shadow.width() + phases) / pitch + map.spread() - 1.0;
                let overlap = (reach - (taps as f64 - 1.0)) / 2.0 * pitch;
                (shadow.below(overlap - shadow.width() / 2.0) / map.spread(), reach)
            })
            .fold((0.0, 0.0), |(lost, reach), (l, r)| (lost.max(l), reach.max(r)))
    }

    /// Largest number of microlenses that a pair of neighbouring voxels reaches in any view.
    pub fn pair_reach(&self) -> usize {
        let pitch = self.optics.microlens.pitch_mm;
        let widest = (0..self.depths.count)
            .map(|depth| {
                let map = RayMap::at_depth(self.optics, self.depths.at(depth));
                let step = (map.position * self.positions.step_mm).abs();
                (step + self.widest_shadow_mm(map)) / pitch + map.spread() - 1.0
            })
            .fold(0.0, f64::max);
        // An interval of n pitches overlaps at most n + 1 microlenses.
        widest.ceil() as usize + 1
    }

    /// The widest shadow at a depth, with the phases of the microlenses' pupil intervals, in mm.
    fn widest_shadow_mm(&self, map: RayMap) -> f64 {
        let last = self.positions.at(self.positions.count - 1);
        let slant_mm = f64::from(self.sampling.reach) * self.sampling.cell_mm
            + self.positions.first_mm.abs().max(last.abs());
        self.shadow(map, slant_mm).width() + map.pupil.abs() * self.sampling.cell_mm
    }

    /// The shares in view `k` of a voxel at `position_mm` with the ray map `map`. Microlenses are counted from
    /// the start of the window.
    fn tap<const W: usize>(&self, map: RayMap, k: i32, position_mm: f64) -> Tap<W> {
        let pitch = self.optics.microlens.pitch_mm;
        let pupil_mm = f64::from(k) * self.sampling.cell_mm;
        let trapezoid = self.shadow(map, pupil_mm - position_mm);
        let middle = (self.sampling.microlenses as f64 - 1.0) / 2.0;
        let nominal = map.pupil * pupil_mm + map.position * position_mm;
        let start = (nominal / pitch + middle - (W as f64 - 1.0) / 2.0).round() as i64;
        // A footprint that extends beyond the window keeps its true shares inside.
        let last_first = self.window.end as i64 - W as i64;
        let first = start.clamp(self.window.start as i64, last_first.max(self.window.start as i64));
        let shadow = Shadow { map, trapezoid, k, position_mm };
        let weights = std::array::from_fn(|n| self.share(&shadow, first as usize + n) as f32);
        Tap::new((first - self.window.start as i64) as u16, weights)
    }

    /// The shadow in view `k` of a source at `position_mm` with the ray map `map`.
    pub fn shadow_of(&self, map: RayMap, k: i32, position_mm: f64) -> Shadow {
        let pupil_mm = f64::from(k) * self.sampling.cell_mm;
        Shadow { map, trapezoid: self.shadow(map, pupil_mm - position_mm), k, position_mm }
    }

    /// The first microlens, counted from the start of the array, that a shadow can reach. The pupil interval of
    /// each microlens deviates by up to half a cell from the nominal one.
    pub fn first_reached(&self, shadow: &Shadow) -> i64 {
        let pupil_mm = f64::from(shadow.k) * self.sampling.cell_mm;
        let nominal = shadow.map.pupil * pupil_mm + shadow.map.position * shadow.position_mm;
        let phase = shadow.map.pupil.abs() * self.sampling.cell_mm / 2.0;
        let half_lens = shadow.map.spread() * self.optics.microlens.pitch_mm / 2.0;
        let edge = nominal - phase - shadow.trapezoid.width() / 2.0 - half_lens;
        let middle = (self.sampling.microlenses as f64 - 1.0) / 2.0;
        (edge / self.optics.microlens.pitch_mm + middle).ceil() as i64
    }

    /// The share of a source's light on microlens `i`, counted from the start of the array, in the shadow's view; 0
    /// outside the window and for microlenses without an unshared pixel in this view.
    pub fn share(&self, shadow: &Shadow, i: usize) -> f64 {
        if !self.window.contains(&i) {
            return 0.0;
        }
        let Some(sample) = self.sampling.sample(shadow.k, i) else { return 0.0 };
        let pitch = self.optics.microlens.pitch_mm;
        let middle = (self.sampling.microlenses as f64 - 1.0) / 2.0;
        let spread = shadow.map.spread();
        let centre = shadow.map.pupil * sample.pupil_mm + shadow.map.position * shadow.position_mm;
        let offset = (i as f64 - middle) * pitch - centre;
        let half_lens = spread * pitch / 2.0;
        if offset.abs() >= half_lens + shadow.trapezoid.width() / 2.0 {
            return 0.0;
        }
        let (low, high) = (offset - half_lens, offset + half_lens);
        (shadow.trapezoid.below(high) - shadow.trapezoid.below(low)) / spread
    }
}

/// Shadow of a source along one axis in one view.
#[derive(Debug, Clone, Copy)]
pub struct Shadow {
    map: RayMap,
    trapezoid: Trapezoid,
    k: i32,
    position_mm: f64,
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

    /// The taps of view index `k`, with index `depth * positions + position`.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{model::ModelParts, test_bench};

    /// The largest share of nine taps that is outside of `W` taps, over all views, depths and positions. Voxels
    /// and taps are well inside the window.
    fn lost<const W: usize>(geometry: &AxisGeometry<'_>) -> f64 {
        let mut most = 0.0f64;
        for depth in 0..geometry.depths.count {
            let map = RayMap::at_depth(geometry.optics, geometry.depths.at(depth));
            for k in -8..=8 {
                for n in 0..geometry.positions.count {
                    let position = geometry.positions.at(n);
                    let sum = |weights: &[f32]| weights.iter().copied().map(f64::from).sum::<f64>();
                    let all = sum(&geometry.tap::<9>(map, k, position).weights);
                    most = most.max(all - sum(&geometry.tap::<W>(map, k, position).weights));
                }
            }
        }
        most
    }

    #[test]
    fn taps_lose_no_more_than_stated() {
        let optics = test_bench::optics();
        let sampling = AxisSampling::columns(&optics);
        let mut tightest = 0.0f64;
        for footprint_mm in [0.0, 0.03, 0.05, 0.1, 0.12, 0.2, 0.25] {
            for deepest_mm in [0.05, 1.0, 2.5, 4.0, 6.0, 8.0, 12.0, 16.0] {
                let geometry = AxisGeometry {
                    optics: &optics,
                    sampling: &sampling,
                    window: 0..129,
                    positions: Nodes { first_mm: -1.9, step_mm: 0.0137, count: 280 },
                    depths: Nodes { first_mm: -deepest_mm, step_mm: 2.0 * deepest_mm, count: 2 },
                    footprint_mm,
                    blur: ModelParts::default().blur(&optics),
                };
                let of_taps = [
                    (2, lost::<2>(&geometry)),
                    (3, lost::<3>(&geometry)),
                    (5, lost::<5>(&geometry)),
                ];
                for (taps, lost) in of_taps {
                    let (bound, _) = geometry.most_lost(taps);
                    let case = (footprint_mm, deepest_mm, taps);
                    if bound <= 0.05 {
                        assert!(lost <= bound + 1e-6, "{case:?} lost {lost}, stated {bound}");
                    }
                    // An accepted number of taps loses at most half a percent.
                    if bound <= 0.005 {
                        tightest = tightest.max(lost);
                    }
                }
            }
        }
        println!("most light lost beside the taps that are accepted: {:.2} %", 100.0 * tightest);
        assert!(tightest <= 0.005, "{tightest}");
    }
}
