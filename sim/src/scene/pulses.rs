//! Exposures with arbitrary light pulses.

use super::{FrameOfPair, Scene, SimulatedShot, Truth, stream_key};
use crate::{
    geometry::BenchGeometry,
    imaging::{ElectronImage, PointSource},
    particles::Tracer,
};

/// A laser pulse.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LightPulse {
    /// Time relative to the middle of the pulse pair, in s.
    pub at_s: f64,
    /// Energy relative to a nominal pulse.
    pub energy: f64,
}

impl Scene {
    /// One shot as recorded by all cameras when the given pulses fall into exposures 1 and 2 of
    /// each camera. Particles are where the flow has carried them at the time of a pulse. Pulses in
    /// one exposure add up. An exposure without pulses shows background and noise.
    ///
    /// With one pulse of energy 1 at half a pulse separation before the middle in exposure 1, and
    /// one at half a separation after it in exposure 2, the result equals [`Scene::shot`] bit for
    /// bit. Particles are seeded for the pulse separation of `bench`; a pulse further from the
    /// middle finds fewer particles where the flow enters the light sheet.
    pub fn exposures(
        &self,
        bench: &BenchGeometry,
        seed: u64,
        shot: u64,
        light: &[[Vec<LightPulse>; 2]],
    ) -> SimulatedShot {
        let particles = self.numbered_particles(bench, seed, shot);
        let truth = self.truth(bench, seed, shot);
        let images = (0..bench.poses.len())
            .map(|camera| {
                [FrameOfPair::A, FrameOfPair::B].map(|frame| {
                    let pulses = light.get(camera).map_or(&[][..], |l| &l[frame as usize]);
                    let key = stream_key(&truth, camera, frame);
                    let light = self.light_of_pulses(bench, &particles, camera, pulses, key);
                    self.sensor_of(camera).expose(&light, &key)
                })
            })
            .collect();
        SimulatedShot { images, truth: Truth { dt_s: bench.dt_s, ..truth } }
    }

    /// All particles. Those lit in a nominal pair come first, numbered as in [`Scene::shot`].
    fn numbered_particles(&self, bench: &BenchGeometry, seed: u64, shot: u64) -> Vec<Tracer> {
        let (volume, pitch_mm) = (&bench.volume, bench.object_pitch_mm());
        let flow = self.flow.of_shot(seed, shot);
        let all =
            self.seeding(bench).all_particles(volume, pitch_mm, &flow, bench.dt_s, (seed, shot));
        let (mut lit, dark): (Vec<_>, Vec<_>) =
            all.into_iter().partition(|particle| particle.visible_a || particle.visible_b);
        lit.extend(dark);
        lit
    }

    fn light_of_pulses(
        &self,
        bench: &BenchGeometry,
        particles: &[Tracer],
        camera: usize,
        pulses: &[LightPulse],
        key: [u64; 4],
    ) -> ElectronImage {
        let Some(tracer) = self.tracer(bench, camera) else {
            return ElectronImage::dark(&bench.optics);
        };
        let mut images = pulses
            .iter()
            .filter(|pulse| pulse.energy > 0.0)
            .map(|pulse| tracer.trace(&self.lit_by(bench, particles, pulse, key), &key));
        let mut sum = images.next().unwrap_or_else(|| ElectronImage::dark(&bench.optics));
        images.for_each(|image| sum.add(&image));
        sum
    }

    fn lit_by(
        &self,
        bench: &BenchGeometry,
        particles: &[Tracer],
        pulse: &LightPulse,
        exposure: [u64; 4],
    ) -> Vec<PointSource> {
        let (seeding, flow) = (self.seeding(bench), self.flow.of_shot(exposure[0], exposure[1]));
        let lit = particles.iter().zip(0..).filter_map(|(particle, id)| {
            let position_mm = seeding.lit_mm(particle, &bench.volume, &flow, pulse.at_s)?;
            let electrons = self.electrons(particle, id, exposure) * pulse.energy;
            Some(PointSource { id, position_mm, electrons })
        });
        lit.collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        Flow, SensorSettings,
        flow::{Abc, RoundJet},
        scene::Lighting,
        test_bench,
    };

    fn scene() -> Scene {
        let flow =
            Flow::Abc(Abc { wavelength_mm: 10.0, amplitude_m_s: 1.0, coefficients: [1.0; 3] });
        Scene { rays_per_particle: 400, flow, ..Scene::default() }
    }

    fn pulse(at_s: f64, energy: f64) -> Vec<LightPulse> {
        vec![LightPulse { at_s, energy }]
    }

    fn lit(light: [Vec<LightPulse>; 2]) -> Vec<[Vec<LightPulse>; 2]> {
        vec![light.clone(), light]
    }

    fn light_counts(image: &lfpiv_hw::RawImage) -> f64 {
        image.counts().iter().map(|&count| f64::from(count) - 64.0).sum()
    }

    #[test]
    fn the_planned_pulses_give_the_planned_shot_bit_for_bit() {
        let bench = test_bench::small();
        let half_s = bench.dt_s / 2.0;
        let lighting = Lighting { pulse_energy: [1.0, 0.7], frame_spread: 0.2, ..scene().lighting };
        let uneven =
            Scene { camera_shift_mm: vec![[0.0; 3], [0.03, 0.0, 0.0]], lighting, ..scene() };
        let unsteady = Scene { flow: Flow::RoundJet(RoundJet::default()), ..scene() };
        assert_ne!(unsteady.truth(&bench, 1, 0).flow, unsteady.truth(&bench, 1, 1).flow);
        for (scene, seed, shot) in
            [(scene(), 1, 0), (scene(), 7, 3), (uneven, 1, 0), (unsteady, 2, 1)]
        {
            let light = lit([pulse(-half_s, 1.0), pulse(half_s, 1.0)]);
            let rendered = scene.exposures(&bench, seed, shot, &light);
            assert_eq!(rendered, scene.shot(&bench, seed, shot));
        }
    }

    #[test]
    fn without_light_there_is_background_and_noise() {
        let bench = test_bench::small();
        let sensor = SensorSettings { background_electrons: 50.0, ..SensorSettings::default() };
        let scene = Scene { sensor, ..scene() };
        let dark = scene.exposures(&bench, 1, 0, &lit([Vec::new(), pulse(0.0, 0.0)]));
        for image in dark.images.iter().flatten() {
            let mean = light_counts(image) / image.counts().len() as f64;
            assert!((mean - 50.0).abs() < 0.5, "{mean}");
            assert!(image.counts().iter().any(|count| *count != image.counts()[0]));
        }
    }

    #[test]
    fn energies_scale_and_pulses_in_one_exposure_add_up() {
        let bench = test_bench::small();
        let scene = Scene { sensor: SensorSettings::default().noise_free(), ..scene() };
        let half_s = bench.dt_s / 2.0;
        let both = [pulse(-half_s, 1.0), pulse(half_s, 1.0)].concat();
        let shot = scene.exposures(&bench, 1, 0, &lit([both, pulse(half_s, 0.5)]));
        let usual = scene.shot(&bench, 1, 0);
        let [sum, half] = &shot.images[0];
        let [a, b] = &usual.images[0];
        assert!((light_counts(sum) / (light_counts(a) + light_counts(b)) - 1.0).abs() < 0.01);
        assert!((light_counts(half) / light_counts(b) - 0.5).abs() < 0.01);
    }

    #[test]
    fn a_pulse_at_another_time_shows_particles_elsewhere() {
        let bench = test_bench::small();
        let half_s = bench.dt_s / 2.0;
        let late =
            scene().exposures(&bench, 1, 0, &lit([pulse(-half_s, 1.0), pulse(2.0 * half_s, 1.0)]));
        let usual = scene().shot(&bench, 1, 0);
        assert_eq!(late.images[0][0], usual.images[0][0]);
        assert_ne!(late.images[0][1], usual.images[0][1]);
    }
}
