//! Single precision against double, and against itself at other magnitudes.

use lfpiv_core::{
    model::{ForwardModel, ViewId, thin_lens_model},
    reconstruction::{SartOptions, sart},
    untimed,
    velocimetry::{Interrogation, PointCloud},
};
use lfpiv_sim::FrameOfPair;

use super::bench::{SEED, shot, usual};

/// Rows Σ_j w_ij of one view for all voxels, as the model has them, in double precision.
struct Rows {
    view: ViewId,
    weights: Vec<Vec<(usize, f64)>>,
}

fn rows(model: &dyn ForwardModel, view: ViewId, voxels: &[u32]) -> Rows {
    let projector = model.projector(voxels);
    let mut weights = vec![Vec::new(); model.layouts()[view.camera].window.len()];
    let mut image = vec![0.0f32; weights.len()];
    for voxel in 0..voxels.len() {
        let mut unit = vec![0.0; voxels.len()];
        unit[voxel] = 1.0;
        projector.project(view, &unit, &mut image);
        for (row, &w) in weights.iter_mut().zip(&image) {
            if w != 0.0 {
                row.push((voxel, f64::from(w)));
            }
        }
    }
    Rows { view, weights }
}

/// SART by its formula (the paper's Eq. 2), each subset one view, in double precision.
fn sart_f64(subsets: &[(Rows, Vec<f64>)], voxels: usize, passes: usize) -> Vec<f64> {
    let mut light = vec![0.0f64; voxels];
    for _ in 0..passes {
        for (rows, measured) in subsets {
            let (mut correction, mut columns) = (vec![0.0; voxels], vec![0.0; voxels]);
            for (row, measured) in rows.weights.iter().zip(measured) {
                let sum: f64 = row.iter().map(|(_, w)| w).sum();
                if sum <= 1e-6 {
                    continue;
                }
                let projected: f64 = row.iter().map(|&(j, w)| w * light[j]).sum();
                for &(j, w) in row {
                    correction[j] += w * (measured - projected) / sum;
                    columns[j] += w;
                }
            }
            for ((light, correction), column) in light.iter_mut().zip(correction).zip(columns) {
                if column > 1e-6 {
                    *light = (*light + correction / column).max(0.0);
                }
            }
        }
    }
    light
}

/// Rounding at 6e-8 grows with the root of the 20,000 additions that a voxel sees in 20 passes, to
/// 1e-5 of the brightest; ten times that is allowed for.
#[test]
fn single_precision_sart_is_that_of_double_precision() {
    let mut config = usual();
    config.volume.voxels = [6, 5, 4];
    let optics = &mut config.optics;
    (optics.microlens.columns, optics.microlens.rows) = (11, 11);
    (optics.sensor.columns, optics.sensor.rows) = (201, 201);
    let shot = shot(&config, SEED);
    let model = thin_lens_model(&config.optics, &config.camera, &config.volume, 0.1).unwrap();
    let voxels: Vec<u32> = (0..config.volume.len() as u32).collect();
    let stacks: Vec<_> = model
        .layouts()
        .iter()
        .zip(&shot.images)
        .map(|(layout, [image, _])| layout.decode(image, |_, _, count| f32::from(count) - 74.0))
        .collect();
    let order: Vec<ViewId> = (0..model.layouts().len())
        .flat_map(|camera| {
            let views = model.layouts()[camera].views.len();
            (0..views).step_by(9).map(move |view| ViewId { camera, view })
        })
        .collect();
    let subsets: Vec<(Rows, Vec<f64>)> = order
        .iter()
        .map(|&id| {
            let measured = stacks[id.camera].view(id.view).iter().map(|&v| f64::from(v)).collect();
            (rows(model.as_ref(), id, &voxels), measured)
        })
        .collect();
    assert!(subsets.iter().all(|(rows, _)| order.contains(&rows.view)));
    let reference = sart_f64(&subsets, voxels.len(), 20);
    let options = SartOptions {
        relaxation: 1.0,
        passes: 20,
        subsets: order.iter().map(|&id| vec![id]).collect(),
        clock: untimed,
    };
    let found = sart(model.as_ref(), &stacks, voxels, &options, &mut |_, _| ());
    let brightest = reference.iter().copied().fold(0.0, f64::max);
    let worst = reference
        .iter()
        .zip(&found.intensity)
        .map(|(r, &f)| (r - f64::from(f)).abs() / brightest)
        .fold(0.0, f64::max);
    println!("f32 against f64 SART: {worst:.1e} of the brightest voxel");
    assert!(brightest > 10.0 && worst <= 1e-4, "{worst} of {brightest}");
}

/// Displacements do not depend on the unit of light, over twelve orders of magnitude.
#[test]
fn correlation_does_not_depend_on_the_unit_of_light() {
    let config = usual();
    let truth = shot(&config, SEED).truth;
    let interrogation = Interrogation::new(&config.volume, 2, &config.velocimetry);
    let grid = interrogation.cloud_grid();
    let measure = |unit: f64| {
        let [a, b] = [FrameOfPair::A, FrameOfPair::B].map(|frame| {
            let lit = truth.particles.iter().filter_map(|p| Some((p.lit_mm(frame)?, unit)));
            PointCloud::from_particles(&lit.collect::<Vec<_>>(), &grid)
        });
        interrogation.measure(&a, &b, 1e-4)
    };
    let usual = measure(1.0);
    assert!(usual.valid_share() > 0.9);
    for unit in [1e-6, 1e-3, 1e3, 1e6] {
        let other = measure(unit);
        assert_eq!(other.status, usual.status, "{unit}");
        for (pair, name) in [
            ((&other.displacement_vox, &usual.displacement_vox), "displacement"),
            ((&other.uncertainty_vox, &usual.uncertainty_vox), "uncertainty"),
        ] {
            let worst = pair
                .0
                .iter()
                .flatten()
                .zip(pair.1.iter().flatten())
                .map(|(a, b)| (a - b).abs())
                .fold(0.0f32, f32::max);
            assert!(worst <= 1e-3, "{name} at {unit}: {worst} voxels");
        }
    }
}
