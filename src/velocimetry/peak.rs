//! The displacement that a correlation volume shows.

use super::lags::Lags;

/// The highest correlation peak.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// Its place, in cells of the correlated frames, to a fraction of a cell.
    pub shift: [f32; 3],
    /// The whole lag nearest to it, in cells.
    pub lag: [i64; 3],
    /// Its height over that of the next highest peak.
    pub ratio: f32,
}

/// Cells around the highest peak that belong to it.
const PEAK_RADIUS: i64 = 2;

/// Finds the highest peak of a correlation, among the lags that have neighbours on all sides.
/// `None` when nothing correlates, or more at the border of the lags than inside: something higher
/// may lie beyond it.
pub fn highest_peak(lags: Lags, correlation: &[f32]) -> Option<Peak> {
    let (edge, inner) = (lags.edge(), lags.reach as i64 - 1);
    let within = |index: usize, place: [i64; 3], radius: i64| {
        let s = lags.components(index);
        (0..3).all(|axis| (s[axis] - place[axis]).abs() <= radius)
    };
    let mut best: Option<(usize, f32)> = None;
    for (index, &value) in correlation.iter().enumerate() {
        if value > best.map_or(0.0, |(_, height)| height) && within(index, [0; 3], inner) {
            best = Some((index, value));
        }
    }
    let (index, height) = best?;
    let lag = lags.components(index);
    let sides: [[f32; 2]; 3] = std::array::from_fn(|axis| {
        let stride = edge.pow(axis as u32);
        [correlation[index - stride], correlation[index + stride]]
    });
    if sides.as_flattened().iter().any(|&side| side > height) {
        return None;
    }
    let mut second = 0.0f32;
    for (other, &value) in correlation.iter().enumerate() {
        if value > second && !within(other, lag, PEAK_RADIUS) {
            second = value;
        }
    }
    let shift = std::array::from_fn(|axis| {
        let [below, above] = sides[axis];
        lag[axis] as f32 + three_point_gaussian(below, height, above)
    });
    Some(Peak { shift, lag, ratio: (height / second.max(height * 1e-3)).min(1e3) })
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

    /// A peak at `centre` along x, sampled at all lags.
    fn peak_at(lags: Lags, centre: f32) -> Option<Peak> {
        let at = |index| {
            let [x, y, z] = lags.components(index).map(|c| c as f32);
            (-((x - centre).powi(2) + y * y + z * z) / 2.0).exp()
        };
        highest_peak(lags, &(0..lags.count()).map(at).collect::<Vec<f32>>())
    }

    #[test]
    fn what_rises_beyond_the_lags_is_no_peak() {
        let lags = Lags { reach: 3 };
        let inside = peak_at(lags, 1.8).unwrap();
        assert_eq!(inside.lag, [2, 0, 0]);
        assert!((inside.shift[0] - 1.8).abs() < 1e-4);
        for beyond in [2.6, 3.0, 4.5] {
            assert_eq!(peak_at(lags, beyond), None, "{beyond}");
        }
    }

    #[test]
    fn flat_and_negative_neighbours_give_finite_offsets() {
        assert_eq!(three_point_gaussian(1.0, 1.0, 1.0), 0.0);
        assert!(three_point_gaussian(-1.0, 2.0, 1.5).is_finite());
    }
}
