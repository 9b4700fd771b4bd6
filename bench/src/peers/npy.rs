//! NumPy's array files (`.npy`, format 1.0), little-endian and in C order.

use std::{
    fs::File,
    io::{BufWriter, Seek, Write},
    marker::PhantomData,
    path::{Path, PathBuf},
};

use lfpiv_rawlog::regular_file::read_regular;

use super::PeersError;

const MAGIC: &[u8; 8] = b"\x93NUMPY\x01\x00";

/// Bytes before the data. Fixed, so that the header can be written when the length is known.
const HEADER_BYTES: usize = 128;
/// Bytes that the header of another program may have.
const MOST_DESCRIPTION_BYTES: usize = 1 << 16;

/// A number that an array file can hold.
pub trait Element: Copy {
    /// NumPy's name of the type.
    const DESCRIPTION: &'static str;
    /// Bytes of one number.
    const BYTES: usize = size_of::<Self>();
    /// Appends the little-endian bytes.
    fn put(self, bytes: &mut Vec<u8>);
    /// The number in [`Self::BYTES`] little-endian bytes.
    fn get(bytes: &[u8]) -> Self;
}

macro_rules! element {
    ($number:ty, $description:literal) => {
        impl Element for $number {
            const DESCRIPTION: &'static str = $description;

            fn put(self, bytes: &mut Vec<u8>) {
                bytes.extend(self.to_le_bytes());
            }

            fn get(bytes: &[u8]) -> Self {
                let mut own = [0; size_of::<$number>()];
                own.copy_from_slice(bytes);
                Self::from_le_bytes(own)
            }
        }
    };
}

element!(f32, "<f4");
element!(u32, "<u4");
element!(u64, "<u8");

/// Writes an array piece by piece, for arrays that memory need not hold.
pub struct NpyWriter<T> {
    path: PathBuf,
    file: BufWriter<File>,
    written: usize,
    element: PhantomData<T>,
}

impl<T: Element> NpyWriter<T> {
    /// Starts an array file.
    pub fn create(path: &Path) -> Result<Self, PeersError> {
        let start = || {
            let mut file = BufWriter::new(File::create(path)?);
            file.write_all(&[0; HEADER_BYTES])?;
            Ok(file)
        };
        let file = start().map_err(PeersError::io("write", path))?;
        Ok(Self { path: path.to_owned(), file, written: 0, element: PhantomData })
    }

    /// Appends numbers.
    pub fn append(&mut self, values: &[T]) -> Result<(), PeersError> {
        let mut bytes = Vec::with_capacity(values.len() * T::BYTES);
        values.iter().for_each(|value| value.put(&mut bytes));
        self.written += values.len();
        self.file.write_all(&bytes).map_err(PeersError::io("write", &self.path))
    }

    /// Ends the file. Panics when `shape` is not that of as many numbers as were written.
    pub fn finish(mut self, shape: &[usize]) -> Result<(), PeersError> {
        assert_eq!(shape.iter().product::<usize>(), self.written, "{}", self.path.display());
        self.file
            .rewind()
            .and_then(|()| self.file.write_all(&header::<T>(shape)))
            .and_then(|()| self.file.flush())
            .map_err(PeersError::io("write", &self.path))
    }
}

/// Writes a whole array. Panics when `shape` is not that of `values`.
pub fn write_array<T: Element>(
    path: &Path,
    shape: &[usize],
    values: &[T],
) -> Result<(), PeersError> {
    let mut writer = NpyWriter::create(path)?;
    writer.append(values)?;
    writer.finish(shape)
}

/// Reads an array of numbers in C order, as [`NpyWriter`] and NumPy write it (format version 1).
///
/// # Errors
/// The file cannot be read, or holds another type or another number of elements than `shape`.
pub fn read_array<T: Element>(path: &Path, shape: &[usize]) -> Result<Vec<T>, PeersError> {
    let elements: usize = shape.iter().product();
    let most = (MOST_DESCRIPTION_BYTES + elements * T::BYTES) as u64;
    let bytes = read_regular(path, most).map_err(PeersError::io("read", path))?;
    let wrong = |reason: String| PeersError::WrongArray { path: path.to_owned(), reason };
    let Some((found, data)) = description(&bytes) else {
        return Err(wrong(format!("{} bytes without NumPy's header", bytes.len())));
    };
    if found != without_spaces(&array_description::<T>(shape)) {
        return Err(wrong(format!("not {shape:?} of {}", T::DESCRIPTION)));
    }
    if data.len() != elements * T::BYTES {
        return Err(wrong(format!("{} bytes of data", data.len())));
    }
    Ok(data.chunks_exact(T::BYTES).map(T::get).collect())
}

/// An array file's description without its spaces, and its data.
fn description(bytes: &[u8]) -> Option<(String, &[u8])> {
    let rest = bytes.strip_prefix(MAGIC)?;
    let (length, rest) = rest.split_first_chunk()?;
    let (text, data) = rest.split_at_checked(u16::from_le_bytes(*length).into())?;
    Some((without_spaces(std::str::from_utf8(text).ok()?), data))
}

/// NumPy and this program put spaces, and a comma after the last length, in different places.
fn without_spaces(description: &str) -> String {
    let dense: String = description.chars().filter(|c| !c.is_whitespace()).collect();
    dense.replace(",)", ")")
}

fn array_description<T: Element>(shape: &[usize]) -> String {
    let lengths: String = shape.iter().map(|n| format!("{n},")).collect();
    format!("{{'descr': '{}', 'fortran_order': False, 'shape': ({lengths}), }}", T::DESCRIPTION)
}

fn header<T: Element>(shape: &[usize]) -> Vec<u8> {
    let text = array_description::<T>(shape);
    let room = HEADER_BYTES - MAGIC.len() - size_of::<u16>();
    let mut header = MAGIC.to_vec();
    header.extend((room as u16).to_le_bytes());
    header.extend(format!("{text:<width$}\n", width = room - 1).bytes());
    header
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn an_array_reads_back_as_it_was_written() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.npy");
        let values = [1.5f32, -2.0, 0.0, f32::MIN_POSITIVE, 3e8, -0.25];
        let mut writer = NpyWriter::create(&path).unwrap();
        writer.append(&values[..2]).unwrap();
        writer.append(&values[2..]).unwrap();
        writer.finish(&[3, 2]).unwrap();
        assert_eq!(read_array::<f32>(&path, &[3, 2]).unwrap(), values);
    }

    #[test]
    fn the_header_is_numpys() {
        let header = header::<u64>(&[7]);
        assert_eq!(header.len(), HEADER_BYTES);
        assert_eq!(&header[..10], b"\x93NUMPY\x01\x00\x76\x00");
        let text = std::str::from_utf8(&header[10..]).unwrap();
        assert_eq!(text.trim_end(), "{'descr': '<u8', 'fortran_order': False, 'shape': (7,), }");
        assert!(text.ends_with('\n'));
    }

    /// As `numpy.save` writes float32 of shape (1, 2): with spaces, without a last comma.
    #[test]
    fn an_array_that_numpy_wrote_is_read() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.npy");
        let text = "{'descr': '<f4', 'fortran_order': False, 'shape': (1, 2), }";
        let mut bytes = b"\x93NUMPY\x01\x00\x76\x00".to_vec();
        bytes.extend(format!("{text:<117}\n").bytes());
        bytes.extend([1.5f32, -2.0].iter().flat_map(|value| value.to_le_bytes()));
        fs::write(&path, bytes).unwrap();
        assert_eq!(read_array::<f32>(&path, &[1, 2]).unwrap(), [1.5, -2.0]);
        assert!(read_array::<f32>(&path, &[2, 1]).is_err());
    }

    #[test]
    fn another_type_shape_or_length_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.npy");
        write_array(&path, &[2], &[1u32, 2]).unwrap();
        assert!(read_array::<f32>(&path, &[2]).is_err());
        assert!(read_array::<u32>(&path, &[3]).is_err());
        let bytes = fs::read(&path).unwrap();
        fs::write(&path, &bytes[..bytes.len() - 1]).unwrap();
        assert!(read_array::<u32>(&path, &[2]).is_err());
        fs::write(&path, b"short").unwrap();
        assert!(read_array::<u32>(&path, &[2]).is_err());
    }
}
