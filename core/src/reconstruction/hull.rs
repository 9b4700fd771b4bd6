//! Which voxels a reconstruction may light: the photo-hull's rule, and MLOS.

use super::SparseVolume;
use crate::{
    lightfield::{ViewLayout, ViewStack},
    model::{Darkness, ForwardModel, photo_hull},
};

/// The views on every third diagonal of the pupil are asked. All of them leave a tenth (0.3 ppm)
/// to a fifth (1 ppm) fewer blocks, which the first views of the solver give up anyway, and cost three
/// times as much.
const DIAGONALS: i32 = 3;

/// Of cameras that stand anyhow every fourth diagonal is asked: each costs three times as much there.
const DIAGONALS_ON_GRID: i32 = 4;

/// Cameras with fewer views than this are asked for all of them.
const LEAST_VIEWS_TO_CHOOSE: usize = 120;

/// Views of a camera that may find a lit voxel dark: a few always, a share of them by noise.
const FORGIVEN: f64 = 1.0;
const NOISE_SHARE: f64 = 0.03;

/// The hull for solvers that go on to tell lit voxels from dark ones: a part of the views is asked.
/// `dark_below` is, per camera, the count under which a pixel is dark.
pub(super) fn some_views(layouts: &[ViewLayout], dark_below: Vec<f32>) -> Darkness {
    let asked = layouts.iter().map(|layout| {
        let all = layout.views.len();
        let diagonals = if layout.grid.is_some() { DIAGONALS_ON_GRID } else { DIAGONALS };
        let is_asked = |&n: &usize| {
            let view = &layout.views[n];
            all < LEAST_VIEWS_TO_CHOOSE || (view.k + view.l).rem_euclid(diagonals) == 0
        };
        (0..all).filter(is_asked).collect()
    });
    darkness(asked.collect(), dark_below)
}

/// The hull where nothing follows that could tell lit voxels from dark ones: all views are asked.
fn all_views(layouts: &[ViewLayout], dark_below: Vec<f32>) -> Darkness {
    darkness(layouts.iter().map(|layout| (0..layout.views.len()).collect()).collect(), dark_below)
}

fn darkness(asked: Vec<Vec<usize>>, dark_below: Vec<f32>) -> Darkness {
    let forgiven = |asked: &Vec<usize>| (FORGIVEN + NOISE_SHARE * asked.len() as f64) as usize;
    Darkness { forgiven: asked.iter().map(forgiven).collect(), asked, dark_below }
}

/// The voxels of the model's grid that may hold light, each with the light that its dimmest view
/// allows, in counts. `dark_below` is, per camera, the count under which a pixel is dark.
pub fn mlos(model: &dyn ForwardModel, views: &[ViewStack], dark_below: &[f32]) -> SparseVolume {
    let darkness = all_views(model.layouts(), dark_below.to_vec());
    let hull = photo_hull(model, views, &darkness);
    SparseVolume { grid: model.grid().clone(), voxels: hull.voxels, intensity: hull.light }
}
