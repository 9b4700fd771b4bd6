//! `lfpiv calibrate volume`: calibrates the cameras' maps of the volume.

use std::{
    io::{self, Write},
    path::{Path, PathBuf},
};

use anyhow::{Context, bail};
use lfpiv_core::{
    calibration::{CardLight, VolumeCalibration, VolumeInput, WhiteImage, calibrate_volume},
    lightfield::MicroImageGrid,
};
use lfpiv_hw::{CameraName, card::CalibrationCard};

use super::{
    reference_images::{InputFile, read_images},
    volume_file::{Inputs, VolumeFile},
    volume_page,
};
use crate::{
    archive::{ImageSize, write_replacing},
    cli::{
        card_file::read_card,
        output::{count, print, progress_bar},
    },
    config::{CalibrationContent, Config, ConfigFile, Purpose, read_calibration},
};

/// The maps are valid up to this distance beyond the reconstructed volume and its margin, in mm.
const BEYOND_MM: f64 = 0.5;

/// Arguments of `lfpiv calibrate volume`.
#[derive(Debug, clap::Args)]
pub struct VolumeArgs {
    /// Card file (TOML): the card, the walls, the white and dark images of each camera, and the
    /// images of the card at each position. config/card.toml explains the keys.
    #[arg(long, value_name = "FILE")]
    pub card: PathBuf,
    /// Configuration of the bench: nominal optics, poses and volume.
    #[arg(long, value_name = "FILE")]
    pub config: PathBuf,
    /// The grids of all cameras, in the cameras' order, from `lfpiv calibrate grid`.
    #[arg(long, value_name = "FILE", required = true, num_args = 1..)]
    pub grid: Vec<PathBuf>,
    /// File for the calibration of all cameras (JSON). An HTML page with figures is written with
    /// the same name and the suffix .html.
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// Standard deviation of the card's stated positions along each axis, in µm; unless it is 0,
    /// the positions are fitted as well.
    #[arg(long, value_name = "UM", default_value_t = 0.0, value_parser = micrometres)]
    pub stage_uncertainty_um: f64,
    /// Serial numbers of the cameras, in their order; default: those of [instruments].
    #[arg(long, value_name = "SERIAL", num_args = 1..)]
    pub serial: Vec<String>,
}

fn micrometres(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(um) if (0.0..=1000.0).contains(&um) => Ok(um),
        _ => Err("allowed: 0 to 1000".into()),
    }
}

/// All input images.
struct Images {
    white: Vec<WhiteImage>,
    dark: Vec<Vec<lfpiv_hw::RawImage>>,
    inputs: Inputs,
}

/// Writes the calibration and its page, and prints a summary. Warnings appear in all three.
pub fn volume(args: &VolumeArgs) -> anyhow::Result<()> {
    let page_path = args.out.with_extension("html");
    if page_path == args.out {
        bail!(
            "{}: the page gets this name; give the calibration another one, such as \
             calibration.json",
            args.out.display()
        );
    }
    let file = ConfigFile::load_for(Purpose::Optics, &args.config)?;
    let config = &file.config;
    let card = read_card(&args.card)?;
    if !args.serial.is_empty() && args.serial.len() != config.camera.len() {
        bail!("--serial: give one for each of the {}", count(config.camera.len(), "camera"));
    }
    let grids = read_grids(args, config)?;
    let images = read_references(args, &file, &card)?;
    let (lights, images) = read_card_images(args, config, &card, &grids, images)?;
    let poses = config.poses();
    let input = VolumeInput {
        optics: &config.optics,
        poses: &poses,
        card: &card,
        light: &lights,
        stage_deviation_mm: args.stage_uncertainty_um * 1e-3,
        box_mm: box_mm(config),
    };
    let bar = progress_bar(input.steps(), "steps");
    let found = calibrate_volume(&input, || bar.inc(1))
        .with_context(|| format!("no calibration from {}", args.card.display()))?;
    bar.finish_and_clear();
    let written = VolumeFile::new(config, &args.serial, &card, &grids, &found, images.inputs)?;
    write_replacing(&args.out, |writer| {
        serde_json::to_writer_pretty(&mut *writer, &written).map_err(io::Error::from)?;
        writeln!(writer)
    })?;
    let html = volume_page::page(&lights, &found, &written);
    write_replacing(&page_path, |writer| writer.write_all(html.as_bytes()))?;
    print_summary(args, &page_path, &found)
}

/// Centre and half edges of the box in which the maps are valid: the volume, its margin, and
/// [`BEYOND_MM`].
fn box_mm(config: &Config) -> [[f64; 3]; 2] {
    let volume = &config.volume.grid();
    let margin = config.velocimetry.margin_vox() as f64;
    let half = |voxels: usize| (voxels as f64 / 2.0 + margin) * volume.voxel_mm + BEYOND_MM;
    [volume.centre_mm, volume.voxels.map(half)]
}

/// The cameras' grids, in the cameras' order.
fn read_grids(args: &VolumeArgs, config: &Config) -> anyhow::Result<Vec<MicroImageGrid>> {
    let cameras = config.camera.len();
    if args.grid.len() != cameras {
        bail!(
            "--grid: {} given, but {} has {}: give one grid per camera, in the cameras' order",
            count(args.grid.len(), "file"),
            args.config.display(),
            count(cameras, "camera")
        );
    }
    let lenses = [config.optics.microlens.columns, config.optics.microlens.rows];
    let mut grids = Vec::new();
    for (camera, path) in args.grid.iter().enumerate() {
        let name = CameraName(camera).to_string();
        let content = match read_calibration(path) {
            Ok((CalibrationContent::Grid(content), _)) => content,
            Ok(_) => bail!(
                "{}: the file is not a grid; `lfpiv calibrate grid` makes one",
                path.display()
            ),
            Err(message) => bail!("{}: {message}", path.display()),
        };
        if let Some(other) = content.camera.filter(|camera| *camera != name) {
            bail!("{}: it is the grid of {other}, but is given for {name}", path.display());
        }
        let grid = content.grid;
        if !grid.is_square() {
            bail!(
                "{}: its array is hexagonal, but volumes can be reconstructed from square arrays \
                 only, so there is nothing to calibrate a volume for",
                path.display()
            );
        }
        if grid.microlenses != lenses {
            bail!(
                "{}: it has {} x {} microlenses, but [optics.microlens] has {} x {}: calibrate the \
                 grid with --config {} --camera {}",
                path.display(),
                grid.microlenses[0],
                grid.microlenses[1],
                lenses[0],
                lenses[1],
                args.config.display(),
                camera + 1
            );
        }
        grids.push(grid);
    }
    Ok(grids)
}

fn relative_to(card_file: &Path, names: &[String]) -> Vec<PathBuf> {
    let folder = card_file.parent().unwrap_or(Path::new(""));
    names.iter().map(|name| folder.join(name)).collect()
}

/// White and dark images of each camera, and the descriptions of all input files.
fn read_references(
    args: &VolumeArgs,
    file: &ConfigFile,
    card: &CalibrationCard,
) -> anyhow::Result<Images> {
    let cameras = file.config.camera.len();
    if card.reference.len() != cameras {
        bail!(
            "{}: {} given, but {} needed: list the white images of each camera, as for its grid",
            args.card.display(),
            count(card.reference.len(), "[[reference]] table"),
            cameras
        );
    }
    let size = Some(ImageSize::from(&file.config.optics.sensor));
    let describe = |path: &Path| {
        let content =
            std::fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
        anyhow::Ok(InputFile::of_bytes(path, &content))
    };
    let mut inputs = Inputs {
        card: describe(&args.card)?,
        configuration: InputFile::of_bytes(&args.config, file.text.as_bytes()),
        grids: args.grid.iter().map(|path| describe(path)).collect::<Result<_, _>>()?,
        images: Vec::new(),
    };
    let (mut white, mut dark) = (Vec::new(), Vec::new());
    for reference in &card.reference {
        let (whites, white_files) = read_images(&relative_to(&args.card, &reference.white), size)?;
        let (darks, dark_files) = read_images(&relative_to(&args.card, &reference.dark), size)?;
        white.push(WhiteImage::average(&whites, &darks)?);
        dark.push(darks);
        inputs.images.extend(white_files.into_iter().chain(dark_files));
    }
    Ok(Images { white, dark, inputs })
}

/// The card's images as light per view, by position and camera.
fn read_card_images<'a>(
    args: &VolumeArgs,
    config: &'a Config,
    card: &CalibrationCard,
    grids: &'a [MicroImageGrid],
    mut images: Images,
) -> anyhow::Result<(Vec<Vec<CardLight<'a>>>, Images)> {
    let size = Some(ImageSize::from(&config.optics.sensor));
    let mut lights = Vec::new();
    let bar = progress_bar(card.position.len(), "card positions");
    for (number, position) in card.position.iter().enumerate() {
        if position.images.len() != grids.len() {
            bail!(
                "{}: position {} has {}, but {} needed: `images` lists one per camera",
                args.card.display(),
                number + 1,
                count(position.images.len(), "image"),
                grids.len()
            );
        }
        let (taken, files) = read_images(&relative_to(&args.card, &position.images), size)?;
        images.inputs.images.extend(files);
        let mut position_lights = Vec::new();
        for (camera, (image, grid)) in taken.into_iter().zip(grids).enumerate() {
            let image = WhiteImage::average(&[image], &images.dark[camera])?;
            position_lights.push(CardLight::new(
                &config.optics,
                grid,
                &images.white[camera],
                &image,
            ));
        }
        lights.push(position_lights);
        bar.inc(1);
    }
    bar.finish_and_clear();
    Ok((lights, images))
}

fn print_summary(args: &VolumeArgs, page: &Path, found: &VolumeCalibration) -> anyhow::Result<()> {
    for (camera, calibrated) in found.cameras.iter().enumerate() {
        print(&format!(
            "{}: {}, residual {:.4} microlens rms; its map follows the rays to {:.2} um \
             across and {:.1} um in depth",
            CameraName(camera),
            count(calibrated.marks.len(), "mark"),
            calibrated.rms_microlenses,
            calibrated.map_residual.lateral_mm * 1e3,
            calibrated.map_residual.depth_mm * 1e3
        ))?;
    }
    let held_out = &found.held_out;
    print(&format!(
        "{} at positions left out of the fit: {:.4} microlens rms (mean over the views), {:.4} in \
         a single view; condition number {:.1e}",
        count(held_out.marks, "mark"),
        held_out.mean_microlenses,
        held_out.view_microlenses,
        found.condition_number
    ))?;
    for warning in &found.warnings {
        print(&format!("warning: {warning}"))?;
    }
    let warned = match found.warnings.len() {
        0 => String::new(),
        warnings => format!(", with {}", count(warnings, "warning")),
    };
    print(&format!(
        "{} and {}{warned}; enter the first in each [[camera]] table: calibration = \"{}\"",
        args.out.display(),
        page.display(),
        args.out.display()
    ))
}
