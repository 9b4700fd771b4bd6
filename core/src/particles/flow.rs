//! Where the flow takes particles between the frames.

use super::neighbours::Neighbours;
use crate::statistics::median;

/// Displacement from frame a to frame b of the particle that is at a place, in mm, in the middle of the
/// pair, in mm.
pub type Flow<'a> = &'a (dyn Fn([f64; 3]) -> [f64; 3] + Sync);

/// Rounds in which the middle of a path is found.
const ROUNDS: usize = 3;

/// Particles whose median corrects the flow at a place: a sphere holds so many on average.
const PARTICLES_ABOUT: f64 = 14.0;

/// Fewer say nothing.
const LEAST_PARTICLES: usize = 5;

/// Where a particle of frame a (`sign` 1) or b (−1) is in the middle of the pair.
pub fn middle(at_mm: [f64; 3], flow: Flow<'_>, sign: f64) -> [f64; 3] {
    let mut middle = at_mm;
    for _ in 0..ROUNDS {
        let moved = flow(middle);
        middle = std::array::from_fn(|axis| at_mm[axis] + sign * moved[axis] / 2.0);
    }
    middle
}

/// What particles that are known in both frames say the flow misses, about any place.
///
/// What correlation knows of a rough flow is a voxel's part off; particles about a place have that in
/// common. The median over them is not drawn aside by those that are taken for others.
pub struct FlowCorrection {
    middles: Vec<[f32; 3]>,
    missed_mm: Vec<[f64; 3]>,
    reach: f32,
    voxel_mm: f64,
}

impl FlowCorrection {
    /// Of pairs: where they are in the middle, in voxels, and their displacement less that of the flow, in
    /// mm. `density` is the number of pairs per voxel.
    pub fn new(
        middles: Vec<[f32; 3]>,
        missed_mm: Vec<[f64; 3]>,
        density: f64,
        voxel_mm: f64,
    ) -> Self {
        let sphere = 4.0 / 3.0 * std::f64::consts::PI;
        let reach = (PARTICLES_ABOUT / (sphere * density.max(1e-9))).cbrt();
        Self { middles, missed_mm, reach: reach as f32, voxel_mm }
    }

    /// The correction ready to be asked.
    pub fn ready(&self) -> impl Fn([f64; 3]) -> [f64; 3] + Sync + '_ {
        let near = Neighbours::new(&self.middles, self.reach);
        move |at_mm| {
            let mut about = Vec::new();
            let at = at_mm.map(|mm| (mm / self.voxel_mm) as f32);
            near.visit(at, |n, _| about.push(n));
            if about.len() < LEAST_PARTICLES {
                return [0.0; 3];
            }
            std::array::from_fn(|axis| {
                median(about.iter().map(|&n| self.missed_mm[n][axis])).unwrap_or_default()
            })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middle_of_a_path_is_met_from_both_ends() {
        let flow = |at: [f64; 3]| [0.2 + 0.05 * at[1], -0.1 * at[0], 0.03];
        let at_mm = [1.0, -2.0, 0.5];
        let moved = flow(at_mm);
        for (sign, end) in [(1.0, -0.5), (-1.0, 0.5)] {
            let start = std::array::from_fn(|axis| at_mm[axis] + end * moved[axis]);
            let found = middle(start, &flow, sign);
            assert!((0..3).all(|axis| (found[axis] - at_mm[axis]).abs() < 1e-5), "{found:?}");
        }
    }

    #[test]
    fn a_correction_is_what_most_particles_about_a_place_miss() {
        let place = |n: usize| [n % 6, n / 6 % 6, n / 36].map(|i| i as f32 * 3.0);
        let middles: Vec<[f32; 3]> = (0..216).map(place).collect();
        // One in nine is taken for another.
        let missed = |n: usize| if n.is_multiple_of(9) { [1.0; 3] } else { [0.02, -0.03, 0.0] };
        let missed_mm = (0..216).map(missed).collect();
        let correction = FlowCorrection::new(middles, missed_mm, 1.0 / 27.0, 0.1);
        let correction = correction.ready();
        assert_eq!(correction([0.7, 0.8, 0.75]), [0.02, -0.03, 0.0]);
        assert_eq!(correction([90.0, 0.0, 0.0]), [0.0; 3]);
    }
}
