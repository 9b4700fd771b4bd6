//! One frame to a volume: Q and ε against the truth, seconds of the solver.

use std::time::Instant;

use lfpiv_core::reconstruction::{
    DenseVolume,
    quality::{quality_factor, reconstruction_error},
};

use super::{Findings, Surroundings};
use crate::{
    BenchmarkError, Figure, Method, Projection, Row,
    case::Setting,
    truth::{Frame, reconstructor, true_volume},
};

/// Reconstructs frame a of every seed's shot with every method.
pub(super) fn measure(
    setting: &Setting,
    methods: &[Option<&Method>],
    surroundings: &mut Surroundings,
    findings: &mut Findings,
) -> Result<(), BenchmarkError> {
    let shown = setting.case.figures.contains(&Figure::Projection);
    for &method in methods {
        let reconstructor = reconstructor(&setting.config_with(method))?;
        for &seed in &setting.case.seeds {
            let truth = setting.scene.truth(&setting.bench, seed, 0);
            let frame = Frame::simulate(setting, &truth, &reconstructor);
            let started = Instant::now();
            let solved = reconstructor.reconstruct(&frame.views, &frame.levels);
            let seconds = started.elapsed().as_secs_f64();
            let volume = solved.volume.on_grid(&setting.config.volume.grid());
            let expected = true_volume(setting, &truth, &setting.config.volume.grid());
            let mut row = setting.row(method, seed);
            row.seconds = Some(seconds);
            row.seconds_of = "reconstruction of one frame, its start counted".to_owned();
            row.iterations = Some(solved.passes.len());
            fill(&mut row, &volume, &expected);
            if shown && seed == setting.case.seeds[0] {
                let first = findings.projections.iter().all(|p| p.case != row.case);
                if first {
                    let truth = Projection { method: None, ..projected(&row, &expected) };
                    findings.projections.push(truth);
                }
                findings.projections.push(projected(&row, &volume));
            }
            findings.add(row, surroundings);
        }
    }
    Ok(())
}

/// Q and ε of a volume.
pub(super) fn fill(row: &mut Row, volume: &DenseVolume, expected: &DenseVolume) {
    let dark = vec![0.0; expected.intensity.len()];
    let missed = reconstruction_error(&volume.intensity, &expected.intensity);
    row.q = Some(quality_factor(&volume.intensity, &expected.intensity));
    let all = reconstruction_error(&dark, &expected.intensity);
    row.relative_error = (all > 0.0).then(|| missed / all);
}

/// A volume summed along x.
pub(super) fn projected(row: &Row, volume: &DenseVolume) -> Projection {
    let [nx, ny, nz] = volume.grid.voxels;
    Projection {
        case: row.case.clone(),
        method: Some(row.method.clone()),
        cameras: row.cameras,
        ppm: row.ppm,
        size: [ny, nz],
        light: volume.intensity.chunks(nx).map(|along_x| along_x.iter().sum()).collect(),
    }
}
