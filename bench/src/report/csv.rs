//! CSV for spreadsheets.

use std::io::{self, Write};

use serde::Serialize;

use crate::{Curve, Row};

/// One line per row; absent figures are empty.
pub fn rows<'a>(writer: impl Write, rows: impl Iterator<Item = &'a Row>) -> io::Result<()> {
    let mut table = csv::Writer::from_writer(writer);
    for row in rows {
        table.serialize(row)?;
    }
    table.flush()
}

/// A point of a curve.
#[derive(Serialize)]
struct Point<'a> {
    case: &'a str,
    method: &'a str,
    cameras: usize,
    ppm: f64,
    seed: u64,
    curve: &'a str,
    x: f64,
    y: f64,
}

/// One line per point.
pub fn curves(writer: impl Write, curves: &[Curve]) -> io::Result<()> {
    let mut table = csv::Writer::from_writer(writer);
    for curve in curves {
        for &[x, y] in &curve.points {
            table.serialize(Point {
                case: &curve.case,
                method: &curve.method,
                cameras: curve.cameras,
                ppm: curve.ppm,
                seed: curve.seed,
                curve: &curve.name,
                x,
                y,
            })?;
        }
    }
    table.flush()
}
