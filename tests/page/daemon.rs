//! The real program on a simulated bench, with tokens and both permissions to arm.

use std::{
    fs,
    io::{BufRead, BufReader},
    os::unix::fs::PermissionsExt,
    path::{Path, PathBuf},
    process::{Child, Command, ExitStatus, Stdio},
};

use serde_json::Value;

use crate::body::cylinder;

pub const READ: &str = "9c27d5f01ab8463e70c1f94d2e58b6a3";
pub const CONTROL: &str = "Zr8+qT1/vXo2Lk9wBe5HdM==";

/// The body that masks a part of the volume, beside the configuration.
pub const BODY: &str = "body.stl";

/// What stands in the volume: the two exclude each other.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Scene {
    /// A body in a corner, which a mask leaves out.
    Body,
    /// Flow alone, whose particles are placed in the images.
    Placed,
    /// Flow alone.
    Flow,
}

pub struct Daemon {
    child: Child,
    pub port: u16,
}

impl Daemon {
    /// A run without end; port 0 takes any.
    pub fn start(folder: &Path, port: u16, scene: Scene) -> Self {
        Self::run(&configuration(folder, port, scene))
    }

    /// The same of any configuration.
    pub fn run(configuration: &Path) -> Self {
        Self::of(lfpiv(&["run", "--remote-arming", "--config"]).arg(configuration))
    }

    /// A run that is over, on any port.
    pub fn serve(run: &Path) -> Self {
        Self::of(lfpiv(&["serve", "--address", "127.0.0.1:0"]).arg(run))
    }

    fn of(command: &mut Command) -> Self {
        let mut child = command.stdout(Stdio::piped()).spawn().unwrap();
        let mut lines = BufReader::new(child.stdout.take().unwrap()).lines();
        let address = lines.find_map(|line| {
            let line = line.unwrap();
            let rest = line.split("127.0.0.1:").nth(1)?;
            rest.split('/').next().unwrap().parse().ok()
        });
        // What it says of shots is nobody's here, but must be read.
        std::thread::spawn(move || lines.for_each(drop));
        Self { child, port: address.expect("the daemon names its address") }
    }

    pub fn url(&self) -> String {
        format!("http://127.0.0.1:{}", self.port)
    }

    pub fn get(&self, path: &str) -> Value {
        let answer = ureq::get(format!("{}{path}", self.url()))
            .header("Authorization", format!("Bearer {READ}"))
            .call();
        answer.unwrap().body_mut().read_json().unwrap()
    }

    /// The status of the answer to a POST with a token that may control.
    pub fn post(&self, path: &str, body: &str) -> u16 {
        let agent = ureq::Agent::config_builder().http_status_as_error(false).build();
        let answer = ureq::Agent::from(agent)
            .post(format!("{}{path}", self.url()))
            .header("Authorization", format!("Bearer {CONTROL}"))
            .header("Content-Type", "application/json")
            .send(body);
        answer.unwrap().status().as_u16()
    }

    /// Asks it to end, and waits until it has.
    pub fn terminate(&mut self) -> ExitStatus {
        let terminate = format!("kill -TERM {}", self.child.id());
        assert!(Command::new("sh").args(["-c", &terminate]).status().unwrap().success());
        self.child.wait().unwrap()
    }

    /// Ends it as a power cut would.
    pub fn kill(&mut self) {
        self.child.kill().unwrap();
        self.child.wait().unwrap();
    }
}

impl Drop for Daemon {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The program, with these arguments.
pub fn lfpiv(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_lfpiv"));
    command.args(arguments);
    command
}

/// The folder of the only run.
pub fn only_run(folder: &Path) -> PathBuf {
    let runs = fs::read_dir(folder.join("results")).unwrap();
    let runs: Vec<PathBuf> = runs.map(|run| run.unwrap().path()).collect();
    assert_eq!(runs.len(), 1, "{runs:?}");
    runs.into_iter().next().unwrap()
}

/// A small bench with tokens, and arming allowed.
pub fn configuration(folder: &Path, port: u16, scene: Scene) -> PathBuf {
    let tokens = folder.join("tokens");
    fs::write(&tokens, format!("read {READ}\ncontrol {CONTROL}\n")).unwrap();
    fs::set_permissions(&tokens, PermissionsExt::from_mode(0o600)).unwrap();
    let small = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/small.toml");
    let text = fs::read_to_string(small).unwrap();
    let server = format!(
        "address = \"127.0.0.1:{port}\"\ntokens = {tokens:?}\nremote_arming = true\nrequests_per_s = 500.0"
    );
    let shown = match scene {
        Scene::Body => Some((
            "centre_mm = [0.0, 0.0, 0.0]",
            "centre_mm = [0.0, 0.0, 0.0]\nmask = { leave_out = [{ stl = \"body.stl\" }] }",
        )),
        Scene::Placed => Some(("place_particles = false", "place_particles = true")),
        Scene::Flow => None,
    };
    let changes = [
        ("address = \"127.0.0.1:0\"", server.as_str()),
        ("dir = \"results\"", &format!("dir = {:?}", folder.join("results"))),
        // More would be shed, and take the browser's processors.
        ("rate_hz = 10.0", "rate_hz = 1.0"),
        // A flow with something to see in it.
        ("kind = \"uniform\"", "kind = \"abc\"\nwavelength_mm = 2.4\namplitude_m_s = 0.6"),
        ("velocity_m_s = [1.0, -0.5, 0.25]", ""),
    ];
    let text = changes.iter().chain(&shown).fold(text, |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    });
    fs::write(folder.join(BODY), cylinder([0.8, 0.6], 0.5)).unwrap();
    let configuration = folder.join("page.toml");
    fs::write(&configuration, text).unwrap();
    configuration
}
