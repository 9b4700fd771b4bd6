//! A host that is killed: the unit ends the burst, and the port can be opened again.

use std::{
    env,
    process::{Command, Stdio},
    thread,
    time::Duration,
};

use lfpiv_hw::device::SynchroniserState;

use crate::bench::{Bench, open, schedule, timing, wait_until};

const PORT: &str = "LFPIV_TEST_PORT";
const SHOTS: u64 = 60;

/// The host: renews bursts until it is killed. Run by the test below in a process of its own.
#[test]
#[ignore = "is run by another test"]
fn host_that_renews_bursts() {
    let Ok(port) = env::var(PORT) else { return };
    let mut settings = Bench::usual().settings();
    settings.port = port;
    let mut unit = open(&settings, &timing()).unwrap();
    unit.program(&schedule()).unwrap();
    loop {
        unit.fire(SHOTS).unwrap();
        while unit.state().unwrap() == SynchroniserState::Firing {
            thread::sleep(Duration::from_millis(5));
        }
    }
}

#[test]
fn after_a_kill_no_more_than_the_burst_under_way_comes_out() {
    let bench = Bench::usual();
    let mut host = Command::new(env::current_exe().unwrap())
        .args(["--exact", "killed::host_that_renews_bursts", "--ignored"])
        .env(PORT, bench.served.path())
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    wait_until("the second burst", || bench.q_switch_pulses()[0] > SHOTS + 10);
    host.kill().unwrap();
    host.wait().unwrap();
    let at_the_kill = bench.q_switch_pulses()[0];
    wait_until("end of the burst", || !bench.served.unit().is_running());
    let [first, second] = bench.q_switch_pulses();
    assert!(first - at_the_kill <= SHOTS, "{} pulses after the kill", first - at_the_kill);
    assert_eq!((first % SHOTS, first), (0, second), "bursts were whole");
    thread::sleep(Duration::from_millis(100));
    assert_eq!(bench.q_switch_pulses()[0], first);
    // The next host finds the port free and the unit obedient.
    let (mut unit, _) = bench.connect();
    assert_eq!(unit.state().unwrap(), SynchroniserState::Safe);
}
