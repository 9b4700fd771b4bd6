//! The forward models against ray tracing that shares nothing with them, and against each other.
//!
//! A model's weights, times the light of a pupil cell, must be what rays from the voxel leave on
//! each pixel. Pixels on the border of two micro-images belong to no view (docs/theory.md, section 3); the
//! light they take is reported as dropped and not compared.

use lfpiv_core::{
    lightfield::ViewLayout,
    model::{
        ModelError, ModelParts, QuadratureWeights, TableWeights, ViewId, VolumeGrid, WeightSource,
        thin_lens_model,
    },
};
use lfpiv_hw::{CameraName, Optics, Pose};
use lfpiv_sim::imaging::{ElectronImage, PointSource, RaySettings, RayTracer};
use nalgebra::Vector3;

use crate::test_bench::{optics, poses};

/// Light that a traced source sends through the pupil.
const ELECTRONS: f64 = 1e6;
const BOX_RAYS: u64 = 1 << 22;

/// A camera turned about x from camera 1 towards camera 2.
fn turned(degrees: f64) -> Pose {
    let (sin, cos) = degrees.to_radians().sin_cos();
    Pose {
        right: Vector3::x(),
        up: Vector3::new(0.0, cos, -sin),
        axis: Vector3::new(0.0, sin, cos),
        origin_mm: Vector3::zeros(),
    }
}

fn voxel_at(centre_mm: [f64; 3], voxel_mm: f64) -> VolumeGrid {
    VolumeGrid { voxels: [1; 3], voxel_mm, centre_mm }
}

/// The centre, a place beside it that is no multiple of anything, and the corners at ±4 mm.
fn places_mm() -> Vec<[f64; 3]> {
    let corner = |n: usize| std::array::from_fn(|axis| if n >> axis & 1 == 0 { -4.0 } else { 4.0 });
    [[0.0; 3], [0.537, -0.313, 0.771]].into_iter().chain((0..8).map(corner)).collect()
}

/// One camera's views of the grid's first voxel, view after view; counts per unit of intensity.
fn weights(source: &dyn WeightSource, camera: usize) -> Vec<f64> {
    weights_of(source, camera, 0)
}

fn weights_of(source: &dyn WeightSource, camera: usize, voxel: u32) -> Vec<f64> {
    let layout = &source.layouts()[camera];
    let mut all = vec![0.0; layout.views.len() * layout.window.len()];
    let mut entries = Vec::new();
    for (view, values) in all.chunks_exact_mut(layout.window.len()).enumerate() {
        entries.clear();
        source.weights(ViewId { camera, view }, voxel, &mut entries);
        for entry in &entries {
            values[entry.pixel as usize] += f64::from(entry.weight);
        }
    }
    all
}

/// The views of a traced image in the same order, in the same unit: the pupil sends what
/// π/4 (D/cell)² fully open cells would.
fn traced_views(image: &ElectronImage, layout: &ViewLayout, optics: &Optics) -> Vec<f64> {
    let cells = optics.pupil_diameter_mm() / optics.pupil_cell_mm();
    let unit = ELECTRONS / (std::f64::consts::FRAC_PI_4 * cells * cells);
    let mut all = Vec::new();
    for view in &layout.views {
        for j in layout.window.rows.clone() {
            for i in layout.window.columns.clone() {
                let pixel = layout.columns.sample(view.k, i).zip(layout.rows.sample(view.l, j));
                all.push(pixel.map_or(0.0, |(column, row)| {
                    let at = row.pixel as usize * image.columns() + column.pixel as usize;
                    f64::from(image.electrons()[at]) / unit
                }));
            }
        }
    }
    all
}

/// Share of a traced image's light that belongs to no view.
fn dropped(traced: &[f64], image: &ElectronImage, optics: &Optics) -> f64 {
    let cells = optics.pupil_diameter_mm() / optics.pupil_cell_mm();
    let total = image.total() / ELECTRONS * std::f64::consts::FRAC_PI_4 * cells * cells;
    1.0 - traced.iter().sum::<f64>() / total
}

/// Sum of absolute differences and difference of sums, both over the sum of `truth`.
fn l1_and_energy(model: &[f64], truth: &[f64]) -> (f64, f64) {
    assert_eq!(model.len(), truth.len());
    assert!(model.iter().all(|w| w.is_finite()));
    let total: f64 = truth.iter().sum();
    assert!(total > 10.0, "the truth is dark: {total}");
    let l1: f64 = model.iter().zip(truth).map(|(m, t)| (m - t).abs()).sum();
    (l1 / total, model.iter().sum::<f64>() / total - 1.0)
}

fn trace_box(optics: &Optics, pose: &Pose, centre_mm: [f64; 3], edge_mm: f64) -> ElectronImage {
    let settings = RaySettings { rays_per_particle: 1, diffraction_nm: None };
    RayTracer::new(optics, pose, &settings).trace_box(centre_mm, edge_mm, ELECTRONS, BOX_RAYS, 7)
}

#[test]
fn both_models_match_a_ray_traced_voxel() {
    let (optics, poses) = (optics(), poses());
    for place in places_mm() {
        let grid = voxel_at(place, 0.1);
        let tables = TableWeights::new(&optics, &poses, &grid, 0.1).unwrap();
        let quadrature = QuadratureWeights::new(&optics, &poses, &grid, 0.1).unwrap();
        for (camera, pose) in poses.iter().enumerate() {
            let image = trace_box(&optics, pose, place, 0.1);
            let traced = traced_views(&image, &tables.layouts()[camera], &optics);
            let dropped = dropped(&traced, &image, &optics);
            let t = l1_and_energy(&weights(&tables, camera), &traced);
            let q = l1_and_energy(&weights(&quadrature, camera), &traced);
            println!(
                "{place:?} camera {}: tables L1 {:.2} % energy {:+.2} %, quadrature L1 {:.2} % \
                 energy {:+.2} %, dropped {:.1} %",
                camera + 1,
                100.0 * t.0,
                100.0 * t.1,
                100.0 * q.0,
                100.0 * q.1,
                100.0 * dropped
            );
            assert!(t.0 <= 0.02 && t.1.abs() <= 0.01, "tables: {t:?}");
            assert!(q.0 <= 0.02 && q.1.abs() <= 0.005, "quadrature: {q:?}");
            assert!((0.0..0.15).contains(&dropped), "dropped {dropped}");
        }
    }
}

#[test]
fn tables_match_quadrature() {
    let (optics, poses) = (optics(), poses());
    for (place, edge) in places_mm().into_iter().zip([0.1, 0.05].into_iter().cycle()) {
        let grid = voxel_at(place, edge);
        let tables = TableWeights::new(&optics, &poses, &grid, edge).unwrap();
        let quadrature = QuadratureWeights::new(&optics, &poses, &grid, edge).unwrap();
        for camera in 0..2 {
            let reference = weights(&quadrature, camera);
            let (l1, _) = l1_and_energy(&weights(&tables, camera), &reference);
            println!("{place:?} of {edge} mm, camera {}: L1 {:.2} %", camera + 1, 100.0 * l1);
            assert!(l1 <= 0.015, "{l1}");
        }
    }
}

#[test]
fn a_voxel_without_size_matches_a_traced_point() {
    let (optics, poses) = (optics(), poses());
    let settings = RaySettings { rays_per_particle: 1 << 20, diffraction_nm: None };
    // Off the borders of microlenses, where a point in focus jumps from one to the next.
    for place in [[0.02, -0.01, 0.0], [0.537, -0.313, 0.771], [3.97, -3.98, 4.0], [-4.0, 2.0, -3.3]]
    {
        let grid = voxel_at(place, 0.1);
        let tables = TableWeights::new(&optics, &poses, &grid, 0.0).unwrap();
        for (camera, pose) in poses.iter().enumerate() {
            let source = PointSource { id: 0, position_mm: place, electrons: ELECTRONS };
            let image = RayTracer::new(&optics, pose, &settings).trace(&[source], &[1]);
            let traced = traced_views(&image, &tables.layouts()[camera], &optics);
            let (l1, energy) = l1_and_energy(&weights(&tables, camera), &traced);
            println!(
                "point {place:?} camera {}: L1 {:.2} % energy {:+.2} %",
                camera + 1,
                100.0 * l1,
                100.0 * energy
            );
            assert!(l1 <= 0.03 && energy.abs() <= 0.01, "L1 {l1}, energy {energy}");
        }
    }
}

/// The simulator scatters every ray twice; the tables widen shadows and pupil intervals.
#[test]
fn diffraction_matches_rays_that_are_scattered() {
    let (optics, poses) = (optics(), poses());
    let settings = RaySettings { rays_per_particle: 1 << 20, diffraction_nm: Some(532.0) };
    for place in [[0.537, -0.313, 0.771], [1.97, -1.98, 2.0], [3.97, -3.98, 4.0]] {
        let source = PointSource { id: 0, position_mm: place, electrons: ELECTRONS };
        let image = RayTracer::new(&optics, &poses[0], &settings).trace(&[source], &[1]);
        let [without, with] = [None, Some(532.0)].map(|diffraction_nm| {
            let parts = ModelParts { diffraction_nm, ..ModelParts::default() };
            let grid = voxel_at(place, 0.1);
            let tables = TableWeights::with_parts(&optics, &poses, &grid, 0.0, &parts).unwrap();
            let traced = traced_views(&image, &tables.layouts()[0], &optics);
            l1_and_energy(&weights(&tables, 0), &traced)
        });
        println!(
            "diffraction at {place:?}: L1 {:.2} % -> {:.2} %, energy {:+.2} % -> {:+.2} %",
            100.0 * without.0,
            100.0 * with.0,
            100.0 * without.1,
            100.0 * with.1
        );
        assert!(with.0 < 0.6 * without.0, "{without:?} {with:?}");
    }
}

/// The shadow of a turned cube is no box: same width on average, softer edges.
#[test]
fn an_oblique_camera_sees_the_voxel_in_its_place() {
    let optics = optics();
    let poses = vec![turned(0.0), turned(60.0)];
    let grid = VolumeGrid { voxels: [1, 21, 21], voxel_mm: 0.1, centre_mm: [1.0, 1.0, -2.0] };
    let tables = TableWeights::new(&optics, &poses, &grid, 0.1).unwrap();
    for ijk in [[0, 0, 0], [0, 20, 0], [0, 7, 12]] {
        let centre = grid.centre_of(ijk);
        let image = trace_box(&optics, &poses[1], centre.into(), 0.1);
        let traced = traced_views(&image, &tables.layouts()[1], &optics);
        let (l1, energy) = l1_and_energy(&weights_of(&tables, 1, grid.linear(ijk) as u32), &traced);
        println!("60 degrees: tables L1 {:.2} %, energy {:+.2} %", 100.0 * l1, 100.0 * energy);
        assert!(l1 <= 0.12 && energy.abs() <= 0.02, "L1 {l1}, energy {energy}");

        let alone = voxel_at(centre.into(), 0.1);
        let quadrature = QuadratureWeights::new(&optics, &poses, &alone, 0.1).unwrap();
        let traced = traced_views(&image, &quadrature.layouts()[1], &optics);
        let (l1, energy) = l1_and_energy(&weights(&quadrature, 1), &traced);
        println!("60 degrees: quadrature L1 {:.2} %, energy {:+.2} %", 100.0 * l1, 100.0 * energy);
        assert!(l1 <= 0.03 && energy.abs() <= 0.005, "L1 {l1}, energy {energy}");
    }
}

/// A row of voxels across the field's edge (|x| = 6.45 mm) and half a millimetre beyond it.
#[test]
fn voxels_across_the_edge_of_the_field_are_clipped() {
    let (optics, poses) = (optics(), poses());
    let depth = 3.0;
    let grid = VolumeGrid { voxels: [16, 1, 1], voxel_mm: 0.1, centre_mm: [6.4, 0.0, depth] };
    let model = thin_lens_model(&optics, &poses[..1], &grid, 0.1).unwrap();
    let layout = &model.layouts()[0];
    let voxels: Vec<u32> = (0..16).collect();
    let projector = model.projector(&voxels);
    let light: Vec<f64> = (0..16)
        .map(|voxel| {
            let mut one = vec![0.0; 16];
            one[voxel] = 1.0;
            let mut modelled = Vec::new();
            for view in 0..layout.views.len() {
                let mut image = vec![0.0; layout.window.len()];
                projector.project(ViewId { camera: 0, view }, &one, &mut image);
                modelled.extend(image.into_iter().map(f64::from));
            }
            assert!(modelled.iter().all(|w| w.is_finite() && *w >= 0.0));
            let light: f64 = modelled.iter().sum();
            let image = trace_box(&optics, &poses[0], grid.centre_of([voxel, 0, 0]).into(), 0.1);
            let traced = traced_views(&image, layout, &optics);
            let error: f64 = modelled.iter().zip(&traced).map(|(m, t)| (m - t).abs()).sum();
            // 4 % of a whole voxel's 250 cells.
            assert!(error < 0.04 * 250.0, "voxel {voxel}: {error} of {light}");
            light
        })
        .collect();
    println!("light across the edge: {light:.0?}");
    assert!(light[0] > 200.0 && light[15] < 5.0);
    assert!(light.iter().any(|l| (50.0..200.0).contains(l)));
}

#[test]
fn a_bench_that_cannot_see_the_volume_is_refused() {
    let (optics, poses) = (optics(), poses());
    let refusal = |grid: &VolumeGrid, footprint_mm| {
        thin_lens_model(&optics, &poses, grid, footprint_mm).map(|_| ()).unwrap_err()
    };
    let grid = |voxels, centre_mm| VolumeGrid { voxels, voxel_mm: 0.1, centre_mm };
    // Camera 1 sees x and y, camera 2 x and z: 6 mm along z leaves camera 2's 9.7 mm of height.
    let beside = grid([10; 3], [0.0, 0.0, 6.0]);
    assert_eq!(refusal(&beside, 0.1), ModelError::VolumeOutOfView { camera: CameraName(1) });
    let beside = grid([10; 3], [0.0, 6.0, 0.0]);
    assert_eq!(refusal(&beside, 0.1), ModelError::VolumeOutOfView { camera: CameraName(0) });
    let near = refusal(&grid([10, 10, 200], [0.0, 0.0, 95.0]), 0.1);
    assert!(
        matches!(near, ModelError::TooDeep { camera: CameraName(0), depth_mm, .. } if depth_mm > 100.0),
        "{near:?}"
    );
    // Deep along y, where camera 2 looks; camera 1 sees only the middle, in focus.
    let deep = refusal(&grid([10, 400, 10], [0.0; 3]), 0.3);
    assert!(
        matches!(deep, ModelError::FootprintTooWide { camera: CameraName(1), most: 4, pitches, .. } if pitches > 4.0),
        "{deep:?}"
    );
    let wide = refusal(&grid([10; 3], [0.0; 3]), 0.5);
    assert!(matches!(wide, ModelError::FootprintTooWide { camera: CameraName(0), .. }), "{wide:?}");
    for footprint_mm in [-0.1, f64::NAN, f64::INFINITY] {
        let refused = refusal(&grid([10; 3], [0.0; 3]), footprint_mm);
        assert!(matches!(refused, ModelError::FootprintOutOfRange { .. }), "{refused:?}");
    }
}
