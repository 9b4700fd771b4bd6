//! Workers that nothing happens to.

use std::fs;

use lfpiv::{acquisition::journal::RecordedRun, archive::stored_particles};
use rcgen::{CertifiedKey, generate_simple_self_signed};

use crate::{
    bench::{lfpiv, text},
    broker::Nats,
    processes::{coordinator, path, worker},
    recorded::{
        SHOTS, assert_as_on_one_machine, assert_same, copied, recorded, recorded_otherwise,
    },
};

#[test]
fn workers_together_measure_what_one_machine_measures() {
    let root = tempfile::tempdir().expect("a folder");
    let run = recorded(root.path());
    let nats = Nats::start(root.path());
    // Frames from the folder of the run, from the one above it, and over HTTP.
    let workers = [
        worker(root.path(), &nats.url(), "one", &["--shared", path(&run)]),
        worker(root.path(), &nats.url(), "two", &["--shared", path(root.path())]),
        worker(root.path(), &nats.url(), "three", &["--slots", "2"]),
    ];
    let ended = coordinator(root.path(), &run, &nats.url(), &[]).wait();
    assert_eq!(ended.code, Some(0), "{ended:?}");
    assert_as_on_one_machine(&run);
    let now = format!("{SHOTS} shots recorded, 0 had a result, {SHOTS} have one now");
    assert!(ended.stdout.contains(&now), "{ended:?}");
    assert!(ended.stdout.contains("0 results refused"), "{ended:?}");
    // The coordinator has measured the shot that decides the forward model.
    let by_workers = ended.stdout.lines().filter_map(|line| line.split_once(": "));
    let by_workers = by_workers.filter(|(name, _)| ["one", "two", "three"].contains(name));
    let counts = by_workers.map(|(_, shots)| shots.split(' ').next().expect("a number"));
    assert_eq!(counts.map(|n| n.parse::<usize>().expect("a number")).sum::<usize>(), SHOTS - 1);

    // Told to stop, workers end well; a run that is complete needs none, and no broker.
    for worker in workers {
        let ended = worker.terminate();
        assert_eq!(ended.code, Some(0), "{ended:?}");
    }
    drop(nats);
    let again = coordinator(root.path(), &run, "nats://127.0.0.1:1", &[]).wait();
    assert_eq!(again.code, Some(0), "{again:?}");
    assert_as_on_one_machine(&run);
}

#[test]
fn only_what_has_no_result_is_measured_and_damaged_shots_are_lost_as_on_one_machine() {
    let root = tempfile::tempdir().expect("a folder");
    let run = recorded_otherwise(&root.path().join("bench"), ("seed = 1", "seed = 2"), 12);
    let shots = RecordedRun::open(&run).expect("a run").index().shots;
    // The images of two shots, one of which would decide the forward model.
    for shot in [0, 7] {
        let place = shots[&shot].frames[1][0];
        let segment = run.join(format!("raw/segment_{:06}.raw", place.segment));
        let mut bytes = fs::read(&segment).expect("a segment");
        bytes[place.offset as usize + 5000] ^= 1;
        fs::write(&segment, bytes).expect("a segment");
    }
    let part = root.path().join("part");
    let half = lfpiv(&["process", path(&run), "--part", "2/2", "--out", path(&part)]);
    assert_eq!(half.status.code(), Some(3), "{}", text(&half.stderr));
    for entry in fs::read_dir(&part).expect("results") {
        let entry = entry.expect("an entry");
        if entry.file_name().to_string_lossy().starts_with(['v', 's']) {
            fs::copy(entry.path(), run.join(entry.file_name())).expect("a copy");
        }
    }
    let at_once = copied(&run, &root.path().join("at_once"));
    let output = lfpiv(&["process", path(&at_once)]);
    assert_eq!(output.status.code(), Some(3), "{}", text(&output.stderr));

    let nats = Nats::start(root.path());
    let _worker = worker(root.path(), &nats.url(), "one", &[]);
    let ended = coordinator(root.path(), &run, &nats.url(), &[]).wait();
    assert_eq!(ended.code, Some(3), "{ended:?}");
    assert!(ended.stderr.contains("shot 0") && ended.stderr.contains("shot 7"), "{ended:?}");
    assert_same(&at_once, &run);
}

#[test]
fn placed_particles_come_with_their_shots() {
    let root = tempfile::tempdir().expect("a folder");
    let placed = ("place_particles = false", "place_particles = true");
    let run = recorded_otherwise(&root.path().join("bench"), placed, 4);
    let at_once = copied(&run, &root.path().join("at_once"));
    let output = lfpiv(&["process", path(&at_once)]);
    assert!(output.status.success(), "{}", text(&output.stderr));
    let particles = stored_particles(&at_once).expect("particles");
    assert!(particles.len() > 2 && particles.values().all(|shot| !shot.is_empty()));

    let nats = Nats::start(root.path());
    let worker = worker(root.path(), &nats.url(), "one", &[]);
    let ended = coordinator(root.path(), &run, &nats.url(), &[]).wait();
    assert_eq!(ended.code, Some(0), "{ended:?}");
    assert_same(&at_once, &run);
    assert_eq!(worker.terminate().code, Some(0));
}

#[test]
fn a_broker_with_a_password_and_a_certificate_is_used_as_it_demands() {
    let root = tempfile::tempdir().expect("a folder");
    let run = recorded_otherwise(&root.path().join("bench"), ("seed = 1", "seed = 3"), 3);
    let at_once = copied(&run, &root.path().join("at_once"));
    assert!(lfpiv(&["process", path(&at_once)]).status.success());
    let CertifiedKey { cert, signing_key } =
        generate_simple_self_signed(["127.0.0.1".to_owned()]).expect("a certificate");
    let [certificate, key] = ["cert.pem", "key.pem"].map(|name| root.path().join(name));
    fs::write(&certificate, cert.pem()).expect("a file");
    fs::write(&key, signing_key.serialize_pem()).expect("a file");
    let secured = ["--tls", "--tlscert", path(&certificate), "--tlskey", path(&key)];
    let nats =
        Nats::with(root.path(), &[&secured[..], &["--user", "me", "--pass", "secret"]].concat());
    let authority = ["--authority", path(&certificate)];

    let right = format!("tls://me:secret@127.0.0.1:{}", nats.port());
    let wrong = format!("tls://me:guess@127.0.0.1:{}", nats.port());
    // Neither with another password nor without the certificate.
    for (url, more) in [(&wrong, &authority[..]), (&right, &[])] {
        let stranger = worker(root.path(), url, "stranger", more).wait();
        assert_eq!(stranger.code, Some(1), "{stranger:?}");
        assert!(
            stranger.stderr.contains("cannot connect to the broker at tls://127"),
            "{stranger:?}"
        );
        assert!(!stranger.stderr.contains("guess"), "{stranger:?}");
    }
    let trusting = worker(root.path(), &right, "one", &authority);
    let ended = coordinator(root.path(), &run, &right, &authority).wait();
    assert_eq!(ended.code, Some(0), "{ended:?}");
    assert!(ended.stdout.contains("one: 2 shots"), "{ended:?}");
    assert!(!ended.stderr.contains("secret"), "{ended:?}");
    assert_same(&at_once, &run);
    let said = trusting.terminate();
    assert!(said.code == Some(0) && !(said.stderr + &said.stdout).contains("secret"));
}
