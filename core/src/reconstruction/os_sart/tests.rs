//! Eq. 2 on active voxels compared with the whole-volume form, and that with the explicit matrix.

use super::*;
use crate::{
    lightfield::ViewStack,
    model::{
        BlockLight, BlockModel, ExplicitModel, ForwardModel, LitBlocks, ModelParts, TableWeights,
        ViewId, VolumeGrid, VoxelwiseBlocks, block_model, blocks_along, child_voxel,
        thin_lens_model,
    },
    reconstruction::{
        BlockVolume, Domain, ReconstructionSettings, Reconstructor, SartOptions, Solver,
        SparseVolume, ViewLevels,
        pass::{InverseProblem, Pruning},
        sart,
        subsets::balanced_subsets,
    },
    test_bench, untimed,
};

const RELAXATION: f32 = 0.8;
const PASSES: usize = 2;

fn grid() -> VolumeGrid {
    VolumeGrid { voxels: [5, 4, 3], voxel_mm: 0.1, centre_mm: [0.0; 3] }
}

fn voxelwise() -> Box<dyn ForwardModel> {
    thin_lens_model(&test_bench::optics(), &test_bench::poses(), &grid(), 0.1).unwrap()
}

/// Inconsistent views that no volume explains; some pixels are below the black level.
fn views(layouts: &[crate::lightfield::ViewLayout]) -> Vec<ViewStack> {
    let stack = |layout: &crate::lightfield::ViewLayout| {
        let values = (0..layout.window.len() * layout.views.len())
            .map(|n| ((n * 7919) % 101) as f32 - 20.0)
            .collect();
        ViewStack::new(layout.window.len(), values)
    };
    layouts.iter().map(stack).collect()
}

fn over_the_volume(model: &dyn ForwardModel, subsets: Vec<Vec<ViewId>>) -> SparseVolume {
    let voxels = (0..model.grid().len() as u32).collect();
    let views = views(model.layouts());
    let options = SartOptions { relaxation: RELAXATION, passes: PASSES, subsets, clock: untimed };
    sart(model, &views, voxels, &options, &mut |_, _| {})
}

/// The same passes in blocks whose voxels all stay active.
fn all_active(model: &dyn BlockModel, subsets: &[Vec<ViewId>]) -> SparseVolume {
    all_active_in(model, &views(model.layouts()), subsets)
}

fn all_active_in(
    model: &dyn BlockModel,
    views: &[ViewStack],
    subsets: &[Vec<ViewId>],
) -> SparseVolume {
    let blocks: Vec<u32> =
        (0..blocks_along(model.grid()).into_iter().product::<usize>() as u32).collect();
    let inside = |&block: &u32| {
        let child = |child| u8::from(child_voxel(model.grid(), block, child).is_some()) << child;
        (0..8).map(child).sum()
    };
    let children = blocks.iter().map(inside).collect();
    let mut volume = BlockVolume::with_uniform_light(model.grid(), LitBlocks { blocks, children });
    volume.light.as_flattened_mut().iter_mut().for_each(|light| *light *= DARK);
    let problem = InverseProblem { model, views };
    let update = OsSart { relaxation: RELAXATION, noise_share: vec![0.0; 2] };
    let mut projector = model.projector(&volume.blocks);
    for passes_done in 0..PASSES {
        let pruning = Pruning { prune_below: 0.0, rising_passes: 1, passes_done };
        problem.pass(&update, subsets, pruning, &mut volume, projector.as_mut());
    }
    assert_eq!(volume.active_voxels(), model.grid().len());
    volume.into_voxels()
}

/// Largest difference, relative to the largest light.
fn apart(a: &SparseVolume, b: &SparseVolume) -> f32 {
    assert_eq!(a.voxels, b.voxels);
    let brightest = a.intensity.iter().copied().fold(0.0, f32::max);
    assert!(brightest > 1.0, "nothing to compare");
    let differences = a.intensity.iter().zip(&b.intensity).map(|(a, b)| (a - b).abs());
    differences.fold(0.0, f32::max) / brightest
}

#[test]
fn where_every_voxel_is_active_both_forms_are_the_same() {
    let model = voxelwise();
    for per_camera in [1, 7] {
        let subsets = balanced_subsets(model.layouts(), per_camera);
        let whole = over_the_volume(model.as_ref(), subsets.clone());
        let active = all_active(&VoxelwiseBlocks::new(voxelwise()), &subsets);
        let difference = apart(&whole, &active);
        assert!(difference < 1e-4, "{per_camera} subsets: {difference}");
    }
}

/// The fast tables have 16-bit shares and thus deviate by some thousandths. Both forms solve for a volume that
/// explains the views, on voxels with the same shared depths.
#[test]
fn the_fast_blocks_solve_as_the_voxelwise_ones_do() {
    let grid = VolumeGrid { voxels: [12, 10, 8], voxel_mm: 0.025, centre_mm: [0.1, -0.2, 0.3] };
    let (optics, poses) = (test_bench::optics(), test_bench::poses());
    let model = |footprint_mm| {
        let slow = thin_lens_model(&optics, &poses, &grid, footprint_mm).unwrap();
        let fast = block_model(&optics, &poses, &grid, footprint_mm, &ModelParts::default());
        (fast.unwrap(), VoxelwiseBlocks::new(slow))
    };
    let (fast, slow) = model(0.025);
    let views = views_of_points(&slow);
    let subsets = balanced_subsets(slow.layouts(), 7);
    let solved = [fast.as_ref(), &slow].map(|model| all_active_in(model, &views, &subsets));
    let difference = apart(&solved[0], &solved[1]);
    assert!(difference < 0.03, "{difference}");
}

/// Projection of a volume in which every 331st voxel is bright.
fn views_of_points(model: &dyn BlockModel) -> Vec<ViewStack> {
    let blocks: Vec<u32> =
        (0..blocks_along(model.grid()).into_iter().product::<usize>() as u32).collect();
    let lit = |&block: &u32| {
        std::array::from_fn(|child| match child_voxel(model.grid(), block, child) {
            Some(voxel) if voxel % 331 == 5 => 200.0,
            _ => 0.0,
        })
    };
    let light: Vec<BlockLight> = blocks.iter().map(lit).collect();
    let projector = model.projector(&blocks);
    let stack = |(camera, layout): (usize, &crate::lightfield::ViewLayout)| {
        let pixels = layout.window.len();
        let mut values = Vec::with_capacity(pixels * layout.views.len());
        for view in 0..layout.views.len() {
            let mut image = vec![0.0; model.image_len(camera)];
            projector.project(ViewId { camera, view }, &light, &mut image);
            values.extend_from_slice(&image[..pixels]);
        }
        ViewStack::new(pixels, values)
    };
    model.layouts().iter().enumerate().map(stack).collect()
}

#[test]
fn the_whole_volume_solves_as_the_explicit_matrix_does() {
    let (optics, poses) = (test_bench::optics(), test_bench::poses());
    let model = voxelwise();
    let weights = TableWeights::new(&optics, &poses, &grid(), 0.1).unwrap();
    let explicit = ExplicitModel::new(weights);
    for per_camera in [1, 7] {
        let subsets = balanced_subsets(model.layouts(), per_camera);
        let (tables, matrix) =
            (over_the_volume(model.as_ref(), subsets.clone()), over_the_volume(&explicit, subsets));
        let difference = apart(&tables, &matrix);
        assert!(difference < 1e-4, "{per_camera} subsets: {difference}");
    }
}

#[test]
fn every_solver_gives_the_same_bits_on_any_number_of_threads() {
    let grid = VolumeGrid { voxels: [12, 10, 8], voxel_mm: 0.1, centre_mm: [0.0; 3] };
    for solver in [Solver::OsSart, Solver::Sart, Solver::PrSart, Solver::OsMart] {
        let settings = ReconstructionSettings {
            solver,
            domain: Domain::Active,
            ..ReconstructionSettings::default()
        };
        let (optics, poses) = (test_bench::optics(), test_bench::poses());
        let reconstructor = Reconstructor::new(&optics, &poses, &grid, &settings).unwrap();
        // Blocks of the solver's voxel size, with the same microlens windows.
        let fine = block_model(&optics, &poses, &grid.refined(4), 0.025, &ModelParts::default());
        let views = views_of_points(fine.unwrap().as_ref());
        let levels: Vec<ViewLevels> = views.iter().map(|view| ViewLevels::of(view, 2.0)).collect();
        let run = |threads| {
            let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
            pool.install(|| reconstructor.reconstruct(&views, &levels))
        };
        let (one, three) = (run(1), run(3));
        assert!(one.volume.intensity.iter().all(|light| light.is_finite() && *light >= 0.0));
        assert!(!one.volume.voxels.is_empty(), "{solver}");
        assert_eq!(one.volume, three.volume, "{solver}");
        assert_eq!(one.passes, three.passes, "{solver}");
    }
}
