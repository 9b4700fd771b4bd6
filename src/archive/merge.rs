//! Merges the sealed segments of a finished run into few files, sorted by shot.
//!
//! A run seals a segment every minute, so segments of a slow run hold one or two shots. Segments
//! are merged if they differ in their shots only: model, grid and configuration must be equal. A
//! merged file is named by its first shot and bounded in size. The shots of consecutive files
//! follow each other, as required by readers that concatenate files by coordinates.
//!
//! The particles of a merged file's shots become the file beside it ([`particles`]).
//!
//! Merged files are sealed before their segments are removed. If the process is killed in between,
//! some shots are stored twice with equal numbers; the next merge removes the duplicates.

mod particles;

use std::{
    collections::{BTreeMap, BTreeSet},
    fs::{self, File},
    path::{Path, PathBuf},
    time::SystemTime,
};

use netcdf::{
    AttributeValue, FileMut, Variable, VariableMut,
    types::{FloatType, IntType, NcVariableType},
};

use super::{
    ArchiveError,
    durable::{MemoryFile, part_path, seal},
    netcdf_file::history_line,
    netcdf_open::{create, open},
    particle_file::particles_beside,
    stored::{FIRST_STORED, first_stored, records_of, segments},
    stored_particles::remove_orphans,
};

/// The dimension along which segments are concatenated.
const SHOT: &str = "shot";
/// Global attributes that may differ between segments of one run.
const SEGMENT_ATTRIBUTES: [&str; 2] = ["history", FIRST_STORED];

/// Largest size of a merged file.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounds {
    /// Number of shots: the library needs some 5 kB of memory per shot.
    pub shots: usize,
    /// Bytes of the segments: the merged file is built in memory.
    pub bytes: u64,
}

/// Size of segments, in the terms of [`Bounds`].
#[derive(Debug, Clone, Copy, Default)]
struct Size {
    shots: usize,
    bytes: u64,
}

impl Size {
    fn plus(self, other: Self) -> Self {
        Self { shots: self.shots + other.shots, bytes: self.bytes + other.bytes }
    }

    fn fits(self, bounds: Bounds) -> bool {
        self.shots <= bounds.shots && self.bytes <= bounds.bytes
    }
}

const BOUNDS: Bounds = Bounds { shots: 10_000, bytes: 256 << 20 };

/// Memory to request, as a multiple of the segments' size: the chunks of a merged file differ from
/// those of its segments.
const MEMORY_FACTOR: u64 = 2;

/// Merges the sealed segments in a run's folder. `go_on` is called before each merged file is
/// written; when it returns `false`, the remaining segments stay as they are.
///
/// # Errors
/// A segment cannot be read or a merged file cannot be written; then no segment is lost.
pub fn merge_segments(folder: &Path, go_on: impl FnMut() -> bool) -> Result<(), ArchiveError> {
    merge_within(folder, BOUNDS, go_on)
}

pub(super) fn merge_within(
    folder: &Path,
    bounds: Bounds,
    mut go_on: impl FnMut() -> bool,
) -> Result<(), ArchiveError> {
    remove_orphans(folder)?;
    let mut by_kind: BTreeMap<String, Vec<Segment>> = BTreeMap::new();
    for path in segments(folder, ".nc")? {
        let segment = Segment::read(path)?;
        by_kind.entry(segment.kind.clone()).or_default().push(segment);
    }
    for segments in by_kind.into_values() {
        for group in grouped(segments, bounds) {
            if group.iter().all(|segment| group.len() == 1 && segment.is_sorted()) {
                continue;
            }
            if !go_on() {
                return Ok(());
            }
            merge(folder, &group, bounds)?;
        }
    }
    Ok(())
}

/// The properties of a sealed segment that decide where it is merged.
#[derive(Debug)]
struct Segment {
    path: PathBuf,
    /// Shot of each record; negative for an incomplete record.
    shots: Vec<i64>,
    /// Equal for segments that can be merged into one file.
    kind: String,
    /// Those of its particles, too.
    bytes: u64,
    sealed: SystemTime,
    first_stored: Option<u64>,
}

impl Segment {
    fn read(path: PathBuf) -> Result<Self, ArchiveError> {
        let shots = records_of(&path)?;
        let kind = kind_of(&path).map_err(ArchiveError::unreadable_results(&path))?;
        let first_stored = first_stored(&path)?;
        let metadata = fs::metadata(&path).map_err(ArchiveError::io("look at", &path))?;
        let sealed = metadata.modified().map_err(ArchiveError::io("look at", &path))?;
        let particles = fs::metadata(particles_beside(&path)).map_or(0, |file| file.len());
        let bytes = metadata.len() + particles;
        Ok(Self { shots, kind, bytes, sealed, first_stored, path })
    }

    fn is_sorted(&self) -> bool {
        self.shots.is_sorted_by(|a, b| a < b) && self.shots.first().is_none_or(|shot| *shot >= 0)
    }

    fn lowest(&self) -> i64 {
        self.shots.iter().copied().filter(|shot| *shot >= 0).min().unwrap_or(i64::MAX)
    }

    fn highest(&self) -> i64 {
        self.shots.iter().copied().max().unwrap_or(i64::MIN)
    }

    fn size(&self) -> Size {
        Size { shots: self.shots.len(), bytes: self.bytes }
    }
}

/// Describes everything in a file that does not depend on the shots: attributes, variables, and the
/// values of variables without the shot dimension.
fn kind_of(path: &Path) -> netcdf::Result<String> {
    let file = open(path)?;
    let mut kind = String::new();
    for attribute in file.attributes() {
        if !SEGMENT_ATTRIBUTES.contains(&attribute.name()) {
            kind += &format!("{} {:?}\n", attribute.name(), attribute.value()?);
        }
    }
    for variable in file.variables() {
        let dimensions: Vec<String> = variable.dimensions().iter().map(|d| d.name()).collect();
        kind += &format!("{} {:?} {dimensions:?}", variable.name(), variable.vartype());
        if !has_shots(&variable) {
            kind += &format!(" {:?}", variable.get_raw_values(..)?);
        }
        for attribute in variable.attributes() {
            kind += &format!(" {} {:?}", attribute.name(), attribute.value()?);
        }
        kind.push('\n');
    }
    Ok(kind)
}

/// Groups whole segments in the order of their shots, as many per group as the bounds allow.
/// Segments with interleaved shots stay together regardless of the bounds.
fn grouped(mut segments: Vec<Segment>, bounds: Bounds) -> Vec<Vec<Segment>> {
    segments.sort_by_key(Segment::lowest);
    let (mut chains, mut highest) = (Vec::<Vec<Segment>>::new(), i64::MIN);
    for segment in segments {
        let follows = segment.lowest() > highest;
        highest = highest.max(segment.highest());
        match chains.last_mut().filter(|_| !follows) {
            Some(chain) => chain.push(segment),
            None => chains.push(vec![segment]),
        }
    }
    let (mut groups, mut size) = (Vec::<Vec<Segment>>::new(), Size::default());
    for chain in chains {
        let more = chain.iter().map(Segment::size).fold(Size::default(), Size::plus);
        match groups.last_mut().filter(|_| size.plus(more).fits(bounds)) {
            Some(group) => {
                size = size.plus(more);
                group.extend(chain);
            }
            None => {
                size = more;
                groups.push(chain);
            }
        }
    }
    groups
}

/// A record of a segment.
#[derive(Debug, Clone, Copy)]
struct Record {
    shot: i64,
    /// Index of the segment in the group, and of the record in the segment.
    segment: usize,
    record: usize,
    /// The record's share of the segment's bytes.
    bytes: u64,
}

/// Each shot of a group once, in order, split into pieces within the bounds. For a shot stored
/// twice, the first record is used.
fn pieces(group: &[Segment], bounds: Bounds) -> Vec<Vec<Record>> {
    let mut records: BTreeMap<i64, Record> = BTreeMap::new();
    for (number, segment) in group.iter().enumerate() {
        let bytes = segment.bytes / segment.shots.len().max(1) as u64;
        for (record, shot) in segment.shots.iter().copied().enumerate().filter(|(_, s)| *s >= 0) {
            records.entry(shot).or_insert(Record { shot, segment: number, record, bytes });
        }
    }
    let all = group.iter().map(Segment::size).fold(Size::default(), Size::plus);
    if all.fits(bounds) {
        return vec![records.into_values().collect()];
    }
    let (mut pieces, mut size) = (Vec::<Vec<Record>>::new(), Size::default());
    for record in records.into_values() {
        let more = Size { shots: 1, bytes: record.bytes };
        match pieces.last_mut().filter(|_| size.plus(more).fits(bounds)) {
            Some(piece) => {
                size = size.plus(more);
                piece.push(record);
            }
            None => {
                size = more;
                pieces.push(vec![record]);
            }
        }
    }
    pieces
}

/// Replaces a group by as few files as the bounds allow.
fn merge(folder: &Path, group: &[Segment], bounds: Bounds) -> Result<(), ArchiveError> {
    let mut written: Vec<PathBuf> = Vec::new();
    for piece in pieces(group, bounds).iter().filter(|piece| !piece.is_empty()) {
        let path = path_for(folder, group, piece, &written);
        write_piece(&path, group, piece)?;
        written.push(path);
    }
    if written.is_empty() {
        return Ok(());
    }
    for path in group.iter().map(|segment| &segment.path).filter(|path| !written.contains(path)) {
        fs::remove_file(path).map_err(ArchiveError::io("remove", path))?;
    }
    remove_orphans(folder)
}

/// Path for a merged file, named by its first shot. A suffix is added if a file of that name has
/// shots that are not in `piece`, or belongs to another group.
fn path_for(folder: &Path, group: &[Segment], piece: &[Record], written: &[PathBuf]) -> PathBuf {
    let shots: BTreeSet<i64> = piece.iter().map(|record| record.shot).collect();
    let is_free = |path: &PathBuf| match group.iter().find(|segment| segment.path == *path) {
        _ if written.contains(path) => false,
        Some(own) => own.shots.iter().all(|shot| *shot < 0 || shots.contains(shot)),
        None => !path.exists(),
    };
    let first = piece[0].shot;
    let suffixes = (2..).map(|number| format!("_{number}"));
    let mut names = std::iter::once(String::new())
        .chain(suffixes)
        .map(|suffix| folder.join(format!("velocity_{first:06}{suffix}.nc")));
    names.find(is_free).unwrap_or_default()
}

/// Writes one merged file; its modification time is that of the oldest segment of the group.
fn write_piece(path: &Path, group: &[Segment], piece: &[Record]) -> Result<(), ArchiveError> {
    let oldest = group.iter().min_by_key(|segment| segment.sealed);
    let records = piece.iter().map(|record| record.bytes).sum::<u64>();
    // A file also contains data besides its records.
    let bytes = records + group.iter().map(|segment| segment.bytes).min().unwrap_or_default();
    let (memory, merged) = MemoryFile::create(MEMORY_FACTOR * bytes, create)
        .map_err(ArchiveError::io("write", path))?;
    let first_stored = oldest.and_then(|segment| segment.first_stored);
    merged
        .and_then(|merged| write(merged, group, piece, first_stored))
        .map_err(ArchiveError::netcdf(path))?;
    // First, as where a segment is stored.
    particles::merge(&particles_beside(path), group, piece)?;
    memory.write_part(path)?;
    if let Some(oldest) = oldest {
        let part = part_path(path);
        File::options()
            .append(true)
            .open(&part)
            .and_then(|file| file.set_modified(oldest.sealed))
            .map_err(ArchiveError::io("set the time of", part))?;
    }
    seal(path)
}

/// Writes records of a group in their order.
fn write(
    mut merged: FileMut,
    group: &[Segment],
    piece: &[Record],
    first_stored: Option<u64>,
) -> netcdf::Result<()> {
    describe(&mut merged, &group[0].path, group.len(), first_stored)?;
    define(&mut merged, &group[0].path)?;
    for (number, segment) in group.iter().enumerate() {
        let records = piece.iter().enumerate().filter(|(_, record)| record.segment == number);
        let mut places: Vec<(usize, usize)> =
            records.map(|(place, record)| (record.record, place)).collect();
        places.sort_unstable();
        copy_records(&mut merged, &segment.path, &places)?;
    }
    merged.close()
}

/// Copies the global attributes of `like`.
fn describe(
    merged: &mut FileMut,
    like: &Path,
    segments: usize,
    first_stored: Option<u64>,
) -> netcdf::Result<()> {
    for attribute in open(like)?.attributes() {
        match (attribute.name(), attribute.value()?) {
            ("history", AttributeValue::Str(history)) => {
                let line = history_line(&format!("{segments} segments merged"));
                merged.add_attribute("history", format!("{line}\n{history}"))?;
            }
            (FIRST_STORED, _) => {}
            (name, value) => {
                merged.add_attribute(name, value)?;
            }
        }
    }
    if let Some(shot) = first_stored {
        merged.add_attribute(FIRST_STORED, shot as i64)?;
    }
    Ok(())
}

/// Defines dimensions and variables as in `like`, and copies values that do not belong to a shot.
fn define(merged: &mut FileMut, like: &Path) -> netcdf::Result<()> {
    let like = open(like)?;
    for dimension in like.dimensions() {
        if dimension.is_unlimited() {
            merged.add_unlimited_dimension(&dimension.name())?;
        } else {
            merged.add_dimension(&dimension.name(), dimension.len())?;
        }
    }
    for variable in like.variables() {
        add_like(merged, &variable)?;
    }
    for variable in like.variables().filter(|variable| !has_shots(variable)) {
        copy(merged, &variable, None)?;
    }
    Ok(())
}

/// Adds a variable like that of another file, without its values.
fn add_like<'m>(
    merged: &'m mut FileMut,
    variable: &Variable<'_>,
) -> netcdf::Result<VariableMut<'m>> {
    let dimensions: Vec<String> = variable.dimensions().iter().map(|d| d.name()).collect();
    let dimensions: Vec<&str> = dimensions.iter().map(String::as_str).collect();
    let kind = variable.vartype();
    let mut copy = merged.add_variable_with_type(&variable.name(), &dimensions, &kind)?;
    for attribute in variable.attributes() {
        copy.put_attribute(attribute.name(), attribute.value()?)?;
    }
    Ok(copy)
}

/// Copies records of a segment. `places` lists pairs of the record's index in the segment and in
/// the merged file.
fn copy_records(
    merged: &mut FileMut,
    from: &Path,
    places: &[(usize, usize)],
) -> netcdf::Result<()> {
    let segment = open(from)?;
    for variable in segment.variables().filter(has_shots) {
        // Records that are consecutive in both files are copied together.
        for piece in places.chunk_by(|a, b| b.0 == a.0 + 1 && b.1 == a.1 + 1) {
            copy(merged, &variable, Some((piece[0], piece.len())))?;
        }
    }
    Ok(())
}

/// Copies a variable: the whole variable, or `piece` = ((first source record, first target record),
/// number of records).
fn copy(
    merged: &mut FileMut,
    variable: &Variable<'_>,
    piece: Option<((usize, usize), usize)>,
) -> netcdf::Result<()> {
    match variable.vartype() {
        NcVariableType::Float(FloatType::F32) => copy_as::<f32>(merged, variable, piece),
        NcVariableType::Float(FloatType::F64) => copy_as::<f64>(merged, variable, piece),
        NcVariableType::Int(IntType::I8) => copy_as::<i8>(merged, variable, piece),
        NcVariableType::Int(IntType::I64) => copy_as::<i64>(merged, variable, piece),
        _ => Err(netcdf::Error::Str(format!("{}: unexpected variable type", variable.name()))),
    }
}

fn copy_as<T: netcdf::NcTypeDescriptor + Copy>(
    merged: &mut FileMut,
    variable: &Variable<'_>,
    piece: Option<((usize, usize), usize)>,
) -> netcdf::Result<()> {
    let name = variable.name();
    let missing = || netcdf::Error::NotFound(name.clone());
    let mut copy = merged.variable_mut(&name).ok_or_else(missing)?;
    let Some(((from, to), records)) = piece else {
        return copy.put_values(&variable.get_values::<T, _>(..)?, ..);
    };
    let extents = |first: usize| {
        let mut extents = vec![netcdf::Extent::from(first..first + records)];
        extents.resize(variable.dimensions().len(), (..).into());
        extents
    };
    copy.put_values(&variable.get_values::<T, _>(extents(from))?, extents(to))
}

fn has_shots(variable: &Variable<'_>) -> bool {
    variable.dimensions().first().is_some_and(|dimension| dimension.name() == SHOT)
}

#[cfg(test)]
mod tests;
