//! Which vectors disagree with their neighbours, and what to put in their place.

/// Fewer neighbours than this say nothing about a vector.
const LEAST_NEIGHBOURS: usize = 4;

/// Vectors on a lattice, some of them missing.
#[derive(Debug)]
pub struct Candidates<'a> {
    /// Vectors along x, y, z.
    pub nodes: [usize; 3],
    /// Stored z, y, x.
    pub values: &'a [[f32; 3]],
    /// Whether each vector was measured.
    pub present: &'a [bool],
}

impl Candidates<'_> {
    /// The normalised median test (Westerweel and Scarano, Exp. Fluids 39, 2005): a vector fails
    /// when a component differs from its neighbours' median by more than `threshold` times
    /// (their median residual + `epsilon_vox`). Missing vectors fail.
    ///
    /// The median is taken after each neighbour is carried to the vector's place along the median
    /// gradient: at a face of the volume all neighbours lie on one side, and a plain median would
    /// condemn every shear. The test runs twice, the
    /// second time without the neighbours that failed, so that one outlier does not condemn those
    /// around it.
    pub fn passing(&self, threshold: f64, epsilon_vox: f64) -> Vec<bool> {
        let once = self.tested(self.present, threshold, epsilon_vox);
        self.tested(&once, threshold, epsilon_vox)
    }

    fn tested(&self, trusted: &[bool], threshold: f64, epsilon_vox: f64) -> Vec<bool> {
        (0..self.values.len())
            .map(|index| {
                self.present[index] && {
                    let near = self.neighbours(index, trusted);
                    let level = carried_to_centre(&near);
                    near.len() < LEAST_NEIGHBOURS
                        || (0..3).all(|c| {
                            let spread = median_residual(near.iter().map(|n| n.value[c]));
                            let mut around: Vec<f32> = level.iter().map(|v| v[c]).collect();
                            let residual = (self.values[index][c] - median(&mut around)).abs();
                            f64::from(residual) <= threshold * (f64::from(spread) + epsilon_vox)
                        })
                }
            })
            .collect()
    }

    /// What the trusted neighbours of a vector say it should be: the mean of their values, each
    /// carried to its place; `None` when there are none.
    pub fn interpolated(&self, index: usize, trusted: &[bool]) -> Option<Interpolated> {
        let near = carried_to_centre(&self.neighbours(index, trusted));
        let count = near.len() as f32;
        (!near.is_empty()).then(|| {
            let mean = |of: &dyn Fn(&[f32; 3]) -> f32| near.iter().map(of).sum::<f32>() / count;
            let value: [f32; 3] = std::array::from_fn(|c| mean(&|v| v[c]));
            let spread_vox = std::array::from_fn(|c| mean(&|v| (v[c] - value[c]).powi(2)).sqrt());
            Interpolated { value, spread_vox, supported: near.len() >= LEAST_NEIGHBOURS }
        })
    }

    /// Indices of the up to 26 trusted vectors around one.
    pub fn near<'a>(
        &self,
        index: usize,
        trusted: &'a [bool],
    ) -> impl Iterator<Item = usize> + use<'a> {
        let [nx, ny, nz] = self.nodes;
        let (i, j, k) = (index % nx, index / nx % ny, index / (nx * ny));
        let around = |c: usize, n: usize| c.saturating_sub(1)..(c + 2).min(n);
        let (xs, ys) = (around(i, nx), around(j, ny));
        around(k, nz)
            .flat_map(move |z| ys.clone().map(move |y| (y, z)))
            .flat_map(move |(y, z)| xs.clone().map(move |x| (z * ny + y) * nx + x))
            .filter(move |&other| other != index && trusted[other])
    }

    fn neighbours(&self, index: usize, trusted: &[bool]) -> Vec<Neighbour> {
        let [nx, ny, _] = self.nodes;
        let place = |n: usize| [n % nx, n / nx % ny, n / (nx * ny)].map(|c| c as i32);
        let from = place(index);
        self.near(index, trusted)
            .map(|other| {
                let to = place(other);
                let offset = std::array::from_fn(|axis| to[axis] - from[axis]);
                Neighbour { offset, value: self.values[other] }
            })
            .collect()
    }
}

/// A vector made from its neighbours.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interpolated {
    /// The vector.
    pub value: [f32; 3],
    /// Standard deviation of the neighbours from it, each carried to its place.
    pub spread_vox: [f32; 3],
    /// Whether there are enough neighbours to say anything.
    pub supported: bool,
}

/// A vector near another one.
#[derive(Debug, Clone, Copy)]
struct Neighbour {
    /// Lattice steps to it along x, y, z.
    offset: [i32; 3],
    value: [f32; 3],
}

/// The values of neighbours, each carried to the centre along their median gradient.
fn carried_to_centre(near: &[Neighbour]) -> Vec<[f32; 3]> {
    let gradient: [[f32; 3]; 3] = std::array::from_fn(|axis| {
        let one_step = |(low, high): &(&Neighbour, &Neighbour)| {
            (0..3).all(|a| high.offset[a] - low.offset[a] == i32::from(a == axis))
        };
        let pairs: Vec<_> = near
            .iter()
            .flat_map(|low| near.iter().map(move |high| (low, high)))
            .filter(one_step)
            .collect();
        std::array::from_fn(|c| {
            let mut slopes: Vec<f32> = pairs.iter().map(|(l, h)| h.value[c] - l.value[c]).collect();
            if slopes.is_empty() { 0.0 } else { median(&mut slopes) }
        })
    });
    let carried = |n: &Neighbour| {
        std::array::from_fn(|c| {
            let rise: f32 = (0..3).map(|a| gradient[a][c] * n.offset[a] as f32).sum();
            n.value[c] - rise
        })
    };
    near.iter().map(carried).collect()
}

/// Median distance of values from their median.
fn median_residual(values: impl Iterator<Item = f32>) -> f32 {
    let mut values: Vec<f32> = values.collect();
    let middle = median(&mut values);
    for value in &mut values {
        *value = (*value - middle).abs();
    }
    median(&mut values)
}

fn median(values: &mut [f32]) -> f32 {
    let middle = values.len() / 2;
    let (below, &mut upper, _) = values.select_nth_unstable_by(middle, f32::total_cmp);
    if below.len() < middle || !values.len().is_multiple_of(2) {
        return upper;
    }
    let lower = values[..middle].iter().copied().fold(f32::NEG_INFINITY, f32::max);
    (lower + upper) / 2.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn median_agrees_with_sorting(mut values in proptest::collection::vec(-5f32..5.0, 1..30)) {
            let mut sorted = values.clone();
            sorted.sort_by(f32::total_cmp);
            let n = sorted.len();
            let expected = (sorted[(n - 1) / 2] + sorted[n / 2]) / 2.0;
            prop_assert_eq!(median(&mut values), expected);
        }
    }

    #[test]
    fn one_outlier_in_a_shear_is_found_and_nothing_else() {
        let nodes = [5, 5, 5];
        let mut values: Vec<[f32; 3]> =
            (0..125).map(|n| [(n / 25) as f32 * 0.5, 1.0, 0.0]).collect();
        values[62] = [4.0, -3.0, 0.0];
        let present = vec![true; 125];
        let field = Candidates { nodes, values: &values, present: &present };
        let pass = field.passing(2.0, 0.1);
        let failed: Vec<usize> = (0..125).filter(|&n| !pass[n]).collect();
        assert_eq!(failed, [62]);
        let replaced = field.interpolated(62, &pass).unwrap().value;
        assert!((replaced[0] - 1.0).abs() < 1e-5 && (replaced[1] - 1.0).abs() < 1e-5);
    }
}
