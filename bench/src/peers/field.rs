//! A displacement field through particles whose displacements are known exactly.

use std::path::Path;

use lfpiv_core::{
    model::VolumeGrid,
    velocimetry::{
        VelocimetrySettings,
        spline_field::{Extent, Guess, Sample, SplineField, through},
    },
};
use lfpiv_sim::{BenchGeometry, FrameOfPair, Scene};
use serde::{Deserialize, Serialize};

use super::{
    CorrelationCase, PeersError, Row,
    correlation::{Windows, mean_abs_error_vox},
    description::{case_name, read_description, write_description},
    npy::{read_array, write_array},
    row::repeated,
};
use crate::between::spread;

/// Number of places at which fields are judged: about the vectors of a volume 0.4 mm apart.
const UNSEEN: usize = 10_000;

/// Standard deviation of a given displacement, in voxels: rounding, and a path's curvature.
const GIVEN_DEVIATION_VOX: f32 = 1e-3;

/// Displacements along x, y, z at places, both in voxels. A place is the mean of a particle's two positions.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Displacements {
    /// The places.
    pub at_vox: Vec<[f32; 3]>,
    /// From frame a to frame b.
    pub moved_vox: Vec<[f32; 3]>,
}

/// True particles, places where there is none, and the particles' light as a pair of volumes.
#[derive(Debug, Clone, PartialEq)]
pub struct FieldCase {
    /// The volumes, for a program that correlates.
    pub volumes: CorrelationCase,
    /// Particles that are lit in both frames.
    pub particles: Displacements,
    /// Places between the windows' centres, where a program that correlates has vectors about it.
    pub unseen: Displacements,
}

#[derive(Debug, Serialize, Deserialize)]
struct Description {
    kind: String,
    /// Counts along x, y, z.
    voxels: [usize; 3],
    windows: Windows,
    particles: usize,
    unseen: usize,
}

impl FieldCase {
    /// The scene's first shot.
    pub fn of_particles(
        bench: &BenchGeometry,
        grid: &VolumeGrid,
        scene: &Scene,
        velocimetry: &VelocimetrySettings,
    ) -> Self {
        let volumes = CorrelationCase::of_particles(bench, grid, scene, velocimetry);
        let truth = scene.truth(bench, scene.seed, 0);
        let vox = |at_mm: [f64; 3]| -> [f64; 3] {
            std::array::from_fn(|axis| grid.index_of(axis, at_mm[axis]))
        };
        let mut particles = Displacements::default();
        for particle in &truth.particles {
            let [a, b] = [FrameOfPair::A, FrameOfPair::B].map(|frame| particle.lit_mm(frame));
            let Some((a, b)) = a.map(vox).zip(b.map(vox)) else { continue };
            particles.push(|axis| (a[axis] + b[axis]) / 2.0, |axis| b[axis] - a[axis]);
        }
        let mut unseen = Displacements::default();
        let rim_vox = (volumes.windows().edge_vox as f64 - 1.0) / 2.0;
        for share in (0..UNSEEN).map(spread) {
            let along = |axis: usize| {
                let last_vox = (grid.voxels[axis] - 1) as f64 - rim_vox;
                rim_vox + share[axis] * (last_vox - rim_vox)
            };
            let at_mm = std::array::from_fn(|axis| grid.coordinate_mm(axis, along(axis)));
            let moved_mm = scene.flow.displacement_about_mm(at_mm, bench.dt_s);
            unseen.push(along, |axis| moved_mm[axis] / grid.voxel_mm);
        }
        Self { volumes, particles, unseen }
    }

    /// Writes the volumes and, of shape (n, 3), `particles_vox.npy` and `particles_moved_vox.npy`, and the same of
    /// unseen places, described by `case.json`.
    pub fn write(&self, folder: &Path) -> Result<(), PeersError> {
        self.volumes.write_arrays(folder)?;
        self.particles.write(folder, "particles")?;
        self.unseen.write(folder, "unseen")?;
        let description = Description {
            kind: "field".to_owned(),
            voxels: self.volumes.volumes[0].grid.voxels,
            windows: self.volumes.windows().clone(),
            particles: self.particles.at_vox.len(),
            unseen: self.unseen.at_vox.len(),
        };
        write_description(folder, &description)
    }

    /// Reads a case that [`Self::write`] has written on this grid.
    pub fn read(folder: &Path, grid: &VolumeGrid) -> Result<Self, PeersError> {
        let Description { particles, unseen, .. } = read_description(folder)?;
        Ok(Self {
            volumes: CorrelationCase::read(folder, grid)?,
            particles: Displacements::read(folder, "particles", particles)?,
            unseen: Displacements::read(folder, "unseen", unseen)?,
        })
    }
}

impl Displacements {
    fn push(&mut self, at_vox: impl Fn(usize) -> f64, moved_vox: impl Fn(usize) -> f64) {
        self.at_vox.push(std::array::from_fn(|axis| at_vox(axis) as f32));
        self.moved_vox.push(std::array::from_fn(|axis| moved_vox(axis) as f32));
    }

    fn write(&self, folder: &Path, name: &str) -> Result<(), PeersError> {
        for (file, values) in files(name).into_iter().zip([&self.at_vox, &self.moved_vox]) {
            write_array(&folder.join(file), &[values.len(), 3], values.as_flattened())?;
        }
        Ok(())
    }

    fn read(folder: &Path, name: &str, count: usize) -> Result<Self, PeersError> {
        let [at, moved] = files(name);
        let read = |file: String| -> Result<Vec<[f32; 3]>, PeersError> {
            Ok(read_array::<f32>(&folder.join(file), &[count, 3])?.as_chunks().0.to_vec())
        };
        Ok(Self { at_vox: read(at)?, moved_vox: read(moved)? })
    }

    /// The field through them, over a volume of these voxels.
    fn field(&self, voxels: [usize; 3], incompressible: bool) -> SplineField {
        let sample = |(at_vox, moved_vox): (&[f32; 3], &[f32; 3])| Sample {
            middle_vox: *at_vox,
            displacement_vox: *moved_vox,
            variance_vox2: [GIVEN_DEVIATION_VOX * GIVEN_DEVIATION_VOX; 3],
        };
        let samples: Vec<Sample> = self.at_vox.iter().zip(&self.moved_vox).map(sample).collect();
        let corners_vox = [[-0.5; 3], voxels.map(|count| count as f32 - 0.5)];
        let extent = Extent { corners_vox, coarsest_vox: f32::INFINITY };
        let square: f32 = self.moved_vox.as_flattened().iter().map(|moved| moved * moved).sum();
        let error_vox = (square / (3 * samples.len()).max(1) as f32).sqrt();
        let guess = Guess { at: &|_| [0.0; 3], error_vox, stiffness: None };
        through(&extent, &samples, &guess, incompressible).0
    }
}

fn files(name: &str) -> [String; 2] {
    [format!("{name}_vox.npy"), format!("{name}_moved_vox.npy")]
}

/// Times the field of the case in `folder`, from particles to values at unseen places. The seconds are the median of
/// `repeats` runs.
pub fn time_field(
    folder: &Path,
    grid: &VolumeGrid,
    incompressible: bool,
    repeats: usize,
) -> Result<Row, PeersError> {
    let case = FieldCase::read(folder, grid)?;
    let (values, cost) = repeated(repeats, || {
        let field = case.particles.field(grid.voxels, incompressible);
        case.unseen.at_vox.iter().map(|&at| field.value(at)).collect::<Vec<_>>()
    });
    let method = if incompressible { "splines, incompressible" } else { "splines" };
    let row = Row::own(
        case_name(folder),
        method.to_owned(),
        (0.0, cost),
        "particles to values at unseen places",
    );
    Ok(Row {
        vectors: Some(values.len()),
        mean_abs_error_vox: Some(mean_abs_error_vox(&values, &case.unseen.moved_vox)),
        ..row
    })
}
