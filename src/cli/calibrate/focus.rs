//! `lfpiv calibrate focus`: the position of the plane in focus, and the match of f-numbers.

use std::{
    fs,
    path::{Path, PathBuf},
    thread,
    time::{Duration, SystemTime},
};

use anyhow::bail;
use lfpiv_core::{
    calibration::{Focus, GridCalibration, WhiteImage, calibrate_grid, focus as focus_of},
    lightfield::MicroImageGrid,
};
use lfpiv_hw::{CameraName, Optics, RawImage};

use super::{live::LiveCamera, reference_images::read_images};
use crate::{
    archive::ImageSize,
    cli::output::{print, print_while_read},
    config::{CalibrationContent, ConfigFile, Purpose, read_calibration},
};

/// Interval at which watched files are checked.
const WATCH_INTERVAL: Duration = Duration::from_millis(300);

/// Largest distance from the plane in focus that counts as in focus, in mm.
const IN_FOCUS_MM: f64 = 0.1;

/// A larger share of pixels at the end of the range hides structure.
const MOST_SATURATED: f64 = 0.01;

/// Arguments of `lfpiv calibrate focus`.
#[derive(Debug, clap::Args)]
pub struct FocusArgs {
    /// Configuration of the bench: the nominal optics.
    #[arg(long, value_name = "FILE")]
    pub config: PathBuf,
    /// Images of a card, or of any structured object, across the camera's axis where the plane in
    /// focus should be; 8- or 16-bit grey TIFF.
    #[arg(long, value_name = "FILE", num_args = 1..)]
    pub image: Vec<PathBuf>,
    /// White images: they show whether f-numbers match, and locate the micro-images.
    #[arg(long, value_name = "FILE", num_args = 1..)]
    pub white: Vec<PathBuf>,
    /// Dark images; their mean is subtracted.
    #[arg(long, value_name = "FILE", num_args = 1..)]
    pub dark: Vec<PathBuf>,
    /// The camera's grid from `lfpiv calibrate grid`; the default is the grid of the white images,
    /// or the nominal one.
    #[arg(long, value_name = "FILE")]
    pub grid: Option<PathBuf>,
    /// Refractive index of the medium around the card.
    #[arg(long, value_name = "N", default_value_t = 1.0, value_parser = index)]
    pub medium_index: f64,
    /// Evaluate each file again whenever it is written, until Ctrl-C. A camera program that keeps
    /// writing one file thus gives a live display.
    #[arg(long)]
    pub watch: bool,
    /// Evaluate the images of a free-running camera of [instruments], until Ctrl-C. Laser and synchroniser are
    /// not used, and the camera's settings are restored at the end.
    #[arg(long, requires = "camera", conflicts_with_all = ["image", "watch"])]
    pub live: bool,
    /// The live camera: 1 for the first [[instruments.camera]] table.
    #[arg(long, value_name = "N", requires = "live", value_parser = clap::value_parser!(u8).range(1..))]
    pub camera: Option<u8>,
    /// Exposure time of the live camera in µs, 1 to 10,000,000; the default is the configured one.
    #[arg(long, value_name = "US", requires = "live", value_parser = exposure)]
    pub exposure_us: Option<f64>,
}

fn index(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(index) if (1.0..=3.0).contains(&index) => Ok(index),
        _ => Err("allowed: 1 to 3".into()),
    }
}

fn exposure(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(us) if (1.0..=1e7).contains(&us) => Ok(us),
        _ => Err("allowed: 1 to 10000000".into()),
    }
}

/// What is needed to evaluate an image.
struct Camera {
    optics: Optics,
    size: ImageSize,
    dark: Vec<RawImage>,
    grid: MicroImageGrid,
    white: Option<WhiteImage>,
    medium_index: f64,
}

/// Prints a line for the white images and one for each image.
pub fn focus(args: &FocusArgs) -> anyhow::Result<()> {
    if args.image.is_empty() && args.white.is_empty() && !args.live {
        bail!(
            "give --white for the match of f-numbers, --image or --live --camera N for the plane in focus, or \
             both; docs/calibration.md says how to take them"
        );
    }
    let config = ConfigFile::load_for(Purpose::Optics, &args.config)?.config;
    let device = match args.camera {
        Some(number) => {
            Some(LiveCamera::configured(&args.config, &config, number, args.exposure_us)?)
        }
        None => None,
    };
    let optics = config.optics;
    let size = ImageSize::from(&optics.sensor);
    let (dark, _) = read_images(&args.dark, Some(size))?;
    let white = match args.white.as_slice() {
        [] => None,
        files => Some(WhiteImage::average(&read_images(files, Some(size))?.0, &dark)?),
    };
    let found = white.as_ref().map(|white| calibrate_grid(white, Some(&optics))).transpose()?;
    if let Some(found) = &found {
        print(&format!("f-numbers: {}", found.f_number))?;
    }
    let grid = grid(args, &optics, found)?;
    let medium_index = args.medium_index;
    let camera = Camera { optics, size, dark, grid, white, medium_index };
    if let Some(device) = &device {
        return device.watch(|frame| {
            let line = camera.evaluate_images(std::slice::from_ref(&frame.image))?;
            print_while_read(&format!("{}, frame {}: {line}", device.name(), frame.frame_id))
        });
    }
    let mut seen: Vec<Option<SystemTime>> = vec![None; args.image.len()];
    loop {
        for (path, seen) in args.image.iter().zip(&mut seen) {
            let written = fs::metadata(path).and_then(|data| data.modified()).ok();
            if args.watch && (written.is_none() || written == *seen) {
                continue;
            }
            *seen = written;
            match camera.evaluate(path) {
                Ok(line) => {
                    if !print_while_read(&format!("{}: {line}", path.display()))? {
                        return Ok(());
                    }
                }
                // The file may be incomplete; it is read again when it has been written.
                Err(error) if args.watch => tracing::debug!("{}: {error:#}", path.display()),
                Err(error) => return Err(error),
            }
        }
        if !args.watch {
            return Ok(());
        }
        thread::sleep(WATCH_INTERVAL);
    }
}

/// The micro-image grid: from a file, from the white images, or nominal.
fn grid(
    args: &FocusArgs,
    optics: &Optics,
    found: Option<GridCalibration>,
) -> anyhow::Result<MicroImageGrid> {
    let Some(path) = &args.grid else {
        return Ok(found.map_or_else(|| MicroImageGrid::nominal(optics), |found| found.grid));
    };
    match read_calibration(path) {
        Ok((CalibrationContent::Grid(content), _)) => {
            let live = args.camera.map(|number| CameraName(usize::from(number) - 1).to_string());
            if let (Some(of_file), Some(live)) = (&content.camera, live)
                && *of_file != live
            {
                bail!("{}: it is the grid of {of_file}, not of {live}", path.display());
            }
            Ok(content.grid)
        }
        Ok(_) => {
            bail!("{}: the file is not a grid; `lfpiv calibrate grid` makes one", path.display())
        }
        Err(message) => bail!("{}: {message}", path.display()),
    }
}

impl Camera {
    fn evaluate(&self, path: &Path) -> anyhow::Result<String> {
        let (images, _) = read_images(&[path.to_owned()], Some(self.size))?;
        self.evaluate_images(&images)
    }

    /// Describes the focus of one image.
    fn evaluate_images(&self, images: &[RawImage]) -> anyhow::Result<String> {
        let image = WhiteImage::average(images, &self.dark)?;
        let found = match focus_of(&self.optics, &self.grid, &image, self.white.as_ref()) {
            Some(found) => describe(&found, self.medium_index),
            None => format!(
                "no depth is sharper than the others: place a card or print there (dots of {:.1} \
                 mm or more) and illuminate it",
                4.0 * self.optics.object_pitch_mm()
            ),
        };
        let saturated = image.saturated_share();
        Ok(match saturated > MOST_SATURATED {
            true => format!(
                "{found}; {:.1} % of the pixels are saturated: expose for less time",
                100.0 * saturated
            ),
            false => found,
        })
    }
}

fn describe(found: &Focus, medium_index: f64) -> String {
    let [columns, rows] = found.depth_mm.map(|mm| mm * medium_index);
    let depth_mm = (columns + rows) / 2.0;
    let side = if depth_mm > 0.0 { "nearer to the camera than" } else { "behind" };
    let todo = match depth_mm {
        near if near.abs() < IN_FOCUS_MM => "in focus".to_owned(),
        nearer if nearer > 0.0 => {
            format!(
                "move the camera back by {:.2} mm, or focus that much nearer",
                camera_shift_mm(found)
            )
        }
        _ => format!(
            "move the camera forward by {:.2} mm, or focus that much farther",
            camera_shift_mm(found)
        ),
    };
    format!(
        "{:.2} mm {side} the plane in focus (columns {columns:+.2}, rows {rows:+.2}; contrast \
         {:.1}): {todo}",
        depth_mm.abs(),
        found.contrast
    )
}

/// The distance by which the camera has to be moved, in air.
fn camera_shift_mm(found: &Focus) -> f64 {
    ((found.depth_mm[0] + found.depth_mm[1]) / 2.0).abs()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_description_says_how_to_move_the_camera() {
        let near = describe(&Focus { depth_mm: [1.4, 1.6], contrast: 3.0 }, 1.333);
        assert!(near.starts_with("2.00 mm nearer to the camera than"), "{near}");
        assert!(near.contains("move the camera back by 1.50 mm"), "{near}");
        let far = describe(&Focus { depth_mm: [-0.5, -0.5], contrast: 3.0 }, 1.0);
        assert!(
            far.contains("behind the plane in focus") && far.contains("forward by 0.50"),
            "{far}"
        );
        assert!(
            describe(&Focus { depth_mm: [0.02, 0.01], contrast: 3.0 }, 1.0).contains("in focus")
        );
    }
}
