//! The taps of a whole row of voxel pairs: one view index, one depth, every position.
//!
//! [`pair_tap`] defines a single tap. Here the same operations run in the same order over all
//! positions in parallel, so that they become vector instructions with bit-identical results.

use multiversion::multiversion;

use super::pair_tap::{PairTap, SHARE_UNIT, first_of_pair, pair_tap};
use crate::model::{
    footprint::{POINT_WIDTH, RayMap, STEP_WIDTH_MM},
    tables::AxisGeometry,
};

/// The row of one table being computed, with its scratch memory.
pub(super) struct RowShares<'a> {
    geometry: &'a AxisGeometry<'a>,
    lenses: Vec<Lens>,
    shadows: Shadows,
    offsets_mm: Vec<f64>,
    units: Vec<i32>,
}

/// Parameters of a microlens of the window for a row.
#[derive(Debug, Clone, Copy)]
struct Lens {
    /// Its centre, in mm.
    centre_mm: f64,
    /// Where rays from ξ = 0 to its pixel of this view meet the microlens plane, in mm; infinite if
    /// it has no pixel for the view.
    pupil_on_plane_mm: f64,
}

/// The trapezoids of a row's voxels, as in [`crate::model::footprint::Trapezoid`].
#[derive(Debug, Default)]
struct Shadows {
    /// Where the ray through the pupil's centre meets the microlens plane.
    on_plane_mm: Vec<f64>,
    half_sum_mm: Vec<f64>,
    half_difference_mm: Vec<f64>,
    scale: Vec<f64>,
    /// First microlens reached, relative to the array.
    first: Vec<f64>,
}

/// Parameters common to all voxels of a row.
#[derive(Debug, Clone, Copy)]
struct RowOptics {
    map: RayMap,
    pitch_mm: f64,
    middle: f64,
    pupil_mm: f64,
    /// Widths that do not depend on the position, ascending.
    widths_mm: [f64; 3],
    footprint_mm: f64,
    per_depth: f64,
    phase_mm: f64,
    half_lens_mm: f64,
}

impl<'a> RowShares<'a> {
    pub fn new(geometry: &'a AxisGeometry<'a>) -> Self {
        let positions = 2 * geometry.positions.count.div_ceil(2);
        let zeros = || vec![0.0; positions];
        let shadows = Shadows {
            on_plane_mm: zeros(),
            half_sum_mm: zeros(),
            half_difference_mm: zeros(),
            scale: zeros(),
            first: zeros(),
        };
        Self {
            geometry,
            lenses: Vec::new(),
            shadows,
            offsets_mm: zeros(),
            units: vec![0; positions],
        }
    }

    /// Appends the taps of view index `k` at depth node `depth`.
    pub fn push_taps<const L: usize>(&mut self, k: i32, depth: usize, taps: &mut Vec<PairTap<L>>) {
        let geometry = self.geometry;
        let map = RayMap::at_depth(geometry.optics, geometry.depths.at(depth));
        let optics = RowOptics::new(geometry, map, k);
        let nodes = geometry.positions;
        if !cast_shadows(&optics, nodes.first_mm, nodes.step_mm, &mut self.shadows) {
            // Shadows without a second width have their own formula.
            let pairs = 0..nodes.count.div_ceil(2);
            taps.extend(pairs.map(|pair| pair_tap(geometry, map, k, pair)));
            return;
        }
        let start = taps.len();
        taps.extend(self.shadows.first.chunks_exact(2).map(|first| {
            let first = first_of_pair::<L>(geometry, first[0].min(first[1]) as i64);
            PairTap { first: (first - geometry.window.start) as u16, ..PairTap::NONE }
        }));
        let taps = &mut taps[start..];
        self.place_lenses::<L>(&optics, k);
        for n in 0..L {
            for (pair, tap) in taps.iter().enumerate() {
                let lens = self.lenses[usize::from(tap.first) + n];
                for voxel in [2 * pair, 2 * pair + 1] {
                    let centre_mm = lens.pupil_on_plane_mm + self.shadows.on_plane_mm[voxel];
                    self.offsets_mm[voxel] = lens.centre_mm - centre_mm;
                }
            }
            measure_shares(&optics, &self.shadows, &self.offsets_mm, &mut self.units);
            for (tap, units) in taps.iter_mut().zip(self.units.chunks_exact(2)) {
                tap.shares[0][n] = units[0] as u16;
                tap.shares[1][n] = units[1] as u16;
                if units[0] > 0 || units[1] > 0 {
                    tap.len = n as u16 + 1;
                }
            }
        }
    }

    /// The window's microlenses in view `k`, followed by `L` without a pixel.
    fn place_lenses<const L: usize>(&mut self, optics: &RowOptics, k: i32) {
        let window = &self.geometry.window;
        self.lenses.clear();
        self.lenses.extend((window.start..window.end + L).map(|i| {
            let sample = if i < window.end { self.geometry.sampling.sample(k, i) } else { None };
            Lens {
                centre_mm: (i as f64 - optics.middle) * optics.pitch_mm,
                pupil_on_plane_mm: sample
                    .map_or(f64::INFINITY, |sample| optics.map.pupil * sample.pupil_mm),
            }
        }));
    }
}

impl RowOptics {
    fn new(geometry: &AxisGeometry<'_>, map: RayMap, k: i32) -> Self {
        let optics = geometry.optics;
        let pitch_mm = optics.microlens.pitch_mm;
        let mut widths_mm = [
            map.pupil.abs() * geometry.blur.pupil_mm,
            map.position.abs() * geometry.footprint_mm,
            geometry.blur.plane_mm,
        ];
        widths_mm.sort_unstable_by(f64::total_cmp);
        Self {
            map,
            pitch_mm,
            middle: (geometry.sampling.microlenses as f64 - 1.0) / 2.0,
            pupil_mm: f64::from(k) * geometry.sampling.cell_mm,
            widths_mm,
            footprint_mm: geometry.footprint_mm,
            per_depth: map.position * map.position / optics.image_distance_mm(),
            phase_mm: map.pupil.abs() * geometry.sampling.cell_mm / 2.0,
            half_lens_mm: map.spread() * pitch_mm / 2.0,
        }
    }
}

/// The shadows of voxels at `first_mm + n·step_mm`. Returns whether all of them have two widths.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn cast_shadows(optics: &RowOptics, first_mm: f64, step_mm: f64, shadows: &mut Shadows) -> bool {
    let count = shadows.first.len();
    let on_plane_mm = &mut shadows.on_plane_mm[..count];
    let half_sum_mm = &mut shadows.half_sum_mm[..count];
    let half_difference_mm = &mut shadows.half_difference_mm[..count];
    let scale = &mut shadows.scale[..count];
    let first = &mut shadows.first[..count];
    let [a, b, c] = optics.widths_mm;
    let pupil_on_plane_mm = optics.map.pupil * optics.pupil_mm;
    let mut least_share = f64::INFINITY;
    for n in 0..count {
        let position_mm = first_mm + f64::from(n as u32) * step_mm;
        let slant_mm = (optics.pupil_mm - position_mm).abs();
        let slanted = optics.per_depth * slant_mm * optics.footprint_mm;
        // The four widths, ascending.
        let (w0, rest) = (a.min(slanted), a.max(slanted));
        let (w1, rest) = (b.min(rest), b.max(rest));
        let (w2, w3) = (c.min(rest), c.max(rest));
        let joined = (w0 * w0 + w1 * w1 + w2 * w2).sqrt();
        let (wide, narrow) = (w3.max(joined).max(STEP_WIDTH_MM), w3.min(joined));
        least_share = least_share.min(narrow / wide);
        on_plane_mm[n] = optics.map.position * position_mm;
        half_sum_mm[n] = (wide + narrow) / 2.0;
        half_difference_mm[n] = (wide - narrow) / 2.0;
        scale[n] = 0.5 / (wide * narrow);
        let nominal_mm = pupil_on_plane_mm + on_plane_mm[n];
        let edge_mm = nominal_mm - optics.phase_mm - half_sum_mm[n] - optics.half_lens_mm;
        first[n] = (edge_mm / optics.pitch_mm + optics.middle).ceil();
    }
    least_share > 2.0 * POINT_WIDTH
}

/// The shares, in units of the tables, of microlenses at `offsets_mm` from the voxels' nominal
/// positions.
#[multiversion(targets("x86_64+avx512f+avx512vl", "x86_64+avx2"))]
fn measure_shares(optics: &RowOptics, shadows: &Shadows, offsets_mm: &[f64], units: &mut [i32]) {
    let count = units.len();
    let offsets_mm = &offsets_mm[..count];
    let half_sum_mm = &shadows.half_sum_mm[..count];
    let half_difference_mm = &shadows.half_difference_mm[..count];
    let scale = &shadows.scale[..count];
    let spread = optics.map.spread();
    let square = |t: f64| if t > 0.0 { t * t } else { 0.0 };
    let reached = |n: usize| offsets_mm[n].abs() < optics.half_lens_mm + half_sum_mm[n];
    let measure = |n: usize| {
        let (s, d) = (half_sum_mm[n], half_difference_mm[n]);
        // The trapezoid is symmetric: its upper half is 1 minus the lower one.
        let below = |t: f64| {
            let tail = (square(s - t.abs()) - square(d - t.abs())) * scale[n];
            let tail = tail.clamp(0.0, 1.0);
            if t <= 0.0 { tail } else { 1.0 - tail }
        };
        let (low, high) =
            (offsets_mm[n] - optics.half_lens_mm, offsets_mm[n] + optics.half_lens_mm);
        let share = (below(high) - below(low)) / spread;
        let share = if reached(n) { share } else { 0.0 };
        (share / f64::from(SHARE_UNIT) + 0.5).min(f64::from(u16::MAX)) as i32
    };
    for start in (0..count).step_by(NEIGHBOURS) {
        let end = count.min(start + NEIGHBOURS);
        // The last microlenses of a tap are rarely reached.
        let mut any = false;
        for n in start..end {
            any |= reached(n);
        }
        for (n, units) in (start..end).zip(&mut units[start..end]) {
            *units = if any { measure(n) } else { 0 };
        }
    }
}

/// Voxels that are checked together for whether a microlens receives any of their light.
const NEIGHBOURS: usize = 32;

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::{
        lightfield::AxisSampling,
        model::{ModelParts, tables::Nodes},
        test_bench,
    };

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]

        /// The naive reference: every tap separately, from the definition of a share.
        #[test]
        fn a_row_is_its_taps_one_by_one(
            first_mm in -7.0..7.0f64,
            step_mm in prop_oneof![0.01..0.1f64, -0.1..-0.01f64],
            count in 1usize..60,
            depth_mm in prop_oneof![Just(0.0), -8.0..8.0f64],
            footprint_mm in prop_oneof![Just(0.0), 0.01..0.1f64],
            pupil_blur in any::<bool>(),
            diffraction_nm in prop_oneof![Just(None), Just(Some(532.0))],
            k in -9i32..=9,
            window in prop_oneof![Just(0..129), Just(20..100), Just(60..63)],
        ) {
            let optics = test_bench::optics();
            let sampling = AxisSampling::columns(&optics);
            let parts = ModelParts { pupil_blur, diffraction_nm, ..ModelParts::default() };
            let geometry = AxisGeometry {
                optics: &optics,
                sampling: &sampling,
                window,
                positions: Nodes { first_mm, step_mm, count },
                depths: Nodes { first_mm: depth_mm, step_mm: 0.1, count: 1 },
                footprint_mm,
                blur: parts.blur(&optics),
            };
            let mut row = Vec::new();
            RowShares::new(&geometry).push_taps::<4>(k, 0, &mut row);
            let map = RayMap::at_depth(&optics, depth_mm);
            let single: Vec<PairTap<4>> =
                (0..count.div_ceil(2)).map(|pair| pair_tap(&geometry, map, k, pair)).collect();
            prop_assert_eq!(row, single);
        }
    }
}
