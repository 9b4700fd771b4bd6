//! The fast path compared with the voxelwise one, and with the definition of a share.

use lfpiv_hw::Pose;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::*;
use crate::{model::thin_lens_model, test_bench};

/// Cameras along z and y, as in the bench, and along z and x, as for the jet.
fn pairs_of_poses() -> [Vec<Pose>; 2] {
    let pose = |right: [f64; 3], up: [f64; 3], axis: [f64; 3]| Pose {
        right: right.into(),
        up: up.into(),
        axis: axis.into(),
        origin_mm: [0.0; 3].into(),
    };
    let first = pose([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
    let above = pose([1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]);
    let beside = pose([0.0, 0.0, -1.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]);
    [vec![first.clone(), above], vec![first, beside]]
}

/// Voxels small enough that both paths share depths between the same voxels.
fn grid() -> VolumeGrid {
    VolumeGrid { voxels: [26, 23, 21], voxel_mm: 0.025, centre_mm: [3.1, -2.0, 2.6] }
}

fn both(poses: &[Pose]) -> (Box<dyn BlockModel>, VoxelwiseBlocks) {
    both_on(&grid(), poses, 1.0)
}

/// Sources of `footprint` voxels.
fn both_on(
    grid: &VolumeGrid,
    poses: &[Pose],
    footprint: f64,
) -> (Box<dyn BlockModel>, VoxelwiseBlocks) {
    let optics = test_bench::optics();
    let footprint_mm = footprint * grid.voxel_mm;
    let fast = block_model(&optics, poses, grid, footprint_mm, &ModelParts::default()).unwrap();
    let slow = thin_lens_model(&optics, poses, grid, footprint_mm).unwrap();
    (fast, VoxelwiseBlocks::new(slow))
}

/// Points on voxels of 0.1 mm: every voxel needs its own depth.
fn points_grid() -> VolumeGrid {
    VolumeGrid { voxels: [7, 8, 9], voxel_mm: 0.1, centre_mm: [3.1, -2.0, 2.6] }
}

fn all_blocks(grid: &VolumeGrid) -> Vec<u32> {
    (0..blocks_along(grid).into_iter().product::<usize>() as u32).collect()
}

#[test]
fn children_are_at_their_places_along_the_axes() {
    for axes in aligned_tables::Axes::ALL {
        for (r, columns) in axes.children().into_iter().enumerate() {
            for (c, depths) in columns.into_iter().enumerate() {
                for (d, child) in depths.into_iter().enumerate() {
                    let bit = |axis: usize| child >> axis & 1;
                    assert_eq!([bit(axes.column), bit(axes.row), bit(axes.depth)], [c, r, d]);
                }
            }
        }
    }
}

/// Random light, dark outside the grid.
fn random_light(random: &mut Pcg64Mcg, grid: &VolumeGrid, blocks: &[u32]) -> Vec<BlockLight> {
    let light = |&block: &u32| {
        std::array::from_fn(|child| match child_voxel(grid, block, child) {
            Some(_) => random.random::<f32>(),
            None => 0.0,
        })
    };
    blocks.iter().map(light).collect()
}

#[test]
fn projects_as_the_voxelwise_model() {
    let mut random = Pcg64Mcg::seed_from_u64(5);
    let models = pairs_of_poses()
        .into_iter()
        .flat_map(|poses| [both(&poses), both_on(&points_grid(), &poses, 0.0)]);
    for (fast, slow) in models {
        let blocks = all_blocks(fast.grid());
        let light = random_light(&mut random, fast.grid(), &blocks);
        let (p, q) = (fast.projector(&blocks), slow.projector(&blocks));
        for camera in 0..2 {
            for view in (0..fast.layouts()[camera].views.len()).step_by(17) {
                let id = ViewId { camera, view };
                let mut a = vec![0.0; fast.image_len(camera)];
                let mut b = vec![0.0; slow.image_len(camera)];
                p.project(id, &light, &mut a);
                q.project(id, &light, &mut b);
                let total: f32 = b.iter().sum();
                let apart: f32 = a.iter().zip(&b).map(|(a, b)| (a - b).abs()).sum();
                // The voxelwise tables may lose half a percent outside their taps.
                assert!(apart <= 5e-3 * total, "{id:?}: {apart} of {total}");
                let beyond: f32 = a[b.len()..].iter().sum();
                assert!(beyond.abs() < 1e-6 * total.max(1.0));
            }
        }
    }
}

#[test]
fn back_projection_is_the_adjoint_of_projection() {
    let mut random = Pcg64Mcg::seed_from_u64(6);
    let models = pairs_of_poses()
        .into_iter()
        .flat_map(|poses| [both(&poses), both_on(&points_grid(), &poses, 0.0)]);
    for (model, _) in models {
        let blocks: Vec<u32> = all_blocks(model.grid()).into_iter().step_by(3).collect();
        let mut projector = model.projector(&blocks);
        let keep: Vec<bool> = (0..blocks.len()).map(|n| n % 4 != 1).collect();
        projector.retain(&keep);
        let kept: Vec<u32> =
            blocks.iter().zip(&keep).filter(|(_, keep)| **keep).map(|(&b, _)| b).collect();
        let light = random_light(&mut random, model.grid(), &kept);
        for camera in 0..2 {
            let id = ViewId { camera, view: model.layouts()[camera].views.len() / 3 };
            let pixels = model.layouts()[camera].window.len();
            let mut weights = vec![0.0f32; model.image_len(camera)];
            weights[..pixels].fill_with(|| random.random::<f32>());
            let mut image = vec![0.0; model.image_len(camera)];
            projector.project(id, &light, &mut image);
            let mut spread = vec![[0.0; 8]; kept.len()];
            let (low, high) = spread.split_at_mut(kept.len() / 2);
            let mut prepared = weights.clone();
            projector.prepare(id, &mut prepared);
            projector.back_project(id, &prepared, 0..low.len(), low);
            projector.back_project(id, &prepared, kept.len() / 2..kept.len(), high);
            let dot = |a: &[f32], b: &[f32]| -> f64 {
                a.iter().zip(b).map(|(a, b)| f64::from(a * b)).sum()
            };
            let (there, back) =
                (dot(&image, &weights), dot(light.as_flattened(), spread.as_flattened()));
            assert!((there - back).abs() < 1e-5 * there.abs(), "{there} {back}");
        }
    }
}

#[test]
fn finds_the_same_voxels_lit_as_the_voxelwise_model() {
    let mut random = Pcg64Mcg::seed_from_u64(7);
    for poses in pairs_of_poses() {
        let (fast, slow) = both(&poses);
        let views: Vec<ViewStack> = fast
            .layouts()
            .iter()
            .map(|layout| {
                let len = layout.window.len();
                // A fifth of the pixels is dark.
                let value = |_| if random.random::<f32>() < 0.2 { 0.0 } else { 10.0 };
                ViewStack::new(len, (0..len * layout.views.len()).map(value).collect())
            })
            .collect();
        for tolerated in [0, 3, 20] {
            let selected = |layout: &ViewLayout| (0..layout.views.len()).step_by(2).collect();
            let criteria = HullCriteria {
                selected: fast.layouts().iter().map(selected).collect(),
                dark_below: vec![5.0; 2],
                tolerated: vec![tolerated; 2],
                displacement: vec![0.0; 2],
            };
            let (a, b) = (fast.lit(&views, &criteria), slow.lit(&views, &criteria));
            let count =
                |lit: &LitBlocks| -> u32 { lit.children.iter().map(|m| m.count_ones()).sum() };
            let (n, m) = (count(&a), count(&b));
            // Shares at the very edge of the support may differ between the tables.
            assert!(n.abs_diff(m) <= 1 + m / 20, "{tolerated}: {n} {m}");
        }
    }
}
