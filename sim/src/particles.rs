//! Where the tracer particles are, when, and how bright.

use std::ops::RangeInclusive;

use rand::{Rng, RngExt, seq::index};
use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use crate::{
    flow::Flow,
    geometry::{EmptySpace, Volume},
    stream::{Purpose, random_stream},
};

/// Where particles sit in the middle of the pulse pair.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Placement {
    /// Anywhere, as real particles do.
    #[default]
    OffGrid,
    /// On distinct voxel centres, as the paper's numerical particles. With a flow they sit there
    /// in the middle of the pair only; without one, in both frames.
    OnGrid,
}

/// How many particles, where and how bright.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Seeding {
    /// Particles per microlens: see [`Seeding::count_in_volume`].
    pub ppm: f64,
    /// On or off the voxel grid.
    pub placement: Placement,
    /// Half-width s of the uniform distribution of relative brightness on [1 − s, 1 + s].
    pub intensity_spread: f64,
    /// Edge lengths (x, y, z) of the lit box, centred on the volume, in mm; the volume's own
    /// extents when absent.
    pub sheet_mm: Option<[f64; 3]>,
    /// Where there are none.
    #[serde(skip)]
    pub empty: Option<EmptySpace>,
}

/// A frame of a pulse pair.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum FrameOfPair {
    /// Exposure 1, half a pulse separation before the middle.
    A,
    /// Exposure 2, half a pulse separation after it.
    B,
}

/// One particle of one shot.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Tracer {
    /// Position at the first pulse, in mm.
    pub a_mm: [f64; 3],
    /// Position in the middle of the pair, in mm.
    pub mid_mm: [f64; 3],
    /// Position at the second pulse, in mm.
    pub b_mm: [f64; 3],
    /// Brightness relative to the mean particle.
    pub intensity: f64,
    /// Whether it is seen at the first pulse: inside the light sheet, and not inside a body.
    pub visible_a: bool,
    /// Whether it is seen at the second pulse.
    pub visible_b: bool,
}

impl Tracer {
    /// Position in one frame, in mm, or `None` where the light sheet misses it.
    pub fn lit_mm(&self, frame: FrameOfPair) -> Option<[f64; 3]> {
        match frame {
            FrameOfPair::A => self.visible_a.then_some(self.a_mm),
            FrameOfPair::B => self.visible_b.then_some(self.b_mm),
        }
    }
}

/// A box with edges along the world axes, in mm.
#[derive(Debug, Clone, PartialEq)]
struct AlignedBox {
    centre_mm: [f64; 3],
    extents_mm: [f64; 3],
}

impl AlignedBox {
    fn contains(&self, position_mm: [f64; 3]) -> bool {
        (0..3).all(|axis| {
            (position_mm[axis] - self.centre_mm[axis]).abs() <= self.extents_mm[axis] / 2.0
        })
    }

    fn volume_mm3(&self) -> f64 {
        self.extents_mm.iter().product()
    }

    fn grown(&self, margin_mm: [f64; 3]) -> Self {
        let extents_mm = std::array::from_fn(|axis| self.extents_mm[axis] + 2.0 * margin_mm[axis]);
        Self { centre_mm: self.centre_mm, extents_mm }
    }

    /// The point at fractions 0 to 1 of each edge.
    fn at(&self, fractions: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|axis| {
            self.centre_mm[axis] + (fractions[axis] - 0.5) * self.extents_mm[axis]
        })
    }
}

impl Seeding {
    /// Mean number of particles inside the volume: ppm × microlenses that the volume's x-y face
    /// covers, with microlenses of `object_pitch_mm` (microlens pitch over |magnification|).
    /// 1 ppm over a 10 mm × 10 mm face of 0.1 mm microlenses is 10,000.
    pub fn count_in_volume(&self, volume: &Volume, object_pitch_mm: f64) -> f64 {
        let [x_mm, y_mm, _] = volume.extents_mm();
        self.ppm * (x_mm / object_pitch_mm) * (y_mm / object_pitch_mm)
    }

    /// Number of particles that [`Seeding::particles`] draws, before those that are never lit
    /// are dropped.
    pub fn drawn(&self, volume: &Volume, object_pitch_mm: f64, flow: &Flow, dt_s: f64) -> f64 {
        let region = self.region(volume, flow, dt_s);
        self.density_per_mm3(volume, object_pitch_mm) * region.volume_mm3()
    }

    /// The particles of one shot that are lit in at least one frame; the same for the same
    /// `(seed, shot)`.
    ///
    /// The number density is that of ppm inside the volume, whatever the size of the light
    /// sheet. Seeding reaches beyond the sheet by as far as the flow carries particles in half a
    /// pulse separation, so that particles enter and leave it and both frames have the full
    /// density up to the sheet's edges. Without flow the number is exactly that of ppm.
    pub fn particles(
        &self,
        volume: &Volume,
        object_pitch_mm: f64,
        flow: &Flow,
        dt_s: f64,
        (seed, shot): (u64, u64),
    ) -> Vec<Tracer> {
        let mut particles = self.all_particles(volume, object_pitch_mm, flow, dt_s, (seed, shot));
        particles.retain(|particle| particle.visible_a || particle.visible_b);
        particles
    }

    /// As [`Seeding::particles`], with those that are lit in neither frame.
    pub(crate) fn all_particles(
        &self,
        volume: &Volume,
        object_pitch_mm: f64,
        flow: &Flow,
        dt_s: f64,
        (seed, shot): (u64, u64),
    ) -> Vec<Tracer> {
        let sheet = self.sheet(volume);
        let region = self.region(volume, flow, dt_s);
        let density_per_mm3 = self.density_per_mm3(volume, object_pitch_mm);
        let mut rng = random_stream(Purpose::Seeding, &[seed, shot]);
        let middles = match self.placement {
            Placement::OffGrid => anywhere(&mut rng, &region, density_per_mm3),
            Placement::OnGrid => voxel_centres(&mut rng, volume, &region, density_per_mm3),
        };
        let spread = self.intensity_spread;
        let placed: Vec<([f64; 3], f64)> = middles
            .into_iter()
            .map(|mid_mm| (mid_mm, 1.0 + spread * rng.random_range(-1.0..=1.0)))
            .collect();
        placed
            .into_par_iter()
            .map(|(mid_mm, intensity)| self.particle(mid_mm, intensity, &sheet, flow, dt_s))
            .collect()
    }

    /// Where a particle is `at_s` after the middle of the pair, in mm; `None` where the light
    /// sheet misses it then.
    pub(crate) fn lit_mm(
        &self,
        particle: &Tracer,
        volume: &Volume,
        flow: &Flow,
        at_s: f64,
    ) -> Option<[f64; 3]> {
        let position_mm = flow.advect_mm(particle.mid_mm, at_s);
        self.is_seen(&self.sheet(volume), position_mm).then_some(position_mm)
    }

    /// Whether a particle is seen at a place (mm): in the light, and not where there are none.
    fn is_seen(&self, sheet: &AlignedBox, at_mm: [f64; 3]) -> bool {
        sheet.contains(at_mm) && !self.empty.as_ref().is_some_and(|empty| empty.contains(at_mm))
    }

    fn particle(
        &self,
        mid_mm: [f64; 3],
        intensity: f64,
        sheet: &AlignedBox,
        flow: &Flow,
        dt_s: f64,
    ) -> Tracer {
        let a_mm = flow.advect_mm(mid_mm, -dt_s / 2.0);
        let b_mm = flow.advect_mm(mid_mm, dt_s / 2.0);
        let (visible_a, visible_b) = (self.is_seen(sheet, a_mm), self.is_seen(sheet, b_mm));
        Tracer { a_mm, mid_mm, b_mm, intensity, visible_a, visible_b }
    }

    fn sheet(&self, volume: &Volume) -> AlignedBox {
        AlignedBox {
            centre_mm: volume.centre_mm,
            extents_mm: self.sheet_mm.unwrap_or_else(|| volume.extents_mm()),
        }
    }

    /// Where particles are in the middle of the pair that are in the sheet before or after it.
    fn region(&self, volume: &Volume, flow: &Flow, dt_s: f64) -> AlignedBox {
        let sheet = self.sheet(volume);
        sheet.grown(reach_mm(&sheet, flow, dt_s))
    }

    /// Zero in a volume without voxels.
    fn density_per_mm3(&self, volume: &Volume, object_pitch_mm: f64) -> f64 {
        let volume_mm3: f64 = volume.extents_mm().iter().product();
        if volume_mm3 > 0.0 {
            self.count_in_volume(volume, object_pitch_mm) / volume_mm3
        } else {
            0.0
        }
    }
}

/// How far the flow carries any particle of the sheet along each axis in half a pulse separation,
/// in mm: the largest on a grid of points, and a tenth more for what the grid misses. At most
/// the sheet's own extents: no pair of frames can be matched across more.
fn reach_mm(sheet: &AlignedBox, flow: &Flow, dt_s: f64) -> [f64; 3] {
    const POINTS: usize = 13;
    let fraction = |index: usize| index as f64 / (POINTS - 1) as f64;
    let mut reach_mm = [0.0_f64; 3];
    for point in 0..POINTS.pow(3) {
        let start = sheet.at([
            fraction(point % POINTS),
            fraction(point / POINTS % POINTS),
            fraction(point / POINTS / POINTS),
        ]);
        for half_s in [-dt_s / 2.0, dt_s / 2.0] {
            let end = flow.advect_mm(start, half_s);
            for axis in 0..3 {
                reach_mm[axis] = reach_mm[axis].max(1.1 * (end[axis] - start[axis]).abs());
            }
        }
    }
    std::array::from_fn(|axis| reach_mm[axis].min(sheet.extents_mm[axis]))
}

/// Points uniform in `region`.
fn anywhere(rng: &mut impl Rng, region: &AlignedBox, density_per_mm3: f64) -> Vec<[f64; 3]> {
    let count = (density_per_mm3 * region.volume_mm3()).round() as usize;
    (0..count).map(|_| region.at(std::array::from_fn(|_| rng.random()))).collect()
}

/// Distinct centres, in random order, of the volume's voxel grid continued through `region`; all
/// of them where the density asks for more.
fn voxel_centres(
    rng: &mut impl Rng,
    volume: &Volume,
    region: &AlignedBox,
    density_per_mm3: f64,
) -> Vec<[f64; 3]> {
    let indices: [RangeInclusive<i64>; 3] = std::array::from_fn(|axis| {
        let middle = (volume.voxels[axis] as f64 - 1.0) / 2.0;
        let half = region.extents_mm[axis] / 2.0 / volume.voxel_mm;
        // A centre on the region's very edge belongs to it, whatever the rounding.
        (middle - half - 1e-9).ceil() as i64..=(middle + half + 1e-9).floor() as i64
    });
    let counts = indices.clone().map(|range| range.count());
    let available: usize = counts.iter().product();
    let count = (density_per_mm3 * available as f64 * volume.voxel_mm.powi(3)).round() as usize;
    index::sample(rng, available, count.min(available))
        .into_iter()
        .map(|voxel| {
            let offsets = [voxel % counts[0], voxel / counts[0] % counts[1]];
            let offsets = [offsets[0], offsets[1], voxel / counts[0] / counts[1]];
            std::array::from_fn(|axis| {
                let index = (indices[axis].start() + offsets[axis] as i64) as f64;
                let middle = (volume.voxels[axis] as f64 - 1.0) / 2.0;
                volume.centre_mm[axis] + (index - middle) * volume.voxel_mm
            })
        })
        .collect()
}

#[cfg(test)]
mod tests;
