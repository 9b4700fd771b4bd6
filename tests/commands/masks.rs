//! `[volume.mask]`: what is refused and how, and what `lfpiv check` says of it.

use std::{fs, path::Path};

use lfpiv::config::{Config, ConfigFile};

use crate::{
    body::cylinder,
    support::{Done, changed_configuration, lfpiv},
};

/// The small bench, 2.4 x 2 x 1.6 mm, with this mask.
fn masked(folder: &Path, mask: &str) -> std::path::PathBuf {
    changed_configuration(folder, "voxel_mm = 0.1", &format!("voxel_mm = 0.1\nmask = {mask}"))
}

fn check(folder: &Path, mask: &str) -> Done {
    let config = masked(folder, mask);
    lfpiv(["check".as_ref(), "--quick".as_ref(), "--config".as_ref(), config.as_os_str()])
}

#[test]
fn check_says_how_much_is_flow() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("body.stl"), cylinder([0.5, 0.0], 0.4)).unwrap();
    let done = check(folder.path(), "{ leave_out = [{ stl = \"body.stl\" }] }");
    assert!(done.success, "{}", done.stderr);
    // A cylinder of 0.4 mm radius in 2.4 x 2 mm: 10.5 %.
    for said in
        ["mask           89.", "% of the volume is flow, body.stl with 96 triangles", "in the flow"]
    {
        assert!(done.stdout.contains(said), "{said}: {}", done.stdout);
    }
    let half = "{ keep = [{ low_mm = [-9, -9, -9], high_mm = [0, 9, 9] }] }";
    let done = check(folder.path(), half);
    assert!(
        done.success && done.stdout.contains("50.0 % of the volume is flow"),
        "{}",
        done.stdout
    );
    let none = "{ leave_out = [{ low_mm = [-1.15, -9, -9], high_mm = [9, 9, 9] }] }";
    let done = check(folder.path(), none);
    assert!(done.stdout.contains("no vector will be measured"), "{}", done.stdout);
    let thin = "{ leave_out = [{ low_mm = [-0.4, -9, -9], high_mm = [-0.1, 9, 9] }] }";
    let done = check(folder.path(), thin);
    assert!(
        done.stdout.contains("next to a body that is thinner than a window"),
        "{}",
        done.stdout
    );
}

#[test]
fn a_mask_that_cannot_be_is_refused_with_its_key() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    let whole = cylinder([0.0, 0.0], 0.5);
    write("text.stl", "a drawing");
    write("cut.stl", &whole[..whole.len() / 2]);
    write("open.stl", &whole.replacen(facet(&whole), "", 1));
    write("far.stl", &cylinder([50.0, 0.0], 0.5));
    write("thin.stl", &cylinder([0.0, 0.0], 0.01));
    write("body.stl", &whole);
    let stl = |name: &str| format!("{{ leave_out = [{{ stl = \"{name}\" }}] }}");
    for (mask, key, said) in [
        (stl("none.stl"), "leave_out[0].stl", "it cannot be read: No such file"),
        (stl("."), "leave_out[0].stl", "it is not a regular file"),
        (stl("text.stl"), "leave_out[0].stl", "it is no STL file"),
        (stl("cut.stl"), "leave_out[0].stl", "a part of one"),
        (stl("open.stl"), "leave_out[0].stl", "it is not closed: 3 edges have no second triangle"),
        (stl("far.stl"), "leave_out[0].stl", "it lies outside the volume"),
        (stl("thin.stl"), "leave_out[0].stl", "it contains the centre of no voxel"),
        ("{}".into(), "mask", "the mask has no region"),
        (
            "{ keep = [{ stl = \"body.stl\" }, {}] }".into(),
            "keep[1]",
            "either stl, or low_mm and high_mm",
        ),
        (
            "{ keep = [{ low_mm = [0, 0, 0] }] }".into(),
            "keep[0]",
            "either stl, or low_mm and high_mm",
        ),
        (
            "{ keep = [{ low_mm = [0, 0, 0], high_mm = [1, 0, 1] }] }".into(),
            "keep[0].high_mm",
            "more than low_mm along every axis",
        ),
        (
            "{ keep = [{ low_mm = [0, 0, nan], high_mm = [1, 1, 1] }] }".into(),
            "low_mm[2]",
            "allowed",
        ),
        ("{ leave = [] }".into(), "volume.mask.leave", "unknown key; allowed: keep or leave_out"),
        (
            "{ leave_out = [{ low_mm = [-9, -9, -9], high_mm = [9, 9, 9] }] }".into(),
            "volume.mask",
            "it leaves nothing",
        ),
    ] {
        let done = check(folder.path(), &mask);
        let refusal = done.stderr.lines().find(|line| line.contains("changed.toml:"));
        let refusal = refusal.unwrap_or_else(|| panic!("{mask}: {}{}", done.stdout, done.stderr));
        assert!(
            !done.success && refusal.contains(key) && refusal.contains(said),
            "{mask}: {refusal}"
        );
    }
}

/// The first triangle of an ASCII file.
fn facet(text: &str) -> &str {
    let (start, end) = (text.find("facet").unwrap(), "endfacet\n");
    &text[start..text.find(end).unwrap() + end.len()]
}

#[test]
fn the_stored_text_holds_the_mask_and_its_files_hash() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("body.stl"), cylinder([0.0, 0.0], 0.5)).unwrap();
    let path = masked(folder.path(), "{ leave_out = [{ stl = \"body.stl\" }] }");
    let loaded = ConfigFile::load(&path).unwrap();
    fs::remove_file(folder.path().join("body.stl")).unwrap();
    // As a run stores it, and as a file of its own.
    let stored = Config::parse("stored", &loaded.text).unwrap();
    assert_eq!(stored.measurement(), loaded.config.measurement());
    fs::write(&path, &loaded.text).unwrap();
    assert_eq!(ConfigFile::load(&path).unwrap().config.measurement(), stored.measurement());
    assert_eq!(ConfigFile::load(&path).unwrap().text, loaded.text);
    assert_eq!(stored.mask.as_ref().unwrap().files[0].sha256.len(), 64);
    // For another volume it is not that mask.
    let other = loaded.text.replacen("voxels = [24, 20, 16]", "voxels = [20, 20, 16]", 1);
    let refusal = Config::parse("stored", &other).unwrap_err().to_string();
    assert!(refusal.contains("made for another [volume]"), "{refusal}");
}

/// Simulated particles stay out of the body, unless they are asked for.
#[test]
fn simulated_particles_stay_out_of_what_is_masked() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("body.stl"), cylinder([0.3, 0.0], 0.6)).unwrap();
    let path = masked(folder.path(), "{ leave_out = [{ stl = \"body.stl\" }] }");
    let mut config = ConfigFile::load(&path).unwrap().config;
    let inside = |config: &Config| {
        let scene = config.simulation.clone().unwrap();
        let truth = scene.truth(&config.bench_geometry(), 1, 0);
        let seen = truth.particles.iter().filter(|particle| particle.visible_a);
        seen.filter(|particle| (particle.a_mm[0] - 0.3).hypot(particle.a_mm[1]) < 0.59).count()
    };
    assert_eq!(inside(&config), 0);
    config.simulation.as_mut().unwrap().particles_in_mask = true;
    assert!(inside(&config) > 10);
}
