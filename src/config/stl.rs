//! Triangles from STL files, binary and ASCII.

use std::io::{self, Cursor};

use stl_io::{Triangle, create_stl_reader};

/// Bytes before the triangles of a binary file, the last four of them their number.
const HEADER: usize = 84;

/// Bytes of a triangle in a binary file.
const TRIANGLE: usize = 50;

/// The corners of a triangle, in the file's unit.
type Corners = [[f64; 3]; 3];

/// The corners of a file's triangles, in its order.
///
/// # Errors
/// A message for the user: it is neither format, or it is cut off.
pub(super) fn triangles(bytes: &[u8]) -> Result<Vec<Corners>, String> {
    // Binary files may begin with the word that ASCII files begin with, by which the library tells them: their
    // length is no accident.
    let read = if is_binary(bytes) { binary(bytes) } else { ascii(bytes) };
    read.map_err(|error| {
        format!(
            "it is no STL file, or a part of one ({error}); allowed: the ASCII format, or the \
             binary one with {TRIANGLE} bytes for each of the triangles that it announces"
        )
    })
}

fn is_binary(bytes: &[u8]) -> bool {
    let number = bytes.get(HEADER - 4..HEADER).and_then(|bytes| bytes.try_into().ok());
    let number = number.map(|bytes| u32::from_le_bytes(bytes) as usize);
    number.is_some_and(|number| bytes.len() == HEADER + TRIANGLE * number)
}

fn binary(bytes: &[u8]) -> io::Result<Vec<Corners>> {
    let mut file = bytes.to_vec();
    file[..HEADER - 4].fill(0);
    create_stl_reader(&mut Cursor::new(file))?.map(corners).collect()
}

/// The library reads one body, with a name; a file may hold several, and names are often left out.
fn ascii(bytes: &[u8]) -> io::Result<Vec<Corners>> {
    let invalid = |what: String| io::Error::new(io::ErrorKind::InvalidData, what);
    let text = str::from_utf8(bytes).map_err(|error| invalid(error.to_string()))?;
    let mut lines = text.lines().filter(|line| !line.trim().is_empty());
    let mut found = Vec::new();
    while let Some(first) = lines.next() {
        if first.split_whitespace().next() != Some("solid") {
            return Err(invalid(format!("{first:?} instead of \"solid\"")));
        }
        let mut body = "solid body\n".to_owned();
        for line in lines.by_ref() {
            body.push_str(line);
            body.push('\n');
            if line.trim_start().starts_with("endsolid") {
                break;
            }
        }
        for triangle in create_stl_reader(&mut Cursor::new(body))? {
            found.push(corners(triangle)?);
        }
    }
    Ok(found)
}

fn corners(triangle: io::Result<Triangle>) -> io::Result<Corners> {
    Ok(triangle?.vertices.map(|vertex| <[f32; 3]>::from(vertex).map(f64::from)))
}

#[cfg(test)]
mod tests {
    use super::*;

    const FACET: &str = "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0.5\n  \
                         vertex 0 1e1 0\n endloop\nendfacet\n";

    fn binary_file(header: &[u8], triangles: u32) -> Vec<u8> {
        let mut bytes = header.to_vec();
        bytes.resize(80, b' ');
        bytes.extend(triangles.to_le_bytes());
        for _ in 0..triangles {
            let numbers = [0.0f32, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.5, 0.0, 10.0, 0.0];
            bytes.extend(numbers.iter().flat_map(|number| number.to_le_bytes()));
            bytes.extend([0; 2]);
        }
        bytes
    }

    #[test]
    fn both_formats_hold_the_same_triangles() {
        let expected = [[0.0; 3], [1.0, 0.0, 0.5], [0.0, 10.0, 0.0]];
        for text in [
            format!("solid\n{FACET}endsolid\n"),
            format!("solid a name\n{FACET}endsolid a name"),
            format!("\n  solid x\r\n{}endsolid x\r\n\n", FACET.replace('\n', "\r\n")),
        ] {
            assert_eq!(triangles(text.as_bytes()).unwrap(), [expected], "{text}");
        }
        assert_eq!(triangles(&binary_file(b"solid as some write", 2)).unwrap(), [expected; 2]);
        let two = format!("solid a\n{FACET}endsolid a\nsolid b\n{FACET}{FACET}endsolid b\n");
        assert_eq!(triangles(two.as_bytes()).unwrap(), [expected; 3]);
    }

    #[test]
    fn other_files_and_parts_of_files_are_refused() {
        let whole = format!("solid a\n{FACET}endsolid a\n");
        let binary = binary_file(b"", 3);
        let parts = [&whole.as_bytes()[..whole.len() / 2], &binary[..200], &binary[..90], b"solid"];
        let others: [&[u8]; 4] = [b"", b"\xff\xfe", b"# volume", b"solid a\nfacet\nendsolid"];
        for bytes in parts.into_iter().chain(others) {
            let read = triangles(bytes);
            assert!(read.is_err() || bytes.is_empty(), "{read:?}");
        }
        let error = triangles(b"voxels = [1, 2]").unwrap_err();
        assert!(error.contains("it is no STL file"), "{error}");
    }
}
