//! Photo-hull settings of the reconstruction, and MLOS.

use super::SparseVolume;
use crate::{
    lightfield::{ViewLayout, ViewStack},
    model::{ForwardModel, HullCriteria, photo_hull},
};

/// The photo-hull uses the views on every third diagonal of the pupil. With all views there are 10 % (0.3 ppm)
/// to 20 % (1 ppm) fewer blocks at three times the cost, and the solver prunes these blocks after a few views.
const DIAGONALS: i32 = 3;

/// For arbitrarily oriented cameras with few lit pixels, every fourth diagonal is used, and depths that are
/// displaced by up to a quarter of a microlens are evaluated as one. The hull's time dominates in this case,
/// because it does not depend on the number of particles. In images with more lit pixels the solver's time
/// dominates, and superfluous voxels of the hull reduce the accuracy (docs/decisions.md).
const FAST_DIAGONALS: i32 = 4;
const FAST_DISPLACEMENT: f64 = 0.25;
const DISPLACEMENT: f64 = 0.0625;

/// Share of lit pixels above which images are dense.
const DENSE: f64 = 0.35;

/// With fewer views than this per camera, all are used.
const MIN_VIEWS_FOR_SELECTION: usize = 120;

/// Number of views per camera in which a lit voxel may be dark, besides the share explained by noise:
/// [`NOISY_VIEW_SHARE`].
const TOLERATED_DARK_VIEWS: f64 = 1.0;
const NOISY_VIEW_SHARE: f64 = 0.03;

/// The hull for iterative solvers, which later separate lit from dark voxels: uses a subset of the
/// views. `dark_below` is, per camera, the count below which a pixel is dark.
pub(super) fn some_views(
    layouts: &[ViewLayout],
    views: &[ViewStack],
    dark_below: Vec<f32>,
) -> HullCriteria {
    let (mut selected, mut displacement) = (Vec::new(), Vec::new());
    for (layout, (stack, &dark_below)) in layouts.iter().zip(views.iter().zip(&dark_below)) {
        let is_fast = layout.grid.is_some() && lit_share(stack, dark_below) < DENSE;
        let diagonals = if is_fast { FAST_DIAGONALS } else { DIAGONALS };
        selected.push(views_on(layout, diagonals));
        displacement.push(if is_fast { FAST_DISPLACEMENT } else { DISPLACEMENT });
    }
    criteria(selected, dark_below, displacement)
}

/// The views on every `diagonals`-th diagonal of the pupil.
fn views_on(layout: &ViewLayout, diagonals: i32) -> Vec<usize> {
    let all = layout.views.len();
    let is_selected = |&n: &usize| {
        let view = &layout.views[n];
        all < MIN_VIEWS_FOR_SELECTION || (view.k + view.l).rem_euclid(diagonals) == 0
    };
    (0..all).filter(is_selected).collect()
}

/// Share of a camera's pixels, in all views, that are not dark.
fn lit_share(views: &ViewStack, dark_below: f32) -> f64 {
    let pixels = views.values();
    let lit = pixels.iter().filter(|&&value| value >= dark_below).count();
    lit as f64 / pixels.len().max(1) as f64
}

/// The hull as final result: uses all views.
fn all_views(layouts: &[ViewLayout], dark_below: Vec<f32>) -> HullCriteria {
    let selected = layouts.iter().map(|layout| (0..layout.views.len()).collect()).collect();
    criteria(selected, dark_below, vec![0.0; layouts.len()])
}

fn criteria(
    selected: Vec<Vec<usize>>,
    dark_below: Vec<f32>,
    displacement: Vec<f64>,
) -> HullCriteria {
    let tolerated = |selected: &Vec<usize>| {
        (TOLERATED_DARK_VIEWS + NOISY_VIEW_SHARE * selected.len() as f64) as usize
    };
    let tolerated = selected.iter().map(tolerated).collect();
    HullCriteria { tolerated, selected, dark_below, displacement }
}

/// The voxels of the model's grid that may contain light, each with the upper limit of its light from its
/// dimmest view, in counts. `dark_below` is, per camera, the count below which a pixel is dark.
pub fn mlos(model: &dyn ForwardModel, views: &[ViewStack], dark_below: &[f32]) -> SparseVolume {
    let criteria = all_views(model.layouts(), dark_below.to_vec());
    let hull = photo_hull(model, views, &criteria);
    SparseVolume { grid: model.grid().clone(), voxels: hull.voxels, intensity: hull.light }
}
