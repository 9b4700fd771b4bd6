//! Reads and writes grey TIFF images.

use std::{
    fmt,
    io::{self, BufRead, BufReader, Read, Seek, Write},
    path::Path,
};

use image::{
    EncodableLayout, ImageBuffer, ImageError, ImageFormat, ImageResult, Luma, PixelWithColorType,
    Primitive,
    error::{ParameterError, ParameterErrorKind::DimensionMismatch},
};
use lfpiv_hw::{RawImage, Sensor};
use lfpiv_rawlog::regular_file::open_regular;
use tiff::{
    ColorType, TiffError, TiffResult,
    decoder::{ChunkType, Decoder, DecodingResult},
};

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

/// Tile edges are multiples of this (TIFF 6.0, section 15).
const TILE_STEP: u32 = 16;

/// Reads an 8- or 16-bit grey TIFF of `size` pixels; counts are returned as stored.
///
/// The header is checked before any pixels are decoded.
///
/// # Errors
/// The file cannot be opened, is damaged, is not a grey TIFF or has another size.
pub fn read_grey_tiff(path: &Path, size: ImageSize) -> Result<RawImage, ArchiveError> {
    read(path, Some(size))
}

/// Reads an 8- or 16-bit grey TIFF of any size.
///
/// # Errors
/// The file cannot be opened, is damaged or is not a grey TIFF.
pub fn read_grey_tiff_of_any_size(path: &Path) -> Result<RawImage, ArchiveError> {
    read(path, None)
}

fn read(path: &Path, expected: Option<ImageSize>) -> Result<RawImage, ArchiveError> {
    let file = open_regular(path).map_err(ArchiveError::io("open the image", path))?;
    let mut reader = BufReader::new(file);
    if let Some(found) = other_format(&mut reader) {
        return Err(ArchiveError::NotGrey { path: path.into(), found });
    }
    let failure = |source| describe_failure(path, source);
    let mut decoder = Decoder::new(reader).map_err(failure)?;
    let size = check(&mut decoder, path, expected)?;
    let decoded = decoder.read_image().map_err(failure)?;
    if has_second_page(&mut decoder) {
        return Err(ArchiveError::SeveralPages { path: path.into(), size });
    }
    let counts = match decoded {
        DecodingResult::U8(counts) => counts.into_iter().map(u16::from).collect(),
        DecodingResult::U16(counts) => counts,
        _ => {
            let found = "of signed or floating-point numbers".into();
            return Err(ArchiveError::NotGrey { path: path.into(), found });
        }
    };
    RawImage::new(size.columns, size.rows, counts).map_err(|error| ArchiveError::UnreadableImage {
        path: path.into(),
        reason: error.to_string(),
    })
}

/// What the file is by its first bytes, if that is an image of another format.
fn other_format(reader: &mut impl BufRead) -> Option<String> {
    let format = image::guess_format(reader.fill_buf().ok()?).ok()?;
    let name = format.extensions_str().first()?.to_uppercase();
    (format != ImageFormat::Tiff).then(|| format!("a {name} image"))
}

/// Checks pixel type, tiles and size, and returns the size.
fn check<R: Read + Seek>(
    decoder: &mut Decoder<R>,
    path: &Path,
    expected: Option<ImageSize>,
) -> Result<ImageSize, ArchiveError> {
    let failure = |source| describe_failure(path, source);
    let not_grey = |found: String| Err(ArchiveError::NotGrey { path: path.into(), found });
    match decoder.colortype().map_err(failure)? {
        ColorType::Gray(8 | 16) => {}
        ColorType::Gray(bits) => return not_grey(format!("grey of {bits} bit")),
        other => return not_grey(format!("colour or transparent ({other:?})")),
    }
    let (width, height) = decoder.chunk_dimensions();
    if matches!(decoder.get_chunk_type(), ChunkType::Tile)
        && [width, height].iter().any(|edge| edge % TILE_STEP != 0)
    {
        let reason = format!(
            "it has tiles of {width} x {height} pixels, which are not multiples of {TILE_STEP}"
        );
        return Err(ArchiveError::UnreadableImage { path: path.into(), reason });
    }
    let (columns, rows) = decoder.dimensions().map_err(failure)?;
    let found = ImageSize { columns: columns as usize, rows: rows as usize };
    match expected {
        Some(expected) if found != expected => {
            Err(ArchiveError::WrongSize { path: path.into(), found, expected })
        }
        _ => Ok(found),
    }
}

/// Whether a second page has the size of the first. If both frames of a pair were in one file, the
/// first would be read twice and no motion would be measured. Thumbnails are allowed.
fn has_second_page<R: Read + Seek>(decoder: &mut Decoder<R>) -> bool {
    let mut pages = || -> TiffResult<bool> {
        let first = decoder.dimensions()?;
        while decoder.more_images() {
            decoder.next_image()?;
            if decoder.dimensions()? == first {
                return Ok(true);
            }
        }
        Ok(false)
    };
    pages().unwrap_or(false)
}

/// Writes an uncompressed grey TIFF. Counts above the maximum of `depth` are clipped.
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

fn describe_failure(path: &Path, source: TiffError) -> ArchiveError {
    let path = path.into();
    match source {
        TiffError::UnsupportedError(detail) => {
            ArchiveError::NotGrey { path, found: format!("of a kind not supported ({detail})") }
        }
        damage => ArchiveError::UnreadableImage { path, reason: damage.to_string() },
    }
}

#[cfg(test)]
mod tests {
    use std::fs::{self, File};

    use image::DynamicImage;
    use tiff::{
        encoder::{TiffEncoder, colortype::Gray16},
        tags::Tag,
    };

    use super::*;

    const RAMP: ImageSize = ImageSize { columns: 3, rows: 2 };

    /// The error message on reading a file as an image of `size`.
    fn refusal(path: &Path, [columns, rows]: [usize; 2]) -> String {
        read_grey_tiff(path, ImageSize { columns, rows }).unwrap_err().to_string()
    }

    fn ramp() -> RawImage {
        RawImage::new(3, 2, vec![0, 1, 200, 255, 300, 65_535]).unwrap()
    }

    #[test]
    fn counts_survive_the_file() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("cam1_a.tif");
        write_grey_tiff(&path, &ramp(), FileDepth::Sixteen).unwrap();
        assert_eq!(read_grey_tiff(&path, RAMP).unwrap(), ramp());
        assert_eq!(read_grey_tiff_of_any_size(&path).unwrap(), ramp());
        write_grey_tiff(&path, &ramp(), FileDepth::Eight).unwrap();
        assert_eq!(read_grey_tiff(&path, RAMP).unwrap().counts(), [0, 1, 200, 255, 255, 255]);
    }

    #[test]
    fn a_file_cut_at_any_tenth_is_an_error_that_names_it() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("cam1_a.tif");
        let image = RawImage::new(64, 64, (0..4096).collect()).unwrap();
        write_grey_tiff(&path, &image, FileDepth::Sixteen).unwrap();
        let whole = fs::read(&path).unwrap();
        for tenths in 0..10 {
            fs::write(&path, &whole[..whole.len() * tenths / 10]).unwrap();
            let message = refusal(&path, [64, 64]);
            assert!(message.contains("cam1_a.tif"), "{message}");
            assert!(message.contains("truncated"), "{message}");
        }
    }

    #[test]
    fn an_image_of_another_format_is_named() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("cam1_a.tif");
        DynamicImage::new_luma16(3, 2).save_with_format(&path, ImageFormat::Png).unwrap();
        let message = refusal(&path, [3, 2]);
        assert!(message.contains("cam1_a.tif is a PNG image: save it as grey TIFF"), "{message}");
    }

    #[test]
    fn two_frames_in_one_file_are_refused_but_not_a_thumbnail() {
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
        let message = refusal(&path, [8, 8]);
        assert!(message.contains("cam1_a.tif holds several pages of 8 x 8"), "{message}");
        write_pages([8, 2]);
        let size = ImageSize { columns: 8, rows: 8 };
        assert_eq!(read_grey_tiff(&path, size).unwrap().columns(), 8);
    }

    /// A small file may claim any size; 1-bit images are refused; tile edges are multiples of 16.
    #[test]
    fn the_header_is_checked_before_pixels_are_decoded() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("cam1_a.tif");
        // Little-endian, one directory at byte 8: each tag has one 16-bit number.
        let write = |tags: &[(Tag, u16)]| {
            let mut bytes = [&b"II*\0"[..], &8_u32.to_le_bytes()].concat();
            bytes.extend((tags.len() as u16).to_le_bytes());
            for (tag, value) in tags {
                for number in [tag.to_u16(), 3, 1, 0, *value, 0] {
                    bytes.extend(number.to_le_bytes());
                }
            }
            bytes.extend([0; 4]);
            bytes.resize(4096, 0);
            fs::write(&path, bytes).unwrap();
        };
        let image = |size: u16, bits: u16| {
            [
                (Tag::ImageWidth, size),
                (Tag::ImageLength, size),
                (Tag::BitsPerSample, bits),
                (Tag::PhotometricInterpretation, 1),
            ]
        };
        let strip = |rows: u16| {
            [(Tag::StripOffsets, 1024), (Tag::RowsPerStrip, rows), (Tag::StripByteCounts, 64)]
        };
        let tiles = |edge: u16| {
            [
                (Tag::TileWidth, edge),
                (Tag::TileLength, 16),
                (Tag::TileOffsets, 1024),
                (Tag::TileByteCounts, 256),
            ]
        };
        write(&[&image(8, 8)[..], &strip(8)].concat());
        assert!(read_grey_tiff(&path, ImageSize { columns: 8, rows: 8 }).is_ok());
        write(&[&image(8, 1)[..], &strip(8)].concat());
        assert!(refusal(&path, [8, 8]).contains("cam1_a.tif is grey of 1 bit: save it as grey"));
        write(&[&image(8, 8)[..], &tiles(16)].concat());
        assert!(read_grey_tiff(&path, ImageSize { columns: 8, rows: 8 }).is_ok());
        write(&[&image(8, 8)[..], &tiles(10)].concat());
        let said = refusal(&path, [8, 8]);
        assert!(said.contains("tiles of 10 x 16 pixels, which are not multiples of 16"), "{said}");
        write(&[&image(65_535, 16)[..], &strip(65_535)].concat());
        let said = refusal(&path, [8, 8]);
        assert!(
            said.contains("has 65535 x 65535 pixels but the configured sensor has 8 x 8"),
            "{said}"
        );
    }

    #[test]
    fn a_pipe_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("cam1_a.tif");
        assert!(std::process::Command::new("mkfifo").arg(&path).status().unwrap().success());
        let said = refusal(&path, [8, 8]);
        assert!(said.contains("cam1_a.tif: it is not a regular file"), "{said}");
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
            let message = refusal(&path, [4, 4]);
            assert!(message.contains("cam2_b.tif is colour"), "{message}");
            assert!(message.contains("save it as grey TIFF of 8 or 16 bit"), "{message}");
        }
    }
}
