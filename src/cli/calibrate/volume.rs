//! `lfpiv calibrate volume`: how the cameras see the volume.

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
        output::{count, print},
    },
    config::{CalibrationContent, Config, ConfigFile, Purpose, read_calibration},
};

/// Beyond the volume and the margin that is reconstructed, the maps hold for so much, in mm.
const BEYOND_MM: f64 = 0.5;

/// Arguments of `lfpiv calibrate volume`.
#[derive(Debug, clap::Args)]
pub struct VolumeArgs {
    /// Card file (TOML): the card, the walls, the white and dark images of each camera, and the images
    /// of the card at each position. config/card.toml explains the keys.
    #[arg(long, value_name = "FILE")]
    pub card: PathBuf,
    /// Configuration of the bench: optics, poses and volume as drawn.
    #[arg(long, value_name = "FILE")]
    pub config: PathBuf,
    /// The grids of all cameras, in their order, from `lfpiv calibrate grid`.
    #[arg(long, value_name = "FILE", required = true, num_args = 1..)]
    pub grid: Vec<PathBuf>,
    /// The file for the calibration of all cameras (JSON); a page with pictures goes beside it, as .html.
    #[arg(long, value_name = "FILE")]
    pub out: PathBuf,
    /// How far the card may have been from each told place, standard deviation along each axis in µm:
    /// the places are then found, too.
    #[arg(long, value_name = "UM", default_value_t = 0.0, value_parser = micrometres)]
    pub stage_uncertainty_um: f64,
    /// Serial numbers of the cameras, in their order; those of [instruments] when absent.
    #[arg(long, value_name = "SERIAL", num_args = 1..)]
    pub serial: Vec<String>,
}

fn micrometres(text: &str) -> Result<f64, String> {
    match text.parse() {
        Ok(um) if (0.0..=1000.0).contains(&um) => Ok(um),
        _ => Err("allowed: 0 to 1000".into()),
    }
}

/// Everything that is read before anything is fitted.
struct Images {
    white: Vec<WhiteImage>,
    dark: Vec<Vec<lfpiv_hw::RawImage>>,
    inputs: Inputs,
}

/// Writes the calibration and its page, and prints what was found. Doubts are part of all three.
pub fn volume(args: &VolumeArgs) -> anyhow::Result<()> {
    let page_path = args.out.with_extension("html");
    if page_path == args.out {
        bail!(
            "{}: the page has this name; give the calibration another, as calibration.json",
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
    let found = calibrate_volume(&input)
        .with_context(|| format!("no calibration from {}", args.card.display()))?;
    let written = VolumeFile::new(config, &args.serial, &card, &grids, &found, images.inputs)?;
    write_replacing(&args.out, |writer| {
        serde_json::to_writer_pretty(&mut *writer, &written).map_err(io::Error::from)?;
        writeln!(writer)
    })?;
    let html = volume_page::page(&lights, &found, &written);
    write_replacing(&page_path, |writer| writer.write_all(html.as_bytes()))?;
    tell(args, &page_path, &found)
}

/// Middle and half the edges of the box that the maps hold in: the volume, the margin that is
/// reconstructed with it, and some more.
fn box_mm(config: &Config) -> [[f64; 3]; 2] {
    let volume = &config.volume;
    let margin = (config.velocimetry.max_displacement_vox / 2.0).ceil() + 1.0;
    let half = |voxels: usize| (voxels as f64 / 2.0 + margin) * volume.voxel_mm + BEYOND_MM;
    [volume.centre_mm, volume.voxels.map(half)]
}

/// The cameras' grids, in their order.
fn read_grids(args: &VolumeArgs, config: &Config) -> anyhow::Result<Vec<MicroImageGrid>> {
    let cameras = config.camera.len();
    if args.grid.len() != cameras {
        bail!(
            "--grid: {} given, {} has {}: give the grid of each, in their order",
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
            Ok(_) => bail!("{}: it is no grid; `lfpiv calibrate grid` makes one", path.display()),
            Err(message) => bail!("{}: {message}", path.display()),
        };
        if let Some(other) = content.camera.filter(|camera| *camera != name) {
            bail!("{}: it is the grid of {other}, and stands in {name}'s place", path.display());
        }
        let grid = content.grid;
        if !grid.is_square() {
            bail!(
                "{}: its array is hexagonal; volumes are reconstructed from square arrays only, so there is \
                 nothing to calibrate a volume for",
                path.display()
            );
        }
        if grid.microlenses != lenses {
            bail!(
                "{}: it has {} x {} microlenses, [optics.microlens] {} x {}: calibrate the grid with \
                 --config {} --camera {}",
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

fn beside(card_file: &Path, names: &[String]) -> Vec<PathBuf> {
    let folder = card_file.parent().unwrap_or(Path::new(""));
    names.iter().map(|name| folder.join(name)).collect()
}

/// White and dark images of each camera.
fn read_references(
    args: &VolumeArgs,
    file: &ConfigFile,
    card: &CalibrationCard,
) -> anyhow::Result<Images> {
    let cameras = file.config.camera.len();
    if card.reference.len() != cameras {
        bail!(
            "{}: {} given, {} needed: white images of each camera, as for its grid",
            args.card.display(),
            count(card.reference.len(), "[[reference]] table"),
            cameras
        );
    }
    let size = Some(ImageSize::from(&file.config.optics.sensor));
    let of_path = |path: &Path| {
        let content =
            std::fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
        anyhow::Ok(InputFile::of_bytes(path, &content))
    };
    let mut inputs = Inputs {
        card: of_path(&args.card)?,
        configuration: InputFile::of_bytes(&args.config, file.text.as_bytes()),
        grids: args.grid.iter().map(|path| of_path(path)).collect::<Result<_, _>>()?,
        images: Vec::new(),
    };
    let (mut white, mut dark) = (Vec::new(), Vec::new());
    for reference in &card.reference {
        let (whites, white_files) = read_images(&beside(&args.card, &reference.white), size)?;
        let (darks, dark_files) = read_images(&beside(&args.card, &reference.dark), size)?;
        white.push(WhiteImage::average(&whites, &darks)?);
        dark.push(darks);
        inputs.images.extend(white_files.into_iter().chain(dark_files));
    }
    Ok(Images { white, dark, inputs })
}

/// The card's light by position and camera.
fn read_card_images<'a>(
    args: &VolumeArgs,
    config: &'a Config,
    card: &CalibrationCard,
    grids: &'a [MicroImageGrid],
    mut images: Images,
) -> anyhow::Result<(Vec<Vec<CardLight<'a>>>, Images)> {
    let size = Some(ImageSize::from(&config.optics.sensor));
    let mut lights = Vec::new();
    for (number, position) in card.position.iter().enumerate() {
        if position.images.len() != grids.len() {
            bail!(
                "{}: position {} has {}, {} needed: `images` lists one of each camera",
                args.card.display(),
                number + 1,
                count(position.images.len(), "image"),
                grids.len()
            );
        }
        let (taken, files) = read_images(&beside(&args.card, &position.images), size)?;
        images.inputs.images.extend(files);
        let mut of_position = Vec::new();
        for (camera, (image, grid)) in taken.into_iter().zip(grids).enumerate() {
            let image = WhiteImage::average(&[image], &images.dark[camera])?;
            of_position.push(CardLight::new(&config.optics, grid, &images.white[camera], &image));
        }
        lights.push(of_position);
    }
    Ok((lights, images))
}

fn tell(args: &VolumeArgs, page: &Path, found: &VolumeCalibration) -> anyhow::Result<()> {
    for (camera, of_camera) in found.cameras.iter().enumerate() {
        print(&format!(
            "{}: {}, {:.4} microlens rms beside the fitted camera; its map follows the rays to {:.2} um \
             across and {:.1} um in depth",
            CameraName(camera),
            count(of_camera.marks.len(), "mark"),
            of_camera.rms_microlenses,
            of_camera.map_residual.lateral_mm * 1e3,
            of_camera.map_residual.depth_mm * 1e3
        ))?;
    }
    let held_out = &found.held_out;
    print(&format!(
        "{} of positions left out of the fit: {:.4} microlens rms (mean over the views), {:.4} in a \
         single view; condition number {:.1e}",
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
        "{} and {}{warned}; name the first in each [[camera]] table: calibration = \"{}\"",
        args.out.display(),
        page.display(),
        args.out.display()
    ))
}
