//! Writes records into segments, on one thread, in a crash-safe order of writes, syncs and renames.
//!
//! The guarantees, and why they hold:
//!
//! - *Written* records are in the kernel: the write call of their batch has returned.
//! - *Synced* records survive a power cut: their segment was synced after they were written, and its
//!   name, under which it was created, before the first of them.
//! - A segment gets its final name only when the next one exists with a synced header. So if a
//!   sealed segment says "the next segment follows" and there is none, that segment was lost. Records
//!   go into the next segment only after that rename, so at most one unsealed segment lacks its footer.
//! - A failed write is truncated, so that the file ends with the last written record.

use std::{
    path::{Path, PathBuf},
    sync::Arc,
    time::{SystemTime, UNIX_EPOCH},
};

use super::{
    RawLogError, Record,
    codec::{Encoder, STORED_RAW},
    format::{
        Ending, FORMAT_VERSION, Footer, MAX_HEADER_BYTES, Predecessor, RECORD_HEADER_BYTES,
        RecordHeader, SegmentHeader,
    },
    names::{part_path, sealed_path},
    settings::Limits,
    storage::{LogFile, Storage},
};

/// Records are batched up to this size, because a write call per small record is slow.
const BATCH_BYTES: usize = 1 << 20;

/// The segments of a log being written.
pub(super) struct Segments {
    storage: Arc<dyn Storage>,
    folder: PathBuf,
    identity: Identity,
    segment_bytes: u64,
    encoder: Encoder,
    current: OpenSegment,
    /// Encoded records not yet written.
    batch: Vec<u8>,
    batch_records: u64,
    progress: Progress,
}

/// Progress of the writer.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Progress {
    /// Records written to the operating system.
    pub written: u64,
    /// Records synced to disk.
    pub synced: u64,
    /// Bytes of all segments.
    pub bytes_written: u64,
    /// Segments created.
    pub segments: u32,
}

/// The fields that all segment headers share.
struct Identity {
    created_ns: u64,
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
    /// Whether a sync has failed: a later success would prove nothing.
    sync_failed: bool,
}

impl Segments {
    /// Creates the folder and the first segment, and syncs both.
    ///
    /// # Errors
    /// The folder already contains a log, or a file operation fails.
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
            storage.sync_folder(run).map_err(RawLogError::io("sync", run))?;
        }
        if description.len() > MAX_HEADER_BYTES / 2 {
            let what = format!("a description of {} bytes", description.len());
            return Err(RawLogError::TooLarge { what, limit: "33554432 bytes" });
        }
        let created_ns =
            SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default().as_nanos();
        let created_ns = u64::try_from(created_ns).unwrap_or_default();
        let identity = Identity { created_ns, description: description.into() };
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

    /// The progress so far.
    pub fn progress(&self) -> Progress {
        self.progress
    }

    /// Whether any written record is not synced.
    pub fn has_unsynced(&self) -> bool {
        self.progress.synced < self.progress.written
    }

    /// Adds a record to the batch; [`Self::flush`] writes it.
    ///
    /// # Errors
    /// The record exceeds the format's limits, or a file operation fails. After an error only
    /// [`Self::rescue`] may be called.
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
        // The salt depends on the segment, which is known only now.
        let header = header.encode(self.current.salt);
        self.batch[start..start + RECORD_HEADER_BYTES].copy_from_slice(&header);
        self.current.headers.update(&header);
        self.current.records += 1;
        self.batch_records += 1;
        if self.batch.len() >= BATCH_BYTES { self.flush() } else { Ok(()) }
    }

    /// Writes the batch: all records appended so far are then *written*.
    ///
    /// # Errors
    /// The write fails. The file then holds none of the batch's records, unless truncating it fails,
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

    /// Makes all written records *synced*.
    ///
    /// # Errors
    /// The sync fails. What is on the disk is then unknown for good: a second sync may succeed without
    /// having written anything.
    pub fn sync(&mut self) -> Result<(), RawLogError> {
        self.current.sync()?;
        self.progress.synced = self.progress.written;
        Ok(())
    }

    /// Writes the batch and seals the last segment: all records are then *synced*.
    ///
    /// # Errors
    /// A file operation fails.
    pub fn finish(&mut self) -> Result<(), RawLogError> {
        self.flush()?;
        self.seal()
    }

    /// After an error: syncs the records written before it, if that is still possible.
    pub fn rescue(&mut self) {
        if !self.current.sync_failed && self.has_unsynced() && self.sync().is_err() {
            tracing::warn!("cannot sync {}", self.current.path.display());
        }
    }

    fn begin_next(&mut self) -> Result<(), RawLogError> {
        self.flush()?;
        let known_as = self.end_segment(Ending::Continues)?;
        let (storage, folder) = (&*self.storage, &self.folder);
        let next = begin(storage, folder, &self.identity, known_as, &mut self.progress)?;
        rename_sealed(storage, folder, self.current.number)?;
        self.current = next;
        Ok(())
    }

    fn seal(&mut self) -> Result<(), RawLogError> {
        self.end_segment(Ending::Closed)?;
        rename_sealed(&*self.storage, &self.folder, self.current.number)
    }

    /// Writes and syncs the footer; returns what the next segment's header states about this one.
    fn end_segment(&mut self, ending: Ending) -> Result<Predecessor, RawLogError> {
        let footer = self.current.footer(ending);
        let bytes = footer.encode(FORMAT_VERSION, self.current.salt);
        self.current.append(&bytes)?;
        self.progress.bytes_written += bytes.len() as u64;
        self.sync()?;
        let digest = footer.digest(FORMAT_VERSION, self.current.salt);
        Ok(Predecessor { records: footer.records, digest })
    }

    /// Appends space for the header, then head and stored image, to the batch.
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
            // Raw counts are stored as the same bytes that the image checksum covers.
            let is_raw = header.codec == STORED_RAW;
            header.image_crc = if is_raw { header.stored_crc } else { image.crc32() };
        }
        Ok(header)
    }
}

impl OpenSegment {
    /// Appends all bytes or none, if truncating works.
    fn append(&mut self, bytes: &[u8]) -> Result<(), RawLogError> {
        if let Err(reason) = self.file.append(bytes) {
            if let Err(error) = self.file.truncate(self.length) {
                tracing::warn!("{} may end with a torn record: {error}", self.path.display());
            }
            return Err(RawLogError::io("write to", &self.path)(reason));
        }
        self.length += bytes.len() as u64;
        Ok(())
    }

    fn sync(&mut self) -> Result<(), RawLogError> {
        let synced = self.file.sync();
        self.sync_failed |= synced.is_err();
        synced.map_err(RawLogError::io("sync", &self.path))
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

/// Creates a segment; syncs its header and its name.
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
        created_ns: identity.created_ns,
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
    file.sync().map_err(RawLogError::io("sync", &path))?;
    storage.sync_folder(folder).map_err(RawLogError::io("sync", folder))?;
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

/// Renames a finished, synced segment and syncs the new name.
pub(super) fn rename_sealed(
    storage: &dyn Storage,
    folder: &Path,
    segment: u32,
) -> Result<(), RawLogError> {
    let part = part_path(folder, segment);
    storage
        .rename(&part, &sealed_path(folder, segment))
        .map_err(RawLogError::io("give its final name to", &part))?;
    storage.sync_folder(folder).map_err(RawLogError::io("sync", folder))
}
