//! The paper's numerical verification (section 4.1) on a small volume: ray-traced particles on
//! voxel centres, no noise, reconstructed by SART, OS-SART and PR-SART with one camera and two.
//!
//! Figures are printed: `cargo test --package lfpiv-core --test capabilities reconstruction_paper -- --nocapture`.

use lfpiv_core::{
    lightfield::ViewStack,
    model::{ForwardModel, ViewId, VolumeGrid, thin_lens_model},
    reconstruction::{
        ConvergenceLog, DenseVolume, SartOptions, SparseVolume, pr_sart, quality::elongation_mm,
        sart, subsets::balanced_subsets,
    },
    untimed,
};
use lfpiv_hw::{Optics, RawImage};
use lfpiv_sim::{
    Placement,
    imaging::{PointSource, RaySettings, RayTracer},
    particles::Seeding,
};

use crate::test_bench::{optics, poses};

/// Photo-electrons, here also counts, of one particle: 3852 per open pupil cell.
const PARTICLE_COUNTS: f64 = 1e6;

/// Footprint of a point in the model, in mm: the paper's particles are points on voxel centres.
const POINT_MM: f64 = 0.001;

/// Ordered subsets per camera: 16 of 16 views.
const SUBSETS: usize = 16;

/// A reconstruction problem whose answer is known.
struct Case {
    model: Box<dyn ForwardModel>,
    views: Vec<ViewStack>,
    truth: DenseVolume,
}

impl Case {
    fn new(cameras: usize, grid: VolumeGrid, particles: &[[f64; 3]]) -> Self {
        let optics = optics();
        let poses = poses()[..cameras].to_vec();
        let model = thin_lens_model(&optics, &poses, &grid, POINT_MM).unwrap();
        let settings = RaySettings { rays_per_particle: 40_000, diffraction_nm: None };
        let images = poses.iter().zip(0..).map(|(pose, camera)| {
            let tracer = RayTracer::new(&optics, pose, &settings);
            let source = |(id, &position_mm): (usize, &[f64; 3])| PointSource {
                id: id as u64,
                position_mm,
                electrons: PARTICLE_COUNTS,
            };
            let sources: Vec<_> = particles.iter().enumerate().map(source).collect();
            let light = tracer.trace(&sources, &[camera]);
            let counts = light.electrons().iter().map(|&e| e.round() as u16).collect();
            RawImage::new(light.columns(), light.rows(), counts).unwrap()
        });
        let views = images
            .zip(model.layouts())
            .map(|(image, layout)| layout.decode(&image, |_, _, count| f32::from(count)))
            .collect();
        let truth = truth(&optics, grid, particles);
        Self { model, views, truth }
    }

    /// Particles on voxel centres at `ppm` in 24 × 20 × 20 voxels of 0.1 mm about a depth from
    /// camera 1's focal plane. The volume is 2 mm deep: at equal ppm it holds five times as many
    /// particles per mm³ as the paper's.
    fn seeded(cameras: usize, ppm: f64, depth_mm: f64) -> Self {
        let centre_mm = [0.0, 0.0, depth_mm];
        let grid = VolumeGrid { voxels: [24, 20, 20], voxel_mm: 0.1, centre_mm };
        let seeding = Seeding {
            ppm,
            placement: Placement::OnGrid,
            intensity_spread: 0.0,
            sheet_mm: None,
            empty: None,
        };
        let volume = lfpiv_sim::Volume {
            voxels: grid.voxels,
            voxel_mm: grid.voxel_mm,
            centre_mm: grid.centre_mm,
        };
        let still = lfpiv_sim::Flow::default();
        let particles = seeding.particles(&volume, 0.1, &still, 0.0, (5, 0));
        let positions: Vec<[f64; 3]> = particles.iter().map(|p| p.mid_mm).collect();
        Self::new(cameras, grid, &positions)
    }

    /// One particle at a depth from camera 1's focal plane, as in the paper's Fig. 10.
    fn single_particle(cameras: usize, depth_mm: f64) -> Self {
        let centre_mm = [0.0, 0.0, depth_mm];
        let grid = VolumeGrid { voxels: [9, 9, 41], voxel_mm: 0.1, centre_mm };
        let position = grid.centre_of([4, 4, 20]);
        Self::new(cameras, grid, &[position.into()])
    }

    fn options(&self, subsets_per_camera: usize, passes: usize) -> SartOptions {
        let subsets = balanced_subsets(self.model.layouts(), subsets_per_camera);
        SartOptions { relaxation: 1.0, passes, subsets, clock: untimed }
    }

    fn sart(&self, subsets_per_camera: usize, passes: usize) -> (SparseVolume, ConvergenceLog) {
        let mut log = ConvergenceLog::with_truth(self.truth.clone());
        let voxels = (0..self.model.grid().len() as u32).collect();
        let options = self.options(subsets_per_camera, passes);
        let volume =
            sart(self.model.as_ref(), &self.views, voxels, &options, &mut |report, volume| {
                log.record(report, volume);
            });
        (volume, log)
    }

    fn pr_sart(&self, passes: usize) -> (SparseVolume, ConvergenceLog) {
        let mut log = ConvergenceLog::with_truth(self.truth.clone());
        let options = self.options(1, passes);
        // A tenth of what a particle gives a pixel that all of its light reaches.
        let dark_below = vec![0.1 * counts_per_cell(&optics()) as f32; self.views.len()];
        let volume = pr_sart(
            self.model.as_ref(),
            &self.views,
            &dark_below,
            &options,
            &mut |report, volume| log.record(report, volume),
        );
        (volume, log)
    }

    fn elongation_mm(&self, volume: &SparseVolume) -> f64 {
        elongation_mm(&volume.on_grid(&self.truth.grid), 2).unwrap()
    }
}

/// Counts of a particle in a pixel that sees an open pupil cell and gets all of its light.
fn counts_per_cell(optics: &Optics) -> f64 {
    let radius_mm = optics.pupil_diameter_mm() / 2.0;
    PARTICLE_COUNTS * optics.pupil_cell_mm().powi(2) / (std::f64::consts::PI * radius_mm.powi(2))
}

fn truth(optics: &Optics, grid: VolumeGrid, particles: &[[f64; 3]]) -> DenseVolume {
    let mut intensity = vec![0.0; grid.len()];
    for position in particles {
        let index = |axis: usize| grid.index_of(axis, position[axis]).round() as usize;
        intensity[grid.linear([index(0), index(1), index(2)])] = counts_per_cell(optics) as f32;
    }
    DenseVolume { grid, intensity }
}

fn quality(log: &ConvergenceLog) -> f64 {
    log.last().and_then(|point| point.quality).unwrap()
}

fn report(name: &str, log: &ConvergenceLog) {
    let point = log.last().unwrap();
    println!(
        "{name}: pass {}, residual {:.4}, Q {:.4}, error {:.1}, {} voxels, {:.2} s",
        point.report.pass,
        point.report.residual,
        point.quality.unwrap(),
        point.error.unwrap(),
        point.report.active_voxels,
        log.seconds(),
    );
}

#[test]
fn the_residual_of_sart_falls_with_every_pass() {
    let (_, log) = Case::seeded(2, 1.0, 0.0).sart(1, 30);
    report("SART, 1 ppm, two cameras", &log);
    for pair in log.passes.windows(2) {
        assert!(pair[1].report.residual < pair[0].report.residual, "{pair:?}");
    }
}

#[test]
fn ordered_subsets_need_at_most_a_quarter_of_the_passes_of_sart() {
    for ppm in [0.1, 1.0] {
        let case = Case::seeded(2, ppm, 0.0);
        let (_, slow) = case.sart(1, 40);
        let (_, fast) = case.sart(SUBSETS, 20);
        report(&format!("SART, {ppm} ppm"), &slow);
        report(&format!("OS-SART, {ppm} ppm"), &fast);
        let reached = fast.first_to_reach(quality(&slow)).unwrap();
        println!(
            "{ppm} ppm: OS-SART reaches the Q of 40 passes of SART in {}",
            reached.report.pass
        );
        assert!(reached.report.pass <= 10);
        for (slow, fast) in slow.passes.iter().zip(&fast.passes) {
            assert!(fast.quality > slow.quality && fast.error < slow.error);
        }
    }
}

/// Away from focus: see below for what a single camera can know in focus.
#[test]
fn pre_recognition_helps_a_single_camera() {
    for ppm in [0.03, 0.1, 0.3] {
        let case = Case::seeded(1, ppm, 4.0);
        let (_, plain) = case.sart(1, 30);
        let (_, recognised) = case.pr_sart(30);
        report(&format!("SART, one camera, {ppm} ppm at 4 mm"), &plain);
        report(&format!("PR-SART, one camera, {ppm} ppm at 4 mm"), &recognised);
        // Measured: 0.14, 0.12 and 0.10 more.
        assert!(quality(&recognised) > quality(&plain) + 0.05);
        let active = recognised.last().unwrap().report.active_voxels;
        assert!(active < case.truth.grid.len() / 5, "{active}");
    }
}

#[test]
fn two_cameras_are_clearly_better_than_one() {
    let (_, one) = Case::seeded(1, 0.5, 0.0).sart(SUBSETS, 20);
    let (_, two) = Case::seeded(2, 0.5, 0.0).sart(SUBSETS, 20);
    report("OS-SART, one camera, 0.5 ppm", &one);
    report("OS-SART, two cameras, 0.5 ppm", &two);
    assert!(quality(&two) > quality(&one) + 0.2);
}

/// Within 0.8 mm of focus the main lens blurs a point by less than a microlens: no view tells its
/// depth, and pre-recognition cannot either.
#[test]
fn a_second_camera_ends_the_elongation_along_depth() {
    for (depth_mm, times) in [(0.0, 10.0), (3.0, 2.5)] {
        let one = Case::single_particle(1, depth_mm);
        let two = Case::single_particle(2, depth_mm);
        let single = one.elongation_mm(&one.sart(SUBSETS, 40).0);
        let recognised = one.elongation_mm(&one.pr_sart(40).0);
        let dual = two.elongation_mm(&two.sart(SUBSETS, 40).0);
        println!(
            "FWHM along depth at {depth_mm} mm: one camera {single:.3} mm (PR-SART \
             {recognised:.3} mm), two cameras {dual:.3} mm"
        );
        assert!(dual < 0.12, "{dual}");
        assert!(single > times * dual, "{single}, {dual}");
    }
}

#[test]
fn one_thread_and_two_give_the_same_volume() {
    let case = Case::seeded(2, 0.5, 0.0);
    let run = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| (case.sart(SUBSETS, 2), case.pr_sart(2)))
    };
    let ((one, one_log), (one_pr, _)) = run(1);
    let ((two, two_log), (two_pr, _)) = run(2);
    assert!(one.intensity.iter().any(|&e| e > 0.0) && !one_pr.voxels.is_empty());
    assert_eq!(one, two);
    assert_eq!(one_pr, two_pr);
    let residuals = |log: &ConvergenceLog| -> Vec<f64> {
        log.passes.iter().map(|point| point.report.residual).collect()
    };
    assert_eq!(residuals(&one_log), residuals(&two_log));
}

#[test]
fn one_camera_of_a_two_camera_model_can_be_used_alone() {
    let case = Case::seeded(2, 0.1, 0.0);
    let mut options = case.options(SUBSETS, 3);
    options.subsets.retain(|subset| subset.iter().all(|ViewId { camera, .. }| *camera == 0));
    let voxels: Vec<u32> = (0..case.model.grid().len() as u32).collect();
    let volume = sart(case.model.as_ref(), &case.views, voxels, &options, &mut |_, _| {});
    let alone = Case::seeded(1, 0.1, 0.0).sart(SUBSETS, 3).0;
    assert_eq!(volume.intensity, alone.intensity);
}
