//! One segment, opened for reading.

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

/// A segment whose header can be read.
pub(in super::super) struct SegmentFile {
    pub file: Box<dyn LogFile>,
    pub path: PathBuf,
    pub header: SegmentHeader,
    pub salt: u32,
    /// Where its first record begins.
    pub start: u64,
    /// Whether it had its final name when it was opened.
    pub is_sealed: bool,
    /// The copy of the header that is damaged.
    pub damaged_header: Option<Range<u64>>,
}

/// What lies at a place in a segment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum Found {
    /// A record that is there to its last byte.
    Record(RecordHeader),
    /// A record that the file ends in.
    Torn(RecordHeader),
    /// The segment's end.
    Footer(Footer),
    /// None of these: the end of the file, or damage.
    Nothing,
}

impl SegmentFile {
    /// Opens a segment under the name it has; nothing where it does not exist, or was never begun.
    pub fn find(
        storage: &dyn Storage,
        folder: &Path,
        number: u32,
    ) -> Result<Option<Self>, RawLogError> {
        let sealed = sealed_path(folder, number);
        // It may be given its final name between the first look and the second.
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

    /// What lies at `offset`.
    pub fn look(&self, offset: u64) -> Result<Found, RawLogError> {
        let mut bytes = [0; RECORD_HEADER_BYTES];
        let read = self.file.read_at(offset, &mut bytes).map_err(self.io())?;
        let bytes = &bytes[..read];
        if let Some(footer) = Footer::decode(bytes, self.header.version, self.salt) {
            return Ok(Found::Footer(footer));
        }
        let Some(header) = RecordHeader::decode(bytes, self.salt) else {
            return Ok(Found::Nothing);
        };
        let is_whole = offset + header.record_bytes() <= self.length()?;
        Ok(if is_whole { Found::Record(header) } else { Found::Torn(header) })
    }

    /// The head of the record at `offset`.
    pub fn head(&self, offset: u64, header: &RecordHeader) -> Result<Vec<u8>, RawLogError> {
        let head = self.read(offset + RECORD_HEADER_BYTES as u64, header.head_bytes)?;
        if crc32fast::hash(&head) != header.head_crc {
            return Err(self.damaged_record(offset, header, "the head of the record has changed"));
        }
        Ok(head)
    }

    /// The image of the record at `offset`, checked against the checksum of what was recorded.
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

    /// Where a record or the footer begins at `offset` or behind it, by magic number, checksum and
    /// length, and what it is. A record that the file ends in counts, too.
    pub fn resynchronise(&self, mut offset: u64) -> Result<Option<(u64, Found)>, RawLogError> {
        let magics: [&[u8]; 2] = [&RECORD_MAGIC, &FOOTER_MAGIC];
        while let Some(at) =
            find_bytes(&*self.file, offset, u64::MAX, &magics).map_err(self.io())?
        {
            match self.look(at)? {
                Found::Nothing => offset = at + 1,
                found => return Ok(Some((at, found))),
            }
        }
        Ok(None)
    }

    /// Whether the bytes from `offset` to the end of the file are what a death of the program may
    /// leave of a record: fewer than a header has, or fewer than the header announces.
    pub fn is_torn(&self, offset: u64, found: &Found) -> Result<bool, RawLogError> {
        let left = self.length()?.saturating_sub(offset);
        Ok(matches!(found, Found::Torn(_)) || left < RECORD_HEADER_BYTES as u64)
    }

    /// Bytes in the file.
    pub fn length(&self) -> Result<u64, RawLogError> {
        self.file.length().map_err(self.io())
    }

    /// The error for bytes that are not what was written, and the records lost with them as far as
    /// they are known.
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

    fn read(&self, offset: u64, length: u32) -> Result<Vec<u8>, RawLogError> {
        let mut bytes = vec![0; length as usize];
        let read = self.file.read_at(offset, &mut bytes).map_err(self.io())?;
        bytes.truncate(read);
        Ok(bytes)
    }

    fn io(&self) -> impl FnOnce(io::Error) -> RawLogError + use<'_> {
        RawLogError::io("read", &self.path)
    }
}
