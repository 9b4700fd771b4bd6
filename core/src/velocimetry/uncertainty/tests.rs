use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::*;
use crate::velocimetry::{PointCloud, raster::Raster};

const EDGE: usize = 16;
const VOXELS: [usize; 3] = [EDGE + 8; 3];

/// Both frames of a window: `count` particles that move by `shift_vox` and each by an error of its
/// own, with a standard deviation of `error_vox` per component.
fn frames(count: usize, shift_vox: f32, error_vox: f32, seed: u64) -> [Vec<f32>; 2] {
    let mut random = Pcg64Mcg::seed_from_u64(seed);
    let mut uniform = |half: f32| random.random_range(-half..=half);
    let a: Vec<[f32; 3]> =
        (0..count).map(|_| [(); 3].map(|()| 12.0 + uniform(EDGE as f32 / 2.0 - 0.5))).collect();
    // A rectangular distribution of half-width √3 σ.
    let b =
        a.iter().map(|at| at.map(|c| c + shift_vox + uniform(3f32.sqrt() * error_vox))).collect();
    let raster = Raster { cells: VOXELS, first_vox: [0.0; 3], cell_vox: 1.0 };
    [a, b].map(|position_vox| {
        let cloud =
            PointCloud { light: vec![1.0; position_vox.len()], position_vox, grain_vox: 0.0 };
        raster.render(&cloud, None)
    })
}

fn statistics(frames: &[Vec<f32>; 2]) -> Option<PeakStatistics> {
    let [a, b] = frames.each_ref().map(|light| Image {
        light,
        cells: VOXELS,
        lit: VOXELS.map(|n| [0, n as i64]),
    });
    PeakStatistics::of([a, b], [4; 3], EDGE, [0; 3], &mut Cutouts::default())
}

#[test]
fn equal_frames_leave_no_doubt_and_count_the_particles() {
    for count in [10, 30] {
        let found: Vec<PeakStatistics> =
            (0..20).filter_map(|seed| statistics(&frames(count, 0.0, 0.0, seed))).collect();
        assert_eq!(found.len(), 20);
        for found in &found {
            assert!(found.variance_vox2.iter().all(|&v| v < 1e-9), "{found:?}");
            assert!((found.coefficient - 1.0).abs() < 1e-4, "{found:?}");
        }
        // The mean of the reciprocals: what the estimate adds up.
        let counted = 20.0 / found.iter().map(|found| 1.0 / found.particles).sum::<f32>();
        assert!((0.6..1.6).contains(&(counted / count as f32)), "{counted} of {count}");
    }
}

/// The mean of n particles that err by σ each errs by σ/√n; a residual that all share is no error.
#[test]
fn the_variance_is_that_of_the_mean_of_the_particles() {
    const ERROR_VOX: f32 = 0.2;
    for shift_vox in [0.0, 0.15] {
        let count = 25;
        let mean = (0..40)
            .filter_map(|seed| statistics(&frames(count, shift_vox, ERROR_VOX, seed)))
            .map(|found| found.variance_vox2.iter().sum::<f32>() / 3.0)
            .sum::<f32>()
            / 40.0;
        let expected = ERROR_VOX.powi(2) / count as f32;
        assert!((0.7..1.4).contains(&(mean / expected)), "{shift_vox}: {mean} for {expected}");
    }
}

#[test]
fn one_particle_cannot_confirm_itself_and_darkness_has_no_peak() {
    let lone = statistics(&frames(1, 0.1, 0.0, 3)).unwrap();
    assert_eq!(lone.uncertainty_vox([0.1; 3]), None, "{lone:?}");
    let dark = [vec![0.0; 24 * 24 * 24], vec![0.0; 24 * 24 * 24]];
    assert_eq!(statistics(&dark), None);
}

#[test]
fn few_particles_know_no_more_than_the_voxel() {
    let few = PeakStatistics { variance_vox2: [0.0; 3], particles: 3.0, coefficient: 1.0 };
    assert!((few.uncertainty_vox([0.0; 3]).unwrap()[0] - 0.2887).abs() < 1e-4);
    let many = PeakStatistics { variance_vox2: [0.01; 3], particles: 1000.0, coefficient: 1.0 };
    assert!((many.uncertainty_vox([0.0; 3]).unwrap()[0] - 0.1 * SOLVER_ERROR_FACTOR).abs() < 1e-3);
    let moving = many.uncertainty_vox([2.0; 3]).unwrap()[0];
    assert!((moving - 0.38f32.hypot(0.1 * SOLVER_ERROR_FACTOR)).abs() < 1e-3);
}
