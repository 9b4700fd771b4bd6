//! Footprints of a pair of voxels along one axis of an array, at any position.
//!
//! The footprint depends on the camera through a few numbers only: the depth, the position between
//! two microlenses, the phase of the nearest microlens, and the slope of the rays
//! ([`crate::model::tables::AxisGeometry`] has the formula). The table has nodes in all four. Depth
//! and slope only change its width, so few nodes suffice; the position determines the shares of the
//! microlenses. The phase of the nearest microlens is added to the position; the table only needs
//! its discontinuities, which determine the neighbours whose pixel of the view is the previous or next one.

use lfpiv_hw::Optics;
use rayon::prelude::*;

use crate::{
    lightfield::TIE_PX,
    model::{
        Blur,
        blocks::pair_tap::{PairTap, SHARE_UNIT},
        footprint::{RayMap, Trapezoid},
        tables::Nodes,
    },
};

/// Position nodes per microlens.
const PLACES_PER_LENS: f64 = 32.0;

/// Classes of the nearest microlens' phase, which ranges over one pixel.
pub(super) const PHASE_CLASSES: usize = 8;

/// Classes of ray slope.
pub(super) const SLOPE_CLASSES: usize = 4;

/// Bias of a tap's first microlens, which is relative to the nearest one.
pub(super) const FIRST_BIAS: i32 = 32;

/// Geometry of the footprints along one axis of an array.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FootprintGeometry {
    pub optics: Optics,
    /// Microlens pitch, in mm.
    pub pitch_mm: f64,
    /// Microlenses per pupil cell along this axis, signed.
    pub lenses_per_cell: f64,
    /// Increase of the phase between neighbouring microlenses, in pixels, modulo 1.
    pub phase_step_px: f64,
    pub depths: Nodes,
    /// Distance between the voxels of a pair, in microlenses for a ray map with b = 1; 0 if single
    /// voxels are tabulated.
    pub pair_step: f64,
    /// Distance between a pair and the one behind it, likewise.
    pub depth_step: f64,
    pub footprint_mm: f64,
    pub blur: Blur,
    /// The largest |U − ξ| of any ray, in mm.
    pub max_slope_mm: f64,
}

/// Shares of pairs of voxels, or of two pairs at different depths, ordered by slope, depth, phase,
/// position.
#[derive(Debug)]
pub(super) struct ShareTable<const L: usize, const C: usize> {
    pub layout: TableLayout,
    pub taps: Vec<PairTap<L, C>>,
}

/// Addressing of a table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TableLayout {
    pub places: usize,
    pub depths: Nodes,
    /// Position of node 0, in microlenses from the nearest one.
    pub first_place: f32,
    pub places_per_lens: f32,
    pub leans_per_mm: f32,
}

impl FootprintGeometry {
    fn layout(&self) -> TableLayout {
        let deepest = [self.depths.at(0), self.depths.at(self.depths.count - 1)];
        let parallax = deepest.map(|depth| RayMap::at_depth(&self.optics, depth).pupil.abs());
        // The nearest microlens is found without its phase, which is up to half a cell along each axis.
        let beyond = parallax[0].max(parallax[1]) * self.lenses_per_cell.abs() * 0.6;
        let first_place = -0.5 - beyond;
        TableLayout {
            places: (-2.0 * first_place * PLACES_PER_LENS).ceil() as usize + 2,
            depths: self.depths,
            first_place: first_place as f32,
            places_per_lens: PLACES_PER_LENS as f32,
            leans_per_mm: ((SLOPE_CLASSES - 1) as f64 / self.max_slope_mm) as f32,
        }
    }

    /// The shadow of a voxel at a depth, for this ray slope: see
    /// [`crate::model::tables::AxisGeometry`].
    pub fn shadow(&self, map: RayMap, slope_mm: f64) -> Trapezoid {
        let per_depth = map.position * map.position / self.optics.image_distance_mm();
        let mut widths = [
            map.pupil.abs() * self.blur.pupil_mm,
            map.position.abs() * self.footprint_mm,
            per_depth * slope_mm * self.footprint_mm,
            self.blur.plane_mm,
        ];
        widths.sort_unstable_by(f64::total_cmp);
        let narrow = widths[..3].iter().map(|width| width * width).sum::<f64>().sqrt();
        Trapezoid::new(widths[3], narrow)
    }

    /// Offset of a microlens' pupil interval from that of the nearest one, in cells, if the nearest
    /// one has phase `phase` and is `n` microlenses away.
    pub fn further_phase(&self, phase: f64, n: i32) -> f64 {
        let next = phase + f64::from(n) * self.phase_step_px;
        next - (next + 0.5 + TIE_PX).floor() - phase
    }

    /// The share of a voxel's light that microlens `n` receives, counted from the nearest one, at a
    /// voxel position of `place` microlenses from that.
    pub fn share(&self, map: RayMap, shadow: &Trapezoid, phase: f64, place: f64, n: i32) -> f64 {
        let shift = map.pupil * self.lenses_per_cell * self.further_phase(phase, n);
        let offset_mm = (f64::from(n) - place - shift) * self.pitch_mm;
        let half_lens_mm = map.spread() * self.pitch_mm / 2.0;
        if offset_mm.abs() >= half_lens_mm + shadow.width() / 2.0 {
            return 0.0;
        }
        let below = |mm: f64| shadow.below(mm);
        (below(offset_mm + half_lens_mm) - below(offset_mm - half_lens_mm)) / map.spread()
    }

    /// Centre of a class of phases.
    pub fn phase_of(class: usize) -> f64 {
        (class as f64 + 0.5) / PHASE_CLASSES as f64 - 0.5
    }

    /// Positions of a tap's voxels relative to their centre, in microlenses.
    pub fn voxels<const C: usize>(&self, map: RayMap) -> [f64; C] {
        let half = |upper: bool, step: f64| if upper { step / 2.0 } else { -step / 2.0 };
        std::array::from_fn(|q| {
            let behind = if C > 2 { half(q >= 2, self.depth_step) } else { 0.0 };
            map.position * (half(q % 2 == 1, self.pair_step) + behind)
        })
    }

    /// The tap of voxels whose centre is `place` microlenses from the nearest one; `None` if it
    /// reaches more than `L`.
    fn tap<const L: usize, const C: usize>(
        &self,
        map: RayMap,
        shadow: &Trapezoid,
        phase: f64,
        place: f64,
    ) -> Option<PairTap<L, C>> {
        let voxels = self.voxels::<C>(map);
        let farthest = voxels.into_iter().fold(0.0, |most: f64, voxel| most.max(voxel.abs()));
        let reach = (place.abs() + farthest).ceil() as i32 + 2 * L as i32;
        let units = |n: i32| -> [u16; C] {
            voxels.map(|voxel| {
                let share = self.share(map, shadow, phase, place + voxel, n);
                (share / f64::from(SHARE_UNIT) + 0.5) as u16
            })
        };
        let nearest = place.round() as i32;
        let mut lit = (nearest - reach..=nearest + reach).filter(|&n| units(n) != [0; C]);
        let Some(first) = lit.next() else {
            return Some(PairTap { first: FIRST_BIAS as u16, ..PairTap::NONE });
        };
        let last = lit.next_back().unwrap_or(first);
        let len = usize::try_from(last - first + 1).ok().filter(|&len| len <= L)?;
        let units = |n: usize| if n < len { units(first + n as i32) } else { [0; C] };
        let voxels: [[u16; C]; L] = std::array::from_fn(units);
        let shares = std::array::from_fn(|q| voxels.map(|units| units[q]));
        let first = u16::try_from(first + FIRST_BIAS).ok()?;
        Some(PairTap { shares, first, len: len as u16 })
    }
}

impl TableLayout {
    /// Index of the first tap of a depth, for the smallest slope.
    pub fn depth_index(&self, depth_mm: f64) -> usize {
        self.depths.nearest(depth_mm) * PHASE_CLASSES * self.places
    }

    /// Number of taps per slope.
    pub fn taps_per_slope(&self) -> usize {
        self.depths.count * PHASE_CLASSES * self.places
    }
}

impl<const L: usize, const C: usize> ShareTable<L, C> {
    /// `None` if a tap reaches more than `L` microlenses.
    pub fn new(geometry: &FootprintGeometry) -> Option<Self> {
        let layout = geometry.layout();
        let (places, depths) = (layout.places, layout.depths.count);
        let row = |n: usize| -> Option<Vec<PairTap<L, C>>> {
            let (slope, depth, phase) =
                (n / (depths * PHASE_CLASSES), n / PHASE_CLASSES % depths, n % PHASE_CLASSES);
            let map = RayMap::at_depth(&geometry.optics, layout.depths.at(depth));
            let slope_mm = slope as f64 / f64::from(layout.leans_per_mm);
            let shadow = geometry.shadow(map, slope_mm);
            let phase = FootprintGeometry::phase_of(phase);
            let place = |n: usize| f64::from(layout.first_place) + n as f64 / PLACES_PER_LENS;
            (0..places).map(|n| geometry.tap(map, &shadow, phase, place(n))).collect()
        };
        let rows: Option<Vec<_>> =
            (0..SLOPE_CLASSES * depths * PHASE_CLASSES).into_par_iter().map(row).collect();
        Some(Self { layout, taps: rows?.concat() })
    }

    #[inline(always)]
    pub fn tap(&self, at: usize) -> &PairTap<L, C> {
        &self.taps[at]
    }

    pub fn memory_bytes(&self) -> usize {
        size_of_val(self.taps.as_slice())
    }
}
