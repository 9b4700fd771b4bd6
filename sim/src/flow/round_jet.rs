//! The near field of a round jet: a mean that spreads downstream, and fluctuations of every shot.

use std::f64::consts::TAU;

use garde::Validate;
use lfpiv_hw::check::finite;
use rand::RngExt;
use serde::{Deserialize, Serialize};

use super::{
    drawn::DrawnWaves,
    turbulence::{direction, perpendicular},
};
use crate::stream::{Purpose, random_stream};

/// Number of waves of a realisation.
const WAVES: usize = 48;

/// Least share of the shear layer's initial thickness upstream of the outlet.
const LEAST_THICKNESS: f64 = 0.5;

/// A round jet along +y near its nozzle. Mean and fluctuations are both free of divergence, and the mean and the
/// rms of each component over all realisations are known in closed form ([`Self::mean_m_s`], [`Self::rms_m_s`]).
///
/// Mean, with q = r², distance y from the outlet and s(y) = 4 R θ(y), θ(y) = θ0 + θ' y:
///
/// - v = V/2 (1 − tanh ζ), ζ = (q − R²)/s: near r = R the shear layer V/2 (1 − tanh((r − R)/2θ)) of momentum
///   thickness θ;
/// - u_r = −(1/r) ∂ψ/∂y with the stream function ψ = ∫ v r dr = V/4 (q − s ln cosh ζ + s ln cosh(R²/s)).
///
/// The flux at the outlet is that of the bulk velocity through the nozzle, R = D/2 · √(bulk/V); downstream the
/// jet draws in fluid from around it.
///
/// Fluctuations of one realisation: curl(g A), with an envelope g = c + (1 − c) exp(−ζ²/2) that is 1 in the
/// middle of the shear layer and c outside, and a vector potential A = Σ a cos(k·x + φ) of random waves with
/// Kolmogorov's spectrum. Phases are independent of directions, so A and curl A at a place are uncorrelated, and
/// the variance of component i is g² σ² + (|∇g|² − (∂g/∂i)²) σ_A².
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct RoundJet {
    /// Diameter D of the nozzle, in mm.
    #[garde(custom(finite), range(min = 0.1, max = 1000.0))]
    pub diameter_mm: f64,
    /// Flow rate over the nozzle's area, in m/s.
    #[garde(custom(finite), range(min = 0.0, max = 1000.0))]
    pub bulk_m_s: f64,
    /// Velocity V at the top of the profile, in m/s.
    #[garde(custom(finite), range(min = 0.001, max = 1000.0))]
    pub peak_m_s: f64,
    /// Centre (x, y, z) of the outlet, in mm.
    #[garde(inner(custom(finite), range(min = -1000.0, max = 1000.0)))]
    pub outlet_mm: [f64; 3],
    /// Momentum thickness θ0 of the shear layer at the outlet, in mm.
    #[garde(custom(finite), range(min = 0.01, max = 100.0))]
    pub momentum_thickness_mm: f64,
    /// Its growth θ' per distance from the outlet.
    #[garde(custom(finite), range(min = 0.0, max = 1.0))]
    pub growth: f64,
    /// Root mean square σ of each component in the middle of the shear layer without the envelope's gradient, in
    /// m/s.
    #[garde(custom(finite), range(min = 0.0, max = 1000.0))]
    pub rms_m_s: f64,
    /// Share c of it far from the shear layer.
    #[garde(custom(finite), range(min = 0.0, max = 1.0))]
    pub quiet_share: f64,
    /// Shortest and longest wavelength of the fluctuations, in mm.
    #[garde(inner(custom(finite), range(min = 0.01, max = 10_000.0)))]
    pub wavelengths_mm: [f64; 2],
    /// Seed and shot of the fluctuations. When absent, every shot has its own; the flow itself is then the mean.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[garde(skip)]
    pub realisation: Option<[u64; 2]>,
    #[serde(skip)]
    #[garde(skip)]
    waves: DrawnWaves<Wave>,
}

#[derive(Debug, Clone, Copy)]
struct Wave {
    /// k, in rad/mm.
    number_per_mm: [f64; 3],
    /// a, in mm m/s.
    potential: [f64; 3],
    /// k × a, in m/s.
    velocity_m_s: [f64; 3],
    /// φ.
    phase: f64,
}

impl Default for RoundJet {
    /// The paper's experiment: D = 18 mm, Re = bulk · D/ν = 1.6·10⁴ in air of 298 K (ν = 15.6 mm²/s), a volume
    /// that begins 1.38 D above the outlet and is centred 0.33 D beside the axis, 16 m/s in the core.
    fn default() -> Self {
        Self {
            diameter_mm: 18.0,
            bulk_m_s: 13.9,
            peak_m_s: 16.0,
            outlet_mm: [5.94, -29.84, 0.0],
            momentum_thickness_mm: 0.4,
            growth: 0.0425,
            rms_m_s: 1.6,
            quiet_share: 0.2,
            wavelengths_mm: [5.0, 20.0],
            realisation: None,
            waves: DrawnWaves::default(),
        }
    }
}

/// What the profile is made of at a place.
struct Profile {
    /// Position relative to the outlet, in mm.
    from_outlet_mm: [f64; 3],
    /// ζ.
    zeta: f64,
    /// s in mm², and its growth ∂s/∂y in mm.
    s: f64,
    growth: f64,
    /// R², in mm².
    core: f64,
}

impl RoundJet {
    /// The flow of a shot: with fluctuations of its own, unless a realisation is set.
    pub fn of_shot(&self, seed: u64, shot: u64) -> Self {
        let realisation = self.realisation.or(Some([seed, shot]));
        Self { realisation, waves: DrawnWaves::default(), ..self.clone() }
    }

    /// Mean over all realisations of (u, v, w), in m/s.
    pub fn mean_m_s(&self, position_mm: [f64; 3]) -> [f64; 3] {
        let Profile { from_outlet_mm: [x, _, z], zeta, s, growth, core } =
            self.profile(position_mm);
        let along = self.peak_m_s / 2.0 * (1.0 - zeta.tanh());
        // ∂ψ/∂y = V/4 ∂s/∂y (G(ζ) − G(R²/s)), G(ζ) = ζ tanh ζ − ln cosh ζ; on the axis by its slope.
        let g = |zeta: f64| zeta * zeta.tanh() - ln_cosh(zeta);
        let q = x * x + z * z;
        let per_q = if q > 1e-9 * core {
            (g(zeta) - g(core / s)) / q
        } else {
            let zeta = -core / s;
            zeta / zeta.cosh().powi(2) / s
        };
        let inwards = self.peak_m_s / 4.0 * growth * per_q;
        [-x * inwards, along, -z * inwards]
    }

    /// Root mean square over all realisations of the fluctuations of (u, v, w), in m/s.
    pub fn rms_m_s(&self, position_mm: [f64; 3]) -> [f64; 3] {
        let (g, gradient) = self.envelope(&self.profile(position_mm));
        let potential_mm = self.potential_rms_mm() * self.rms_m_s;
        let square: f64 = gradient.iter().map(|g| g * g).sum();
        gradient.map(|along| {
            let bent = (square - along * along) * potential_mm.powi(2);
            ((g * self.rms_m_s).powi(2) + bent).sqrt()
        })
    }

    pub(super) fn velocity_m_s(&self, position_mm: [f64; 3]) -> [f64; 3] {
        let mut velocity = self.mean_m_s(position_mm);
        let Some(realisation) = self.realisation else { return velocity };
        let (g, gradient) = self.envelope(&self.profile(position_mm));
        let (mut potential, mut curl) = ([0.0; 3], [0.0; 3]);
        for wave in self.waves.get_or_draw(|| self.draw(realisation)) {
            let angle: f64 = (0..3).map(|c| wave.number_per_mm[c] * position_mm[c]).sum();
            let (sin, cos) = (angle + wave.phase).sin_cos();
            for c in 0..3 {
                potential[c] += wave.potential[c] * cos;
                curl[c] -= wave.velocity_m_s[c] * sin;
            }
        }
        let bent = cross(gradient, potential);
        for c in 0..3 {
            velocity[c] += g * curl[c] + bent[c];
        }
        velocity
    }

    fn profile(&self, position_mm: [f64; 3]) -> Profile {
        let from_outlet_mm: [f64; 3] =
            std::array::from_fn(|axis| position_mm[axis] - self.outlet_mm[axis]);
        let [x, y, z] = from_outlet_mm;
        let core = (self.diameter_mm / 2.0).powi(2) * self.bulk_m_s / self.peak_m_s;
        let scale = 4.0 * core.sqrt();
        let (thickness, least) = (
            self.momentum_thickness_mm + self.growth * y,
            LEAST_THICKNESS * self.momentum_thickness_mm,
        );
        let growth = if thickness > least { scale * self.growth } else { 0.0 };
        let s = scale * thickness.max(least);
        Profile { from_outlet_mm, zeta: (x * x + z * z - core) / s, s, growth, core }
    }

    /// g and its gradient per mm.
    fn envelope(&self, profile: &Profile) -> (f64, [f64; 3]) {
        let Profile { from_outlet_mm: [x, _, z], zeta, s, growth, .. } = profile;
        let bump = (1.0 - self.quiet_share) * (-zeta * zeta / 2.0).exp();
        let slope = -bump * zeta;
        let of_zeta = [2.0 * x / s, -zeta * growth / s, 2.0 * z / s];
        (self.quiet_share + bump, of_zeta.map(|c| slope * c))
    }

    /// Wave number n, spaced evenly in log k, in rad/mm.
    fn number_per_mm(&self, n: usize) -> f64 {
        let [longest, shortest] = [1, 0].map(|n| TAU / self.wavelengths_mm[n]);
        longest * (shortest / longest).powf((n as f64 + 0.5) / WAVES as f64)
    }

    /// σ_A / σ, in mm.
    fn potential_rms_mm(&self) -> f64 {
        let sum = |power: f64| (0..WAVES).map(|n| self.number_per_mm(n).powf(power)).sum::<f64>();
        // |a| = |velocity| / k, and velocity² ∝ k^(−2/3).
        (sum(-8.0 / 3.0) / sum(-2.0 / 3.0)).sqrt()
    }

    fn draw(&self, realisation: [u64; 2]) -> Vec<Wave> {
        let mut rng = random_stream(Purpose::RoundJet, &realisation);
        let squares: f64 = (0..WAVES).map(|n| self.number_per_mm(n).powf(-2.0 / 3.0)).sum();
        // The mean of sin² is 1/2, and the squared amplitude includes three components.
        let scale = self.rms_m_s * (6.0 / squares).sqrt();
        (0..WAVES)
            .map(|n| {
                let along = direction(&mut rng);
                let across = perpendicular(&mut rng, along);
                let number = self.number_per_mm(n);
                let speed_m_s = scale * number.powf(-1.0 / 3.0);
                Wave {
                    number_per_mm: along.map(|c| number * c),
                    potential: across.map(|c| speed_m_s / number * c),
                    velocity_m_s: cross(along, across).map(|c| speed_m_s * c),
                    phase: rng.random_range(0.0..TAU),
                }
            })
            .collect()
    }
}

/// Accurate for any argument.
fn ln_cosh(x: f64) -> f64 {
    let x = x.abs();
    x + (-2.0 * x).exp().ln_1p() - std::f64::consts::LN_2
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Places relative to the axis and the outlet, in mm: core, shear layer, outside.
    const PLACES: [[f64; 3]; 5] = [
        [0.0, 28.0, 0.0],
        [3.0, 26.0, -2.0],
        [-8.0, 30.0, 1.0],
        [-6.0, 10.0, 6.5],
        [-11.0, 32.0, 2.0],
    ];

    fn at(jet: &RoundJet, place: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|c| jet.outlet_mm[c] + place[c])
    }

    fn divergence_per_s(of: impl Fn([f64; 3]) -> [f64; 3], place_mm: [f64; 3]) -> f64 {
        let half_mm = 1e-3;
        let slope = |axis: usize| {
            let (mut low, mut high) = (place_mm, place_mm);
            low[axis] -= half_mm;
            high[axis] += half_mm;
            (of(high)[axis] - of(low)[axis]) * 1000.0 / (2.0 * half_mm)
        };
        (0..3).map(slope).sum()
    }

    #[test]
    fn the_mean_has_the_bulk_flux_at_the_outlet_draws_in_fluid_and_spreads() {
        let jet = RoundJet::default();
        // Over annuli up to 40 mm, as a share of that of the nozzle.
        let step = 0.01;
        let nozzle = jet.bulk_m_s * std::f64::consts::PI * 81.0;
        let flux = |y: f64| -> f64 {
            let of_annulus = |n: i32| {
                let r = (f64::from(n) + 0.5) * step;
                jet.mean_m_s(at(&jet, [r, y, 0.0]))[1] * TAU * r * step / nozzle
            };
            (0..4000).map(of_annulus).sum()
        };
        assert!((flux(3.0) - 1.0).abs() < 1e-3, "{}", flux(3.0));
        // What it has more further up has come in through the cylinder around.
        let drawn_in: f64 = (0..3000)
            .map(|n| {
                let y = 4.0 + (f64::from(n) + 0.5) * step;
                -jet.mean_m_s(at(&jet, [0.0, y, 40.0]))[2] * TAU * 40.0 * step / nozzle
            })
            .sum();
        let more = flux(34.0) - flux(4.0);
        assert!(more > 0.02 && (drawn_in / more - 1.0).abs() < 1e-2, "{drawn_in} {more}");
        let speed = |r: f64, y: f64| jet.mean_m_s(at(&jet, [r, y, 0.0]))[1];
        assert!((speed(0.0, 10.0) / 16.0 - 1.0).abs() < 1e-2);
        assert!(speed(11.0, 30.0) > 2.0 * speed(11.0, 15.0), "the layer spreads");
        // Its vorticity thickness, V over the steepest slope, is 4 θ (q instead of r: within a tenth).
        let slope = (1..1200).map(|n| f64::from(n) * 0.01).fold(0.0_f64, |most, r| {
            most.max((speed(r - 0.005, 28.0) - speed(r + 0.005, 28.0)) / 0.01)
        });
        let thickness = 4.0 * (0.4 + 0.0425 * 28.0);
        assert!((16.0 / slope / thickness - 1.0).abs() < 0.1, "{}", 16.0 / slope);
    }

    #[test]
    fn mean_and_realisations_are_free_of_divergence() {
        let jet = RoundJet::default();
        let shot = jet.of_shot(1, 5);
        for place in PLACES {
            let place = at(&jet, place);
            let mean = divergence_per_s(|at| jet.mean_m_s(at), place);
            let all = divergence_per_s(|at| shot.velocity_m_s(at), place);
            // Velocity gradients are some 1000/s.
            assert!(mean.abs() < 0.01 && all.abs() < 0.01, "{place:?}: {mean} {all}");
        }
    }

    #[test]
    fn realisations_have_the_mean_and_the_rms_that_are_stated() {
        let jet = RoundJet::default();
        const SHOTS: u64 = 6000;
        let mut sums = [[[0.0; 3]; 2]; PLACES.len()];
        for shot in 0..SHOTS {
            let flow = jet.of_shot(3, shot);
            for (sums, place) in sums.iter_mut().zip(PLACES) {
                let place = at(&jet, place);
                let (found, mean) = (flow.velocity_m_s(place), jet.mean_m_s(place));
                for c in 0..3 {
                    sums[0][c] += found[c] - mean[c];
                    sums[1][c] += (found[c] - mean[c]).powi(2);
                }
            }
        }
        for (sums, place) in sums.iter().zip(PLACES) {
            let rms = jet.rms_m_s(at(&jet, place));
            for c in 0..3 {
                let [offset, square] = sums.map(|sum| sum[c] / SHOTS as f64);
                // Four standard errors: of a mean, and of a standard deviation.
                let (n, found) = (SHOTS as f64, square.sqrt());
                assert!(offset.abs() < 4.0 * rms[c] / n.sqrt(), "{place:?} {c}: {offset}");
                let error = (found / rms[c] - 1.0).abs();
                assert!(error < 4.0 / (2.0 * n).sqrt(), "{place:?} {c}: {found} {}", rms[c]);
            }
        }
    }

    #[test]
    fn shots_differ_and_can_be_repeated() {
        let jet = RoundJet::default();
        let place = [0.5, 0.0, -1.0];
        assert_eq!(jet.velocity_m_s(place), jet.mean_m_s(place));
        let velocity = |seed, shot| jet.of_shot(seed, shot).velocity_m_s(place);
        assert_eq!(velocity(1, 2), velocity(1, 2));
        assert_ne!(velocity(1, 2), velocity(1, 3));
        assert_ne!(velocity(1, 2), velocity(2, 2));
        let fixed = RoundJet { realisation: Some([1, 2]), ..jet.clone() };
        assert_eq!(fixed.of_shot(7, 8).velocity_m_s(place), velocity(1, 2));
        let text = toml::to_string(&jet.of_shot(1, 2)).unwrap();
        let read: RoundJet = toml::from_str(&text).unwrap();
        assert_eq!(read.velocity_m_s(place), velocity(1, 2));
    }
}
