//! The velocity fields with their formulas.

use std::f64::consts::TAU;

use garde::Validate;
use lfpiv_hw::check::finite;
use serde::{Deserialize, Serialize};

use super::MM_PER_M;

/// An axis of the world frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Axis {
    /// First world axis.
    X,
    /// Second world axis.
    Y,
    /// Third world axis.
    Z,
}

/// The same velocity everywhere.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct Uniform {
    /// Velocity (x, y, z), in m/s.
    #[garde(inner(custom(finite), range(min = -1000.0, max = 1000.0)))]
    pub velocity_m_s: [f64; 3],
}

/// Velocity `component` = rate × coordinate `along`; zero at the origin.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct LinearShear {
    /// The velocity component that is not zero.
    #[garde(skip)]
    pub component: Axis,
    /// The coordinate that the velocity is proportional to.
    #[garde(custom(differs(self.component)))]
    pub along: Axis,
    /// Velocity gradient, in 1/s.
    #[garde(custom(finite), range(min = -1e6, max = 1e6))]
    pub rate_per_s: f64,
}

impl LinearShear {
    pub(super) fn velocity_m_s(&self, position_mm: [f64; 3]) -> [f64; 3] {
        let mut velocity = [0.0; 3];
        velocity[self.component as usize] =
            self.rate_per_s * position_mm[self.along as usize] / MM_PER_M;
        velocity
    }
}

/// Rigid rotation about the z axis: velocity = rate × (−y, x, 0).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct SolidRotation {
    /// Angular rate, counter-clockwise seen from +z, in rad/s.
    #[garde(custom(finite), range(min = -1e6, max = 1e6))]
    pub rate_rad_s: f64,
}

impl SolidRotation {
    pub(super) fn velocity_m_s(&self, [x, y, _]: [f64; 3]) -> [f64; 3] {
        let rate = self.rate_rad_s / MM_PER_M;
        [-rate * y, rate * x, 0.0]
    }
}

/// Gaussian vortex ring of docs/theory.md, section 2: axis z, centre at the origin.
///
/// Swirl about the circular core, at distance ρ from it: u_θ(ρ) = A (ρ/s) exp(−ρ²/2s²), which
/// peaks at ρ = s with A exp(−1/2). Inside the ring the fluid moves towards +z for positive A.
/// The field is free of divergence except for the curvature of the core, ∇·u = u_r / r: at most 8 %
/// of the core vorticity for the default ring.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct RingVortex {
    /// Radius R0 of the core's circle, in mm.
    #[garde(custom(finite), range(min = 0.01, max = 1000.0))]
    pub ring_radius_mm: f64,
    /// Core size s, in mm.
    #[garde(custom(finite), range(min = 0.01, max = 1000.0))]
    pub core_radius_mm: f64,
    /// A of the formula, in m/s. The default is 0.30 mm per pair at dt = 100 µs.
    #[garde(custom(finite), range(min = -1000.0, max = 1000.0))]
    pub amplitude_m_s: f64,
}

impl Default for RingVortex {
    fn default() -> Self {
        Self { ring_radius_mm: 3.5, core_radius_mm: 0.9, amplitude_m_s: 3.0 }
    }
}

impl RingVortex {
    pub(super) fn velocity_m_s(&self, [x, y, z]: [f64; 3]) -> [f64; 3] {
        let radius = x.hypot(y);
        let outward = radius - self.ring_radius_mm;
        let s = self.core_radius_mm;
        let decay = (-(outward * outward + z * z) / (2.0 * s * s)).exp();
        let swirl_per_mm = self.amplitude_m_s / s * decay;
        // The radial direction is undefined on the axis; the radial velocity is zero there.
        let radial_per_mm = if radius > 0.0 { swirl_per_mm * z / radius } else { 0.0 };
        [radial_per_mm * x, radial_per_mm * y, -swirl_per_mm * outward]
    }
}

/// A round jet along +y whose profile does not change downstream.
///
/// Smooth top hat with a shear layer of momentum thickness θ (Michalke's profile):
/// v(r) = V/2 · (1 + tanh(R/(4θ) · (R/r − r/R))).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct Jet {
    /// Velocity V on the axis, in m/s; negative for a jet along −y.
    #[garde(custom(finite), range(min = -1000.0, max = 1000.0))]
    pub peak_m_s: f64,
    /// Radius R at half the peak velocity, in mm.
    #[garde(custom(finite), range(min = 0.01, max = 1000.0))]
    pub radius_mm: f64,
    /// Momentum thickness θ of the shear layer, in mm.
    #[garde(custom(finite), range(min = 0.001, max = 1000.0))]
    pub momentum_thickness_mm: f64,
    /// Position (x, z) of the jet's axis, in mm.
    #[garde(inner(custom(finite), range(min = -1000.0, max = 1000.0)))]
    pub axis_offset_mm: [f64; 2],
}

impl Default for Jet {
    fn default() -> Self {
        Self { peak_m_s: 3.0, radius_mm: 3.0, momentum_thickness_mm: 0.3, axis_offset_mm: [0.0; 2] }
    }
}

impl Jet {
    pub(super) fn velocity_m_s(&self, [x, _, z]: [f64; 3]) -> [f64; 3] {
        let ratio = (x - self.axis_offset_mm[0]).hypot(z - self.axis_offset_mm[1]) / self.radius_mm;
        let steepness = self.radius_mm / (4.0 * self.momentum_thickness_mm);
        let profile = (1.0 + (steepness * (1.0 / ratio - ratio)).tanh()) / 2.0;
        [0.0, self.peak_m_s * profile, 0.0]
    }
}

/// Arnold-Beltrami-Childress flow with k = 2π / wavelength and coefficients a, b, c:
///
/// - u = A (a sin kz + c cos ky)
/// - v = A (b sin kx + a cos kz)
/// - w = A (c sin ky + b cos kx)
///
/// With the default coefficients of 1 the peak of each component is **2 A**. For a peak
/// displacement of 2 voxels of 0.1 mm at dt = 100 µs, A is 1.0 m/s.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct Abc {
    /// Wavelength, in mm.
    #[garde(custom(finite), range(min = 0.01, max = 10_000.0))]
    pub wavelength_mm: f64,
    /// A of the formula, in m/s: half the peak of each component.
    #[garde(custom(finite), range(min = -1000.0, max = 1000.0))]
    pub amplitude_m_s: f64,
    /// Coefficients a, b, c.
    #[serde(default = "equal_coefficients")]
    #[garde(inner(custom(finite), range(min = -100.0, max = 100.0)))]
    pub coefficients: [f64; 3],
}

fn equal_coefficients() -> [f64; 3] {
    [1.0; 3]
}

impl Abc {
    pub(super) fn velocity_m_s(&self, position_mm: [f64; 3]) -> [f64; 3] {
        let [(sin_x, cos_x), (sin_y, cos_y), (sin_z, cos_z)] =
            position_mm.map(|coordinate| (TAU * coordinate / self.wavelength_mm).sin_cos());
        let [a, b, c] = self.coefficients.map(|coefficient| coefficient * self.amplitude_m_s);
        [a * sin_z + c * cos_y, b * sin_x + a * cos_z, c * sin_y + b * cos_x]
    }
}

/// Two parallel streams: component u = ΔU/2 · tanh(2 (y − y0)/δ) along another axis y.
///
/// δ = ΔU / max |du/dy| is the vorticity thickness (Brown and Roshko, J. Fluid Mech. 64, 1974).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct ShearLayer {
    /// The velocity component that is not zero.
    #[garde(skip)]
    pub component: Axis,
    /// The coordinate along which the velocity changes.
    #[garde(custom(differs(self.component)))]
    pub along: Axis,
    /// Velocity difference ΔU between the streams at large and at small y, in m/s.
    #[garde(custom(finite), range(min = -1000.0, max = 1000.0))]
    pub difference_m_s: f64,
    /// Vorticity thickness δ, in mm.
    #[garde(custom(finite), range(min = 0.001, max = 1000.0))]
    pub thickness_mm: f64,
    /// Coordinate y0 of the layer's centre, in mm.
    #[serde(default)]
    #[garde(custom(finite), range(min = -1000.0, max = 1000.0))]
    pub offset_mm: f64,
}

impl ShearLayer {
    pub(super) fn velocity_m_s(&self, position_mm: [f64; 3]) -> [f64; 3] {
        let from_middle = position_mm[self.along as usize] - self.offset_mm;
        let mut velocity = [0.0; 3];
        velocity[self.component as usize] =
            self.difference_m_s / 2.0 * (2.0 * from_middle / self.thickness_mm).tanh();
        velocity
    }
}

/// A transverse plane wave: u = A e sin(2π k·x/λ + φ), with perpendicular unit vectors k and e.
///
/// The ratio of measured to true amplitude is the gain of a measurement at that wavelength.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct PlaneWave {
    /// Wavelength λ, in mm.
    #[garde(custom(finite), range(min = 0.01, max = 10_000.0))]
    pub wavelength_mm: f64,
    /// Amplitude A, in m/s.
    #[garde(custom(finite), range(min = -1000.0, max = 1000.0))]
    pub amplitude_m_s: f64,
    /// Direction k of increasing phase, of any length.
    #[garde(inner(custom(finite), range(min = -1000.0, max = 1000.0)), custom(has_length))]
    pub along: [f64; 3],
    /// Direction e of the velocity, of any length; its component along k is ignored.
    #[garde(inner(custom(finite), range(min = -1000.0, max = 1000.0)), custom(is_across(self.along)))]
    pub component: [f64; 3],
    /// Phase φ at the origin, in rad.
    #[serde(default)]
    #[garde(custom(finite), range(min = -1000.0, max = 1000.0))]
    pub phase_rad: f64,
}

impl PlaneWave {
    /// Velocity at the crest of the wave, in m/s.
    pub fn crest_m_s(&self) -> [f64; 3] {
        across(self.component, self.along).map(|c| self.amplitude_m_s * c)
    }

    /// Phase 2π k·x/λ + φ of a world position, in rad.
    pub fn phase_rad_at(&self, position_mm: [f64; 3]) -> f64 {
        let along = unit(self.along);
        TAU * dot(along, position_mm) / self.wavelength_mm + self.phase_rad
    }

    pub(super) fn velocity_m_s(&self, position_mm: [f64; 3]) -> [f64; 3] {
        let sine = self.phase_rad_at(position_mm).sin();
        self.crest_m_s().map(|c| c * sine)
    }
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|c| a[c] * b[c]).sum()
}

fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = dot(v, v).sqrt();
    v.map(|c| c / length)
}

/// The unit vector along the part of `v` that is perpendicular to `to`.
fn across(v: [f64; 3], to: [f64; 3]) -> [f64; 3] {
    let to = unit(to);
    let common = dot(v, to);
    unit(std::array::from_fn(|c| v[c] - common * to[c]))
}

fn has_length(v: &[f64; 3], (): &()) -> garde::Result {
    if dot(*v, *v) > 0.0 {
        Ok(())
    } else {
        Err(garde::Error::new("allowed: a direction, not zero"))
    }
}

fn is_across(along: [f64; 3]) -> impl FnOnce(&[f64; 3], &()) -> garde::Result {
    move |component, ()| {
        let (squares, common) =
            (dot(*component, *component) * dot(along, along), dot(*component, along));
        // The directions must differ by at least a hundredth of a radian.
        if squares > 0.0 && common * common < (1.0 - 1e-4) * squares {
            Ok(())
        } else {
            Err(garde::Error::new("allowed: a direction different from along"))
        }
    }
}

fn differs(component: Axis) -> impl FnOnce(&Axis, &()) -> garde::Result {
    move |along, _| {
        if *along == component {
            Err(garde::Error::new(
                "allowed: an axis other than component, otherwise the flow is not a shear",
            ))
        } else {
            Ok(())
        }
    }
}
