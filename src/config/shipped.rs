//! Configurations and suites that the program brings along: its examples work wherever it is.

use std::{
    io,
    path::{Component, Path, PathBuf},
};

use lfpiv_rawlog::regular_file::read_text;

/// Every shipped file by its place in the source.
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

/// A file's text. Where there is no such file and its path is that of a shipped one, as
/// `config/bench.toml`, that one's.
///
/// # Errors
/// The file cannot be read, and is none of the shipped ones.
pub fn read_or_shipped(path: &Path) -> io::Result<String> {
    match read_text(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => match shipped(path) {
            Some(text) => {
                tracing::info!("{} comes with the program", path.display());
                Ok(text.to_owned())
            }
            None => Err(error),
        },
        read => read,
    }
}

fn shipped(path: &Path) -> Option<&'static str> {
    let path = without_detours(path);
    SHIPPED.iter().find(|(place, _)| Path::new(place) == path).map(|(_, text)| *text)
}

/// `bench/../config/bench.toml` as `config/bench.toml`; nothing is looked up.
fn without_detours(path: &Path) -> PathBuf {
    path.components().fold(PathBuf::new(), |mut straight, component| {
        match component {
            Component::CurDir => {}
            Component::ParentDir if straight.file_name().is_some() => {
                straight.pop();
            }
            other => straight.push(other),
        }
        straight
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
    fn a_file_that_is_there_comes_first() {
        let root = tempfile::tempdir().unwrap();
        let path = root.path().join("config/sim.toml");
        fs::create_dir(root.path().join("config")).unwrap();
        fs::write(&path, "mine").unwrap();
        assert_eq!(read_or_shipped(&path).unwrap(), "mine");
        let absent = read_or_shipped(&root.path().join("config/jet.toml")).unwrap_err();
        assert_eq!(absent.kind(), io::ErrorKind::NotFound);
    }

    /// All of `config/` is brought along.
    #[test]
    fn no_configuration_is_forgotten() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("config");
        for entry in fs::read_dir(folder).unwrap() {
            let name = entry.unwrap().file_name().into_string().unwrap();
            assert!(shipped(&Path::new("config").join(&name)).is_some(), "{name}");
        }
    }
}
