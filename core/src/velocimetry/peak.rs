//! Displacement peaks of a correlation volume.

use std::ops::Range;

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

/// The peak near zero lag after the previous passes: the vertex of the Gaussian through the lags of reach 1, at
/// most one lag from zero along each axis. `None` where these lags have no maximum. They contain no secondary
/// peak, so its ratio is [`MAX_RATIO`].
pub fn nearest_peak(correlation: &[f32]) -> Option<Peak> {
    const MIDDLE: usize = 13;
    let mut shift = [0.0; 3];
    for (shift, stride) in shift.iter_mut().zip([1, 3, 9]) {
        let [below, height, above] =
            [MIDDLE - stride, MIDDLE, MIDDLE + stride].map(|lag| f64::from(correlation[lag]));
        let curvature = log_curvature(below, height, above)?;
        *shift = ((above.ln() - below.ln()) / (2.0 * curvature)).clamp(-1.0, 1.0) as f32;
    }
    Some(Peak { shift, lag: [0; 3], ratio: MAX_RATIO })
}

/// Negative second difference of the logarithm of three equidistant samples; `None` where a sample is not
/// positive, or the samples have no peak.
pub fn log_curvature(below: f64, at: f64, above: f64) -> Option<f64> {
    let positive = [below, at, above].iter().all(|&value| value > 0.0);
    let curvature = positive.then(|| 2.0 * at.ln() - below.ln() - above.ln())?;
    (curvature > LEAST_CURVATURE).then_some(curvature)
}

/// Least curvature of a peak.
const LEAST_CURVATURE: f64 = 1e-3;

/// Upper limit of the peak ratio; also the ratio of a peak without a secondary one.
const MAX_RATIO: f32 = 1e3;

/// Radius in cells within which values belong to the highest peak.
const PEAK_RADIUS: i64 = 2;

/// Finds the highest peak of a correlation among the lags with neighbours on all sides. `None` where no value is
/// positive, or the correlation is higher at the border of the lags: the maximum may lie beyond it.
pub fn highest_peak(lags: Lags, correlation: &[f32]) -> Option<Peak> {
    let edge = lags.edge();
    let mut best: Option<(usize, f32)> = None;
    for line in Line::all(lags).filter(|line| line.within([0; 3], lags.reach as i64 - 1)) {
        for (index, &value) in line.range().zip(&correlation[line.range()]).skip(1).take(edge - 2) {
            if value > best.map_or(0.0, |(_, height)| height) {
                best = Some((index, value));
            }
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
    let shift = std::array::from_fn(|axis| {
        let [below, above] = sides[axis];
        lag[axis] as f32 + three_point_gaussian(below, height, above)
    });
    Some(Peak { shift, lag, ratio: over(height, next_highest(lags, correlation, lag)) })
}

/// Ratio of the highest value within one lag of zero to the highest value outside that peak: less than 1 where
/// another peak is higher, 0 where no value near zero lag is positive.
pub fn ratio_at_zero_lag(lags: Lags, correlation: &[f32]) -> f32 {
    let own = Line::all(lags).filter(|line| line.within([0; 3], 1)).fold(0.0, |most, line| {
        let middle = line.first + lags.reach;
        highest(&correlation[middle - 1..=middle + 1], most)
    });
    over(own, next_highest(lags, correlation, [0; 3]))
}

/// Ratio of a peak to the next highest; at most [`MAX_RATIO`].
fn over(height: f32, next: f32) -> f32 {
    if height > 0.0 { (height / next.max(height / MAX_RATIO)).min(MAX_RATIO) } else { 0.0 }
}

/// The highest value outside the peak at `lag`; 0 where all are negative.
fn next_highest(lags: Lags, correlation: &[f32], lag: [i64; 3]) -> f32 {
    Line::all(lags).fold(0.0, |highest_yet, line| {
        let values = &correlation[line.range()];
        if !line.within(lag, PEAK_RADIUS) {
            return highest(values, highest_yet);
        }
        let own = [lag[0] - PEAK_RADIUS, lag[0] + PEAK_RADIUS + 1]
            .map(|end| (end + lags.reach as i64).clamp(0, line.length as i64) as usize);
        highest(&values[own[1]..], highest(&values[..own[0]], highest_yet))
    })
}

/// Lags that differ along x only.
struct Line {
    first: usize,
    length: usize,
    /// Their components along y and z.
    across: [i64; 2],
}

impl Line {
    fn all(lags: Lags) -> impl Iterator<Item = Self> {
        let length = lags.edge();
        (0..length * length).map(move |line| {
            let across = [line % length, line / length].map(|c| c as i64 - lags.reach as i64);
            Self { first: line * length, length, across }
        })
    }

    fn range(&self) -> Range<usize> {
        self.first..self.first + self.length
    }

    /// Whether y and z are within `radius` of `lag`.
    fn within(&self, lag: [i64; 3], radius: i64) -> bool {
        self.across.iter().zip(&lag[1..]).all(|(own, lag)| (own - lag).abs() <= radius)
    }
}

/// The highest of some values, at least `least`.
fn highest(values: &[f32], least: f32) -> f32 {
    values.iter().fold(least, |most, &value| if value > most { value } else { most })
}

/// Offset of the vertex of a Gaussian through three equidistant samples, −0.5 to 0.5; of a parabola where a
/// neighbour is not positive.
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

    /// The definition, lag by lag: place and height of the highest inside, and the next highest.
    fn by_definition(lags: Lags, correlation: &[f32]) -> Option<([i64; 3], f32)> {
        let apart = |index: usize, place: [i64; 3]| {
            lags.components(index).iter().zip(place).map(|(s, p)| (s - p).abs()).max().unwrap()
        };
        let inside = (0..lags.count()).filter(|&n| apart(n, [0; 3]) < lags.reach as i64);
        let best = inside.max_by(|&a, &b| correlation[a].total_cmp(&correlation[b])).unwrap();
        let lag = lags.components(best);
        let others = (0..lags.count()).filter(|&n| apart(n, lag) > PEAK_RADIUS);
        let second = others.map(|n| correlation[n]).fold(0.0, f32::max);
        (correlation[best] > 0.0).then_some((lag, correlation[best] / second.max(1e-30)))
    }

    #[test]
    fn peaks_and_their_ratios_are_those_of_the_definition() {
        use rand::{RngExt, SeedableRng};
        let mut random = rand_pcg::Pcg64Mcg::seed_from_u64(11);
        let mut found = 0;
        for reach in [1, 2, 3, 4, 5] {
            let lags = Lags { reach };
            for _ in 0..40 {
                let noise: Vec<f32> =
                    (0..lags.count()).map(|_| random.random_range(-0.2..0.5)).collect();
                let mut correlation = noise;
                let top = random.random_range(0..lags.count());
                correlation[top] = 1.0;
                if let Some(peak) = highest_peak(lags, &correlation) {
                    let (lag, ratio) = by_definition(lags, &correlation).unwrap();
                    assert_eq!(peak.lag, lag);
                    assert!((peak.ratio / ratio.min(MAX_RATIO) - 1.0).abs() < 1e-5);
                    found += 1;
                }
            }
        }
        assert!(found > 40, "{found}");
    }

    #[test]
    fn a_peak_at_zero_lag_is_compared_with_secondary_peaks() {
        let lags = Lags { reach: 3 };
        let mut correlation = vec![0.1; lags.count()];
        let place =
            |wanted: [i64; 3]| (0..lags.count()).find(|&n| lags.components(n) == wanted).unwrap();
        correlation[place([1, 0, -1])] = 0.6;
        correlation[place([0, 2, 0])] = 0.5;
        correlation[place([-3, 0, 1])] = 0.2;
        assert!((ratio_at_zero_lag(lags, &correlation) - 3.0).abs() < 1e-6);
        correlation[place([0, 3, 3])] = 1.2;
        assert!((ratio_at_zero_lag(lags, &correlation) - 0.5).abs() < 1e-6);
        assert_eq!(ratio_at_zero_lag(lags, &vec![-1.0; lags.count()]), 0.0);
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
    fn the_nearest_lags_find_a_top_up_to_a_lag_away() {
        let lags = Lags { reach: 1 };
        let at = |centre: [f32; 3], index| {
            let s = lags.components(index).map(|c| c as f32);
            let square: f32 = (0..3).map(|c| (s[c] - centre[c]).powi(2)).sum();
            (-square / 1.7).exp()
        };
        for centre in [[0.0, 0.1, -0.4], [0.7, -0.9, 0.2]] {
            let correlation: Vec<f32> = (0..27).map(|n| at(centre, n)).collect();
            let shift = nearest_peak(&correlation).unwrap().shift;
            assert!(shift.iter().zip(centre).all(|(s, c)| (s - c).abs() < 1e-4), "{shift:?}");
        }
        let beyond: Vec<f32> = (0..27).map(|n| at([2.5, 0.0, 0.0], n)).collect();
        assert_eq!(nearest_peak(&beyond).unwrap().shift[0], 1.0);
        assert_eq!(nearest_peak(&[1.0; 27]), None);
        assert_eq!(nearest_peak(&[0.0; 27]), None);
        let valley: Vec<f32> = (0..27).map(|n| 1.0 / at([0.0; 3], n)).collect();
        assert_eq!(nearest_peak(&valley), None);
    }

    #[test]
    fn flat_and_negative_neighbours_give_finite_offsets() {
        assert_eq!(three_point_gaussian(1.0, 1.0, 1.0), 0.0);
        assert!(three_point_gaussian(-1.0, 2.0, 1.5).is_finite());
    }
}
