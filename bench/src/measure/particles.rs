//! Particles placed in the images of a pair, as they are stored, against those that made the images.

use lfpiv::pipeline::monotonic;
use lfpiv_core::{
    measurement::{Measurement, Processor},
    velocimetry::Placing,
};

use super::{
    Findings, Surroundings,
    velocity::{calibrations, simulated},
};
use crate::{BenchmarkError, Method, case::Setting, particle_score::ParticleScore};

/// Measures every seed's shot with every method.
pub(super) fn measure(
    setting: &Setting,
    methods: &[Option<&Method>],
    surroundings: &mut Surroundings,
    findings: &mut Findings,
) -> Result<(), BenchmarkError> {
    let calibrations = calibrations(setting, surroundings)?;
    for &method in methods {
        let mut config = setting.config_with(method);
        config.velocimetry.place_particles = Placing::Always;
        let measurement =
            Measurement { calibrations: calibrations.clone(), ..config.measurement() };
        let processor = Processor::timed(measurement, monotonic)?;
        for &seed in &setting.case.seeds {
            let shot = simulated(setting, seed);
            let result = processor.process(&shot.pair)?;
            // A pair that does not fit the bench has no particles.
            let particles = result.particles.as_deref().unwrap_or_default();
            let score = ParticleScore::of(particles, &shot.truth, setting);
            let mut row = setting.row(method, seed);
            row.seconds = Some(result.seconds.total_s());
            row.seconds_of =
                "one pair in a running program: decode, reconstruct, correlate, place".to_owned();
            row.set_particles(&score);
            findings.add(row, surroundings);
        }
    }
    Ok(())
}
