//! After a crash: the segment that was being written is cut behind its last whole record and
//! sealed.

use std::{
    fmt,
    path::{Path, PathBuf},
};

use super::{
    RawLogError,
    format::{Footer, HeaderFault, RecordHeader},
    names::{parse, part_path, sealed_path, torn_path},
    reader::segment_file::{Found, OpenFault, SegmentFile, end_behind_footer},
    segments::give_sealed_name,
    storage::{Disk, LogFile, Storage},
};

/// How much is moved at once.
const MOVED_BYTES: usize = 1 << 20;

/// What recovery found and did.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Recovery {
    /// Segments that were not sealed: one after a crash, none otherwise.
    pub segments: Vec<RecoveredSegment>,
}

/// A segment that was not sealed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RecoveredSegment {
    /// Its name now; nothing where no record could be in it, because its header was torn.
    pub path: Option<PathBuf>,
    /// Whole records in it.
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
    /// Sequence numbers of records that it can be seen to have held, whole or in part.
    pub records: Vec<u64>,
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
    let segments = unsealed.map(|(number, _)| work.recover(number)).collect::<Result<_, _>>()?;
    Ok(Recovery { segments })
}

struct Work<'s> {
    storage: &'s dyn Storage,
    folder: &'s Path,
}

/// How far a segment is whole.
struct Whole {
    end: u64,
    records: u64,
    headers: crc32fast::Hasher,
    has_footer: bool,
}

impl Work<'_> {
    fn recover(&self, number: u32) -> Result<RecoveredSegment, RawLogError> {
        let path = part_path(self.folder, number);
        let file = self.storage.open_to_repair(&path).map_err(RawLogError::io("open", &path))?;
        let bytes = file.length().map_err(RawLogError::io("read", &path))?;
        let mut segment = match SegmentFile::open(file, &path, false) {
            Ok(segment) => segment,
            Err(OpenFault::Io(error)) => return Err(RawLogError::io("read", &path)(error)),
            Err(OpenFault::Header(HeaderFault::NewerVersion(found))) => {
                return Err(RawLogError::NewerVersion { path, found });
            }
            Err(OpenFault::Header(_)) => return self.set_aside(number, bytes),
        };
        if !self.belongs_here(&segment, number)? {
            return self.set_aside(number, bytes);
        }
        let whole = measure(&segment)?;
        let torn = if bytes > whole.end {
            Some(self.move_torn(number, &segment, whole.end, bytes)?)
        } else {
            None
        };
        complete(&mut segment, &whole)?;
        drop(segment);
        give_sealed_name(self.storage, self.folder, number)?;
        let path = Some(sealed_path(self.folder, number));
        Ok(RecoveredSegment { path, records: whole.records, torn })
    }

    /// Whether the header is that of a segment of this log, and not what an older file left in the
    /// disk's blocks.
    fn belongs_here(&self, segment: &SegmentFile, number: u32) -> Result<bool, RawLogError> {
        let header = &segment.header;
        if number == 0 || header.segment != number {
            return Ok(header.segment == number);
        }
        let first = SegmentFile::find(self.storage, self.folder, 0)?;
        Ok(first.is_none_or(|first| first.header.description == header.description))
    }

    /// A segment without a header has no records: the whole file is torn.
    fn set_aside(&self, number: u32, bytes: u64) -> Result<RecoveredSegment, RawLogError> {
        let path = part_path(self.folder, number);
        let moved_to = self.unused_torn_path(number)?;
        self.rename(&path, &moved_to)?;
        let torn = TornTail { segment: path, offset: 0, bytes, moved_to, records: Vec::new() };
        Ok(RecoveredSegment { path: None, records: 0, torn: Some(torn) })
    }

    /// Copies the torn tail, safe on disk, before it is cut.
    fn move_torn(
        &self,
        number: u32,
        segment: &SegmentFile,
        offset: u64,
        end: u64,
    ) -> Result<TornTail, RawLogError> {
        let moved_to = self.unused_torn_path(number)?;
        let mut copy = self
            .storage
            .create(&moved_to)
            .map_err(RawLogError::io("keep a torn tail in", &moved_to))?;
        copy_bytes(segment, offset, &mut *copy, &moved_to)?;
        copy.sync().map_err(RawLogError::io("flush to disk", &moved_to))?;
        self.storage
            .sync_folder(self.folder)
            .map_err(RawLogError::io("flush to disk", self.folder))?;
        Ok(TornTail {
            segment: segment.path.clone(),
            offset,
            bytes: end - offset,
            moved_to,
            records: torn_records(segment, offset)?,
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

/// How far the segment is whole: every record there, in order, with the right checksums.
fn measure(segment: &SegmentFile) -> Result<Whole, RawLogError> {
    let mut whole = Whole {
        end: segment.start,
        records: 0,
        headers: crc32fast::Hasher::new(),
        has_footer: false,
    };
    loop {
        match segment.look(whole.end)? {
            Found::Record(header) if is_next(segment, &whole, &header)? => {
                whole.end += header.record_bytes();
                whole.records += 1;
                whole.headers.update(&header.encode(segment.salt));
            }
            Found::Footer(footer) if footer == whole.footer(segment) => {
                whole.end = end_behind_footer(whole.end);
                whole.has_footer = true;
                return Ok(whole);
            }
            Found::Record(_) | Found::Footer(_) | Found::Nothing => return Ok(whole),
        }
    }
}

impl Whole {
    fn footer(&self, segment: &SegmentFile) -> Footer {
        Footer {
            segment: segment.header.segment,
            records: self.records,
            length: self.end,
            headers_crc: self.headers.clone().finalize(),
        }
    }
}

/// Whether the record is the one expected, with every byte of it right.
fn is_next(
    segment: &SegmentFile,
    whole: &Whole,
    header: &RecordHeader,
) -> Result<bool, RawLogError> {
    if header.sequence != segment.header.first_sequence + whole.records {
        return Ok(false);
    }
    let read = segment
        .head(whole.end, header)
        .and_then(|_| segment.stored(whole.end, header))
        .map(|_| true);
    match read {
        Err(RawLogError::Damaged { .. }) => Ok(false),
        read => read,
    }
}

/// Cuts what is torn and writes the footer that is missing, safe on disk.
fn complete(segment: &mut SegmentFile, whole: &Whole) -> Result<(), RawLogError> {
    let path = segment.path.clone();
    let file = &mut segment.file;
    file.truncate(whole.end).map_err(RawLogError::io("cut the torn end of", &path))?;
    if !whole.has_footer {
        let footer = whole.footer(segment).encode(segment.salt);
        segment.file.append(&footer).map_err(RawLogError::io("write to", &path))?;
    }
    segment.file.sync().map_err(RawLogError::io("flush to disk", &path))
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

/// Sequence numbers of the record that is torn, if its header is there, and of whole ones behind.
fn torn_records(segment: &SegmentFile, offset: u64) -> Result<Vec<u64>, RawLogError> {
    let mut records: Vec<u64> =
        segment.header_at(offset)?.map(|h| h.sequence).into_iter().collect();
    let mut from = offset + 1;
    while let Some(at) = segment.next_record(from)? {
        records.extend(segment.header_at(at)?.map(|header| header.sequence));
        from = at + 1;
    }
    Ok(records)
}

impl fmt::Display for TornTail {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { segment, offset, bytes, moved_to, records } = self;
        write!(
            formatter,
            "{bytes} bytes from byte {offset} of {} on were not written completely and are now in \
             {}",
            segment.display(),
            moved_to.display()
        )?;
        if records.is_empty() {
            return Ok(());
        }
        let numbers: Vec<String> = records.iter().map(u64::to_string).collect();
        write!(formatter, "; they were of the records {}", numbers.join(", "))
    }
}
