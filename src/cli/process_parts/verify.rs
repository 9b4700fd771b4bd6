//! Whether parts are all of a run, each shot once, and measured alike.

use std::{
    collections::{BTreeMap, BTreeSet},
    fmt::Display,
    path::{Path, PathBuf},
};

use anyhow::bail;
use lfpiv_core::model::ModelChoice;

use super::part_file::{NAME, Part, PartFile};
use crate::{
    archive::{SealedFile, sha256},
    cli::{output::count, recording::refuse_running},
    cluster::Conditions,
};

/// Shots that a message names.
const NAMED: usize = 5;

/// A part on disk that nobody writes.
#[derive(Debug)]
pub(super) struct PartFolder {
    pub folder: PathBuf,
    pub file: PartFile,
    sealed: Vec<SealedFile>,
}

impl PartFolder {
    /// # Errors
    /// There is no part, it is still written, or it cannot be read.
    pub fn open(folder: &Path) -> anyhow::Result<Self> {
        refuse_running(folder)?;
        let Some(file) = PartFile::read(folder)? else {
            bail!("{} is no part of a run: it has no {NAME}", folder.display());
        };
        Ok(Self { folder: folder.into(), file, sealed: SealedFile::find_all(folder)? })
    }

    /// Every result that it holds.
    fn results(&self) -> impl Iterator<Item = u64> {
        self.sealed.iter().flat_map(|file| file.shots.iter().copied())
    }

    fn name(&self) -> String {
        format!("part {} in {}", self.file.part, self.folder.display())
    }

    /// What of its results is not as its file says, or as the run is.
    fn strange_results(&self, configuration: &str) -> Option<String> {
        let model_sha256 = self.file.decision.as_ref().map(|decision| &decision.model_sha256);
        // Shots before the one that decided have the model as configured, and no scene.
        let is_undecided = |choice: &str| {
            serde_json::from_str::<ModelChoice>(choice).is_ok_and(|choice| choice.scene.is_none())
        };
        let is_strange = |choice: &String| {
            Some(&sha256(choice.as_bytes())) != model_sha256 && !is_undecided(choice)
        };
        let is_own = |shot: u64| self.file.shots.binary_search(&shot).is_ok();
        for SealedFile { path, shots, configuration: own, model_choice } in &self.sealed {
            let path = path.display();
            if own != configuration {
                return Some(format!("{path} was measured with another configuration"));
            }
            if model_choice.as_ref().is_none_or(is_strange) {
                return Some(format!("{path} was measured with another forward model"));
            }
            if let Some(shot) = shots.iter().find(|shot| !is_own(**shot)) {
                return Some(format!("{path} holds shot {shot}, which is not of this part"));
            }
        }
        None
    }
}

/// The run that parts are to complete.
pub(super) struct Run<'a> {
    pub folder: &'a Path,
    pub configuration: &'a str,
    pub conditions: &'a Conditions,
    /// Shots with a result in it, without those that a merge of these parts has put there.
    pub measured: BTreeSet<u64>,
    /// Shots without one.
    pub missing: BTreeSet<u64>,
}

impl Run<'_> {
    /// # Errors
    /// All that is wrong with the parts: one is missing, doubled, cut off or of other conditions; a shot is
    /// there twice or not at all.
    pub fn verify(&self, parts: &[PartFolder]) -> anyhow::Result<()> {
        let steps = [Self::unlike, Self::incomplete, Self::cut_off, Self::not_once];
        // Each step takes what was found by the one before for granted.
        for problems in steps.map(|step| step(self, parts)) {
            if !problems.is_empty() {
                let listed: String = problems.iter().map(|line| format!("\n  {line}")).collect();
                bail!("nothing is merged into {}:{listed}", self.folder.display());
            }
        }
        Ok(())
    }

    /// Parts that were made under other conditions.
    fn unlike(&self, parts: &[PartFolder]) -> Vec<String> {
        let mut problems = Vec::new();
        let decided = parts.iter().find(|part| part.file.decision.is_some());
        for part in parts {
            let name = part.name();
            let PartFile { conditions, decision, .. } = &part.file;
            if let Some(difference) = conditions.difference(self.conditions) {
                problems.push(format!("{name} {difference}"));
            } else if let Some(other) = decided.filter(|other| other.file.decision != *decision)
                && decision.is_some()
            {
                problems.push(format!(
                    "{name} was measured with another forward model than {}: measure all parts on \
                     processors of one kind",
                    other.name()
                ));
            } else if let Some(strange) = part.strange_results(self.configuration) {
                problems.push(format!("{name}: {strange}"));
            }
        }
        problems
    }

    /// Parts that are missing, there twice, or of another division.
    fn incomplete(&self, parts: &[PartFolder]) -> Vec<String> {
        let Some(first) = parts.first() else { return vec!["no part is given".to_owned()] };
        let mut by_part: BTreeMap<Part, &PartFolder> = BTreeMap::new();
        let mut problems = Vec::new();
        for part in parts {
            let of = part.file.part.of();
            if of != first.file.part.of() {
                problems.push(format!("{} is one of {of}, unlike {}", part.name(), first.name()));
            } else if let Some(other) = by_part.insert(part.file.part, part) {
                let (part, other) = (part.name(), other.folder.display());
                problems.push(format!("{part} is given twice: also in {other}"));
            }
        }
        if problems.is_empty() {
            let missing =
                Part::all(first.file.part.of()).filter(|part| !by_part.contains_key(part));
            problems.extend(missing.map(|part| {
                let call = self.call(part, "DIR");
                format!("part {part} is missing: give its folder, or measure it: {call}")
            }));
        }
        problems
    }

    /// Parts with shots that were not looked at.
    fn cut_off(&self, parts: &[PartFolder]) -> Vec<String> {
        let cut_off = |part: &PartFolder| {
            let PartFile { part: number, shots, finished, failed, lost, .. } = &part.file;
            let have: BTreeSet<u64> = part.results().collect();
            let has_none = |shot: &&u64| {
                !(have.contains(*shot) || failed.contains_key(*shot) || lost.contains_key(*shot))
            };
            let left = shots.iter().filter(has_none).count();
            (left > 0 || !finished).then(|| {
                format!(
                    "{} was cut off: {left} of {} not measured; continue with {}",
                    part.name(),
                    count(shots.len(), "shot"),
                    self.call(*number, part.folder.display())
                )
            })
        };
        parts.iter().filter_map(cut_off).collect()
    }

    /// Shots that are there twice, or not at all.
    fn not_once(&self, parts: &[PartFolder]) -> Vec<String> {
        let mut found: BTreeMap<u64, Vec<String>> = BTreeMap::new();
        for part in parts {
            let named = part.file.failed.keys().chain(part.file.lost.keys()).copied();
            for shot in part.results().chain(named) {
                found.entry(shot).or_default().push(part.name());
            }
        }
        for shot in &self.measured {
            found.entry(*shot).and_modify(|places| places.push("the run".to_owned()));
        }
        let twice = found.iter().filter(|(_, places)| places.len() > 1);
        let mut problems: Vec<String> = twice
            .clone()
            .take(NAMED)
            .map(|(shot, places)| {
                format!("shot {shot} is in more than one place: {}", places.join(", "))
            })
            .collect();
        if let Some(more) = twice.count().checked_sub(NAMED + 1) {
            problems.push(format!("and {} more", count(more + 1, "shot")));
        }
        let nowhere: Vec<u64> =
            self.missing.iter().copied().filter(|shot| !found.contains_key(shot)).collect();
        if let Some(first) = nowhere.first() {
            problems.push(format!(
                "{} have no result and are in no part (the first is shot {first}): the run had \
                 results of them when the parts were started; remove the parts and measure again",
                count(nowhere.len(), "shot")
            ));
        }
        problems
    }

    fn call(&self, part: Part, out: impl Display) -> String {
        format!("`lfpiv process {} --part {part} --out {out}`", self.folder.display())
    }
}
