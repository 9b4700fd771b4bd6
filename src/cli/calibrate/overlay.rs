//! Figures of a grid: SVG with embedded PNG pixels.

use std::fmt::Write;

use image::{ExtendedColorType, ImageEncoder, codecs::png::PngEncoder};
use lfpiv_core::calibration::{GridCalibration, Lens, LensState, WhiteImage};

/// Edge of a displayed part of the image, in micro-images.
const PIECE_PITCHES: f64 = 6.0;

/// Edge of the figure, in CSS pixels.
const PIECE_EDGE: f64 = 420.0;

/// Largest number of arrows along the longer side of the residual map.
const ARROWS: usize = 24;

/// A part of the white image with the fitted centres and circles: orange for the stop, blue for the
/// second aperture. `at` is the part's relative position, from 0 to 1 along each axis.
pub fn piece(image: &WhiteImage, found: &GridCalibration, at: [f64; 2]) -> String {
    let size = [image.columns(), image.rows()];
    let pitch = found.grid.pitch_px()[0];
    let edge = ((PIECE_PITCHES * pitch) as usize).clamp(16, size[0].min(size[1]));
    let first = [0, 1].map(|axis| ((size[axis] - edge) as f64 * at[axis]) as usize);
    let counts = |n: usize| image.at(first[0] + n % edge, first[1] + n / edge);
    let brightest = (0..edge * edge).map(counts).fold(1.0, f64::max);
    let grey = (0..edge * edge).map(|n| (255.0 * counts(n).max(0.0) / brightest) as u8).collect();
    let mut svg = format!(
        "<svg viewBox=\"-0.5 -0.5 {edge} {edge}\" width=\"{PIECE_EDGE}\" \
         height=\"{PIECE_EDGE}\">{}",
        picture(grey, [edge, edge], ExtendedColorType::L8)
    );
    let [nx, _] = found.grid.microlenses;
    for (n, lens) in found.lenses.iter().enumerate() {
        let on_sensor = found.grid.centre_px((n % nx) as f64, (n / nx) as f64);
        let [x, y] = [0, 1].map(|axis| on_sensor[axis] - first[axis] as f64);
        let reach = found.radius_px + 1.0;
        if [x, y].iter().any(|place| *place < -reach || *place > edge as f64 + reach) {
            continue;
        }
        let dashed = if lens.state == LensState::Valid { "" } else { " stroke-dasharray=\"0.8\"" };
        // Writing to a String does not fail.
        let _ = write!(
            svg,
            "<circle class=\"stop\" cx=\"{x:.3}\" cy=\"{y:.3}\" r=\"{:.3}\"{dashed}/>\
             <path class=\"stop\" d=\"M{:.3} {y:.3}h1.2M{x:.3} {:.3}v1.2\"/>",
            found.radius_px,
            x - 0.6,
            y - 0.6
        );
        if let Some([cx, cy, r]) = found.second_circle_px(on_sensor)
            && lens.open_share < 0.999
        {
            let _ = write!(
                svg,
                "<circle class=\"second\" cx=\"{:.3}\" cy=\"{:.3}\" r=\"{r:.3}\"/>",
                cx - first[0] as f64,
                cy - first[1] as f64
            );
        }
    }
    svg + "</svg>"
}

/// Mean residuals of blocks of lenses as arrows, with the length of the longest one.
pub fn residuals(found: &GridCalibration) -> String {
    let [nx, ny] = found.grid.microlenses;
    let block = nx.max(ny).div_ceil(ARROWS).max(1);
    let (columns, rows) = (nx.div_ceil(block), ny.div_ceil(block));
    let mut sums = vec![[0.0; 3]; columns * rows];
    for (n, lens) in found.lenses.iter().enumerate() {
        let (Some([x, y]), LensState::Valid) = (lens.residual_px, lens.state) else { continue };
        let sum = &mut sums[n / nx / block * columns + n % nx / block];
        *sum = [sum[0] + x, sum[1] + y, sum[2] + 1.0];
    }
    let means: Vec<Option<[f64; 2]>> =
        sums.iter().map(|[x, y, n]| (*n > 0.0).then(|| [x / n, y / n])).collect();
    let longest = means.iter().flatten().map(|[x, y]| x.hypot(*y)).fold(1e-6, f64::max);
    let mut svg = format!(
        "<svg class=\"map\" viewBox=\"-1 -1 {} {}\" width=\"{PIECE_EDGE}\" height=\"{:.0}\">",
        columns + 1,
        rows + 1,
        PIECE_EDGE * (rows + 1) as f64 / (columns + 1) as f64
    );
    for (n, mean) in means.iter().enumerate() {
        let Some([x, y]) = mean else { continue };
        // The longest arrow is a block long; j counts upwards.
        let (from_x, from_y) = (n % columns, rows - 1 - n / columns);
        let _ = write!(
            svg,
            "<circle cx=\"{from_x}\" cy=\"{from_y}\" r=\"0.07\"/><path class=\"arrow\" \
             d=\"M{from_x} {from_y}l{:.3} {:.3}\"/>",
            x / longest,
            y / longest
        );
    }
    svg + &format!("</svg><p>Longest arrow: {longest:.3} px, mean of {block} x {block} lenses.</p>")
}

/// A quantity of each lens in grey (1 is white); unusable lenses are coloured.
pub fn map(found: &GridCalibration, value: impl Fn(&Lens) -> f64) -> String {
    let [nx, ny] = found.grid.microlenses;
    let colour = |n: usize| {
        let lens = &found.lenses[(ny - 1 - n / nx) * nx + n % nx];
        let grey = (255.0 * value(lens).clamp(0.0, 1.0)) as u8;
        match lens.state {
            LensState::Valid => [grey; 3],
            LensState::PartlyImaged => [70, 90, 130],
            LensState::Dark => [200, 40, 40],
            LensState::Disturbed => [240, 170, 40],
        }
    };
    let pixels = (0..nx * ny).flat_map(colour).collect();
    format!(
        "<svg class=\"map\" viewBox=\"-0.5 -0.5 {nx} {ny}\" width=\"{PIECE_EDGE}\" \
         height=\"{:.0}\">{}</svg>",
        PIECE_EDGE * ny as f64 / nx.max(1) as f64,
        picture(pixels, [nx, ny], ExtendedColorType::Rgb8)
    )
}

/// An image element of the pixels in their original size; empty if they cannot be encoded.
pub(super) fn picture(
    pixels: Vec<u8>,
    [columns, rows]: [usize; 2],
    colour: ExtendedColorType,
) -> String {
    let mut png = Vec::new();
    let encoder = PngEncoder::new(&mut png);
    if encoder.write_image(&pixels, columns as u32, rows as u32, colour).is_err() {
        return String::new();
    }
    format!(
        "<image x=\"-0.5\" y=\"-0.5\" width=\"{columns}\" height=\"{rows}\" \
         href=\"data:image/png;base64,{}\"/>",
        base64(&png)
    )
}

/// Base 64 by RFC 4648, section 4.
fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        let mut bits = [0; 4];
        bits[1..=three.len()].copy_from_slice(three);
        let bits = u32::from_be_bytes(bits);
        for place in 0..4 {
            let digit = DIGITS[(bits >> (18 - 6 * place) & 63) as usize];
            text.push(if place > three.len() { '=' } else { char::from(digit) });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::base64;

    #[test]
    fn base64_matches_the_rfc() {
        for (bytes, text) in
            [("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foobar", "Zm9vYmFy")]
        {
            assert_eq!(base64(bytes.as_bytes()), text);
        }
    }
}
