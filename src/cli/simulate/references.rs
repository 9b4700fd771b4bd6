//! Writes white and dark images of every camera, and the true micro-image grids.

use std::{
    fs, io,
    path::{Path, PathBuf},
};

use anyhow::Context;
use lfpiv_hw::{CameraName, RawImage};
use lfpiv_sim::{BenchGeometry, Scene, TrueMicroImageGrid};
use serde::Serialize;

use crate::archive::{FileDepth, write_grey_tiff, write_replacing};

/// Explanation of the numbers, written into the file.
const MEANING: &str = "the micro-image of microlens (i, j) is centred at column a0 + a1 i + a2 j \
                       and row b0 + b1 i + b2 j, with column_px = [a0, a1, a2] and row_px = [b0, \
                       b1, b2]; i runs along +right and j along +up of the array's own axes, from \
                       (0, 0) in its first corner; pixel centres are whole numbers from 0, rows \
                       count downwards; the centre is where the ray through the middle of aperture \
                       stop and microlens lands";

/// Content of `camK_grid_true.json`.
#[derive(Serialize)]
struct GridFile {
    camera: String,
    #[serde(flatten)]
    grid: TrueMicroImageGrid,
    meaning: &'static str,
}

/// The folders of white and dark images in `out`.
pub(super) fn folders(out: &Path) -> [PathBuf; 2] {
    ["white", "dark"].map(|name| out.join(name))
}

/// Writes `white/camK_NN.tif` with `white/camK_grid_true.json`, and `dark/camK_NN.tif`, in `out`.
pub(super) fn write(
    scene: &Scene,
    bench: &BenchGeometry,
    seed: u64,
    out: &Path,
    [white, dark]: [u64; 2],
) -> anyhow::Result<()> {
    let [white_folder, dark_folder] = folders(out);
    let depth = FileDepth::for_sensor_bits(scene.sensor.bits);
    for camera in 0..bench.poses.len() {
        if white > 0 {
            let images = scene.white_images(bench, camera, seed, white);
            write_images(&white_folder, camera, images, depth)?;
            write_grid(&white_folder, camera, scene.micro_image_grid(bench, camera))?;
        }
        if dark > 0 {
            let images = scene.dark_images(bench, camera, seed, dark);
            write_images(&dark_folder, camera, images, depth)?;
        }
    }
    Ok(())
}

/// The name `camK_NN.tif`.
pub(super) fn image_name(camera: usize, number: u64) -> String {
    format!("{}_{number:02}.tif", CameraName(camera))
}

fn write_images(
    folder: &Path,
    camera: usize,
    images: impl Iterator<Item = RawImage>,
    depth: FileDepth,
) -> anyhow::Result<()> {
    fs::create_dir_all(folder).with_context(|| format!("cannot create {}", folder.display()))?;
    for (number, image) in images.enumerate() {
        write_grey_tiff(&folder.join(image_name(camera, number as u64)), &image, depth)?;
    }
    Ok(())
}

fn write_grid(
    folder: &Path,
    camera: usize,
    grid: Option<TrueMicroImageGrid>,
) -> anyhow::Result<()> {
    let Some(grid) = grid else { return Ok(()) };
    let camera = CameraName(camera).to_string();
    let path = folder.join(format!("{camera}_grid_true.json"));
    let file = GridFile { camera, grid, meaning: MEANING };
    write_replacing(&path, |writer| {
        serde_json::to_writer_pretty(writer, &file).map_err(io::Error::from)
    })?;
    Ok(())
}
