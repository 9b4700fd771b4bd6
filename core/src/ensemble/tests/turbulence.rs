//! A turbulent flow with known statistics: the intermittent shear layer of a jet.
//!
//! At each node the flow is turbulent with probability γ, the intermittency, and at rest otherwise (Pope 2000,
//! section 5.5.2). Turbulent velocities are a mean plus a sum of Fourier modes with normal amplitudes, correlated
//! between components and nodes. The mixture is neither normal nor symmetric; its moments follow from those of
//! both states.

use std::f64::consts::TAU;

use super::*;

const MODES: usize = 24;

pub(super) struct Turbulence {
    modes: Vec<Mode>,
    places_mm: Vec<[f64; 3]>,
}

/// Homogeneous mode a cos(k·x) + b sin(k·x) along two directions, with normal a and b.
struct Mode {
    wavevector: [f64; 3],
    /// Velocities of two independent amplitudes.
    directions: [[f64; 3]; 2],
}

/// Standard normal numbers (Box and Muller 1958).
pub(super) fn normal(random: &mut Pcg64Mcg) -> f64 {
    let radius = (-2.0 * (1.0 - random.random::<f64>()).ln()).sqrt();
    radius * (TAU * random.random::<f64>()).cos()
}

impl Turbulence {
    pub fn new(grid: &VectorGrid, seed: u64) -> Self {
        let mut random = Pcg64Mcg::seed_from_u64(seed);
        let modes = (0..MODES).map(|mode| {
            // Wavelengths from 12 to 1.5 mm; energy proportional to wavenumber^(-5/3).
            let wavenumber = TAU / 12.0 * 8f64.powf(mode as f64 / (MODES - 1) as f64);
            let towards = [0; 3].map(|_| normal(&mut random));
            let length = towards.iter().map(|t| t * t).sum::<f64>().sqrt();
            let scale = 0.2 * wavenumber.powf(-5.0 / 6.0);
            // The first direction correlates u and v, as in a shear layer.
            let directions =
                [[scale, -0.5 * scale, 0.2 * scale], [0.3 * scale, 0.6 * scale, 0.7 * scale]];
            Mode { wavevector: towards.map(|t| t / length * wavenumber), directions }
        });
        let places_mm = (0..grid.len()).map(|place| grid.position_mm(place)).collect();
        Self { modes: modes.collect(), places_mm }
    }

    /// Mean of the turbulent state, in m/s, with shear along y.
    fn mean(&self, place: usize) -> [f64; 3] {
        [3.0 + (self.places_mm[place][1] - 1.0), 0.4, 0.0]
    }

    /// Intermittency γ of a node.
    fn share(&self, place: usize) -> f64 {
        0.6 + 0.1 * (self.places_mm[place][1] * 2.0).sin()
    }

    /// Covariance of two components of the turbulent state, which is homogeneous.
    fn covariance(&self, i: usize, j: usize) -> f64 {
        let directions = self.modes.iter().flat_map(|mode| &mode.directions);
        directions.map(|direction| direction[i] * direction[j]).sum()
    }

    /// Two-point covariance of a component of the turbulent state.
    pub fn correlation(&self, component: usize, apart_mm: [f64; 3]) -> f64 {
        let of = |mode: &Mode| {
            let phase: f64 = mode.wavevector.iter().zip(apart_mm).map(|(k, r)| k * r).sum();
            let energy: f64 = mode.directions.iter().map(|d| d[component].powi(2)).sum();
            energy * phase.cos()
        };
        self.modes.iter().map(of).sum()
    }

    /// The true value of a statistic.
    pub fn truth(&self, quantity: Quantity, place: usize) -> f64 {
        let (share, step) = (self.share(place), self.mean(place));
        let stress = |i: usize, j: usize| {
            share * self.covariance(i, j) + share * (1.0 - share) * step[i] * step[j]
        };
        match quantity {
            Quantity::Mean(c) => share * step[c],
            Quantity::Rms(c) => stress(c, c).sqrt(),
            Quantity::Stress(i, j) => stress(i, j),
            Quantity::Skewness(c) => {
                let [turbulent, quiet] = [(1.0 - share) * step[c], -share * step[c]];
                let third = share * (turbulent.powi(3) + 3.0 * self.covariance(c, c) * turbulent)
                    + (1.0 - share) * quiet.powi(3);
                third / stress(c, c).powf(1.5)
            }
        }
    }

    /// Velocity of the turbulent state in one shot, at each node.
    pub fn turbulent(&self, random: &mut Pcg64Mcg) -> Vec<[f64; 3]> {
        let amplitudes: Vec<[f64; 4]> =
            self.modes.iter().map(|_| [0; 4].map(|_| normal(random))).collect();
        let velocity = |(place, position): (usize, &[f64; 3])| {
            let mut velocity = self.mean(place);
            for (mode, a) in self.modes.iter().zip(&amplitudes) {
                let phase: f64 = mode.wavevector.iter().zip(position).map(|(k, x)| k * x).sum();
                let (sin, cos) = phase.sin_cos();
                let strengths = [a[0] * cos + a[1] * sin, a[2] * cos + a[3] * sin];
                for (strength, direction) in strengths.into_iter().zip(&mode.directions) {
                    (0..3).for_each(|c| velocity[c] += strength * direction[c]);
                }
            }
            velocity
        };
        self.places_mm.iter().enumerate().map(velocity).collect()
    }

    /// A measured shot. Errors agree with the stated uncertainties; a tenth of the samples is missing.
    pub fn shot(&self, shot: u64, random: &mut Pcg64Mcg) -> Snapshot {
        let samples = self.turbulent(random).into_iter().enumerate().map(|(place, turbulent)| {
            let quiet = !random.random_bool(self.share(place));
            let flow = if quiet { [0.0; 3] } else { turbulent };
            let uncertainty_m_s = [0.2, 0.2, 0.3].map(|u| u * random.random_range(0.5..1.5));
            let velocity_m_s =
                std::array::from_fn(|c| flow[c] + uncertainty_m_s[c] * normal(random));
            random.random_bool(0.9).then_some(Sample { velocity_m_s, uncertainty_m_s })
        });
        Snapshot { shot, samples: samples.collect() }
    }
}
