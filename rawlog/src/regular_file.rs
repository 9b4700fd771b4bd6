//! Files that are read: regular ones, and no larger than they may be.
//!
//! A pipe under the name of a file would be waited for without end, and so would a terminal. What is
//! opened is looked at, not the name, which may be given to something else in between.

use std::{
    fs::{File, OpenOptions},
    io::{self, Read},
    os::unix::fs::OpenOptionsExt,
    path::Path,
};

use rustix::fs::OFlags;

/// Most bytes of a text that somebody wrote: configurations, tokens, descriptions. A parser takes up
/// to a hundred times as much memory.
const MOST_TEXT_BYTES: u64 = 1 << 20;

/// Opens a file to read it.
///
/// # Errors
/// It cannot be opened, or is no regular file.
pub fn open_regular(path: &Path) -> io::Result<File> {
    open_regular_with(File::options().read(true), path)
}

/// The same to do more than read.
///
/// # Errors
/// As [`open_regular`].
pub fn open_regular_with(options: &mut OpenOptions, path: &Path) -> io::Result<File> {
    // Regular files know no waiting; for others, opening does not wait then.
    let file = options.custom_flags(OFlags::NONBLOCK.bits() as i32).open(path)?;
    match file.metadata()?.is_file() {
        true => Ok(file),
        false => Err(io::Error::other("it is no regular file")),
    }
}

/// The bytes of a file, `most` at most.
///
/// # Errors
/// As [`open_regular`]; it is larger, or cannot be read.
pub fn read_regular(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    bytes_of(open_regular(path)?, most)
}

/// The text of a file, 1 MiB at most.
///
/// # Errors
/// As [`read_regular`]; it is no UTF-8.
pub fn read_text(path: &Path) -> io::Result<String> {
    text_of(open_regular(path)?)
}

/// The text of an opened file, as [`read_text`].
///
/// # Errors
/// As [`read_text`].
pub fn text_of(file: File) -> io::Result<String> {
    let bytes = bytes_of(file, MOST_TEXT_BYTES)?;
    String::from_utf8(bytes)
        .map_err(|_| io::Error::new(io::ErrorKind::InvalidData, "it is no text in UTF-8"))
}

fn bytes_of(file: File, most: u64) -> io::Result<Vec<u8>> {
    let length = file.metadata()?.len();
    if length > most {
        let words = format!("it has {length} bytes, and {most} are the most that are read");
        return Err(io::Error::new(io::ErrorKind::FileTooLarge, words));
    }
    let mut bytes = Vec::new();
    // It may grow meanwhile.
    file.take(most).read_to_end(&mut bytes)?;
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn what_is_no_regular_file_is_refused_and_not_waited_for() {
        let folder = tempfile::tempdir().unwrap();
        let pipe = folder.path().join("pipe");
        assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        for path in [&pipe, folder.path(), Path::new("/dev/zero")] {
            let said = read_text(path).unwrap_err().to_string();
            assert_eq!(said, "it is no regular file", "{}", path.display());
        }
        // Nobody reads from it: opening it to write would wait, too.
        assert!(open_regular_with(File::options().append(true), &pipe).is_err());
    }

    #[test]
    fn a_text_has_a_largest_size_and_is_utf_8() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("text");
        fs::write(&path, vec![b'a'; MOST_TEXT_BYTES as usize]).unwrap();
        assert_eq!(read_text(&path).unwrap().len() as u64, MOST_TEXT_BYTES);
        fs::write(&path, vec![b'a'; MOST_TEXT_BYTES as usize + 1]).unwrap();
        let said = read_text(&path).unwrap_err().to_string();
        assert!(said.contains("1048577 bytes, and 1048576 are the most"), "{said}");
        fs::write(&path, b"\xff").unwrap();
        assert!(read_text(&path).unwrap_err().to_string().contains("UTF-8"));
    }
}
