//! Images that cannot be measured. Each gives a result marked invalid with a warning that gives the
//! reason, or an error; never a panic, a NaN or a field of zeros that looks measured. Also tests
//! unusual sensors, which must not reduce accuracy.
//!
//! Missing, truncated, empty and colour files are tested in `process.rs`, NaN in the configuration
//! in `configuration_numbers.rs`.

use std::fs;

use image::{DynamicImage, ImageBuffer, ImageFormat};
use lfpiv::config::Config;
use lfpiv_core::{
    lightfield::ImagePair,
    measurement::{ProcessError, Processor, SetupError},
    velocimetry::{PairResult, VectorStatus},
};
use lfpiv_hw::{CameraName, RawImage};
use lfpiv_sim::{Scene, SimulatedShot};

use crate::support::{mean_error_vox, process, simulate, small_bench, small_configuration};

const FULL_COUNTS: u16 = 4095;

/// A pair of the small bench with a changed scene.
fn shot(change: impl FnOnce(&mut Scene), seed: u64) -> SimulatedShot {
    shot_on(&small_bench(), change, seed)
}

fn shot_on(config: &Config, change: impl FnOnce(&mut Scene), seed: u64) -> SimulatedShot {
    let mut scene = config.simulation.clone().unwrap();
    change(&mut scene);
    scene.shot(&config.bench_geometry(), seed, 0)
}

fn usual_pair() -> ImagePair {
    ImagePair { cameras: shot(|_| (), 5).images }
}

/// A pair of the small bench whose images are uniform.
fn uniform_pair(count: u16) -> ImagePair {
    let sensor = small_bench().optics.sensor;
    let counts = vec![count; sensor.columns * sensor.rows];
    let image = RawImage::new(sensor.columns, sensor.rows, counts).unwrap();
    ImagePair { cameras: vec![[image.clone(), image.clone()], [image.clone(), image]] }
}

/// Measures a pair on the small bench and checks properties of every result.
fn measured(pair: &ImagePair) -> PairResult {
    measured_on(&small_bench(), pair)
}

fn measured_on(config: &Config, pair: &ImagePair) -> PairResult {
    let processor = Processor::new(config.measurement()).unwrap();
    let (result, volumes) = processor.process_with_volumes(pair).unwrap();
    for volume in &volumes {
        assert!(volume.intensity.iter().all(|e| e.is_finite() && *e >= 0.0));
    }
    let field = &result.field;
    assert_eq!(field.status.len(), field.grid.len());
    for vectors in [&field.displacement_vox, &field.vorticity] {
        assert!(vectors.iter().flatten().all(|value| value.is_finite()));
    }
    for scalars in [&field.peak_ratio, &field.divergence] {
        assert!(scalars.iter().all(|value| value.is_finite()));
    }
    for (value, status) in field.displacement_vox.iter().zip(&field.status) {
        assert_eq!(*value == [0.0; 3], *status == VectorStatus::Invalid, "{value:?} {status:?}");
    }
    result
}

/// Checks that every vector is invalid and that the warnings contain `expected`.
fn assert_invalid(name: &str, result: &PairResult, expected: &[&str]) {
    let field = &result.field;
    assert!(!field.grid.is_empty());
    assert!(field.status.iter().all(|s| *s == VectorStatus::Invalid), "{name}: {:?}", field.status);
    assert_eq!(field.valid_share(), 0.0);
    for text in expected {
        let said = result.warnings.iter().any(|warning| warning.contains(text));
        assert!(said, "{name}: nothing says {text:?}: {:?}", result.warnings);
    }
}

#[test]
fn all_zero_images_give_a_result_marked_invalid() {
    let expected = ["cam1, frame a: no particle above the noise", "cam2, frame b: no part"];
    assert_invalid("all zero", &measured(&uniform_pair(0)), &expected);
}

#[test]
fn all_saturated_images_give_a_result_marked_invalid() {
    let saturated = "100 % of the lit pixels are saturated at 4095 counts";
    let expected = [&format!("cam1, frame a: {saturated}"), "cam2, frame b: 100 %"];
    assert_invalid("all saturated", &measured(&uniform_pair(FULL_COUNTS)), &expected);
}

#[test]
fn partly_saturated_images_are_measured_with_a_warning_that_names_them() {
    // Camera 2 is ten times too bright in frame b.
    let bright = shot(|scene| scene.particle_photoelectrons *= 10.0, 5);
    let mut pair = usual_pair();
    pair.cameras[1][1] = bright.images[1][1].clone();
    let result = measured(&pair);
    let [warning] = result.warnings.as_slice() else { panic!("{:?}", result.warnings) };
    assert!(warning.starts_with("cam2, frame b: "), "{warning}");
    assert!(warning.contains("% of the lit pixels are saturated at 4095 counts"), "{warning}");
    assert!(result.field.valid_share() > 0.9, "{}", result.field.valid_share());
}

#[test]
fn one_dark_camera_is_named_and_its_pair_marked_invalid() {
    for dark in 0..2 {
        for with_noise in [false, true] {
            let mut pair = usual_pair();
            let unlit = if with_noise {
                ImagePair { cameras: shot(|scene| scene.ppm = 0.0, 6).images }
            } else {
                uniform_pair(64)
            };
            pair.cameras[dark] = unlit.cameras[dark].clone();
            let result = measured(&pair);
            let name = format!("cam{}, frame a: no particle", dark + 1);
            assert_invalid("one dark camera", &result, &[&name]);
            let other = format!("cam{}", 2 - dark);
            assert!(result.warnings.iter().all(|w| !w.contains(&other)), "{:?}", result.warnings);
        }
    }
}

#[test]
fn no_particles_but_noise_and_stray_light_give_a_result_marked_invalid() {
    let stray = |scene: &mut Scene, electrons: f64, offset: f64| {
        scene.ppm = 0.0;
        scene.sensor.background_electrons = electrons;
        scene.sensor.offset_counts = offset;
    };
    for (seed, electrons, offset) in [
        (1, 0.0, 64.0),
        (2, 0.0, 64.0),
        (3, 0.0, 0.0),
        (4, 3.0, 64.0),
        (5, 3.0, 0.0),
        (6, 200.0, 64.0),
    ] {
        let images = shot(|scene| stray(scene, electrons, offset), seed).images;
        let name = format!("seed {seed}, {electrons} electrons, offset {offset}");
        let result = measured(&ImagePair { cameras: images });
        assert_invalid(&name, &result, &["cam1, frame a: no particle above the noise"]);
    }
}

/// Light through the aperture leaves the corners of the micro-images dark, so its shot noise
/// differs from the noise of the black level.
#[test]
fn light_through_the_aperture_without_particles_gives_a_result_marked_invalid() {
    let dense = shot(
        |scene| {
            // So many faint particles that no pixel distinguishes them.
            scene.ppm = 20.0;
            scene.particle_photoelectrons = 50.0;
            scene.sheet_mm = Some([6.0, 6.0, 6.0]);
            scene.rays_per_particle = 64;
        },
        7,
    );
    let result = measured(&ImagePair { cameras: dense.images });
    assert_invalid("stray light", &result, &["cam1, frame a: no particle above the noise"]);
}

#[test]
fn a_volume_that_no_camera_sees_is_refused_with_the_cameras_name() {
    let refused = |centre_mm| {
        let mut measurement = small_bench().measurement();
        measurement.volume.centre_mm = centre_mm;
        let Err(SetupError::Model(error)) = Processor::new(measurement) else {
            panic!("a volume at {centre_mm:?} mm was accepted")
        };
        error.to_string()
    };
    // Along x both cameras lose the volume; along y only camera 1, along z only camera 2.
    for (centre_mm, camera) in [([30.0, 0.0, 0.0], 1), ([0.0, 20.0, 0.0], 1), ([0.0, 0.0, 20.0], 2)]
    {
        let message = refused(centre_mm);
        let expected = format!("cam{camera} does not see the volume");
        assert!(message.contains(&expected), "{centre_mm:?}: {message}");
    }
}

#[test]
fn images_of_the_wrong_size_or_number_are_errors() {
    let processor = Processor::new(small_bench().measurement()).unwrap();
    let mut wrong_size = uniform_pair(64);
    wrong_size.cameras[1][0] = RawImage::new(700, 748, vec![64; 700 * 748]).unwrap();
    let error = processor.process(&wrong_size).unwrap_err();
    assert!(matches!(
        error,
        ProcessError::ImageSize { camera: CameraName(1), frame: 'a', columns: 700, .. }
    ));
    assert!(error.to_string().contains("cam2, frame a: the image has 700 x 748"), "{error}");
    for cameras in [0, 1, 3] {
        let images = uniform_pair(64).cameras[0].clone();
        let pair = ImagePair { cameras: vec![images; cameras] };
        let error = processor.process(&pair).unwrap_err();
        assert_eq!(error, ProcessError::CameraCount { expected: 2, found: cameras });
    }
}

#[test]
fn the_command_stores_an_invalid_result_and_says_why() {
    let root = tempfile::tempdir().unwrap();
    assert!(simulate(&small_configuration(), root.path().join("pairs").as_path(), 1, 5).success);
    let folder = root.path().join("pairs/shot_0000");
    let sensor = small_bench().optics.sensor;
    let black =
        ImageBuffer::from_pixel(sensor.columns as u32, sensor.rows as u32, image::Luma([0]));
    let path = folder.join("cam2_a.tif");
    fs::remove_file(&path).unwrap();
    DynamicImage::ImageLuma16(black).save_with_format(path, ImageFormat::Tiff).unwrap();
    let out = root.path().join("out");
    let done = process(&out, &[folder]);
    assert!(done.success, "{}", done.stderr);
    assert!(done.stderr.contains("cam2, frame a: no particle above"), "{}", done.stderr);
    assert!(done.stdout.contains("0.0 % valid"), "{}", done.stdout);
    let file = netcdf::open(out.join("shot_0000/velocity.nc")).unwrap();
    let valid: Vec<i32> = file.variable("valid").unwrap().get_values(..).unwrap();
    assert!(!valid.is_empty() && valid.iter().all(|&flag| flag == 0));
    for name in ["u", "v", "w"] {
        let values: Vec<f64> = file.variable(name).unwrap().get_values(..).unwrap();
        assert!(values.iter().all(|value| value.is_nan()), "{name} is its fill value");
    }
}

#[test]
fn unusual_sensors_and_light_do_not_cost_accuracy() {
    let mut config = small_bench();
    config.volume.voxels = [32, 28, 24];
    config.velocimetry.window_mm = 1.2;
    let error = |name: &str, change: fn(&mut Scene)| {
        let shot = shot_on(&config, change, 9);
        let result = measured_on(&config, &ImagePair { cameras: shot.images });
        assert!(result.warnings.is_empty(), "{name}: {:?}", result.warnings);
        assert!(result.field.valid_share() > 0.9, "{name}: {}", result.field.valid_share());
        let error = mean_error_vox(&result.field, &shot.truth.flow);
        println!("{name}: mean |error| {:.4} {:.4} {:.4} voxels", error[0], error[1], error[2]);
        error.into_iter().fold(0.0, f64::max)
    };
    let plain = error("12 bits", |_| ());
    let eight_bits = error("8 bits without offset", |scene| {
        scene.sensor.bits = 8;
        scene.sensor.gain_counts_per_electron = 0.1;
        scene.sensor.offset_counts = 0.0;
    });
    let background = error("30 electrons of background", |scene| {
        scene.sensor.background_electrons = 30.0;
    });
    let diffraction = error("diffraction", |scene| scene.diffraction = true);
    for (name, error) in
        [("8 bits", eight_bits), ("background", background), ("diffraction", diffraction)]
    {
        assert!(error < (1.5 * plain).max(0.05) && error < 0.1, "{name}: {error}, plain {plain}");
    }
}
