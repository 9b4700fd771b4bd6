//! Statistics with confidence intervals, from moments.

use serde::{Deserialize, Serialize};

use super::{
    jackknife,
    moments::{Moments, PAIRS},
    student::half_width_95,
};

/// A statistic at a node. Velocities are in m/s, stresses in m²/s², skewness is dimensionless.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Mean of component 0, 1 or 2.
    Mean(usize),
    /// Standard deviation of the flow's fluctuations, without the variance of the measurement.
    Rms(usize),
    /// Covariance of two components of the flow: Reynolds stress divided by density.
    Stress(usize, usize),
    /// Skewness of the flow's fluctuations.
    Skewness(usize),
}

impl Quantity {
    /// All statistics: three means, three root-mean-squares, six stresses, three skewnesses.
    pub const ALL: [Self; 15] = [
        Self::Mean(0),
        Self::Mean(1),
        Self::Mean(2),
        Self::Rms(0),
        Self::Rms(1),
        Self::Rms(2),
        Self::Stress(0, 0),
        Self::Stress(1, 1),
        Self::Stress(2, 2),
        Self::Stress(0, 1),
        Self::Stress(0, 2),
        Self::Stress(1, 2),
        Self::Skewness(0),
        Self::Skewness(1),
        Self::Skewness(2),
    ];

    /// Name in files and HTTP responses: `u_mean`, `v_rms`, `uw`, `w_skewness`.
    pub fn name(self) -> String {
        const NAMES: [&str; 3] = ["u", "v", "w"];
        match self {
            Self::Mean(c) => format!("{}_mean", NAMES[c]),
            Self::Rms(c) => format!("{}_rms", NAMES[c]),
            Self::Stress(i, j) => format!("{}{}", NAMES[i], NAMES[j]),
            Self::Skewness(c) => format!("{}_skewness", NAMES[c]),
        }
    }

    /// The statistic. `None` with too few samples, or without a variance to normalise by.
    fn of(self, moments: &Moments) -> Option<f64> {
        match self {
            Self::Mean(c) => (moments.count > 0).then(|| moments.mean[c]),
            // As a variance; `Estimate::root` converts it, because its interval may include zero.
            Self::Rms(c) => Self::Stress(c, c).of(moments),
            Self::Stress(i, j) => {
                let at = PAIRS.iter().position(|pair| *pair == (i, j))?;
                moments.stresses().map(|stresses| stresses[at])
            }
            Self::Skewness(c) => moments.skewness()?[c],
        }
    }

    /// Variance of the statistic due to the measurement, for normal fluctuations and errors.
    fn measurement_variance(self, moments: &Moments) -> Option<f64> {
        let n = moments.count as f64;
        let noise = moments.noise;
        let stress = |c: usize| moments.stresses().map(|stresses| stresses[c].max(0.0));
        match self {
            Self::Mean(c) => Some(noise[c] / n),
            Self::Rms(c) => Self::Stress(c, c).measurement_variance(moments),
            Self::Stress(i, j) if i == j => {
                Some((4.0 * stress(i)? * noise[i] + 2.0 * noise[i].powi(2)) / (n - 1.0))
            }
            Self::Stress(i, j) => Some(
                (stress(i)? * noise[j] + stress(j)? * noise[i] + noise[i] * noise[j]) / (n - 1.0),
            ),
            Self::Skewness(c) => {
                let flow = stress(c)?;
                Some(6.0 * (((flow + noise[c]) / flow).powi(3) - 1.0) / n)
            }
        }
    }
}

/// A statistic with its uncertainty.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Estimate {
    /// Value.
    pub value: f64,
    /// Standard uncertainty due to the finite number of shots of a fluctuating flow.
    pub flow_uncertainty: f64,
    /// Standard uncertainty due to the errors of the velocities, which are assumed to be independent between shots.
    pub measurement_uncertainty: f64,
    /// Interval that contains the true value with a probability of 95 %, from both uncertainties.
    pub interval_95: [f64; 2],
}

impl Estimate {
    /// Combined standard uncertainty of flow and measurement.
    pub fn uncertainty(&self) -> f64 {
        self.flow_uncertainty.hypot(self.measurement_uncertainty)
    }

    /// The root of a variance.
    fn root(self) -> Self {
        let value = self.value.max(0.0).sqrt();
        let interval_95 = self.interval_95.map(|bound| bound.max(0.0).sqrt());
        // d√x = dx/(2√x). For x ≤ 0 only the interval is defined.
        let scale = if value > 0.0 { 0.5 / value } else { 0.0 };
        let [flow, measurement] =
            [self.flow_uncertainty, self.measurement_uncertainty].map(|part| part * scale);
        Self { value, flow_uncertainty: flow, measurement_uncertainty: measurement, interval_95 }
    }
}

/// The statistics at all nodes.
#[derive(Debug, Clone, PartialEq)]
pub struct Estimates {
    /// Number of samples at each node.
    pub counts: Vec<u64>,
    /// For each quantity in the order of [`Quantity::ALL`]: the estimate at each node; `None` with too few samples.
    pub values: Vec<Vec<Option<Estimate>>>,
}

impl Estimates {
    /// The estimates of one quantity.
    pub fn of(&self, quantity: Quantity) -> &[Option<Estimate>] {
        let at = Quantity::ALL.iter().position(|other| *other == quantity);
        at.and_then(|at| self.values.get(at)).map_or(&[], Vec::as_slice)
    }
}

/// The estimates at one node from the moments of its groups, in the order of [`Quantity::ALL`].
pub(super) fn estimates(groups: &[Moments]) -> [Option<Estimate>; Quantity::ALL.len()] {
    let mut whole = Moments::default();
    groups.iter().for_each(|group| whole.merge(group));
    let without = jackknife::left_out(groups);
    Quantity::ALL.map(|quantity| {
        let value = quantity.of(&whole)?;
        let mut others = Vec::with_capacity(without.len());
        for (size, moments) in &without {
            others.push((*size, quantity.of(moments)?));
        }
        let variance = jackknife::variance(value, others.iter().copied())?;
        let measurement = quantity.measurement_variance(&whole)?;
        let half = half_width_95(others.len() - 1) * variance.sqrt();
        let estimate = Estimate {
            value,
            flow_uncertainty: (variance - measurement).max(0.0).sqrt(),
            measurement_uncertainty: measurement.sqrt(),
            interval_95: [value - half, value + half],
        };
        Some(if matches!(quantity, Quantity::Rms(_)) { estimate.root() } else { estimate })
    })
}
