use rayon::ThreadPoolBuilder;

use super::*;
use crate::{flow::Uniform, test_bench};

fn scene() -> Scene {
    Scene { rays_per_particle: 400, ..Scene::default() }
}

#[test]
fn one_thread_and_two_give_the_same_shot() {
    let bench = test_bench::small();
    let scene = Scene { diffraction: true, ..scene() };
    let with_threads = |threads| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| scene.shot(&bench, 3, 1))
    };
    let alone = with_threads(1);
    assert_eq!(alone, with_threads(2));
    assert_eq!(alone.truth.particles.len(), 120);
}

#[test]
fn seeds_and_shots_are_reproducible_and_distinct() {
    let bench = test_bench::small();
    let shot = |seed, shot| scene().shot(&bench, seed, shot).images;
    assert_eq!(shot(1, 0), shot(1, 0));
    assert_ne!(shot(1, 0), shot(1, 1));
    assert_ne!(shot(1, 0), shot(2, 0));
}

#[test]
fn every_camera_gives_two_images_of_the_sensor_with_light_in_them() {
    let bench = test_bench::small();
    let shot = scene().shot(&bench, 1, 0);
    assert_eq!(shot.images.len(), 2);
    for image in shot.images.iter().flatten() {
        assert_eq!((image.columns(), image.rows()), (384, 312));
        let sum: f64 = image.counts().iter().map(|&count| f64::from(count) - 64.0).sum();
        // 120 particles of 100,000 electrons of unit gain; few rays miss this sensor.
        assert!((0.9e7..1.3e7).contains(&sum), "{sum}");
    }
}

#[test]
fn a_particle_that_left_the_sheet_is_dark_in_the_second_frame() {
    let bench = test_bench::small();
    let carried = Flow::Uniform(Uniform { velocity_m_s: [4.0, 0.0, 0.0] });
    let scene = Scene { flow: carried, ..scene() };
    let mut truth = scene.truth(&bench, 1, 0);
    truth.particles.retain(|p| p.visible_a && !p.visible_b);
    assert!(!truth.particles.is_empty());
    assert!(truth.particles.iter().all(|p| p.b_mm[0] > 0.6));
    assert!(scene.light(&bench, &truth, 0, FrameOfPair::A).total() > 1e5);
    assert_eq!(scene.light(&bench, &truth, 0, FrameOfPair::B).total(), 0.0);
}

/// A camera that stands 0.03 mm further along x sees every particle as much further back: the image
/// of the particles moved by as much the other way, with the bench as drawn.
#[test]
fn a_camera_beside_its_pose_sees_the_world_moved_the_other_way() {
    let bench = test_bench::small();
    let shift_mm = 0.03;
    let shifted = Scene { camera_shift_mm: vec![[0.0; 3], [shift_mm, 0.0, 0.0]], ..scene() };
    let truth = scene().truth(&bench, 1, 0);
    let mut moved = truth.clone();
    for particle in &mut moved.particles {
        particle.a_mm[0] -= shift_mm;
    }
    let seen = |scene: &Scene, truth, camera| scene.light(&bench, truth, camera, FrameOfPair::A);
    assert_eq!(seen(&shifted, &truth, 0), seen(&scene(), &truth, 0));
    let (there, here) = (seen(&shifted, &truth, 1), seen(&scene(), &moved, 1));
    // The two sums differ in their last bit, which moves hardly a ray across a pixel's edge.
    let difference: f64 =
        there.electrons().iter().zip(here.electrons()).map(|(a, b)| f64::from((a - b).abs())).sum();
    assert!(difference < 1e-3 * here.total(), "{difference} of {}", here.total());
    assert_ne!(there, seen(&scene(), &truth, 1));
}

#[test]
fn the_second_pulse_and_the_second_camera_may_be_dimmer() {
    let bench = test_bench::small();
    let lighting =
        Lighting { pulse_energy: [1.0, 0.6], camera_light: vec![1.0, 0.5], ..Lighting::default() };
    let uneven = Scene { lighting, ..scene() };
    let truth = scene().truth(&bench, 1, 0);
    for (camera, frame, share) in
        [(0, FrameOfPair::A, 1.0), (0, FrameOfPair::B, 0.6), (1, FrameOfPair::B, 0.3)]
    {
        let total = |scene: &Scene| scene.light(&bench, &truth, camera, frame).total();
        let got = total(&uneven) / total(&scene());
        assert!((got - share).abs() < 1e-4, "{got} instead of {share}");
    }
}

#[test]
fn an_empty_scene_and_an_unknown_camera_are_dark() {
    let bench = test_bench::small();
    let empty = Scene { ppm: 0.0, sensor: SensorSettings::default().noise_free(), ..scene() };
    let shot = empty.shot(&bench, 1, 0);
    assert!(shot.images.iter().flatten().all(|image| image.counts().iter().all(|&c| c == 64)));
    assert_eq!(scene().light(&bench, &shot.truth, 5, FrameOfPair::A).total(), 0.0);
}

#[test]
fn too_many_particles_are_refused_in_advance() {
    let bench = test_bench::small();
    assert!(scene().check(&bench).is_ok());
    let flooded = Scene { ppm: 20.0, sheet_mm: Some([100.0; 3]), ..scene() };
    let text = flooded.check(&bench).unwrap_err().to_string();
    assert!(text.contains("allowed: at most 10000000"), "{text}");
}

#[test]
fn the_table_has_defaults_and_refuses_unknown_keys_and_bad_values() {
    let read = |text: &str| toml::from_str::<Scene>(text);
    assert_eq!(read("").unwrap(), Scene::default());
    assert!(Scene::default().validate().is_ok());
    let text = "ppm = 0.3\nplacement = 'on-grid'\nsheet_mm = [12.0, 12.0, 4.0]\n\
                [flow]\nkind = 'abc'\nwavelength_mm = 10.0\namplitude_m_s = 1.0\n\
                [sensor]\nbits = 8\nshot_noise = false";
    let scene = read(text).unwrap();
    assert!(scene.validate().is_ok());
    assert_eq!(scene.placement, Placement::OnGrid);
    assert_eq!(scene.sensor.bits, 8);
    assert!(read("ppn = 1.0").is_err());
    assert!(read("[sensor]\nbit = 8").is_err());
    assert!(read("[lighting]\npulse_energies = [1.0, 1.0]").is_err());
    for bad in [
        "ppm = nan",
        "ppm = -1.0",
        "sheet_mm = [1.0, 0.0, 1.0]",
        "rays_per_particle = 0",
        "camera_shift_mm = [[0.0, 11.0, 0.0]]",
        "lighting = { pulse_energy = [1.0, -1.0] }",
        "lighting = { camera_spread = 2.0 }",
    ] {
        let key = bad.split(' ').next().unwrap();
        assert!(read(bad).unwrap().validate().unwrap_err().to_string().contains(key), "{bad}");
    }
}

#[test]
fn truth_survives_being_written_and_read() {
    let mut truth = scene().truth(&test_bench::small(), 1, 0);
    truth.particles.truncate(3);
    let text = toml::to_string(&truth).unwrap();
    assert_eq!(toml::from_str::<Truth>(&text).unwrap(), truth);
}
