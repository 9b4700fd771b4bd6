//! A worker on a processor without the vector instructions of this one, by way of an emulator.

use std::process::Command;

use crate::{
    bench::lfpiv,
    broker::Nats,
    processes::{EMULATOR, Process, coordinator, path},
    recorded::{assert_same, copied, recorded_otherwise},
};

/// Started by the test below, in the emulator.
#[test]
#[ignore = "part of another test"]
fn names_the_vector_instructions() {
    println!("avx: {}", std::arch::is_x86_feature_detected!("avx"));
}

/// It reproduces the reference, or it would refuse the run; and its results are those of this machine, bit for bit.
#[test]
fn results_do_not_depend_on_the_vector_instructions() {
    let own = std::env::current_exe().expect("this program");
    let here =
        ["--ignored", "--exact", "--nocapture", "instructions::names_the_vector_instructions"];
    let [program, more @ ..] = EMULATOR;
    let told = Command::new(program).args(more).arg(own).args(here).output();
    let told = told.expect("qemu-x86_64: apt-get install qemu-user");
    assert!(String::from_utf8_lossy(&told.stdout).contains("avx: false"), "{told:?}");

    let root = tempfile::tempdir().expect("a folder");
    let placed = ("place_particles = false", "place_particles = true");
    let run = recorded_otherwise(&root.path().join("bench"), placed, 2);
    let here = copied(&run, &root.path().join("here"));
    assert!(lfpiv(&["process", path(&here)]).status.success());
    let nats = Nats::start(root.path());
    let url = nats.url();
    let worker = Process::emulated(root.path(), &["work", "--url", &url, "--name", "plain"]);
    let ended = coordinator(root.path(), &run, &url, &[]).wait();
    assert_eq!(ended.code, Some(0), "{ended:?}\n{}", worker.log());
    assert!(ended.stdout.contains("plain: 1 shot"), "{ended:?}");
    assert_same(&here, &run);
    assert_eq!(worker.terminate().code, Some(0));
}
