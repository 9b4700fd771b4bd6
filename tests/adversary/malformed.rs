//! Malformed input files: configurations, images, volumes, tokens.

use std::{
    fs,
    os::unix::fs::PermissionsExt,
    path::{Path, PathBuf},
};

use rand::RngExt;
use tempfile::TempDir;

use crate::{
    bench::{configuration, lfpiv},
    campaign::{Campaign, Case},
    connections::with_tokens,
    exported::argument,
    mutation::{Damage, spoiled},
    report::FaultKind,
};

/// Memory limit: no file of some kilobytes is worth more.
const MOST_BYTES: u64 = 4 << 30;

/// See the module.
pub struct Malformed {
    root: TempDir,
    config: PathBuf,
    with_tokens: PathBuf,
    image: Vec<u8>,
    volumes: Vec<u8>,
    tokens: String,
}

impl Malformed {
    /// Makes a file of each kind.
    pub fn prepare() -> Self {
        let root = tempfile::tempdir().expect("a folder");
        let folder = |name: &str| {
            let folder = root.path().join(name);
            fs::create_dir_all(&folder).expect("a folder");
            folder
        };
        let config = configuration(&folder("plain"), "");
        let with_tokens = with_tokens(&folder("guarded"));
        let pairs = root.path().join("pairs");
        let simulate =
            ["simulate", "--config", argument(&config), "--out", argument(&pairs), "--shots", "1"];
        assert!(lfpiv(&simulate).status.success());
        let pair = pairs.join("shot_0000");
        let image = fs::read(pair.join("cam1_a.tif")).expect("an image");
        let out = root.path().join("measured");
        let process = ["process", "--save-volumes", "--config", argument(&config), "--out"];
        let measured = lfpiv(&[&process[..], &[argument(&out), argument(&pair)]].concat());
        assert!(measured.status.success(), "{measured:?}");
        let volumes = fs::read(out.join("shot_0000/volumes.nc")).expect("volumes");
        let tokens = fs::read_to_string(with_tokens.with_file_name("tokens")).expect("tokens");
        Self { root, config, with_tokens, image, volumes, tokens }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.root.path().join(name)
    }

    fn configuration(&self, case: &mut Case<'_>) {
        let text = fs::read_to_string(&self.config).expect("the configuration");
        let path = self.path("spoiled.toml");
        fs::write(&path, spoiled(&text, &mut case.random)).expect("a file");
        self.refused_or_done(case, &["check", "--quick", "--config", argument(&path)], &path);
    }

    fn image(&self, case: &mut Case<'_>) {
        let pair = self.path("pairs/shot_0000");
        let path = pair.join("cam1_a.tif");
        write_damaged(case, &path, &self.image);
        let out = self.path("out");
        let _ = fs::remove_dir_all(&out);
        let paths = [&self.config, &out, &pair].map(|path| argument(path));
        let [config, out, pair] = paths;
        self.refused_or_done(case, &["process", "--config", config, "--out", out, pair], &path);
    }

    fn volumes(&self, case: &mut Case<'_>) {
        let (path, out) = (self.path("volumes.nc"), self.path("correlated"));
        write_damaged(case, &path, &self.volumes);
        let [config, out, volumes] = [&self.config, &out, &path].map(|path| argument(path));
        self.refused_or_done(
            case,
            &["correlate", "--config", config, "--out", out, volumes],
            &path,
        );
    }

    fn tokens(&self, case: &mut Case<'_>) {
        let path = self.with_tokens.with_file_name("tokens");
        fs::write(&path, spoiled(&self.tokens, &mut case.random)).expect("a file");
        fs::set_permissions(&path, PermissionsExt::from_mode(0o600)).expect("its mode");
        let config = argument(&self.with_tokens);
        self.refused_or_done(case, &["run", "--shots", "1", "--config", config], &path);
        let _ = fs::remove_dir_all(self.path("guarded/results"));
    }

    /// Checks that the command succeeded, or that it named the file.
    fn refused_or_done(&self, case: &mut Case<'_>, arguments: &[&str], file: &Path) {
        let ended = case.lfpiv(arguments);
        let name = file.file_name().unwrap_or_default().to_string_lossy();
        let is_named = ended.stderr.contains(&*name) || ended.stdout.contains(&*name);
        if ended.code == Some(1) && !is_named {
            let words = ended.last_words();
            case.fault(FaultKind::Unreported, format!("{name} is not named: {words}"));
        }
        if ended.peak_bytes > MOST_BYTES {
            let mb = ended.peak_bytes >> 20;
            case.fault(FaultKind::Wrong, format!("{name} took {mb} MB: {}", ended.last_words()));
        }
    }
}

fn write_damaged(case: &mut Case<'_>, path: &Path, whole: &[u8]) {
    let mut bytes = whole.to_vec();
    for _ in 0..case.random.random_range(1..4) {
        // Headers are at the ends of files.
        let edge = 600.min(bytes.len());
        let (before, after) = match case.random.random_range(0..3) {
            0 => (0, bytes.len() - edge),
            1 => (bytes.len() - edge, 0),
            _ => (0, 0),
        };
        let end = bytes.len() - after;
        let part = bytes[before..end].to_vec();
        let part = Damage::any(&mut case.random).of(part, &mut case.random).unwrap_or_default();
        bytes.splice(before..end, part);
    }
    fs::write(path, bytes).expect("a damaged file");
}

impl Campaign for Malformed {
    fn run(&mut self, case: &mut Case<'_>) {
        case.tally.mutations += 1;
        match case.random.random_range(0..10) {
            0..3 => self.configuration(case),
            3..6 => self.image(case),
            6..9 => self.volumes(case),
            _ => self.tokens(case),
        }
    }
}
