//! The light of shots that workers measure, as the page shows it.

use std::time::{Duration, Instant};

use crate::{
    bench::{PATIENCE, Running, configuration},
    broker::Nats,
    processes::worker,
    recorded::MODEL,
};

/// Shots that are compared: the first is measured by the daemon in either case.
const COMPARED: usize = 3;

/// An image, or the status and the words of the answer.
fn image(run: &Running, path: &str) -> Result<Vec<u8>, (u16, String)> {
    let agent = ureq::Agent::config_builder().http_status_as_error(false).build();
    let answer = ureq::Agent::from(agent).get(format!("{}{path}", run.address)).call();
    let mut answer = answer.expect("an answer");
    let bytes = answer.body_mut().read_to_vec().expect("bytes");
    match answer.status().as_u16() {
        200 => Ok(bytes),
        status => Err((status, String::from_utf8_lossy(&bytes).into_owned())),
    }
}

/// The same simulated shots, measured by a worker and by a daemon alone.
#[test]
fn the_projections_of_a_workers_shots_are_those_of_one_machine() {
    let root = tempfile::tempdir().expect("a folder");
    let nats = Nats::start(root.path());
    let _worker = worker(root.path(), &nats.url(), "one", &[]);
    let run = |name: &str, more: &str| {
        let folder = root.path().join(name);
        std::fs::create_dir(&folder).expect("a folder");
        Running::start(&configuration(&folder, &format!("{MODEL}\n{more}")), &[])
    };
    let shared = run("shared", &format!("[cluster]\nurl = \"{}\"", nats.url()));
    let alone = run("alone", "");
    let (began, mut same) = (Instant::now(), 0);
    let mut shot = 1;
    while same < COMPARED {
        assert!(began.elapsed() < PATIENCE, "{same} shots were measured by both");
        let path = format!("/api/v1/results/{shot}/projections/b/xz.png");
        match (image(&shared, &path), image(&alone, &path)) {
            (Ok(theirs), Ok(ours)) => {
                assert!(theirs == ours, "shot {shot} looks otherwise");
                for name in ["a/xy", "a/xz", "a/yz", "b/xy", "b/yz"] {
                    let path = format!("/api/v1/results/{shot}/projections/{name}.png");
                    assert!(image(&shared, &path) == image(&alone, &path), "{path}");
                }
                same += 1;
                shot += 1;
            }
            // A busy machine may shed shots where one measures alone.
            (_, Err((404, words))) if words.contains("shed") => shot += 1,
            _ => std::thread::sleep(Duration::from_millis(20)),
        }
    }
    // Of the volume itself it says why it is not there.
    let volume = format!("/api/v1/results/{}/volumes/a", shot - 1);
    let (status, words) = image(&shared, &volume).expect_err("no volume");
    assert_eq!(status, 410, "{words}");
    assert!(words.contains("the worker that measured it"), "{words}");
}
