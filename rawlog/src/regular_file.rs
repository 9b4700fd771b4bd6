//! Bounded reading of regular files.
//!
//! Opening a pipe or terminal in place of a file would block for ever. The opened file is checked,
//! not its path, which another process may replace in between.

use std::{
    fs::{File, OpenOptions},
    io::{self, Read},
    os::unix::fs::OpenOptionsExt,
    path::Path,
};

use rustix::fs::OFlags;

/// Most bytes of a hand-written text: configuration, tokens, description. A parser needs up to a
/// hundred times as much memory.
const MAX_TEXT_BYTES: u64 = 1 << 20;

/// Opens a file for reading.
///
/// # Errors
/// It cannot be opened, or is not a regular file.
pub fn open_regular(path: &Path) -> io::Result<File> {
    open_regular_with(File::options().read(true), path)
}

/// As [`open_regular`], with other options.
///
/// # Errors
/// As [`open_regular`].
pub fn open_regular_with(options: &mut OpenOptions, path: &Path) -> io::Result<File> {
    // No effect on regular files; opening anything else then does not block.
    let file = options.custom_flags(OFlags::NONBLOCK.bits() as i32).open(path)?;
    match file.metadata()?.is_file() {
        true => Ok(file),
        false => Err(io::Error::other("it is not a regular file")),
    }
}

/// The bytes of a file, at most `most`.
///
/// # Errors
/// As [`open_regular`]; or the file is larger, or cannot be read.
pub fn read_regular(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    bytes_of(open_regular(path)?, most)
}

/// The text of a file, 1 MiB at most.
///
/// # Errors
/// As [`read_regular`]; or it is not UTF-8.
pub fn read_text(path: &Path) -> io::Result<String> {
    text_of(open_regular(path)?)
}

/// The text of an open file, as [`read_text`].
///
/// # Errors
/// As [`read_text`].
pub fn text_of(file: File) -> io::Result<String> {
    let bytes = bytes_of(file, MAX_TEXT_BYTES)?;
    String::from_utf8(bytes)
        .map_err(|_| io::Error::new(io::ErrorKind::InvalidData, "it is not UTF-8 text"))
}

fn bytes_of(file: File, most: u64) -> io::Result<Vec<u8>> {
    let length = file.metadata()?.len();
    if length > most {
        let words = format!("it has {length} bytes; at most {most} are read");
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, words));
    }
    let mut bytes = Vec::new();
    // The file may grow in the meantime.
    file.take(most).read_to_end(&mut bytes)?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn files_that_are_not_regular_are_refused_without_blocking() {
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe");
        assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        for path in [&pipe, folder.path(), Path::new("/dev/zero")] {
            let said = read_text(path).unwrap_err().to_string();
            assert_eq!(said, "it is not a regular file", "{}", path.display());
        }
        // Nobody reads from the pipe: opening it for writing would block, too.
        assert!(open_regular_with(File::options().append(true), &pipe).is_err());
    }

    #[test]
    fn a_text_has_a_largest_size_and_is_utf_8() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("text");
        fs::write(&path, vec![b'a'; MAX_TEXT_BYTES as usize]).unwrap();
        assert_eq!(read_text(&path).unwrap().len() as u64, MAX_TEXT_BYTES);
        fs::write(&path, vec![b'a'; MAX_TEXT_BYTES as usize + 1]).unwrap();
        let said = read_text(&path).unwrap_err().to_string();
        assert!(said.contains("1048577 bytes; at most 1048576"), "{said}");
        fs::write(&path, b"\xff").unwrap();
        assert!(read_text(&path).unwrap_err().to_string().contains("UTF-8"));
    }
}
