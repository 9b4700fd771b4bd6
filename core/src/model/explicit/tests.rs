use lfpiv_hw::Pose;
use nalgebra::Vector3;
use rand::{Rng, RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;
use rayon::ThreadPoolBuilder;

use super::*;
use crate::{
    model::{QuadratureWeights, TableWeights, thin_lens_model},
    test_bench::{optics, poses},
};

/// Special cases: in and out of focus, one voxel thick, cut by the field's edge, and at the edge with a window of a
/// single column of microlenses.
fn grids() -> Vec<VolumeGrid> {
    let grid = |voxels, voxel_mm, centre_mm| VolumeGrid { voxels, voxel_mm, centre_mm };
    vec![
        grid([7, 5, 9], 0.1, [0.13, -0.07, 0.21]),
        grid([1, 3, 11], 0.1, [0.0, 0.3, 3.0]),
        grid([29, 3, 2], 0.1, [6.0, 0.0, 0.0]),
        grid([5, 9, 4], 0.05, [0.4, 0.2, -2.5]),
        grid([3, 4, 4], 0.1, [6.53, 0.0, 0.0]),
        grid([3, 4, 5], 0.2, [0.0, 0.0, 4.0]),
    ]
}

fn random(len: usize, rng: &mut impl Rng) -> Vec<f32> {
    (0..len).map(|_| rng.random_range(0.0..1.0)).collect()
}

/// Largest difference divided by the largest value.
fn difference(a: &[f32], b: &[f32]) -> f32 {
    let most = |v: &mut dyn Iterator<Item = f32>| v.fold(0.0f32, |m, x| m.max(x.abs()));
    assert_eq!(a.len(), b.len());
    let scale = most(&mut a.iter().copied());
    assert!(scale > 0.0, "nothing to compare");
    most(&mut a.iter().zip(b).map(|(a, b)| a - b)) / scale
}

fn dot(a: &[f32], b: &[f32]) -> f64 {
    a.iter().zip(b).map(|(&a, &b)| f64::from(a) * f64::from(b)).sum()
}

fn all_voxels(grid: &VolumeGrid) -> Vec<u32> {
    (0..grid.len() as u32).collect()
}

/// Images of the views by a projector, in sequence.
fn images(p: &dyn Projector, model: &dyn ForwardModel, views: &[ViewId], x: &[f32]) -> Vec<f32> {
    let image = |view: &ViewId| {
        let mut image = vec![f32::NAN; model.layouts()[view.camera].window.len()];
        p.project(*view, x, &mut image);
        image
    };
    views.iter().flat_map(image).collect()
}

/// Back-projection of images by a projector, in two ranges of voxels.
fn back_projected(
    p: &dyn Projector,
    model: &dyn ForwardModel,
    views: &[ViewId],
    images: &[f32],
) -> Vec<f32> {
    let mut volume = vec![0.0; model.grid().len()];
    let (middle, len) = (volume.len() / 2, volume.len());
    let mut first = 0;
    for view in views {
        let next = first + model.layouts()[view.camera].window.len();
        let (low, high) = volume.split_at_mut(middle);
        p.back_project(*view, &images[first..next], 0..middle, low);
        p.back_project(*view, &images[first..next], middle..len, high);
        first = next;
    }
    volume
}

#[test]
fn tables_and_matrix_with_shared_weights_project_alike() {
    let optics = optics();
    let mut rng = Pcg64Mcg::seed_from_u64(1);
    let (mut forward, mut back) = (0.0f32, 0.0f32);
    for grid in grids() {
        for footprint_mm in [grid.voxel_mm, 0.0] {
            let tables = thin_lens_model(&optics, &poses(), &grid, footprint_mm).unwrap();
            let source = TableWeights::new(&optics, &poses(), &grid, footprint_mm).unwrap();
            let explicit = ExplicitModel::new(source);
            let views = explicit.views();
            let matrix = explicit.load(&views);
            let active = all_voxels(&grid);
            let p = tables.projector(&active);
            let q = explicit.projector(&active);

            let x = random(grid.len(), &mut rng);
            let expected = images(p.as_ref(), tables.as_ref(), &views, &x);
            let mut product = vec![f32::NAN; expected.len()];
            matrix.project(&x, &mut product);
            forward = forward.max(difference(&expected, &product));
            forward =
                forward.max(difference(&expected, &images(q.as_ref(), &explicit, &views, &x)));

            let y = random(expected.len(), &mut rng);
            let expected = back_projected(p.as_ref(), tables.as_ref(), &views, &y);
            let mut product = vec![f32::NAN; grid.len()];
            matrix.back_project(&y, &mut product);
            back = back.max(difference(&expected, &product));
            back =
                back.max(difference(&expected, &back_projected(q.as_ref(), &explicit, &views, &y)));
        }
    }
    println!("tables against matrix: forward {forward:.1e}, back {back:.1e}");
    assert!(forward < 1e-5 && back < 1e-5, "forward {forward}, back {back}");
}

#[test]
fn back_projection_is_the_adjoint() {
    let optics = optics();
    let mut rng = Pcg64Mcg::seed_from_u64(2);
    let mut worst = 0.0f64;
    for grid in grids() {
        let edge = grid.voxel_mm;
        let tables = thin_lens_model(&optics, &poses(), &grid, edge).unwrap();
        let quadrature = QuadratureWeights::new(&optics, &poses(), &grid, edge).unwrap();
        let explicit = ExplicitModel::new(quadrature);
        // Every ninth view, to limit the time of quadrature: cut and open ones of both cameras.
        let views: Vec<_> = explicit.views().into_iter().step_by(9).collect();
        let x = random(grid.len(), &mut rng);
        let p = tables.projector(&all_voxels(&grid));
        let ax = images(p.as_ref(), tables.as_ref(), &views, &x);
        let y = random(ax.len(), &mut rng);
        let aty = back_projected(p.as_ref(), tables.as_ref(), &views, &y);
        worst = worst.max((dot(&ax, &y) / dot(&x, &aty) - 1.0).abs());

        let matrix = explicit.load(&views);
        let (mut ax, mut aty) = (vec![0.0; y.len()], vec![0.0; x.len()]);
        matrix.project(&x, &mut ax);
        matrix.back_project(&y, &mut aty);
        worst = worst.max((dot(&ax, &y) / dot(&x, &aty) - 1.0).abs());
    }
    println!("<Ax, y> / <x, A'y> - 1: {worst:.1e}");
    assert!(worst < 1e-5, "{worst}");
}

#[test]
fn projectors_agree_on_the_brightest_pixel_before_and_after_pruning() {
    let optics = optics();
    let grid = &grids()[0];
    let tables = thin_lens_model(&optics, &poses(), grid, 0.1).unwrap();
    let explicit = ExplicitModel::new(TableWeights::new(&optics, &poses(), grid, 0.1).unwrap());
    let mut voxels: Vec<u32> = all_voxels(grid).into_iter().step_by(2).collect();
    let mut p = tables.projector(&voxels);
    let mut q = explicit.projector(&voxels);
    let mut rng = Pcg64Mcg::seed_from_u64(3);
    let mut finite = 0;
    for _ in 0..2 {
        for &view in &explicit.views() {
            let mut image = random(tables.layouts()[view.camera].window.len(), &mut rng);
            // Most pixels below the black level, as in a sparse scene.
            image.iter_mut().for_each(|value| *value -= 0.7);
            let (mut a, mut b) = (vec![0.0; voxels.len()], vec![0.0; voxels.len()]);
            p.brightest(view, &image, 0..voxels.len(), &mut a);
            q.brightest(view, &image, 0..voxels.len(), &mut b);
            assert_eq!(a, b, "{view:?}");
            finite += a.iter().filter(|most| most.is_finite()).count();
        }
        let keep: Vec<bool> = voxels.iter().map(|v| v % 3 != 0).collect();
        p.retain(&keep);
        q.retain(&keep);
        voxels.retain(|v| v % 3 != 0);
    }
    assert!(finite > 100_000, "{finite}");
}

#[test]
fn subsets_add_up_to_the_full_matrix() {
    let optics = optics();
    let grid = VolumeGrid { voxels: [11, 10, 9], voxel_mm: 0.1, centre_mm: [0.0; 3] };
    let explicit = ExplicitModel::new(TableWeights::new(&optics, &poses(), &grid, 0.1).unwrap());
    let views = explicit.views();
    let full = explicit.matrix_bytes(&views);
    let subsets: Vec<SubsetMatrix> =
        views.chunks(views.len().div_ceil(16)).map(|subset| explicit.load(subset)).collect();
    let largest = subsets.iter().map(SubsetMatrix::memory_bytes).max().unwrap();
    let entries: usize = subsets.iter().map(|subset| subset.matrix().nnz()).sum();
    println!("full matrix {full} bytes, largest of 16 subsets {largest}");
    assert_eq!(full, explicit.load(&views).memory_bytes());
    assert_eq!(full, entries * 8 + (grid.len() + 1) * 8);
    assert!((10..=16).contains(&(full / largest)), "{full} / {largest}");
}

#[test]
fn products_do_not_depend_on_the_number_of_threads() {
    let optics = optics();
    let grid = VolumeGrid { voxels: [11, 10, 9], voxel_mm: 0.1, centre_mm: [0.0; 3] };
    let explicit = ExplicitModel::new(TableWeights::new(&optics, &poses(), &grid, 0.1).unwrap());
    let subset = &explicit.views()[..20];
    let mut rng = Pcg64Mcg::seed_from_u64(4);
    let x = random(grid.len(), &mut rng);
    let on = |threads| {
        ThreadPoolBuilder::new().num_threads(threads).build().unwrap().install(|| {
            let matrix = explicit.load(subset);
            let (mut ax, mut atax) = (vec![0.0; matrix.matrix().rows()], vec![0.0; x.len()]);
            matrix.project(&x, &mut ax);
            matrix.back_project(&ax, &mut atax);
            (ax, atax)
        })
    };
    let one = on(1);
    assert!(one.1.iter().sum::<f32>() > 0.0);
    assert_eq!(one, on(3));
}

#[test]
fn an_oblique_camera_projects_alike_too() {
    let angle = 60.0_f64.to_radians();
    let mut poses = poses();
    poses[1] = Pose {
        right: Vector3::x(),
        up: Vector3::new(0.0, angle.cos(), -angle.sin()),
        axis: Vector3::new(0.0, angle.sin(), angle.cos()),
        origin_mm: Vector3::zeros(),
    };
    let (optics, grid) = (optics(), &grids()[0]);
    let tables = thin_lens_model(&optics, &poses, grid, 0.1).unwrap();
    let explicit = ExplicitModel::new(TableWeights::new(&optics, &poses, grid, 0.1).unwrap());
    let views = explicit.views();
    let x = random(grid.len(), &mut Pcg64Mcg::seed_from_u64(5));
    let expected =
        images(tables.projector(&all_voxels(grid)).as_ref(), tables.as_ref(), &views, &x);
    let mut product = vec![0.0; expected.len()];
    explicit.load(&views).project(&x, &mut product);
    assert!(difference(&expected, &product) < 1e-5);
}
