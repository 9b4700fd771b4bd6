//! `part.json`: which shots a part measures, under which conditions, and what came of them.

use std::{
    collections::{BTreeMap, BTreeSet},
    fmt,
    io::Write,
    path::Path,
    str::FromStr,
};

use anyhow::{Context, bail};
use lfpiv_rawlog::regular_file::read_regular;
use serde::{Deserialize, Serialize};

use crate::{archive::write_replacing, cli::recorded_shots::Decision, cluster::Conditions};

/// The file's name in the part's folder.
pub(super) const NAME: &str = "part.json";
/// The form of the file.
const VERSION: u32 = 1;
/// Most bytes of it: some ten per shot, and the failures.
const MOST_BYTES: u64 = 256 << 20;

/// Part `k` of `n`, from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Part {
    k: usize,
    n: usize,
}

impl Part {
    /// How many parts there are.
    pub(super) fn of(self) -> usize {
        self.n
    }

    /// All parts of as many.
    pub(super) fn all(n: usize) -> impl Iterator<Item = Self> {
        (1..=n).map(move |k| Self { k, n })
    }

    /// Every n-th of the shots.
    pub(super) fn share(self, shots: impl IntoIterator<Item = u64>) -> Vec<u64> {
        shots.into_iter().skip(self.k - 1).step_by(self.n).collect()
    }
}

impl FromStr for Part {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers = text.split_once('/').map(|(k, n)| (k.trim().parse(), n.trim().parse()));
        match numbers {
            Some((Ok(k), Ok(n))) if (1..=n).contains(&k) => Ok(Self { k, n }),
            _ => Err(format!("'{text}' is no part: give K/N with K from 1 to N, as 2/8")),
        }
    }
}

impl fmt::Display for Part {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}/{}", self.k, self.n)
    }
}

/// The vector instructions of this processor that numerics and libraries choose among.
pub(super) fn vector_instructions() -> String {
    #[cfg(target_arch = "x86_64")]
    let found = [
        ("avx512", is_x86_feature_detected!("avx512f") && is_x86_feature_detected!("avx512vl")),
        ("avx2", is_x86_feature_detected!("avx2")),
        ("fma", is_x86_feature_detected!("fma")),
    ];
    #[cfg(not(target_arch = "x86_64"))]
    let found: [(&str, bool); 0] = [];
    let found = found.iter().filter(|(_, has)| *has).map(|(name, _)| format!(" {name}"));
    format!("{}{}", std::env::consts::ARCH, found.collect::<String>())
}

/// A part's own account.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct PartFile {
    version: u32,
    pub part: Part,
    pub conditions: Conditions,
    /// The shots that it measures.
    pub shots: Vec<u64>,
    /// What decided the forward model; absent as long as nothing has.
    pub decision: Option<Decision>,
    /// The vector instructions of the processors that measured: with others, sums are rounded otherwise.
    pub instructions: BTreeSet<String>,
    /// Whether all of them were looked at.
    pub finished: bool,
    /// Shots that could not be measured, and why.
    pub failed: BTreeMap<u64, String>,
    /// Shots whose images cannot be read, and why.
    pub lost: BTreeMap<u64, String>,
}

impl PartFile {
    /// A part of which nothing is measured yet.
    pub fn new(part: Part, conditions: Conditions, shots: Vec<u64>) -> Self {
        Self {
            version: VERSION,
            part,
            conditions,
            shots,
            decision: None,
            instructions: BTreeSet::new(),
            finished: false,
            failed: BTreeMap::new(),
            lost: BTreeMap::new(),
        }
    }

    /// Reads that of the part in `folder`; nothing where there is none.
    ///
    /// # Errors
    /// It cannot be read, or has another form.
    pub fn read(folder: &Path) -> anyhow::Result<Option<Self>> {
        let path = folder.join(NAME);
        if !path.exists() {
            return Ok(None);
        }
        let text = read_regular(&path, MOST_BYTES)
            .with_context(|| format!("cannot read {}", path.display()))?;
        let file: Self = serde_json::from_slice(&text)
            .with_context(|| format!("{} does not describe a part of a run", path.display()))?;
        if file.version != VERSION || file.part.k == 0 || file.part.k > file.part.n {
            bail!("{} does not describe a part as this lfpiv knows it", path.display());
        }
        Ok(Some(file))
    }

    /// Replaces that of the part in `folder`.
    pub fn write(&self, folder: &Path) -> anyhow::Result<()> {
        let text = serde_json::to_vec_pretty(self).context("a part cannot be written as JSON")?;
        write_replacing(&folder.join(NAME), |writer| writer.write_all(&text))?;
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_counted_from_one() {
        assert_eq!("2/3".parse(), Ok(Part { k: 2, n: 3 }));
        assert_eq!("2/3".parse::<Part>().unwrap().to_string(), "2/3");
        for wrong in ["0/3", "4/3", "2", "a/3", "1/0", "-1/3", ""] {
            assert!(wrong.parse::<Part>().unwrap_err().contains("K/N"), "{wrong}");
        }
    }

    #[test]
    fn every_shot_is_in_one_part() {
        let shots = [2, 3, 5, 7, 11, 13, 17];
        let mut found: Vec<u64> = Part::all(3).flat_map(|part| part.share(shots)).collect();
        assert_eq!(Part { k: 1, n: 3 }.share(shots), [2, 7, 17]);
        found.sort_unstable();
        assert_eq!(found, shots);
        assert!(Part { k: 9, n: 9 }.share(shots).is_empty());
    }

    #[test]
    fn a_part_is_read_as_it_was_written() {
        let root = tempfile::tempdir().unwrap();
        assert_eq!(PartFile::read(root.path()).unwrap(), None);
        let conditions = Conditions {
            code_version: "1".into(),
            configuration_sha256: "2".into(),
            shots_sha256: "3".into(),
            background_crc32: vec![4],
        };
        let mut file = PartFile::new(Part { k: 1, n: 2 }, conditions, vec![0, 2]);
        file.failed.insert(2, "dark".into());
        file.write(root.path()).unwrap();
        assert_eq!(PartFile::read(root.path()).unwrap(), Some(file));
        std::fs::write(root.path().join(NAME), "{}").unwrap();
        let words = format!("{:#}", PartFile::read(root.path()).unwrap_err());
        assert!(words.contains("does not describe a part"), "{words}");
    }
}
