//! Each test in a network of its own: two loopback addresses, and no other test's cameras.

use std::{
    env,
    process::{Command, Stdio},
};

/// Set in the process that runs inside.
const INSIDE: &str = "LFPIV_PRIVATE_NETWORK";

/// Makes the network, two loopback addresses in it, and becomes the command that follows.
const PRIVATE_NETWORK: &str = include_str!("../../../scripts/private-network.sh");

/// Runs `body` in a private network, in a process of its own: this test binary once more, told to
/// run the one test of that name.
pub fn in_private_network(test: &str, body: impl FnOnce()) {
    if env::var_os(INSIDE).is_some() {
        return body();
    }
    let mut inside = Command::new("sh");
    inside.args(["-c", PRIVATE_NETWORK, "sh"]);
    inside.arg(env::current_exe().expect("this binary")).args([test, "--exact", "--nocapture"]);
    inside.arg("--include-ignored");
    inside.env(INSIDE, "1");
    let output = inside.output().expect("a shell");
    let words = String::from_utf8_lossy(&output.stdout);
    let errors = String::from_utf8_lossy(&output.stderr);
    println!("{words}{errors}");
    assert!(words.contains("1 passed"), "{test} failed in its private network");
}

/// This test binary once more in the same network, to run one of its ignored tests as a program
/// that can be killed.
pub fn program(test: &str) -> Command {
    assert!(env::var_os(INSIDE).is_some(), "only inside a private network");
    let mut program = Command::new(env::current_exe().expect("this binary"));
    program.args([test, "--exact", "--ignored", "--nocapture"]).stdout(Stdio::piped());
    program
}

/// Whether this process was started by [`program`], not by somebody who runs ignored tests.
pub fn is_program() -> bool {
    env::var_os(INSIDE).is_some()
}
