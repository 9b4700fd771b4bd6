use lfpiv::config::Config;
use lfpiv_core::{
    model::{ExplicitModel, TableWeights, ViewId, VolumeGrid, thin_lens_model},
    reconstruction::{Footprint, ReconstructionSettings},
    velocimetry::VelocimetrySettings,
};
use lfpiv_sim::{
    BenchGeometry, Flow, Placement, Scene, SensorSettings, Volume,
    flow::{RingVortex, Uniform},
};
use tempfile::tempdir;

use super::*;

fn bench(grid: &VolumeGrid) -> BenchGeometry {
    let config = Config::parse("bench", include_str!("../../../config/bench.toml")).unwrap();
    let (poses, mut optics) = (config.poses(), config.optics);
    // Five pixels along a micro-image: few views, so that the test is quick.
    optics.sensor.pixel_pitch_um = 20.08;
    (optics.sensor.columns, optics.sensor.rows) = (645, 485);
    let volume = Volume { voxels: grid.voxels, voxel_mm: grid.voxel_mm, centre_mm: grid.centre_mm };
    BenchGeometry { optics, poses, volume, dt_s: 1e-4, empty: None }
}

fn grid(voxels: [usize; 3]) -> VolumeGrid {
    VolumeGrid { voxels, voxel_mm: 0.1, centre_mm: [0.0; 3] }
}

fn still_scene() -> Scene {
    Scene {
        ppm: 0.5,
        placement: Placement::OnGrid,
        intensity_spread: 0.0,
        particle_photoelectrons: 8000.0,
        flow: Flow::Uniform(Uniform { velocity_m_s: [0.0; 3] }),
        sensor: SensorSettings::default().noise_free(),
        ..Scene::default()
    }
}

/// y = A x, with the matrix as a peer reads it.
fn product(folder: &std::path::Path, size: &MatrixSize, x: &[f32]) -> Vec<f32> {
    let rows = size.views * size.rows_per_view;
    let read = |name: &str| folder.join(name);
    let ends = read_array::<u64>(&read("matrix_indptr.npy"), &[rows + 1]).unwrap();
    let columns = read_array::<u32>(&read("matrix_indices.npy"), &[size.entries]).unwrap();
    let weights = read_array::<f32>(&read("matrix_data.npy"), &[size.entries]).unwrap();
    ends.windows(2)
        .map(|row| {
            let row = row[0] as usize..row[1] as usize;
            let terms = columns[row.clone()].iter().zip(&weights[row]);
            terms.map(|(&voxel, weight)| weight * x[voxel as usize]).sum()
        })
        .collect()
}

#[test]
fn the_exported_matrix_images_a_volume_as_the_projector_does() {
    // The cameras' windows differ, so that rows are padded.
    let grid = grid([8, 5, 9]);
    let BenchGeometry { optics, poses, .. } = bench(&grid);
    let explicit = ExplicitModel::new(TableWeights::new(&optics, &poses, &grid, 0.0).unwrap());
    let folder = tempdir().unwrap();
    let views = explicit.views();
    let size = write_matrix(&explicit, &views, folder.path()).unwrap();
    assert_eq!((size.views, size.columns), (views.len(), grid.len()));

    let model = thin_lens_model(&optics, &poses, &grid, 0.0).unwrap();
    let projector = model.projector(&(0..grid.len() as u32).collect::<Vec<_>>());
    let x: Vec<f32> = (0..grid.len()).map(|n| (n * 7 % 11) as f32).collect();
    let images = product(folder.path(), &size, &x);
    let (mut lit, mut padded) = (0, 0);
    for (&ViewId { camera, view }, rows) in views.iter().zip(images.chunks(size.rows_per_view)) {
        let mut image = vec![0.0; model.layouts()[camera].window.len()];
        projector.project(ViewId { camera, view }, &x, &mut image);
        for (row, pixel) in rows.iter().zip(&image) {
            assert!((row - pixel).abs() <= 1e-5 * pixel.max(1.0), "{row} {pixel}");
            lit += usize::from(*pixel > 0.0);
        }
        assert!(rows[image.len()..].iter().all(|&row| row == 0.0));
        padded += rows.len() - image.len();
    }
    assert!(lit > 1000 && padded > 100, "{lit} lit, {padded} padded");
}

#[test]
fn an_exported_frame_reads_back_and_is_reconstructed() {
    let grid = grid([12, 10, 9]);
    let bench = bench(&grid);
    let case = ReconstructionCase::simulate(&bench, &grid, &still_scene()).unwrap();
    let folder = tempdir().unwrap();
    case.write(&bench, folder.path()).unwrap();
    let settings = ReconstructionSettings {
        refinement: 1,
        footprint: Footprint::Point,
        ..ReconstructionSettings::default()
    };
    let layouts = thin_lens_model(&bench.optics, &bench.poses, &grid, 0.0).unwrap();
    let read = ReconstructionCase::read(folder.path(), &grid, layouts.layouts()).unwrap();
    assert_eq!(read, case);
    let active = case.truth.intensity.iter().filter(|&&light| light > 0.0).count();
    assert_eq!(active, 60);

    let row = time_reconstruction(folder.path(), &bench, &grid, &settings, 2).unwrap();
    println!("{row:?}");
    // Whole and in the right order: how good the solver is, the comparison says.
    assert!(row.q.unwrap() > 0.7 && row.seconds > 0.0);
}

#[test]
fn exported_volumes_read_back_and_are_correlated() {
    let grid = grid([40, 36, 32]);
    let bench = bench(&grid);
    let flow = Flow::RingVortex(RingVortex::default());
    let scene = Scene { ppm: 2.0, flow, ..Scene::default() };
    let settings = VelocimetrySettings::default();
    let case = CorrelationCase::of_particles(&bench, &grid, &scene, &settings);
    let folder = tempdir().unwrap();
    case.write(folder.path()).unwrap();
    assert_eq!(CorrelationCase::read(folder.path(), &grid).unwrap(), case);
    for passes in [2, 4] {
        let settings = VelocimetrySettings { passes, ..settings.clone() };
        let row = time_correlation(folder.path(), &grid, &settings, bench.dt_s, 1).unwrap();
        println!("{row:?}");
        assert_eq!(row.vectors, Some(4 * 3 * 3));
        assert!(row.mean_abs_error_vox.unwrap().iter().all(|error| *error < 0.3));
    }
}

#[test]
fn exported_particles_read_back_and_their_field_is_the_flow() {
    let grid = grid([40, 36, 32]);
    let bench = bench(&grid);
    let flow = Flow::RingVortex(RingVortex::default());
    let scene = Scene { ppm: 2.0, flow, ..Scene::default() };
    let case = FieldCase::of_particles(&bench, &grid, &scene, &VelocimetrySettings::default());
    let folder = tempdir().unwrap();
    case.write(folder.path()).unwrap();
    assert_eq!(FieldCase::read(folder.path(), &grid).unwrap(), case);
    for incompressible in [false, true] {
        let row = time_field(folder.path(), &grid, incompressible, 1).unwrap();
        println!("{row:?}");
        assert_eq!(row.vectors, Some(case.unseen.at_vox.len()));
        // Displacements are exact, and the ring's core extends over many particles.
        assert!(row.mean_abs_error_vox.unwrap().iter().all(|error| *error < 0.002));
    }
}
