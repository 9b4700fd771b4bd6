//! What a configuration will make the program do, in words and numbers.

use std::{fmt, sync::Arc};

use super::{Measurement, fitted::Fitted};
use crate::{
    model::{ModelChoice, ModelMode},
    reconstruction::ReconstructionSettings,
    velocimetry::{InFlow, Interrogation, VectorGrid},
};

/// The work that each pair will need.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// Voxel counts of the solver's grids, coarse to fine, margins included.
    pub solver_voxels: Vec<[usize; 3]>,
    /// Views of each camera.
    pub views: Vec<usize>,
    /// Ordered subsets in one pass over all views.
    pub subsets: usize,
    /// Bytes of the raw images of a pair.
    pub image_bytes: usize,
    /// Bytes of the model's tables.
    pub table_bytes: usize,
    /// Bytes of the views of both frames.
    pub view_bytes: usize,
    /// Solver and its parameters.
    pub reconstruction: ReconstructionSettings,
    /// The forward model; with `mode = "auto"` the one that holds until particles are seen.
    pub model: Arc<ModelChoice>,
    /// Where the vectors will be.
    pub vectors: VectorGrid,
    /// What of them is flow, where the volume has a mask.
    pub in_flow: Option<InFlow>,
    /// Edges of the first and the final windows, in voxels.
    pub windows_vox: [usize; 2],
    /// Correlation passes.
    pub passes: usize,
}

impl Plan {
    pub(super) fn new(
        measurement: &Measurement,
        fitted: &Fitted,
        interrogation: &Interrogation,
    ) -> Self {
        let reconstructor = &fitted.reconstructor;
        let layouts = reconstructor.layouts();
        let view_values: usize = layouts.iter().map(|l| l.views.len() * l.window.len()).sum();
        let sensor = &measurement.optics.sensor;
        Self {
            solver_voxels: reconstructor.grids().iter().map(|grid| grid.voxels).collect(),
            views: layouts.iter().map(|layout| layout.views.len()).collect(),
            subsets: reconstructor.subsets_per_pass(),
            image_bytes: 2 * layouts.len() * sensor.columns * sensor.rows * size_of::<u16>(),
            table_bytes: reconstructor.memory_bytes(),
            view_bytes: 2 * view_values * size_of::<f32>(),
            reconstruction: measurement.reconstruction.clone(),
            model: fitted.choice.clone(),
            vectors: interrogation.vector_grid(),
            in_flow: interrogation.in_flow(),
            windows_vox: interrogation.windows_vox(),
            passes: measurement.velocimetry.passes,
        }
    }
}

/// The parts of the model, or that they are still to be chosen.
fn parts_line(model: &ModelChoice) -> String {
    match model.mode {
        ModelMode::Explicit => model.to_string(),
        ModelMode::Auto => {
            let forced = |part: &&crate::model::PartChoice| part.forced;
            let forced: Vec<String> = model
                .parts
                .iter()
                .filter(forced)
                .map(|part| format!("{} {}", part.part, if part.on { "on" } else { "off" }))
                .collect();
            let forced = if forced.is_empty() { "nothing".to_owned() } else { forced.join(", ") };
            format!("auto: parts are chosen on the first pair with particles; forced: {forced}")
        }
    }
}

fn times(counts: &[usize; 3]) -> String {
    format!("{} x {} x {}", counts[0], counts[1], counts[2])
}

impl fmt::Display for Plan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mega = |bytes: usize| bytes as f64 / 1e6;
        let grids: Vec<String> = self.solver_voxels.iter().map(times).collect();
        let views: Vec<String> = self.views.iter().map(usize::to_string).collect();
        let [first, last] = self.windows_vox;
        writeln!(f, "{:<14} {}", "solver", self.reconstruction.solver)?;
        writeln!(f, "{:<14} {} voxels, margins included", "solver grid", grids.join(" -> "))?;
        writeln!(
            f,
            "{:<14} {} per camera, {} ordered subsets in a pass",
            "views",
            views.join(" + "),
            self.subsets
        )?;
        writeln!(
            f,
            "{:<14} separable thin lens; {}",
            "model",
            self.reconstruction.footprint.reason()
        )?;
        writeln!(f, "{:<14} {}", "", parts_line(&self.model))?;
        writeln!(
            f,
            "{:<14} {:.0} MB raw images, {:.0} MB views, {:.0} MB tables, and what the lit voxels \
             need",
            "memory",
            mega(self.image_bytes),
            mega(self.view_bytes),
            mega(self.table_bytes)
        )?;
        writeln!(
            f,
            "{:<14} {first}³ voxels in the first of {} passes, then {last}³",
            "windows", self.passes
        )?;
        writeln!(
            f,
            "{:<14} {}, one every {} mm{}",
            "vectors",
            times(&self.vectors.vectors),
            self.vectors.spacing_mm,
            self.in_flow.map_or(String::new(), |flow| format!("; {} in the flow", flow.vectors))
        )
    }
}
