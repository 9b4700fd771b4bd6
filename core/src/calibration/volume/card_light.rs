//! Images of the card, with the ray of each pixel: its place on the microlens plane and its position on the pupil.

use lfpiv_hw::Optics;

use crate::{calibration::WhiteImage, lightfield::MicroImageGrid};

/// Least light of a used pixel in the white image, relative to the brightest pixel of its microlens. Darker pixels
/// are crossed by the pupil's rim, and the centre of their light is not the centre of the pixel.
const FULLY_LIT: f32 = 0.85;

/// Image of the card by one camera, relative to the white image.
#[derive(Debug, Clone)]
pub struct CardLight<'a> {
    optics: &'a Optics,
    grid: &'a MicroImageGrid,
    columns: usize,
    rows: usize,
    /// Light of each pixel relative to the white image; NaN for unusable pixels.
    share: Vec<f32>,
    /// Half width of a micro-image, in pixels.
    reach_px: usize,
    /// Median number of usable pixels per microlens.
    pixels_per_lens: usize,
}

/// A usable pixel of a microlens.
#[derive(Debug, Clone, Copy)]
pub(super) struct LitPixel {
    /// Index of the pixel in the image, row by row.
    pub(super) number: usize,
    /// Light relative to the white image.
    pub(super) share: f32,
    /// Indices of the microlens.
    pub(super) lens: [f64; 2],
    /// Offset of the pixel from the micro-image's centre along `right` and `up`, in mm.
    pub(super) offset_mm: [f64; 2],
}

impl<'a> CardLight<'a> {
    /// Divides the image of a card by the white image. Both have no black level and the same size.
    pub fn new(
        optics: &'a Optics,
        grid: &'a MicroImageGrid,
        white: &WhiteImage,
        card: &WhiteImage,
    ) -> Self {
        let (columns, rows) = (white.columns(), white.rows());
        let [along_i, along_j] = grid.pitch_px();
        let reach_px = (along_i.min(along_j) / 2.0).floor() as usize;
        let mut light = Self {
            optics,
            grid,
            columns,
            rows,
            share: vec![f32::NAN; columns * rows],
            reach_px,
            pixels_per_lens: 0,
        };
        let mut counts = Vec::with_capacity(grid.microlenses[0] * grid.microlenses[1]);
        for j in 0..grid.microlenses[1] {
            for i in 0..grid.microlenses[0] {
                let pixels: Vec<usize> = light.pixels_of(i, j).collect();
                let lit = |&pixel: &usize| white.light()[pixel];
                let brightest = pixels.iter().map(lit).fold(0.0, f32::max);
                let mut count = 0;
                for pixel in pixels {
                    if brightest > 0.0 && white.light()[pixel] >= FULLY_LIT * brightest {
                        light.share[pixel] = card.light()[pixel] / white.light()[pixel];
                        count += 1;
                    }
                }
                counts.push(count);
            }
        }
        counts.sort_unstable();
        light.pixels_per_lens = counts.get(counts.len() / 2).copied().unwrap_or(0);
        light
    }

    /// Indices of the pixels in the square around the centre of a micro-image.
    fn pixels_of(&self, i: usize, j: usize) -> impl Iterator<Item = usize> + use<'_> {
        let centre = self.grid.centre_px(i as f64, j as f64).map(f64::round);
        let reach = self.reach_px as i64;
        let line = move |at: f64, pixels: usize| {
            (at as i64 - reach).max(0)..(at as i64 + reach + 1).min(pixels as i64)
        };
        let columns = line(centre[0], self.columns);
        line(centre[1], self.rows).flat_map(move |row| {
            columns.clone().map(move |column| row as usize * self.columns + column as usize)
        })
    }

    /// The usable pixels of a microlens.
    pub(super) fn lit_pixels(
        &self,
        i: usize,
        j: usize,
    ) -> impl Iterator<Item = LitPixel> + use<'_> {
        let [column_px, row_px] = self.grid.centre_px(i as f64, j as f64);
        let pitch_mm = self.optics.pixel_pitch_mm();
        self.pixels_of(i, j).filter_map(move |number| {
            let share = self.share[number];
            let offset_mm = [
                ((number % self.columns) as f64 - column_px) * pitch_mm,
                (row_px - (number / self.columns) as f64) * pitch_mm,
            ];
            share.is_finite().then_some(LitPixel {
                number,
                share,
                lens: [i as f64, j as f64],
                offset_mm,
            })
        })
    }

    /// Median number of usable pixels per microlens.
    pub(super) fn pixels_per_lens(&self) -> f64 {
        self.pixels_per_lens as f64
    }

    /// Number of microlenses along both axes.
    pub fn microlenses(&self) -> [usize; 2] {
        self.grid.microlenses
    }

    /// Place of a lens on the microlens plane, in mm along `right` and `up`, for a nominal camera with the same
    /// micro-images.
    pub(super) fn place_mm(&self, lens: [f64; 2]) -> [f64; 2] {
        let [column_px, row_px] = self.grid.centre_px(lens[0], lens[1]);
        let scale = self.optics.pixel_pitch_mm() / self.optics.micro_image_magnification();
        [
            (column_px - (self.columns as f64 - 1.0) / 2.0) * scale,
            ((self.rows as f64 - 1.0) / 2.0 - row_px) * scale,
        ]
    }

    /// Fractional microlens indices of a place on the microlens plane: the inverse of [`Self::place_mm`].
    pub(super) fn lens_at(&self, place_mm: [f64; 2]) -> [f64; 2] {
        let scale = self.optics.pixel_pitch_mm() / self.optics.micro_image_magnification();
        self.grid.lens_at(
            place_mm[0] / scale + (self.columns as f64 - 1.0) / 2.0,
            (self.rows as f64 - 1.0) / 2.0 - place_mm[1] / scale,
        )
    }

    /// Position on the nominal pupil of a ray, in mm: U = δ − w s_i/f_m (docs/theory.md, section 3). δ is the ray's
    /// offset from the centre of its microlens (`lens_offset_mm`), w that from the centre of the micro-image on the
    /// sensor (`pixel_offset_mm`). A microlens does not deflect rays through its centre and focuses parallel rays.
    pub(super) fn pupil_mm(&self, lens_offset_mm: [f64; 2], pixel_offset_mm: [f64; 2]) -> [f64; 2] {
        let per_mm = self.optics.image_distance_mm() / self.optics.microlens.focal_length_mm;
        std::array::from_fn(|axis| lens_offset_mm[axis] - pixel_offset_mm[axis] * per_mm)
    }

    /// The nominal optics.
    pub(super) fn optics(&self) -> &Optics {
        self.optics
    }

    /// Relative light of each microlens, averaged over its pixels in the inner half of the pupil's radius, row by
    /// row; NaN without such pixels.
    pub fn middle_view(&self) -> Vec<f32> {
        let [columns, rows] = self.microlenses();
        let radius_mm = self.optics.pupil_diameter_mm() / 4.0;
        let inner = |pixel: &LitPixel| {
            let [u, v] = self.pupil_mm([0.0; 2], pixel.offset_mm);
            u.hypot(v) < radius_mm
        };
        let mean = |i: usize, j: usize| {
            let (sum, count) = self
                .lit_pixels(i, j)
                .filter(inner)
                .fold((0.0, 0u32), |(sum, count), pixel| (sum + pixel.share, count + 1));
            sum / count as f32
        };
        (0..columns * rows).map(|lens| mean(lens % columns, lens / columns)).collect()
    }
}
