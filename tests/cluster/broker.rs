//! A NATS server of the test's own: on a free port of this machine, with a folder of its own.

use std::{
    fs,
    net::{Ipv4Addr, TcpListener, TcpStream},
    path::{Path, PathBuf},
    process::{Child, Command, Stdio},
    time::{Duration, Instant},
};

use lfpiv::cluster::{Broker, Job, JobQueue};

use crate::bench::PATIENCE;

/// Debian has it where only root looks.
const PROGRAMS: [&str; 2] = ["/usr/sbin/nats-server", "nats-server"];

pub struct Nats {
    child: Child,
    port: u16,
    folder: PathBuf,
    more: Vec<String>,
}

impl Nats {
    pub fn start(root: &Path) -> Self {
        Self::with(root, &[])
    }

    /// The same with further arguments.
    pub fn with(root: &Path, more: &[&str]) -> Self {
        let more: Vec<String> = more.iter().map(|word| (*word).to_owned()).collect();
        let folder = root.join("broker");
        // Another program may take the port between our look and its start.
        for _ in 0..20 {
            let free = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).expect("a free port");
            let port = free.local_addr().expect("an address").port();
            drop(free);
            if let Some(child) = started(port, &folder, &more) {
                return Self { child, port, folder, more };
            }
        }
        panic!("nats-server does not start; scripts/install-broker.sh installs it");
    }

    pub fn url(&self) -> String {
        format!("nats://127.0.0.1:{}", self.port)
    }

    pub fn port(&self) -> u16 {
        self.port
    }

    /// Kills it, and removes all that it has stored.
    pub fn kill_and_forget(&mut self) {
        self.child.kill().expect("a running server");
        self.child.wait().expect("its end");
        fs::remove_dir_all(&self.folder).expect("its store");
    }

    /// Starts it anew at the same port.
    pub fn start_again(&mut self) {
        let began = Instant::now();
        loop {
            if let Some(child) = started(self.port, &self.folder, &self.more) {
                self.child = child;
                return;
            }
            assert!(began.elapsed() < PATIENCE, "port {} stays taken", self.port);
        }
    }
}

/// The server once it accepts connections; `None` if it ends.
fn started(port: u16, folder: &Path, more: &[String]) -> Option<Child> {
    let program = PROGRAMS.iter().find(|path| Path::new(path).exists()).unwrap_or(&PROGRAMS[1]);
    let mut child = Command::new(program)
        .args(["--addr", "127.0.0.1", "--port", &port.to_string(), "--jetstream", "--store_dir"])
        .arg(folder)
        .args(more)
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("nats-server: scripts/install-broker.sh installs it");
    let began = Instant::now();
    loop {
        if child.try_wait().expect("a child").is_some() {
            return None;
        }
        if TcpStream::connect((Ipv4Addr::LOCALHOST, port)).is_ok() {
            return Some(child);
        }
        assert!(began.elapsed() < PATIENCE, "nats-server does not listen");
        std::thread::sleep(Duration::from_millis(10));
    }
}

/// A failing test leaves no server behind.
impl Drop for Nats {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The first job that the broker at `url` has; it stays there.
pub fn first_job(url: &str) -> Job {
    let broker = Broker { url: url.to_owned(), ..Broker::default() };
    let runtime = tokio::runtime::Runtime::new().expect("a runtime");
    runtime.block_on(async {
        let queue = JobQueue::connect(&broker, "by hand", "").await.expect("an address");
        loop {
            match queue.take().await {
                Ok(Some(taken)) => {
                    taken.give_back(Duration::ZERO).await.expect("a broker");
                    return taken.job;
                }
                _ => tokio::time::sleep(Duration::from_millis(10)).await,
            }
        }
    })
}
