//! Records into segments, on one thread: the order of writes, syncs and renames.
//!
//! What is promised, and why it holds:
//!
//! - *Written* records are in the kernel's hands: the batch's write call has returned.
//! - *Synced* records survive a power cut: their segment's content was synced after that, and its
//!   name, under which it was created, before the first of them.
//! - A segment gets its final name only when the next one exists, with its header safe on disk: a
//!   sealed segment that says "the log goes on" without a next one has lost it. Records go into the
//!   next one only behind that, so at most one segment that is not sealed lacks its footer.
//! - A write that fails is cut off again, so that the file ends with the last written record.

use std::{
    path::{Path, PathBuf},
    sync::Arc,
    time::{SystemTime, UNIX_EPOCH},
};

use super::{
    RawLogError, Record,
    codec::{Encoder, STORED_RAW},
    format::{
        Ending, FORMAT_VERSION, Footer, MOST_HEADER_BYTES, Predecessor, RECORD_HEADER_BYTES,
        RecordHeader, SegmentHeader,
    },
    names::{part_path, sealed_path},
    settings::Limits,
    storage::{LogFile, Storage},
};

/// Records are gathered up to here before they are written: small ones are not worth a call each.
const BATCH_BYTES: usize = 1 << 20;

/// The segments of a log that is being written.
pub(super) struct Segments {
    storage: Arc<dyn Storage>,
    folder: PathBuf,
    identity: Identity,
    segment_bytes: u64,
    encoder: Encoder,
    current: OpenSegment,
    /// Encoded records that are not written yet.
    batch: Vec<u8>,
    batch_records: u64,
    progress: Progress,
}

/// How far records have got, and in how many bytes.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Progress {
    /// Records handed to the operating system.
    pub written: u64,
    /// Records on the disk.
    pub synced: u64,
    /// Bytes of all segments.
    pub bytes_written: u64,
    /// Segments begun.
    pub segments: u32,
}

/// What is the same in every header.
struct Identity {
    begun_ns: u64,
    description: Vec<u8>,
}

struct OpenSegment {
    file: Box<dyn LogFile>,
    path: PathBuf,
    number: u32,
    salt: u32,
    /// Bytes written.
    length: u64,
    /// Records written or in the batch.
    records: u64,
    headers: crc32fast::Hasher,
    /// Whether a sync has failed: another one would prove nothing.
    sync_failed: bool,
}

impl Segments {
    /// Creates the folder and the first segment, safe on disk.
    ///
    /// # Errors
    /// The folder holds a log already, or the disk refuses.
    pub fn create(
        storage: Arc<dyn Storage>,
        folder: &Path,
        description: &[u8],
        limits: &Limits,
    ) -> Result<Self, RawLogError> {
        storage.create_folder(folder).map_err(RawLogError::io("create the folder", folder))?;
        let names = storage.list(folder).map_err(RawLogError::io("list the folder", folder))?;
        if names.iter().any(|name| name.starts_with("segment_")) {
            return Err(RawLogError::AlreadyUsed { folder: folder.into() });
        }
        if let Some(run) = folder.parent().filter(|run| !run.as_os_str().is_empty()) {
            storage.sync_folder(run).map_err(RawLogError::io("flush to disk", run))?;
        }
        if description.len() > MOST_HEADER_BYTES / 2 {
            let what = format!("a description of {} bytes", description.len());
            return Err(RawLogError::TooLarge { what, limit: "33554432 bytes" });
        }
        let begun_ns = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default().as_nanos();
        let begun_ns = u64::try_from(begun_ns).unwrap_or_default();
        let identity = Identity { begun_ns, description: description.into() };
        let encoder = Encoder::new(limits.codec)
            .map_err(RawLogError::io("prepare compression for", folder))?;
        let mut progress = Progress::default();
        let current = begin(&*storage, folder, &identity, Predecessor::default(), &mut progress)?;
        Ok(Self {
            storage,
            folder: folder.into(),
            identity,
            segment_bytes: limits.segment_bytes,
            encoder,
            current,
            batch: Vec::new(),
            batch_records: 0,
            progress,
        })
    }

    /// How far records have got.
    pub fn progress(&self) -> Progress {
        self.progress
    }

    /// Whether a sync would make records safer.
    pub fn has_unsynced(&self) -> bool {
        self.progress.synced < self.progress.written
    }

    /// Takes the next record. It is written with the batch: see [`Self::flush`].
    ///
    /// # Errors
    /// The record is larger than the format allows, or the disk refuses. After an error nothing but
    /// [`Self::rescue`] makes sense.
    pub fn append(&mut self, record: &Record) -> Result<(), RawLogError> {
        let mut start = self.batch.len();
        let header = self.encode(record)?;
        let length = self.current.length + self.batch.len() as u64;
        if length > self.segment_bytes && self.current.records > 0 {
            let encoded = self.batch.split_off(start);
            self.begin_next()?;
            self.batch = encoded;
            start = 0;
        }
        // Only now is it known which segment the record lies in, and so its salt.
        let header = header.encode(self.current.salt);
        self.batch[start..start + RECORD_HEADER_BYTES].copy_from_slice(&header);
        self.current.headers.update(&header);
        self.current.records += 1;
        self.batch_records += 1;
        if self.batch.len() >= BATCH_BYTES { self.flush() } else { Ok(()) }
    }

    /// Writes the batch: afterwards every record taken is *written*.
    ///
    /// # Errors
    /// The disk refuses; none of the batch's records is in the file then, unless cutting it fails,
    /// too.
    pub fn flush(&mut self) -> Result<(), RawLogError> {
        if self.batch.is_empty() {
            return Ok(());
        }
        self.current.append(&self.batch)?;
        self.progress.bytes_written += self.batch.len() as u64;
        self.progress.written += std::mem::take(&mut self.batch_records);
        self.batch.clear();
        Ok(())
    }

    /// Makes every record that is written *synced*.
    ///
    /// # Errors
    /// The disk refuses. What of the file is on the disk is unknown then and stays so: a second
    /// attempt may succeed without having written anything.
    pub fn sync(&mut self) -> Result<(), RawLogError> {
        self.current.sync()?;
        self.progress.synced = self.progress.written;
        Ok(())
    }

    /// Writes what is left and seals the last segment; afterwards every record taken is *synced*.
    ///
    /// # Errors
    /// The disk refuses.
    pub fn finish(&mut self) -> Result<(), RawLogError> {
        self.flush()?;
        self.seal()
    }

    /// After an error: syncs what was written before it, where that may still be possible.
    pub fn rescue(&mut self) {
        if !self.current.sync_failed && self.has_unsynced() && self.sync().is_err() {
            tracing::warn!("{} cannot be flushed to disk", self.current.path.display());
        }
    }

    fn begin_next(&mut self) -> Result<(), RawLogError> {
        self.flush()?;
        let known_as = self.end_segment(Ending::GoesOn)?;
        let (storage, folder) = (&*self.storage, &self.folder);
        let next = begin(storage, folder, &self.identity, known_as, &mut self.progress)?;
        give_sealed_name(storage, folder, self.current.number)?;
        self.current = next;
        Ok(())
    }

    fn seal(&mut self) -> Result<(), RawLogError> {
        self.end_segment(Ending::Closed)?;
        give_sealed_name(&*self.storage, &self.folder, self.current.number)
    }

    /// Writes the footer, safe on disk; what a next segment says of this one.
    fn end_segment(&mut self, ending: Ending) -> Result<Predecessor, RawLogError> {
        let footer = self.current.footer(ending);
        let bytes = footer.encode(FORMAT_VERSION, self.current.salt);
        self.current.append(&bytes)?;
        self.progress.bytes_written += bytes.len() as u64;
        self.sync()?;
        let digest = footer.digest(FORMAT_VERSION, self.current.salt);
        Ok(Predecessor { records: footer.records, digest })
    }

    /// Appends room for the header, then head and stored image, to the batch.
    fn encode(&mut self, record: &Record) -> Result<RecordHeader, RawLogError> {
        let sequence = self.progress.written + self.batch_records;
        let [columns, rows] = record.image_size()?;
        self.batch.extend([0; RECORD_HEADER_BYTES]);
        self.batch.extend(&record.head);
        let stored_at = self.batch.len();
        let mut header = RecordHeader {
            head_bytes: record.head.len() as u32,
            sequence,
            columns,
            rows,
            codec: 0,
            stored_bytes: 0,
            head_crc: crc32fast::hash(&record.head),
            stored_crc: 0,
            image_crc: 0,
        };
        if let Some(image) = &record.image {
            header.codec = self
                .encoder
                .encode(image, &mut self.batch)
                .map_err(RawLogError::io("compress an image for", &self.current.path))?;
            let stored = &self.batch[stored_at..];
            header.stored_bytes = stored.len() as u32;
            header.stored_crc = crc32fast::hash(stored);
            // Raw counts are stored as the bytes that their checksum is of.
            let is_raw = header.codec == STORED_RAW;
            header.image_crc = if is_raw { header.stored_crc } else { image.crc32() };
        }
        Ok(header)
    }
}

impl OpenSegment {
    /// Appends all bytes or none, if the disk allows that.
    fn append(&mut self, bytes: &[u8]) -> Result<(), RawLogError> {
        if let Err(reason) = self.file.append(bytes) {
            if let Err(error) = self.file.truncate(self.length) {
                tracing::warn!("{} may end in a torn record: {error}", self.path.display());
            }
            return Err(RawLogError::io("write to", &self.path)(reason));
        }
        self.length += bytes.len() as u64;
        Ok(())
    }

    fn sync(&mut self) -> Result<(), RawLogError> {
        let synced = self.file.sync();
        self.sync_failed |= synced.is_err();
        synced.map_err(RawLogError::io("flush to disk", &self.path))
    }

    fn footer(&self, ending: Ending) -> Footer {
        Footer {
            segment: self.number,
            records: self.records,
            length: self.length,
            headers_crc: self.headers.clone().finalize(),
            ending,
        }
    }
}

/// Creates the next segment, its header and its name safe on disk.
fn begin(
    storage: &dyn Storage,
    folder: &Path,
    identity: &Identity,
    predecessor: Predecessor,
    progress: &mut Progress,
) -> Result<OpenSegment, RawLogError> {
    let number = progress.segments;
    let header = SegmentHeader {
        version: FORMAT_VERSION,
        begun_ns: identity.begun_ns,
        segment: number,
        predecessor,
        first_sequence: progress.written,
        description: identity.description.clone(),
    };
    let (copy, salt) = header.encode();
    let bytes = [&copy[..], &copy].concat();
    let path = part_path(folder, number);
    let mut file = storage.create(&path).map_err(RawLogError::io("create", &path))?;
    file.append(&bytes).map_err(RawLogError::io("write to", &path))?;
    file.sync().map_err(RawLogError::io("flush to disk", &path))?;
    storage.sync_folder(folder).map_err(RawLogError::io("flush to disk", folder))?;
    progress.segments += 1;
    progress.bytes_written += bytes.len() as u64;
    Ok(OpenSegment {
        file,
        path,
        number,
        salt,
        length: bytes.len() as u64,
        records: 0,
        headers: crc32fast::Hasher::new(),
        sync_failed: false,
    })
}

/// Renames a finished, synced segment, so that the new name survives a power cut.
pub(super) fn give_sealed_name(
    storage: &dyn Storage,
    folder: &Path,
    segment: u32,
) -> Result<(), RawLogError> {
    let part = part_path(folder, segment);
    storage
        .rename(&part, &sealed_path(folder, segment))
        .map_err(RawLogError::io("give its final name to", &part))?;
    storage.sync_folder(folder).map_err(RawLogError::io("flush to disk", folder))
}
