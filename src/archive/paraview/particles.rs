//! The particles of a shot for ParaView.

use std::{io::Write, path::Path};

use lfpiv_core::velocimetry::{MeasuredParticle, VelocityField};

use super::{Array, VtiSource, write_arrays, write_data, write_field_data};
use crate::archive::{ArchiveError, durable::replace};

/// Writes particles for ParaView: vertices of a PolyData, in SI units, with the point arrays `velocity`,
/// `velocity_uncertainty` (m/s), `light` (counts, mean of the cameras) and `valid`. `field` is what they are
/// particles of.
pub fn write_vtp(
    path: &Path,
    source: &VtiSource,
    field: &VelocityField,
    particles: &[MeasuredParticle],
) -> Result<(), ArchiveError> {
    let count = particles.len();
    let speed = field.metres_per_second_per_voxel() as f32;
    let cameras =
        |p: &MeasuredParticle| p.light.iter().filter(|light| **light > 0.0).count().max(1);
    let light: Vec<f32> =
        particles.iter().map(|p| p.light.iter().sum::<f32>() / cameras(p) as f32).collect();
    let points =
        [Array::vectors("points", particles.iter().map(|p| p.at_mm.map(|mm| (mm * 1e-3) as f32)))];
    let vertices = [
        Array::integers("connectivity", 0..count as i64),
        Array::integers("offsets", 1..=count as i64),
    ];
    let of_points = [
        Array::vectors("velocity", particles.iter().map(|p| p.displacement_vox.map(|d| d * speed))),
        Array::vectors(
            "velocity_uncertainty",
            particles.iter().map(|p| p.uncertainty_vox.map(|u| u * speed)),
        ),
        Array::scalars("light", &light),
        Array::flags("valid", particles.iter().map(|p| u8::from(p.agrees))),
    ];
    replace(path, |writer| {
        writeln!(
            writer,
            r#"<?xml version="1.0"?>
<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<PolyData>"#
        )?;
        write_field_data(writer, source, field.dt_s)?;
        writeln!(writer, r#"<Piece NumberOfPoints="{count}" NumberOfVerts="{count}">"#)?;
        let mut offset = 0;
        let parts: [(&str, &[Array]); 3] = [
            ("Points", &points),
            ("Verts", &vertices),
            (r#"PointData Vectors="velocity" Scalars="valid""#, &of_points),
        ];
        for (tag, arrays) in parts {
            writeln!(writer, "<{tag}>")?;
            offset = write_arrays(writer, arrays, offset)?;
            let name = tag.split(' ').next().unwrap_or(tag);
            writeln!(writer, "</{name}>")?;
        }
        write!(writer, "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_")?;
        write_data(writer, parts.iter().flat_map(|(_, arrays)| arrays.iter()))
    })
}
