//! Views for assessing a reconstruction.

use rayon::prelude::*;

use super::SparseVolume;
use crate::{
    lightfield::ViewLayout,
    model::{ForwardModel, ViewId},
};

/// Number of these views per camera: a sixth of those of the bench. Their projection takes a few percent of the
/// reconstruction's time.
const PROBES_PER_CAMERA: usize = 40;

/// Projection of a volume into one view.
#[derive(Debug, Clone, PartialEq)]
pub struct ProjectedView {
    /// The view.
    pub id: ViewId,
    /// Its pixels, row-major over the camera's microlens window, in counts.
    pub image: Vec<f32>,
}

/// The views for assessing a reconstruction: fully open, evenly distributed over the pupil.
pub(super) fn probes(layouts: &[ViewLayout]) -> Vec<ViewId> {
    let of_camera = |(camera, layout): (usize, &ViewLayout)| {
        let open: Vec<usize> =
            (0..layout.views.len()).filter(|&view| !layout.views[view].is_cut()).collect();
        let views = if open.is_empty() { (0..layout.views.len()).collect() } else { open };
        let probes = PROBES_PER_CAMERA.min(views.len());
        (0..probes)
            .map(move |n| ViewId { camera, view: views[(2 * n + 1) * views.len() / (2 * probes)] })
            .collect::<Vec<_>>()
    };
    layouts.iter().enumerate().flat_map(of_camera).collect()
}

/// Projects `volume` into these views.
pub(super) fn projected(model: &dyn ForwardModel, volume: &SparseVolume) -> Vec<ProjectedView> {
    let projector = model.projector(&volume.voxels);
    probes(model.layouts())
        .into_par_iter()
        .map(|id| {
            let mut image = vec![0.0; model.layouts()[id.camera].window.len()];
            projector.project(id, &volume.intensity, &mut image);
            ProjectedView { id, image }
        })
        .collect()
}
