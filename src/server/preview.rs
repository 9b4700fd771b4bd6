//! Previews of images: reduced by area averaging, scaled to 8 bits, encoded as PNG.

use axum::{
    body::Bytes,
    http::{HeaderMap, HeaderName, HeaderValue},
};
use image::{ExtendedColorType, ImageEncoder, codecs::png::PngEncoder};
use lfpiv_hw::RawImage;
use tokio::sync::oneshot;

use super::{ApiError, work::Work};

/// Share of the pixels that are not brighter than white. A few hot pixels must not darken the
/// image.
const WHITE_PERCENTILE: f64 = 0.999;

/// Grey values before scaling.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Grey {
    pub columns: usize,
    pub rows: usize,
    /// Row-major, the top row first.
    pub values: Vec<f32>,
}

/// A PNG and the value of its white. Black is zero.
#[derive(Debug)]
pub(super) struct Preview {
    pub png: Vec<u8>,
    pub white: f32,
}

/// The media type of previews.
pub(super) const PNG: &str = "image/png";

/// Makes a preview within the limits of `work`; returns the PNG and the header with its white
/// value.
pub(super) async fn encode_preview(
    work: &Work,
    bytes: usize,
    preview: impl FnOnce() -> Result<Preview, ApiError> + Send + 'static,
) -> Result<(Bytes, HeaderMap), ApiError> {
    let (tell_white, white) = oneshot::channel();
    let png = work.make(bytes, move || {
        let Preview { png, white } = preview()?;
        // The receiver exists until this closure ends.
        let _ = tell_white.send(white);
        Ok(png)
    });
    let png = png.await?;
    Ok((png, white_header(white.await.unwrap_or_default())))
}

/// The header with the value of white.
fn white_header(white: f32) -> HeaderMap {
    let mut headers = HeaderMap::new();
    // Digits are valid header characters.
    if let Ok(white) = HeaderValue::from_str(&white.to_string()) {
        headers.insert(HeaderName::from_static("lfpiv-white"), white);
    }
    headers
}

impl Grey {
    /// Reduces an image to at most `columns` columns; each pixel is the mean over its area.
    pub fn of(image: &RawImage, columns: usize) -> Self {
        let columns = columns.clamp(1, image.columns().max(1));
        let scale = image.columns() as f64 / columns as f64;
        let rows = ((image.rows() as f64 / scale).round() as usize).max(1);
        let step = image.rows() as f64 / rows as f64;
        let mut sums = vec![0.0f64; columns * rows];
        let (mut integral, mut narrow) = (vec![0.0; image.columns() + 1], vec![0.0; columns]);
        for row in 0..image.rows() {
            narrow_row(image.row(row), scale, &mut integral, &mut narrow);
            let (top, bottom) = (row as f64 / step, (row + 1) as f64 / step);
            for target in top as usize..(bottom.ceil() as usize).min(rows) {
                let share = bottom.min((target + 1) as f64) - top.max(target as f64);
                let sums = &mut sums[target * columns..(target + 1) * columns];
                for (sum, value) in sums.iter_mut().zip(&narrow) {
                    *sum += share * value;
                }
            }
        }
        Self { columns, rows, values: sums.into_iter().map(|sum| sum as f32).collect() }
    }

    /// Scales the values so that white is the 99.9th percentile.
    pub fn preview(&self) -> Result<Preview, ApiError> {
        let white = percentile(&self.values, WHITE_PERCENTILE);
        let factor = if white > 0.0 { 255.0 / white } else { 0.0 };
        let pixels: Vec<u8> =
            self.values.iter().map(|value| (value * factor).round() as u8).collect();
        let mut png = Vec::new();
        PngEncoder::new(&mut png)
            .write_image(&pixels, self.columns as u32, self.rows as u32, ExtendedColorType::L8)
            .map_err(|error| ApiError::internal(format!("no PNG can be made: {error}")))?;
        Ok(Preview { png, white })
    }
}

/// Means over `scale` pixels each, computed from the integral along the row.
fn narrow_row(row: &[u16], scale: f64, integral: &mut [f64], narrow: &mut [f64]) {
    for (n, &count) in row.iter().enumerate() {
        integral[n + 1] = integral[n] + f64::from(count);
    }
    let up_to = |at: f64| {
        let whole = (at as usize).min(row.len());
        let rest = row.get(whole).map_or(0.0, |&count| (at - whole as f64) * f64::from(count));
        integral[whole] + rest
    };
    for (n, mean) in narrow.iter_mut().enumerate() {
        *mean = (up_to((n + 1) as f64 * scale) - up_to(n as f64 * scale)) / scale;
    }
}

fn percentile(values: &[f32], share: f64) -> f32 {
    if values.is_empty() {
        return 0.0;
    }
    let mut values = values.to_vec();
    let at = (((values.len() - 1) as f64) * share).round() as usize;
    *values.select_nth_unstable_by(at, f32::total_cmp).1
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn image(columns: usize, rows: usize, count: impl Fn(usize) -> u16) -> RawImage {
        RawImage::new(columns, rows, (0..columns * rows).map(count).collect()).unwrap()
    }

    #[test]
    fn half_the_width_is_the_mean_of_four_pixels() {
        let grey = Grey::of(&image(4, 2, |n| n as u16), 2);
        assert_eq!((grey.columns, grey.rows), (2, 1));
        assert_eq!(grey.values, [2.5, 4.5]);
    }

    #[test]
    fn a_preview_is_a_png_with_its_white_value() {
        let grey = Grey::of(&image(40, 50, |n| if n < 20 { 4000 } else { 100 }), 1000);
        assert_eq!((grey.columns, grey.rows), (40, 50));
        let preview = grey.preview().unwrap();
        assert_eq!(preview.white, 4000.0);
        let read = image::load_from_memory(&preview.png).unwrap().into_luma8();
        assert_eq!((read.dimensions(), read.as_raw()[0]), ((40, 50), 255));
        assert_eq!(read.as_raw()[1999], (255.0 / 40.0) as u8);
    }

    #[test]
    fn a_dark_image_is_black() {
        let preview = Grey::of(&image(3, 3, |_| 0), 3).preview().unwrap();
        assert_eq!(preview.white, 0.0);
        assert!(
            image::load_from_memory(&preview.png).unwrap().into_luma8().iter().all(|p| *p == 0)
        );
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(64))]
        #[test]
        fn the_mean_is_kept(columns in 1usize..30, rows in 1usize..30, width in 1usize..40, seed: u16) {
            let image = image(columns, rows, |n| (n as u16).wrapping_mul(seed | 1));
            let mean = |values: &mut dyn Iterator<Item = f64>, count: usize| {
                values.sum::<f64>() / count as f64
            };
            let whole = mean(&mut image.counts().iter().map(|&c| f64::from(c)), columns * rows);
            let grey = Grey::of(&image, width);
            let made = mean(&mut grey.values.iter().map(|&v| f64::from(v)), grey.values.len());
            prop_assert!((made - whole).abs() <= 1e-3 * whole.max(1.0), "{made} {whole}");
        }
    }
}
