//! Statistics of all shots of a run, on the page.

use crate::{
    BROWSER,
    daemon::{Daemon, READ, Scene},
    pictures,
    script::run_script,
    served::finished_run,
};

/// Enough for intervals.
const SHOTS: u64 = 12;

#[test]
fn the_page_shows_the_statistics_of_all_shots_of_a_run() {
    let _browser = BROWSER.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    let folder = tempfile::tempdir().unwrap();
    let run = finished_run(folder.path(), Scene::Body, SHOTS);
    let daemon = Daemon::serve(&run);
    let pictures = pictures().display().to_string();
    run_script("statistics.mjs", &[&daemon.url(), READ, &pictures], |asked| {
        panic!("asked for {asked}")
    });
}
