//! Scans a log record by record, across segments, past damaged and missing data.

use std::collections::VecDeque;

use crate::{
    Position, RawLogError,
    format::{Ending, Footer, Predecessor, RecordHeader},
};

use super::{
    RawLogReader,
    segment_file::{SegmentFile, SegmentItem},
};

/// A position in the log, and what was found before it.
pub(super) struct Scan {
    reader: RawLogReader,
    /// The segment that is or will be read.
    number: u32,
    open: Option<SegmentScan>,
    /// Sequence number of the next record, if none is missing.
    expected: u64,
    /// The previous segment, if it was read to its end.
    previous: Option<FinishedSegment>,
    /// The first of the segments that could not be read since the last readable one.
    first_unreadable: Option<u32>,
    /// Errors to report before the next record.
    pending_errors: VecDeque<RawLogError>,
    /// The end of the log has been checked.
    end_reported: bool,
}

/// A segment being read, with the totals to compare with its footer.
struct SegmentScan {
    segment: SegmentFile,
    offset: u64,
    headers: crc32fast::Hasher,
    /// Damage in this segment has been reported.
    is_damaged: bool,
}

/// A segment that was read to its end.
struct FinishedSegment {
    number: u32,
    /// What the next segment's header must state about it.
    expected_predecessor: Predecessor,
    ending: Ending,
}

/// Position and header of a record in [`Scan::scanned`].
pub(super) type Step = Result<(Position, RecordHeader), RawLogError>;

/// Result of one attempt to advance.
enum Advance {
    Record(Position, RecordHeader),
    /// The scan has moved: try again.
    Moved,
    /// No further complete record.
    End,
}

impl Scan {
    pub fn new(reader: &RawLogReader) -> Self {
        Self {
            reader: reader.clone(),
            number: 0,
            open: None,
            expected: 0,
            previous: None,
            first_unreadable: None,
            pending_errors: VecDeque::new(),
            end_reported: false,
        }
    }

    /// The segment of the last step.
    ///
    /// # Errors
    /// No step was taken yet.
    pub fn scanned(&self) -> Result<&SegmentFile, RawLogError> {
        let segment = self.open.as_ref().map(|open| &open.segment);
        segment.ok_or_else(|| RawLogError::NoSegment { folder: self.reader.folder().to_owned() })
    }

    /// The next record or the next error; `None` after the last complete record. During a run there may
    /// be more later.
    pub fn step(&mut self) -> Option<Step> {
        loop {
            if let Some(error) = self.pending_errors.pop_front() {
                return Some(Err(error));
            }
            let advance = if self.open.is_some() { self.advance() } else { self.enter() };
            match advance {
                Ok(Advance::Moved) => {}
                Ok(Advance::Record(position, header)) => return Some(Ok((position, header))),
                Ok(Advance::End) if self.pending_errors.is_empty() => return None,
                Ok(Advance::End) => {}
                Err(error) => return Some(Err(error)),
            }
        }
    }

    /// Opens the next segment.
    fn enter(&mut self) -> Result<Advance, RawLogError> {
        if self.number == u32::MAX {
            return Ok(Advance::End);
        }
        let segment = match self.reader.segment(self.number) {
            Ok(Some(segment)) => segment,
            Ok(None) => return self.skip_segment(),
            Err(error) => {
                self.note_unreadable();
                self.number = self.number.saturating_add(1);
                return Err(error);
            }
        };
        if let Some(copy) = &segment.damaged_header {
            let what =
                "one of the two copies of the segment's header is damaged; no record is lost";
            self.pending_errors.push_back(segment.damaged(copy.clone(), None, what));
        }
        self.check_chain(&segment);
        self.report_missing(segment.header.first_sequence);
        self.first_unreadable = None;
        self.open = Some(SegmentScan {
            offset: segment.start,
            segment,
            headers: crc32fast::Hasher::new(),
            is_damaged: false,
        });
        Ok(Advance::Moved)
    }

    /// Moves to the next segment that exists.
    fn skip_segment(&mut self) -> Result<Advance, RawLogError> {
        if let Some(next) = self.reader.next_existing_segment(self.number)? {
            self.note_unreadable();
            self.number = next;
            return Ok(Advance::Moved);
        }
        // A segment gets its final name only when the next one exists.
        if let Some(FinishedSegment { number, ending: Ending::Continues, .. }) = self.previous
            && !self.end_reported
            && number.checked_add(1) == Some(self.number)
            && self.reader.is_sealed(number)
            && self.reader.segment(self.number)?.is_none()
        {
            self.end_reported = true;
            self.pending_errors.push_back(RawLogError::MissingEnd {
                folder: self.reader.folder().into(),
                first: self.expected,
                segment: self.number,
            });
        }
        Ok(Advance::End)
    }

    fn note_unreadable(&mut self) {
        self.first_unreadable.get_or_insert(self.number);
    }

    /// Checks that the segment follows the one that was read before it.
    fn check_chain(&mut self, segment: &SegmentFile) {
        let header = &segment.header;
        let before = self
            .previous
            .take()
            .filter(|previous| previous.number.checked_add(1) == Some(self.number));
        let is_chained = header.version > 1 && before.is_some();
        if is_chained
            && before.is_some_and(|previous| previous.expected_predecessor != header.predecessor)
        {
            let what = "the header does not name the segment before this one: one of the two is of \
                another log, or was rewritten";
            self.pending_errors.push_back(segment.damaged(0..segment.start, None, what));
        }
    }

    /// Reports missing records once.
    fn report_missing(&mut self, found: u64) {
        let first = std::mem::replace(&mut self.expected, found);
        if found > first {
            let last_segment = self.number.saturating_sub(1);
            self.pending_errors.push_back(RawLogError::Missing {
                folder: self.reader.folder().into(),
                records: first..=found - 1,
                segments: self.first_unreadable.map(|first| first..=last_segment),
            });
        }
    }

    /// Advances by one record, or leaves the segment at its end.
    fn advance(&mut self) -> Result<Advance, RawLogError> {
        let Some(open) = &mut self.open else { return Ok(Advance::Moved) };
        let offset = open.offset;
        let mut found = open.segment.item_at(offset);
        let is_end = matches!(found, Ok(SegmentItem::Nothing | SegmentItem::Torn(_)));
        if is_end && !open.segment.is_sealed {
            if self.reader.next_existing_segment(self.number)?.is_none() {
                return self.end_of_unsealed(offset);
            }
            // The writer has sealed the segment since the first look.
            found = open.segment.item_at(offset);
        }
        match found {
            Ok(SegmentItem::Record(header)) if header.sequence != self.expected => {
                // The gap is reported first; then the record is read again.
                self.report_missing(header.sequence);
                Ok(Advance::Moved)
            }
            Ok(SegmentItem::Record(header)) => {
                self.expected += 1;
                open.add(&header);
                Ok(Advance::Record(Position { segment: self.number, offset }, header))
            }
            Ok(SegmentItem::Footer(footer)) => {
                self.check_footer(&footer);
                Ok(Advance::Moved)
            }
            Ok(SegmentItem::Nothing | SegmentItem::Torn(_)) => self.skip_damage(offset),
            Err(error) => {
                self.leave();
                Err(error)
            }
        }
    }

    /// Handles the end of complete records in a segment without a successor. During a run more may
    /// follow; after it, the rest is damaged or torn.
    fn end_of_unsealed(&mut self, offset: u64) -> Result<Advance, RawLogError> {
        let Some(open) = &self.open else { return Ok(Advance::End) };
        let found = open.segment.item_at(offset)?;
        let is_torn = open.segment.is_torn(offset, &found)?;
        if !is_torn && open.segment.resynchronise(offset + 1)?.is_some() {
            return match open.segment.item_at(offset)? {
                SegmentItem::Nothing => self.skip_damage(offset),
                // A running writer has advanced in the meantime.
                _ => Ok(Advance::Moved),
            };
        }
        if !is_torn && self.reader.is_finished && !std::mem::replace(&mut self.end_reported, true) {
            let bytes = offset..open.segment.length()?;
            self.pending_errors.push_back(open.segment.damaged(
                bytes,
                None,
                NEITHER_RECORD_NOR_FOOTER,
            ));
        }
        Ok(Advance::End)
    }

    /// Skips damaged bytes up to the next record or footer.
    fn skip_damage(&mut self, offset: u64) -> Result<Advance, RawLogError> {
        let Some(open) = &mut self.open else { return Ok(Advance::Moved) };
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
        // Sequence number of the record after the damage, if it is known.
        let next = match ahead {
            Some((_, SegmentItem::Record(header) | SegmentItem::Torn(header))) => {
                Some(header.sequence)
            }
            Some((_, SegmentItem::Footer(footer))) => {
                Some(segment.header.first_sequence.saturating_add(footer.records))
            }
            _ => None,
        };
        let lost = next.filter(|next| *next > expected).map(|next| expected..=next - 1);
        let what = if offset >= length { NO_FOOTER } else { NEITHER_RECORD_NOR_FOOTER };
        let bytes = offset.min(length)..ahead.map_or(length, |(at, _)| at);
        self.pending_errors.push_back(segment.damaged(bytes, lost, what));
        self.expected = next.unwrap_or(expected).max(expected);
        match ahead {
            Some((at, _)) => open.offset = at,
            None => self.leave(),
        }
        Ok(Advance::Moved)
    }

    fn check_footer(&mut self, footer: &Footer) {
        let Some(open) = &self.open else { return };
        let header = &open.segment.header;
        let seen = Footer {
            segment: header.segment,
            records: self.expected.saturating_sub(header.first_sequence),
            length: open.offset,
            headers_crc: open.headers.clone().finalize(),
            ending: footer.ending,
        };
        // Damage was reported where it was found.
        if !open.is_damaged && seen != *footer {
            let bytes = open.offset..open.offset + Footer::bytes(header.version) as u64;
            let what = "the footer does not match the records before it";
            self.pending_errors.push_back(open.segment.damaged(bytes, None, what));
        }
        let digest = footer.digest(header.version, open.segment.salt);
        let expected_predecessor = Predecessor { records: footer.records, digest };
        self.previous = Some(FinishedSegment {
            number: self.number,
            expected_predecessor,
            ending: footer.ending,
        });
        self.leave();
    }

    fn leave(&mut self) {
        self.open = None;
        self.number = self.number.saturating_add(1);
    }
}

const NEITHER_RECORD_NOR_FOOTER: &str = "neither a record nor the segment's end";
const NO_FOOTER: &str =
    "the segment ends without its footer: it was cut, and what followed is lost";

impl SegmentScan {
    fn add(&mut self, header: &RecordHeader) {
        self.offset += header.record_bytes();
        self.headers.update(&header.encode(self.segment.salt));
    }
}
