//! White images and their true micro-image grids.

use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::{
    ElectronImage, RayTracer,
    pupil::{LowDiscrepancy, PupilStrata},
};
use crate::stream::{Purpose, random_stream};

/// True centres of a camera's micro-images: the positions on the sensor of rays through the centres
/// of the stop and of a microlens.
///
/// Microlens (i, j) is counted in the array's own axes: i along its `right`, j along its `up`, from
/// (0, 0) in the first corner. Its micro-image is centred at column a₀ + a₁ i + a₂ j and row b₀ +
/// b₁ i + b₂ j. Pixel centres are at integers from 0; rows are counted downwards.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TrueMicroImageGrid {
    /// Number of microlenses along i and j.
    pub microlenses: [usize; 2],
    /// a₀, a₁, a₂.
    pub column_px: [f64; 3],
    /// b₀, b₁, b₂.
    pub row_px: [f64; 3],
}

impl TrueMicroImageGrid {
    /// Column and row of the centre of a microlens' micro-image, in pixels.
    pub fn centre_px(&self, i: usize, j: usize) -> [f64; 2] {
        [self.column_px, self.row_px]
            .map(|[first, along_i, along_j]| first + along_i * i as f64 + along_j * j as f64)
    }
}

impl RayTracer<'_> {
    /// The true grid of this camera's micro-images.
    pub fn micro_image_grid(&self) -> TrueMicroImageGrid {
        let centre = |lens: [f64; 2]| self.detector.micro_image_centre_px(lens);
        let (first, next_i, next_j) = (centre([0.0, 0.0]), centre([1.0, 0.0]), centre([0.0, 1.0]));
        let [column_px, row_px] = std::array::from_fn(|axis| {
            [first[axis], next_i[axis] - first[axis], next_j[axis] - first[axis]]
        });
        TrueMicroImageGrid { microlenses: self.detector.microlenses().counts(), column_px, row_px }
    }

    /// The image of a diffuser that sends the same light through every part of the stop to every
    /// part of the array, scaled so that the brightest pixel collects `brightest_electrons`.
    ///
    /// `rays` per microlens (rounded up to a square number), spread evenly over microlens and stop,
    /// pass the same stop, apertures, microlenses and pixels as those of a particle. `stream`
    /// selects the random numbers; the result is identical, bit for bit, for any number of threads.
    pub fn trace_white(
        &self,
        rays: usize,
        brightest_electrons: f64,
        stream: &[u64],
    ) -> ElectronImage {
        self.trace_lit(rays, brightest_electrons, stream, |_| |_, _| 1)
    }

    /// Like [`Self::trace_white`] for a non-uniform object. For each microlens `light_on` returns a
    /// function that gives the light, as an integer, of the ray through two positions in mm: on the
    /// microlens plane and on the stop.
    pub(super) fn trace_lit<L: Fn([f64; 2], [f64; 2]) -> u32>(
        &self,
        rays: usize,
        brightest_electrons: f64,
        stream: &[u64],
        light_on: impl Fn([usize; 2]) -> L + Sync,
    ) -> ElectronImage {
        let mut image = ElectronImage::dark(self.optics);
        // Integer sums do not depend on the order.
        let light: Vec<AtomicU32> = image.electrons().iter().map(|_| AtomicU32::new(0)).collect();
        let [columns, rows] = self.detector.microlenses().counts();
        let strata = PupilStrata::new(self.lens.stop_radius_mm, rays);
        (0..columns * rows).into_par_iter().for_each(|number| {
            let lens = [number % columns, number / columns];
            self.trace_microlens(lens, &strata, stream, &light_on(lens), |pixel, of_rays| {
                light[pixel as usize].fetch_add(of_rays, Relaxed);
            });
        });
        for (electrons, light) in image.electrons_mut().iter_mut().zip(light) {
            *electrons = light.into_inner() as f32;
        }
        self.blemishes.apply(&mut image);
        let brightest = image.electrons().iter().copied().fold(0.0, f32::max);
        if brightest > 0.0 {
            let scale = brightest_electrons as f32 / brightest;
            image.electrons_mut().iter_mut().for_each(|electrons| *electrons *= scale);
        }
        image
    }

    /// Traces a ray from every stratum of the stop to a different position on one microlens. Calls
    /// `hit` with pixels and the light of the rays that hit them; a pixel may occur several times.
    fn trace_microlens(
        &self,
        lens: [usize; 2],
        strata: &PupilStrata,
        stream: &[u64],
        light: &impl Fn([f64; 2], [f64; 2]) -> u32,
        mut hit: impl FnMut(u32, u32),
    ) {
        let number = lens.map(|index| index as u64);
        let key: Vec<u64> = stream.iter().copied().chain(number).collect();
        let mut rng = random_stream(Purpose::White, &key);
        let mut diffraction_rng = random_stream(Purpose::Diffraction, &key);
        let mut places = LowDiscrepancy::<2>::shifted(&mut rng).points();
        let mut run: Option<(u32, u32)> = None;
        strata.jittered(&mut rng, |stop_mm| {
            let [x, y] = places.next().unwrap_or_default();
            let place = [lens[0] as f64 + x - 0.5, lens[1] as f64 + y - 0.5];
            let plane_mm = self.detector.microlenses().place_mm(place);
            let Some(pixel) = self.hit(plane_mm, stop_mm, &mut diffraction_rng) else { return };
            let light = light(plane_mm, stop_mm);
            match &mut run {
                Some((last, sum)) if *last == pixel => *sum += light,
                _ => {
                    if let Some((last, sum)) = run.replace((pixel, light)) {
                        hit(last, sum);
                    }
                }
            }
        });
        if let Some((last, sum)) = run {
            hit(last, sum);
        }
    }
}
