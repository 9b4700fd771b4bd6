//! Estimation of a camera's point blur from the images.

use rayon::prelude::*;

use super::{fit::FrameFit, image::ParticleImage, normal::Particle};
use crate::{
    model::{PointBlur, PointCamera, PointFootprint},
    parabola,
};

/// Ratio of successive trial widths.
const WIDTH_STEP: f64 = 1.4;

/// Limits of the width, as standard deviations in pixels.
const WIDTHS_PX: [f64; 2] = [0.08, 1.2];

/// Largest number of moves to a larger or smaller width.
const MAX_MOVES: usize = 6;

/// Number of particles in a part of the image: neighbours, so that most overlapping images are in the same part.
const PART: usize = 500;

/// Largest number of parts that are used. With all of them no more particles are found (docs/decisions.md).
const MOST_PARTS: usize = 5;

/// Initial width of points, in pixels.
pub const FIRST_WIDTH_PX: f64 = 0.25;

/// Blur with the same width on the sensor and, in pixels, on the microlenses: microlenses have the working f-number of
/// the main lens, so diffraction is equal on both.
pub fn blur_of_width(width_px: f64, pixel_mm: f64) -> PointBlur {
    PointBlur { plane_mm: width_px * pixel_mm, sensor_px: width_px }
}

/// The width with which camera `c`'s image leaves the least residual at the particles of `paired`, or those in some evenly
/// spread parts of the image if they are many.
///
/// Each particle has a misfit of its own, of unknown scale, so what is least is the sum of the logarithms of their
/// residuals (profile likelihood). By the sum itself few misplaced or false particles would decide, and for them a wider
/// image is always better (docs/decisions.md).
pub fn fitted_blur(
    fit: &FrameFit,
    cameras: &[PointCamera],
    c: usize,
    paired: &[usize],
) -> PointBlur {
    let before = cameras[c].blur;
    let pixel_mm = before.plane_mm / before.sensor_px;
    let order = &fit.orders[c];
    let parts = order.len().div_ceil(PART);
    let every = parts.div_ceil(MOST_PARTS).max(1);
    let used = || order.chunks(PART).step_by(every).flatten().map(|&n| n as usize);
    let particle = |n: usize| &fit.particles[n];
    let mut is_paired = vec![false; fit.particles.len()];
    paired.iter().for_each(|&n| is_paired[n] = true);
    let measured: Vec<&Particle> = used().filter(|&n| is_paired[n]).map(particle).collect();
    let used: Vec<&Particle> = used().map(particle).collect();
    let mut without = fit.images[c].clone();
    add_all(&mut without, &cameras[c], (&used, c), -1.0);
    let (mut image, mut camera) = (without.clone(), cameras[c].clone());
    let mut misfit = |log_width: f64| {
        image.copy_model(&without);
        camera.blur = blur_of_width(log_width.exp(), pixel_mm);
        add_all(&mut image, &camera, (&used, c), 1.0);
        // Pixels and weights are those of the previous width for every trial width.
        let left = |footprint: &mut PointFootprint, particle: &&Particle| {
            cameras[c].image(particle.at_mm, footprint);
            image.weighted_residual(&fit.images[c], &cameras[c], footprint)
        };
        let left: Vec<f64> = measured.par_iter().map_init(PointFootprint::default, left).collect();
        left.iter().map(|left| left.max(f64::MIN_POSITIVE).ln()).sum::<f64>()
    };
    let step = WIDTH_STEP.ln();
    let [low, high] = WIDTHS_PX.map(f64::ln);
    let mut middle = before.sensor_px.ln().clamp(low + step, high - step);
    let mut at = [-step, 0.0, step].map(|further| misfit(middle + further));
    for _ in 0..MAX_MOVES {
        if at[0] < at[1] && middle - 2.0 * step >= low {
            middle -= step;
            at = [misfit(middle - step), at[0], at[1]];
        } else if at[2] < at[1] && middle + 2.0 * step <= high {
            middle += step;
            at = [at[1], at[2], misfit(middle + step)];
        } else {
            break;
        }
    }
    blur_of_width((middle + parabola::minimum(at) * step).exp(), pixel_mm)
}

/// Adds particles to the model of camera number `c`, or removes them (`sign` −1).
fn add_all(
    image: &mut ParticleImage,
    camera: &PointCamera,
    (particles, c): (&[&Particle], usize),
    sign: f64,
) {
    let mut footprint = PointFootprint::default();
    for particle in particles {
        camera.image(particle.at_mm, &mut footprint);
        image.add(camera, &footprint, (sign * particle.light[c]) as f32);
    }
}

#[cfg(test)]
mod tests {
    use rand::SeedableRng;
    use rand_pcg::Pcg64Mcg;

    use super::*;
    use crate::particles::test_data::{VOXEL_MM, cameras, image, particles};

    #[test]
    fn misplaced_particles_do_not_widen_the_blur() {
        const WIDTH_PX: f64 = 0.2;
        let mut cameras = cameras();
        let pixel_mm = cameras[0].blur.plane_mm / cameras[0].blur.sensor_px;
        let truth = particles(&mut Pcg64Mcg::seed_from_u64(9));
        let images = cameras.iter_mut().enumerate().map(|(c, camera)| {
            camera.blur = blur_of_width(WIDTH_PX, pixel_mm);
            image(camera, c, &truth)
        });
        let mut fit = FrameFit::new(images.collect());
        cameras.iter_mut().for_each(|camera| camera.blur = blur_of_width(0.5, pixel_mm));
        fit.extend(truth.iter().enumerate().map(|(n, particle)| {
            let off = if n % 4 == 0 { 0.5 * VOXEL_MM } else { 0.0 };
            Particle { at_mm: particle.at_mm.map(|mm| mm + off), ..*particle }
        }));
        fit.render(&cameras);
        let all: Vec<usize> = (0..truth.len()).collect();
        for c in 0..cameras.len() {
            let found = fitted_blur(&fit, &cameras, c, &all).sensor_px;
            assert!((found / WIDTH_PX - 1.0).abs() < 0.2, "camera {c}: {found}");
        }
    }
}
