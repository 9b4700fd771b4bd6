//! A pair of volumes to correlate, whose flow is known.

use std::path::Path;

use lfpiv_core::{
    lightfield::ImagePair,
    measurement::{Measurement, Processor},
    model::VolumeGrid,
    reconstruction::DenseVolume,
    velocimetry::{PointCloud, VelocimetrySettings, VolumeInterrogation},
};
use lfpiv_sim::{BenchGeometry, FrameOfPair, Scene};
use serde::{Deserialize, Serialize};

use super::{
    PeersError, Row,
    description::{case_name, read_description, write_description},
    npy::{read_array, write_array},
    row::{repeated, timed},
};

/// Both frames as dense volumes on one grid, and the true displacement in every window.
#[derive(Debug, Clone, PartialEq)]
pub struct CorrelationCase {
    /// Frames a and b.
    pub volumes: [DenseVolume; 2],
    /// Displacement at the windows' centres along x, y, z, in voxels; in z, y, x order.
    pub displacement_vox: Vec<[f32; 3]>,
    windows: Windows,
}

/// Interrogation windows on a volume's voxels.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Windows {
    /// Edge, in voxels.
    pub edge_vox: usize,
    /// Distance between neighbouring windows, in voxels; the first lies in the volume's corner.
    step_vox: usize,
    /// Counts along x, y, z.
    vectors: [usize; 3],
}

#[derive(Debug, Serialize, Deserialize)]
struct Description {
    kind: String,
    /// Counts along x, y, z.
    voxels: [usize; 3],
    windows: Windows,
}

impl CorrelationCase {
    /// The true particles of the scene's first shot, each rendered as a cubic B-spline (near a
    /// Gaussian of 0.58 voxel standard deviation): what a perfect reconstruction would give.
    pub fn of_particles(
        bench: &BenchGeometry,
        grid: &VolumeGrid,
        scene: &Scene,
        velocimetry: &VelocimetrySettings,
    ) -> Self {
        let truth = scene.truth(bench, scene.seed, 0);
        let volumes = [FrameOfPair::A, FrameOfPair::B].map(|frame| {
            let lit = truth.particles.iter().filter_map(|p| Some((p.lit_mm(frame)?, p.intensity)));
            let cloud = PointCloud::from_particles(&lit.collect::<Vec<_>>(), grid);
            DenseVolume { grid: grid.clone(), intensity: cloud.render(grid) }
        });
        Self::new(volumes, bench, scene, velocimetry)
    }

    /// The scene's first shot, ray-traced and reconstructed, summed onto the configured voxels.
    pub fn reconstructed(
        bench: &BenchGeometry,
        measurement: &Measurement,
        scene: &Scene,
    ) -> Result<Self, PeersError> {
        let processor = Processor::new(measurement.clone())?;
        let pair = ImagePair { cameras: scene.shot(bench, scene.seed, 0).images };
        let (_, volumes) = processor.process_with_volumes(&pair)?;
        Ok(Self::new(volumes, bench, scene, &measurement.velocimetry))
    }

    fn new(
        volumes: [DenseVolume; 2],
        bench: &BenchGeometry,
        scene: &Scene,
        velocimetry: &VelocimetrySettings,
    ) -> Self {
        let grid = &volumes[0].grid;
        let interrogation = VolumeInterrogation::new(grid, velocimetry);
        let vectors = interrogation.vector_grid();
        let [_, edge_vox] = interrogation.windows_vox();
        let step_vox = (vectors.spacing_mm / grid.voxel_mm).round() as usize;
        let displacement_vox = (0..vectors.len())
            .map(|n| {
                let moved_mm = scene.flow.displacement_mm(vectors.position_mm(n), bench.dt_s);
                moved_mm.map(|mm| (mm / grid.voxel_mm) as f32)
            })
            .collect();
        let windows = Windows { edge_vox, step_vox, vectors: vectors.vectors };
        Self { volumes, displacement_vox, windows }
    }

    /// The windows at whose centres the displacement is given.
    pub fn windows(&self) -> &Windows {
        &self.windows
    }

    /// Writes `a.npy` and `b.npy` (z, y, x) and `displacement_vox.npy` (z, y, x, component),
    /// described by `case.json`.
    pub fn write(&self, folder: &Path) -> Result<(), PeersError> {
        self.write_arrays(folder)?;
        let description = Description {
            kind: "correlation".to_owned(),
            voxels: self.volumes[0].grid.voxels,
            windows: self.windows.clone(),
        };
        write_description(folder, &description)
    }

    /// The same without a description.
    pub(super) fn write_arrays(&self, folder: &Path) -> Result<(), PeersError> {
        let [nx, ny, nz] = self.volumes[0].grid.voxels;
        for (name, volume) in ["a.npy", "b.npy"].iter().zip(&self.volumes) {
            write_array(&folder.join(name), &[nz, ny, nx], &volume.intensity)?;
        }
        let [vx, vy, vz] = self.windows.vectors;
        let path = folder.join("displacement_vox.npy");
        write_array(&path, &[vz, vy, vx, 3], self.displacement_vox.as_flattened())
    }

    /// Reads a case that [`Self::write`] has written on this grid.
    pub fn read(folder: &Path, grid: &VolumeGrid) -> Result<Self, PeersError> {
        let Description { windows, .. } = read_description(folder)?;
        let [nx, ny, nz] = grid.voxels;
        let volume = |name: &str| {
            let intensity = read_array(&folder.join(name), &[nz, ny, nx])?;
            Ok::<_, PeersError>(DenseVolume { grid: grid.clone(), intensity })
        };
        let volumes = [volume("a.npy")?, volume("b.npy")?];
        let [vx, vy, vz] = windows.vectors;
        let flat = read_array::<f32>(&folder.join("displacement_vox.npy"), &[vz, vy, vx, 3])?;
        let displacement_vox = flat.as_chunks().0.to_vec();
        Ok(Self { volumes, displacement_vox, windows })
    }
}

/// Mean absolute error along x, y, z, in voxels, over all vectors, whatever their status: a method may not choose where
/// it is judged.
pub(super) fn mean_abs_error_vox(found_vox: &[[f32; 3]], true_vox: &[[f32; 3]]) -> [f64; 3] {
    std::array::from_fn(|axis| {
        let error =
            |(found, truth): (&[f32; 3], &[f32; 3])| f64::from((found[axis] - truth[axis]).abs());
        let sum: f64 = found_vox.iter().zip(true_vox).map(error).sum();
        sum / true_vox.len().max(1) as f64
    })
}

/// Times the correlation of the case in `folder`, from dense volumes to vectors. The seconds are the
/// median of `repeats` runs.
pub fn time_correlation(
    folder: &Path,
    grid: &VolumeGrid,
    velocimetry: &VelocimetrySettings,
    dt_s: f64,
    repeats: usize,
) -> Result<Row, PeersError> {
    let case = CorrelationCase::read(folder, grid)?;
    let passes = velocimetry.passes;
    let (interrogation, assembly_seconds) = timed(|| VolumeInterrogation::new(grid, velocimetry));
    let [a, b] = &case.volumes;
    let (field, cost) = repeated(repeats, || interrogation.measure(a, b, dt_s));
    let row = Row::own(
        case_name(folder),
        format!("{passes} passes"),
        (assembly_seconds, cost),
        "volumes to vectors",
    );
    Ok(Row {
        iterations: Some(passes),
        vectors: Some(field.grid.len()),
        mean_abs_error_vox: Some(mean_abs_error_vox(
            &field.displacement_vox,
            &case.displacement_vox,
        )),
        ..row
    })
}
