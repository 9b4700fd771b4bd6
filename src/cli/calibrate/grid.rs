//! `lfpiv calibrate grid`: the centres of a camera's micro-images.

use std::{
    io::{self, Write},
    path::{Path, PathBuf},
};

use anyhow::{Context, bail};
use lfpiv_core::calibration::{
    GRID_STEPS, GridCalibration, LensState, WhiteImage, calibrate_grid_watched,
};
use lfpiv_hw::CameraName;

use super::{
    grid_file::{GridFile, Inputs},
    page,
    reference_images::{InputFile, read_images},
};
use crate::{
    archive::write_replacing,
    cli::output::{count, print, progress_bar},
    config::{ConfigFile, Purpose},
};

/// Arguments of `lfpiv calibrate grid`.
#[derive(Debug, clap::Args)]
pub struct GridArgs {
    /// White images: a uniform diffuser that fills the main lens' pupil; 8- or 16-bit grey TIFF.
    /// Several are averaged.
    #[arg(long, value_name = "FILE", required = true, num_args = 1..)]
    pub white: Vec<PathBuf>,
    /// Dark images, without light, of the same exposure time; their mean is subtracted.
    #[arg(long, value_name = "FILE", num_args = 1..)]
    pub dark: Vec<PathBuf>,
    /// Configuration of the bench: number of microlenses, and which of them is the first. Without
    /// it, lenses are counted from the first lit one.
    #[arg(long, value_name = "FILE", requires = "camera")]
    pub config: Option<PathBuf>,
    /// Number of the camera: 1 for the first [[camera]] table.
    #[arg(long, value_name = "N", requires = "config", value_parser = clap::value_parser!(u8).range(1..))]
    pub camera: Option<u8>,
    /// File for the grid (JSON). An HTML page with figures is written with the same name and the
    /// suffix .html.
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
}

/// Writes the grid and its page, and prints a summary. Warnings appear in all three.
pub fn grid(args: &GridArgs) -> anyhow::Result<()> {
    let page_path = args.out.with_extension("html");
    if page_path == args.out {
        bail!(
            "{}: the page gets this name; give the grid another one, such as grid.json",
            args.out.display()
        );
    }
    let config = configured(args)?;
    let optics = config.as_ref().map(|file| &file.config.optics);
    let size = optics.map(|optics| (&optics.sensor).into());
    let images = args.white.len() + args.dark.len();
    let bar = progress_bar(images + GRID_STEPS, "steps");
    let (white, white_files) = read_images(&args.white, size)?;
    let (dark, dark_files) = read_images(&args.dark, size)?;
    bar.set_position(images as u64);
    let image = WhiteImage::average(&white, &dark)?;
    let steps_done = |steps: usize| bar.set_position((images + steps) as u64);
    let found = calibrate_grid_watched(&image, optics, steps_done)
        .with_context(|| format!("no grid in {}", args.white[0].display()))?;
    bar.finish_and_clear();
    let inputs = Inputs {
        white: white_files,
        dark: dark_files,
        configuration: config
            .as_ref()
            .map(|file| InputFile::of_bytes(&file.path, file.text.as_bytes())),
    };
    let camera = args.camera.map(|number| CameraName(usize::from(number) - 1).to_string());
    let file = GridFile::new(camera, &found, inputs)?;
    write_replacing(&args.out, |writer| {
        serde_json::to_writer_pretty(&mut *writer, &file).map_err(io::Error::from)?;
        writeln!(writer)
    })?;
    let html = page::page(&image, &found, &file);
    write_replacing(&page_path, |writer| writer.write_all(html.as_bytes()))?;
    print_summary(args, &page_path, &found)
}

/// The configuration, after checking that it has the given camera.
fn configured(args: &GridArgs) -> anyhow::Result<Option<ConfigFile>> {
    let Some(path) = &args.config else { return Ok(None) };
    let file = ConfigFile::load_for(Purpose::Optics, path)?;
    let cameras = file.config.camera.len();
    if args.camera.is_some_and(|number| usize::from(number) > cameras) {
        bail!("{} has {}: give --camera 1 to {cameras}", path.display(), count(cameras, "camera"));
    }
    Ok(Some(file))
}

fn print_summary(args: &GridArgs, page: &Path, found: &GridCalibration) -> anyhow::Result<()> {
    let [columns, rows] = found.grid.microlenses;
    let [along_i, along_j] = found.grid.pitch_px();
    let [turned_i, turned_j] = found.grid.turned_deg();
    let array = format!("{:?}", found.array).to_lowercase();
    print(&format!(
        "{columns} x {rows} micro-images, {array}, pitch {along_i:.4} and {along_j:.4} px, turned \
         by {turned_i:.3} and {turned_j:.3} degrees"
    ))?;
    let [x, y] = found.heldout.rms_px;
    let agreement = found.agreement.map_or(String::new(), |agreement| {
        format!(
            "; two estimators agree to {:.3} px at 95 % of the lenses, {:.3} px at the worst",
            agreement.at_95_percent_px, agreement.worst_px
        )
    });
    print(&format!(
        "lenses left out of the fit: {x:.3} and {y:.3} px rms (columns, rows){agreement}"
    ))?;
    print(&format!(
        "{} valid, {} partly imaged, {} dark, {} disturbed; vignetting leaves at least {:.0} % of \
         one",
        found.count(LensState::Valid),
        found.count(LensState::PartlyImaged),
        found.count(LensState::Dark),
        found.count(LensState::Disturbed),
        100.0 * found.least_open_share()
    ))?;
    print(&found.f_number.to_string())?;
    for warning in &found.warnings {
        print(&format!("warning: {warning}"))?;
    }
    let warned = match found.warnings.len() {
        0 => String::new(),
        warnings => format!(", with {}", count(warnings, "warning")),
    };
    print(&format!("{} and {}{warned}", args.out.display(), page.display()))
}
