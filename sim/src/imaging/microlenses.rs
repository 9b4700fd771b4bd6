//! The microlens array and its position on the sensor.

use std::collections::HashSet;

use lfpiv_hw::MicrolensArray;
use rand::RngExt;

use super::{cells::Cells, flaws::CameraFlaws};
use crate::stream::{Purpose, random_stream};

/// A grid of microlenses in the array's own axes.
#[derive(Debug, Clone)]
pub(super) struct Microlenses {
    columns: Cells,
    rows: Cells,
    /// Number of microlenses along each axis.
    counts: [usize; 2],
    pitch_mm: [f64; 2],
    /// Centre of microlens (0, 0) in the array's axes.
    first_mm: [f64; 2],
    /// Position of the array on the sensor; `None` if nominal.
    placement: Option<Placement>,
    /// Whether each microlens is opaque, row by row; empty if none is.
    dead: Vec<bool>,
}

/// The array's axes on the sensor.
#[derive(Debug, Clone)]
struct Placement {
    centre_mm: [f64; 2],
    cosine: f64,
    sine: f64,
}

impl Placement {
    #[inline]
    fn to_array(&self, sensor_mm: [f64; 2]) -> [f64; 2] {
        let x = sensor_mm[0] - self.centre_mm[0];
        let y = sensor_mm[1] - self.centre_mm[1];
        [self.cosine * x + self.sine * y, self.cosine * y - self.sine * x]
    }

    #[inline]
    fn to_sensor(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [
            self.centre_mm[0] + self.cosine * x - self.sine * y,
            self.centre_mm[1] + self.sine * x + self.cosine * y,
        ]
    }
}

impl Microlenses {
    pub(super) fn new(array: &MicrolensArray, flaws: &CameraFlaws) -> Self {
        let pitch_mm = flaws.array_pitch_scale.map(|scale| scale * array.pitch_mm);
        let counts = [array.columns, array.rows];
        let aligned = flaws.array_rotation_deg == 0.0 && flaws.array_shift_mm == [0.0; 2];
        let (sine, cosine) = flaws.array_rotation_deg.to_radians().sin_cos();
        Self {
            columns: Cells::new(pitch_mm[0], array.columns),
            rows: Cells::new(pitch_mm[1], array.rows),
            counts,
            pitch_mm,
            first_mm: std::array::from_fn(|axis| {
                -(counts[axis] as f64 - 1.0) / 2.0 * pitch_mm[axis]
            }),
            placement: (!aligned).then_some(Placement {
                centre_mm: flaws.array_shift_mm,
                cosine,
                sine,
            }),
            dead: dead_microlenses(counts, flaws),
        }
    }

    /// Centre of the microlens that is nearest along the array's axes, in mm along the sensor's
    /// axes. `None` outside the array and for an opaque microlens.
    #[inline]
    pub(super) fn nearest_centre_mm(&self, plane_mm: [f64; 2]) -> Option<[f64; 2]> {
        let array_mm = match &self.placement {
            None => plane_mm,
            Some(placement) => placement.to_array(plane_mm),
        };
        let lens = [self.columns.nearest(array_mm[0])?, self.rows.nearest(array_mm[1])?];
        if !self.dead.is_empty() && self.dead[lens[1] as usize * self.counts[0] + lens[0] as usize]
        {
            return None;
        }
        Some(self.place_mm(lens.map(f64::from)))
    }

    /// Converts a position in units of microlenses, whose centres are at integers, to the sensor's
    /// axes, in mm.
    #[inline]
    pub(super) fn place_mm(&self, lens: [f64; 2]) -> [f64; 2] {
        let array_mm: [f64; 2] =
            std::array::from_fn(|axis| self.first_mm[axis] + lens[axis] * self.pitch_mm[axis]);
        match &self.placement {
            None => array_mm,
            Some(placement) => placement.to_sensor(array_mm),
        }
    }

    /// Number of microlenses along the array's axes.
    pub(super) fn counts(&self) -> [usize; 2] {
        self.counts
    }
}

fn dead_microlenses([columns, rows]: [usize; 2], flaws: &CameraFlaws) -> Vec<bool> {
    let all = columns * rows;
    let count = flaws.dead_microlenses.min(all);
    if count == 0 {
        return Vec::new();
    }
    let mut rng = random_stream(Purpose::DeadMicrolenses, &[flaws.blemish_seed]);
    let mut chosen = HashSet::new();
    while chosen.len() < count {
        chosen.insert(rng.random_range(0..all));
    }
    (0..all).map(|lens| chosen.contains(&lens)).collect()
}
