//! A field between its vectors, as a user gets it: by cubic convolution.

use lfpiv_core::velocimetry::{VectorStatus, VelocityField};
use lfpiv_sim::{Flow, flow::PlaneWave};

use crate::score::KnownFlow;

/// Places that the error between the vectors is a mean over.
const PLACES: usize = 4000;

/// How far inside the volume a wave's gain is taken, in voxels.
const GAIN_INSIDE_VOX: f64 = 12.0;

/// Mean |error| along x, y, z at places spread evenly between the vectors, in voxels: those of which every
/// vector about has a value. `None` where there is none.
pub fn error_between_vox(field: &VelocityField, truth: KnownFlow<'_>) -> Option<[f64; 3]> {
    let (mut sums, mut count) = ([0.0; 3], 0usize);
    for n in 0..PLACES {
        let share = spread(n);
        let at: [f64; 3] =
            std::array::from_fn(|axis| share[axis] * (field.grid.vectors[axis] - 1) as f64);
        let Some(found) = value_at(field, at) else { continue };
        let place_mm = std::array::from_fn(|axis| {
            field.grid.first_mm[axis] + at[axis] * field.grid.spacing_mm
        });
        let moved_mm = truth.displacement_mm(place_mm, field.dt_s);
        for axis in 0..3 {
            sums[axis] += (found[axis] - moved_mm[axis] / field.voxel_mm).abs();
        }
        count += 1;
    }
    (count > 0).then(|| sums.map(|sum| sum / count as f64))
}

/// What of a plane wave is in the valid vectors of a field, 1 for all of it: least squares. `inside` says
/// whether a place in mm is far enough from the volume's faces.
fn gain_of(
    field: &VelocityField,
    wave: &PlaneWave,
    inside: impl Fn([f64; 3]) -> bool,
) -> Option<f64> {
    let flow = Flow::PlaneWave(wave.clone());
    let (mut product, mut square) = (0.0, 0.0);
    for n in 0..field.grid.len() {
        let at_mm = field.grid.position_mm(n);
        if field.status[n] != VectorStatus::Valid || !inside(at_mm) {
            continue;
        }
        let moved_mm = flow.displacement_mm(at_mm, field.dt_s);
        for (found, moved_mm) in field.displacement_vox[n].into_iter().zip(moved_mm) {
            let expected = moved_mm / field.voxel_mm;
            product += f64::from(found) * expected;
            square += expected * expected;
        }
    }
    (square > 0.0).then(|| product / square)
}

/// The gain of a wave over the vectors well inside a volume with its centre and edges in mm.
pub fn gain(
    field: &VelocityField,
    wave: &PlaneWave,
    centre_mm: [f64; 3],
    extents_mm: [f64; 3],
) -> Option<f64> {
    let margin_mm = GAIN_INSIDE_VOX * field.voxel_mm;
    gain_of(field, wave, |at_mm| {
        (0..3)
            .all(|axis| (at_mm[axis] - centre_mm[axis]).abs() <= extents_mm[axis] / 2.0 - margin_mm)
    })
}

/// Point `n` of an additive sequence that fills the unit cube evenly: the fractional parts of n/g, n/g²,
/// n/g³ with g⁴ = g + 1 (Roberts 2018).
pub fn spread(n: usize) -> [f64; 3] {
    const G: f64 = 1.220_744_084_605_759_5;
    [1, 2, 3].map(|power| (0.5 + (n + 1) as f64 / G.powi(power)).fract())
}

/// Cubic convolution (Keys, IEEE Trans. Acoust. 29, 1981) at a place in node distances; at the faces the
/// field goes on as straight as it comes. `None` where a vector about has no value.
fn value_at(field: &VelocityField, at: [f64; 3]) -> Option<[f64; 3]> {
    let vectors = field.grid.vectors;
    let taps: [Vec<(usize, f64)>; 3] = std::array::from_fn(|axis| taps(at[axis], vectors[axis]));
    let mut sum = [0.0; 3];
    for &(k, wz) in &taps[2] {
        for &(j, wy) in &taps[1] {
            for &(i, wx) in &taps[0] {
                let n = (k * vectors[1] + j) * vectors[0] + i;
                if field.status[n] == VectorStatus::Invalid {
                    return None;
                }
                for (sum, value) in sum.iter_mut().zip(field.displacement_vox[n]) {
                    *sum += wz * wy * wx * f64::from(value);
                }
            }
        }
    }
    Some(sum)
}

/// Nodes along an axis and their weights at node coordinate `at`.
fn taps(at: f64, count: usize) -> Vec<(usize, f64)> {
    if count < 2 {
        return vec![(0, 1.0)];
    }
    let cell = (at.floor() as usize).min(count - 2);
    let t = at - cell as f64;
    let weights = [
        ((2.0 - t) * t - 1.0) * t / 2.0,
        ((3.0 * t - 5.0) * t * t + 2.0) / 2.0,
        ((4.0 - 3.0 * t) * t + 1.0) * t / 2.0,
        (t - 1.0) * t * t / 2.0,
    ];
    let mut inner = [weights[1], weights[2]];
    let mut taps = Vec::with_capacity(4);
    if cell > 0 {
        taps.push((cell - 1, weights[0]));
    } else {
        inner = [inner[0] + 2.0 * weights[0], inner[1] - weights[0]];
    }
    if cell + 2 < count {
        taps.push((cell + 2, weights[3]));
    } else {
        inner = [inner[0] - weights[3], inner[1] + 2.0 * weights[3]];
    }
    taps.extend([(cell, inner[0]), (cell + 1, inner[1])]);
    taps
}

#[cfg(test)]
mod tests {
    use lfpiv_core::velocimetry::VectorGrid;

    use super::*;

    /// The displacements of a wave, `part` of them, on 0.3 mm.
    fn field(wave: &PlaneWave, part: f64) -> VelocityField {
        let grid = VectorGrid { vectors: [20, 19, 18], first_mm: [-2.85; 3], spacing_mm: 0.3 };
        let flow = Flow::PlaneWave(wave.clone());
        let displacement_vox: Vec<[f32; 3]> = (0..grid.len())
            .map(|n| {
                let moved_mm = flow.displacement_mm(grid.position_mm(n), 1e-4);
                moved_mm.map(|mm| (part * mm / 0.1) as f32)
            })
            .collect();
        let count = grid.len();
        VelocityField {
            grid,
            displacement_vox,
            uncertainty_vox: vec![[0.1; 3]; count],
            status: vec![VectorStatus::Valid; count],
            peak_ratio: vec![2.0; count],
            vorticity: vec![[0.0; 3]; count],
            divergence: vec![0.0; count],
            has_gradient: vec![true; count],
            voxel_mm: 0.1,
            dt_s: 1e-4,
        }
    }

    fn wave(wavelength_mm: f64) -> PlaneWave {
        PlaneWave {
            wavelength_mm,
            amplitude_m_s: 1.0,
            along: [1.0, 1.0, 0.0],
            component: [0.0, 0.0, 1.0],
            phase_rad: 0.7,
        }
    }

    #[test]
    fn the_gain_is_the_part_of_the_wave_that_is_there() {
        let wave = wave(2.4);
        for part in [1.0, 0.4] {
            let found = gain(&field(&wave, part), &wave, [0.0; 3], [6.0; 3]).unwrap();
            assert!((found - part).abs() < 1e-5, "{found}");
        }
    }

    /// Between nodes an eighth of a wave apart cubic convolution leaves about 1 %; a field that is no wave
    /// at all leaves its mean.
    #[test]
    fn errors_between_vectors_are_those_of_the_interpolation_and_of_the_field() {
        let long = wave(4.8);
        let flow = Flow::PlaneWave(long.clone());
        let truth = KnownFlow::InTheMiddle(&flow);
        let [x, y, z] = error_between_vox(&field(&long, 1.0), truth).unwrap();
        assert!(x == 0.0 && y == 0.0 && z > 0.0 && z < 0.01, "{x} {y} {z}");
        let [_, _, missed] = error_between_vox(&field(&long, 0.0), truth).unwrap();
        assert!((missed - 2.0 / std::f64::consts::PI).abs() < 0.05, "{missed}");
        let mut holes = field(&long, 1.0);
        holes.status.fill(VectorStatus::Invalid);
        assert_eq!(error_between_vox(&holes, truth), None);
    }

    #[test]
    fn straight_fields_are_met_up_to_the_faces() {
        for at in [0.0, 0.3, 1.5, 3.9, 4.0] {
            let place: f64 = taps(at, 5).into_iter().map(|(n, weight)| n as f64 * weight).sum();
            assert!((place - at).abs() < 1e-12, "{at}: {place}");
        }
    }
}
