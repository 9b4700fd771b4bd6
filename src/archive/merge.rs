//! Sealed segments of a run made into few files, sorted by shot.
//!
//! A run seals a segment a minute, and a slow one has a shot or two in each. Once it is over,
//! segments are merged, as long as they agree in all but their shots: model, vectors,
//! configuration. A merged file has the name of its first shot and a bounded size, and its shots follow
//! those of the file before it: readers that put files together by their coordinates need that.
//!
//! Merged files are sealed first, and what they were made of is removed then. Who is killed in between
//! leaves shots that are there twice, with the same numbers: the next merge keeps one of each.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs::{self, File},
    path::{Path, PathBuf},
    time::SystemTime,
};

use netcdf::{
    AttributeValue, FileMut, Variable,
    types::{FloatType, IntType, NcVariableType},
};

use super::{
    ArchiveError,
    durable::{MemoryFile, part_path, seal},
    netcdf_file::history_line,
    netcdf_open::{create, open},
    stored::{FIRST_STORED, first_stored, records_of, segments},
};

/// The dimension along which segments are put together.
const SHOT: &str = "shot";
/// Global attributes in which segments of one run may differ.
const OWN_ATTRIBUTES: [&str; 2] = ["history", FIRST_STORED];

/// How large a merged file may become.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bounds {
    /// Shots: the library's memory grows with them, by some 5 kB each.
    pub shots: usize,
    /// Bytes of the segments in it: it is made in memory.
    pub bytes: u64,
}

/// How large segments are, in the measures of [`Bounds`].
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

/// Times the segments' bytes that are asked for: chunks of a merged file are not those of its segments.
const MEMORY_FACTOR: u64 = 2;

/// Merges the sealed segments in a run's folder. `go_on` is asked before each file that is
/// written; what is not merged stays as it is.
///
/// # Errors
/// A segment cannot be read, or a merged file not written; the segments are all there then.
pub fn merge_segments(folder: &Path, go_on: impl FnMut() -> bool) -> Result<(), ArchiveError> {
    merge_within(folder, BOUNDS, go_on)
}

pub(super) fn merge_within(
    folder: &Path,
    bounds: Bounds,
    mut go_on: impl FnMut() -> bool,
) -> Result<(), ArchiveError> {
    let mut alike: BTreeMap<String, Vec<Segment>> = BTreeMap::new();
    for path in segments(folder, ".nc")? {
        let segment = Segment::read(path)?;
        alike.entry(segment.kind.clone()).or_default().push(segment);
    }
    for segments in alike.into_values() {
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

/// A sealed segment as far as its place in a merged file depends on it.
#[derive(Debug)]
struct Segment {
    path: PathBuf,
    /// Per record; below zero where it was not written whole.
    shots: Vec<i64>,
    /// Equal for segments that can be one file.
    kind: String,
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
        Ok(Self { shots, kind, bytes: metadata.len(), sealed, first_stored, path })
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

/// All that a file says besides its shots: attributes, variables, and those without shots.
fn kind_of(path: &Path) -> netcdf::Result<String> {
    let file = open(path)?;
    let mut kind = String::new();
    for attribute in file.attributes() {
        if !OWN_ATTRIBUTES.contains(&attribute.name()) {
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

/// Whole segments in the order of their shots, as many together as the bounds allow. Those whose shots lie
/// between each other's stay together, however many they are.
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
    /// Which segment of the group, and which record there.
    segment: usize,
    record: usize,
    /// Its share of the segment's bytes.
    bytes: u64,
}

/// Every shot of a group once, in order, in pieces within the bounds. Of a shot that is there twice, the
/// first one is taken.
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

/// Puts as few files as the bounds allow in the place of a group.
fn merge(folder: &Path, group: &[Segment], bounds: Bounds) -> Result<(), ArchiveError> {
    let mut written: Vec<PathBuf> = Vec::new();
    for piece in pieces(group, bounds).iter().filter(|piece| !piece.is_empty()) {
        let path = place_of(folder, group, piece, &written);
        write_piece(&path, group, piece)?;
        written.push(path);
    }
    if written.is_empty() {
        return Ok(());
    }
    for path in group.iter().map(|segment| &segment.path).filter(|path| !written.contains(path)) {
        fs::remove_file(path).map_err(ArchiveError::io("remove", path))?;
    }
    Ok(())
}

/// Where a merged file goes: to the name of its first shot, unless a file is there whose shots would be
/// lost. That may be a segment with other shots, or one of another model that has the same shot.
fn place_of(folder: &Path, group: &[Segment], piece: &[Record], written: &[PathBuf]) -> PathBuf {
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

/// Writes one merged file, with the time of the oldest of its group.
fn write_piece(path: &Path, group: &[Segment], piece: &[Record]) -> Result<(), ArchiveError> {
    let oldest = group.iter().min_by_key(|segment| segment.sealed);
    let records = piece.iter().map(|record| record.bytes).sum::<u64>();
    // What a file has beside its records, it has once more.
    let bytes = records + group.iter().map(|segment| segment.bytes).min().unwrap_or_default();
    let (memory, merged) = MemoryFile::create(MEMORY_FACTOR * bytes, create)
        .map_err(ArchiveError::io("write", path))?;
    let first_stored = oldest.and_then(|segment| segment.first_stored);
    merged
        .and_then(|merged| write(merged, group, piece, first_stored))
        .map_err(ArchiveError::netcdf(path))?;
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
    define(&mut merged, &group[0].path, group.len(), first_stored)?;
    for (number, segment) in group.iter().enumerate() {
        let records = piece.iter().enumerate().filter(|(_, record)| record.segment == number);
        let mut places: Vec<(usize, usize)> =
            records.map(|(place, record)| (record.record, place)).collect();
        places.sort_unstable();
        copy_records(&mut merged, &segment.path, &places)?;
    }
    merged.close()
}

/// Dimensions, variables and attributes as in `like`, and the values that belong to no shot.
fn define(
    merged: &mut FileMut,
    like: &Path,
    segments: usize,
    first_stored: Option<u64>,
) -> netcdf::Result<()> {
    let like = open(like)?;
    for attribute in like.attributes() {
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
    for dimension in like.dimensions() {
        if dimension.is_unlimited() {
            merged.add_unlimited_dimension(&dimension.name())?;
        } else {
            merged.add_dimension(&dimension.name(), dimension.len())?;
        }
    }
    for variable in like.variables() {
        let dimensions: Vec<String> = variable.dimensions().iter().map(|d| d.name()).collect();
        let dimensions: Vec<&str> = dimensions.iter().map(String::as_str).collect();
        let kind = variable.vartype();
        let mut copy = merged.add_variable_with_type(&variable.name(), &dimensions, &kind)?;
        for attribute in variable.attributes() {
            copy.put_attribute(attribute.name(), attribute.value()?)?;
        }
    }
    for variable in like.variables().filter(|variable| !has_shots(variable)) {
        copy(merged, &variable, None)?;
    }
    Ok(())
}

/// Copies records of a segment, each to its place.
fn copy_records(
    merged: &mut FileMut,
    from: &Path,
    places: &[(usize, usize)],
) -> netcdf::Result<()> {
    let segment = open(from)?;
    for variable in segment.variables().filter(has_shots) {
        // Records that follow each other in both files are one piece.
        for piece in places.chunk_by(|a, b| b.0 == a.0 + 1 && b.1 == a.1 + 1) {
            copy(merged, &variable, Some((piece[0], piece.len())))?;
        }
    }
    Ok(())
}

/// Copies a variable: all of it, or so many records from one place to another.
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
        _ => Err(netcdf::Error::Str(format!("{}: no type of a result", variable.name()))),
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
