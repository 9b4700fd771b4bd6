//! Reads a log: after its run, or beside the writer.

mod header_copies;
mod scan;
mod search;
pub(super) mod segment_file;

use std::{
    iter,
    path::{Path, PathBuf},
    sync::Arc,
};

use super::{
    Damage, Position, RawLogError, Record,
    format::{HeaderFault, RecordHeader},
    names,
    storage::{Disk, Storage},
};
use scan::Scan;
use segment_file::{Found, SegmentFile};

/// A log that can be read. It holds no file open.
///
/// Beside a running writer it reads up to what is whole; an iterator that has ended goes on when
/// it is asked again and there is more. After it ([`Self::finished`]) everything is said that cannot
/// be read. What a crash has left is read without [`super::recover`], too.
#[derive(Debug, Clone)]
pub struct RawLogReader {
    storage: Arc<dyn Storage>,
    folder: PathBuf,
    /// When the log was begun, and what it was described as.
    identity: (u64, Vec<u8>),
    /// Nobody writes the log any more.
    is_finished: bool,
}

/// Sequence number, place and head of a record, and whether it has an image.
pub type Head = (u64, Position, Vec<u8>, bool);

impl RawLogReader {
    /// Opens the log in `folder`.
    ///
    /// # Errors
    /// There is none, it was written by a newer program, or no segment has a readable header.
    pub fn open(folder: &Path) -> Result<Self, RawLogError> {
        Self::open_on(Arc::new(Disk), folder)
    }

    pub(super) fn open_on(storage: Arc<dyn Storage>, folder: &Path) -> Result<Self, RawLogError> {
        let folder_path = folder.into();
        let mut reader =
            Self { storage, folder: folder_path, identity: (0, Vec::new()), is_finished: false };
        let mut fault = RawLogError::NoSegment { folder: folder.into() };
        for number in reader.numbers()? {
            match SegmentFile::find(&*reader.storage, folder, number) {
                Ok(Some(segment)) => {
                    reader.identity = (segment.header.begun_ns, segment.header.description);
                    return Ok(reader);
                }
                Ok(None) => {
                    let path = names::part_path(folder, number);
                    fault = RawLogError::header(path, HeaderFault::Incomplete);
                }
                Err(error @ RawLogError::NewerVersion { .. }) => return Err(error),
                Err(error) => fault = error,
            }
        }
        Err(fault)
    }

    /// The same log, of which is known that nobody writes it any more: bytes at its end that are no
    /// record are damage then, and told.
    #[must_use]
    pub fn finished(self) -> Self {
        Self { is_finished: true, ..self }
    }

    /// What the run was described as.
    pub fn description(&self) -> &[u8] {
        &self.identity.1
    }

    /// All heads in order, without their images. An item is an error where something is damaged or
    /// missing; those behind it follow. Images are not checked.
    pub fn heads(&self) -> impl Iterator<Item = Result<Head, RawLogError>> + Send + use<> {
        let mut scan = Scan::new(self);
        iter::from_fn(move || {
            let step = scan.step()?;
            Some(step.and_then(|(position, header)| {
                let segment = scan.scanned()?;
                let head = segment.head(position.offset, &header)?;
                Ok((header.sequence, position, head, header.has_image()))
            }))
        })
    }

    /// All records in order, with their sequence numbers. An item is an error where something is
    /// damaged or missing; those behind it follow.
    pub fn records(
        &self,
    ) -> impl Iterator<Item = Result<(u64, Record), RawLogError>> + Send + use<> {
        let mut scan = Scan::new(self);
        iter::from_fn(move || {
            let step = scan.step()?;
            Some(step.and_then(|(position, header)| {
                let record = read_record(scan.scanned()?, position.offset, &header)?;
                Ok((header.sequence, record))
            }))
        })
    }

    /// The record at a place that [`Self::heads`] gave.
    ///
    /// # Errors
    /// There is no record, or it is damaged.
    pub fn read(&self, position: Position) -> Result<Record, RawLogError> {
        let Position { segment: number, offset } = position;
        let path = names::sealed_path(&self.folder, number);
        let nothing = |path| {
            let (bytes, what) = (offset..offset, "there is no record");
            RawLogError::Damaged(Damage { path, bytes, records: None, what })
        };
        let segment = self.segment(number)?.ok_or_else(|| nothing(path))?;
        match segment.look(offset)? {
            Found::Record(header) => read_record(&segment, offset, &header),
            Found::Torn(_) | Found::Footer(_) | Found::Nothing => Err(nothing(segment.path)),
        }
    }

    fn folder(&self) -> &Path {
        &self.folder
    }

    /// The segment, if it is there and its header is whole.
    fn segment(&self, number: u32) -> Result<Option<SegmentFile>, RawLogError> {
        let segment = SegmentFile::find(&*self.storage, &self.folder, number)?;
        let is_foreign = |segment: &SegmentFile| {
            let header = &segment.header;
            let (begun_ns, description) = &self.identity;
            (header.segment, header.begun_ns) != (number, *begun_ns)
                || header.description != *description
        };
        match segment {
            Some(segment) if is_foreign(&segment) => {
                Err(segment.damaged(0..segment.start, None, "this segment belongs to another log"))
            }
            segment => Ok(segment),
        }
    }

    /// The first segment behind this one that was begun, whatever there is in between.
    fn next_begun_segment(&self, number: u32) -> Result<Option<u32>, RawLogError> {
        let later = self.numbers()?.into_iter().filter(|later| *later > number);
        let is_begun = |later: &u32| {
            !matches!(SegmentFile::find(&*self.storage, &self.folder, *later), Ok(None))
        };
        Ok({ later }.find(is_begun))
    }

    /// Whether the segment has its final name.
    fn is_sealed(&self, number: u32) -> bool {
        self.storage.open(&names::sealed_path(&self.folder, number)).is_ok()
    }

    /// Numbers of all segments, sealed or not, ascending.
    fn numbers(&self) -> Result<Vec<u32>, RawLogError> {
        let list = self.storage.list(&self.folder);
        let list = list.map_err(RawLogError::io("list the folder", &self.folder))?;
        let mut numbers: Vec<u32> =
            list.iter().filter_map(|name| names::parse(name)).map(|(number, _)| number).collect();
        numbers.sort_unstable();
        numbers.dedup();
        Ok(numbers)
    }
}

fn read_record(
    segment: &SegmentFile,
    offset: u64,
    header: &RecordHeader,
) -> Result<Record, RawLogError> {
    let head = segment.head(offset, header)?;
    Ok(Record { head, image: segment.image(offset, header)? })
}
