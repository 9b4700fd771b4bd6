//! File names of a log.

use std::path::{Path, PathBuf};

const SEALED: &str = ".raw";
const PART: &str = ".raw.part";

/// Path of a sealed segment.
pub(super) fn sealed_path(folder: &Path, segment: u32) -> PathBuf {
    folder.join(format!("segment_{segment:06}{SEALED}"))
}

/// Path of the segment being written.
pub(super) fn part_path(folder: &Path, segment: u32) -> PathBuf {
    folder.join(format!("segment_{segment:06}{PART}"))
}

/// Path of the torn tail that recovery cut from a segment at the `attempt`th time (from 1).
pub(super) fn torn_path(folder: &Path, segment: u32, attempt: u32) -> PathBuf {
    let suffix = if attempt == 1 { String::new() } else { format!(".{attempt}") };
    folder.join(format!("segment_{segment:06}{SEALED}.torn{suffix}"))
}

/// Number of a segment file and whether it is sealed; `None` for other files. The highest number is
/// not accepted, because it has no successor.
pub(super) fn parse(name: &str) -> Option<(u32, bool)> {
    let name = name.strip_prefix("segment_")?;
    let (digits, sealed) = match (name.strip_suffix(SEALED), name.strip_suffix(PART)) {
        (Some(digits), _) => (digits, true),
        (_, Some(digits)) => (digits, false),
        _ => return None,
    };
    let number: u32 =
        digits.bytes().all(|byte| byte.is_ascii_digit()).then(|| digits.parse().ok())??;
    (number < u32::MAX).then_some((number, sealed))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn name(path: &Path) -> &str {
        path.file_name().unwrap().to_str().unwrap()
    }

    #[test]
    fn segment_names_are_parsed_and_others_rejected() {
        let folder = Path::new("raw");
        assert_eq!(name(&sealed_path(folder, 12)), "segment_000012.raw");
        for number in [0, 12, 999_999, 1_000_000, u32::MAX - 1] {
            assert_eq!(parse(name(&sealed_path(folder, number))), Some((number, true)));
            assert_eq!(parse(name(&part_path(folder, number))), Some((number, false)));
            assert_eq!(parse(name(&torn_path(folder, number, 1))), None);
            assert_eq!(parse(name(&torn_path(folder, number, 2))), None);
        }
        for other in [
            "segment_4294967295.raw",
            "segment_.raw",
            "segment_+1.raw",
            "segment_1",
            "run.json",
            ".raw",
        ] {
            assert_eq!(parse(other), None, "{other}");
        }
    }
}
