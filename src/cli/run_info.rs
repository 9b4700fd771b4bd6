//! Settings of a run as shown by the server.

use std::path::Path;

use lfpiv_core::model::ModelMode;
use lfpiv_hw::CameraName;

use super::{daemon_plan::DaemonPlan, solver::solver_name};
use crate::{
    acquisition::OverloadPolicy,
    config::{ConfigFile, MaskFile, StoredMask},
    server::{
        BenchSettings, CalibrationSummary, ConfigurationSummary, MaskFileSummary, MaskSummary,
        RunInfo, VolumeViews,
    },
};

/// The configured bench as shown by the server.
pub(super) fn bench_settings(file: &ConfigFile) -> BenchSettings {
    BenchSettings {
        configuration: file.text.clone(),
        optics: file.config.optics.clone(),
        timing: file.config.timing.clone(),
        mask: file.config.mask.as_ref().map(|stored| stored.mask.clone()),
        views: VolumeViews::new(&file.config),
    }
}

pub(super) fn run_info(plan: &DaemonPlan, folder: &Path) -> RunInfo {
    let config = &plan.file.config;
    let solver = solver_name(config.reconstruction.solver);
    let refinement = config.reconstruction.refinement;
    RunInfo {
        code_version: env!("CARGO_PKG_VERSION").to_owned(),
        model: format!("separable thin lens; {}", config.reconstruction.footprint.reason()),
        solver: match config.model.mode {
            ModelMode::Explicit => format!("{solver}, voxels split by {refinement}"),
            ModelMode::Auto => format!("{solver}, voxels split by up to {refinement}"),
        },
        configuration: ConfigurationSummary {
            file: plan.file.path.clone(),
            simulated: config.simulation.is_some(),
            cameras: (0..config.camera.len()).map(|index| CameraName(index).to_string()).collect(),
            calibrations: config
                .calibration
                .iter()
                .map(|stored| CalibrationSummary {
                    camera: CameraName(stored.camera - 1).to_string(),
                    file: stored.file.clone(),
                    sha256: stored.sha256.clone(),
                })
                .collect(),
            mask: config.mask.as_ref().map(mask_summary),
            voxels_xyz: config.volume.voxels,
            voxel_mm: config.volume.voxel_mm,
            centre_mm: config.volume.centre_mm,
            max_displacement_vox: config.velocimetry.max_displacement_vox,
            window_mm: config.velocimetry.window_mm,
            place_particles: config.velocimetry.may_place(config.mask.is_some()),
            dt_us: config.shot.dt_us,
            rate_hz: config.shot.rate_hz,
            shots: plan.shots.map(|shots| shots.get()),
            overload: match plan.overload {
                OverloadPolicy::Shed => "shed".to_owned(),
                OverloadPolicy::Wait => "wait".to_owned(),
            },
            queue: config.pipeline.queue,
        },
        results_dir: folder.to_owned(),
        paraview: config.output.paraview,
    }
}

fn mask_summary(stored: &StoredMask) -> MaskSummary {
    let summary =
        |file: &MaskFile| MaskFileSummary { file: file.file.clone(), sha256: file.sha256.clone() };
    MaskSummary {
        flow_share: stored.mask.flow_share(),
        files: stored.files.iter().map(summary).collect(),
    }
}
