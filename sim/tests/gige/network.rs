//! Each test in a network of its own: two loopback addresses, and no other test's cameras.

use std::{
    env,
    process::{Command, Stdio},
};

/// Set in the process that runs inside.
const INSIDE: &str = "LFPIV_PRIVATE_NETWORK";

/// Makes a loopback interface with two addresses, then becomes the command that follows. Where the
/// kernel can do it, the interface has a line's rate: without that, a frame larger than the receive
/// buffer arrives faster than anybody can take it.
const SET_UP: &str = "ip link set lo up && ip addr add 127.0.0.2/8 dev lo && \
    { tc qdisc add dev lo root tbf rate 2500mbit burst 256kb limit 64mb 2>/dev/null; exec \"$@\"; }";

/// Runs `body` in a private network, in a process of its own: this test binary once more, told to
/// run the one test of that name.
pub fn in_private_network(test: &str, body: impl FnOnce()) {
    if env::var_os(INSIDE).is_some() {
        return body();
    }
    let mut inside = private(&format!("{SET_UP} 2>&1"));
    inside.arg(env::current_exe().expect("this binary")).args([test, "--exact", "--nocapture"]);
    inside.arg("--include-ignored");
    inside.env(INSIDE, "1");
    let output = inside.output().expect("`unshare` (package util-linux) is needed");
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

/// `sh -c script` in a new network: as a user with a user namespace, as root also without.
fn private(script: &str) -> Command {
    let works = |options: &[&str]| {
        let tried = Command::new("unshare")
            .args(options)
            .args(["sh", "-c", "ip link set lo up"])
            .stderr(Stdio::null())
            .status();
        tried.is_ok_and(|status| status.success())
    };
    let options = [["-rn"].as_slice(), ["-n"].as_slice()];
    let Some(options) = options.into_iter().find(|options| works(options)) else {
        panic!(
            "a private network cannot be made: install util-linux (unshare) and iproute2 (ip), and \
             either allow user namespaces (sysctl kernel.unprivileged_userns_clone=1, \
             kernel.apparmor_restrict_unprivileged_userns=0) or run as root with CAP_SYS_ADMIN"
        );
    };
    let mut command = Command::new("unshare");
    command.args(options).args(["sh", "-c", script, "sh"]);
    command
}
