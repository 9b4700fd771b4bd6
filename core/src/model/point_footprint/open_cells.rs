//! Open shares of the pupil cells of all pixels behind each microlens.

use rayon::prelude::*;

use super::LANES;
use crate::{lightfield::Aperture, model::mapped_optics::MappedOptics};

/// Margin around a micro-image for its outermost rays, in pixels.
const MARGIN_PX: f64 = 1.5;

/// Open shares in units of 1/255, in a tile of pixels for each microlens of the window.
#[derive(Debug, Clone)]
pub struct OpenCells {
    shares: Vec<u8>,
    /// Number of pixels along an edge of a tile.
    edge: usize,
    lens_columns: usize,
    half_px: f64,
}

impl OpenCells {
    /// The cells of a camera.
    pub fn new(mapped: &MappedOptics) -> Self {
        let pitch_px = mapped.sampling.grid.pitch_px().into_iter().fold(0.0, f64::max);
        let half_px = pitch_px / 2.0 + MARGIN_PX;
        let edge = (2.0 * half_px).ceil() as usize + 1;
        let window = &mapped.window;
        let aperture = Aperture {
            radius_mm: mapped.optics.pupil_diameter_mm() / 2.0,
            interval_mm: mapped.sampling.cell_mm,
        };
        let (lens_columns, lens_rows) = (window.columns.len(), window.rows.len());
        let cell_mm = mapped.sampling.cell_mm;
        let mut shares: Vec<u8> = (0..lens_columns * lens_rows)
            .into_par_iter()
            .flat_map_iter(|lens| {
                let lens = [lens % lens_columns, lens / lens_columns];
                let centre = mapped.centre_px(lens);
                let first = centre.map(|px| (px - half_px).ceil());
                let aperture = &aperture;
                (0..edge * edge).map(move |n| {
                    let column = first[0] + (n % edge) as f64;
                    let row = first[1] + (n / edge) as f64;
                    let pupil = [(centre[0] - column) * cell_mm, (row - centre[1]) * cell_mm];
                    (255.0 * aperture.covered(pupil)).round() as u8
                })
            })
            .collect();
        // Padding, because kernels read multiples of `LANES` values.
        shares.extend([0; LANES]);
        Self { shares, edge, lens_columns, half_px }
    }

    /// First column, or row, of a tile whose micro-image is centred at `centre_px`.
    pub fn first_px(&self, centre_px: f64) -> i64 {
        (centre_px - self.half_px).ceil() as i64
    }

    /// Number of pixels along an edge of a tile.
    pub fn edge(&self) -> usize {
        self.edge
    }

    /// All tiles, each row-major.
    pub fn shares(&self) -> &[u8] {
        &self.shares
    }

    /// Index of the first pixel of the tile of a microlens of the window.
    pub fn tile(&self, lens: [usize; 2]) -> usize {
        (lens[1] * self.lens_columns + lens[0]) * self.edge * self.edge
    }
}
