//! Too little light, too much, or light that is not of particles.

use lfpiv_core::{
    lightfield::{Background, ImagePair},
    measurement::Processor,
    velocimetry::VectorStatus,
};
use lfpiv_hw::RawImage;

use super::bench::{
    Measured, SEED, measured, scene_of, shot, simulated, uniform, usual, usual_rms, with_scene,
};

/// An image with every count changed by its column and value.
fn changed(image: &RawImage, change: impl Fn(usize, u16) -> u16) -> RawImage {
    let (columns, rows) = (image.columns(), image.rows());
    let counts = image.counts().iter().enumerate().map(|(n, &c)| change(n % columns, c)).collect();
    RawImage::new(columns, rows, counts).unwrap()
}

/// 3 dB less light is half the photons. Were all error photon noise, and of this camera, it would grow
/// by √2.
#[test]
fn a_camera_3_db_dimmer_measures_as_well() {
    let (bright, base) = (shot(&usual(), SEED), usual_rms());
    let dim = shot(&with_scene(|scene| scene.particle_photoelectrons /= 2.0), SEED);
    for camera in 0..2 {
        let mut images = bright.images.clone();
        images[camera] = dim.images[camera].clone();
        let found = measured(&usual(), images, &bright.truth.flow);
        found.print(&format!("camera {} 3 dB dimmer", camera + 1));
        assert!(found.rms() <= 1.42 * base, "{}, usual {base}", found.rms());
        assert!(found.valid_share() >= 0.95);
        assert_eq!(found.false_share(), 0.0);
    }
}

/// A camera without light measures nothing. One whose sensor is covered on the left measures at x < 0
/// what it always did there (images are upside down) and at x > 0 nothing.
#[test]
fn a_half_dark_camera_measures_its_lit_half() {
    // Windows are 1.2 mm wide; their centres lie at x = -1, -0.4, 0.2 and 0.8 mm.
    let lit = |at: [f64; 3]| at[0] < -0.6;
    let dark = |at: [f64; 3]| at[0] > 0.6;
    let bright = shot(&usual(), SEED);
    let base = measured(&usual(), bright.images.clone(), &bright.truth.flow).rms_where(lit);
    let unlit = shot(&with_scene(|scene| scene.ppm = 0.0), SEED);
    for camera in 0..2 {
        let mut images = bright.images.clone();
        images[camera] = unlit.images[camera].clone();
        assert_eq!(measured(&usual(), images, &bright.truth.flow).valid_share(), 0.0);

        let mut images = bright.images.clone();
        for (image, dark) in images[camera].iter_mut().zip(&unlit.images[camera]) {
            let columns = image.columns();
            let counts = image.counts().iter().zip(dark.counts()).enumerate();
            let halved =
                counts.map(|(n, (&lit, &dark))| if n % columns < columns / 2 { dark } else { lit });
            *image = RawImage::new(columns, image.rows(), halved.collect()).unwrap();
        }
        let found = measured(&usual(), images, &bright.truth.flow);
        found.print(&format!("camera {} half dark", camera + 1));
        assert!(found.valid_where(lit) >= 0.9, "{}", found.valid_where(lit));
        assert!(found.rms_where(lit) <= 1.5 * base, "{}, usual {base}", found.rms_where(lit));
        assert_eq!(found.valid_where(dark), 0.0);
        assert_eq!(found.false_share(), 0.0);
    }
}

/// Thirty times the light saturates every particle. Its place is in the shape of its image, which is
/// flattened: twice the usual error, and the reader is told.
#[test]
fn saturation_costs_accuracy_and_is_said() {
    let found = simulated(&with_scene(|scene| scene.particle_photoelectrons *= 30.0), SEED);
    found.print("30 times the light");
    assert!(found.result.warnings.iter().any(|w| w.contains("saturated")));
    assert!(found.rms() <= 2.0 * usual_rms(), "{}, usual {}", found.rms(), usual_rms());
    assert!(found.valid_share() >= 0.9);
    assert_eq!(found.false_share(), 0.0);
}

/// Uniform light adds its shot noise, 14 electrons at 200, and nothing else.
#[test]
fn a_uniform_background_is_only_noise() {
    let found = simulated(&with_scene(|scene| scene.sensor.background_electrons = 200.0), SEED);
    found.print("200 electrons of background");
    assert!(found.rms() <= 1.5 * usual_rms(), "{}, usual {}", found.rms(), usual_rms());
    assert!(found.valid_share() >= 0.95);
    assert_eq!(found.false_share(), 0.0);
}

/// Pixel columns of three microlenses that see x = 0.75 mm, and the counts that a reflection adds.
const STRIPE: std::ops::Range<usize> = 210..265;
const STRIPE_COUNTS: u16 = 1000;

fn striped(image: &RawImage) -> RawImage {
    let lit =
        |column, count: u16| if STRIPE.contains(&column) { count + STRIPE_COUNTS } else { count };
    changed(image, |column, count| lit(column, count).min(4095))
}

/// A stripe that stands still in camera 1 is light from everywhere along its lines of sight; camera
/// 2 confirms it only where it sees a particle. Windows a window away from it measure as usual, and
/// none is falsely valid. With the stripe known, its shot noise is left.
#[test]
fn a_reflection_stripe_spoils_no_vector_beside_it() {
    let (mut lit, base) = (shot(&usual(), SEED), usual_rms());
    for image in &mut lit.images[0] {
        *image = striped(image);
    }
    let found = measured(&usual(), lit.images.clone(), &lit.truth.flow);
    found.print("a reflection stripe");
    let beside = |at: [f64; 3]| at[0] < 0.0;
    assert!(found.valid_where(beside) >= 0.9, "{}", found.valid_where(beside));
    assert!(found.rms_where(beside) <= 1.5 * base, "{}, usual {base}", found.rms_where(beside));
    assert!(found.false_share() <= 0.05, "{}", found.false_share());

    let mut config = usual();
    config.image.background = Background::Images;
    let mut empty = shot(&with_scene(|scene| scene.ppm = 0.0), SEED + 1).images;
    for image in &mut empty[0] {
        *image = striped(image);
    }
    let mut processor = Processor::new(config.measurement()).unwrap();
    processor.learn_background(&ImagePair { cameras: empty }).unwrap();
    let result = processor.process(&ImagePair { cameras: lit.images }).unwrap();
    let found = Measured::of(result, &lit.truth.flow);
    found.print("the stripe known from a background image");
    assert!(found.rms() <= 1.5 * base, "{}, usual {base}", found.rms());
    assert!(found.valid_share() >= 0.95, "{}", found.valid_share());
    assert_eq!(found.false_share(), 0.0);
}

/// The correlation does not know absolute intensities: frame b 30 % brighter or dimmer is the same
/// measurement with other noise.
#[test]
fn intensity_may_change_between_the_frames() {
    let (plain, base) = (shot(&usual(), SEED), usual_rms());
    for factor in [0.7, 1.3] {
        let other = shot(&with_scene(|scene| scene.particle_photoelectrons *= factor), SEED);
        let mut images = plain.images.clone();
        for (pair, other) in images.iter_mut().zip(other.images) {
            pair[1] = other[1].clone();
        }
        let found = measured(&usual(), images, &plain.truth.flow);
        found.print(&format!("frame b at {factor} of the light"));
        assert!(found.rms() <= 1.3 * base, "{}, usual {base}", found.rms());
        assert!(found.valid_share() >= 0.95);
        assert_eq!(found.false_share(), 0.0);
    }
}

/// The same image in both frames has not moved at all; the same count in every pixel shows nothing.
#[test]
fn equal_images_show_rest_or_nothing() {
    let mut lit = shot(&usual(), SEED);
    for pair in &mut lit.images {
        pair[1] = pair[0].clone();
    }
    let found = measured(&usual(), lit.images.clone(), &uniform([0.0; 3]));
    found.print("frame b a copy of frame a");
    assert!(found.rms() <= 1e-3, "{}", found.rms());
    assert!(found.valid_share() >= 0.95);

    let flat = |image: &RawImage| changed(image, |_, _| 1000);
    let flats = lit.images.iter().map(|pair| pair.each_ref().map(flat)).collect();
    let found = measured(&usual(), flats, &uniform([0.0; 3]));
    assert!(found.result.field.status.iter().all(|s| *s == VectorStatus::Invalid));
    assert!(!found.result.warnings.is_empty());
}

/// At 8 bits with 400 electrons to 40 counts the step of 10 electrons has 2.9 electrons of rounding
/// noise, less than the 5 of reading.
#[test]
fn eight_bits_are_enough() {
    let mut config = usual();
    let sensor = &mut scene_of(&mut config).sensor;
    (sensor.bits, sensor.gain_counts_per_electron, sensor.offset_counts) = (8, 0.1, 6.0);
    let found = simulated(&config, SEED);
    found.print("8 bits");
    assert!(found.rms() <= 1.3 * usual_rms(), "{}, usual {}", found.rms(), usual_rms());
    assert!(found.valid_share() >= 0.95);
    assert_eq!(found.false_share(), 0.0);
}
