//! After a crash: what the segment that was being written ends in and is no record is cut, and the
//! segment is sealed. Damage before its last record stays where it is: readers go around it and say
//! so.

use std::{
    fmt,
    ops::Range,
    path::{Path, PathBuf},
};

use super::{
    RawLogError,
    format::{Ending, Footer, HeaderFault},
    names::{parse, part_path, sealed_path, torn_path},
    reader::segment_file::{Found, OpenFault, SegmentFile},
    segments::give_sealed_name,
    storage::{Disk, LogFile, Storage},
};

/// How much is moved at once.
const MOVED_BYTES: usize = 1 << 20;

/// What recovery found and did.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Recovery {
    /// Segments that were not sealed: one after a crash, two after one between two segments, none
    /// otherwise.
    pub segments: Vec<RecoveredSegment>,
}

/// A segment that was not sealed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RecoveredSegment {
    /// Its name now; nothing where no record could be in it, because its header was torn.
    pub path: Option<PathBuf>,
    /// Records in it, those that are damaged included.
    pub records: u64,
    /// What was cut.
    pub torn: Option<TornTail>,
}

/// What was cut from a segment.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TornTail {
    /// The segment as it was named before.
    pub segment: PathBuf,
    /// Its first byte in the segment.
    pub offset: u64,
    /// Its length.
    pub bytes: u64,
    /// Where it lies now.
    pub moved_to: PathBuf,
    /// Sequence number of the record that it can be seen to be a part of.
    pub record: Option<u64>,
}

/// Makes a log whole that a crash or a failed disk has left: cuts what is torn, keeps that beside
/// the segment as `NAME.torn`, and seals the segment. Sealed segments are not touched; a second
/// call finds nothing to do. Not beside a running writer.
///
/// # Errors
/// There is no log in `folder`, a newer program wrote it, or the disk refuses.
pub fn recover(folder: &Path) -> Result<Recovery, RawLogError> {
    recover_on(&Disk, folder)
}

pub(super) fn recover_on(storage: &dyn Storage, folder: &Path) -> Result<Recovery, RawLogError> {
    let work = Work { storage, folder };
    let names = work.names()?;
    let mut found: Vec<(u32, bool)> = names.iter().filter_map(|name| parse(name)).collect();
    if found.is_empty() && !names.iter().any(|name| name.contains(".torn")) {
        return Err(RawLogError::NoSegment { folder: folder.into() });
    }
    found.sort_unstable();
    let unsealed = found.into_iter().filter(|(_, is_sealed)| !is_sealed);
    let recovered = unsealed.filter_map(|(number, _)| work.recover(number).transpose());
    let segments = recovered.collect::<Result<_, _>>()?;
    Ok(Recovery { segments })
}

struct Work<'s> {
    storage: &'s dyn Storage,
    folder: &'s Path,
}

/// What is to stay of a segment.
struct Kept {
    /// Where it ends, without a footer.
    end: u64,
    /// Records up to there, those that cannot be read any more included.
    records: u64,
    headers: crc32fast::Hasher,
    /// The footer behind it, if it is the right one.
    footer: Option<Footer>,
    /// Sequence number of the record that is torn.
    torn_record: Option<u64>,
}

impl Work<'_> {
    /// Nothing where the segment cannot be read: it stays as it is, and readers say so.
    fn recover(&self, number: u32) -> Result<Option<RecoveredSegment>, RawLogError> {
        let path = part_path(self.folder, number);
        let file = match self.storage.open_to_repair(&path) {
            Err(_) if self.storage.open(&path).is_err() => return Ok(None),
            file => file.map_err(RawLogError::io("open", &path))?,
        };
        let bytes = file.length().map_err(RawLogError::io("read", &path))?;
        let mut segment = match SegmentFile::open(file, &path, false) {
            Ok(segment) => segment,
            Err(OpenFault::Io(error)) => return Err(RawLogError::io("read", &path)(error)),
            Err(OpenFault::Header(HeaderFault::Incomplete)) => {
                return self.set_aside(number, bytes).map(Some);
            }
            Err(OpenFault::Header(HeaderFault::Damaged)) => return Ok(None),
            Err(OpenFault::Header(fault)) => return Err(RawLogError::header(path, fault)),
        };
        if !self.belongs_here(&segment, number) {
            return self.set_aside(number, bytes).map(Some);
        }
        let mut kept = keep(&segment)?;
        let torn = match kept.torn_from(&segment) {
            offset if offset < bytes => {
                Some(self.move_torn(number, &segment, offset..bytes, kept.torn_record)?)
            }
            _ => None,
        };
        if kept.footer.is_some_and(|footer| footer.ending == Ending::GoesOn)
            && !self.is_begun(number.saturating_add(1), &segment)?
        {
            // The next segment was never begun: the log ends here.
            kept.footer = None;
        }
        complete(&mut segment, &kept)?;
        drop(segment);
        give_sealed_name(self.storage, self.folder, number)?;
        let path = Some(sealed_path(self.folder, number));
        Ok(Some(RecoveredSegment { path, records: kept.records, torn }))
    }

    /// Whether this segment exists as one of the same log.
    fn is_begun(&self, number: u32, before: &SegmentFile) -> Result<bool, RawLogError> {
        let next = SegmentFile::find(self.storage, self.folder, number)?;
        Ok(next.is_some_and(|next| next.header.begun_ns == before.header.begun_ns))
    }

    /// Whether the header is that of a segment of this log, and not what an older file left in the
    /// disk's blocks.
    fn belongs_here(&self, segment: &SegmentFile, number: u32) -> bool {
        if number == 0 || segment.header.segment != number {
            return segment.header.segment == number;
        }
        let identity =
            |segment: &SegmentFile| (segment.header.begun_ns, segment.header.description.clone());
        // Where the first one cannot be read, nothing speaks against this one.
        let first = SegmentFile::find(self.storage, self.folder, 0).unwrap_or_default();
        first.is_none_or(|first| identity(&first) == identity(segment))
    }

    /// A segment without a header has no records: the whole file is torn.
    fn set_aside(&self, number: u32, bytes: u64) -> Result<RecoveredSegment, RawLogError> {
        let path = part_path(self.folder, number);
        let moved_to = self.unused_torn_path(number)?;
        self.rename(&path, &moved_to)?;
        let torn = TornTail { segment: path, offset: 0, bytes, moved_to, record: None };
        Ok(RecoveredSegment { path: None, records: 0, torn: Some(torn) })
    }

    /// Copies the torn tail, safe on disk, before it is cut.
    fn move_torn(
        &self,
        number: u32,
        segment: &SegmentFile,
        bytes: Range<u64>,
        record: Option<u64>,
    ) -> Result<TornTail, RawLogError> {
        let moved_to = self.unused_torn_path(number)?;
        let mut copy = self
            .storage
            .create(&moved_to)
            .map_err(RawLogError::io("keep a torn tail in", &moved_to))?;
        copy_bytes(segment, bytes.start, &mut *copy, &moved_to)?;
        copy.sync().map_err(RawLogError::io("flush to disk", &moved_to))?;
        self.storage
            .sync_folder(self.folder)
            .map_err(RawLogError::io("flush to disk", self.folder))?;
        Ok(TornTail {
            segment: segment.path.clone(),
            offset: bytes.start,
            bytes: bytes.end - bytes.start,
            moved_to,
            record,
        })
    }

    fn unused_torn_path(&self, number: u32) -> Result<PathBuf, RawLogError> {
        let names = self.names()?;
        let is_unused = |path: &PathBuf| {
            !names.iter().any(|name| path.file_name().is_some_and(|used| used == name.as_str()))
        };
        let mut paths = (1..=u32::MAX).map(|attempt| torn_path(self.folder, number, attempt));
        Ok(paths.find(is_unused).unwrap_or_else(|| torn_path(self.folder, number, 1)))
    }

    fn rename(&self, from: &Path, to: &Path) -> Result<(), RawLogError> {
        self.storage.rename(from, to).map_err(RawLogError::io("rename", from))?;
        self.storage.sync_folder(self.folder).map_err(RawLogError::io("flush to disk", self.folder))
    }

    fn names(&self) -> Result<Vec<String>, RawLogError> {
        self.storage.list(self.folder).map_err(RawLogError::io("list the folder", self.folder))
    }
}

/// Looks through a segment, around what is damaged.
fn keep(segment: &SegmentFile) -> Result<Kept, RawLogError> {
    let mut kept = Kept {
        end: segment.start,
        records: 0,
        headers: crc32fast::Hasher::new(),
        footer: None,
        torn_record: None,
    };
    loop {
        let found = segment.look(kept.end)?;
        match found {
            Found::Record(header) => {
                kept.end += header.record_bytes();
                kept.records = (header.sequence + 1).saturating_sub(segment.header.first_sequence);
                kept.headers.update(&header.encode(segment.salt));
            }
            Found::Footer(footer) => {
                kept.records = footer.records;
                kept.footer = Some(footer);
                return Ok(kept);
            }
            Found::Torn(header) => {
                kept.torn_record = Some(header.sequence);
                return Ok(kept);
            }
            Found::Nothing => {
                if let Some((at, _)) = segment.resynchronise(kept.end + 1)? {
                    kept.end = at;
                    continue;
                }
                if !segment.is_torn(kept.end, &found)? {
                    kept.end = segment.length()?;
                }
                return Ok(kept);
            }
        }
    }
}

impl Kept {
    /// Where that begins which is to be cut.
    fn torn_from(&self, segment: &SegmentFile) -> u64 {
        let footer = self.footer.map_or(0, |_| Footer::bytes(segment.header.version));
        self.end + footer as u64
    }

    fn new_footer(&self, segment: &SegmentFile) -> Footer {
        Footer {
            segment: segment.header.segment,
            records: self.records,
            length: self.end,
            headers_crc: self.headers.clone().finalize(),
            ending: Ending::CutOff,
        }
    }
}

/// Cuts what is torn and writes the footer that is missing, safe on disk.
fn complete(segment: &mut SegmentFile, kept: &Kept) -> Result<(), RawLogError> {
    let path = segment.path.clone();
    let footer = kept.new_footer(segment).encode(segment.header.version, segment.salt);
    let (end, file) = (kept.torn_from(segment), &mut segment.file);
    file.truncate(end).map_err(RawLogError::io("cut the torn end of", &path))?;
    if kept.footer.is_none() {
        file.append(&footer).map_err(RawLogError::io("write to", &path))?;
    }
    file.sync().map_err(RawLogError::io("flush to disk", &path))
}

fn copy_bytes(
    segment: &SegmentFile,
    mut offset: u64,
    copy: &mut dyn LogFile,
    copy_path: &Path,
) -> Result<(), RawLogError> {
    let mut bytes = vec![0; MOVED_BYTES];
    loop {
        let read = segment
            .file
            .read_at(offset, &mut bytes)
            .map_err(RawLogError::io("read", &segment.path))?;
        if read == 0 {
            return Ok(());
        }
        copy.append(&bytes[..read]).map_err(RawLogError::io("keep a torn tail in", copy_path))?;
        offset += read as u64;
    }
}

impl fmt::Display for TornTail {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { segment, offset, bytes, moved_to, record } = self;
        write!(
            formatter,
            "{bytes} bytes from byte {offset} of {} on were not written completely and are now in \
             {}",
            segment.display(),
            moved_to.display()
        )?;
        match record {
            Some(record) => write!(formatter, "; they were of record {record}"),
            None => Ok(()),
        }
    }
}
