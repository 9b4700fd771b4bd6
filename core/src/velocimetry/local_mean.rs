//! Local mean of residuals, near those of a few samples.

use crate::particles::Neighbours;

/// Radius of the mean, in mean distances of samples.
const RADIUS: f32 = 1.5;

/// What a field misses at a sample.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Residual {
    /// The sample's place, in voxels.
    pub at_vox: [f32; 3],
    /// Its displacement without that of the field, in voxels.
    pub left_vox: [f32; 3],
}

/// Mean residual of the samples around a place, weighted by distance (Shepard, Proc. 23rd ACM Natl. Conf., 1968), where
/// some of these samples are far from the field; zero elsewhere.
pub struct LocalMean {
    left_vox: Vec<[f32; 3]>,
    radius_vox: f32,
    all: Neighbours,
    far: Neighbours,
}

impl LocalMean {
    /// Samples from number `first_far` on are far from the field.
    pub fn new(residuals: &[Residual], first_far: usize) -> Self {
        let places: Vec<[f32; 3]> = residuals.iter().map(|residual| residual.at_vox).collect();
        let radius_vox = RADIUS * mean_distance(&places);
        Self {
            left_vox: residuals.iter().map(|residual| residual.left_vox).collect(),
            radius_vox,
            all: Neighbours::new(&places, radius_vox),
            far: Neighbours::new(&places[first_far..], radius_vox),
        }
    }

    /// The mean at a place, in voxels.
    pub fn at(&self, at_vox: [f32; 3]) -> [f32; 3] {
        let mut is_far = false;
        self.far.visit(at_vox, |_, _| is_far = true);
        let (mut sum, mut weights) = ([0.0; 3], 0.0);
        if is_far {
            self.all.visit(at_vox, |n, square| {
                let inside = 1.0 - square / (self.radius_vox * self.radius_vox);
                let weight = inside * inside;
                weights += weight;
                (0..3).for_each(|c| sum[c] += weight * self.left_vox[n][c]);
            });
        }
        if weights > 0.0 { sum.map(|sum| sum / weights) } else { [0.0; 3] }
    }
}

/// Edge of the cube that contains one of the places on average, in the box around them.
fn mean_distance(places: &[[f32; 3]]) -> f32 {
    let span = |axis: usize| {
        let along = || places.iter().map(|at| at[axis]);
        (along().fold(f32::NEG_INFINITY, f32::max) - along().fold(f32::INFINITY, f32::min)).max(1.0)
    };
    ((0..3).map(span).product::<f32>() / places.len() as f32).cbrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// On a lattice 4 voxels apart: 3 voxels in its lower half along x, which is far from the field, 0.5 in the upper.
    fn mean() -> LocalMean {
        let of_half = |half: usize| {
            (0..500).map(move |n| {
                let place = [n % 5 + 5 * half, n / 5 % 10, n / 50];
                let left_vox = [[3.0, 0.0, 0.0], [0.5, 0.0, 0.0]][half];
                Residual { at_vox: place.map(|at| 4.0 * at as f32), left_vox }
            })
        };
        let residuals: Vec<Residual> = of_half(1).chain(of_half(0)).collect();
        LocalMean::new(&residuals, 500)
    }

    #[test]
    fn the_mean_follows_far_samples_and_is_zero_elsewhere() {
        let mean = mean();
        let along_x = |x: f32| mean.at([x, 20.0, 20.0])[0];
        assert!((along_x(4.0) - 3.0).abs() < 1e-6);
        assert!((0.5..2.9).contains(&along_x(18.0)), "{}", along_x(18.0));
        assert_eq!(along_x(30.0), 0.0);
        assert_eq!(mean.at([200.0; 3]), [0.0; 3]);
    }

    #[test]
    fn without_far_samples_there_is_none() {
        let residual = Residual { at_vox: [1.0; 3], left_vox: [2.0; 3] };
        assert_eq!(LocalMean::new(&[residual], 1).at([1.0; 3]), [0.0; 3]);
        assert_eq!(LocalMean::new(&[], 0).at([1.0; 3]), [0.0; 3]);
    }
}
