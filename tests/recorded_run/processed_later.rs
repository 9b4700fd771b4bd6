//! Shots that were shed live are measured later from the raw log.

use std::{collections::BTreeSet, fs};

use lfpiv::archive::StoredResults;

use crate::bench::{Running, configuration, images, lfpiv, text};

#[test]
fn shed_shots_are_measured_later() {
    let root = tempfile::tempdir().expect("a folder");
    // With fine voxels, fifty shots per second are too many to process.
    let config = configuration(root.path(), "");
    let slow = fs::read_to_string(&config).unwrap().replacen("queue = 4", "queue = 1", 1).replacen(
        "refinement = 2",
        "refinement = 4\npasses = 60",
        1,
    );
    fs::write(&config, slow).unwrap();
    let running = Running::start(&config, &[]);
    running.wait_until(|status| status["shots"]["shed"].as_u64() > Some(3));
    let folder = running.terminate();

    let recorded: BTreeSet<u64> = images(&folder).into_iter().map(|(shot, _)| shot).collect();
    let before = StoredResults::find(&folder).unwrap().shots;
    assert!(before.len() + 3 < recorded.len(), "{} of {}", before.len(), recorded.len());
    let output = lfpiv(&["process", folder.to_str().unwrap()]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let after = StoredResults::find(&folder).unwrap();
    assert_eq!(after.shots, recorded);
    assert_eq!(after.records, recorded.len());
    // Times increase in shot order, whenever the shots were measured.
    assert_eq!(after.times_s.len(), recorded.len());
    let times_s: Vec<f64> = after.times_s.values().copied().collect();
    assert!(times_s.is_sorted_by(|a, b| a < b), "{times_s:?}");
    let ledger = fs::read(folder.join("ledger.json")).unwrap();
    let ledger: serde_json::Value = serde_json::from_slice(&ledger).unwrap();
    let later = ledger["processed_later"].as_array().unwrap().len();
    assert_eq!(later, recorded.len() - before.len());
    assert_eq!(ledger["cameras"][0]["outcomes"]["complete"], before.len());
}
