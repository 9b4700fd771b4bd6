//! The standing adversary: seeded campaigns of kills, damage, failing disks, floods and malformed
//! files against the real binary.
//!
//! A minute of it is part of the tests; `make soak SECONDS=3600 SEED=7` runs for an hour. The
//! random state of every case depends only on seed, campaign and number: `LFPIV_SOAK_SEED=7
//! LFPIV_SOAK_CASE=flips:123` runs one of them alone.

#[allow(dead_code)]
#[path = "../recorded_run/bench.rs"]
mod bench;
mod campaign;
mod child;
#[allow(dead_code)]
#[path = "../recorded_run/connections.rs"]
mod connections;
mod disk;
mod exported;
mod flips;
mod floods;
mod journals;
mod kills;
mod loop_disk;
mod malformed;
mod mutation;
mod read_only;
mod report;
#[allow(dead_code)]
#[path = "../recorded_run/small_disk.rs"]
mod small_disk;

use campaign::Plan;
use report::Report;
use small_disk::in_namespace_of;

/// The adversary mounts its own disks: as root in a mount namespace if loop devices are available,
/// otherwise in a user namespace, too.
#[test]
fn the_adversary_finds_nothing() {
    let as_root = rustix::process::geteuid().is_root();
    let options: &[&[&str]] = if as_root { &[&["-m"], &["-Urm"]] } else { &[&["-Urm"]] };
    let passed = options.iter().find_map(|options| in_namespace_of(options, "campaigns"));
    match passed {
        Some(passed) => assert!(passed, "see above"),
        None => campaigns(),
    }
}

#[test]
#[ignore = "the half of the_adversary_finds_nothing that runs in a namespace"]
fn campaigns() {
    let plan = Plan::from_environment();
    let mut report = Report::new(&plan);
    plan.campaign(&mut report, "kills", 0.3, kills::Kills::prepare);
    plan.campaign(&mut report, "flips", 0.15, flips::Flips::prepare);
    plan.campaign(&mut report, "journals", 0.05, journals::Journals::prepare);
    plan.campaign(&mut report, "malformed", 0.35, malformed::Malformed::prepare);
    plan.campaign(&mut report, "disk", 0.08, disk::Disks::prepare);
    plan.campaign(&mut report, "floods", 0.07, floods::Floods::prepare);
    println!("{report}");
    assert!(report.is_clean(), "the adversary has found something");
}
