//! A model of a disk for tests: it logs every operation, fails on demand, and computes what a
//! process death or a power cut at any operation would leave.

use std::{
    collections::BTreeMap,
    io::{self, ErrorKind},
    path::{Path, PathBuf},
    sync::Arc,
    time::Duration,
};

use parking_lot::Mutex;
use rand::{Rng, RngExt};

use super::{LogFile, Storage};

/// A disk in memory. Clones are the same disk.
#[derive(Debug, Clone, Default)]
pub(in super::super) struct ModelDisk(Arc<Mutex<State>>);

#[derive(Debug, Default)]
struct State {
    content: Content,
    /// The durable content before the first operation.
    durable: Content,
    operations: Vec<Operation>,
    faults: Faults,
    /// Modifying operations attempted since the faults were set.
    tried: u64,
}

/// Files by number, and names.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(in super::super) struct Content {
    files: Vec<Vec<u8>>,
    names: BTreeMap<PathBuf, usize>,
}

/// Injected faults.
#[derive(Debug, Clone, Default)]
pub(in super::super) struct Faults {
    /// Total size of all files above which the disk is full.
    pub quota_bytes: Option<u64>,
    /// Index of the operation that fails, and its error.
    pub fails_at: Option<(u64, ErrorKind)>,
    /// Whether all later operations fail, too.
    pub stays_failed: bool,
    /// Whether the next operation panics.
    pub panics: bool,
    /// Duration of a write or a sync.
    pub delay: Duration,
}

/// A completed operation.
#[derive(Debug, Clone)]
pub(in super::super) enum Operation {
    Create { path: PathBuf, file: usize },
    Write { file: usize, offset: usize, bytes: Vec<u8> },
    Truncate { file: usize, length: usize },
    Sync { file: usize },
    Rename { from: PathBuf, to: PathBuf },
    SyncFolder,
}

impl ModelDisk {
    /// A disk with this content, all durable.
    pub fn holding(content: Content) -> Self {
        let state = State { durable: content.clone(), content, ..State::default() };
        Self(Arc::new(Mutex::new(state)))
    }

    /// Sets the faults and restarts the operation count.
    pub fn set_faults(&self, faults: Faults) {
        let mut state = self.0.lock();
        state.faults = faults;
        state.tried = 0;
    }

    /// The content as seen while power is on.
    pub fn content(&self) -> Content {
        self.0.lock().content.clone()
    }

    pub fn operations(&self) -> usize {
        self.0.lock().operations.len()
    }

    /// The content after the process dies: the first `operations`, and `share`/256 of the bytes of the
    /// next one if it is a write.
    pub fn after_death(&self, operations: usize, share: u8) -> Content {
        let state = self.0.lock();
        let mut content = state.durable.clone();
        for operation in &state.operations[..operations] {
            content.apply(operation);
        }
        if let Some(Operation::Write { file, offset, bytes }) = state.operations.get(operations) {
            let part = bytes.len() * usize::from(share) / 256;
            content.write(*file, *offset, &bytes[..part]);
        }
        content
    }

    /// The content after a power cut: what was synced in the first `operations`, and a random part
    /// of the rest.
    pub fn after_power_cut(&self, operations: usize, random: &mut impl Rng) -> Content {
        let state = self.0.lock();
        let done = &state.operations[..operations];
        let mut content = state.durable.clone();
        for (number, operation) in done.iter().enumerate() {
            let is_safe = done[number..].iter().any(|later| later.makes_safe(operation));
            if is_safe || random.random_bool(0.5) {
                content.apply(operation);
            } else if let Operation::Create { file, .. } = operation {
                // The name is lost; the file keeps its number.
                content.reach(*file);
            } else if let Operation::Write { file, offset, bytes } = operation {
                content.write(*file, *offset, &torn(bytes, *offset, &state.durable, random));
            }
        }
        content
    }
}

/// What a power cut leaves of a write: nothing, a part, zeros, or blocks of an older file.
fn torn(bytes: &[u8], offset: usize, older: &Content, random: &mut impl Rng) -> Vec<u8> {
    match random.random_range(0..4) {
        0 => Vec::new(),
        1 => bytes[..random.random_range(0..=bytes.len())].to_vec(),
        2 => vec![0; bytes.len()],
        _ => {
            let files = older.files.len().max(1);
            let older =
                older.files.get(random.random_range(0..files)).map_or(&[][..], Vec::as_slice);
            older.iter().skip(offset).take(bytes.len()).copied().collect()
        }
    }
}

impl Operation {
    fn makes_safe(&self, earlier: &Self) -> bool {
        match (earlier, self) {
            (
                Self::Write { file, .. } | Self::Truncate { file, .. },
                Self::Sync { file: synced },
            ) => file == synced,
            (Self::Create { .. } | Self::Rename { .. }, Self::SyncFolder) => true,
            (Self::Sync { .. } | Self::SyncFolder, _) => true,
            _ => false,
        }
    }
}

impl Content {
    /// Content of a file by name.
    pub fn file(&self, path: &Path) -> Option<&Vec<u8>> {
        Some(&self.files[*self.names.get(path)?])
    }

    /// Mutable content of a file, to damage it.
    pub fn file_mut(&mut self, path: &Path) -> Option<&mut Vec<u8>> {
        Some(&mut self.files[*self.names.get(path)?])
    }

    /// All names with their content.
    pub fn named(&self) -> BTreeMap<&Path, &[u8]> {
        self.names.iter().map(|(name, file)| (name.as_path(), &self.files[*file][..])).collect()
    }

    /// Adds a file.
    pub fn add(&mut self, path: &Path, bytes: Vec<u8>) {
        self.names.insert(path.into(), self.files.len());
        self.files.push(bytes);
    }

    /// Removes a file.
    pub fn remove(&mut self, path: &Path) {
        self.names.remove(path);
    }

    fn apply(&mut self, operation: &Operation) {
        match operation {
            Operation::Create { path, file } => {
                self.reach(*file);
                self.names.insert(path.clone(), *file);
            }
            Operation::Write { file, offset, bytes } => self.write(*file, *offset, bytes),
            Operation::Truncate { file, length } => self.files[*file].truncate(*length),
            Operation::Rename { from, to } => {
                if let Some(file) = self.names.remove(from) {
                    self.names.insert(to.clone(), file);
                }
            }
            Operation::Sync { .. } | Operation::SyncFolder => {}
        }
    }

    fn reach(&mut self, file: usize) {
        self.files.resize_with(self.files.len().max(file + 1), Vec::new);
    }

    fn write(&mut self, file: usize, offset: usize, bytes: &[u8]) {
        let file = &mut self.files[file];
        file.resize(file.len().max(offset + bytes.len()), 0);
        file[offset..offset + bytes.len()].copy_from_slice(bytes);
    }

    fn bytes(&self) -> u64 {
        self.files.iter().map(|file| file.len() as u64).sum()
    }
}

impl State {
    /// Whether the next operation fails.
    fn try_next(&mut self) -> io::Result<()> {
        let number = self.tried;
        self.tried += 1;
        assert!(!self.faults.panics, "the model disk panics as configured");
        match self.faults.fails_at {
            Some((at, kind)) if number == at || (number > at && self.faults.stays_failed) => {
                Err(kind.into())
            }
            _ => Ok(()),
        }
    }

    fn perform(&mut self, operation: Operation) {
        self.content.apply(&operation);
        self.operations.push(operation);
    }

    fn free(&self) -> u64 {
        self.faults.quota_bytes.map_or(u64::MAX, |quota| quota.saturating_sub(self.content.bytes()))
    }
}

impl Storage for ModelDisk {
    fn create_folder(&self, _: &Path) -> io::Result<()> {
        Ok(())
    }

    fn list(&self, folder: &Path) -> io::Result<Vec<String>> {
        let state = self.0.lock();
        let inside = state.content.names.keys().filter(|path| path.parent() == Some(folder));
        let name = |path: &PathBuf| path.file_name().unwrap().to_str().unwrap().to_owned();
        Ok(inside.map(name).collect())
    }

    fn create(&self, path: &Path) -> io::Result<Box<dyn LogFile>> {
        let mut state = self.0.lock();
        state.try_next()?;
        if state.content.names.contains_key(path) {
            return Err(ErrorKind::AlreadyExists.into());
        }
        let file = state.content.files.len();
        state.perform(Operation::Create { path: path.into(), file });
        Ok(Box::new(ModelFile { disk: self.clone(), file }))
    }

    fn open(&self, path: &Path) -> io::Result<Box<dyn LogFile>> {
        let file = self.0.lock().content.names.get(path).copied().ok_or(ErrorKind::NotFound)?;
        Ok(Box::new(ModelFile { disk: self.clone(), file }))
    }

    fn open_writable(&self, path: &Path) -> io::Result<Box<dyn LogFile>> {
        self.open(path)
    }

    fn rename(&self, from: &Path, to: &Path) -> io::Result<()> {
        let mut state = self.0.lock();
        state.try_next()?;
        assert!(state.content.names.contains_key(from), "{} is not there", from.display());
        assert!(!state.content.names.contains_key(to), "{} would be lost", to.display());
        state.perform(Operation::Rename { from: from.into(), to: to.into() });
        Ok(())
    }

    fn sync_folder(&self, _: &Path) -> io::Result<()> {
        let mut state = self.0.lock();
        state.try_next()?;
        state.perform(Operation::SyncFolder);
        Ok(())
    }

    fn free_bytes(&self, _: &Path) -> io::Result<u64> {
        Ok(self.0.lock().free())
    }
}

struct ModelFile {
    disk: ModelDisk,
    file: usize,
}

impl ModelFile {
    fn wait(&self) {
        let delay = self.disk.0.lock().faults.delay;
        if !delay.is_zero() {
            std::thread::sleep(delay);
        }
    }
}

impl LogFile for ModelFile {
    fn append(&mut self, bytes: &[u8]) -> io::Result<()> {
        self.wait();
        let mut state = self.disk.0.lock();
        let tried = state.try_next();
        // A failed write may have written some bytes.
        let fits = match &tried {
            Ok(()) => state.free().min(bytes.len() as u64) as usize,
            Err(_) => bytes.len() / 2,
        };
        let offset = state.content.files[self.file].len();
        let written = bytes[..fits].to_vec();
        state.perform(Operation::Write { file: self.file, offset, bytes: written });
        tried?;
        if fits < bytes.len() { Err(ErrorKind::StorageFull.into()) } else { Ok(()) }
    }

    fn sync(&mut self) -> io::Result<()> {
        self.wait();
        let mut state = self.disk.0.lock();
        state.try_next()?;
        state.perform(Operation::Sync { file: self.file });
        Ok(())
    }

    fn truncate(&mut self, length: u64) -> io::Result<()> {
        let mut state = self.disk.0.lock();
        state.try_next()?;
        state.perform(Operation::Truncate { file: self.file, length: length as usize });
        Ok(())
    }

    fn read_at(&self, offset: u64, bytes: &mut [u8]) -> io::Result<usize> {
        let state = self.disk.0.lock();
        let file = &state.content.files[self.file];
        let from = file.get(offset as usize..).unwrap_or_default();
        let read = from.len().min(bytes.len());
        bytes[..read].copy_from_slice(&from[..read]);
        Ok(read)
    }

    fn length(&self) -> io::Result<u64> {
        Ok(self.disk.0.lock().content.files[self.file].len() as u64)
    }
}
