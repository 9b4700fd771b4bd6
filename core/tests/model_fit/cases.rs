//! Right and wrong benches: how their images and configurations are made, and what a pair measured with
//! them must be told.

use lfpiv_core::{
    lightfield::ImagePair,
    measurement::{Measurement, Processor},
    reconstruction::{FitVerdict, ModelFit},
};
use lfpiv_hw::RawImage;

use crate::support::Bench;

/// What a case changes.
pub enum Change {
    /// The configuration that the images are measured with.
    Configuration(fn(&mut Bench)),
    /// The bench that the images are of.
    Bench(fn(&mut Bench)),
    /// The images of shot 0, with those of shot 1 at hand.
    Images(fn(&mut ImagePair, &ImagePair)),
}

/// A bench, and what is said of it.
pub struct Case {
    pub name: &'static str,
    pub change: Change,
    /// Words that one of the first three causes must have; `None` for a right bench, which must not be
    /// warned of.
    pub cause: Option<&'static str>,
}

const fn right(name: &'static str, change: fn(&mut ImagePair, &ImagePair)) -> Case {
    Case { name, change: Change::Images(change), cause: None }
}

const fn wrong(name: &'static str, change: Change, cause: &'static str) -> Case {
    Case { name, change, cause: Some(cause) }
}

pub const CASES: [Case; 14] = [
    right("as configured", |_, _| {}),
    right("half the light across the field", |pair, _| {
        each(pair, |image| scaled(image, |x| 1.0 - 0.5 * x));
    }),
    right("1 % saturated", |pair, _| each(pair, saturated)),
    right("frame b 20 % dimmer", |pair, _| {
        for [_, b] in &mut pair.cameras {
            *b = scaled(b, |_| 0.8);
        }
    }),
    right("800 hot pixels", |pair, _| each(pair, with_hot_pixels)),
    wrong(
        "camera 2 mirrored along the columns",
        Change::Images(|pair, _| {
            for image in &mut pair.cameras[1] {
                *image = rearranged(image, |c, r, columns, _| (columns - 1 - c, r));
            }
        }),
        "mirrored",
    ),
    wrong(
        "camera 2 mirrored along the rows",
        Change::Images(|pair, _| {
            for image in &mut pair.cameras[1] {
                *image = rearranged(image, |c, r, _, rows| (c, rows - 1 - r));
            }
        }),
        "mirrored",
    ),
    wrong(
        "camera 2 of another shot",
        Change::Images(|pair, other| pair.cameras[1] = other.cameras[1].clone()),
        "different shots",
    ),
    wrong(
        "frame b of another shot",
        Change::Images(|pair, other| {
            for (frames, other) in pair.cameras.iter_mut().zip(&other.cameras) {
                frames[1] = other[1].clone();
            }
        }),
        "frames a and b",
    ),
    wrong(
        "object distance 202 for 200 mm",
        Change::Configuration(|config| config.optics.object_distance_mm = 202.0),
        "object_distance_mm",
    ),
    wrong(
        "pitch 0.1005 for 0.1 mm",
        Change::Configuration(|config| config.optics.microlens.pitch_mm = 0.1005),
        "pitch_mm",
    ),
    wrong(
        "rows 96 for 97",
        Change::Configuration(|config| config.optics.microlens.rows = 96),
        "rows = 96",
    ),
    wrong(
        "camera 2 half a voxel beside its place",
        Change::Configuration(|config| config.camera[1].origin_mm.z += 0.05),
        "mm from its configured position",
    ),
    wrong(
        "camera 2 turned by one degree",
        Change::Bench(|config| {
            let camera = &mut config.camera[1];
            let (sin, cos) = 1f64.to_radians().sin_cos();
            let (right, axis) = (camera.right, camera.axis);
            camera.right = right * cos - axis * sin;
            camera.axis = axis * cos + right * sin;
        }),
        "cam2 is rotated",
    ),
];

/// A bench of the real sensor with particles at `ppm` in `voxels` of 0.1 mm.
pub fn bench(voxels: [usize; 3], ppm: f64) -> Bench {
    let mut config = Bench::shipped("bench");
    config.volume.voxels = voxels;
    config.simulation.as_mut().expect("a simulated bench").ppm = ppm;
    config
}

/// Shots 0 and 1 of a right bench.
pub fn shots(config: &Bench, seed: u64) -> [ImagePair; 2] {
    let scene = config.simulation.as_ref().expect("a simulated bench");
    let geometry = config.geometry();
    [0, 1].map(|shot| ImagePair { cameras: scene.shot(&geometry, seed, shot).images })
}

impl Case {
    /// What is said of the case made from `shots` of the right bench `config` by `seed`.
    pub fn fit(&self, config: &Bench, seed: u64, shots: &[ImagePair; 2]) -> (ModelFit, f64) {
        let (mut config, mut pair) = (config.clone(), shots[0].clone());
        match self.change {
            Change::Configuration(change) => change(&mut config),
            Change::Bench(change) => {
                let mut bench = config.clone();
                change(&mut bench);
                let scene = bench.simulation.as_ref().expect("a simulated bench");
                pair.cameras = scene.shot(&bench.geometry(), seed, 0).images;
            }
            Change::Images(change) => change(&mut pair, &shots[1]),
        }
        let measurement: Measurement = config.measurement();
        let result =
            Processor::new(measurement).expect("a bench").process(&pair).expect("a result");
        (result.fit.expect("made from images"), result.field.valid_share())
    }

    /// Whether what is said is right.
    pub fn is_met(&self, fit: &ModelFit) -> bool {
        match self.cause {
            None => fit.verdict == FitVerdict::Good,
            Some(cause) => {
                fit.verdict != FitVerdict::Good
                    && fit.causes.iter().take(3).any(|found| found.contains(cause))
            }
        }
    }
}

fn each(pair: &mut ImagePair, change: impl Fn(&RawImage) -> RawImage) {
    for image in pair.cameras.iter_mut().flatten() {
        *image = change(image);
    }
}

/// Black level of the simulated sensor.
const OFFSET: f64 = 64.0;

/// Highest count of the simulated sensor.
const HIGHEST: f64 = 4095.0;

fn image_of(like: &RawImage, count: impl Fn(usize, usize) -> u16) -> RawImage {
    let (columns, rows) = (like.columns(), like.rows());
    let counts = (0..rows).flat_map(|r| (0..columns).map(move |c| (c, r)));
    let counts = counts.map(|(c, r)| count(c, r)).collect();
    RawImage::new(columns, rows, counts).expect("as many counts as pixels")
}

/// Light times a factor that depends on the place along the columns, 0 to 1.
fn scaled(image: &RawImage, factor: impl Fn(f64) -> f64) -> RawImage {
    image_of(image, |c, r| {
        let light = f64::from(image.row(r)[c]) - OFFSET;
        let counts = light * factor(c as f64 / image.columns() as f64) + OFFSET;
        counts.round().clamp(0.0, HIGHEST) as u16
    })
}

/// So bright that one pixel in a hundred is saturated.
fn saturated(image: &RawImage) -> RawImage {
    let mut counts: Vec<u16> = (0..image.rows()).flat_map(|r| image.row(r).to_vec()).collect();
    let high = counts.len() * 99 / 100;
    let (_, &mut level, _) = counts.select_nth_unstable(high);
    let factor = (HIGHEST - OFFSET) / (f64::from(level) - OFFSET).max(1.0);
    scaled(image, |_| factor)
}

/// 800 pixels at the highest count, at places without a pattern that the optics have.
fn with_hot_pixels(image: &RawImage) -> RawImage {
    let pixels = image.columns() * image.rows();
    let hot: std::collections::HashSet<usize> =
        (0..800).map(|n| (n * 2_654_435_761 + 12_345) % pixels).collect();
    image_of(image, |c, r| {
        if hot.contains(&(r * image.columns() + c)) { HIGHEST as u16 } else { image.row(r)[c] }
    })
}

fn rearranged(
    image: &RawImage,
    from: impl Fn(usize, usize, usize, usize) -> (usize, usize),
) -> RawImage {
    image_of(image, |c, r| {
        let (c, r) = from(c, r, image.columns(), image.rows());
        image.row(r)[c]
    })
}
