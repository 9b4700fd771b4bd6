//! One segment, opened for reading.

use std::{
    io::{self, ErrorKind},
    path::{Path, PathBuf},
};

use lfpiv_hw::RawImage;

use super::super::{
    RawLogError,
    codec::decode,
    format::{
        FOOTER_BYTES, Footer, HeaderFault, RECORD_HEADER_BYTES, RECORD_MAGIC, RecordHeader,
        SegmentHeader,
    },
    names::{part_path, sealed_path},
    storage::{LogFile, Storage},
};

/// How much is read at once in search of a record.
const SEARCHED_BYTES: usize = 1 << 16;

/// A segment whose header is whole.
pub(in super::super) struct SegmentFile {
    pub file: Box<dyn LogFile>,
    pub path: PathBuf,
    pub header: SegmentHeader,
    pub salt: u32,
    /// Where its first record begins.
    pub start: u64,
    /// Whether it had its final name when it was opened.
    pub is_sealed: bool,
}

/// What lies at a place in a segment.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in super::super) enum Found {
    /// A record that is there to its last byte.
    Record(RecordHeader),
    /// The segment's end.
    Footer(Footer),
    /// Neither: the end of the file, half a record, or damage.
    Nothing,
}

/// Why a segment cannot be opened.
pub(in super::super) enum OpenFault {
    /// Its header.
    Header(HeaderFault),
    /// The operating system.
    Io(io::Error),
}

impl SegmentFile {
    /// Opens a segment under the name it has; nothing where it does not exist, or is just being
    /// created.
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
                Err(OpenFault::Header(HeaderFault::NewerVersion(found))) => {
                    Err(RawLogError::NewerVersion { path: path.into(), found })
                }
                Err(OpenFault::Header(_)) if !is_sealed => Ok(None),
                Err(OpenFault::Header(fault)) => Err(RawLogError::header(path, fault)),
            };
        }
        Ok(None)
    }

    /// Reads the header of an opened file.
    pub fn open(file: Box<dyn LogFile>, path: &Path, is_sealed: bool) -> Result<Self, OpenFault> {
        let read = |length: usize| {
            let mut bytes = vec![0; length];
            let read = file.read_at(0, &mut bytes).map_err(OpenFault::Io)?;
            bytes.truncate(read);
            Ok(bytes)
        };
        let start = read(SegmentHeader::START_BYTES)?;
        let length = SegmentHeader::length(&start).map_err(OpenFault::Header)?;
        if length as u64 > file.length().map_err(OpenFault::Io)? {
            return Err(OpenFault::Header(HeaderFault::Incomplete));
        }
        let (header, salt) = SegmentHeader::decode(&read(length)?).map_err(OpenFault::Header)?;
        Ok(Self { file, path: path.into(), header, salt, start: length as u64, is_sealed })
    }

    /// What lies at `offset`.
    pub fn look(&self, offset: u64) -> Result<Found, RawLogError> {
        let mut bytes = [0; RECORD_HEADER_BYTES];
        let read = self.file.read_at(offset, &mut bytes).map_err(self.io())?;
        let bytes = &bytes[..read];
        if let Some(footer) = Footer::decode(bytes, self.salt) {
            return Ok(Found::Footer(footer));
        }
        let Some(header) = RecordHeader::decode(bytes, self.salt) else {
            return Ok(Found::Nothing);
        };
        let is_whole = offset + header.record_bytes() <= self.file.length().map_err(self.io())?;
        Ok(if is_whole { Found::Record(header) } else { Found::Nothing })
    }

    /// The header of the record at `offset`, whole or not.
    pub fn header_at(&self, offset: u64) -> Result<Option<RecordHeader>, RawLogError> {
        let mut bytes = [0; RECORD_HEADER_BYTES];
        let read = self.file.read_at(offset, &mut bytes).map_err(self.io())?;
        Ok(RecordHeader::decode(&bytes[..read], self.salt))
    }

    /// The head of the record at `offset`.
    pub fn head(&self, offset: u64, header: &RecordHeader) -> Result<Vec<u8>, RawLogError> {
        let head = self.read(offset + RECORD_HEADER_BYTES as u64, header.head_bytes)?;
        if crc32fast::hash(&head) != header.head_crc {
            return Err(self.damaged(offset, "the head of a record has the wrong checksum"));
        }
        Ok(head)
    }

    /// The stored image of the record at `offset`; empty without one.
    pub fn stored(&self, offset: u64, header: &RecordHeader) -> Result<Vec<u8>, RawLogError> {
        let at = offset + RECORD_HEADER_BYTES as u64 + u64::from(header.head_bytes);
        let stored = self.read(at, header.stored_bytes)?;
        if crc32fast::hash(&stored) != header.stored_crc && header.has_image() {
            return Err(self.damaged(offset, "the image of a record has the wrong checksum"));
        }
        Ok(stored)
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
        let stored = self.stored(offset, header)?;
        decode(&stored, header.codec, header.columns, header.rows)
            .filter(|image| image.crc32() == header.image_crc)
            .map(Some)
            .ok_or_else(|| self.damaged(offset, "the image of a record cannot be decoded"))
    }

    /// Where the next record begins that is there to its last byte, from `offset` on.
    pub fn next_record(&self, mut offset: u64) -> Result<Option<u64>, RawLogError> {
        let mut bytes = vec![0; SEARCHED_BYTES];
        loop {
            let read = self.file.read_at(offset, &mut bytes).map_err(self.io())?;
            let candidates = bytes[..read].windows(RECORD_MAGIC.len()).enumerate();
            for (at, _) in candidates.filter(|(_, window)| *window == RECORD_MAGIC) {
                if let Found::Record(_) = self.look(offset + at as u64)? {
                    return Ok(Some(offset + at as u64));
                }
            }
            if read < bytes.len() {
                return Ok(None);
            }
            // A magic number may lie across the border.
            offset += (read - RECORD_MAGIC.len() + 1) as u64;
        }
    }

    /// The error for bytes at `offset` that are not what was written.
    pub fn damaged(&self, offset: u64, what: &'static str) -> RawLogError {
        RawLogError::Damaged { path: self.path.clone(), offset, what }
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

/// Bytes of a segment whose footer begins at `offset`.
pub(in super::super) fn end_behind_footer(offset: u64) -> u64 {
    offset + FOOTER_BYTES as u64
}
