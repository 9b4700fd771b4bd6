//! NumPy's array files (`.npy`), in C order.

use std::{
    fs::File,
    io::BufWriter,
    path::{Path, PathBuf},
};

use lfpiv_rawlog::regular_file::read_regular;
use npyz::{AutoSerialize, Deserialize, NpyFile, NpyHeader, Order, WriteOptions, WriterBuilder};

use super::PeersError;

/// Bytes that the header of another program may have.
const MOST_HEADER_BYTES: usize = 1 << 16;

/// A number that an array file can hold.
pub trait Element: AutoSerialize + Deserialize + Copy {}

impl<T: AutoSerialize + Deserialize + Copy> Element for T {}

/// Writes a vector piece by piece, for vectors that memory need not hold.
pub struct NpyWriter<T: Element> {
    path: PathBuf,
    writer: npyz::NpyWriter<T, BufWriter<File>>,
}

impl<T: Element> NpyWriter<T> {
    /// Starts an array file.
    pub fn create(path: &Path) -> Result<Self, PeersError> {
        let start = || {
            let file = BufWriter::new(File::create(path)?);
            WriteOptions::new().default_dtype().writer(file).begin_1d()
        };
        let writer = start().map_err(PeersError::io("write", path))?;
        Ok(Self { path: path.to_owned(), writer })
    }

    /// Appends numbers.
    pub fn append(&mut self, values: &[T]) -> Result<(), PeersError> {
        let written = self.writer.extend(values.iter().copied());
        written.map_err(PeersError::io("write", &self.path))
    }

    /// Ends the file, as one axis of all that was written.
    pub fn finish(self) -> Result<(), PeersError> {
        self.writer.finish().map_err(PeersError::io("write", &self.path))
    }
}

/// Writes a whole array.
///
/// # Errors
/// The file cannot be written, or `shape` is not that of `values`.
pub fn write_array<T: Element>(
    path: &Path,
    shape: &[usize],
    values: &[T],
) -> Result<(), PeersError> {
    let write = || {
        let file = BufWriter::new(File::create(path)?);
        let options = WriteOptions::new().default_dtype().shape(&lengths(shape));
        let mut writer = options.writer(file).begin_nd()?;
        writer.extend(values.iter().copied())?;
        writer.finish()
    };
    write().map_err(PeersError::io("write", path))
}

/// Reads an array of numbers in C order, as [`NpyWriter`] and NumPy write it.
///
/// # Errors
/// The file cannot be read, or holds another type or another number of elements than `shape`.
pub fn read_array<T: Element>(path: &Path, shape: &[usize]) -> Result<Vec<T>, PeersError> {
    let data_bytes = shape.iter().product::<usize>() * size_of::<T>();
    let most = (MOST_HEADER_BYTES + data_bytes) as u64;
    let bytes = read_regular(path, most).map_err(PeersError::io("read", path))?;
    let wrong = |reason: String| PeersError::WrongArray { path: path.to_owned(), reason };
    let mut data = bytes.as_slice();
    let header = NpyHeader::from_reader(&mut data).map_err(|error| wrong(error.to_string()))?;
    let (found, expected) = (header.dtype(), T::default_dtype());
    if found != expected {
        return Err(wrong(format!("numbers of {}, not {}", found.descr(), expected.descr())));
    }
    if header.shape() != lengths(shape) {
        return Err(wrong(format!("shape {:?}, not {shape:?}", header.shape())));
    }
    if header.order() != Order::C {
        return Err(wrong("its first index runs fastest (Fortran's order)".to_owned()));
    }
    if data.len() != data_bytes {
        return Err(wrong(format!("{} bytes of data, not {data_bytes}", data.len())));
    }
    NpyFile::with_header(header, data).into_vec().map_err(|error| wrong(error.to_string()))
}

fn lengths(shape: &[usize]) -> Vec<u64> {
    shape.iter().map(|&length| length as u64).collect()
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
        write_array(&path, &[3, 2], &values).unwrap();
        assert_eq!(read_array::<f32>(&path, &[3, 2]).unwrap(), values);
        let mut writer = NpyWriter::create(&path).unwrap();
        writer.append(&values[..2]).unwrap();
        writer.append(&values[2..]).unwrap();
        writer.finish().unwrap();
        assert_eq!(read_array::<f32>(&path, &[6]).unwrap(), values);
        assert!(write_array(&path, &[3, 3], &values).is_err());
    }

    /// As `numpy.save` writes float32 of shape (1, 2).
    #[test]
    fn an_array_that_numpy_wrote_is_read() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.npy");
        write_numpys(&path, "False");
        assert_eq!(read_array::<f32>(&path, &[1, 2]).unwrap(), [1.5, -2.0]);
        assert!(read_array::<f32>(&path, &[2, 1]).is_err());
        write_numpys(&path, "True");
        assert!(wrong::<f32>(&path, &[1, 2]).contains("Fortran"));
    }

    #[test]
    fn another_type_shape_or_length_is_refused_and_named() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.npy");
        write_array(&path, &[2], &[1u32, 2]).unwrap();
        let message = wrong::<f32>(&path, &[2]);
        assert!(message.contains("a.npy") && message.contains("<u4"), "{message}");
        assert!(wrong::<u32>(&path, &[3]).contains("[2], not [3]"));
        let bytes = fs::read(&path).unwrap();
        fs::write(&path, &bytes[..bytes.len() - 1]).unwrap();
        assert!(wrong::<u32>(&path, &[2]).contains("7 bytes of data, not 8"));
        fs::write(&path, [bytes.as_slice(), &[0]].concat()).unwrap();
        assert!(wrong::<u32>(&path, &[2]).contains("9 bytes of data, not 8"));
        fs::write(&path, b"short").unwrap();
        assert!(wrong::<u32>(&path, &[2]).contains("NPY"));
    }

    fn wrong<T: Element + std::fmt::Debug>(path: &Path, shape: &[usize]) -> String {
        let refused = read_array::<T>(path, shape).unwrap_err();
        assert!(matches!(refused, PeersError::WrongArray { .. }), "{refused}");
        refused.to_string()
    }

    fn write_numpys(path: &Path, fortran_order: &str) {
        let text =
            format!("{{'descr': '<f4', 'fortran_order': {fortran_order}, 'shape': (1, 2), }}");
        let mut bytes = b"\x93NUMPY\x01\x00\x76\x00".to_vec();
        bytes.extend(format!("{text:<117}\n").bytes());
        bytes.extend([1.5f32, -2.0].iter().flat_map(|value| value.to_le_bytes()));
        fs::write(path, bytes).unwrap();
    }
}
