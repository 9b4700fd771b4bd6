//! A recorded run, read back.

use std::{
    collections::{BTreeMap, BTreeSet, HashMap},
    path::{Path, PathBuf},
};

use lfpiv_core::lightfield::ImagePair;
use lfpiv_hw::RawImage;
use lfpiv_rawlog::{Position, RawLogError, RawLogReader};
use thiserror::Error;

use super::{Description, Entry, FrameKey, JOURNAL_VERSION};
use crate::{acquisition::trigger_times::TriggerTimes, archive::ShotTime};

/// Where a run's raw log lies in its folder.
pub const RAW_FOLDER: &str = "raw";

/// Why a recorded run cannot be read.
#[derive(Debug, Error)]
pub enum RecordedRunError {
    /// The log itself cannot be read.
    #[error(transparent)]
    RawLog(#[from] RawLogError),
    /// Its description or an entry is not what this program writes.
    #[error("{}: {what} cannot be understood: {reason}", folder.display())]
    NotAJournal { folder: PathBuf, what: String, reason: serde_json::Error },
    /// A later program wrote it.
    #[error(
        "{}: written as journal version {found}, this program knows up to {JOURNAL_VERSION}: use \
         the lfpiv that recorded it, or a later one", folder.display()
    )]
    NewerVersion { folder: PathBuf, found: u32 },
    /// An entry that should have an image has none.
    #[error("{}: a frame of the record has no image", folder.display())]
    NoImage { folder: PathBuf },
    /// No such shot.
    #[error("{}: there is no shot {shot} in the record", folder.display())]
    NoShot { folder: PathBuf, shot: u64 },
}

/// A recorded run. It holds no file open, and can be read beside the run that still writes it.
#[derive(Debug, Clone)]
pub struct RecordedRun {
    folder: PathBuf,
    reader: RawLogReader,
    description: Description,
}

/// An entry and where its record lies.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    pub position: Position,
    pub entry: Entry,
}

/// One shot of a recorded run.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordedShot {
    /// Its number.
    pub trigger: u64,
    /// Where frames a and b of each camera lie.
    pub frames: Vec<[Position; 2]>,
    /// Time between the light pulses, in µs.
    pub dt_us: f64,
    /// Evidence that disagrees with the pairing.
    pub suspect: Vec<String>,
    /// When its trigger was given.
    pub time: Option<ShotTime>,
}

/// The end of a run.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RunEnd {
    /// What ended it before its time.
    pub error: Option<String>,
}

/// What a run holds.
#[derive(Debug, Clone, Default)]
pub struct RunIndex {
    /// Its shots by number.
    pub shots: BTreeMap<u64, RecordedShot>,
    /// How the run ended; a run that was killed has no end.
    pub end: Option<RunEnd>,
    /// What is damaged or missing in the log, in words.
    pub damaged: Vec<String>,
    /// Shots that were recorded and are not whole any more, and why.
    pub lost: BTreeMap<u64, String>,
    /// Triggers of which the record says, or must have said, how they ended, and nothing is found.
    /// None where nothing is damaged.
    pub unknown: BTreeSet<u64>,
}

impl RecordedRunError {
    /// Whether recorded data is damaged or missing: the rest can still be read.
    pub fn is_damage(&self) -> bool {
        match self {
            Self::RawLog(error) => error.is_damage(),
            Self::NotAJournal { .. } | Self::NoImage { .. } => true,
            Self::NewerVersion { .. } | Self::NoShot { .. } => false,
        }
    }
}

impl RecordedRun {
    /// Opens the record of the run in `run`.
    ///
    /// # Errors
    /// There is none, or it cannot be read.
    pub fn open(run: &Path) -> Result<Self, RecordedRunError> {
        let folder = run.join(RAW_FOLDER);
        let reader = RawLogReader::open(&folder)?;
        let description: Description =
            serde_json::from_slice(reader.description()).map_err(|reason| {
                let what = "its description".to_owned();
                RecordedRunError::NotAJournal { folder: folder.clone(), what, reason }
            })?;
        if description.journal_version > JOURNAL_VERSION {
            let found = description.journal_version;
            return Err(RecordedRunError::NewerVersion { folder, found });
        }
        Ok(Self { folder, reader, description })
    }

    /// The same record, of which is known that nobody writes it any more: see
    /// [`RawLogReader::finished`].
    #[must_use]
    pub fn finished(self) -> Self {
        Self { reader: self.reader.finished(), ..self }
    }

    /// What the run was.
    pub fn description(&self) -> &Description {
        &self.description
    }

    /// All entries in order. An item is an error where the log is damaged; those behind it follow.
    /// Beside a run that is being written, one that has ended goes on when there is more.
    pub fn entries(&self) -> impl Iterator<Item = Result<Placed, RecordedRunError>> + Send + use<> {
        let folder = self.folder.clone();
        self.reader.heads().map(move |head| {
            let (number, position, head, _) = head?;
            let entry = serde_json::from_slice(&head).map_err(|reason| {
                let what = format!("record {number}");
                RecordedRunError::NotAJournal { folder: folder.clone(), what, reason }
            })?;
            Ok(Placed { position, entry })
        })
    }

    /// Finds every shot and where its frames lie, around whatever is damaged.
    pub fn index(&self) -> RunIndex {
        let mut index = RunIndex::default();
        let mut finder = ShotFinder::default();
        let mut triggers = Triggers::default();
        // Damage since the last whole shot: frames come shortly before their shot.
        let mut recent = 0;
        for item in self.entries() {
            let placed = match item {
                Ok(placed) => placed,
                Err(error) => {
                    index.damaged.push(error.to_string());
                    continue;
                }
            };
            triggers.see(&placed.entry);
            if let Entry::Ended { error, .. } = &placed.entry {
                index.end = Some(RunEnd { error: error.clone() });
            }
            match finder.take(placed) {
                Some(Ok(shot)) => {
                    index.shots.insert(shot.trigger, shot);
                    recent = index.damaged.len();
                }
                Some(Err(trigger)) => {
                    let before = index.damaged[recent..].join("; ");
                    index.lost.insert(trigger, format!("it lacks a frame: {before}"));
                }
                None => {}
            }
        }
        if !index.damaged.is_empty() {
            index.unknown = triggers.unknown(index.end.is_some());
        }
        index
    }

    /// The image of a frame.
    ///
    /// # Errors
    /// The record is damaged, or has no image.
    pub fn image(&self, position: Position) -> Result<RawImage, RecordedRunError> {
        let record = self.reader.read(position)?;
        record.image.ok_or_else(|| RecordedRunError::NoImage { folder: self.folder.clone() })
    }

    /// The images of a shot.
    ///
    /// # Errors
    /// As [`Self::image`].
    pub fn pair(&self, shot: &RecordedShot) -> Result<ImagePair, RecordedRunError> {
        let cameras = shot.frames.iter().map(|[a, b]| Ok([self.image(*a)?, self.image(*b)?]));
        Ok(ImagePair { cameras: cameras.collect::<Result<_, RecordedRunError>>()? })
    }
}

/// More than a burst or a run has: a record that says so takes no more memory and time than this.
const MOST_TRIGGERS: usize = 10_000_000;

/// Which triggers there were, and of which the record says how they ended.
#[derive(Debug, Default)]
struct Triggers {
    entered: BTreeSet<u64>,
    known: BTreeSet<u64>,
}

impl Triggers {
    fn see(&mut self, entry: &Entry) {
        match entry {
            Entry::Fired { first, shots, .. } => {
                let triggers = *first..first.saturating_add(*shots);
                self.entered.extend(triggers.take(MOST_TRIGGERS));
            }
            Entry::Withdrawn { trigger } => drop(self.entered.remove(trigger)),
            Entry::Shot { trigger, .. } | Entry::Settled { trigger, .. } => {
                self.known.insert(*trigger);
            }
            _ => {}
        }
    }

    /// A run that was cut off had no time for its last triggers; one that has ended has ruled on
    /// all.
    fn unknown(&self, has_ended: bool) -> BTreeSet<u64> {
        let last_entered = self.entered.last().filter(|_| has_ended);
        let Some(last) = self.known.last().max(last_entered) else { return BTreeSet::new() };
        let unknown = (0..=*last).filter(|trigger| !self.known.contains(trigger));
        unknown.take(MOST_TRIGGERS).collect()
    }
}

/// Finds the shots in a record, entry by entry.
#[derive(Debug, Default)]
pub(super) struct ShotFinder {
    /// Frames of no shot so far, and their host times in ns.
    frames: HashMap<(usize, FrameKey), (Position, u64)>,
    times: TriggerTimes,
}

impl ShotFinder {
    /// The shot that this entry completes; its number where a frame of it is not in the record.
    pub fn take(&mut self, placed: Placed) -> Option<Result<RecordedShot, u64>> {
        self.times.see(&placed.entry);
        match placed.entry {
            Entry::Frame { camera, frame, .. } => {
                // Of a frame that came twice, the first was used.
                let found = (placed.position, frame.host_timestamp_ns);
                self.frames.entry((camera, frame.key())).or_insert(found);
                None
            }
            Entry::Shot { trigger, frames: keys, suspect, dt_us, .. } => {
                let mut find = |(camera, keys): (usize, &[FrameKey; 2])| {
                    let [a, b] = keys.map(|key| self.frames.remove(&(camera, key)));
                    Some([a?, b?])
                };
                let found: Option<Vec<_>> = keys.iter().enumerate().map(&mut find).collect();
                let Some(frames) = found else { return Some(Err(trigger)) };
                let received_ns = frames.iter().map(|[(_, received_ns), _]| *received_ns);
                let time = self.times.of_shot(trigger, received_ns);
                let frames = frames.iter().map(|ab| ab.map(|(position, _)| position)).collect();
                Some(Ok(RecordedShot { trigger, frames, dt_us, suspect, time }))
            }
            _ => None,
        }
    }

    /// When the triggers seen so far were given.
    pub fn times(&self) -> &TriggerTimes {
        &self.times
    }
}
