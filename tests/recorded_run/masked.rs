//! A run whose volume has a mask: what it was measured with is in the run, and needs no file.

// All of this is test; clippy's exception covers only the functions marked as such.
#![allow(clippy::unwrap_used)]

use std::{
    fs,
    path::{Path, PathBuf},
};

use lfpiv::{
    archive::{StoredResults, StoredShot, StoredShots},
    config::Config,
};
use lfpiv_core::velocimetry::VectorStatus;

use crate::{
    bench::{configuration, finished_run, lfpiv, text},
    body::cylinder,
};

const SHOTS: &str = "4";

/// A run with a cylinder in a corner of the volume, whose file is gone since.
fn masked_run(root: &Path) -> PathBuf {
    let config = configuration(root, "");
    let body = root.join("bodies/body.stl");
    fs::create_dir_all(body.parent().unwrap()).unwrap();
    fs::write(&body, cylinder([0.3, 0.3], 0.2)).unwrap();
    let mask = "voxel_mm = 0.1\nmask = { leave_out = [{ stl = \"bodies/body.stl\" }] }";
    let masked = fs::read_to_string(&config).unwrap().replacen("voxel_mm = 0.1", mask, 1);
    // 27 vectors, three of them in the body.
    let changes = [
        ("voxels = [8, 8, 8]", "voxels = [12, 12, 12]"),
        ("window_mm = 0.8", "window_mm = 0.6"),
        ("ppm = 0.5", "ppm = 2.0"),
    ];
    let masked = changes.iter().fold(masked, |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    });
    fs::write(&config, masked).unwrap();
    let run = finished_run(&config, SHOTS);
    fs::remove_file(&body).unwrap();
    run
}

fn shots(run: &Path) -> Vec<StoredShot> {
    let mut found = Vec::new();
    let take = |shot| -> Result<(), lfpiv::archive::ArchiveError> {
        found.push(shot);
        Ok(())
    };
    StoredShots::find(run).unwrap().for_each(take).unwrap();
    found
}

fn succeeds(arguments: &[&str]) -> String {
    let output = lfpiv(arguments);
    let said = text(&output.stdout);
    assert!(output.status.success(), "{arguments:?}: {said}{}", text(&output.stderr));
    said
}

#[test]
fn a_masked_run_is_replayed_and_measured_again_without_the_files() {
    let root = tempfile::tempdir().unwrap();
    let run = masked_run(root.path());
    let path = run.to_str().unwrap();

    let measured = shots(&run);
    assert_eq!(measured.len().to_string(), SHOTS);
    for shot in &measured {
        for (n, status) in shot.status.iter().enumerate() {
            let [x, y, _] = shot.grid.position_mm(n);
            let is_inside = (x - 0.3).hypot(y - 0.3) < 0.2;
            assert_eq!(*status == VectorStatus::Masked, is_inside, "{x} {y}");
            let missing = shot.velocity_m_s[n].iter().all(|speed| speed.is_nan());
            assert_eq!(missing, !status.has_value(), "{status:?}");
        }
        assert!(shot.status.contains(&VectorStatus::Masked));
        assert!(shot.status.contains(&VectorStatus::Valid));
    }
    let stored = StoredShots::find(&run).unwrap().configuration().unwrap();
    let kept = Config::parse("stored", &stored).unwrap().mask.unwrap();
    assert_eq!(kept.files[0].file, Path::new("bodies/body.stl"));
    assert!(kept.mask.flow_share() < 1.0);

    let out = root.path().join("again");
    let said = succeeds(&["replay", "--speed", "max", "--out", out.to_str().unwrap(), path]);
    assert!(said.contains("0 different") && said.contains("ledgers are the same"), "{said}");

    // Measured later, and in parts that are merged.
    let results = || StoredResults::find(&run).unwrap().shots.len().to_string();
    let remove_results = || {
        for entry in fs::read_dir(&run).unwrap() {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_str().unwrap();
            if name.starts_with("velocity") || name.starts_with("shot_") {
                fs::remove_file(&path).unwrap();
            }
        }
    };
    let bits = |shots: &[StoredShot]| -> Vec<(Vec<u32>, Vec<VectorStatus>)> {
        let bits = |shot: &StoredShot| {
            shot.velocity_m_s.as_flattened().iter().map(|speed| speed.to_bits()).collect()
        };
        shots.iter().map(|shot| (bits(shot), shot.status.clone())).collect()
    };
    remove_results();
    succeeds(&["process", path]);
    assert_eq!(results(), SHOTS);
    assert_eq!(bits(&shots(&run)), bits(&measured));
    remove_results();
    let parts = ["1/2", "2/2"].map(|part| {
        let out = root.path().join(part.replace('/', "_of_"));
        succeeds(&["process", path, "--part", part, "--out", out.to_str().unwrap()]);
        out.to_str().unwrap().to_owned()
    });
    succeeds(&["process", path, "--merge", &parts[0], &parts[1]]);
    assert_eq!(bits(&shots(&run)), bits(&measured));

    // Masked places have no statistics, and are named in exports.
    succeeds(&["statistics", path]);
    let csv = root.path().join("csv");
    succeeds(&["export", path, "--out", csv.to_str().unwrap(), "--format", "csv"]);
    let file = fs::read_dir(&csv).unwrap().next().unwrap().unwrap().path();
    let table = fs::read_to_string(file).unwrap();
    let column = table.lines().next().unwrap().split(',').position(|name| name == "masked");
    let masked =
        table.lines().skip(1).filter(|line| line.split(',').nth(column.unwrap()) == Some("1"));
    let expected =
        measured[0].status.iter().filter(|status| **status == VectorStatus::Masked).count();
    assert_eq!(masked.count(), expected);
}
