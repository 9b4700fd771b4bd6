//! The displacement that a correlation volume shows.

use super::spectrum::Correlator;

/// The highest correlation peak.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// Its place, in voxels, to sub-voxel accuracy.
    pub shift_vox: [f32; 3],
    /// The whole lag nearest to it, in voxels.
    pub lag: [i64; 3],
    /// Its height over that of the next highest peak.
    pub ratio: f32,
}

/// Voxels around the highest peak that belong to it.
const PEAK_RADIUS: i64 = 2;

/// Finds the highest peak of `correlation` (edge of `correlator`, circular lags) within `reach`
/// voxels of zero lag along each axis. `weight[|s|]`, of length `reach` + 2, multiplies the correlation at
/// lag component `s`: the overlap correction. `None` when nothing correlates, or more beyond the
/// reach than inside.
pub fn highest_peak(
    correlator: &Correlator,
    correlation: &[f32],
    reach: usize,
    weight: &[f32],
) -> Option<Peak> {
    let n = correlator.edge() as i64;
    let reach = reach as i64;
    let value = |s: [i64; 3]| {
        let at = |c: i64| c.rem_euclid(n) as usize;
        let share = |c: i64| weight[c.unsigned_abs() as usize];
        correlation[(at(s[2]) * n as usize + at(s[1])) * n as usize + at(s[0])]
            * (share(s[0]) * share(s[1]) * share(s[2]))
    };
    let mut best = (f32::NEG_INFINITY, [0; 3]);
    for_lags(reach, |s| {
        let v = value(s);
        if v > best.0 {
            best = (v, s);
        }
    });
    let (height, place) = best;
    if height.partial_cmp(&0.0) != Some(std::cmp::Ordering::Greater) {
        return None;
    }
    let neighbour = |axis: usize, step: i64| {
        let mut at = place;
        at[axis] += step;
        value(at)
    };
    // At the border of the reach something higher may lie beyond it.
    if (0..3).any(|axis| neighbour(axis, -1) > height || neighbour(axis, 1) > height) {
        return None;
    }
    let mut second = 0.0f32;
    for_lags(reach, |s| {
        if (0..3).any(|a| (s[a] - place[a]).abs() > PEAK_RADIUS) {
            second = second.max(value(s));
        }
    });
    let shift_vox = std::array::from_fn(|axis| {
        let (below, above) = (neighbour(axis, -1), neighbour(axis, 1));
        place[axis] as f32 + three_point_gaussian(below, height, above)
    });
    Some(Peak { shift_vox, lag: place, ratio: (height / second.max(height * 1e-3)).min(1e3) })
}

fn for_lags(reach: i64, mut visit: impl FnMut([i64; 3])) {
    for z in -reach..=reach {
        for y in -reach..=reach {
            for x in -reach..=reach {
                visit([x, y, z]);
            }
        }
    }
}

/// Offset of the top of a Gaussian through three equidistant samples, −0.5 to 0.5. A parabola
/// stands in where a neighbour is not positive and has no logarithm.
pub fn three_point_gaussian(below: f32, at: f32, above: f32) -> f32 {
    let (l, m, r) = if below > 0.0 && above > 0.0 {
        (below.ln(), at.ln(), above.ln())
    } else {
        (below, at, above)
    };
    let curvature = 2.0 * m - l - r;
    let offset = if curvature > 1e-12 { (r - l) / (2.0 * curvature) } else { 0.0 };
    offset.clamp(-0.5, 0.5)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sampled_gaussian_gives_back_its_centre() {
        for centre in [-0.45f32, -0.2, 0.0, 0.3, 0.5] {
            let g = |x: f32| (-(x - centre).powi(2) / 1.3).exp();
            assert!((three_point_gaussian(g(-1.0), g(0.0), g(1.0)) - centre).abs() < 1e-5);
        }
    }

    #[test]
    fn flat_and_negative_neighbours_give_finite_offsets() {
        assert_eq!(three_point_gaussian(1.0, 1.0, 1.0), 0.0);
        assert!(three_point_gaussian(-1.0, 2.0, 1.5).is_finite());
    }
}
