//! Particles placed in the images of a pair, against those that made them; seconds beside those of the
//! vectors alone.

use lfpiv::pipeline::monotonic;
use lfpiv_core::measurement::{Measurement, Processor};

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
        let measurement = Measurement {
            calibrations: calibrations.clone(),
            ..setting.config_with(method).measurement()
        };
        let processor = Processor::timed(measurement, monotonic)?;
        for &seed in &setting.case.seeds {
            let shot = simulated(setting, seed);
            let started = monotonic();
            let (result, placed) = processor.process_with_particles(&shot.pair)?;
            let seconds = (monotonic() - started).as_secs_f64();
            let score = ParticleScore::of(&placed, &shot.truth, setting);
            let mut row = setting.row(method, seed);
            row.seconds = Some(seconds);
            row.seconds_of = "one pair in a running program: vectors, then particles".to_owned();
            row.vectors_s = Some(result.seconds.total_s());
            row.set_particles(&score);
            findings.add(row, surroundings);
        }
    }
    Ok(())
}
