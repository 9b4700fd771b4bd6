//! Ordered subsets of views.

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
