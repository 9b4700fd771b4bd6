//! What a configuration will make the program do, in words and numbers.

use std::fmt;

use super::Measurement;
use crate::{
    model::VolumeGrid,
    reconstruction::{Footprint, Reconstructor, Solver},
    velocimetry::{Interrogation, VectorGrid},
};

/// The work that each pair will need.
#[derive(Debug, Clone, PartialEq)]
pub struct Plan {
    /// The configured volume.
    pub volume: VolumeGrid,
    /// Voxel counts of the solver's grids, coarse to fine, margins included.
    pub solver_voxels: Vec<[usize; 3]>,
    /// Views of each camera.
    pub views: Vec<usize>,
    /// Bytes of the model's tables.
    pub table_bytes: usize,
    /// Bytes of the views of both frames.
    pub view_bytes: usize,
    /// The solver.
    pub solver: Solver,
    /// What a voxel looks like.
    pub footprint: Footprint,
    /// Where the vectors will be.
    pub vectors: VectorGrid,
    /// Edges of the first and the final windows, in voxels.
    pub windows_vox: [usize; 2],
    /// Correlation passes.
    pub passes: usize,
}

impl Plan {
    pub(super) fn new(
        measurement: &Measurement,
        reconstructor: &Reconstructor,
        interrogation: &Interrogation,
    ) -> Self {
        let layouts = reconstructor.layouts();
        let view_values: usize = layouts.iter().map(|l| l.views.len() * l.window.len()).sum();
        Self {
            volume: measurement.volume.clone(),
            solver_voxels: reconstructor.grids().map(|grid| grid.voxels).collect(),
            views: layouts.iter().map(|layout| layout.views.len()).collect(),
            table_bytes: reconstructor.memory_bytes(),
            view_bytes: 2 * view_values * size_of::<f32>(),
            solver: measurement.reconstruction.solver,
            footprint: measurement.reconstruction.footprint,
            vectors: interrogation.vector_grid(),
            windows_vox: interrogation.windows_vox(),
            passes: measurement.velocimetry.passes,
        }
    }

    /// Why this forward model, in one sentence.
    fn reason(&self) -> &'static str {
        match self.footprint {
            Footprint::Voxel => {
                "particles may be anywhere between voxel centres, so a voxel is an evenly filled \
                 cube"
            }
            Footprint::Point => {
                "the configuration says that particles sit on voxel centres, so a voxel is a point"
            }
        }
    }
}

fn times(counts: &[usize; 3]) -> String {
    format!("{} x {} x {}", counts[0], counts[1], counts[2])
}

impl fmt::Display for Plan {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mega = |bytes: usize| bytes as f64 / 1e6;
        writeln!(
            f,
            "volume       {} voxels of {} mm",
            times(&self.volume.voxels),
            self.volume.voxel_mm
        )?;
        let grids: Vec<String> = self.solver_voxels.iter().map(times).collect();
        writeln!(f, "solver grid  {} (margin included)", grids.join(" -> "))?;
        writeln!(f, "views        {:?} per camera", self.views)?;
        writeln!(f, "solver       {:?}", self.solver)?;
        writeln!(f, "model        separable thin lens: {}", self.reason())?;
        writeln!(
            f,
            "memory       {:.0} MB tables, {:.0} MB views",
            mega(self.table_bytes),
            mega(self.view_bytes)
        )?;
        let [first, last] = self.windows_vox;
        writeln!(f, "windows      {first}³ voxels, then {last}³, {} passes", self.passes)?;
        write!(
            f,
            "vectors      {} every {} mm",
            times(&self.vectors.vectors),
            self.vectors.spacing_mm
        )
    }
}
