//! One grey TIFF image.

use std::{
    fmt,
    fs::File,
    io::{self, BufReader, Seek, Write},
    path::Path,
};

use image::{
    DynamicImage, EncodableLayout, ImageBuffer, ImageError, ImageFormat, ImageReader, ImageResult,
    Luma, PixelWithColorType, Primitive,
    error::{ParameterError, ParameterErrorKind::DimensionMismatch},
};
use lfpiv_hw::{RawImage, Sensor};
use tiff::decoder::Decoder;

use super::{ArchiveError, durable::replace};

/// Pixel columns and rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ImageSize {
    /// Pixel columns.
    pub columns: usize,
    /// Pixel rows.
    pub rows: usize,
}

impl fmt::Display for ImageSize {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} x {}", self.columns, self.rows)
    }
}

impl From<&Sensor> for ImageSize {
    fn from(sensor: &Sensor) -> Self {
        Self { columns: sensor.columns, rows: sensor.rows }
    }
}

/// Size of an image in memory.
pub(super) fn size_of(image: &RawImage) -> ImageSize {
    ImageSize { columns: image.columns(), rows: image.rows() }
}

/// Bits per pixel in the file.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileDepth {
    /// Counts up to 255.
    Eight,
    /// Counts up to 65,535.
    Sixteen,
}

impl FileDepth {
    /// The smallest depth that holds a sensor's counts.
    pub fn for_sensor_bits(bits: u8) -> Self {
        if bits <= 8 { Self::Eight } else { Self::Sixteen }
    }
}

/// Reads an 8- or 16-bit grey TIFF; the counts are those in the file.
pub fn read_grey_tiff(path: &Path) -> Result<RawImage, ArchiveError> {
    let mut reader = ImageReader::open(path).map_err(ArchiveError::io("open the image", path))?;
    reader.set_format(ImageFormat::Tiff);
    let decoded = reader.decode().map_err(|source| describe_failure(path, source))?;
    let (columns, rows) = (decoded.width() as usize, decoded.height() as usize);
    if has_second_page(path) {
        let size = ImageSize { columns, rows };
        return Err(ArchiveError::SeveralPages { path: path.into(), size });
    }
    let counts = match decoded {
        DynamicImage::ImageLuma8(grey) => grey.iter().map(|count| u16::from(*count)).collect(),
        DynamicImage::ImageLuma16(grey) => grey.into_raw(),
        other => {
            let found = format!("colour or transparent ({:?})", other.color());
            return Err(ArchiveError::NotGrey { path: path.into(), found });
        }
    };
    RawImage::new(columns, rows, counts).map_err(|error| ArchiveError::UnreadableImage {
        path: path.into(),
        reason: ImageError::IoError(io::Error::other(error)),
    })
}

/// Whether a readable file has a second page as large as its first. Both frames of a pair in one
/// file would otherwise be read as the first frame twice: no motion. Thumbnails are no harm.
fn has_second_page(path: &Path) -> bool {
    let pages = || -> Option<bool> {
        let mut decoder = Decoder::new(BufReader::new(File::open(path).ok()?)).ok()?;
        let first = decoder.dimensions().ok()?;
        while decoder.more_images() {
            decoder.next_image().ok()?;
            if decoder.dimensions().ok()? == first {
                return Some(true);
            }
        }
        Some(false)
    };
    pages().unwrap_or(false)
}

/// Writes an uncompressed grey TIFF. Counts above what `depth` holds become its maximum.
pub fn write_grey_tiff(
    path: &Path,
    image: &RawImage,
    depth: FileDepth,
) -> Result<(), ArchiveError> {
    replace(path, |writer| {
        let encoded = match depth {
            FileDepth::Eight => encode::<u8>(
                image,
                image.counts().iter().map(|c| u8::try_from(*c).unwrap_or(u8::MAX)).collect(),
                writer,
            ),
            FileDepth::Sixteen => encode::<u16>(image, image.counts().to_vec(), writer),
        };
        encoded.map_err(io::Error::other)
    })
}

fn encode<T: Primitive>(
    image: &RawImage,
    counts: Vec<T>,
    writer: &mut (impl Write + Seek),
) -> ImageResult<()>
where
    Luma<T>: PixelWithColorType<Subpixel = T>,
    [T]: EncodableLayout,
{
    let too_large = || ImageError::Parameter(ParameterError::from_kind(DimensionMismatch));
    let columns = u32::try_from(image.columns()).map_err(|_| too_large())?;
    let rows = u32::try_from(image.rows()).map_err(|_| too_large())?;
    ImageBuffer::<Luma<T>, _>::from_raw(columns, rows, counts)
        .ok_or_else(too_large)?
        .write_to(writer, ImageFormat::Tiff)
}

fn describe_failure(path: &Path, source: ImageError) -> ArchiveError {
    let path = path.into();
    match source {
        ImageError::Unsupported(detail) => {
            ArchiveError::NotGrey { path, found: format!("of a kind not supported ({detail})") }
        }
        reason => ArchiveError::UnreadableImage { path, reason },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ramp() -> RawImage {
        RawImage::new(3, 2, vec![0, 1, 200, 255, 300, 65_535]).unwrap()
    }

    #[test]
    fn counts_survive_the_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("cam1_a.tif");
        write_grey_tiff(&path, &ramp(), FileDepth::Sixteen).unwrap();
        assert_eq!(read_grey_tiff(&path).unwrap(), ramp());
        write_grey_tiff(&path, &ramp(), FileDepth::Eight).unwrap();
        assert_eq!(read_grey_tiff(&path).unwrap().counts(), [0, 1, 200, 255, 255, 255]);
    }

    #[test]
    fn a_file_cut_at_any_tenth_is_an_error_that_names_it() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("cam1_a.tif");
        let image = RawImage::new(64, 64, (0..4096).collect()).unwrap();
        write_grey_tiff(&path, &image, FileDepth::Sixteen).unwrap();
        let whole = std::fs::read(&path).unwrap();
        for tenths in 0..10 {
            std::fs::write(&path, &whole[..whole.len() * tenths / 10]).unwrap();
            let message = read_grey_tiff(&path).unwrap_err().to_string();
            assert!(message.contains("cam1_a.tif"), "{message}");
            assert!(message.contains("truncated"), "{message}");
        }
    }

    #[test]
    fn two_frames_in_one_file_are_refused_but_not_a_thumbnail() {
        use tiff::encoder::{TiffEncoder, colortype::Gray16};
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("cam1_a.tif");
        let write_pages = |sizes: [u32; 2]| {
            let mut encoder = TiffEncoder::new(File::create(&path).unwrap()).unwrap();
            for size in sizes {
                let counts = vec![7_u16; (size * size) as usize];
                encoder.write_image::<Gray16>(size, size, &counts).unwrap();
            }
        };
        write_pages([8, 8]);
        let message = read_grey_tiff(&path).unwrap_err().to_string();
        assert!(message.contains("cam1_a.tif holds several pages of 8 x 8"), "{message}");
        write_pages([8, 2]);
        assert_eq!(read_grey_tiff(&path).unwrap().columns(), 8);
    }

    #[test]
    fn colour_transparency_and_floats_are_refused_by_name() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("cam2_b.tif");
        for image in [
            DynamicImage::new_rgb8(4, 4),
            DynamicImage::new_rgba16(4, 4),
            DynamicImage::new_rgb32f(4, 4),
        ] {
            image.save_with_format(&path, ImageFormat::Tiff).unwrap();
            let message = read_grey_tiff(&path).unwrap_err().to_string();
            assert!(message.contains("cam2_b.tif is colour"), "{message}");
            assert!(message.contains("save it as grey TIFF of 8 or 16 bit"), "{message}");
        }
    }
}
