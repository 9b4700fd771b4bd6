//! Scripts that drive a browser, and ask the test for things meanwhile.

use std::{
    io::{BufRead, BufReader, Write},
    path::PathBuf,
    process::{Command, Stdio},
};

/// The page's sources.
pub fn page_folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("web/bench")
}

/// Node, in the page's folder, where its packages are.
pub fn node() -> Command {
    let packages = page_folder().join("node_modules");
    assert!(packages.is_dir(), "{} is missing: make page-tools", packages.display());
    let mut node = Command::new("node");
    node.current_dir(page_folder());
    node
}

/// Runs a script of `web/bench/test` to its end. Its line `ask SOMETHING` is answered by `answer`.
pub fn run_script(name: &str, arguments: &[&str], mut answer: impl FnMut(&str) -> String) {
    let mut child = node()
        .arg(format!("test/{name}"))
        .args(arguments)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("node starts: make page-tools installs it");
    let mut input = child.stdin.take().unwrap();
    for line in BufReader::new(child.stdout.take().unwrap()).lines() {
        let line = line.unwrap();
        match line.strip_prefix("ask ") {
            Some(asked) => writeln!(input, "{}", answer(asked)).unwrap(),
            None => println!("{name}: {line}"),
        }
    }
    assert!(child.wait().unwrap().success(), "{name} has failed");
}
