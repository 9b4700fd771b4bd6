//! Comparison of a reconstructed volume with the true one.
//!
//! Slices have one intensity per voxel in the same order; sums are accumulated in f64.

use super::DenseVolume;

/// Reconstruction quality factor (paper, Eq. 5), 0 to 1:
/// Q = Σ E E₀ / √(Σ E² · Σ E₀²), with E reconstructed and E₀ true.
///
/// In the paper's Eq. 5 the root covers only Σ E², which would depend on the unit of intensity; this is the
/// definition of its reference 35. Q is 0 if any of the volumes is dark.
pub fn quality_factor(reconstructed: &[f32], truth: &[f32]) -> f64 {
    let product: f64 = pairs(reconstructed, truth).map(|(e, e0)| e * e0).sum();
    let reconstructed: f64 = reconstructed.iter().map(|&e| f64::from(e).powi(2)).sum();
    let truth: f64 = truth.iter().map(|&e| f64::from(e).powi(2)).sum();
    let norm = reconstructed.sqrt() * truth.sqrt();
    if norm > 0.0 { (product / norm).min(1.0) } else { 0.0 }
}

/// Reconstruction error (paper, Eq. 3): ε = √Σ (E − E₀)², in the unit of the intensities.
pub fn reconstruction_error(reconstructed: &[f32], truth: &[f32]) -> f64 {
    pairs(reconstructed, truth).map(|(e, e0)| (e - e0).powi(2)).sum::<f64>().sqrt()
}

/// Elongation of the brightest particle: full width at half maximum, in mm, of the intensity
/// profile along `axis` (0 x, 1 y, 2 z) through the brightest voxel (paper, Fig. 10a).
///
/// The profile is interpolated linearly between voxel centres, so a single bright voxel has a width
/// of one voxel. The outside of the volume is dark: a particle cut by the volume's face has the
/// width of the inner part. `None` for a dark volume.
pub fn elongation_mm(volume: &DenseVolume, axis: usize) -> Option<f64> {
    let brightest = brightest_voxel(&volume.intensity)?;
    let [nx, ny, _] = volume.grid.voxels;
    let strides = [1, nx, nx * ny];
    let stride = strides[axis];
    let at = brightest / stride % volume.grid.voxels[axis];
    let first = brightest - at * stride;
    let profile: Vec<f64> = (0..volume.grid.voxels[axis])
        .map(|n| f64::from(volume.intensity[first + n * stride]))
        .collect();
    let after = half_width(profile[at..].iter().copied());
    let before = half_width(profile[..=at].iter().rev().copied());
    Some((before + after) * volume.grid.voxel_mm)
}

fn pairs<'a>(a: &'a [f32], b: &'a [f32]) -> impl Iterator<Item = (f64, f64)> + 'a {
    debug_assert_eq!(a.len(), b.len(), "volumes of different size");
    a.iter().zip(b).map(|(&a, &b)| (f64::from(a), f64::from(b)))
}

fn brightest_voxel(intensity: &[f32]) -> Option<usize> {
    let brightest = (0..intensity.len()).max_by(|&a, &b| intensity[a].total_cmp(&intensity[b]))?;
    (intensity[brightest] > 0.0).then_some(brightest)
}

/// Distance, in voxels, over which a profile falls to half of its first value.
fn half_width(falling: impl Iterator<Item = f64>) -> f64 {
    let mut inner: Option<(f64, f64)> = None;
    // A dark voxel outside the volume ends every profile.
    for (n, value) in falling.chain([0.0]).enumerate() {
        if let Some((half, last)) = inner {
            if value <= half {
                return n as f64 - 1.0 + (last - half) / (last - value);
            }
            inner = Some((half, value));
        } else {
            inner = Some((value / 2.0, value));
        }
    }
    0.0
}

#[cfg(test)]
mod tests {
    use proptest::{collection::vec, prelude::*};

    use super::*;
    use crate::model::VolumeGrid;

    fn line(axis: usize, profile: &[f32], voxel_mm: f64) -> DenseVolume {
        let mut voxels = [3; 3];
        voxels[axis] = profile.len();
        let grid = VolumeGrid { voxels, voxel_mm, centre_mm: [0.0; 3] };
        let mut intensity = vec![0.0; grid.len()];
        for (n, &value) in profile.iter().enumerate() {
            let mut ijk = [1; 3];
            ijk[axis] = n;
            intensity[grid.linear(ijk)] = value;
        }
        DenseVolume { grid, intensity }
    }

    #[test]
    fn quality_and_error_of_small_volumes() {
        // 3*4 / (sqrt(9 + 16) * 4) and sqrt((3 - 4)^2 + 4^2), by hand.
        assert!((quality_factor(&[3.0, 4.0], &[4.0, 0.0]) - 0.6).abs() < 1e-15);
        assert!((reconstruction_error(&[3.0, 4.0], &[4.0, 0.0]) - 17f64.sqrt()).abs() < 1e-15);
        assert_eq!(quality_factor(&[0.0, 1.0], &[1.0, 0.0]), 0.0);
    }

    #[test]
    fn a_dark_volume_has_no_quality_and_no_width() {
        for (a, b) in [([0.0; 2], [0.0, 1.0]), ([0.0, 1.0], [0.0; 2]), ([0.0; 2], [0.0; 2])] {
            assert_eq!(quality_factor(&a, &b), 0.0);
        }
        assert_eq!(elongation_mm(&line(2, &[0.0; 5], 0.1), 2), None);
    }

    #[test]
    fn width_is_interpolated_along_the_given_axis() {
        for axis in 0..3 {
            // Half of 8 is 1 + 1/3 voxels before the peak and 2/4 after it.
            let volume = line(axis, &[1.0, 3.0, 6.0, 8.0, 0.0, 7.0], 0.1);
            let expected = 0.1 * ((1.0 + 2.0 / 3.0) + 0.5);
            let width = elongation_mm(&volume, axis).unwrap();
            assert!((width - expected).abs() < 1e-12, "{width}");
            let across = elongation_mm(&volume, (axis + 1) % 3).unwrap();
            assert!((across - 0.1).abs() < 1e-12, "{across}");
        }
    }

    #[test]
    fn a_particle_at_the_face_ends_there() {
        let width = elongation_mm(&line(2, &[4.0, 3.0, 1.0, 0.0], 0.2), 2).unwrap();
        assert!((width - 0.2 * (0.5 + 1.5)).abs() < 1e-12, "{width}");
        // Uniform light: its four voxels and half a step to the dark on each side.
        let uniform = elongation_mm(&line(2, &[1.0; 4], 0.2), 2).unwrap();
        assert!((uniform - 0.2 * 4.0).abs() < 1e-12, "{uniform}");
    }

    proptest! {
        #[test]
        fn quality_lies_between_0_and_1_and_ignores_the_unit(
            volumes in vec((0.0f32..1e6, 0.0f32..1e6), 1..200),
            unit in 1e-3f32..1e3,
        ) {
            let (a, b): (Vec<f32>, Vec<f32>) = volumes.into_iter().unzip();
            let quality = quality_factor(&a, &b);
            prop_assert!((0.0..=1.0).contains(&quality));
            let scaled: Vec<f32> = a.iter().map(|&e| e * unit).collect();
            prop_assert!((quality_factor(&scaled, &b) - quality).abs() < 1e-6);
            if a.iter().any(|&e| e > 0.0) {
                prop_assert!((quality_factor(&a, &a) - 1.0).abs() < 1e-12);
            }
        }
    }
}
