//! Crates and modules import only from lower ones, and files beside each other not from each other.
#![allow(clippy::unwrap_used)]

use std::{collections::BTreeMap, fs, path::Path};

/// The crates and their modules, the lowest first, as ARCHITECTURE.md lists them. What a crate may
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

/// The modules that a source names after `root`, in plain paths and in import lists.
fn imports<'a>(text: &str, root: &str, modules: &[&'a str]) -> Vec<&'a str> {
    let named = |item: &str| -> Vec<&'a str> {
        let first = item.split([':', ';', '}', ' ']).next();
        modules.iter().copied().filter(|module| first == Some(module)).collect()
    };
    let mut found = Vec::new();
    for (at, _) in text.match_indices(root) {
        // `super::super::` is another module's.
        if text[..at].ends_with("::") {
            continue;
        }
        let rest = &text[at + root.len()..];
        match rest.strip_prefix('{') {
            None => found.extend(named(rest.split_whitespace().next().unwrap_or_default())),
            Some(list) => {
                let list = &list[..list.find("};").unwrap_or(list.len())];
                found.extend(list.split([',', '{', '\n']).flat_map(|item| named(item.trim())));
            }
        }
    }
    found
}

#[test]
fn modules_import_only_from_lower_ones() {
    let mut wrong = Vec::new();
    let mut seen = 0;
    for (of, modules) in CRATES {
        let source_folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(of).join("src");
        for (height, module) in modules.iter().enumerate() {
            let mut files = Vec::new();
            let folder = source_folder.join(module);
            assert!(folder.is_dir(), "{module} is gone: correct this list and ARCHITECTURE.md");
            sources(&folder, &mut files);
            for (file, text) in files {
                let imported = imports(&text, "crate::", modules);
                seen += imported.len();
                wrong.extend(
                    imported
                        .into_iter()
                        .filter(|other| modules.iter().position(|m| m == other) > Some(height))
                        .map(|other| format!("{file} imports from {other}")),
                );
            }
        }
    }
    assert!(seen > 20, "the search for imports finds almost none");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Without its tests and comments.
fn program(path: &Path) -> String {
    let text = fs::read_to_string(path).unwrap();
    let code = text.split("#[cfg(test)]").next().unwrap_or_default();
    let lines = code.lines().filter(|line| !line.trim_start().starts_with("//"));
    lines.map(|line| format!("{line}\n")).collect()
}

/// What a module brings in from its children, so that they can import it from their parent: the name of
/// each item, and the child that has it.
fn brought_in<'a>(parent: &'a str, children: &[&'a str]) -> BTreeMap<&'a str, &'a str> {
    let mut brought = BTreeMap::new();
    for child in children {
        let from = format!("use {child}::");
        for (at, _) in parent.match_indices(&from) {
            let items = &parent[at + from.len()..];
            let items = &items[..items.find(';').unwrap_or(items.len())];
            let names = items.split(['{', '}', ',']).map(|item| item.trim());
            brought.extend(names.filter(|name| !name.is_empty()).map(|name| (name, *child)));
        }
    }
    brought
}

/// Modules beside each other that import each other, in this folder and below. An item that their parent
/// has brought in counts as imported from where it stands.
fn mutual_imports(folder: &Path, seen: &mut usize, found: &mut Vec<String>) {
    let mut beside = BTreeMap::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        if path.is_dir() {
            mutual_imports(&path, seen, found);
            let module = path.join("mod.rs");
            if module.is_file() {
                beside.insert(name, program(&module));
            }
        } else if path.extension().is_some_and(|e| e == "rs") && name != "mod" {
            beside.insert(name, program(&path));
        }
    }
    let parents = ["mod.rs", "lib.rs"].map(|name| folder.join(name));
    let parents = parents.into_iter().chain([folder.with_extension("rs")]);
    let parent: String = parents.filter(|path| path.is_file()).map(|path| program(&path)).collect();
    let names: Vec<&str> = beside.keys().map(String::as_str).collect();
    let brought = brought_in(&parent, &names);
    let items: Vec<&str> = brought.keys().copied().collect();
    let imported: BTreeMap<&str, Vec<&str>> = beside
        .iter()
        .map(|(name, text)| {
            let mut others = imports(text, "super::", &names);
            others.extend(imports(text, "super::", &items).into_iter().map(|item| brought[item]));
            others.retain(|other| other != name);
            others.sort_unstable();
            others.dedup();
            (name.as_str(), others)
        })
        .collect();
    for (name, others) in &imported {
        *seen += others.len();
        let mutual = others.iter().filter(|other| *other > name && imported[*other].contains(name));
        found.extend(mutual.map(|other| format!("{}: {name} and {other}", folder.display())));
    }
}

#[test]
fn files_beside_each_other_do_not_import_each_other() {
    let (mut seen, mut found) = (0, Vec::new());
    for of in ["hw", "core", "rawlog", "sim", ".", "bench"] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(of).join("src");
        mutual_imports(&folder, &mut seen, &mut found);
    }
    assert!(seen > 500, "the search for imports finds almost none: {seen}");
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn modules_that_import_each_other_by_way_of_their_parent_are_found() {
    let root = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| fs::write(root.path().join(name), text).unwrap();
    write("mod.rs", "mod camera;\nmod view;\npub use view::{Shape, View};\n");
    write("camera.rs", "use super::{View, view};\npub struct Camera;\n");
    write("view.rs", "use super::camera::Camera;\npub struct View;\n");
    let (mut seen, mut found) = (0, Vec::new());
    mutual_imports(root.path(), &mut seen, &mut found);
    assert_eq!((seen, found.len()), (2, 1), "{found:?}");

    write("camera.rs", "use super::View;\npub struct Camera;\n");
    mutual_imports(root.path(), &mut seen, &mut found);
    assert_eq!(found.len(), 2, "{found:?}");

    write("view.rs", "// super::camera::Camera\npub struct View;\n");
    mutual_imports(root.path(), &mut seen, &mut found);
    assert_eq!(found.len(), 2, "{found:?}");
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
