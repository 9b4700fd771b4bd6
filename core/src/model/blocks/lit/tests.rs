//! The bit-parallel hull compared with a naive count of dark views.

use lfpiv_hw::Pose;
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::{maps::supports, *};
use crate::{
    model::{ModelParts, VolumeGrid, blocks::aligned::aligned_views, child_voxel},
    test_bench,
};

fn bench_poses() -> Vec<Pose> {
    let pose = |up: [f64; 3], axis: [f64; 3]| Pose {
        right: [1.0, 0.0, 0.0].into(),
        up: up.into(),
        axis: axis.into(),
        origin_mm: [0.0; 3].into(),
    };
    vec![pose([0.0, 1.0, 0.0], [0.0, 0.0, 1.0]), pose([0.0, 0.0, -1.0], [0.0, 1.0, 0.0])]
}

/// The naive reference: whether each voxel may be lit in a camera, and whether it is visible, by checking every
/// view for every voxel.
fn verdicts<const D: usize>(
    model: &AlignedModel<4, D>,
    camera: usize,
    views: &ViewStack,
    criteria: &HullCriteria,
) -> Vec<[bool; 2]> {
    let (dark_below, tolerated) = (criteria.dark_below[camera], criteria.tolerated[camera]);
    let AlignedCamera { axes, columns, rows, width } = &model.cameras[camera];
    let voxels = model.grid.voxels;
    let mut dark = vec![0; model.grid.len()];
    let mut visible = vec![false; model.grid.len()];
    for (n, view) in model.layouts[camera].views.iter().enumerate() {
        let image = views.view(n);
        let is_lit = |pixel: usize| {
            let open = view.coverage.as_ref().map_or(1.0, |coverage| coverage[pixel]);
            open <= 0.5 || image[pixel] >= dark_below * open
        };
        for depth in 0..voxels[axes.depth] {
            let at = D * (depth / 2) + if D == 2 { depth % 2 } else { 0 };
            for (column, across) in supports(columns, (view.k, at)) {
                for (row, along) in supports(rows, (view.l, at)) {
                    if column >= voxels[axes.column] || row >= voxels[axes.row] {
                        continue;
                    }
                    let mut ijk = [0; 3];
                    (ijk[axes.column], ijk[axes.row], ijk[axes.depth]) = (column, row, depth);
                    let voxel = model.grid.linear(ijk);
                    visible[voxel] = true;
                    let lit = along.clone().any(|y| across.clone().any(|x| is_lit(y * width + x)));
                    dark[voxel] += usize::from(!lit && criteria.selected[camera].contains(&n));
                }
            }
        }
    }
    dark.into_iter().zip(visible).map(|(dark, visible)| [dark <= tolerated, visible]).collect()
}

/// Grids wider than a line, odd and even, with one and two depths per block.
fn compare<const D: usize>(voxels: [usize; 3], seed: u64) {
    let optics = test_bench::optics();
    let grid = VolumeGrid { voxels, voxel_mm: 0.03, centre_mm: [1.3, -1.0, 2.6] };
    let views = aligned_views(&optics, &bench_poses(), &grid, grid.voxel_mm).unwrap().unwrap();
    let parts = ModelParts::default();
    let layouts = parts.layouts(&optics, views.iter().map(|view| &view.window), &[]);
    let model =
        AlignedModel::<4, D>::new(&optics, &views, layouts, &grid, grid.voxel_mm, &parts).unwrap();
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let stacks: Vec<ViewStack> = model
        .layouts
        .iter()
        .map(|layout| {
            let len = layout.window.len();
            let value = |_| if random.random::<f32>() < 0.2 { 0.0 } else { 10.0 };
            ViewStack::new(len, (0..len * layout.views.len()).map(value).collect())
        })
        .collect();
    let mut mixed = false;
    for (every, tolerated) in [(1, 0), (1, 10), (1, 20), (1, 30), (1, 45), (3, 3), (3, 10)] {
        let selected = |layout: &ViewLayout| (0..layout.views.len()).step_by(every).collect();
        let criteria = HullCriteria {
            selected: model.layouts.iter().map(selected).collect(),
            dark_below: vec![5.0; 2],
            tolerated: vec![tolerated; 2],
            displacement: vec![0.0; 2],
        };
        let by_camera: Vec<Vec<[bool; 2]>> =
            (0..2).map(|camera| verdicts(&model, camera, &stacks[camera], &criteria)).collect();
        let expected = |voxel: usize| {
            by_camera.iter().all(|verdicts| verdicts[voxel][0])
                && by_camera.iter().any(|verdicts| verdicts[voxel][1])
        };
        let lit = lit_blocks(&model, &stacks, &criteria);
        let mut found = vec![false; grid.len()];
        for (&block, &children) in lit.blocks.iter().zip(&lit.children) {
            for child in (0..8).filter(|child| children >> child & 1 == 1) {
                found[child_voxel(&grid, block, child).unwrap() as usize] = true;
            }
        }
        let count = found.iter().filter(|&&lit| lit).count();
        mixed |= (1..grid.len()).contains(&count);
        for (voxel, &found) in found.iter().enumerate() {
            assert_eq!(found, expected(voxel), "{tolerated} tolerated: voxel {voxel}");
        }
    }
    assert!(mixed, "all voxels alike: nothing is tested");
}

#[test]
fn finds_the_voxels_that_enough_views_find_lit() {
    compare::<1>([261, 7, 6], 3);
    compare::<2>([21, 8, 9], 4);
    compare::<1>([70, 8, 7], 5);
}
