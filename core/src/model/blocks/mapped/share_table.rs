//! Footprints of a pair of voxels along one axis of an array, wherever the pair stands.
//!
//! The footprint depends on the camera only through a few numbers: the depth, the place between two
//! microlenses, the phase of the microlens that the pair is nearest to, and how far the rays lean
//! ([`crate::model::tables::AxisGeometry`] has the formula). The table holds it at nodes of all
//! four. Depth and lean change its width alone, so few nodes do; the place decides which microlens
//! gets how much. Of the phase only the jumps are left to the table: which of the neighbours see the
//! view through the pixel before or after. The nearest microlens' own phase goes into the place.

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

/// Places per microlens.
const PLACES_PER_LENS: f64 = 32.0;

/// Classes of the nearest microlens' phase, which spans a pixel.
pub(super) const PHASES: usize = 8;

/// Classes of how far rays lean.
pub(super) const LEANS: usize = 4;

/// Added to the first microlens of a tap, which is counted from the nearest one.
pub(super) const FIRST_BIAS: i32 = 32;

/// What the footprints along one axis of an array are made from.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct FootprintGeometry {
    pub optics: Optics,
    /// Distance between microlenses, in mm.
    pub pitch_mm: f64,
    /// Microlenses per pupil cell along this axis, with the sign of its direction.
    pub lenses_per_cell: f64,
    /// How much the phase grows from a microlens to the next, in pixels; whole ones do not count.
    pub phase_step_px: f64,
    pub depths: Nodes,
    /// From the pair's first voxel to its second, in microlenses for a ray map with b = 1; 0 where
    /// single voxels are tabulated.
    pub pair_step: f64,
    pub footprint_mm: f64,
    pub blur: Blur,
    /// The largest |U − ξ| of any ray, in mm.
    pub most_lean_mm: f64,
}

/// Shares of pairs of voxels, in the order lean, depth, phase, place.
#[derive(Debug)]
pub(super) struct ShareTable<const L: usize> {
    pub layout: TableLayout,
    pub taps: Vec<PairTap<L>>,
}

/// How a table is addressed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TableLayout {
    pub places: usize,
    pub depths: Nodes,
    /// Place of node 0, in microlenses from the nearest one.
    pub first_place: f32,
    pub places_per_lens: f32,
    pub leans_per_mm: f32,
}

impl FootprintGeometry {
    fn layout(&self) -> TableLayout {
        let deepest = [self.depths.at(0), self.depths.at(self.depths.count - 1)];
        let parallax = deepest.map(|depth| RayMap::at_depth(&self.optics, depth).pupil.abs());
        // The nearest microlens is found without its phase, of up to half a cell along each axis.
        let beyond = parallax[0].max(parallax[1]) * self.lenses_per_cell.abs() * 0.6;
        let first_place = -0.5 - beyond;
        TableLayout {
            places: (-2.0 * first_place * PLACES_PER_LENS).ceil() as usize + 2,
            depths: self.depths,
            first_place: first_place as f32,
            places_per_lens: PLACES_PER_LENS as f32,
            leans_per_mm: ((LEANS - 1) as f64 / self.most_lean_mm) as f32,
        }
    }

    /// The shadow of a voxel at a depth whose rays lean so far: see
    /// [`crate::model::tables::AxisGeometry`].
    pub fn shadow(&self, map: RayMap, lean_mm: f64) -> Trapezoid {
        let per_depth = map.position * map.position / self.optics.image_distance_mm();
        let mut widths = [
            map.pupil.abs() * self.blur.pupil_mm,
            map.position.abs() * self.footprint_mm,
            per_depth * lean_mm * self.footprint_mm,
            self.blur.plane_mm,
        ];
        widths.sort_unstable_by(f64::total_cmp);
        let narrow = widths[..3].iter().map(|width| width * width).sum::<f64>().sqrt();
        Trapezoid::new(widths[3], narrow)
    }

    /// How far the pupil interval of a microlens lies from the nearest one's, in cells, where that has
    /// a phase of `phase` and `n` microlenses lie between.
    pub fn further_phase(&self, phase: f64, n: i32) -> f64 {
        let next = phase + f64::from(n) * self.phase_step_px;
        next - (next + 0.5 + TIE_PX).floor() - phase
    }

    /// The share of a voxel's light that microlens `n` receives, counted from the nearest one, of
    /// which the voxel lies `place` microlenses off.
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

    /// Middle of a class of phases.
    pub fn phase_of(class: usize) -> f64 {
        (class as f64 + 0.5) / PHASES as f64 - 0.5
    }

    /// The tap of a pair whose middle lies `place` microlenses off the nearest one; `None` where it
    /// reaches more than `L`.
    fn tap<const L: usize>(
        &self,
        map: RayMap,
        shadow: &Trapezoid,
        phase: f64,
        place: f64,
    ) -> Option<PairTap<L>> {
        let half_step = map.position * self.pair_step / 2.0;
        let reach = (place.abs() + half_step.abs()).ceil() as i32 + 2 * L as i32;
        let units = |n: i32| -> [u16; 2] {
            [-half_step, half_step].map(|step| {
                let share = self.share(map, shadow, phase, place + step, n);
                (share / f64::from(SHARE_UNIT) + 0.5) as u16
            })
        };
        let nearest = place.round() as i32;
        let mut lit = (nearest - reach..=nearest + reach).filter(|&n| units(n) != [0; 2]);
        let Some(first) = lit.next() else {
            return Some(PairTap { first: FIRST_BIAS as u16, ..PairTap::NONE });
        };
        let last = lit.next_back().unwrap_or(first);
        let len = usize::try_from(last - first + 1).ok().filter(|&len| len <= L)?;
        let units = |n: usize| if n < len { units(first + n as i32) } else { [0; 2] };
        let pairs: [[u16; 2]; L] = std::array::from_fn(units);
        let shares = [0, 1].map(|child| pairs.map(|pair| pair[child]));
        let first = u16::try_from(first + FIRST_BIAS).ok()?;
        Some(PairTap { shares, first, len: len as u16 })
    }
}

impl TableLayout {
    /// Number of the first tap of a depth, for the least lean.
    pub fn of_depth(&self, depth_mm: f64) -> usize {
        self.depths.nearest(depth_mm) * PHASES * self.places
    }

    /// Taps of one lean.
    pub fn per_lean(&self) -> usize {
        self.depths.count * PHASES * self.places
    }
}

impl<const L: usize> ShareTable<L> {
    /// `None` when a pair reaches more than `L` microlenses.
    pub fn new(geometry: &FootprintGeometry) -> Option<Self> {
        let layout = geometry.layout();
        let (places, depths) = (layout.places, layout.depths.count);
        let row = |n: usize| -> Option<Vec<PairTap<L>>> {
            let (lean, depth, phase) = (n / (depths * PHASES), n / PHASES % depths, n % PHASES);
            let map = RayMap::at_depth(&geometry.optics, layout.depths.at(depth));
            let lean_mm = lean as f64 / f64::from(layout.leans_per_mm);
            let shadow = geometry.shadow(map, lean_mm);
            let phase = FootprintGeometry::phase_of(phase);
            let place = |n: usize| f64::from(layout.first_place) + n as f64 / PLACES_PER_LENS;
            (0..places).map(|n| geometry.tap(map, &shadow, phase, place(n))).collect()
        };
        let rows: Option<Vec<_>> = (0..LEANS * depths * PHASES).into_par_iter().map(row).collect();
        Some(Self { layout, taps: rows?.concat() })
    }

    #[inline(always)]
    pub fn tap(&self, at: usize) -> &PairTap<L> {
        &self.taps[at]
    }

    pub fn memory_bytes(&self) -> usize {
        size_of_val(self.taps.as_slice())
    }
}
