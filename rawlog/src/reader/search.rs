//! Searches a damaged file for the next magic number.

use std::io;

use super::super::storage::LogFile;

/// Bytes per read.
const READ_BYTES: usize = 1 << 16;

/// Offset of the first of these patterns that begins in `from..end`.
pub(super) fn find_bytes(
    file: &dyn LogFile,
    mut from: u64,
    end: u64,
    patterns: &[&[u8]],
) -> io::Result<Option<u64>> {
    let longest = patterns.iter().map(|pattern| pattern.len()).max().unwrap_or_default();
    let mut bytes = vec![0; READ_BYTES];
    while from < end {
        let read = file.read_at(from, &mut bytes)?;
        let bytes = &bytes[..read];
        let is_there =
            |at: &usize| patterns.iter().any(|pattern| bytes[*at..].starts_with(pattern));
        if let Some(at) = (0..read).find(is_there) {
            let found = from + at as u64;
            return Ok((found < end).then_some(found));
        }
        if read < READ_BYTES {
            return Ok(None);
        }
        // A pattern may straddle two reads.
        from += (read + 1 - longest) as u64;
    }
    Ok(None)
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::storage::{Storage, model::ModelDisk};

    #[test]
    fn a_pattern_is_found_across_the_border_of_two_reads_and_not_beyond_the_end() {
        let disk = ModelDisk::default();
        let mut file = disk.create(Path::new("file")).unwrap();
        let at = READ_BYTES as u64 - 2;
        file.append(&vec![b'L'; at as usize]).unwrap();
        file.append(b"LFRC and LFEN").unwrap();
        let find = |from, end| find_bytes(&*file, from, end, &[b"LFRC", b"LFEN"]).unwrap();
        assert_eq!(find(0, u64::MAX), Some(at));
        assert_eq!(find(at + 1, u64::MAX), Some(at + 9));
        assert_eq!(find(at + 10, u64::MAX), None);
        assert_eq!(find(0, at), None);
    }
}
