//! The questions of `lfpiv init` and their defaults.

use std::{collections::BTreeMap, fmt::Display, str::FromStr};

use anyhow::{Context, anyhow, bail};

/// One question. Its default may depend on earlier answers.
pub(super) struct Question {
    pub key: &'static str,
    pub text: &'static str,
    pub default: fn(&Answers) -> anyhow::Result<String>,
    /// Checks an answer.
    pub check: fn(&str) -> anyhow::Result<()>,
}

/// The answers by key.
#[derive(Debug, Default, Clone, PartialEq)]
pub(super) struct Answers(BTreeMap<&'static str, String>);

impl Answers {
    pub fn set(&mut self, key: &'static str, answer: String) {
        self.0.insert(key, answer);
    }

    pub fn text(&self, key: &str) -> &str {
        self.0.get(key).map_or("", String::as_str)
    }

    pub fn number(&self, key: &str) -> anyhow::Result<f64> {
        parsed(self.text(key)).with_context(|| format!("{key} = {:?}", self.text(key)))
    }

    pub fn numbers<const N: usize>(&self, key: &str) -> anyhow::Result<[f64; N]> {
        several(self.text(key))
    }

    /// Image distance of the thin lens, in mm.
    pub fn image_distance_mm(&self) -> anyhow::Result<f64> {
        let (f, s) = (self.number("focal_length_mm")?, self.number("object_distance_mm")?);
        if s <= f {
            bail!("the plane in focus, at {s} mm, must be beyond the focal length of {f} mm");
        }
        Ok(f * s / (s - f))
    }

    pub fn magnification(&self) -> anyhow::Result<f64> {
        Ok(self.image_distance_mm()? / self.number("object_distance_mm")?)
    }

    /// Working f-number at the microlenses.
    pub fn working_f_number(&self) -> anyhow::Result<f64> {
        let (f, n) = (self.number("focal_length_mm")?, self.number("f_number")?);
        Ok(n * self.image_distance_mm()? / f)
    }

    /// Number of microlenses along `pixels` of the sensor.
    fn microlenses_on(&self, pixels: &str) -> anyhow::Result<f64> {
        let spread = 1.0 + self.number("microlens_focal_length_mm")? / self.image_distance_mm()?;
        let pitch_um = 1e3 * self.number("microlens_pitch_mm")? * spread;
        Ok((self.number(pixels)? * self.number("pixel_pitch_um")? / pitch_um).floor())
    }

    /// Field of view in the plane in focus, along columns and rows, in mm.
    pub fn field_of_view_mm(&self) -> anyhow::Result<[f64; 2]> {
        let pitch_mm = self.number("microlens_pitch_mm")? / self.magnification()?;
        let along = |key: &str| Ok::<_, anyhow::Error>(self.number(key)? * pitch_mm);
        Ok([along("microlens_columns")?, along("microlens_rows")?])
    }
}

fn parsed<T: FromStr<Err: Display>>(text: &str) -> anyhow::Result<T> {
    text.trim().parse().map_err(|error| anyhow!("{text:?} is not a number: {error}"))
}

fn several<const N: usize>(text: &str) -> anyhow::Result<[f64; N]> {
    let numbers: Vec<f64> = text
        .split(|c: char| c.is_whitespace() || c == ',')
        .filter(|word| !word.is_empty())
        .map(parsed)
        .collect::<anyhow::Result<_>>()?;
    numbers.try_into().map_err(|_| anyhow!("give {N} numbers"))
}

fn positive(text: &str) -> anyhow::Result<()> {
    match parsed::<f64>(text)? {
        number if number > 0.0 && number.is_finite() => Ok(()),
        number => bail!("{number} is not greater than 0"),
    }
}

fn whole(text: &str) -> anyhow::Result<()> {
    match parsed::<u32>(text)? {
        0 => bail!("at least 1"),
        _ => Ok(()),
    }
}

/// Accepts every answer.
fn anything(_: &str) -> anyhow::Result<()> {
    Ok(())
}

/// Rounds to so many decimals, as a person would write.
pub(super) fn rounded(number: f64, digits: usize) -> f64 {
    let scale = 10f64.powi(digits as i32);
    (number * scale).round() / scale
}

/// All questions, in the order in which they are asked.
pub(super) fn questions() -> Vec<Question> {
    macro_rules! ask {
        ($key:literal, $text:literal, $check:expr, $default:expr) => {
            Question { key: $key, text: $text, default: $default, check: $check }
        };
    }
    vec![
        ask!("cameras", "Cameras: 1 or 2", one_or_two, |_| Ok("2".into())),
        ask!("focal_length_mm", "Main lens: focal length in mm", positive, |_| Ok("100.0".into())),
        ask!("f_number", "Main lens: f-number", positive, |_| Ok("4.0".into())),
        ask!(
            "object_distance_mm",
            "Distance from the main lens to the plane in focus in mm",
            positive,
            |a| Ok(decimal(2.0 * a.number("focal_length_mm")?))
        ),
        ask!("sensor_columns", "Sensor: columns in pixels", whole, |_| Ok("2352".into())),
        ask!("sensor_rows", "Sensor: rows in pixels", whole, |_| Ok("1768".into())),
        ask!("pixel_pitch_um", "Sensor: pixel pitch in um", positive, |_| Ok("5.5".into())),
        ask!("bits", "Sensor: significant bits of a pixel", whole, |_| Ok("12".into())),
        ask!("microlens_pitch_mm", "Microlenses: pitch in mm", positive, |_| Ok("0.1".into())),
        ask!(
            "microlens_focal_length_mm",
            "Microlenses: focal length in mm (the default matches the main lens' f-number)",
            positive,
            |a| Ok(decimal(rounded(a.number("microlens_pitch_mm")? * a.working_f_number()?, 4)))
        ),
        ask!("microlens_columns", "Microlenses: columns (as many as fit)", whole, |a| Ok(a
            .microlenses_on("sensor_columns")?
            .to_string())),
        ask!("microlens_rows", "Microlenses: rows (as many as fit)", whole, |a| Ok(a
            .microlenses_on("sensor_rows")?
            .to_string())),
        ask!(
            "second_camera",
            "Camera 2: looks along y, along x, or at an angle in degrees from camera 1 in the x-z \
             plane",
            direction,
            |_| Ok("y".into())
        ),
        ask!("volume_mm", "Volume: sizes along x, y, z in mm", sizes, |a| {
            // Three quarters of the field of view leave room for the margins.
            let [x, y] = a.field_of_view_mm()?.map(|view| rounded(0.75 * view, 1));
            let across = if a.text("second_camera") == "y" { y } else { x.min(y) };
            Ok(format!("{x} {y} {across}"))
        }),
        ask!("fastest_m_s", "Fastest velocity to expect in m/s", positive, |_| Ok("2.0".into())),
        ask!(
            "dt_us",
            "Time between the pulses in us (default: the fastest particles move 4 voxels)",
            positive,
            |a| {
                let voxel_mm = voxel_mm(a)?;
                Ok(decimal(rounded(4.0 * voxel_mm * 1e3 / a.number("fastest_m_s")?, 1)))
            }
        ),
        ask!("rate_hz", "Shots per second", positive, |_| Ok("10.0".into())),
        ask!("ppm", "Seeding: particles per microlens", positive, |_| Ok("0.5".into())),
        ask!(
            "addresses",
            "IP addresses of the cameras, separated by spaces (empty: a simulated bench)",
            anything,
            |_| Ok(String::new())
        ),
        ask!("serial_port", "Serial port of the synchroniser (real bench only)", anything, |a| Ok(
            if a.text("addresses").is_empty() {
                String::new()
            } else {
                "/dev/serial/by-id/...".into()
            }
        )),
    ]
}

/// Edge of a voxel: one microlens pitch in object space, in mm.
pub(super) fn voxel_mm(answers: &Answers) -> anyhow::Result<f64> {
    Ok(rounded(answers.number("microlens_pitch_mm")? / answers.magnification()?, 3))
}

/// A number formatted as a TOML float.
pub(super) fn decimal(number: f64) -> String {
    format!("{number:?}")
}

fn one_or_two(text: &str) -> anyhow::Result<()> {
    match text.trim() {
        "1" | "2" => Ok(()),
        other => bail!("{other:?} is neither 1 nor 2"),
    }
}

fn direction(text: &str) -> anyhow::Result<()> {
    match text.trim() {
        "x" | "y" => Ok(()),
        angle => match parsed::<f64>(angle)? {
            degrees if degrees.abs() > 0.0 && degrees.abs() < 180.0 => Ok(()),
            degrees => bail!("{degrees} degrees: give x, y or an angle between 0 and 180"),
        },
    }
}

fn sizes(text: &str) -> anyhow::Result<()> {
    let sizes = several::<3>(text)?;
    if sizes.iter().all(|size| *size > 0.0) {
        Ok(())
    } else {
        bail!("every size must be greater than 0")
    }
}
