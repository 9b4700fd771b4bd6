//! Files for ParaView: one `.vti` per shot (VTK XML ImageData, raw appended data), a `.vti.series` that lists
//! them; `.vtp` for the particles of a shot (PolyData), and a `.pvd` that lists those.

mod particles;

pub use particles::write_vtp;

use std::{
    io::{self, Write},
    path::Path,
};

use lfpiv_core::velocimetry::{VectorStatus, VelocityField};
use serde::Serialize;

use super::{ArchiveError, durable::replace};

/// VTK's flag for points that filters and views ignore (`vtkDataSetAttributes::HIDDENPOINT`).
const HIDDEN_POINT: u8 = 2;

/// Origin of a file for ParaView.
#[derive(Debug, Clone, Copy)]
pub struct VtiSource<'a> {
    /// Shot number.
    pub shot: u64,
    /// UTC of the trigger in seconds since 1970, if known.
    pub utc_s: Option<f64>,
    /// The configuration's TOML text.
    pub configuration: &'a str,
}

/// One array of the file: name, VTK type, number of components, little-endian bytes.
struct Array {
    name: &'static str,
    vtk_type: &'static str,
    components: usize,
    bytes: Vec<u8>,
}

impl Array {
    fn vectors(name: &'static str, values: impl Iterator<Item = [f32; 3]>) -> Self {
        let bytes = values.flatten().flat_map(f32::to_le_bytes).collect();
        Self { name, vtk_type: "Float32", components: 3, bytes }
    }

    fn scalars(name: &'static str, values: &[f32]) -> Self {
        let bytes = values.iter().flat_map(|v| v.to_le_bytes()).collect();
        Self { name, vtk_type: "Float32", components: 1, bytes }
    }

    fn integers(name: &'static str, values: impl Iterator<Item = i64>) -> Self {
        let bytes = values.flat_map(i64::to_le_bytes).collect();
        Self { name, vtk_type: "Int64", components: 1, bytes }
    }

    fn flags(name: &'static str, values: impl Iterator<Item = u8>) -> Self {
        Self { name, vtk_type: "UInt8", components: 1, bytes: values.collect() }
    }
}

/// Writes one velocity field for ParaView: vectors at the points of an ImageData, in SI units
/// (positions in m, velocities in m/s).
///
/// Point arrays: `velocity` and its standard uncertainty `velocity_uncertainty` (m/s),
/// `displacement_vox`, `vorticity_per_s`, `peak_ratio`, `valid`, `replaced`, `masked`. `vtkGhostType` hides
/// vectors without a value, whose numbers are NaN. Field data: `shot`, `dt_s`, `TimeValue` (UTC, s since
/// 1970, if known), `source` and `configuration`.
pub fn write_vti(
    path: &Path,
    source: &VtiSource,
    field: &VelocityField,
) -> Result<(), ArchiveError> {
    let arrays = arrays_of(field);
    replace(path, |writer| {
        write_header(writer, source, field, &arrays)?;
        write_data(writer, &arrays)
    })
}

fn arrays_of(field: &VelocityField) -> [Array; 9] {
    let to_velocity = field.metres_per_second_per_voxel() as f32;
    let to_rate = (1.0 / field.dt_s) as f32;
    let scaled = |factor: f32| move |vector: [f32; 3]| vector.map(|component| component * factor);
    let mark = |wanted: VectorStatus, mark: u8| {
        field.status.iter().map(move |status| if *status == wanted { mark } else { 0 })
    };
    let hidden =
        field.status.iter().map(|status| if status.has_value() { 0 } else { HIDDEN_POINT });
    let displacement = || field.or_nan(&field.displacement_vox);
    let uncertainty = field.or_nan(&field.uncertainty_vox);
    [
        Array::vectors("velocity", displacement().map(scaled(to_velocity))),
        Array::vectors("velocity_uncertainty", uncertainty.map(scaled(to_velocity))),
        Array::vectors("displacement_vox", displacement()),
        Array::vectors("vorticity_per_s", field.vorticity_or_nan().map(scaled(to_rate))),
        Array::scalars("peak_ratio", &field.peak_ratio),
        Array::flags("valid", mark(VectorStatus::Valid, 1)),
        Array::flags("replaced", mark(VectorStatus::Replaced, 1)),
        Array::flags("masked", mark(VectorStatus::Masked, 1)),
        Array::flags("vtkGhostType", hidden),
    ]
}

fn write_header(
    writer: &mut impl Write,
    source: &VtiSource,
    field: &VelocityField,
    arrays: &[Array],
) -> io::Result<()> {
    let [nx, ny, nz] = field.grid.vectors.map(|n| n.saturating_sub(1));
    let [x, y, z] = field.grid.first_mm.map(|mm| mm * 1e-3);
    let spacing = field.grid.spacing_mm * 1e-3;
    let extent = format!("0 {nx} 0 {ny} 0 {nz}");
    write!(
        writer,
        r#"<?xml version="1.0"?>
<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<ImageData WholeExtent="{extent}" Origin="{x} {y} {z}" Spacing="{spacing} {spacing} {spacing}">
"#
    )?;
    write_field_data(writer, source, field.dt_s)?;
    writeln!(
        writer,
        r#"<Piece Extent="{extent}">
<PointData Vectors="velocity" Scalars="valid">"#
    )?;
    write_arrays(writer, arrays, 0)?;
    // The underscore marks the first byte of the data.
    write!(writer, "</PointData>\n</Piece>\n</ImageData>\n<AppendedData encoding=\"raw\">\n_")
}

/// Writes the headers of arrays whose data begins at `offset`, and returns where the next one's does.
fn write_arrays(writer: &mut impl Write, arrays: &[Array], offset: usize) -> io::Result<usize> {
    let mut offset = offset;
    for Array { name, vtk_type, components, bytes } in arrays {
        writeln!(
            writer,
            r#"<DataArray type="{vtk_type}" Name="{name}" NumberOfComponents="{components}" format="appended" offset="{offset}"/>"#
        )?;
        offset += size_of::<u64>() + bytes.len();
    }
    Ok(offset)
}

/// Writes the data of arrays, behind their headers, and the end of the file.
fn write_data<'a>(
    writer: &mut impl Write,
    arrays: impl IntoIterator<Item = &'a Array>,
) -> io::Result<()> {
    for array in arrays {
        writer.write_all(&(array.bytes.len() as u64).to_le_bytes())?;
        writer.write_all(&array.bytes)?;
    }
    writer.write_all(b"\n</AppendedData>\n</VTKFile>\n")
}

/// Writes the field data: time, if known, and origin.
fn write_field_data(writer: &mut impl Write, source: &VtiSource, dt_s: f64) -> io::Result<()> {
    let VtiSource { shot, utc_s, configuration } = source;
    writeln!(writer, "<FieldData>")?;
    if let Some(utc_s) = utc_s {
        write_number(writer, "TimeValue", "Float64", utc_s)?;
    }
    write_number(writer, "dt_s", "Float64", dt_s)?;
    write_number(writer, "shot", "UInt64", shot)?;
    write_text(writer, "source", concat!("lfpiv ", env!("CARGO_PKG_VERSION")))?;
    write_text(writer, "configuration", configuration)?;
    writeln!(writer, "</FieldData>")
}

fn write_number(
    writer: &mut impl Write,
    name: &str,
    vtk_type: &str,
    number: impl std::fmt::Display,
) -> io::Result<()> {
    writeln!(
        writer,
        r#"<DataArray type="{vtk_type}" Name="{name}" NumberOfTuples="1" format="ascii">{number}</DataArray>"#
    )
}

/// VTK stores text as the numbers of its bytes, terminated by zero.
fn write_text(writer: &mut impl Write, name: &str, text: &str) -> io::Result<()> {
    write!(writer, r#"<Array type="String" Name="{name}" NumberOfTuples="1" format="ascii">"#)?;
    for byte in text.bytes() {
        write!(writer, "{byte} ")?;
    }
    writeln!(writer, "0</Array>")
}

/// A list of files that ParaView opens as one animation: `.vti` files as a `.vti.series`, others as a `.pvd`.
///
/// ParaView's time is UTC in seconds since 1970, or the shot number unless every shot has a time.
pub struct FileSeries<'a> {
    name_of: Box<dyn Fn(u64) -> String + Send + 'a>,
    /// Sorted by shot. A run may have a million files, so only their numbers and times are kept.
    files: Vec<ListedFile>,
}

struct ListedFile {
    shot: u64,
    utc_s: Option<f64>,
}

/// The file in ParaView's format.
#[derive(Serialize)]
struct SeriesFile {
    #[serde(rename = "file-series-version")]
    version: &'static str,
    files: Vec<SeriesEntry>,
}

#[derive(Serialize)]
struct SeriesEntry {
    name: String,
    time: f64,
}

impl<'a> FileSeries<'a> {
    /// An empty list. `name_of` maps a shot to the path of its file, relative to the series file.
    pub fn new(name_of: impl Fn(u64) -> String + Send + 'a) -> Self {
        Self { name_of: Box::new(name_of), files: Vec::new() }
    }

    /// Path of a shot's file, relative to the list.
    pub fn name_of(&self, shot: u64) -> String {
        (self.name_of)(shot)
    }

    /// Adds or replaces the file of a shot; `utc_s` is the shot's time, if known.
    pub fn push(&mut self, shot: u64, utc_s: Option<f64>) {
        let file = ListedFile { shot, utc_s };
        match self.files.binary_search_by_key(&shot, |file| file.shot) {
            Ok(at) => self.files[at] = file,
            Err(at) => self.files.insert(at, file),
        }
    }

    /// Number of listed files.
    pub fn len(&self) -> usize {
        self.files.len()
    }

    /// Whether no file is listed.
    pub fn is_empty(&self) -> bool {
        self.files.is_empty()
    }

    /// Writes the list as a `.vti.series`, replacing an older one.
    pub fn write(&self, path: &Path) -> Result<(), ArchiveError> {
        let series = SeriesFile { version: "1.0", files: self.entries().collect() };
        replace(path, |writer| {
            serde_json::to_writer_pretty(writer, &series).map_err(io::Error::from)
        })
    }

    /// Writes the list as a `.pvd`, replacing an older one.
    pub fn write_pvd(&self, path: &Path) -> Result<(), ArchiveError> {
        replace(path, |writer| {
            writeln!(writer, r#"<?xml version="1.0"?>"#)?;
            writeln!(writer, r#"<VTKFile type="Collection" version="1.0">"#)?;
            writeln!(writer, "<Collection>")?;
            for SeriesEntry { name, time } in self.entries() {
                writeln!(writer, r#"<DataSet timestep="{time}" part="0" file="{name}"/>"#)?;
            }
            writeln!(writer, "</Collection>\n</VTKFile>")
        })
    }

    fn entries(&self) -> impl Iterator<Item = SeriesEntry> {
        let timed = self.files.iter().all(|file| file.utc_s.is_some());
        self.files.iter().map(move |&ListedFile { shot, utc_s }| SeriesEntry {
            name: self.name_of(shot),
            time: utc_s.filter(|_| timed).unwrap_or(shot as f64),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::archive::test_data::result;

    #[test]
    fn appended_arrays_start_at_the_offsets_in_the_header() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("shot.vti");
        let field = result([4, 3, 2]).measured.field;
        let source = VtiSource { shot: 7, utc_s: Some(12.5), configuration: "[a]" };
        write_vti(&path, &source, &field).unwrap();
        let bytes = std::fs::read(&path).unwrap();
        let marker = b"<AppendedData encoding=\"raw\">\n_";
        let data = bytes.windows(marker.len()).position(|w| w == marker).unwrap() + marker.len();
        let header = std::str::from_utf8(&bytes[..data]).unwrap();
        assert!(header.contains(r#"WholeExtent="0 3 0 2 0 1" Origin="-0.001 -0.002 -0.003""#));
        assert!(header.contains(r#"Name="TimeValue" NumberOfTuples="1" format="ascii">12.5<"#));
        assert!(header.contains(r#"format="ascii">91 97 93 0</Array>"#), "{header}");
        let line = header.lines().find(|l| l.contains("\"peak_ratio\"")).unwrap();
        let offset: usize =
            line.split("offset=\"").nth(1).unwrap().trim_end_matches("\"/>").parse().unwrap();
        let at = |i: usize| &bytes[data + offset + i..];
        assert_eq!(u64::from_le_bytes(at(0)[..8].try_into().unwrap()), 24 * 4);
        assert_eq!(f32::from_le_bytes(at(8 + 4)[..4].try_into().unwrap()), field.peak_ratio[1]);
    }

    #[test]
    fn a_series_lists_its_shots() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("velocity.vti.series");
        let mut series = FileSeries::new(|shot| format!("shot_{shot:06}.vti"));
        let read = |series: &FileSeries<'_>| -> serde_json::Value {
            series.write(&path).unwrap();
            serde_json::from_slice(&std::fs::read(&path).unwrap()).unwrap()
        };
        series.push(3, Some(1_700_000_000.5));
        series.push(2, Some(1_700_000_000.25));
        let timed = read(&series);
        assert_eq!(timed["file-series-version"], "1.0");
        assert_eq!(timed["files"][0]["name"], "shot_000002.vti");
        assert_eq!(timed["files"][1]["time"], 1_700_000_000.5);
        // A shot number among dates would appear decades earlier.
        series.push(4, None);
        let times = read(&series)["files"].as_array().unwrap().clone();
        let times: Vec<_> = times.iter().map(|file| file["time"].as_f64().unwrap()).collect();
        assert_eq!(times, [2.0, 3.0, 4.0]);
        series.write_pvd(&path).unwrap();
        let collection = std::fs::read_to_string(&path).unwrap();
        let listed = r#"<DataSet timestep="3" part="0" file="shot_000003.vti"/>"#;
        assert!(collection.contains(listed), "{collection}");
    }
}
