//! Small disks for tests, mounted in a namespace.

use std::{
    fs,
    path::Path,
    process::{Command, Stdio},
};

/// Runs the other half of this test in a namespace in which it may mount a small disk.
pub fn in_namespace(test: &str) -> Option<bool> {
    let done = in_namespace_of(&["-Urm"], test);
    if done.is_none() {
        eprintln!("skipped: mounting in a user namespace is not permitted here (unshare -Urm)");
    }
    done
}

/// The same in a namespace created by `unshare` with these options; `None` if that is not permitted.
pub fn in_namespace_of(options: &[&str], test: &str) -> Option<bool> {
    let unshare = || {
        let mut command = Command::new("unshare");
        command.args(options);
        command
    };
    let probe = unshare().arg("true").stderr(Stdio::null()).status();
    if !probe.is_ok_and(|status| status.success()) {
        return None;
    }
    let own = std::env::current_exe().expect("the test's own path");
    let status = unshare()
        .arg(own)
        .args(["--exact", test, "--ignored", "--nocapture"])
        .status()
        .expect("unshare");
    Some(status.success())
}

/// Mounts a tmpfs of this many megabytes.
pub fn mount_small_disk(at: &Path, megabytes: u32) {
    fs::create_dir_all(at).expect("a folder");
    let size = format!("size={megabytes}m");
    let mounted = Command::new("mount").args(["-t", "tmpfs", "-o", &size, "none"]).arg(at).status();
    assert!(mounted.expect("mount").success());
}
