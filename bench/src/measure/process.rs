//! The whole process, as a user runs it: configuration, TIFF in, NetCDF out.

use std::{fs, io::Write, path::Path};

use lfpiv::{
    archive::{FileDepth, write_pair, write_replacing},
    pipeline::monotonic,
};
use lfpiv_core::{measurement::Processor, statistics::median};

use super::{Findings, Surroundings, velocity};
use crate::{BenchmarkError, Method, case::Setting, child};

/// Runs `lfpiv process` on every seed's pair; the median of the repeats counts. Errors are
/// those of the same pair measured in this process, bit for bit the same.
pub(super) fn measure(
    setting: &Setting,
    methods: &[Option<&Method>],
    surroundings: &mut Surroundings,
    findings: &mut Findings,
) -> Result<(), BenchmarkError> {
    let folder = surroundings.work.join("pair");
    for &seed in &setting.case.seeds {
        let shot = velocity::simulated(setting, seed);
        write_pair(&folder, &shot.pair, FileDepth::for_sensor_bits(setting.scene.sensor.bits))?;
        for &method in methods {
            let taken = repeated(setting, method, surroundings, &folder)?;
            let processor = Processor::timed(setting.config_with(method).measurement(), monotonic)?;
            let mut measured = velocity::measured(setting, method, &processor, &shot)?;
            measured.row.seconds = Some(taken.seconds);
            measured.row.seconds_of = format!(
                "lfpiv process on one pair from start to end, median of {}",
                setting.case.repeats
            );
            measured.row.cpu_s = taken.cpu_seconds;
            measured.row.peak_mb = taken.peak_bytes.map(|bytes| bytes as f64 / 1e6);
            velocity::add(measured, surroundings, findings);
        }
        // The next seed's pair may take this one's place; a folder left behind costs room alone.
        let _ = fs::remove_dir_all(&folder);
    }
    Ok(())
}

/// The median times and the largest peak of the repeats.
fn repeated(
    setting: &Setting,
    method: Option<&Method>,
    surroundings: &Surroundings,
    pair: &Path,
) -> Result<child::Taken, BenchmarkError> {
    let config = surroundings.work.join("case.toml");
    let text = toml::to_string(&setting.config_with(method)).map_err(|error| {
        BenchmarkError::Malformed { path: config.clone(), reason: error.to_string() }
    })?;
    write_replacing(&config, |writer| writer.write_all(text.as_bytes()))?;
    let results = surroundings.work.join("results");
    let runs = (0..setting.case.repeats.max(1))
        .map(|_| child::process(surroundings.program, &config, &results, pair))
        .collect::<Result<Vec<_>, _>>()?;
    Ok(child::Taken {
        seconds: median(runs.iter().map(|run| run.seconds)).unwrap_or_default(),
        cpu_seconds: median(runs.iter().filter_map(|run| run.cpu_seconds)),
        peak_bytes: runs.iter().filter_map(|run| run.peak_bytes).max(),
    })
}
