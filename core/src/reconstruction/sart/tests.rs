use nalgebra::DMatrix;

use super::*;
use crate::{
    model::{VolumeGrid, thin_lens_model},
    reconstruction::subsets::balanced_subsets,
    test_bench, untimed,
};

fn grid() -> VolumeGrid {
    VolumeGrid { voxels: [4, 3, 3], voxel_mm: 0.1, centre_mm: [0.0; 3] }
}

fn model() -> Box<dyn ForwardModel> {
    thin_lens_model(&test_bench::optics(), &test_bench::poses(), &grid(), 0.1).unwrap()
}

/// Inconsistent views that no volume explains; some pixels are below the black level.
fn views(model: &dyn ForwardModel) -> Vec<ViewStack> {
    let stack = |layout: &crate::lightfield::ViewLayout| {
        let pixels = layout.window.len() * layout.views.len();
        let values = (0..pixels).map(|n| ((n * 7919) % 101) as f32 - 20.0).collect();
        ViewStack::new(layout.window.len(), values)
    };
    model.layouts().iter().map(stack).collect()
}

/// The weights of a subset, one row per pixel, from images of single voxels.
fn weights(projector: &dyn Projector, views: &[ViewStack], subset: &[ViewId]) -> DMatrix<f64> {
    let voxels = grid().len();
    let columns: Vec<Vec<f64>> = (0..voxels)
        .map(|j| {
            let mut unit = vec![0.0; voxels];
            unit[j] = 1.0;
            let image = |id: &ViewId| {
                let mut image = vec![0.0; views[id.camera].view(id.view).len()];
                projector.project(*id, &unit, &mut image);
                image.into_iter().map(f64::from).collect::<Vec<f64>>()
            };
            subset.iter().flat_map(image).collect()
        })
        .collect();
    DMatrix::from_fn(columns[0].len(), voxels, |i, j| columns[j][i])
}

/// Eq. 2 with a dense matrix in f64.
fn naive_correction(
    w: &DMatrix<f64>,
    measured: &[f64],
    relaxation: f64,
    intensity: &[f64],
) -> Vec<f64> {
    let (pixels, voxels) = w.shape();
    let ratio: Vec<f64> = (0..pixels)
        .map(|i| {
            let row: f64 = (0..voxels).map(|m| w[(i, m)]).sum();
            let projected: f64 = (0..voxels).map(|m| w[(i, m)] * intensity[m]).sum();
            if row >= 1e-6 { (measured[i] - projected) / row } else { 0.0 }
        })
        .collect();
    (0..voxels)
        .map(|j| {
            let column: f64 = (0..pixels).map(|i| w[(i, j)]).sum();
            let sum: f64 = (0..pixels).map(|i| w[(i, j)] * ratio[i]).sum();
            (intensity[j] + relaxation * sum / column).max(0.0)
        })
        .collect()
}

#[test]
fn two_passes_follow_equation_2_written_out() {
    let model = model();
    let views = views(model.as_ref());
    let voxels: Vec<u32> = (0..grid().len() as u32).collect();
    let projector = model.projector(&voxels);
    for (subsets_per_camera, relaxation) in [(1, 1.0f32), (5, 0.7)] {
        let subsets = balanced_subsets(model.layouts(), subsets_per_camera);
        let mut expected = vec![0.0; voxels.len()];
        for subset in subsets.iter().cycle().take(2 * subsets.len()) {
            let w = weights(projector.as_ref(), &views, subset);
            let measured: Vec<f64> = subset
                .iter()
                .flat_map(|id| views[id.camera].view(id.view))
                .map(|&count| f64::from(count))
                .collect();
            expected = naive_correction(&w, &measured, f64::from(relaxation), &expected);
        }
        let options = SartOptions { relaxation, passes: 2, subsets, clock: untimed };
        let volume = sart(model.as_ref(), &views, voxels.clone(), &options, &mut |_, _| {});
        let brightest = expected.iter().copied().fold(0.0, f64::max);
        assert!(brightest > 1.0, "{brightest}");
        for (&e, &expected) in volume.intensity.iter().zip(&expected) {
            assert!((f64::from(e) - expected).abs() < 1e-4 * brightest, "{e}, {expected}");
        }
    }
}

#[test]
fn column_sums_made_at_each_use_give_the_same_volume() {
    let model = model();
    let views = views(model.as_ref());
    let voxels: Vec<u32> = (0..grid().len() as u32).collect();
    let options = SartOptions {
        relaxation: 1.0,
        passes: 3,
        subsets: balanced_subsets(model.layouts(), 8),
        clock: untimed,
    };
    let run = |bytes| {
        sart_within(model.as_ref(), &views, voxels.clone(), &options, bytes, &mut |_, _| {})
    };
    assert_eq!(run(0), run(usize::MAX));
}

/// Only an edge of the volume is in the field of a far off-axis camera: most sums of its views are zero.
#[test]
fn voxels_that_no_pixel_sees_stay_dark_and_nothing_is_nan() {
    let optics = test_bench::optics();
    let grid = VolumeGrid { voxels: [30, 4, 4], voxel_mm: 0.1, centre_mm: [7.0, 0.0, 0.0] };
    let model = thin_lens_model(&optics, &test_bench::poses()[..1], &grid, 0.1).unwrap();
    let views: Vec<ViewStack> = model
        .layouts()
        .iter()
        .map(|l| ViewStack::new(l.window.len(), vec![50.0; l.window.len() * l.views.len()]))
        .collect();
    let options = SartOptions {
        relaxation: 1.0,
        passes: 5,
        subsets: balanced_subsets(model.layouts(), 16),
        clock: untimed,
    };
    let voxels = (0..grid.len() as u32).collect();
    let mut residuals = Vec::new();
    let volume = sart(model.as_ref(), &views, voxels, &options, &mut |report, _| {
        residuals.push(report.residual);
    });
    assert!(residuals.len() == 5 && residuals.iter().all(|r| r.is_finite()));
    assert!(volume.intensity.iter().all(|e| e.is_finite() && *e >= 0.0));
    // The array ends at 6.45 mm; x runs from 5.55 to 8.45 mm.
    let row = &volume.intensity[..30];
    assert!(row[2] > 0.0 && row[25] == 0.0, "{row:?}");
}

#[test]
fn no_voxels_no_passes_and_no_views_give_dark_volumes() {
    let model = model();
    let views = views(model.as_ref());
    let subsets = balanced_subsets(model.layouts(), 4);
    for (voxels, passes, subsets) in [
        (Vec::new(), 2, subsets.clone()),
        (vec![3, 7], 0, subsets),
        (vec![3, 7], 2, vec![Vec::new()]),
    ] {
        let options = SartOptions { relaxation: 1.0, passes, subsets, clock: untimed };
        let volume = sart(model.as_ref(), &views, voxels.clone(), &options, &mut |_, _| {});
        assert_eq!(volume.voxels, voxels);
        assert_eq!(volume.intensity, vec![0.0; voxels.len()]);
    }
}
