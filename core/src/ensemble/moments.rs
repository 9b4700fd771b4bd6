//! Moments of a velocity, one sample at a time.
//!
//! The updates are those of Welford (1962) and Chan, Golub and LeVeque (1979) for the second moments and of
//! Pébay (SAND2008-6212) for the third: sums of powers of differences from the mean, which lose no digits to a
//! mean that is large beside its fluctuations.

use super::Sample;

/// The pairs of components whose covariances are kept.
pub(super) const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

/// Count, mean and central moments of the samples so far.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Moments {
    /// Number of samples.
    pub count: u64,
    /// Mean of each component.
    pub mean: [f64; 3],
    /// Sums of products of two components' differences from their means, in the order of [`PAIRS`].
    pub products: [f64; 6],
    /// Sums of cubed differences.
    pub cubes: [f64; 3],
    /// Mean of the squared standard uncertainties.
    pub noise: [f64; 3],
}

impl Moments {
    /// Those of one sample.
    pub fn of(sample: &Sample) -> Self {
        Self {
            count: 1,
            mean: sample.velocity_m_s,
            noise: sample.uncertainty_m_s.map(|u| u * u),
            ..Self::default()
        }
    }

    /// Puts the samples of `other` to these.
    pub fn merge(&mut self, other: &Self) {
        if other.count == 0 {
            return;
        }
        if self.count == 0 {
            *self = *other;
            return;
        }
        let (a, b) = (self.count as f64, other.count as f64);
        let n = a + b;
        let apart: [f64; 3] = std::array::from_fn(|c| other.mean[c] - self.mean[c]);
        for (c, apart) in apart.into_iter().enumerate() {
            // The squares are the first three products. Pébay's equation (2.7), for p = 3.
            self.cubes[c] += other.cubes[c]
                + apart.powi(3) * a * b * (a - b) / (n * n)
                + 3.0 * apart * (a * other.products[c] - b * self.products[c]) / n;
        }
        for (product, (more, (i, j))) in
            self.products.iter_mut().zip(other.products.into_iter().zip(PAIRS))
        {
            *product += more + apart[i] * apart[j] * a * b / n;
        }
        for (c, apart) in apart.into_iter().enumerate() {
            self.mean[c] += apart * b / n;
            self.noise[c] += (other.noise[c] - self.noise[c]) * b / n;
        }
        self.count += other.count;
    }

    /// Covariances in the order of [`PAIRS`], without bias; from two samples on.
    pub fn covariances(&self) -> Option<[f64; 6]> {
        (self.count > 1).then(|| self.products.map(|sum| sum / (self.count - 1) as f64))
    }

    /// Covariances less what the measurement's own scatter adds to the variances (Sciacchitano and Wieneke
    /// 2016): those of the flow. Errors of different components are taken as independent.
    pub fn stresses(&self) -> Option<[f64; 6]> {
        let mut stresses = self.covariances()?;
        for (variance, noise) in stresses.iter_mut().zip(self.noise) {
            *variance -= noise;
        }
        Some(stresses)
    }

    /// Skewness of the flow's fluctuations; errors that are symmetric add nothing to the third moment. Absent
    /// where nothing fluctuates more than the measurement does.
    pub fn skewness(&self) -> Option<[Option<f64>; 3]> {
        let stresses = self.stresses().filter(|_| self.count > 2)?;
        let n = self.count as f64;
        // Without bias, as Fisher's k-statistics.
        let unbiased = n / ((n - 1.0) * (n - 2.0));
        Some(std::array::from_fn(|c| {
            (stresses[c] > 0.0).then(|| unbiased * self.cubes[c] / stresses[c].powf(1.5))
        }))
    }
}
