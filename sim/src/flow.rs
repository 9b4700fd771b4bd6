//! Known flows that carry the particles of a simulated shot.
//!
//! Every flow is steady while a shot lasts and defined in the world frame (mm); velocities are in m/s, and 1 m/s is
//! 1000 mm/s. Particle paths are integrated from the middle of the pulse pair, half a pulse
//! separation backwards and half forwards.

mod drawn;
mod fields;
mod round_jet;
mod sampled;
mod turbulence;

use std::path::Path;

use garde::Validate;
use serde::{Deserialize, Serialize};

pub use fields::{
    Abc, Axis, Jet, LinearShear, PlaneWave, RingVortex, ShearLayer, SolidRotation, Uniform,
};
pub use round_jet::RoundJet;
pub use sampled::{SampledFlow, SampledFlowError};
pub use turbulence::Turbulence;

/// mm/s in one m/s.
pub(crate) const MM_PER_M: f64 = 1000.0;

/// Runge-Kutta steps from the middle of the pair to either frame.
///
/// A step of a 0.3 mm displacement pair is then 0.01 mm, a hundredth of the ring's core.
const STEPS_PER_HALF: usize = 16;

/// The same in a flow of random waves that are long beside a displacement, and between samples: a step of a 1 mm pair
/// is 0.13 mm.
const STEPS_PER_HALF_OF_LONG_WAVES: usize = 4;

/// Steps by which the particle is found whose two positions average to a place: each leaves a hundredth.
const MEAN_STEPS: usize = 5;

/// A steady velocity field.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(tag = "kind", rename_all = "kebab-case")]
pub enum Flow {
    /// The same velocity everywhere.
    Uniform(#[garde(dive)] Uniform),
    /// One component grows along another axis.
    LinearShear(#[garde(dive)] LinearShear),
    /// Rigid rotation about the z axis through the origin.
    SolidRotation(#[garde(dive)] SolidRotation),
    /// A vortex ring about the z axis, centred at the origin.
    RingVortex(#[garde(dive)] RingVortex),
    /// A round jet along y.
    Jet(#[garde(dive)] Jet),
    /// Arnold-Beltrami-Childress flow: smooth, periodic, three-dimensional.
    Abc(#[garde(dive)] Abc),
    /// Two streams with a thin layer between them.
    ShearLayer(#[garde(dive)] ShearLayer),
    /// A transverse plane wave.
    PlaneWave(#[garde(dive)] PlaneWave),
    /// Random waves with Kolmogorov's spectrum between two wavelengths.
    Turbulence(#[garde(dive)] Turbulence),
    /// A spreading round jet along y whose fluctuations differ from shot to shot.
    RoundJet(#[garde(dive)] RoundJet),
    /// Samples on a grid, read from a file.
    Sampled(#[garde(dive)] SampledFlow),
}

impl Flow {
    /// Velocity at a world position, in m/s.
    pub fn velocity_m_s(&self, position_mm: [f64; 3]) -> [f64; 3] {
        match self {
            Flow::Uniform(flow) => flow.velocity_m_s,
            Flow::LinearShear(flow) => flow.velocity_m_s(position_mm),
            Flow::SolidRotation(flow) => flow.velocity_m_s(position_mm),
            Flow::RingVortex(flow) => flow.velocity_m_s(position_mm),
            Flow::Jet(flow) => flow.velocity_m_s(position_mm),
            Flow::Abc(flow) => flow.velocity_m_s(position_mm),
            Flow::ShearLayer(flow) => flow.velocity_m_s(position_mm),
            Flow::PlaneWave(flow) => flow.velocity_m_s(position_mm),
            Flow::Turbulence(flow) => flow.velocity_m_s(position_mm),
            Flow::RoundJet(flow) => flow.velocity_m_s(position_mm),
            Flow::Sampled(flow) => flow.velocity_m_s(position_mm),
        }
    }

    /// Makes the relative path of a file with samples one relative to `folder`.
    pub fn in_folder(&mut self, folder: &Path) {
        if let Flow::Sampled(flow) = self {
            flow.in_folder(folder);
        }
    }

    /// Reads the samples of a flow that has some.
    ///
    /// # Errors
    /// The file cannot be read, or holds something else than samples of a velocity.
    pub fn load(&self) -> Result<(), SampledFlowError> {
        match self {
            Flow::Sampled(flow) => flow.load(),
            _ => Ok(()),
        }
    }

    /// The flow of one shot of a run: itself, or where shots differ, that of `seed` and `shot`.
    pub fn of_shot(&self, seed: u64, shot: u64) -> Self {
        match self {
            Flow::RoundJet(flow) => Flow::RoundJet(flow.of_shot(seed, shot)),
            steady => steady.clone(),
        }
    }

    /// Position after `duration_s` of the particle that is at `position_mm` now, in mm; a negative
    /// duration gives an earlier position. Classical fourth-order Runge-Kutta.
    pub fn advect_mm(&self, position_mm: [f64; 3], duration_s: f64) -> [f64; 3] {
        let steps = match self {
            Flow::RoundJet(_) | Flow::Sampled(_) => STEPS_PER_HALF_OF_LONG_WAVES,
            _ => STEPS_PER_HALF,
        };
        let step = duration_s * MM_PER_M / steps as f64;
        (0..steps).fold(position_mm, |at, _| self.runge_kutta_step(at, step))
    }

    /// Displacement x_b − x_a in mm, over a pulse pair with separation `dt_s`, of the particle that
    /// is at `position_mm` in the middle of the pair.
    pub fn displacement_mm(&self, position_mm: [f64; 3], dt_s: f64) -> [f64; 3] {
        let before = self.advect_mm(position_mm, -dt_s / 2.0);
        let after = self.advect_mm(position_mm, dt_s / 2.0);
        std::array::from_fn(|axis| after[axis] - before[axis])
    }

    /// The same of the particle whose two positions average to `mean_mm`: on a curved path it is beside that
    /// place in the middle of the pair, by (d·∇)d/8.
    pub fn displacement_about_mm(&self, mean_mm: [f64; 3], dt_s: f64) -> [f64; 3] {
        let mut middle_mm = mean_mm;
        for _ in 0..MEAN_STEPS {
            let ends = [-0.5, 0.5].map(|part| self.advect_mm(middle_mm, part * dt_s));
            middle_mm = std::array::from_fn(|axis| {
                middle_mm[axis] + mean_mm[axis] - (ends[0][axis] + ends[1][axis]) / 2.0
            });
        }
        self.displacement_mm(middle_mm, dt_s)
    }

    /// One step of length `step`, in mm per (m/s).
    fn runge_kutta_step(&self, at: [f64; 3], step: f64) -> [f64; 3] {
        let ahead = |slope: [f64; 3], by: f64| -> [f64; 3] {
            std::array::from_fn(|axis| at[axis] + by * slope[axis])
        };
        let first = self.velocity_m_s(at);
        let second = self.velocity_m_s(ahead(first, step / 2.0));
        let third = self.velocity_m_s(ahead(second, step / 2.0));
        let fourth = self.velocity_m_s(ahead(third, step));
        std::array::from_fn(|axis| {
            at[axis]
                + step / 6.0 * (first[axis] + 2.0 * second[axis] + 2.0 * third[axis] + fourth[axis])
        })
    }
}

impl Default for Flow {
    fn default() -> Self {
        Flow::Uniform(Uniform { velocity_m_s: [0.0; 3] })
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn ring() -> Flow {
        Flow::RingVortex(RingVortex::default())
    }

    fn abc() -> Flow {
        Flow::Abc(Abc { wavelength_mm: 10.0, amplitude_m_s: 1.0, coefficients: [1.0; 3] })
    }

    /// Central-difference divergence, in 1/s.
    fn divergence_per_s(flow: &Flow, position_mm: [f64; 3]) -> f64 {
        let half_mm = 1e-4;
        (0..3)
            .map(|axis| {
                let (mut low, mut high) = (position_mm, position_mm);
                low[axis] -= half_mm;
                high[axis] += half_mm;
                let rise_m_s = flow.velocity_m_s(high)[axis] - flow.velocity_m_s(low)[axis];
                rise_m_s * MM_PER_M / (2.0 * half_mm)
            })
            .sum()
    }

    #[test]
    fn rotation_paths_are_circles() {
        let rate_rad_s = 2000.0;
        let flow = Flow::SolidRotation(SolidRotation { rate_rad_s });
        let dt_s = 500e-6;
        let angle = rate_rad_s * dt_s / 2.0;
        let (x, y) = (3.0_f64, -2.0_f64);
        let moved = flow.displacement_mm([x, y, 1.0], dt_s);
        // Chord of the arc from −angle to +angle: 2 sin(angle) across the radius.
        assert!((moved[0] + 2.0 * angle.sin() * y).abs() < 1e-7, "{moved:?}");
        assert!((moved[1] - 2.0 * angle.sin() * x).abs() < 1e-7, "{moved:?}");
        assert_eq!(moved[2], 0.0);
    }

    #[test]
    fn a_chord_has_its_own_middle() {
        let flow = Flow::SolidRotation(SolidRotation { rate_rad_s: 2000.0 });
        let angle = 0.5_f64;
        let (x, y) = (3.0_f64, -2.0_f64);
        let moved = flow.displacement_about_mm([x, y, 1.0], 500e-6);
        // The middle of the chord is nearer to the axis than the arc by cos(angle).
        assert!((moved[0] + 2.0 * angle.tan() * y).abs() < 1e-4, "{moved:?}");
        assert!((moved[1] - 2.0 * angle.tan() * x).abs() < 1e-4, "{moved:?}");
    }

    #[test]
    fn uniform_flow_moves_by_velocity_times_dt() {
        let flow = Flow::Uniform(Uniform { velocity_m_s: [1.0, -2.0, 0.5] });
        let moved = flow.displacement_mm([0.3, 0.1, 0.0], 100e-6);
        for (got, want) in moved.iter().zip([0.1, -0.2, 0.05]) {
            assert!((got - want).abs() < 1e-12);
        }
    }

    #[test]
    fn the_shipped_ring_has_the_figures_of_design_section_2() {
        let flow = ring();
        let (dt_s, voxel_mm) = (100e-6, 0.1);
        // Swirl peaks at ρ = s with A exp(−1/2): 1.8 voxels.
        let peak_m_s = flow.velocity_m_s([3.5 - 0.9, 0.0, 0.0])[2];
        assert!((peak_m_s * MM_PER_M * dt_s / voxel_mm - 1.8196).abs() < 1e-3);
        // Vorticity in the core is 2 A / s: 0.67 voxel per voxel.
        let turn = flow.velocity_m_s([3.5 - 1e-4, 0.0, 0.0])[2] / 1e-4 * 2.0;
        assert!((turn * MM_PER_M * dt_s - 0.6667).abs() < 1e-3);
    }

    #[test]
    fn flows_are_read_from_tagged_tables_and_unknown_keys_are_refused() {
        let read = |text: &str| toml::from_str::<Flow>(text);
        assert_eq!(read("kind = 'ring-vortex'").unwrap(), ring());
        let shear = "kind = 'linear-shear'\ncomponent = 'x'\nalong = 'y'\nrate_per_s = 100.0";
        assert_eq!(read(shear).unwrap().velocity_m_s([0.0, 2.0, 0.0]), [0.2, 0.0, 0.0]);
        assert!(read("kind = 'ring-vortex'\nradius = 2").is_err());
        assert!(read("kind = 'whirl'").is_err());
        let stretch = read(&shear.replace("'y'", "'x'")).unwrap();
        assert!(stretch.validate().unwrap_err().to_string().contains("along"));
        let nan = read("kind = 'uniform'\nvelocity_m_s = [nan, 0.0, 0.0]").unwrap();
        assert!(nan.validate().is_err());
    }

    #[test]
    fn the_jet_is_a_smooth_top_hat_along_y() {
        let flow = Flow::Jet(Jet { axis_offset_mm: [1.0, -1.0], ..Jet::default() });
        let speed = |radius: f64| flow.velocity_m_s([1.0 + radius, 7.0, -1.0]);
        let jet = Jet::default();
        assert_eq!(speed(0.0), [0.0, jet.peak_m_s, 0.0]);
        assert!((speed(jet.radius_mm)[1] - jet.peak_m_s / 2.0).abs() < 1e-9);
        assert!(speed(2.0 * jet.radius_mm)[1].abs() < 0.01 * jet.peak_m_s);
    }

    #[test]
    fn the_shear_layer_has_its_thickness() {
        let text = "kind = 'shear-layer'\ncomponent = 'x'\nalong = 'y'\ndifference_m_s = 4.0\n\
                    thickness_mm = 0.4\noffset_mm = 1.0";
        let flow: Flow = toml::from_str(text).unwrap();
        let u = |y_mm: f64| flow.velocity_m_s([0.0, y_mm, 0.0])[0];
        assert!((u(1e-6 + 1.0) / 1e-6 - 4.0 / 0.4).abs() < 1e-6);
        assert!((u(5.0) - 2.0).abs() < 1e-9 && (u(-5.0) + 2.0).abs() < 1e-9);
    }

    #[test]
    fn a_plane_wave_is_transverse_for_any_component() {
        let wave = PlaneWave {
            wavelength_mm: 2.4,
            amplitude_m_s: 0.5,
            along: [1.0, 2.0, -1.0],
            component: [1.0, 0.0, 0.0],
            phase_rad: 0.3,
        };
        assert!(wave.validate().is_ok());
        let crest = wave.crest_m_s();
        assert!((crest[0] + 2.0 * crest[1] - crest[2]).abs() < 1e-12, "{crest:?}");
        assert!((crest.iter().map(|c| c * c).sum::<f64>() - 0.25).abs() < 1e-12);
        let along = PlaneWave { component: wave.along, ..wave.clone() };
        assert!(along.validate().is_err());
        assert!(PlaneWave { along: [0.0; 3], ..wave }.validate().is_err());
    }

    proptest! {
        #[test]
        fn abc_jet_and_turbulence_are_free_of_divergence(
            x in -5.0..5.0_f64, y in -5.0..5.0_f64, z in -5.0..5.0_f64,
        ) {
            let turbulence = Flow::Turbulence(Turbulence::default());
            prop_assert!(divergence_per_s(&turbulence, [x, y, z]).abs() < 1e-3);
            prop_assert!(divergence_per_s(&abc(), [x, y, z]).abs() < 1e-3);
            prop_assert!(divergence_per_s(&Flow::Jet(Jet::default()), [x, y, z]).abs() < 1e-3);
        }

        /// The ring's swirl is free of divergence in the meridional plane. Bending the core into a
        /// circle leaves a divergence of exactly u_r / r (see `RingVortex`).
        #[test]
        fn the_rings_divergence_comes_from_its_curvature(
            radius in 1.0..6.0_f64, angle in 0.0..6.2_f64, z in -3.0..3.0_f64,
        ) {
            let at = [radius * angle.cos(), radius * angle.sin(), z];
            let u = ring().velocity_m_s(at);
            let radial_m_s = (u[0] * at[0] + u[1] * at[1]) / radius;
            let expected = radial_m_s * MM_PER_M / radius;
            prop_assert!((divergence_per_s(&ring(), at) - expected).abs() < 1e-2);
        }

        #[test]
        fn paths_can_be_retraced(x in -5.0..5.0_f64, y in -5.0..5.0_f64, z in -5.0..5.0_f64) {
            let there = abc().advect_mm([x, y, z], 50e-6);
            let back = abc().advect_mm(there, -50e-6);
            for (a, b) in back.iter().zip([x, y, z]) {
                prop_assert!((a - b).abs() < 1e-9);
            }
        }
    }
}
