//! Too many particles, too few, or in the wrong places.

use lfpiv_core::{
    lightfield::ImagePair, measurement::Processor, reconstruction::DenseVolume,
    velocimetry::VectorStatus,
};
use lfpiv_sim::{Truth, particles::Tracer};

use super::bench::{
    Measured, SEED, images_of, measured, shot, simulated, uniform, usual, with_scene,
};
use crate::support::Bench;

const SHIFT_VOX: [f64; 3] = [0.7, -0.45, 0.3];

/// Particles at these places in the middle of the pair (mm), in a uniform flow.
fn truth(config: &Bench, places: impl IntoIterator<Item = ([f64; 3], f64)>) -> Truth {
    let voxel_mm = config.volume.voxel_mm;
    let particle = |(mid_mm, intensity): ([f64; 3], f64)| {
        let at =
            |sign: f64| std::array::from_fn(|c| mid_mm[c] + sign * SHIFT_VOX[c] / 2.0 * voxel_mm);
        let (a_mm, b_mm) = (at(-1.0), at(1.0));
        Tracer { a_mm, mid_mm, b_mm, intensity, visible_a: true, visible_b: true }
    };
    Truth {
        seed: SEED,
        shot: 0,
        dt_s: config.shot.dt_us / 1e6,
        flow: uniform(SHIFT_VOX),
        particles: places.into_iter().map(particle).collect(),
    }
}

fn measured_truth(config: &Bench, truth: &Truth) -> Measured {
    measured(config, images_of(config, truth), &truth.flow)
}

/// Where a scene's particles are in the middle of the pair, as if their sheet were `sheet_mm` wide.
fn drawn(ppm: f64, sheet_mm: [f64; 3]) -> Vec<[f64; 3]> {
    let config = with_scene(|scene| (scene.ppm, scene.sheet_mm) = (ppm, Some(sheet_mm)));
    let scene = config.simulation.as_ref().unwrap();
    let truth = scene.truth(&config.geometry(), SEED, 0);
    truth.particles.iter().map(|particle| particle.mid_mm).collect()
}

/// Half edges of the volume, in mm.
fn half_mm(config: &Bench) -> [f64; 3] {
    config.volume.voxels.map(|n| n as f64 / 2.0 * config.volume.voxel_mm)
}

/// Every view of every camera is a picture with `ppm` particles per pixel. From one on particles
/// overlap in all of them and ghosts grow with ppm squared, but windows hold as many more particles
/// to average. Errors may double from step to step, and are smaller where particles are placed; what is no longer
/// known is not valid.
#[test]
fn dense_seeding_degrades_smoothly() {
    let mut before = Vec::new();
    for (ppm, most_vox) in [(1.0, 0.06), (2.0, 0.1), (5.0, 0.3)] {
        let found = simulated(&with_scene(|scene| scene.ppm = ppm), SEED);
        found.print(&format!("{ppm} ppm"));
        assert!(found.rms() <= most_vox, "{ppm} ppm: {}", found.rms());
        if let Some(largest) = before.iter().copied().reduce(f64::max) {
            assert!(found.rms() <= 2.5 * largest, "{ppm} ppm: {largest} to {}", found.rms());
        }
        assert!(found.false_share() <= 0.03, "{ppm} ppm: {}", found.false_share());
        before.push(found.rms());
    }
}

/// Where a volume's light is, in voxels from a place along x, y, z; `None` in darkness.
fn centroid_off_vox(volume: &DenseVolume, from_mm: [f64; 3]) -> Option<[f64; 3]> {
    let (grid, mut total, mut moment) = (&volume.grid, 0.0, [0.0; 3]);
    for (n, &light) in volume.intensity.iter().enumerate().filter(|(_, light)| **light > 0.0) {
        let at_mm = grid.centre_of(grid.indices(n as u32));
        total += f64::from(light);
        for axis in 0..3 {
            moment[axis] += f64::from(light) * (at_mm[axis] - from_mm[axis]);
        }
    }
    (total > 0.0).then(|| moment.map(|m| m / total / grid.voxel_mm))
}

/// One particle at a time, at places of no pattern. The worst view of a particle is the picture of a
/// point in a microlens, a voxel wide: its light lies within half a voxel of it, along every axis.
fn lone_particles(refinement: usize) -> (usize, f64) {
    let mut config = usual();
    config.reconstruction.refinement = refinement;
    let processor = Processor::new(config.measurement()).unwrap();
    let (mut lost, mut worst) = (0, 0.0f64);
    for at_mm in drawn(0.01, [3.0, 2.6, 2.2]) {
        let truth = truth(&config, [(at_mm, 1.0)]);
        let pair = ImagePair { cameras: images_of(&config, &truth) };
        let (result, [volume, _]) = processor.process_with_volumes(&pair).unwrap();
        assert_eq!(Measured::of(result, &truth.flow).valid_share(), 0.0);
        match centroid_off_vox(&volume, truth.particles[0].a_mm) {
            None => lost += 1,
            Some(off) => worst = off.iter().fold(worst, |worst, c| worst.max(c.abs())),
        }
    }
    println!("lone particles at refinement {refinement}: {lost} lost, worst {worst:.3} voxels off");
    (lost, worst)
}

/// A particle alone in the volume is light in one window, and cannot confirm itself: it is
/// reconstructed where it is, and no vector is valid.
#[test]
fn a_single_particle_is_found_and_not_taken_for_a_flow() {
    for refinement in [1, 2, 4] {
        let (lost, worst) = lone_particles(refinement);
        assert_eq!(lost, 0, "refinement {refinement}");
        assert!(worst <= 0.5, "refinement {refinement}: {worst}");
    }
}

/// Particles in the outermost voxel of the volume only: windows without any are not valid, and those
/// at the faces measure what few they hold, a third of the usual number.
#[test]
fn particles_at_the_faces_only_are_measured_there() {
    let config = usual();
    let half = half_mm(&config);
    let shell = drawn(2.0, half.map(|h| 2.0 * h)).into_iter().filter(|at| {
        (0..3).all(|c| at[c].abs() < half[c]) && (0..3).any(|c| at[c].abs() > half[c] - 0.1)
    });
    let found = measured_truth(&config, &truth(&config, shell.map(|at| (at, 1.0))));
    found.print("particles at the faces only");
    let inside = |at: [f64; 3]| (0..3).all(|c| at[c].abs() + 0.6 < half[c] - 0.2);
    assert_eq!(found.valid_where(inside), 0.0);
    assert!(found.rms() <= 0.15, "{}", found.rms());
    assert!(found.false_share() <= 0.03, "{}", found.false_share());
}

/// Light from beyond the volume and its margin, seen by both cameras, is no measurement inside it.
#[test]
fn particles_outside_the_volume_give_no_vector() {
    let config = usual();
    let half = half_mm(&config);
    let beyond = drawn(1.0, [half[0] * 2.0, half[1] * 2.0, half[2] * 2.0])
        .into_iter()
        .map(|[x, y, z]| [x, y.signum() * (y.abs() * 0.25 + half[1] + 0.5), z]);
    let found = measured_truth(&config, &truth(&config, beyond.map(|at| (at, 1.0))));
    found.print("particles outside the volume only");
    assert_eq!(found.valid_share(), 0.0);
}

/// Twenty particles of a thousand times the light in one corner saturate their pixels. Each view is
/// a sharp picture: away from the cluster's own lines of sight the others are seen as ever. They
/// are measured as well as usual or, at worst, not valid; they are never false.
fn beside_a_bright_cluster() -> Measured {
    let config = usual();
    let shot = shot(&config, SEED);
    let cluster = (0..20).map(|n| {
        let n = f64::from(n);
        (
            [-1.3 + 0.011 * n, 1.1 - 0.3 * (0.618 * n).fract(), -0.9 + 0.3 * (0.414 * n).fract()],
            1000.0,
        )
    });
    let faint = shot.truth.particles.iter().map(|particle| (particle.mid_mm, 1.0));
    let found = measured_truth(&config, &truth(&config, faint.chain(cluster)));
    found.print("beside a cluster 1000 times as bright");
    found
}

/// Both cameras see the cluster at this x; windows further than their half edge from it are clear.
fn clear_of_the_cluster(at: [f64; 3]) -> bool {
    at[0] > 0.0
}

#[test]
fn a_bright_cluster_makes_no_vector_false() {
    let found = beside_a_bright_cluster();
    assert_eq!(found.false_share(), 0.0);
    assert!(found.result.field.status.contains(&VectorStatus::Valid));
}

#[test]
fn a_bright_cluster_does_not_blind_the_rest() {
    let found = beside_a_bright_cluster();
    let share = found.valid_where(clear_of_the_cluster);
    assert!(share >= 0.5, "{share}");
}
