//! Along a log, record by record, through all segments, around whatever is damaged or missing.

use std::collections::VecDeque;

use crate::{
    Position, RawLogError,
    format::{Ending, Footer, Predecessor, RecordHeader},
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
    /// The segment before this one, if it was read to its end.
    left: Option<Left>,
    /// The first segment that was not there to be read since the last that was.
    first_unread: Option<u32>,
    /// What is wrong before the next record, to be told first.
    untold: VecDeque<RawLogError>,
    /// The end has been judged.
    is_over: bool,
}

/// A segment and what its footer must agree with.
struct OpenSegment {
    segment: SegmentFile,
    offset: u64,
    headers: crc32fast::Hasher,
    /// Something was wrong and has been told.
    is_damaged: bool,
}

/// A segment that was read to its end.
struct Left {
    number: u32,
    /// What the next segment must say of it.
    known_as: Predecessor,
    ending: Ending,
}

/// Where a record lies, and its header. It is in [`Scan::scanned`].
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
        Self {
            reader: reader.clone(),
            number: 0,
            open: None,
            expected: 0,
            left: None,
            first_unread: None,
            untold: VecDeque::new(),
            is_over: false,
        }
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
            if let Some(error) = self.untold.pop_front() {
                return Some(Err(error));
            }
            let look = if self.open.is_some() { self.advance() } else { self.enter() };
            match look {
                Ok(Look::Onward) => {}
                Ok(Look::Record(position, header)) => return Some(Ok((position, header))),
                Ok(Look::End) if self.untold.is_empty() => return None,
                Ok(Look::End) => {}
                Err(error) => return Some(Err(error)),
            }
        }
    }

    /// Opens the next segment.
    fn enter(&mut self) -> Result<Look, RawLogError> {
        if self.number == u32::MAX {
            return Ok(Look::End);
        }
        let segment = match self.reader.segment(self.number) {
            Ok(Some(segment)) => segment,
            Ok(None) => return self.skip_segment(),
            Err(error) => {
                self.note_unread();
                self.number = self.number.saturating_add(1);
                return Err(error);
            }
        };
        if let Some(copy) = &segment.damaged_header {
            let what = "one of the two copies of the segment's header; no record is lost";
            self.untold.push_back(segment.damaged(copy.clone(), None, what));
        }
        self.check_chain(&segment);
        self.note_missing(segment.header.first_sequence);
        self.first_unread = None;
        self.open = Some(OpenSegment {
            offset: segment.start,
            segment,
            headers: crc32fast::Hasher::new(),
            is_damaged: false,
        });
        Ok(Look::Onward)
    }

    /// Goes to the next segment that is there.
    fn skip_segment(&mut self) -> Result<Look, RawLogError> {
        if let Some(next) = self.reader.next_begun_segment(self.number)? {
            self.note_unread();
            self.number = next;
            return Ok(Look::Onward);
        }
        // A segment gets its final name only when the next one exists.
        if let Some(Left { number, ending: Ending::GoesOn, .. }) = self.left
            && !self.is_over
            && number.checked_add(1) == Some(self.number)
            && self.reader.is_sealed(number)
            && self.reader.segment(self.number)?.is_none()
        {
            self.is_over = true;
            self.untold.push_back(RawLogError::MissingEnd {
                folder: self.reader.folder().into(),
                first: self.expected,
                segment: self.number,
            });
        }
        Ok(Look::End)
    }

    fn note_unread(&mut self) {
        self.first_unread.get_or_insert(self.number);
    }

    /// Whether the segment follows the one that was read before it.
    fn check_chain(&mut self, segment: &SegmentFile) {
        let header = &segment.header;
        let before =
            self.left.take().filter(|left| left.number.checked_add(1) == Some(self.number));
        let is_chained = header.version > 1 && before.is_some();
        if is_chained && before.is_some_and(|left| left.known_as != header.predecessor) {
            let what = "the header does not name the segment before this one: one of the two is of \
                another log, or was written anew";
            self.untold.push_back(segment.damaged(0..segment.start, None, what));
        }
    }

    /// Notes records that are left out, once.
    fn note_missing(&mut self, found: u64) {
        let first = std::mem::replace(&mut self.expected, found);
        if found > first {
            let last_segment = self.number.saturating_sub(1);
            self.untold.push_back(RawLogError::Missing {
                folder: self.reader.folder().into(),
                records: first..=found - 1,
                segments: self.first_unread.map(|first| first..=last_segment),
            });
        }
    }

    /// Goes one record on, or out of the segment at its end.
    fn advance(&mut self) -> Result<Look, RawLogError> {
        let Some(open) = &mut self.open else { return Ok(Look::Onward) };
        let offset = open.offset;
        let mut found = open.segment.look(offset);
        let is_end = matches!(found, Ok(Found::Nothing | Found::Torn(_)));
        if is_end && !open.segment.is_sealed {
            if self.reader.next_begun_segment(self.number)?.is_none() {
                return self.end_of_unsealed(offset);
            }
            // The segment was finished after the first look.
            found = open.segment.look(offset);
        }
        match found {
            Ok(Found::Record(header)) if header.sequence != self.expected => {
                // Told first; then the record is looked at again.
                self.note_missing(header.sequence);
                Ok(Look::Onward)
            }
            Ok(Found::Record(header)) => {
                self.expected += 1;
                open.pass(&header);
                Ok(Look::Record(Position { segment: self.number, offset }, header))
            }
            Ok(Found::Footer(footer)) => {
                self.pass_footer(&footer);
                Ok(Look::Onward)
            }
            Ok(Found::Nothing | Found::Torn(_)) => self.skip_damage(offset),
            Err(error) => {
                self.leave();
                Err(error)
            }
        }
    }

    /// At the end of what is whole in a segment without a successor: beside a running writer there
    /// may be more later; after it, what lies there is damaged, or was not written completely.
    fn end_of_unsealed(&mut self, offset: u64) -> Result<Look, RawLogError> {
        let Some(open) = &self.open else { return Ok(Look::End) };
        let found = open.segment.look(offset)?;
        let is_torn = open.segment.is_torn(offset, &found)?;
        if !is_torn && open.segment.resynchronise(offset + 1)?.is_some() {
            return match open.segment.look(offset)? {
                Found::Nothing => self.skip_damage(offset),
                // A running writer has come by here in between.
                _ => Ok(Look::Onward),
            };
        }
        if !is_torn && self.reader.is_finished && !std::mem::replace(&mut self.is_over, true) {
            let bytes = offset..open.segment.length()?;
            self.untold.push_back(open.segment.damaged(bytes, None, NEITHER));
        }
        Ok(Look::End)
    }

    /// Goes to the next record, or the footer, behind bytes that are none.
    fn skip_damage(&mut self, offset: u64) -> Result<Look, RawLogError> {
        let Some(open) = &mut self.open else { return Ok(Look::Onward) };
        open.is_damaged = true;
        let (segment, expected) = (&open.segment, self.expected);
        let ahead = match segment.resynchronise(offset + 1) {
            Ok(ahead) => ahead,
            Err(error) => {
                self.leave();
                return Err(error);
            }
        };
        let length = segment.length()?;
        // The sequence number of the record behind the damage, if anything says it.
        let next = match ahead {
            Some((_, Found::Record(header) | Found::Torn(header))) => Some(header.sequence),
            Some((_, Found::Footer(footer))) => {
                Some(segment.header.first_sequence.saturating_add(footer.records))
            }
            _ => None,
        };
        let lost = next.filter(|next| *next > expected).map(|next| expected..=next - 1);
        let what = if offset >= length { NO_FOOTER } else { NEITHER };
        let bytes = offset.min(length)..ahead.map_or(length, |(at, _)| at);
        self.untold.push_back(segment.damaged(bytes, lost, what));
        self.expected = next.unwrap_or(expected).max(expected);
        match ahead {
            Some((at, _)) => open.offset = at,
            None => self.leave(),
        }
        Ok(Look::Onward)
    }

    fn pass_footer(&mut self, footer: &Footer) {
        let Some(open) = &self.open else { return };
        let header = &open.segment.header;
        let seen = Footer {
            segment: header.segment,
            records: self.expected.saturating_sub(header.first_sequence),
            length: open.offset,
            headers_crc: open.headers.clone().finalize(),
            ending: footer.ending,
        };
        // What is wrong has been told where it is wrong.
        if !open.is_damaged && seen != *footer {
            let bytes = open.offset..open.offset + Footer::bytes(header.version) as u64;
            let what = "the footer counts other records than there are";
            self.untold.push_back(open.segment.damaged(bytes, None, what));
        }
        let digest = footer.digest(header.version, open.segment.salt);
        let known_as = Predecessor { records: footer.records, digest };
        self.left = Some(Left { number: self.number, known_as, ending: footer.ending });
        self.leave();
    }

    fn leave(&mut self) {
        self.open = None;
        self.number = self.number.saturating_add(1);
    }
}

const NEITHER: &str = "neither a record nor the segment's end";
const NO_FOOTER: &str =
    "the segment ends without its footer: it was cut, and what followed is lost";

impl OpenSegment {
    fn pass(&mut self, header: &RecordHeader) {
        self.offset += header.record_bytes();
        self.headers.update(&header.encode(self.segment.salt));
    }
}
