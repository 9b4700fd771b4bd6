//! Bytes of the explicit weight matrix: whole, as the conventional SART needs it, and by ordered
//! subsets, of which one is held at a time (paper: 1/12).

use lfpiv_core::{
    model::{ExplicitModel, ForwardModel, TableWeights},
    reconstruction::{ReconstructionSettings, Reconstructor, subsets::balanced_subsets},
};

use super::{Findings, Surroundings};
use crate::{BenchmarkError, Method, case::Setting};

/// Counts the entries, for the subsets of every method; holds none of them.
pub(super) fn measure(
    setting: &Setting,
    methods: &[Option<&Method>],
    surroundings: &mut Surroundings,
    findings: &mut Findings,
) -> Result<(), BenchmarkError> {
    for &method in methods {
        let config = setting.config_with(method);
        let weights = TableWeights::new(
            &config.optics,
            &config.poses(),
            &config.volume.grid(),
            config.volume.voxel_mm,
        )?;
        let model = ExplicitModel::new(weights);
        let subsets = subsets(&config.reconstruction, &config, &model)?;
        let whole = model.matrix_bytes(&model.views());
        let largest = subsets.iter().map(|views| model.matrix_bytes(views)).max().unwrap_or(whole);
        let mut row = setting.row(method, 0);
        row.matrix_mb = Some(whole as f64 / 1e6);
        row.subset_matrix_mb = Some(largest as f64 / 1e6);
        findings.add(row, surroundings);
    }
    Ok(())
}

fn subsets(
    settings: &ReconstructionSettings,
    config: &lfpiv::config::Config,
    model: &ExplicitModel,
) -> Result<Vec<Vec<lfpiv_core::model::ViewId>>, BenchmarkError> {
    let reconstructor =
        Reconstructor::new(&config.optics, &config.poses(), &config.volume.grid(), settings)?;
    let per_camera = reconstructor.subsets_per_pass() / model.layouts().len().max(1);
    Ok(balanced_subsets(model.layouts(), per_camera))
}
