//! Particles placed in the images of a run, on the page while it takes shots and when it is over.

use crate::{
    BROWSER,
    daemon::{Daemon, READ, Scene, only_run},
    pictures,
    script::run_script,
};

#[test]
fn placed_particles_are_seen_during_a_run_and_afterwards() {
    let _browser = BROWSER.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    let folder = tempfile::tempdir().unwrap();
    let pictures = pictures().display().to_string();
    let mut daemon = Daemon::start(folder.path(), 0, Scene::Placed);
    run_script("placed.mjs", &[&daemon.url(), READ, &pictures], |asked| {
        panic!("asked for {asked}")
    });
    assert!(daemon.terminate().success());
    let run = only_run(folder.path());
    assert!(run.join("particles_000000.nc").is_file());

    let daemon = Daemon::serve(&run);
    let shots = daemon.get("/api/v1/shots?limit=60");
    let measured =
        shots["shots"].as_array().unwrap().iter().filter(|shot| !shot["vectors"].is_null());
    let last = measured.filter_map(|shot| shot["shot"].as_u64()).max().unwrap().to_string();
    run_script("placed.mjs", &[&daemon.url(), READ, &pictures, &last], |asked| {
        panic!("asked for {asked}")
    });
}
