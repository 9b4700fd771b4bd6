//! Reads a log during or after its run.

mod header_copies;
mod packed;
mod scan;
mod search;
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
pub use packed::unpack;
use scan::Scan;
use segment_file::SegmentFile;

/// Reads a log. It keeps no file open.
///
/// During a run it reads up to the last complete record; an exhausted iterator continues when it is
/// polled again and there is more. After the run ([`Self::finished`]) all unreadable data is
/// reported. A log left by a crash can be read without [`super::recover`].
#[derive(Debug, Clone)]
pub struct RawLogReader {
    storage: Arc<dyn Storage>,
    folder: PathBuf,
    /// Creation time and description of the log.
    identity: (u64, Vec<u8>),
    /// The log has no writer any more.
    is_finished: bool,
}

/// Sequence number, position and head of a record, and whether it has an image.
pub type Head = (u64, Position, Vec<u8>, bool);

impl RawLogReader {
    /// Opens the log in `folder`.
    ///
    /// # Errors
    /// There is no log, it was written by a newer program, or no segment has a readable header.
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
                    reader.identity = (segment.header.created_ns, segment.header.description);
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

    /// The same log, known to have no writer any more: trailing bytes that are no record are then
    /// reported as damage.
    #[must_use]
    pub fn finished(self) -> Self {
        Self { is_finished: true, ..self }
    }

    /// The description of the run.
    pub fn description(&self) -> &[u8] {
        &self.identity.1
    }

    /// All heads in order, without their images. An error marks damaged or missing data; iteration
    /// continues after it. Images are not checked.
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

    /// All records in order, with their sequence numbers. An error marks damaged or missing data;
    /// iteration continues after it.
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

    /// The record at a position that [`Self::heads`] returned.
    ///
    /// # Errors
    /// There is no record at this position, or it is damaged.
    pub fn read(&self, position: Position) -> Result<Record, RawLogError> {
        let (segment, header) = self.locate(position)?;
        read_record(&segment, position.offset, &header)
    }

    fn folder(&self) -> &Path {
        &self.folder
    }

    /// The segment, if it exists and its header is intact.
    fn segment(&self, number: u32) -> Result<Option<SegmentFile>, RawLogError> {
        let segment = SegmentFile::find(&*self.storage, &self.folder, number)?;
        let is_foreign = |segment: &SegmentFile| {
            let header = &segment.header;
            let (created_ns, description) = &self.identity;
            (header.segment, header.created_ns) != (number, *created_ns)
                || header.description != *description
        };
        match segment {
            Some(segment) if is_foreign(&segment) => {
                Err(segment.damaged(0..segment.start, None, "this segment belongs to another log"))
            }
            segment => Ok(segment),
        }
    }

    /// Number of the next segment that exists, gaps skipped.
    fn next_existing_segment(&self, number: u32) -> Result<Option<u32>, RawLogError> {
        let later = self.numbers()?.into_iter().filter(|later| *later > number);
        let exists_in_same_log = |later: &u32| {
            !matches!(SegmentFile::find(&*self.storage, &self.folder, *later), Ok(None))
        };
        Ok({ later }.find(exists_in_same_log))
    }

    /// Whether the segment has its final name.
    fn is_sealed(&self, number: u32) -> bool {
        self.storage.open(&names::sealed_path(&self.folder, number)).is_ok()
    }

    /// Numbers of all segments, sealed or not, in ascending order.
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
