//! The house rule: a room imports only from floors below it.
#![allow(clippy::unwrap_used)]

use std::{fs, path::Path};

/// The rooms, lowest floor first, as ARCHITECTURE.md lists them.
const FLOORS: [&str; 11] = [
    "lightfield",
    "model",
    "reconstruction",
    "velocimetry",
    "archive",
    "acquisition",
    "pipeline",
    "config",
    "benchmark",
    "server",
    "cli",
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
fn imports(text: &str) -> Vec<&'static str> {
    let names = |from: &str| -> Vec<&'static str> {
        FLOORS.into_iter().filter(|room| from.starts_with(&format!("{room}::"))).collect()
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
    let source_folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut wrong = Vec::new();
    let mut seen = 0;
    for (floor, room) in FLOORS.into_iter().enumerate() {
        let mut files = Vec::new();
        let folder = source_folder.join(room);
        assert!(folder.is_dir(), "the room {room} is gone: correct this list and ARCHITECTURE.md");
        sources(&folder, &mut files);
        for (file, text) in files {
            let imported = imports(&text);
            seen += imported.len();
            wrong.extend(
                imported
                    .into_iter()
                    .filter(|other| FLOORS.iter().position(|r| r == other) > Some(floor))
                    .map(|other| format!("{file} imports from {other}")),
            );
        }
    }
    assert!(seen > 20, "the search for imports finds almost none");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
