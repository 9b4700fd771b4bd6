use rayon::ThreadPoolBuilder;

use super::*;
use crate::{
    flow::Uniform,
    imaging::{Distortion, Dust, SecondAperture, WallSettings},
    test_bench,
};

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
        // 120 particles of 100,000 electrons at unit gain; few rays miss this sensor.
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

/// A camera displaced by 0.03 mm along x sees the image that a nominal camera has of particles
/// displaced by −0.03 mm.
#[test]
fn a_displaced_camera_sees_the_world_moved_the_other_way() {
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
    // The sums differ in their last bit, which moves hardly any ray across a pixel's edge.
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

/// All deviations of a camera together.
fn flawed() -> CameraFlaws {
    CameraFlaws {
        turn_deg: [0.2, -0.1, 0.3],
        array_rotation_deg: 0.5,
        array_shift_mm: [0.01, -0.02],
        array_pitch_scale: [1.003, 0.999],
        distortion: Distortion { radial: 0.005, tangential: [0.001, -0.001] },
        exit_pupil_mm: 30.0,
        f_number_scale: 1.05,
        vignetting: Some(SecondAperture { radius_mm: 12.0, behind_lens_mm: -40.0 }),
        wall: Some(WallSettings { tilt_deg: [5.0, 0.0], ..WallSettings::default() }),
        dust: Dust { specks: 10, ..Dust::default() },
        dead_microlenses: 2,
        blemish_seed: 7,
        blur_px: 0.3,
        gain: 0.8,
    }
}

#[test]
fn imperfect_cameras_do_not_depend_on_the_threads() {
    let bench = test_bench::small();
    let scene = Scene { camera: vec![CameraFlaws::default(), flawed()], ..scene() };
    let white =
        |scene: &Scene, camera| scene.white_images(&bench, camera, 3, 2).collect::<Vec<_>>();
    let with_threads = |threads| {
        let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| (scene.shot(&bench, 3, 1), white(&scene, 1)))
    };
    let alone = with_threads(1);
    assert!(alone == with_threads(2));
    // Images of a camera without flaws do not change.
    let perfect = Scene { camera: Vec::new(), ..scene.clone() }.shot(&bench, 3, 1);
    assert!(alone.0.images[0] == perfect.images[0] && alone.0.images[1] != perfect.images[1]);
}

#[test]
fn a_cameras_gain_scales_counts_and_not_electrons() {
    let bench = test_bench::small();
    let gain = CameraFlaws { gain: 0.8, ..CameraFlaws::default() };
    let sensor = SensorSettings { read_noise_electrons: 0.0, ..SensorSettings::default() };
    let usual = Scene { sensor, ..scene() };
    let dimmer = Scene { camera: vec![gain], ..usual.clone() };
    let [expected, got] = [&usual, &dimmer].map(|scene| scene.shot(&bench, 1, 0).images);
    assert_eq!(expected[1], got[1]);
    // Shot noise is drawn before the gain.
    for (expected, got) in expected[0][0].counts().iter().zip(got[0][0].counts()) {
        let counts = 64.0 + 0.8 * (f64::from(*expected) - 64.0);
        assert!((f64::from(*got) - counts).abs() <= 0.5 || *expected == 4095);
    }
}

/// A white image fills 0.7 of the range, with different noise in each image. A dark image has black
/// level and read noise only.
#[test]
fn white_and_dark_images_are_exposed_as_pairs_are() {
    let bench = test_bench::small();
    let sensor = SensorSettings { background_electrons: 20.0, ..SensorSettings::default() };
    let scene = Scene { sensor, camera: vec![flawed()], rays_per_particle: 100, ..scene() };
    for camera in [0, 1] {
        let white: Vec<_> = scene.white_images(&bench, camera, 1, 2).collect();
        assert_ne!(white[0], white[1]);
        let light = scene.white_light(&bench, camera);
        let brightest = light.electrons().iter().copied().fold(0.0, f32::max);
        let gain = [0.8, 1.0][camera];
        let expected = 0.7 * (4095.0 - 64.0) / gain - 20.0;
        assert!((f64::from(brightest) / expected - 1.0).abs() < 1e-6, "{brightest}");
        let top = white[0].counts().iter().max().copied().unwrap_or(0);
        assert!((2700..3300).contains(&top), "{top}");
        let dark = scene.dark_images(&bench, camera, 1, 1).next().unwrap();
        let mean =
            dark.counts().iter().map(|&c| f64::from(c)).sum::<f64>() / dark.counts().len() as f64;
        assert!((mean - 64.0).abs() < 0.1, "{mean}");
    }
    assert_eq!(scene.white_light(&bench, 2).total(), 0.0);
    assert_eq!(scene.micro_image_grid(&bench, 2), None);
}

#[test]
fn impossible_positions_of_stops_and_walls_are_refused() {
    let bench = test_bench::small();
    let refused = |flaws: CameraFlaws| {
        let scene = Scene { camera: vec![CameraFlaws::default(), flaws], ..scene() };
        scene.check(&bench).unwrap_err().to_string()
    };
    let wall = |distance_mm, thickness_mm| CameraFlaws {
        wall: Some(WallSettings { distance_mm, thickness_mm, ..WallSettings::default() }),
        ..CameraFlaws::default()
    };
    let said = refused(CameraFlaws { exit_pupil_mm: 200.0, ..CameraFlaws::default() });
    assert!(said.contains("simulation.camera[1].exit_pupil_mm = 200: allowed"), "{said}");
    let vignetting = Some(SecondAperture { radius_mm: 10.0, behind_lens_mm: 250.0 });
    let said = refused(CameraFlaws { vignetting, ..CameraFlaws::default() });
    assert!(said.contains("camera[1].vignetting.behind_lens_mm = 250"), "{said}");
    // Among the particles; and so far away that the lens is in the water.
    for wall in [wall(0.3, 5.0), wall(300.0, 5.0)] {
        assert!(refused(wall).contains("simulation.camera[1].wall: allowed"));
    }
    let good = Scene { camera: vec![wall(30.0, 5.0)], ..scene() };
    assert!(good.check(&bench).is_ok());
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
    assert!(read("[[camera]]\nturn = 1.0").is_err());
    assert!(read("[[camera]]\nvignetting = { radius_mm = 9.0 }").is_err());
    let text =
        "[[camera]]\n[[camera]]\nturn_deg = [0.2, 0.0, 0.0]\nwall = { tilt_deg = [5.0, 0.0] }";
    let scene = read(text).unwrap();
    assert!(scene.validate().is_ok());
    assert_eq!(scene.camera[0], CameraFlaws::default());
    assert_eq!(scene.camera[1].wall.as_ref().unwrap().medium_index, 1.333);
    assert_eq!(read(&toml::to_string(&scene).unwrap()).unwrap(), scene);
    assert!(read("[lighting]\npulse_energies = [1.0, 1.0]").is_err());
    for bad in [
        "ppm = nan",
        "ppm = -1.0",
        "sheet_mm = [1.0, 0.0, 1.0]",
        "rays_per_particle = 0",
        "camera_shift_mm = [[0.0, 11.0, 0.0]]",
        "lighting = { pulse_energy = [1.0, -1.0] }",
        "lighting = { camera_spread = 2.0 }",
        "camera = [{ array_pitch_scale = [1.0, 3.0] }]",
        "camera = [{ wall = { medium_index = 0.9 } }]",
        "camera = [{ distortion = { radial = nan } }]",
    ] {
        let key = bad.split(' ').next().unwrap();
        assert!(read(bad).unwrap().validate().unwrap_err().to_string().contains(key), "{bad}");
    }
}

#[test]
fn truth_round_trips_through_toml() {
    let mut truth = scene().truth(&test_bench::small(), 1, 0);
    truth.particles.truncate(3);
    let text = toml::to_string(&truth).unwrap();
    assert_eq!(toml::from_str::<Truth>(&text).unwrap(), truth);
}
