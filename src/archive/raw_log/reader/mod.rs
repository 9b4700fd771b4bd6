//! Reads a log: after its run, or beside the writer.

mod scan;
pub(super) mod segment_file;

use std::{
    iter,
    path::{Path, PathBuf},
    sync::Arc,
};

use super::{
    Position, RawLogError, Record,
    format::{HeaderFault, RecordHeader},
    names,
    storage::{Disk, Storage},
};
use scan::Scan;
use segment_file::{Found, SegmentFile};

/// A log that can be read. It holds no file open.
///
/// Beside a running writer it reads up to what is whole; an iterator that has ended goes on when
/// it is asked again and there is more. What a crash has left is read up to the first record that
/// is not whole: [`super::recover`] first cuts what lies behind.
#[derive(Debug, Clone)]
pub struct RawLogReader {
    storage: Arc<dyn Storage>,
    folder: PathBuf,
    description: Vec<u8>,
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
        let mut reader = Self { storage, folder: folder.into(), description: Vec::new() };
        let mut fault = RawLogError::NoSegment { folder: folder.into() };
        for number in reader.numbers()? {
            match SegmentFile::find(&*reader.storage, folder, number) {
                Ok(Some(segment)) => {
                    reader.description = segment.header.description;
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

    /// What the run was described as.
    pub fn description(&self) -> &[u8] {
        &self.description
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
        let nothing = |path| RawLogError::Damaged { path, offset, what: "there is no record" };
        let segment = self.segment(number)?.ok_or_else(|| nothing(path))?;
        match segment.look(offset)? {
            Found::Record(header) => read_record(&segment, offset, &header),
            Found::Footer(_) | Found::Nothing => Err(nothing(segment.path)),
        }
    }

    fn folder(&self) -> &Path {
        &self.folder
    }

    /// The segment, if it is there and its header is whole.
    fn segment(&self, number: u32) -> Result<Option<SegmentFile>, RawLogError> {
        let segment = SegmentFile::find(&*self.storage, &self.folder, number)?;
        let is_foreign = |segment: &SegmentFile| {
            segment.header.segment != number || segment.header.description != self.description
        };
        match segment {
            Some(segment) if is_foreign(&segment) => {
                Err(segment.damaged(0, "this segment belongs to another log"))
            }
            segment => Ok(segment),
        }
    }

    /// Whether there are segments behind one that is not there.
    fn has_segment_behind(&self, number: u32) -> Result<bool, RawLogError> {
        // A segment whose header is not whole is the last, and as good as none.
        for later in self.numbers()?.into_iter().filter(|later| *later > number) {
            if !matches!(SegmentFile::find(&*self.storage, &self.folder, later), Ok(None)) {
                return Ok(true);
            }
        }
        Ok(false)
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
