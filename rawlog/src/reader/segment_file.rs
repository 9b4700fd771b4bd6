//! A segment opened for reading.

use std::{
    io::{self, ErrorKind},
    ops::{Range, RangeInclusive},
    path::{Path, PathBuf},
};

use lfpiv_hw::RawImage;

use super::super::{
    Damage, RawLogError,
    codec::decode,
    format::{
        FOOTER_MAGIC, Footer, HeaderFault, RECORD_HEADER_BYTES, RECORD_MAGIC, RecordHeader,
        SegmentHeader,
    },
    names::{part_path, sealed_path},
    storage::{LogFile, Storage},
};
pub(in super::super) use super::header_copies::OpenFault;
use super::{header_copies::read_header, search::find_bytes};

/// A segment with a readable header.
pub(in super::super) struct SegmentFile {
    pub file: Box<dyn LogFile>,
    pub path: PathBuf,
    pub header: SegmentHeader,
    pub salt: u32,
    /// Offset of its first record.
    pub start: u64,
    /// Whether it had its final name when it was opened.
    pub is_sealed: bool,
    /// Range of the damaged copy of the header, if any.
    pub damaged_header: Option<Range<u64>>,
}

/// What is at an offset of a segment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum SegmentItem {
    /// A complete record.
    Record(RecordHeader),
    /// A record cut off by the end of the file.
    Torn(RecordHeader),
    /// The footer.
    Footer(Footer),
    /// Neither: the end of the file, or damage.
    Nothing,
}

impl SegmentFile {
    /// Opens a segment, sealed or not; `None` if it does not exist or its header was never completed.
    pub fn find(
        storage: &dyn Storage,
        folder: &Path,
        number: u32,
    ) -> Result<Option<Self>, RawLogError> {
        let sealed = sealed_path(folder, number);
        // The writer may rename it between the first and the second attempt.
        for path in [&sealed, &part_path(folder, number), &sealed] {
            let file = match storage.open(path) {
                Ok(file) => file,
                Err(error) if error.kind() == ErrorKind::NotFound => continue,
                Err(error) => return Err(RawLogError::io("open", path)(error)),
            };
            let is_sealed = *path == sealed;
            return match Self::open(file, path, is_sealed) {
                Ok(segment) => Ok(Some(segment)),
                Err(OpenFault::Io(error)) => Err(RawLogError::io("read", path)(error)),
                Err(OpenFault::Header(HeaderFault::Incomplete)) if !is_sealed => Ok(None),
                Err(OpenFault::Header(fault)) => Err(RawLogError::header(path, fault)),
            };
        }
        Ok(None)
    }

    /// Reads the header of an opened file.
    pub fn open(file: Box<dyn LogFile>, path: &Path, is_sealed: bool) -> Result<Self, OpenFault> {
        let found = read_header(&*file)?;
        let (header, salt) = (found.decoded.header, found.decoded.salt);
        let length = found.decoded.length as u64;
        let start = length * header.copies() as u64;
        let damaged_header = found.damaged.map(|at| at..at + length);
        Ok(Self { file, path: path.into(), header, salt, start, is_sealed, damaged_header })
    }

    /// Identifies what is at `offset`.
    pub fn item_at(&self, offset: u64) -> Result<SegmentItem, RawLogError> {
        let mut bytes = [0; RECORD_HEADER_BYTES];
        let read = self.file.read_at(offset, &mut bytes).map_err(self.io())?;
        let bytes = &bytes[..read];
        if let Some(footer) = Footer::decode(bytes, self.header.version, self.salt) {
            return Ok(SegmentItem::Footer(footer));
        }
        let Some(header) = RecordHeader::decode(bytes, self.salt) else {
            return Ok(SegmentItem::Nothing);
        };
        let is_whole = offset + header.record_bytes() <= self.length()?;
        Ok(if is_whole { SegmentItem::Record(header) } else { SegmentItem::Torn(header) })
    }

    /// The head of the record at `offset`.
    pub fn head(&self, offset: u64, header: &RecordHeader) -> Result<Vec<u8>, RawLogError> {
        let head = self.read(offset + RECORD_HEADER_BYTES as u64, header.head_bytes)?;
        if crc32fast::hash(&head) != header.head_crc {
            return Err(self.damaged_record(offset, header, "the head of the record has changed"));
        }
        Ok(head)
    }

    /// The image of the record at `offset`, checked against the checksum of the recorded counts.
    pub fn image(
        &self,
        offset: u64,
        header: &RecordHeader,
    ) -> Result<Option<RawImage>, RawLogError> {
        if !header.has_image() {
            return Ok(None);
        }
        let at = offset + RECORD_HEADER_BYTES as u64 + u64::from(header.head_bytes);
        let stored = self.read(at, header.stored_bytes)?;
        if crc32fast::hash(&stored) != header.stored_crc {
            return Err(self.damaged_record(offset, header, "the image of the record has changed"));
        }
        decode(&stored, header.codec, header.columns, header.rows)
            .filter(|image| image.crc32() == header.image_crc)
            .map(Some)
            .ok_or_else(|| self.damaged_record(offset, header, "the image cannot be decoded"))
    }

    /// Finds the next record or footer at or after `offset`, by magic number, checksum and length. A
    /// record cut off by the end of the file counts.
    pub fn resynchronise(
        &self,
        mut offset: u64,
    ) -> Result<Option<(u64, SegmentItem)>, RawLogError> {
        let magics: [&[u8]; 2] = [&RECORD_MAGIC, &FOOTER_MAGIC];
        while let Some(at) =
            find_bytes(&*self.file, offset, u64::MAX, &magics).map_err(self.io())?
        {
            match self.item_at(at)? {
                SegmentItem::Nothing => offset = at + 1,
                found => return Ok(Some((at, found))),
            }
        }
        Ok(None)
    }

    /// Whether the bytes from `offset` to the end of the file can be the torn tail of a killed program:
    /// shorter than a header, or than the record that the header announces.
    pub fn is_torn(&self, offset: u64, found: &SegmentItem) -> Result<bool, RawLogError> {
        let left = self.length()?.saturating_sub(offset);
        Ok(matches!(found, SegmentItem::Torn(_)) || left < RECORD_HEADER_BYTES as u64)
    }

    /// Bytes in the file.
    pub fn length(&self) -> Result<u64, RawLogError> {
        self.file.length().map_err(self.io())
    }

    /// The error for damaged bytes, with the lost records if they are known.
    pub fn damaged(
        &self,
        bytes: Range<u64>,
        records: Option<RangeInclusive<u64>>,
        what: &'static str,
    ) -> RawLogError {
        RawLogError::Damaged(Damage { path: self.path.clone(), bytes, records, what })
    }

    fn damaged_record(
        &self,
        offset: u64,
        header: &RecordHeader,
        what: &'static str,
    ) -> RawLogError {
        let records = header.sequence..=header.sequence;
        self.damaged(offset..offset + header.record_bytes(), Some(records), what)
    }

    /// The bytes of a whole record, unchecked.
    pub fn bytes(&self, offset: u64, length: u64) -> Result<Vec<u8>, RawLogError> {
        let mut bytes = vec![0; usize::try_from(length).unwrap_or_default()];
        let read = self.file.read_at(offset, &mut bytes).map_err(self.io())?;
        bytes.truncate(read);
        Ok(bytes)
    }

    fn read(&self, offset: u64, length: u32) -> Result<Vec<u8>, RawLogError> {
        self.bytes(offset, u64::from(length))
    }

    fn io(&self) -> impl FnOnce(io::Error) -> RawLogError + use<'_> {
        RawLogError::io("read", &self.path)
    }
}
