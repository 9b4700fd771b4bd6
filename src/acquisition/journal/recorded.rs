//! Reads a recorded run.

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

/// Folder of the raw log in a run's folder.
pub const RAW_FOLDER: &str = "raw";

/// Why a recorded run cannot be read.
#[derive(Debug, Error)]
pub enum RecordedRunError {
    /// The log itself cannot be read.
    #[error(transparent)]
    RawLog(#[from] RawLogError),
    /// Its description or an entry has an unknown form.
    #[error("{}: {what} has an unknown form: {reason}", folder.display())]
    NotAJournal { folder: PathBuf, what: String, reason: serde_json::Error },
    /// Written by a later program.
    #[error(
        "{}: written in journal version {found}, and this program reads up to {JOURNAL_VERSION}: use \
         the lfpiv that recorded it, or a later one", folder.display()
    )]
    NewerVersion { folder: PathBuf, found: u32 },
    /// A frame entry without an image.
    #[error("{}: a frame of the record has no image", folder.display())]
    NoImage { folder: PathBuf },
    /// The shot does not exist.
    #[error("{}: there is no shot {shot} in the record", folder.display())]
    NoShot { folder: PathBuf, shot: u64 },
}

/// A recorded run. It keeps no file open, and can be read while the run is still being written.
#[derive(Debug, Clone)]
pub struct RecordedRun {
    folder: PathBuf,
    reader: RawLogReader,
    description: Description,
}

/// An entry and the position of its record.
#[derive(Debug, Clone, PartialEq)]
pub struct LocatedEntry {
    pub position: Position,
    pub entry: Entry,
}

/// One shot of a recorded run.
#[derive(Debug, Clone, PartialEq)]
pub struct RecordedShot {
    /// Its number.
    pub trigger: u64,
    /// Positions of frames a and b of each camera.
    pub frames: Vec<[Position; 2]>,
    /// Time between the light pulses, in µs.
    pub dt_us: f64,
    /// Evidence against the pairing.
    pub suspect: Vec<String>,
    /// When its trigger was given.
    pub time: Option<ShotTime>,
}

/// The end of a run.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RunEnd {
    /// The error that ended it early, if any.
    pub error: Option<String>,
}

/// Contents of a recorded run.
#[derive(Debug, Clone, Default)]
pub struct RunIndex {
    /// Its shots by number.
    pub shots: BTreeMap<u64, RecordedShot>,
    /// The end of the run; `None` if it was killed.
    pub end: Option<RunEnd>,
    /// Damaged or missing parts of the log, described for the user.
    pub damaged: Vec<String>,
    /// Recorded shots that are incomplete now, with the reason.
    pub lost: BTreeMap<u64, String>,
    /// Triggers whose outcome must have been recorded but is missing. Empty if nothing is damaged.
    pub unknown: BTreeSet<u64>,
}

impl RecordedRunError {
    /// Whether recorded data is damaged or missing; the rest can still be read.
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
    /// There is no record, or it cannot be read.
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

    /// The same record, known to have no writer any more: see [`RawLogReader::finished`].
    #[must_use]
    pub fn finished(self) -> Self {
        Self { reader: self.reader.finished(), ..self }
    }

    /// The description of the run.
    pub fn description(&self) -> &Description {
        &self.description
    }

    /// All entries in order. An error marks damage; iteration continues after it. During a run, an
    /// exhausted iterator continues when there is more.
    pub fn entries(
        &self,
    ) -> impl Iterator<Item = Result<LocatedEntry, RecordedRunError>> + Send + use<> {
        let folder = self.folder.clone();
        self.reader.heads().map(move |head| {
            let (number, position, head, _) = head?;
            let entry = serde_json::from_slice(&head).map_err(|reason| {
                let what = format!("record {number}");
                RecordedRunError::NotAJournal { folder: folder.clone(), what, reason }
            })?;
            Ok(LocatedEntry { position, entry })
        })
    }

    /// Finds every shot and the positions of its frames, past damage.
    pub fn index(&self) -> RunIndex {
        let mut index = RunIndex::default();
        let mut finder = ShotFinder::default();
        let mut triggers = TriggerSets::default();
        // Damage since the last complete shot: frames precede their shot closely.
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

    /// The record of a frame as it is on disk: see [`RawLogReader::packed`].
    ///
    /// # Errors
    /// There is no such record.
    pub fn packed(&self, position: Position) -> Result<Vec<u8>, RecordedRunError> {
        Ok(self.reader.packed(position)?)
    }

    /// CRC-32 of a frame's image, from the header of its record.
    ///
    /// # Errors
    /// There is no such record.
    pub fn image_crc32(&self, position: Position) -> Result<u32, RecordedRunError> {
        Ok(self.reader.image_crc32(position)?)
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

/// Bound on the triggers of a run, to limit memory and time for a corrupt record.
const MAX_TRIGGERS: usize = 10_000_000;

/// Triggers given, and those with a recorded outcome.
#[derive(Debug, Default)]
struct TriggerSets {
    entered: BTreeSet<u64>,
    known: BTreeSet<u64>,
}

impl TriggerSets {
    fn see(&mut self, entry: &Entry) {
        match entry {
            Entry::Fired { first, shots, .. } => {
                let triggers = *first..first.saturating_add(*shots);
                self.entered.extend(triggers.take(MAX_TRIGGERS));
            }
            Entry::Withdrawn { trigger } => drop(self.entered.remove(trigger)),
            Entry::Shot { trigger, .. } | Entry::Settled { trigger, .. } => {
                self.known.insert(*trigger);
            }
            _ => {}
        }
    }

    /// Triggers without an outcome. A run that was cut off did not settle its last ones; a
    /// completed run settled all.
    fn unknown(&self, has_ended: bool) -> BTreeSet<u64> {
        let last_entered = self.entered.last().filter(|_| has_ended);
        let Some(last) = self.known.last().max(last_entered) else { return BTreeSet::new() };
        let unknown = (0..=*last).filter(|trigger| !self.known.contains(trigger));
        unknown.take(MAX_TRIGGERS).collect()
    }
}

/// Assembles shots from the entries of a record.
#[derive(Debug, Default)]
pub(super) struct ShotFinder {
    /// Frames not yet part of a shot, and their host times in ns.
    frames: HashMap<(usize, FrameKey), (Position, u64)>,
    times: TriggerTimes,
}

impl ShotFinder {
    /// The shot that this entry completes; its number as error if one of its frames is missing.
    pub fn take(&mut self, placed: LocatedEntry) -> Option<Result<RecordedShot, u64>> {
        self.times.see(&placed.entry);
        match placed.entry {
            Entry::Frame { camera, frame, .. } => {
                // Of a duplicate frame, the first was used.
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

    /// Times of the triggers seen so far.
    pub fn times(&self) -> &TriggerTimes {
        &self.times
    }
}
