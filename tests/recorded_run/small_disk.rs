//! Disks of a test's own, in a namespace in which it may mount them.

use std::{
    fs,
    path::Path,
    process::{Command, Stdio},
};

/// Runs this test's other half in a namespace in which it may mount a small disk of its own.
pub fn in_namespace(test: &str) -> Option<bool> {
    let done = in_namespace_of(&["-Urm"], test);
    if done.is_none() {
        eprintln!("skipped: this machine lets nobody mount in a namespace (unshare -Urm)");
    }
    done
}

/// The same in a namespace made by `unshare` with these options; nothing where that is not allowed.
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

/// A disk in memory, of so many megabytes.
pub fn mount_small_disk(at: &Path, megabytes: u32) {
    fs::create_dir_all(at).expect("a folder");
    let size = format!("size={megabytes}m");
    let mounted = Command::new("mount").args(["-t", "tmpfs", "-o", &size, "none"]).arg(at).status();
    assert!(mounted.expect("mount").success());
}
