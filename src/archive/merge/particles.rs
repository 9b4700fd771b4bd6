//! The particles of a merged file's shots, from the files beside their segments.

use std::{collections::BTreeMap, ops::Range, path::Path};

use netcdf::FileMut;

use super::{Record, Segment, add_like, copy, describe};
use crate::archive::{
    ArchiveError,
    durable::MemoryFile,
    netcdf_open::{create, open},
    particle_file::{PARTICLE, RECORD, RECORD_SHOT, ROW_SIZE, particles_beside},
    stored_particles::rows_in,
};

/// The particles of a shot in the file beside a segment.
struct Rows {
    shot: i64,
    /// Index of the segment in the group.
    segment: usize,
    rows: Range<usize>,
}

/// Writes the particles of a piece's shots to `path`. Where none were placed there is no file.
pub(super) fn merge(path: &Path, group: &[Segment], piece: &[Record]) -> Result<(), ArchiveError> {
    let found = rows_of(group, piece)?;
    let Some(Rows { segment, .. }) = found.first() else { return Ok(()) };
    let like = particles_beside(&group[*segment].path);
    let bytes = piece.iter().map(|record| record.bytes).sum::<u64>();
    let bytes = super::MEMORY_FACTOR * (bytes + group[*segment].bytes);
    let (memory, merged) =
        MemoryFile::create(bytes, create).map_err(ArchiveError::io("write", path))?;
    merged
        .and_then(|merged| write(merged, &like, group, &found))
        .map_err(ArchiveError::netcdf(path))?;
    memory.store(path)
}

/// Where the particles of the piece's shots are, in its order; shots without are left out.
fn rows_of(group: &[Segment], piece: &[Record]) -> Result<Vec<Rows>, ArchiveError> {
    let mut in_segments: BTreeMap<usize, BTreeMap<u64, Range<usize>>> = BTreeMap::new();
    for Record { segment, .. } in piece {
        let path = particles_beside(&group[*segment].path);
        if !in_segments.contains_key(segment) && path.exists() {
            let rows = open(&path).and_then(|file| rows_in(&file));
            in_segments.insert(*segment, rows.map_err(ArchiveError::unreadable_particles(&path))?);
        }
    }
    let rows = |record: &Record| {
        let Record { shot, segment, .. } = *record;
        let rows = in_segments.get(&segment)?.get(&u64::try_from(shot).ok()?)?.clone();
        Some(Rows { shot, segment, rows })
    };
    Ok(piece.iter().filter_map(rows).collect())
}

fn write(
    mut merged: FileMut,
    like: &Path,
    group: &[Segment],
    found: &[Rows],
) -> netcdf::Result<()> {
    describe(&mut merged, like, group.len(), None)?;
    define(&mut merged, like, found)?;
    let mut start = 0;
    let places = found.iter().map(|Rows { rows, .. }| {
        start += rows.len();
        start - rows.len()
    });
    let mut by_segment: BTreeMap<usize, Vec<(&Rows, usize)>> = BTreeMap::new();
    for (rows, to) in found.iter().zip(places) {
        by_segment.entry(rows.segment).or_default().push((rows, to));
    }
    for (segment, places) in by_segment {
        let file = open(&particles_beside(&group[segment].path))?;
        let variables = file.variables().filter(|variable| {
            variable.dimensions().first().is_some_and(|first| first.name() == PARTICLE)
        });
        for variable in variables {
            for (Rows { rows, .. }, to) in places.iter().filter(|(found, _)| !found.rows.is_empty())
            {
                copy(&mut merged, &variable, Some(((rows.start, *to), rows.len())))?;
            }
        }
    }
    merged.close()
}

/// Defines everything, and writes what is not over particles.
fn define(merged: &mut FileMut, like: &Path, found: &[Rows]) -> netcdf::Result<()> {
    let like = open(like)?;
    for dimension in like.dimensions() {
        let length = match dimension.name().as_str() {
            PARTICLE => found.iter().map(|found| found.rows.len()).sum(),
            RECORD => found.len(),
            _ => dimension.len(),
        };
        merged.add_dimension(&dimension.name(), length)?;
    }
    for variable in like.variables() {
        let mut copy = add_like(merged, &variable)?;
        copy.set_compression(1, true)?;
    }
    let numbers = [
        (RECORD_SHOT.name, found.iter().map(|found| found.shot).collect::<Vec<_>>()),
        (ROW_SIZE.name, found.iter().map(|found| found.rows.len() as i64).collect()),
    ];
    for (name, values) in numbers {
        let missing = || netcdf::Error::NotFound(name.to_owned());
        merged.variable_mut(name).ok_or_else(missing)?.put_values(&values, ..)?;
    }
    Ok(())
}
