//! Configurations and suites that are compiled into the program, so that the documented examples
//! work in any folder.

use std::{
    io,
    path::{Component, Path, PathBuf},
};

use lfpiv_rawlog::regular_file::read_text;

/// Every shipped file with its path in the repository.
const SHIPPED: [(&str, &str); 10] = [
    ("config/sim.toml", include_str!("../../config/sim.toml")),
    ("config/bench.toml", include_str!("../../config/bench.toml")),
    ("config/imperfect.toml", include_str!("../../config/imperfect.toml")),
    ("config/card.toml", include_str!("../../config/card.toml")),
    ("config/jet.toml", include_str!("../../config/jet.toml")),
    ("config/paper.toml", include_str!("../../config/paper.toml")),
    ("config/loopback.toml", include_str!("../../config/loopback.toml")),
    ("config/loopback-bench.toml", include_str!("../../config/loopback-bench.toml")),
    ("bench/report.toml", include_str!("../../bench/report.toml")),
    ("bench/smoke.toml", include_str!("../../bench/smoke.toml")),
];

/// Reads a text file. If it does not exist and its path is that of a shipped file, such as
/// `config/bench.toml`, the shipped text is returned.
///
/// # Errors
/// The file cannot be read and is not a shipped one.
pub fn read_or_shipped(path: &Path) -> io::Result<String> {
    match read_text(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => match shipped(path) {
            Some(text) => {
                tracing::info!(
                    "{} does not exist; using the copy shipped with the program",
                    path.display()
                );
                Ok(text.to_owned())
            }
            None => Err(error),
        },
        read => read,
    }
}

fn shipped(path: &Path) -> Option<&'static str> {
    let path = normalized(path);
    SHIPPED.iter().find(|(place, _)| Path::new(place) == path).map(|(_, text)| *text)
}

/// Resolves `.` and `..` by name alone: `bench/../config/bench.toml` becomes `config/bench.toml`.
fn normalized(path: &Path) -> PathBuf {
    path.components().fold(PathBuf::new(), |mut normal, component| {
        match component {
            Component::CurDir => {}
            Component::ParentDir if normal.file_name().is_some() => {
                normal.pop();
            }
            other => normal.push(other),
        }
        normal
    })
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn shipped_files_are_found_by_their_place_in_the_source() {
        for path in ["config/sim.toml", "./config/sim.toml", "bench/../config/sim.toml"] {
            assert_eq!(shipped(Path::new(path)), Some(SHIPPED[0].1), "{path}");
        }
        for path in ["sim.toml", "/config/sim.toml", "../config/sim.toml", "config/mine.toml"] {
            assert_eq!(shipped(Path::new(path)), None, "{path}");
        }
    }

    #[test]
    fn an_existing_file_takes_precedence() {
        let root = tempfile::tempdir().unwrap();
        let path = root.path().join("config/sim.toml");
        fs::create_dir(root.path().join("config")).unwrap();
        fs::write(&path, "mine").unwrap();
        assert_eq!(read_or_shipped(&path).unwrap(), "mine");
        let absent = read_or_shipped(&root.path().join("config/jet.toml")).unwrap_err();
        assert_eq!(absent.kind(), io::ErrorKind::NotFound);
    }

    /// All files of `config/` are shipped.
    #[test]
    fn every_configuration_is_shipped() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("config");
        for entry in fs::read_dir(folder).unwrap() {
            let name = entry.unwrap().file_name().into_string().unwrap();
            assert!(shipped(&Path::new("config").join(&name)).is_some(), "{name}");
        }
    }
}
