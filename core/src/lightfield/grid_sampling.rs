//! Assignment of pixels to microlenses and views for an arbitrarily oriented array.
//!
//! [`super::AxisSampling`] requires an array along the sensor's axes. Here a [`MicroImageGrid`] gives the
//! centres of the micro-images. View (k, l) consists of the pixel behind every microlens that is k columns to
//! the left of and l rows below the pixel nearest to the micro-image's centre. The ray through its centre
//! crosses the pupil k cells to the right and l cells above the centre, plus the *phase*: the distance from the
//! nearest pixel to the micro-image's centre. Nothing is resampled; the phase is known for every microlens.

use lfpiv_hw::Optics;

use super::MicroImageGrid;

/// Centres within this distance of the middle between two pixels are assigned to the higher index. Single
/// precision, with an error of 2.4·10⁻⁴ for 5000 pixels, then gives the same result.
pub const TIE_PX: f64 = 1e-3;

/// The sampling of a sensor behind a square array that may be rotated, shifted and stretched.
#[derive(Debug, Clone, PartialEq)]
pub struct GridSampling {
    /// Centres of the micro-images.
    pub grid: MicroImageGrid,
    /// View indices run from `-reach` to `reach` along both axes.
    pub reach: i32,
    /// Width of a pixel's interval on the pupil, in mm.
    pub cell_mm: f64,
    /// Pixels along the sensor's columns and rows.
    sensor: [usize; 2],
    /// Derivatives of the microlens indices (i, j) with respect to (column, row).
    lenses_per_px: [[f64; 2]; 2],
    /// Largest distance along i and j between a pixel's centre and that of its micro-image, in
    /// microlenses. Beyond it the pixel receives light from two microlenses.
    max_offset: [f64; 2],
}

/// The pixel nearest to the centre of a micro-image.
#[derive(Debug, Clone, Copy)]
pub struct NearestPixel {
    /// Its column and row.
    place_px: [i32; 2],
    /// Offset of the pixel from the micro-image's centre, in microlenses along i and j.
    off: [f64; 2],
}

impl GridSampling {
    /// The sampling of a camera with these optics and micro-images.
    pub fn new(optics: &Optics, grid: &MicroImageGrid) -> Self {
        let [origin, next_column, next_row] =
            [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)].map(|(column, row)| grid.lens_at(column, row));
        let lenses_per_px =
            [0, 1].map(|axis| [next_column[axis] - origin[axis], next_row[axis] - origin[axis]]);
        let max_offset = lenses_per_px.map(|[column, row]| 0.5 - (column.abs() + row.abs()) / 2.0);
        let longest = grid.pitch_px().into_iter().fold(0.0, f64::max);
        Self {
            grid: grid.clone(),
            reach: (longest / 2.0).ceil() as i32 + 1,
            cell_mm: optics.pupil_cell_mm(),
            sensor: [optics.sensor.columns, optics.sensor.rows],
            lenses_per_px,
            max_offset,
        }
    }

    /// The phase of microlens (i, j): the offset of the pupil interval of view (0, 0) from the pupil's
    /// centre, in cells to the right and upwards, each within half a cell.
    pub fn phase(&self, i: usize, j: usize) -> [f64; 2] {
        let [column, row] = self.grid.centre_px(i as f64, j as f64);
        [column - nearest(column), nearest(row) - row]
    }

    /// The pixel nearest to the centre of a microlens' micro-image.
    pub fn nearest_pixel(&self, i: usize, j: usize) -> NearestPixel {
        let centre = self.grid.centre_px(i as f64, j as f64);
        let place_px = centre.map(nearest);
        let off_px = [place_px[0] - centre[0], place_px[1] - centre[1]];
        NearestPixel { place_px: place_px.map(|px| px as i32), off: self.in_lenses(off_px) }
    }

    /// Column and row of a microlens' pixel in view (k, l), as a function of the microlens' nearest pixel. `None`
    /// if the pixel is shared or off the sensor.
    pub fn pixels(&self, (k, l): (i32, i32)) -> impl Fn(&NearestPixel) -> Option<[usize; 2]> {
        let [by_i, by_j] = self.in_lenses([f64::from(-k), f64::from(l)]);
        let ([most_i, most_j], [columns, rows]) = (self.max_offset, self.sensor);
        move |nearest| {
            let [i, j] = nearest.off;
            let own = (i + by_i).abs() <= most_i && (j + by_j).abs() <= most_j;
            let [column, row] = nearest.place_px;
            let column = usize::try_from(column - k).ok().filter(|&column| column < columns);
            let row = usize::try_from(row + l).ok().filter(|&row| row < rows);
            Some([column?, row?]).filter(|_| own)
        }
    }

    /// [`Self::pixels`] of one microlens.
    pub fn pixel(&self, view: (i32, i32), i: usize, j: usize) -> Option<[usize; 2]> {
        self.pixels(view)(&self.nearest_pixel(i, j))
    }

    /// Centre of a pixel's pupil interval, in mm along `right` and `up`. `None` for pixels shared by two
    /// microlenses or outside the array.
    pub fn pupil_of_pixel_mm(&self, column: usize, row: usize) -> Option<[f64; 2]> {
        let pixel = [column as f64, row as f64];
        let [i, j] = self.grid.lens_at(pixel[0], pixel[1]);
        let lens = [i.round(), j.round()];
        let own =
            (i - lens[0]).abs() <= self.max_offset[0] && (j - lens[1]).abs() <= self.max_offset[1];
        let exists = (0..2).all(|n| lens[n] >= 0.0 && lens[n] < self.grid.microlenses[n] as f64);
        let centre = self.grid.centre_px(lens[0], lens[1]);
        let pupil = [(centre[0] - pixel[0]) * self.cell_mm, (pixel[1] - centre[1]) * self.cell_mm];
        (own && exists).then_some(pupil)
    }

    /// Converts a vector on the sensor, in columns and rows, to microlenses along i and j.
    fn in_lenses(&self, [columns, rows]: [f64; 2]) -> [f64; 2] {
        self.lenses_per_px.map(|[by_column, by_row]| by_column * columns + by_row * rows)
    }

    /// Centre of the pupil interval of microlens (i, j) in view (k, l), in mm along `right` and `up`.
    pub fn pupil_mm(&self, (k, l): (i32, i32), i: usize, j: usize) -> [f64; 2] {
        let [right, up] = self.phase(i, j);
        [(f64::from(k) + right) * self.cell_mm, (f64::from(l) + up) * self.cell_mm]
    }
}

/// The integer nearest to a pixel coordinate.
fn nearest(px: f64) -> f64 {
    (px + 0.5 + TIE_PX).floor()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{lightfield::AxisSampling, test_bench};

    /// For an ideal array both samplings assign the same microlens and pupil interval to a pixel. Excluded are the
    /// central lens, whose pixels are halfway between two view indices, and view indices of 9, whose pixels are
    /// shared by some microlenses.
    #[test]
    fn both_samplings_agree_for_the_nominal_array() {
        let optics = test_bench::optics();
        let sampling = GridSampling::new(&optics, &MicroImageGrid::nominal(&optics));
        let (columns, rows) = (AxisSampling::columns(&optics), AxisSampling::rows(&optics));
        for (i, j) in [(0, 0), (3, 50), (57, 41), (101, 20), (128, 96)] {
            for (k, l) in (-8..=8).flat_map(|k| (-8..=8).map(move |l| (k, l))) {
                let along_axes = columns.sample(k, i).zip(rows.sample(l, j));
                let pixel = sampling.pixel((k, l), i, j);
                let nominal = along_axes.map(|(column, row)| [column.pixel, row.pixel]);
                assert_eq!(
                    pixel.map(|of| of.map(|place| place as u32)),
                    nominal,
                    "{k}, {l}: {i}, {j}"
                );
                let Some((column, row)) = along_axes else { continue };
                let [u, v] = sampling.pupil_mm((k, l), i, j);
                assert!((u - column.pupil_mm).abs() < 1e-9);
                assert!((v - row.pupil_mm).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn every_pixel_of_a_rotated_array_belongs_to_one_microlens_and_view() {
        let optics = test_bench::optics();
        let nominal = MicroImageGrid::nominal(&optics);
        let (sine, cosine) = 1.0f64.to_radians().sin_cos();
        let pitch = nominal.column_px[1];
        let grid = MicroImageGrid {
            column_px: [40.2, pitch * cosine, -pitch * sine],
            row_px: [1700.7, -pitch * sine, -pitch * cosine],
            ..nominal
        };
        let sampling = GridSampling::new(&optics, &grid);
        let mut seen = std::collections::HashMap::new();
        for (i, j) in (40..50).flat_map(|i| (30..40).map(move |j| (i, j))) {
            for k in -sampling.reach..=sampling.reach {
                for l in -sampling.reach..=sampling.reach {
                    let Some(pixel) = sampling.pixel((k, l), i, j) else { continue };
                    *seen.entry(pixel).or_insert(0) += 1;
                    let [column, row] = grid.centre_px(i as f64, j as f64);
                    let [u, v] = sampling.pupil_mm((k, l), i, j);
                    assert!((u / sampling.cell_mm - (column - pixel[0] as f64)).abs() < 1e-9);
                    assert!((v / sampling.cell_mm - (pixel[1] as f64 - row)).abs() < 1e-9);
                }
            }
        }
        assert!(seen.values().all(|&times| times == 1));
        // Of 18.25 pixels in each direction, one is shared.
        let share = seen.len() as f64 / (100.0 * pitch * pitch);
        assert!((share - 0.89).abs() < 0.03, "{share}");
    }
}
