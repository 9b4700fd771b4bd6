//! Photo-hull settings of the reconstruction, and MLOS.

use super::SparseVolume;
use crate::{
    lightfield::{ViewLayout, ViewStack},
    model::{ForwardModel, HullCriteria, photo_hull},
};

/// The photo-hull uses the views on every third diagonal of the pupil. All views leave 10 % (0.3
/// ppm) to 20 % (1 ppm) fewer blocks, which the first views of the solver prune anyway, at three
/// times the cost.
const DIAGONALS: i32 = 3;

/// For arbitrarily oriented cameras, every fourth diagonal (docs/decisions.md).
const DIAGONALS_ON_GRID: i32 = 4;

/// With fewer views than this per camera, all are used.
const MIN_VIEWS_FOR_SELECTION: usize = 120;

/// Number of views per camera that may find a lit voxel dark, besides the share explained by noise.
const TOLERATED_DARK_VIEWS: f64 = 1.0;
const NOISE_SHARE: f64 = 0.03;

/// The hull for iterative solvers, which later separate lit from dark voxels: uses a subset of the
/// views. `dark_below` is, per camera, the count below which a pixel is dark.
pub(super) fn some_views(layouts: &[ViewLayout], dark_below: Vec<f32>) -> HullCriteria {
    let selected = layouts.iter().map(|layout| {
        let all = layout.views.len();
        let diagonals = if layout.grid.is_some() { DIAGONALS_ON_GRID } else { DIAGONALS };
        let is_asked = |&n: &usize| {
            let view = &layout.views[n];
            all < MIN_VIEWS_FOR_SELECTION || (view.k + view.l).rem_euclid(diagonals) == 0
        };
        (0..all).filter(is_asked).collect()
    });
    criteria(selected.collect(), dark_below)
}

/// The hull as final result: uses all views.
fn all_views(layouts: &[ViewLayout], dark_below: Vec<f32>) -> HullCriteria {
    criteria(layouts.iter().map(|layout| (0..layout.views.len()).collect()).collect(), dark_below)
}

fn criteria(selected: Vec<Vec<usize>>, dark_below: Vec<f32>) -> HullCriteria {
    let tolerated = |selected: &Vec<usize>| {
        (TOLERATED_DARK_VIEWS + NOISE_SHARE * selected.len() as f64) as usize
    };
    HullCriteria { tolerated: selected.iter().map(tolerated).collect(), selected, dark_below }
}

/// The voxels of the model's grid that may contain light, each with the largest light that its dimmest
/// view allows, in counts. `dark_below` is, per camera, the count below which a pixel is dark.
pub fn mlos(model: &dyn ForwardModel, views: &[ViewStack], dark_below: &[f32]) -> SparseVolume {
    let criteria = all_views(model.layouts(), dark_below.to_vec());
    let hull = photo_hull(model, views, &criteria);
    SparseVolume { grid: model.grid().clone(), voxels: hull.voxels, intensity: hull.light }
}
