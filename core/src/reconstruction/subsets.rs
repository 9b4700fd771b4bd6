//! Ordered subsets of views.

use std::cmp::Reverse;

use rand::{SeedableRng, seq::SliceRandom};
use rand_pcg::Pcg64Mcg;

use crate::{lightfield::ViewLayout, model::ViewId};

/// Seed of the view order: the same images always give the same volume.
const ORDER_SEED: u64 = 0x1f91;

/// All views of all cameras in a fixed random order, cameras alternating as in the paper's Fig. 6.
pub fn alternating_views(layouts: &[ViewLayout]) -> Vec<ViewId> {
    let mut random = Pcg64Mcg::seed_from_u64(ORDER_SEED);
    let per_camera: Vec<Vec<ViewId>> = layouts
        .iter()
        .enumerate()
        .map(|(camera, layout)| {
            let mut views: Vec<ViewId> =
                (0..layout.views.len()).map(|view| ViewId { camera, view }).collect();
            views.shuffle(&mut random);
            views
        })
        .collect();
    let longest = per_camera.iter().map(Vec::len).max().unwrap_or(0);
    (0..longest)
        .flat_map(|n| per_camera.iter().filter_map(move |views| views.get(n).copied()))
        .collect()
}

/// Balanced ordered subsets (paper, Eq. 4) in the order of correction of its Fig. 6: subset 1 of
/// camera 1, subset 1 of camera 2, subset 2 of camera 1, and so on.
///
/// Every camera's views are divided into N_s = `subsets_per_camera` subsets; their sizes N_d differ
/// by at most one view, and each is distributed evenly over the pupil. N_s = 1 gives the
/// conventional SART, all views of a camera at once. N_s is clamped to 1 to the number of the
/// camera's views, so that no subset is empty; a camera without views has none.
pub fn balanced_subsets(layouts: &[ViewLayout], subsets_per_camera: usize) -> Vec<Vec<ViewId>> {
    let per_camera: Vec<Vec<Vec<ViewId>>> = layouts
        .iter()
        .enumerate()
        .map(|(camera, layout)| {
            let to_ids = |views: Vec<usize>| {
                views.into_iter().map(|view| ViewId { camera, view }).collect::<Vec<_>>()
            };
            divide(&pupil_cells(layout), subsets_per_camera).into_iter().map(to_ids).collect()
        })
        .collect();
    let longest = per_camera.iter().map(Vec::len).max().unwrap_or(0);
    (0..longest)
        .flat_map(|n| per_camera.iter().filter_map(move |subsets| subsets.get(n).cloned()))
        .collect()
}

fn pupil_cells(layout: &ViewLayout) -> Vec<[i32; 2]> {
    layout.views.iter().map(|view| [view.k, view.l]).collect()
}

/// Divides the views at these pupil cells into balanced subsets of indices of `cells`.
///
/// Each run of N_s views along a Hilbert curve is a compact patch of the pupil. Every patch gives
/// one view to every subset, so all subsets sample the whole pupil evenly.
fn divide(cells: &[[i32; 2]], subsets: usize) -> Vec<Vec<usize>> {
    if cells.is_empty() {
        return Vec::new();
    }
    let mut divided = vec![Vec::new(); subsets.clamp(1, cells.len())];
    let mut imbalance = vec![[0.0; 2]; divided.len()];
    for patch in in_patches(cells, divided.len()).chunks(divided.len()) {
        let mean: [f64; 2] = std::array::from_fn(|axis| {
            let sum: f64 = patch.iter().map(|&view| f64::from(cells[view][axis])).sum();
            sum / patch.len() as f64
        });
        let mut left = patch.to_vec();
        for subset in most_lopsided_first(&imbalance).into_iter().take(patch.len()) {
            let lean = |view: usize| -> [f64; 2] {
                std::array::from_fn(|axis| {
                    imbalance[subset][axis] + f64::from(cells[view][axis]) - mean[axis]
                })
            };
            let best = (0..left.len())
                .min_by(|&a, &b| square(lean(left[a])).total_cmp(&square(lean(left[b]))));
            if let Some(best) = best {
                let view = left.swap_remove(best);
                imbalance[subset] = lean(view);
                divided[subset].push(view);
            }
        }
    }
    divided
}

fn most_lopsided_first(imbalance: &[[f64; 2]]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..imbalance.len()).collect();
    order.sort_by(|&a, &b| square(imbalance[b]).total_cmp(&square(imbalance[a])));
    order
}

fn square([a, b]: [f64; 2]) -> f64 {
    a * a + b * b
}

/// Indices of `cells` along a Hilbert curve, in patches of `size`. The remainder comes last and
/// from the centre of the pupil, where one more view hardly changes a subset's mean.
fn in_patches(cells: &[[i32; 2]], size: usize) -> Vec<usize> {
    let mut order = along_hilbert_curve(cells);
    let mut inward = order.clone();
    inward.sort_by_key(|&view| Reverse(cells[view].iter().map(|cell| cell * cell).sum::<i32>()));
    let central = inward.split_off(cells.len() - cells.len() % size);
    order.retain(|view| !central.contains(view));
    order.extend(central);
    order
}

/// Indices of `cells`, ordered so that neighbours in the list are neighbours on the pupil.
fn along_hilbert_curve(cells: &[[i32; 2]]) -> Vec<usize> {
    let first = |axis: usize| cells.iter().map(|cell| cell[axis]).min().unwrap_or(0);
    let first = [first(0), first(1)];
    let place = |cell: [i32; 2]| [0, 1].map(|axis| cell[axis].abs_diff(first[axis]));
    let widest = cells.iter().flat_map(|&cell| place(cell)).max().unwrap_or(0);
    let side = (widest + 1).next_power_of_two();
    let mut order: Vec<usize> = (0..cells.len()).collect();
    order.sort_by_key(|&view| hilbert_distance(side, place(cells[view])));
    order
}

/// Distance of a cell along the Hilbert curve that fills a square of `side` cells, a power of two.
fn hilbert_distance(side: u32, [mut x, mut y]: [u32; 2]) -> u64 {
    let mut distance = 0;
    let mut half = side / 2;
    while half > 0 {
        let (right, up) = (x & half != 0, y & half != 0);
        let quadrant = match (right, up) {
            (false, false) => 0,
            (false, true) => 1,
            (true, true) => 2,
            (true, false) => 3,
        };
        distance += quadrant * u64::from(half) * u64::from(half);
        if !up {
            if right {
                (x, y) = (side - 1 - x, side - 1 - y);
            }
            (x, y) = (y, x);
        }
        half /= 2;
    }
    distance
}

#[cfg(test)]
mod tests {
    use std::collections::HashSet;

    use proptest::prelude::*;

    use super::*;
    use crate::{lightfield::MicrolensWindow, test_bench};

    fn layout() -> ViewLayout {
        let optics = test_bench::optics();
        ViewLayout::new(&optics, MicrolensWindow { columns: 60..64, rows: 48..52 })
    }

    #[test]
    fn the_hilbert_curve_visits_every_cell_in_unit_steps() {
        let side = 8;
        let mut cells: Vec<[u32; 2]> =
            (0..side).flat_map(|y| (0..side).map(move |x| [x, y])).collect();
        cells.sort_by_key(|&cell| hilbert_distance(side, cell));
        for (n, pair) in cells.windows(2).enumerate() {
            assert_eq!(hilbert_distance(side, pair[0]), n as u64);
            let step = pair[0][0].abs_diff(pair[1][0]) + pair[0][1].abs_diff(pair[1][1]);
            assert_eq!(step, 1);
        }
    }

    #[test]
    fn the_mean_pupil_position_of_each_subset_is_near_the_centre() {
        let layout = layout();
        let cells = pupil_cells(&layout);
        for subsets in 1..=32 {
            for subset in divide(&cells, subsets) {
                let sum = |axis: usize| subset.iter().map(|&view| cells[view][axis]).sum::<i32>();
                for sum in [sum(0), sum(1)] {
                    let mean = f64::from(sum) / subset.len() as f64;
                    // The pupil extends nine cells from its centre; the mean of eight random cells
                    // would be off by up to four.
                    assert!(mean.abs() <= 1.25, "{subsets} subsets: mean at {mean} cells");
                }
            }
        }
    }

    #[test]
    fn every_quarter_of_the_pupil_is_in_every_subset_alike() {
        let cells = pupil_cells(&layout());
        for subset in divide(&cells, 16) {
            for (right, up) in [(false, false), (false, true), (true, false), (true, true)] {
                let inside = |&&view: &&usize| (cells[view][0] >= 0, cells[view][1] >= 0);
                let share = subset.iter().filter(|v| inside(v) == (right, up)).count() as f64
                    / subset.len() as f64;
                assert!((share - 0.25).abs() < 0.15, "{share}");
            }
        }
    }

    #[test]
    fn one_subset_per_camera_is_the_conventional_sart() {
        let layouts = [layout(), layout()];
        let subsets = balanced_subsets(&layouts, 1);
        assert_eq!(subsets.len(), 2);
        for (camera, subset) in subsets.iter().enumerate() {
            assert_eq!(subset.len(), layouts[camera].views.len());
        }
        assert_eq!(balanced_subsets(&layouts, 0), subsets);
    }

    proptest! {
        #[test]
        fn subsets_divide_the_views_evenly_with_cameras_alternating(
            kept in [0usize..=300, 1usize..=300],
            subsets_per_camera in 1usize..=300,
        ) {
            let layouts = kept.map(|kept| {
                let mut layout = layout();
                layout.views.truncate(kept);
                layout
            });
            let subsets = balanced_subsets(&layouts, subsets_per_camera);
            let all: HashSet<ViewId> = subsets.iter().flatten().copied().collect();
            prop_assert_eq!(all.len(), subsets.iter().map(Vec::len).sum::<usize>());
            prop_assert_eq!(all.len(), layouts.iter().map(|l| l.views.len()).sum::<usize>());
            let cameras: Vec<usize> = subsets.iter().map(|subset| subset[0].camera).collect();
            for (camera, layout) in layouts.iter().enumerate() {
                let own: Vec<_> = subsets.iter().filter(|s| s[0].camera == camera).collect();
                prop_assert!(own.iter().all(|s| s.iter().all(|view| view.camera == camera)));
                let sizes = || own.iter().map(|s| s.len());
                prop_assert!(sizes().max().unwrap_or(0) <= sizes().min().unwrap_or(0) + 1);
                let expected = subsets_per_camera.min(layout.views.len());
                prop_assert_eq!(own.len(), expected);
            }
            let both = 2 * cameras.iter().filter(|&&c| c == 0).count()
                .min(cameras.iter().filter(|&&c| c == 1).count());
            prop_assert!(cameras[..both].iter().enumerate().all(|(n, &camera)| camera == n % 2));
        }
    }
}
