//! A recorded or imported image pair: one folder, one file per camera and frame.

use std::{
    fs,
    path::{Path, PathBuf},
};

use lfpiv_core::lightfield::ImagePair;
use lfpiv_hw::{CameraName, RawImage};
use rayon::prelude::*;

use super::{ArchiveError, FileDepth, ImageSize, read_grey_tiff, write_grey_tiff};

/// File names of frames a and b of camera `index` (from 0): `cam1_a.tif`, `cam1_b.tif`.
pub fn image_names(index: usize) -> [String; 2] {
    ["a", "b"].map(|frame| format!("{}_{frame}.tif", CameraName(index)))
}

/// Reads the images of the first `cameras` cameras from a pair folder.
///
/// Every image must have `size` pixels. Images are read in parallel. Images of further cameras in
/// the folder are ignored. Names may also end in `.tiff` or be in capitals.
pub fn read_pair(
    folder: &Path,
    cameras: usize,
    size: ImageSize,
) -> Result<ImagePair, ArchiveError> {
    let read = |name: String| read_image(folder, &name, cameras, size);
    let read_frames = |index: usize| {
        let [a, b] = image_names(index);
        rayon::join(|| read(a), || read(b))
    };
    // All images are read before an error is reported, so the error is always that of the first
    // file.
    let read: Vec<_> = (0..cameras).into_par_iter().map(read_frames).collect();
    let cameras = read.into_iter().map(|(a, b)| Ok([a?, b?])).collect::<Result<_, _>>()?;
    Ok(ImagePair { cameras })
}

fn read_image(
    folder: &Path,
    name: &str,
    cameras: usize,
    size: ImageSize,
) -> Result<RawImage, ArchiveError> {
    let path = match files_of(folder, name).as_slice() {
        [] => {
            return Err(ArchiveError::MissingImage {
                path: folder.join(name),
                cameras: if cameras == 1 {
                    "1 camera".into()
                } else {
                    format!("{cameras} cameras")
                },
                needed: (0..cameras).flat_map(image_names).collect::<Vec<_>>().join(", "),
            });
        }
        [path] => path.clone(),
        [first, second, ..] => {
            let [first, second] = [first, second].map(|path| path.to_owned());
            return Err(ArchiveError::TwoImages { first, second });
        }
    };
    read_grey_tiff(&path, size)
}

/// The files that match a name such as `cam1_a.tif`, sorted: in lower or upper case, with `.tif` or
/// `.tiff`.
fn files_of(folder: &Path, name: &str) -> Vec<PathBuf> {
    let matches = |path: &PathBuf| {
        let found = path.file_name().map(|found| found.to_string_lossy().to_ascii_lowercase());
        found.is_some_and(|found| found == name || found == format!("{name}f"))
    };
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    let mut files: Vec<PathBuf> = entries.map(|entry| entry.path()).filter(matches).collect();
    files.sort();
    files
}

/// Writes a pair folder; creates it if necessary.
pub fn write_pair(folder: &Path, pair: &ImagePair, depth: FileDepth) -> Result<(), ArchiveError> {
    super::durable::create_folder(folder)?;
    for (index, frames) in pair.cameras.iter().enumerate() {
        for (name, image) in image_names(index).iter().zip(frames) {
            write_grey_tiff(&folder.join(name), image, depth)?;
        }
    }
    Ok(())
}

/// The pair folders in `folder`: `folder` itself if it contains images of a pair, otherwise its
/// direct subfolders that do, sorted by name.
///
/// A folder with only some images counts: [`read_pair`] reports the missing ones.
pub fn find_pair_folders(folder: &Path) -> Result<Vec<PathBuf>, ArchiveError> {
    if holds_images(folder) {
        return Ok(vec![folder.into()]);
    }
    let entries = fs::read_dir(folder).map_err(ArchiveError::io("list the folder", folder))?;
    let mut found = Vec::new();
    for entry in entries {
        let path = entry.map_err(ArchiveError::io("list the folder", folder))?.path();
        if path.is_dir() && holds_images(&path) {
            found.push(path);
        }
    }
    if found.is_empty() {
        return Err(ArchiveError::NoPair { path: folder.into() });
    }
    found.sort();
    Ok(found)
}

fn holds_images(folder: &Path) -> bool {
    (0..2).flat_map(image_names).any(|name| !files_of(folder, &name).is_empty())
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: ImageSize = ImageSize { columns: 4, rows: 3 };

    fn pair(cameras: usize) -> ImagePair {
        let image = |level: u16| RawImage::new(4, 3, vec![level; 12]).unwrap();
        let cameras = (0..cameras as u16).map(|c| [image(10 * c), image(10 * c + 1)]).collect();
        ImagePair { cameras }
    }

    fn failure(folder: &Path, cameras: usize) -> String {
        read_pair(folder, cameras, SIZE).unwrap_err().to_string()
    }

    #[test]
    fn cameras_and_frames_keep_their_order() {
        let root = tempfile::tempdir().unwrap();
        write_pair(root.path(), &pair(2), FileDepth::Eight).unwrap();
        let read = read_pair(root.path(), 2, SIZE).unwrap();
        assert_eq!(read.cameras, pair(2).cameras);
        assert_eq!(read_pair(root.path(), 1, SIZE).unwrap().cameras, pair(1).cameras);
    }

    #[test]
    fn a_missing_image_is_named_with_all_that_are_needed() {
        let root = tempfile::tempdir().unwrap();
        write_pair(root.path(), &pair(1), FileDepth::Sixteen).unwrap();
        let message = failure(root.path(), 2);
        assert!(message.contains("cam2_a.tif is missing"), "{message}");
        assert!(message.contains("cam1_a.tif, cam1_b.tif, cam2_a.tif, cam2_b.tif"), "{message}");
    }

    #[test]
    fn image_names_may_have_capitals_and_a_long_suffix() {
        let root = tempfile::tempdir().unwrap();
        write_pair(root.path(), &pair(2), FileDepth::Eight).unwrap();
        let names = ["cam1_a.tiff", "cam1_b.TIF", "CAM2_A.TIFF", "cam2_b.tif"];
        for (from, to) in (0..2).flat_map(image_names).zip(names) {
            fs::rename(root.path().join(from), root.path().join(to)).unwrap();
        }
        assert_eq!(read_pair(root.path(), 2, SIZE).unwrap().cameras, pair(2).cameras);
        assert_eq!(find_pair_folders(root.path()).unwrap(), [root.path()]);
        // Two files match one image.
        fs::copy(root.path().join("cam1_a.tiff"), root.path().join("cam1_a.tif")).unwrap();
        let message = failure(root.path(), 2);
        assert!(message.contains("cam1_a.tif ") && message.contains("cam1_a.tiff"), "{message}");
    }

    #[test]
    fn one_image_of_another_size_is_named_with_both_sizes() {
        let root = tempfile::tempdir().unwrap();
        write_pair(root.path(), &pair(2), FileDepth::Sixteen).unwrap();
        let odd = RawImage::new(5, 3, vec![0; 15]).unwrap();
        write_grey_tiff(&root.path().join("cam2_a.tif"), &odd, FileDepth::Sixteen).unwrap();
        let message = failure(root.path(), 2);
        assert!(message.contains("cam2_a.tif has 5 x 3 pixels"), "{message}");
        assert!(message.contains("sensor has 4 x 3"), "{message}");
    }

    #[test]
    fn pair_folders_are_the_folder_itself_or_its_subfolders() {
        let root = tempfile::tempdir().unwrap();
        assert!(find_pair_folders(root.path()).unwrap_err().to_string().contains("cam1_a.tif"));
        for name in ["shot_0001", "shot_0000"] {
            write_pair(&root.path().join(name), &pair(1), FileDepth::Eight).unwrap();
        }
        fs::create_dir(root.path().join("notes")).unwrap();
        let found = find_pair_folders(root.path()).unwrap();
        let names: Vec<_> = found.iter().map(|p| p.file_name().unwrap()).collect();
        assert_eq!(names, ["shot_0000", "shot_0001"]);
        assert_eq!(find_pair_folders(&found[0]).unwrap(), found[..1]);
        let absent = find_pair_folders(&root.path().join("absent")).unwrap_err().to_string();
        assert!(absent.contains("absent"), "{absent}");
    }
}
