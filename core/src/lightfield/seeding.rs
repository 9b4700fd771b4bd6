//! Seeding density from the statistics of views.

use super::{ViewLayout, ViewStack};

/// Seeding density and brightness of particles in one camera's views.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seeding {
    /// Particles per microlens in the middle of the volume's image (ppm in the paper).
    pub ppm: f64,
    /// Light of one particle in a fully open view, in counts; the light-weighted mean over the
    /// particles.
    pub particle_counts: f64,
}

impl Seeding {
    /// Number and brightness from mean m and variance σ² of the pixels (Digman et al., Biophysical Journal 94,
    /// 2008). For a Poisson distribution with mean n of particles with the light E, m = n E and σ² = n E² + noise².
    /// Therefore E = (σ² − noise²)/m and n = m/E, for any overlap of particles. The pixels are from fully open
    /// views, in the middle half of the window along each axis, where every pixel images the whole depth of the
    /// volume.
    ///
    /// `None` if the light is not above the noise, or no view is fully open.
    pub fn of(views: &ViewStack, layout: &ViewLayout, noise_counts: f64) -> Option<Self> {
        let [columns, rows] = [layout.window.columns.len(), layout.window.rows.len()];
        let middle = |n: usize| n / 4..(n - n / 4);
        let (mut pixels, mut sum, mut squares) = (0.0, 0.0, 0.0);
        for (n, view) in layout.views.iter().enumerate().filter(|(_, view)| !view.is_cut()) {
            for row in middle(rows) {
                for at in middle(columns).map(|column| row * columns + column) {
                    // Skip microlenses without a pixel for this view.
                    if view.coverage.as_ref().is_none_or(|coverage| coverage[at] > 0.0) {
                        let value = f64::from(views.view(n)[at]);
                        pixels += 1.0;
                        sum += value;
                        squares += value * value;
                    }
                }
            }
        }
        let mean = sum / pixels;
        let variance = squares / pixels - mean * mean - noise_counts * noise_counts;
        let stands_out = pixels > 0.0 && mean > 0.0 && variance > mean * noise_counts;
        let particle_counts = variance / mean;
        stands_out.then(|| Self { ppm: mean / particle_counts, particle_counts })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        lightfield::{ApertureEdge, MicrolensWindow},
        test_bench,
    };
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64Mcg;

    fn layout() -> ViewLayout {
        let optics = test_bench::optics();
        let edge = ApertureEdge { partly_open_views: false, ..ApertureEdge::sharp(&optics) };
        ViewLayout::with_edge(&optics, MicrolensWindow { columns: 40..90, rows: 30..60 }, edge)
    }

    /// Views with random particles of 300 counts, `ppm` per pixel, and noise of ±5.
    fn views(layout: &ViewLayout, ppm: f64) -> ViewStack {
        let mut random = Pcg64Mcg::seed_from_u64(3);
        let pixels = layout.window.len() * layout.views.len();
        let noise = |n: usize| if n.is_multiple_of(2) { 5.0 } else { -5.0 };
        let mut values: Vec<f32> = (0..pixels).map(noise).collect();
        for _ in 0..(ppm * pixels as f64) as usize {
            values[random.random_range(0..pixels)] += 300.0;
        }
        ViewStack::new(layout.window.len(), values)
    }

    #[test]
    fn overlapping_particles_are_counted() {
        let layout = layout();
        for ppm in [0.03, 0.3, 1.0, 3.0] {
            let found = Seeding::of(&views(&layout, ppm), &layout, 5.0).unwrap();
            assert!((found.ppm / ppm - 1.0).abs() < 0.03, "{ppm}: {found:?}");
            assert!((found.particle_counts / 300.0 - 1.0).abs() < 0.03, "{ppm}: {found:?}");
        }
    }

    #[test]
    fn noise_and_darkness_are_no_particles() {
        let layout = layout();
        assert_eq!(Seeding::of(&views(&layout, 0.0), &layout, 5.0), None);
        let black = ViewStack::new(
            layout.window.len(),
            vec![0.0; layout.window.len() * layout.views.len()],
        );
        assert_eq!(Seeding::of(&black, &layout, 0.3), None);
    }
}
