//! Mean white image of one camera, without black level.

use lfpiv_hw::RawImage;

use super::CalibrationError;

/// Full scales of sensors with 8, 10, 12, 14 and 16 bit, in counts.
const FULL_SCALES: [u16; 5] = [255, 1023, 4095, 16_383, u16::MAX];

/// Largest distance of the saturation count from full scale: left-aligned counts of few bits end below it.
const FULL_SCALE_WITHIN: u16 = 16;

/// The mean of white images minus the mean of dark images.
#[derive(Debug, Clone)]
pub struct WhiteImage {
    columns: usize,
    rows: usize,
    light: Vec<f32>,
    saturated_share: f64,
}

impl WhiteImage {
    /// Averages images of the same diffuser. Without dark images the black level remains as a uniform background.
    ///
    /// # Errors
    /// There is no white image, or the sizes of the images differ.
    pub fn average(white: &[RawImage], dark: &[RawImage]) -> Result<Self, CalibrationError> {
        let first = white.first().ok_or(CalibrationError::NoImage)?;
        let (columns, rows) = (first.columns(), first.rows());
        let different = |image: &&RawImage| (image.columns(), image.rows()) != (columns, rows);
        if let Some((before, image)) =
            white.iter().chain(dark).enumerate().find(|(_, image)| different(image))
        {
            return Err(CalibrationError::DifferentSizes {
                number: before + 1,
                found_columns: image.columns(),
                found_rows: image.rows(),
                columns,
                rows,
            });
        }
        let mut light = mean(white, columns * rows);
        if !dark.is_empty() {
            let black = mean(dark, columns * rows);
            light.iter_mut().zip(black).for_each(|(light, black)| *light -= black);
        }
        Ok(Self { columns, rows, light, saturated_share: saturated_share(white) })
    }

    /// Pixel columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// Pixel rows.
    pub fn rows(&self) -> usize {
        self.rows
    }

    /// Counts above the black level, row by row.
    pub fn light(&self) -> &[f32] {
        &self.light
    }

    /// Share of saturated pixels in the white images.
    pub fn saturated_share(&self) -> f64 {
        self.saturated_share
    }

    /// Counts of one pixel above the black level.
    #[inline]
    pub fn at(&self, column: usize, row: usize) -> f64 {
        f64::from(self.light[row * self.columns + column])
    }

    /// Counts at a sub-pixel position, by cubic convolution (Keys, IEEE Trans. Acoust. 29, 1981; a = −1/2). It is
    /// of third order; linear interpolation would displace edges depending on their sub-pixel position. `None`
    /// within two pixels of the image's border.
    pub fn between(&self, column_px: f64, row_px: f64) -> Option<f64> {
        let inside = |place: f64, pixels: usize| place >= 1.0 && place < pixels as f64 - 2.0;
        if !inside(column_px, self.columns) || !inside(row_px, self.rows) {
            return None;
        }
        let (column, row) = (column_px as usize, row_px as usize);
        let across = cubic_weights(column_px - column as f64);
        let down = cubic_weights(row_px - row as f64);
        let first = (row - 1) * self.columns + column - 1;
        let lines = down.iter().enumerate().map(|(line, weight)| {
            let pixels = &self.light[first + line * self.columns..][..4];
            let sum: f64 = pixels.iter().zip(across).map(|(&light, w)| f64::from(light) * w).sum();
            weight * sum
        });
        Some(lines.sum())
    }
}

fn mean(images: &[RawImage], pixels: usize) -> Vec<f32> {
    let mut sums = vec![0u64; pixels];
    for image in images {
        for (sum, &count) in sums.iter_mut().zip(image.counts()) {
            *sum += u64::from(count);
        }
    }
    sums.iter().map(|&sum| (sum as f64 / images.len() as f64) as f32).collect()
}

/// Share of pixels at the highest count, if that is the end of a sensor's range; otherwise 0.
fn saturated_share(images: &[RawImage]) -> f64 {
    let counts = || images.iter().flat_map(|image| image.counts());
    let brightest = counts().copied().max().unwrap_or(0);
    let ends_a_range = FULL_SCALES
        .iter()
        .any(|&full| brightest <= full && full - brightest < FULL_SCALE_WITHIN.min(full / 256 + 1));
    if !ends_a_range {
        return 0.0;
    }
    let pixels = counts().count();
    counts().filter(|&&count| count == brightest).count() as f64 / pixels as f64
}

fn cubic_weights(t: f64) -> [f64; 4] {
    let (t2, t3) = (t * t, t * t * t);
    [
        -0.5 * t3 + t2 - 0.5 * t,
        1.5 * t3 - 2.5 * t2 + 1.0,
        -1.5 * t3 + 2.0 * t2 + 0.5 * t,
        0.5 * t3 - 0.5 * t2,
    ]
}
