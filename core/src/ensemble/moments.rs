//! Moments of a velocity, updated with one sample at a time.
//!
//! The updates are those of Welford (1962) and Chan, Golub and LeVeque (1979) for the second moments and of Pébay
//! (SAND2008-6212) for the third. They use sums of powers of differences from the mean, which are accurate even if
//! the mean is much larger than the fluctuations.

use super::Sample;

/// The pairs of components with a covariance.
pub(super) const PAIRS: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

/// Count, mean and central moments of the samples.
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
    /// The moments of one sample.
    pub fn of(sample: &Sample) -> Self {
        Self {
            count: 1,
            mean: sample.velocity_m_s,
            noise: sample.uncertainty_m_s.map(|u| u * u),
            ..Self::default()
        }
    }

    /// Adds the samples of `other`.
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
            // Pébay's equation (2.7) for p = 3. The first three products are the sums of squares.
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

    /// Unbiased covariances in the order of [`PAIRS`]. `None` for fewer than two samples.
    pub fn covariances(&self) -> Option<[f64; 6]> {
        (self.count > 1).then(|| self.products.map(|sum| sum / (self.count - 1) as f64))
    }

    /// Covariances of the flow: the variances are reduced by those of the measurement (Sciacchitano and Wieneke
    /// 2016). Errors of different components are assumed to be independent.
    pub fn stresses(&self) -> Option<[f64; 6]> {
        let mut stresses = self.covariances()?;
        for (variance, noise) in stresses.iter_mut().zip(self.noise) {
            *variance -= noise;
        }
        Some(stresses)
    }

    /// Skewness of the flow's fluctuations. Measurement errors are assumed to be symmetric, so that they do not
    /// contribute to the third moment. `None` if the variance of the flow is not positive.
    pub fn skewness(&self) -> Option<[Option<f64>; 3]> {
        let stresses = self.stresses().filter(|_| self.count > 2)?;
        let n = self.count as f64;
        // Unbiased third moment: Fisher's k-statistic.
        let unbiased = n / ((n - 1.0) * (n - 2.0));
        Some(std::array::from_fn(|c| {
            (stresses[c] > 0.0).then(|| unbiased * self.cubes[c] / stresses[c].powf(1.5))
        }))
    }
}
