//! The house rule: a crate and a room import only from floors below.
#![allow(clippy::unwrap_used)]

use std::{fs, path::Path};

/// The crates and their rooms, lowest floor first, as ARCHITECTURE.md lists them. What a crate may
/// depend on stands in its `Cargo.toml`, and cargo allows no circles.
const CRATES: [(&str, &[&str]); 2] = [
    (
        "core",
        &[
            "lightfield",
            "model",
            "reconstruction",
            "particles",
            "velocimetry",
            "ensemble",
            "calibration",
            "measurement",
        ],
    ),
    (".", &["archive", "acquisition", "pipeline", "cluster", "config", "server", "cli"]),
];

/// What the crates below the daemon must not depend on. The simulator must not know the forward model that it
/// tests.
const KEPT_APART: [(&str, &[&str]); 4] = [
    ("hw", &["lfpiv-core", "lfpiv-rawlog", "lfpiv-sim", "lfpiv"]),
    ("core", &["lfpiv-rawlog", "lfpiv-sim", "lfpiv", "tokio", "netcdf"]),
    ("rawlog", &["lfpiv-core", "lfpiv-sim", "lfpiv"]),
    ("sim", &["lfpiv-core", "lfpiv-rawlog", "lfpiv"]),
];

fn sources(folder: &Path, found: &mut Vec<(String, String)>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push((path.display().to_string(), fs::read_to_string(&path).unwrap()));
        }
    }
}

/// The rooms that a source names after `crate::`, in plain paths and in import lists.
fn imports(text: &str, rooms: &[&'static str]) -> Vec<&'static str> {
    let names = |from: &str| -> Vec<&'static str> {
        rooms.iter().copied().filter(|room| from.starts_with(&format!("{room}::"))).collect()
    };
    let mut found = Vec::new();
    for (at, _) in text.match_indices("crate::") {
        let rest = &text[at + "crate::".len()..];
        match rest.strip_prefix('{') {
            None => found.extend(names(rest)),
            Some(list) => {
                let list = &list[..list.find("};").unwrap_or(list.len())];
                found.extend(list.split([',', '{', '\n']).flat_map(|item| names(item.trim())));
            }
        }
    }
    found
}

#[test]
fn rooms_import_only_from_floors_below() {
    let mut wrong = Vec::new();
    let mut seen = 0;
    for (of, rooms) in CRATES {
        let source_folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(of).join("src");
        for (floor, room) in rooms.iter().enumerate() {
            let mut files = Vec::new();
            let folder = source_folder.join(room);
            assert!(folder.is_dir(), "{room} is gone: correct this list and ARCHITECTURE.md");
            sources(&folder, &mut files);
            for (file, text) in files {
                let imported = imports(&text, rooms);
                seen += imported.len();
                wrong.extend(
                    imported
                        .into_iter()
                        .filter(|other| rooms.iter().position(|r| r == other) > Some(floor))
                        .map(|other| format!("{file} imports from {other}")),
                );
            }
        }
    }
    assert!(seen > 20, "the search for imports finds almost none");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Results do not depend on when they are made: who wants times of the stages hands in a clock.
#[test]
fn the_numerics_read_no_clock() {
    let mut files = Vec::new();
    sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("core/src"), &mut files);
    assert!(files.len() > 50, "core has moved: correct this test");
    let reads = |text: &str| ["Instant", "SystemTime"].iter().any(|clock| names(text, clock));
    assert!(reads("let t = Instant::now();") && !reads("Instantaneous"));
    let wrong: Vec<&str> =
        files.iter().filter(|(_, text)| reads(text)).map(|(file, _)| file.as_str()).collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Whether a source names this as a whole word.
fn names(text: &str, word: &str) -> bool {
    let part_of_a_name = |c: char| c.is_alphanumeric() || c == '_';
    text.match_indices(word).any(|(at, _)| {
        !text[..at].ends_with(part_of_a_name)
            && !text[at + word.len()..].starts_with(part_of_a_name)
    })
}

#[test]
fn crates_depend_only_on_crates_below() {
    for (of, kept_out) in KEPT_APART {
        let manifest = Path::new(env!("CARGO_MANIFEST_DIR")).join(of).join("Cargo.toml");
        let manifest: toml::Table = fs::read_to_string(manifest).unwrap().parse().unwrap();
        let needed = manifest["dependencies"].as_table().unwrap();
        assert!(!needed.is_empty());
        for other in kept_out {
            assert!(!needed.contains_key(*other), "{of} depends on {other}");
        }
    }
}
