//! Recovery after a crash: cuts the torn tail of the unsealed segment and seals it. Damage before
//! its last record stays; readers skip and report it.

use std::{
    fmt,
    ops::Range,
    path::{Path, PathBuf},
};

use super::{
    RawLogError,
    format::{Ending, Footer, HeaderFault},
    names::{parse, part_path, sealed_path, torn_path},
    reader::segment_file::{OpenFault, SegmentFile, SegmentItem},
    segments::rename_sealed,
    storage::{Disk, LogFile, Storage},
};

/// Bytes copied at once.
const COPY_BYTES: usize = 1 << 20;

/// Result of a recovery.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Recovery {
    /// Segments that were not sealed: one after a crash, two after a crash between two segments, none
    /// otherwise.
    pub segments: Vec<RecoveredSegment>,
}

/// A segment that was not sealed.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct RecoveredSegment {
    /// Its new name; `None` if its header was torn, so that it could hold no record.
    pub path: Option<PathBuf>,
    /// Number of its records, including damaged ones.
    pub records: u64,
    /// The tail that was cut.
    pub torn: Option<TornTail>,
}

/// The torn tail of a segment.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TornTail {
    /// The segment's former name.
    pub segment: PathBuf,
    /// Offset of the tail in the segment.
    pub offset: u64,
    /// Its length.
    pub bytes: u64,
    /// The file that holds it now.
    pub moved_to: PathBuf,
    /// Sequence number of the record that it belongs to, if known.
    pub record: Option<u64>,
}

/// Repairs a log after a crash or a disk failure: moves the torn tail to `NAME.torn` and seals the
/// segment. Sealed segments are not touched, and a second call changes nothing. Must not run beside
/// a writer.
///
/// # Errors
/// There is no log in `folder`, a newer program wrote it, or a file operation fails.
pub fn recover(folder: &Path) -> Result<Recovery, RawLogError> {
    recover_on(&Disk, folder)
}

pub(super) fn recover_on(storage: &dyn Storage, folder: &Path) -> Result<Recovery, RawLogError> {
    let work = Repair { storage, folder };
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

struct Repair<'s> {
    storage: &'s dyn Storage,
    folder: &'s Path,
}

/// The valid part of a segment.
struct ValidPart {
    /// Its end, without the footer.
    end: u64,
    /// Number of its records, including unreadable ones.
    records: u64,
    headers: crc32fast::Hasher,
    /// The footer after it, if it matches.
    footer: Option<Footer>,
    /// Sequence number of the torn record.
    torn_record: Option<u64>,
}

impl Repair<'_> {
    /// Seals one segment. `None` if it cannot be read: it is left alone, and readers report it.
    fn recover(&self, number: u32) -> Result<Option<RecoveredSegment>, RawLogError> {
        let path = part_path(self.folder, number);
        let file = match self.storage.open_writable(&path) {
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
        let mut valid = scan_valid(&segment)?;
        let torn = match valid.cut_offset(&segment) {
            offset if offset < bytes => {
                Some(self.save_torn_tail(number, &segment, offset..bytes, valid.torn_record)?)
            }
            _ => None,
        };
        if valid.footer.is_some_and(|footer| footer.ending == Ending::Continues)
            && !self.exists_in_same_log(number.saturating_add(1), &segment)?
        {
            // The next segment was never completed: the log ends here.
            valid.footer = None;
        }
        complete(&mut segment, &valid)?;
        drop(segment);
        rename_sealed(self.storage, self.folder, number)?;
        let path = Some(sealed_path(self.folder, number));
        Ok(Some(RecoveredSegment { path, records: valid.records, torn }))
    }

    /// Whether this segment exists and belongs to the same log.
    fn exists_in_same_log(&self, number: u32, before: &SegmentFile) -> Result<bool, RawLogError> {
        let next = SegmentFile::find(self.storage, self.folder, number)?;
        Ok(next.is_some_and(|next| next.header.created_ns == before.header.created_ns))
    }

    /// Whether the header belongs to a segment of this log, and not to an older file whose blocks the
    /// disk reused.
    fn belongs_here(&self, segment: &SegmentFile, number: u32) -> bool {
        if number == 0 || segment.header.segment != number {
            return segment.header.segment == number;
        }
        let identity =
            |segment: &SegmentFile| (segment.header.created_ns, segment.header.description.clone());
        // If the first segment cannot be read, there is no evidence against this one.
        let first = SegmentFile::find(self.storage, self.folder, 0).unwrap_or_default();
        first.is_none_or(|first| identity(&first) == identity(segment))
    }

    /// Moves a segment without a header aside: it has no records, so the whole file is torn.
    fn set_aside(&self, number: u32, bytes: u64) -> Result<RecoveredSegment, RawLogError> {
        let path = part_path(self.folder, number);
        let moved_to = self.unused_torn_path(number)?;
        self.rename(&path, &moved_to)?;
        let torn = TornTail { segment: path, offset: 0, bytes, moved_to, record: None };
        Ok(RecoveredSegment { path: None, records: 0, torn: Some(torn) })
    }

    /// Copies the torn tail and syncs the copy before the tail is cut.
    fn save_torn_tail(
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
            .map_err(RawLogError::io("save a torn tail in", &moved_to))?;
        copy_bytes(segment, bytes.start, &mut *copy, &moved_to)?;
        copy.sync().map_err(RawLogError::io("sync", &moved_to))?;
        self.storage.sync_folder(self.folder).map_err(RawLogError::io("sync", self.folder))?;
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
        self.storage.sync_folder(self.folder).map_err(RawLogError::io("sync", self.folder))
    }

    fn names(&self) -> Result<Vec<String>, RawLogError> {
        self.storage.list(self.folder).map_err(RawLogError::io("list the folder", self.folder))
    }
}

/// Scans a segment, past damaged records.
fn scan_valid(segment: &SegmentFile) -> Result<ValidPart, RawLogError> {
    let mut valid = ValidPart {
        end: segment.start,
        records: 0,
        headers: crc32fast::Hasher::new(),
        footer: None,
        torn_record: None,
    };
    loop {
        let found = segment.item_at(valid.end)?;
        match found {
            SegmentItem::Record(header) => {
                valid.end += header.record_bytes();
                valid.records = (header.sequence + 1).saturating_sub(segment.header.first_sequence);
                valid.headers.update(&header.encode(segment.salt));
            }
            SegmentItem::Footer(footer) => {
                valid.records = footer.records;
                valid.footer = Some(footer);
                return Ok(valid);
            }
            SegmentItem::Torn(header) => {
                valid.torn_record = Some(header.sequence);
                return Ok(valid);
            }
            SegmentItem::Nothing => {
                if let Some((at, _)) = segment.resynchronise(valid.end + 1)? {
                    valid.end = at;
                    continue;
                }
                if !segment.is_torn(valid.end, &found)? {
                    valid.end = segment.length()?;
                }
                return Ok(valid);
            }
        }
    }
}

impl ValidPart {
    /// Offset from which the segment is cut.
    fn cut_offset(&self, segment: &SegmentFile) -> u64 {
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

/// Cuts the torn tail, writes the missing footer and syncs.
fn complete(segment: &mut SegmentFile, valid: &ValidPart) -> Result<(), RawLogError> {
    let path = segment.path.clone();
    let footer = valid.new_footer(segment).encode(segment.header.version, segment.salt);
    let (end, file) = (valid.cut_offset(segment), &mut segment.file);
    file.truncate(end).map_err(RawLogError::io("cut the torn end of", &path))?;
    if valid.footer.is_none() {
        file.append(&footer).map_err(RawLogError::io("write to", &path))?;
    }
    file.sync().map_err(RawLogError::io("sync", &path))
}

fn copy_bytes(
    segment: &SegmentFile,
    mut offset: u64,
    copy: &mut dyn LogFile,
    copy_path: &Path,
) -> Result<(), RawLogError> {
    let mut bytes = vec![0; COPY_BYTES];
    loop {
        let read = segment
            .file
            .read_at(offset, &mut bytes)
            .map_err(RawLogError::io("read", &segment.path))?;
        if read == 0 {
            return Ok(());
        }
        copy.append(&bytes[..read]).map_err(RawLogError::io("save a torn tail in", copy_path))?;
        offset += read as u64;
    }
}

impl fmt::Display for TornTail {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { segment, offset, bytes, moved_to, record } = self;
        write!(
            formatter,
            "{bytes} bytes of {}, from byte {offset} on, were not written completely and are now in \
             {}",
            segment.display(),
            moved_to.display()
        )?;
        match record {
            Some(record) => write!(formatter, "; they belong to record {record}"),
            None => Ok(()),
        }
    }
}
