//! Support of a voxel's light on the microlenses at one depth.

use super::share_table::FootprintGeometry;
use crate::model::{
    SUPPORT_SHARE,
    footprint::{RayMap, Trapezoid},
    tables::MIN_VISIBLE_SHARE,
};

/// Bisection steps.
const HALVINGS: usize = 24;

/// Positions around the middle of a gap between two microlenses at which a view contains too little of a
/// voxel's light ([`MIN_VISIBLE_SHARE`]), in microlenses.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct GapZone {
    /// Width of the narrowest gap with such positions; infinite if there are none.
    pub least: f64,
    /// Half width of the zone for that gap, and its increase with the gap's width.
    pub half: f64,
    pub half_per_gap: f64,
}

/// Along columns and rows, in microlenses.
#[derive(Debug, Clone, Copy)]
pub(super) struct Support {
    /// Largest distance of a voxel's position from the microlenses of its support.
    pub reach: [f64; 2],
    /// Largest displacement by phases.
    pub phase: [f64; 2],
    /// Width of a microlens for the rays of one view.
    pub lens_width: f64,
    /// Zones where gaps between microlenses hide too much of a voxel.
    pub gaps: [GapZone; 2],
}

impl Support {
    /// For voxels at the depths of columns and rows; `lenses_per_cell` gives the range of phases.
    pub fn new(
        geometries: &[FootprintGeometry; 2],
        depth_mm: [f64; 2],
        lenses_per_cell: [[f64; 2]; 2],
    ) -> Self {
        let maps = [0, 1].map(|n| RayMap::at_depth(&geometries[n].optics, depth_mm[n]));
        let shadows = [0, 1].map(|n| {
            let geometry = &geometries[n];
            geometry.shadow(maps[n], geometry.max_slope_mm / 2.0)
        });
        let cell = [0, 1].map(|n| {
            let [by_right, by_up] = lenses_per_cell[n];
            maps[n].pupil.abs() * (by_right.abs() + by_up.abs())
        });
        let reach = [0, 1].map(|n| {
            let geometry = &geometries[n];
            let widest = (maps[n].spread() * geometry.pitch_mm + shadows[n].width()) / 2.0;
            let share = |place: f64| geometry.share(maps[n], &shadows[n], 0.0, place, 0);
            let lit = |place: f64| share(place) > f64::from(SUPPORT_SHARE);
            last_in(0.0, widest / geometry.pitch_mm, lit)
        });
        let lens_width = (maps[0].spread() + maps[1].spread()) / 2.0;
        let gaps = [0, 1].map(|n| {
            let widest = 1.0 - lens_width + cell[n];
            GapZone::new(&shadows[n], geometries[n].pitch_mm, widest)
        });
        Self { reach, phase: cell.map(|cell| cell / 2.0), lens_width, gaps }
    }

    /// A support that contains both.
    pub fn union(&self, other: &Self) -> Self {
        let larger = |of: fn(&Self) -> [f64; 2]| [0, 1].map(|n| of(self)[n].max(of(other)[n]));
        Self {
            reach: larger(|support| support.reach),
            phase: larger(|support| support.phase),
            lens_width: self.lens_width.min(other.lens_width),
            gaps: [0, 1].map(|n| self.gaps[n].union(&other.gaps[n])),
        }
    }

    /// Whether phases can leave gaps that hide too much of a voxel.
    pub fn has_gaps(&self) -> bool {
        self.gaps.iter().any(|zone| zone.least.is_finite())
    }
}

impl GapZone {
    const NONE: Self = Self { least: f64::INFINITY, half: 0.0, half_per_gap: 0.0 };

    /// A zone that contains both.
    fn union(&self, other: &Self) -> Self {
        Self {
            least: self.least.min(other.least),
            half: self.half.max(other.half),
            half_per_gap: self.half_per_gap.max(other.half_per_gap),
        }
    }

    /// For voxels with this shadow and gaps of at most `widest` microlenses.
    fn new(shadow: &Trapezoid, pitch_mm: f64, widest: f64) -> Self {
        // Share of a voxel that a gap hides, at a distance of `beside` microlenses from its middle.
        let hidden = |gap: f64, beside: f64| {
            let below = |lenses: f64| shadow.below(lenses * pitch_mm);
            below(beside + gap / 2.0) - below(beside - gap / 2.0)
        };
        let too_much =
            |gap: f64, beside: f64| hidden(gap, beside) > f64::from(1.0 - MIN_VISIBLE_SHARE);
        if !too_much(widest, 0.0) {
            return Self::NONE;
        }
        let least = last_in(0.0, widest, |gap| !too_much(gap, 0.0));
        let farthest = widest + shadow.width() / pitch_mm;
        let half = |gap: f64| last_in(0.0, farthest, |beside| too_much(gap, beside));
        // Slightly wider than the narrowest gap, in which a uniform shadow is hidden equally at many positions.
        let slightly = least + 0.02 * (widest - least);
        let (first, last) = (half(slightly), half(widest));
        let half_per_gap = (last - first) / (widest - slightly).max(1e-12);
        Self { least, half: first, half_per_gap }
    }
}

/// The largest value between `low` and `high` for which a monotonic condition holds.
fn last_in(low: f64, high: f64, holds: impl Fn(f64) -> bool) -> f64 {
    let (mut inside, mut outside) = (low, high);
    for _ in 0..HALVINGS {
        let middle = (inside + outside) / 2.0;
        *(if holds(middle) { &mut inside } else { &mut outside }) = middle;
    }
    outside
}
