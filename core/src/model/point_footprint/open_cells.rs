//! How much of the aperture the pixels behind each microlens see.

use rayon::prelude::*;

use super::LANES;
use crate::{lightfield::Aperture, model::mapped_optics::MappedOptics};

/// Pixels beside a micro-image that its outermost rays reach.
const BESIDE_PX: f64 = 1.5;

/// Open shares in steps of 1/255, a tile of pixels per microlens of the window.
#[derive(Debug, Clone)]
pub struct OpenCells {
    shares: Vec<u8>,
    /// Pixels of a tile along its columns and rows.
    edge: usize,
    lens_columns: usize,
    half_px: f64,
}

impl OpenCells {
    /// The cells of a camera.
    pub fn new(seen: &MappedOptics) -> Self {
        let pitch_px = seen.sampling.grid.pitch_px().into_iter().fold(0.0, f64::max);
        let half_px = pitch_px / 2.0 + BESIDE_PX;
        let edge = (2.0 * half_px).ceil() as usize + 1;
        let window = &seen.window;
        let aperture = Aperture {
            radius_mm: seen.optics.pupil_diameter_mm() / 2.0,
            interval_mm: seen.sampling.cell_mm,
        };
        let (lens_columns, lens_rows) = (window.columns.len(), window.rows.len());
        let cell_mm = seen.sampling.cell_mm;
        let mut shares: Vec<u8> = (0..lens_columns * lens_rows)
            .into_par_iter()
            .flat_map_iter(|lens| {
                let lens = [lens % lens_columns, lens / lens_columns];
                let centre = seen.centre_px(lens);
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
        // Kernels read whole lanes.
        shares.extend([0; LANES]);
        Self { shares, edge, lens_columns, half_px }
    }

    /// First column, or row, of a tile whose micro-image is centred at `centre_px`.
    pub fn first_px(&self, centre_px: f64) -> i64 {
        (centre_px - self.half_px).ceil() as i64
    }

    /// Pixels of a tile along each axis.
    pub fn edge(&self) -> usize {
        self.edge
    }

    /// All tiles, row-major each.
    pub fn shares(&self) -> &[u8] {
        &self.shares
    }

    /// Where the tile of a microlens of the window begins.
    pub fn tile(&self, lens: [usize; 2]) -> usize {
        (lens[1] * self.lens_columns + lens[0]) * self.edge * self.edge
    }
}
