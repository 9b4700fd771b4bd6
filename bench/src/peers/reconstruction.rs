//! One frame to reconstruct, whose volume is known.

use std::path::Path;

use lfpiv_core::{
    lightfield::{ViewLayout, ViewStack},
    model::{ExplicitModel, ModelError, TableWeights, VolumeGrid, thin_lens_model},
    reconstruction::{
        DenseVolume, ReconstructionSettings, Reconstructor, ViewLevels, hull::mlos,
        quality::quality_factor,
    },
};
use lfpiv_sim::{BenchGeometry, FrameOfPair, Scene, Truth};
use serde::{Deserialize, Serialize};

use super::{
    MatrixSize, PeersError, Row,
    description::{case_name, read_description, write_description},
    npy::{read_array, write_array},
    row::{repeated, timed},
    write_matrix,
};

/// Particles on voxel centres are points.
const POINT_MM: f64 = 0.0;

/// Standard deviation of rounding to whole counts.
const ROUNDING_COUNTS: f64 = 0.289;

/// The views of one frame, and the volume they were made from.
#[derive(Debug, Clone, PartialEq)]
pub struct ReconstructionCase {
    /// The views, one stack per camera, in counts above the black level.
    pub views: Vec<ViewStack>,
    /// Their levels of light.
    pub levels: Vec<ViewLevels>,
    /// Every particle's brightness in its voxel.
    pub truth: DenseVolume,
}

#[derive(Debug, Serialize, Deserialize)]
struct Description {
    kind: String,
    voxels: [usize; 3],
    voxel_mm: f64,
    particles: usize,
    /// Noise of each camera's views, in counts.
    noise_counts: Vec<f64>,
    matrix: MatrixSize,
    active_voxels: usize,
    hull_seconds: f64,
}

impl ReconstructionCase {
    /// The first frame of the scene's first shot, ray-traced. Its particles must lie on the
    /// centres of the voxels of `grid`, the bench's volume. Black level and noise are taken as
    /// known, those of the scene's sensor.
    pub fn simulate(
        bench: &BenchGeometry,
        grid: &VolumeGrid,
        scene: &Scene,
    ) -> Result<Self, ModelError> {
        let model = thin_lens_model(&bench.optics, &bench.poses, grid, POINT_MM)?;
        let shot = scene.shot(bench, scene.seed, 0);
        let sensor = &scene.sensor;
        let gain = sensor.gain_counts_per_electron;
        let black = (sensor.offset_counts + gain * sensor.background_electrons) as f32;
        let noise_counts = (gain * sensor.read_noise_electrons).hypot(ROUNDING_COUNTS);
        let views: Vec<ViewStack> = model
            .layouts()
            .iter()
            .zip(&shot.images)
            .map(|(layout, [image, _])| layout.decode(image, |_, _, c| f32::from(c) - black))
            .collect();
        let levels = views.iter().map(|views| ViewLevels::of(views, noise_counts)).collect();
        Ok(Self { views, levels, truth: in_voxels(&shot.truth, grid) })
    }

    /// Writes the case and the explicit matrix to a folder: `views.npy` (b, view after view,
    /// padded to the matrix's rows), `matrix_*.npy` (see [`write_matrix`]), `truth.npy` and
    /// `active.npy` (positions of the photo-hull's voxels), described by `case.json`.
    pub fn write(&self, bench: &BenchGeometry, folder: &Path) -> Result<(), PeersError> {
        let grid = &self.truth.grid;
        let (optics, poses) = (&bench.optics, &bench.poses);
        let model = thin_lens_model(optics, poses, grid, POINT_MM)?;
        let dark_below: Vec<f32> = self.levels.iter().map(ViewLevels::dark_below).collect();
        let (hull, hull_seconds) = timed(|| mlos(model.as_ref(), &self.views, &dark_below));
        let explicit = ExplicitModel::new(TableWeights::new(optics, poses, grid, POINT_MM)?);
        let matrix = write_matrix(&explicit, &explicit.views(), folder)?;
        let rows = self.rows(matrix.rows_per_view);
        write_array(&folder.join("views.npy"), &[rows.len()], &rows)?;
        write_array(&folder.join("truth.npy"), &[grid.len()], &self.truth.intensity)?;
        write_array(&folder.join("active.npy"), &[hull.voxels.len()], &hull.voxels)?;
        let description = Description {
            kind: "reconstruction".to_owned(),
            voxels: grid.voxels,
            voxel_mm: grid.voxel_mm,
            particles: self.truth.intensity.iter().filter(|&&light| light > 0.0).count(),
            noise_counts: self.levels.iter().map(|level| level.noise_counts).collect(),
            matrix,
            active_voxels: hull.voxels.len(),
            hull_seconds,
        };
        write_description(folder, &description)
    }

    /// Reads a case that [`Self::write`] has written for this volume and these views.
    pub fn read(
        folder: &Path,
        grid: &VolumeGrid,
        layouts: &[ViewLayout],
    ) -> Result<Self, PeersError> {
        let description: Description = read_description(folder)?;
        let per_view = description.matrix.rows_per_view;
        let rows = read_array::<f32>(
            &folder.join("views.npy"),
            &[layouts.iter().map(|layout| layout.views.len()).sum::<usize>() * per_view],
        )?;
        let mut of_view = rows.chunks_exact(per_view.max(1));
        let views: Vec<ViewStack> = layouts
            .iter()
            .map(|layout| {
                let pixels = layout.window.len();
                let own = of_view.by_ref().take(layout.views.len());
                let values = own.flat_map(|view| &view[..pixels]).copied().collect();
                ViewStack::new(pixels, values)
            })
            .collect();
        let levels = views
            .iter()
            .zip(&description.noise_counts)
            .map(|(views, &noise_counts)| ViewLevels::of(views, noise_counts))
            .collect();
        let intensity = read_array(&folder.join("truth.npy"), &[grid.len()])?;
        Ok(Self { views, levels, truth: DenseVolume { grid: grid.clone(), intensity } })
    }

    /// The views as one vector, each padded with dark pixels to `rows_per_view`.
    fn rows(&self, rows_per_view: usize) -> Vec<f32> {
        let mut rows = Vec::new();
        for stack in &self.views {
            for view in 0..stack.len() {
                let end = rows.len() + rows_per_view;
                rows.extend_from_slice(stack.view(view));
                rows.resize(end, 0.0);
            }
        }
        rows
    }
}

/// Every particle of the first frame in its voxel.
fn in_voxels(truth: &Truth, grid: &VolumeGrid) -> DenseVolume {
    let mut intensity = vec![0.0f32; grid.len()];
    for particle in &truth.particles {
        if let Some(at) = particle.lit_mm(FrameOfPair::A) {
            let index = |axis: usize| grid.index_of(axis, at[axis]).round() as usize;
            intensity[grid.linear([index(0), index(1), index(2)])] += particle.intensity as f32;
        }
    }
    DenseVolume { grid: grid.clone(), intensity }
}

/// Times a solver on the case in `folder`, from views to volume: its start is counted, its tables
/// are not. The seconds are the median of `repeats` runs.
pub fn time_reconstruction(
    folder: &Path,
    bench: &BenchGeometry,
    grid: &VolumeGrid,
    settings: &ReconstructionSettings,
    repeats: usize,
) -> Result<Row, PeersError> {
    let (reconstructor, assembly_seconds) =
        timed(|| Reconstructor::new(&bench.optics, &bench.poses, grid, settings));
    let reconstructor = reconstructor?;
    let case = ReconstructionCase::read(folder, grid, reconstructor.layouts())?;
    let (solved, cost) = repeated(repeats, || reconstructor.reconstruct(&case.views, &case.levels));
    let volume = solved.volume.on_grid(grid);
    let row = Row::own(
        case_name(folder),
        settings.solver.to_string(),
        (assembly_seconds, cost),
        "views to volume, start included",
    );
    Ok(Row {
        q: Some(quality_factor(&volume.intensity, &case.truth.intensity)),
        iterations: Some(solved.passes.len()),
        ..row
    })
}
