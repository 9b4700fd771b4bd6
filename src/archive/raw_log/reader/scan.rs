//! Along a log, record by record, through all segments.

use crate::archive::raw_log::{
    Position, RawLogError,
    format::{Footer, RecordHeader},
};

use super::{
    RawLogReader,
    segment_file::{Found, SegmentFile},
};

/// A place in the log, and what has been seen on the way.
pub(super) struct Scan {
    reader: RawLogReader,
    /// The segment that is or will be read.
    number: u32,
    open: Option<OpenSegment>,
    /// Sequence number of the next record, if none is missing.
    expected: u64,
}

/// A segment and what its footer must agree with.
struct OpenSegment {
    segment: SegmentFile,
    offset: u64,
    records: u64,
    headers: crc32fast::Hasher,
    /// Something was wrong and has been told.
    is_damaged: bool,
}

/// Where a record lies, and its header. It is in [`Scan::segment`].
pub(super) type Step = Result<(Position, RecordHeader), RawLogError>;

/// What one look gave.
enum Look {
    Record(Position, RecordHeader),
    /// Something else: look again.
    Onward,
    /// The end of what is whole.
    End,
}

impl Scan {
    pub fn new(reader: &RawLogReader) -> Self {
        Self { reader: reader.clone(), number: 0, open: None, expected: 0 }
    }

    /// The segment that the last step was in.
    ///
    /// # Errors
    /// There was no step.
    pub fn scanned(&self) -> Result<&SegmentFile, RawLogError> {
        let segment = self.open.as_ref().map(|open| &open.segment);
        segment.ok_or_else(|| RawLogError::NoSegment { folder: self.reader.folder().to_owned() })
    }

    /// The next record, or what is wrong before it; nothing at the end of what is whole. Beside a
    /// running writer there may be more later.
    pub fn step(&mut self) -> Option<Step> {
        loop {
            let look = if self.open.is_some() { self.advance() } else { self.enter() };
            match look {
                Ok(Look::Onward) => {}
                Ok(Look::Record(position, header)) => return Some(Ok((position, header))),
                Ok(Look::End) => return None,
                Err(error) => return Some(Err(error)),
            }
        }
    }

    /// Opens the next segment.
    fn enter(&mut self) -> Result<Look, RawLogError> {
        let segment = match self.reader.segment(self.number) {
            Ok(Some(segment)) => segment,
            Ok(None) if !self.reader.has_segment_behind(self.number)? => return Ok(Look::End),
            nothing_or_error => {
                self.number += 1;
                return nothing_or_error.map(|_| Look::Onward);
            }
        };
        let first = segment.header.first_sequence;
        self.open = Some(OpenSegment {
            offset: segment.start,
            segment,
            records: 0,
            headers: crc32fast::Hasher::new(),
            is_damaged: false,
        });
        note_gap(&self.reader, &mut self.expected, first)?;
        Ok(Look::Onward)
    }

    /// Goes one record on, or out of the segment at its end.
    fn advance(&mut self) -> Result<Look, RawLogError> {
        let Some(open) = &mut self.open else { return Ok(Look::Onward) };
        let offset = open.offset;
        let mut found = open.segment.look(offset);
        if matches!(found, Ok(Found::Nothing)) && !open.segment.is_sealed {
            if self.reader.segment(self.number + 1)?.is_none() {
                return Ok(Look::End);
            }
            // The segment was finished after the first look.
            found = open.segment.look(offset);
        }
        match found {
            Ok(Found::Record(header)) => {
                note_gap(&self.reader, &mut self.expected, header.sequence)?;
                self.expected += 1;
                open.pass(&header);
                Ok(Look::Record(Position { segment: self.number, offset }, header))
            }
            Ok(Found::Footer(footer)) => {
                let verdict = open.judge(&footer);
                self.leave();
                verdict.map(|()| Look::Onward)
            }
            Ok(Found::Nothing) => Err(self.skip_damage()),
            Err(error) => {
                self.leave();
                Err(error)
            }
        }
    }

    /// Goes to the next record behind bytes that are none.
    fn skip_damage(&mut self) -> RawLogError {
        let folder = self.reader.folder();
        let Some(open) = &mut self.open else {
            return RawLogError::NoSegment { folder: folder.into() };
        };
        let error = open.segment.damaged(open.offset, "there is neither a record nor the end");
        open.is_damaged = true;
        match open.segment.next_record(open.offset + 1) {
            Ok(Some(next)) => open.offset = next,
            Ok(None) | Err(_) => self.leave(),
        }
        error
    }

    fn leave(&mut self) {
        self.open = None;
        self.number += 1;
    }
}

impl OpenSegment {
    fn pass(&mut self, header: &RecordHeader) {
        self.offset += header.record_bytes();
        self.records += 1;
        self.headers.update(&header.encode(self.segment.salt));
    }

    /// Whether the footer agrees with what came before it.
    fn judge(&self, footer: &Footer) -> Result<(), RawLogError> {
        let seen = Footer {
            segment: self.segment.header.segment,
            records: self.records,
            length: self.offset,
            headers_crc: self.headers.clone().finalize(),
        };
        // What is wrong has been told where it is wrong.
        if self.is_damaged || seen == *footer {
            return Ok(());
        }
        Err(self.segment.damaged(self.offset, "the footer counts other records than there are"))
    }
}

/// An error where sequence numbers are left out, once: the record behind the gap comes after it.
fn note_gap(reader: &RawLogReader, expected: &mut u64, found: u64) -> Result<(), RawLogError> {
    let first = std::mem::replace(expected, found);
    if found <= first {
        return Ok(());
    }
    Err(RawLogError::Missing { folder: reader.folder().into(), first, last: found - 1 })
}
