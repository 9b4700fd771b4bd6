//! Optional parts of the forward model, and their effects on the light.

use lfpiv_hw::Optics;
use serde::{Deserialize, Serialize};

use super::footprint::RayMap;
use crate::lightfield::{ApertureEdge, GridSampling, MicrolensWindow, ViewLayout};

/// The parts of a forward model. The default is suitable for every scene.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct ModelParts {
    /// Finite pupil intervals of pixels, which give finite shadows of points out of focus. Without it the
    /// interval of every pixel is a point.
    pub pupil_blur: bool,
    /// Views that are cut by the aperture's edge, with the open share of each pixel. Without it these views are
    /// left out.
    pub aperture_coverage: bool,
    /// Diffraction at the main lens and at the microlenses, for light of this wavelength in nm.
    pub diffraction_nm: Option<f64>,
    /// No corrections for light within the noise (β of OS-MART).
    pub noise_weighting: bool,
}

impl Default for ModelParts {
    fn default() -> Self {
        Self {
            pupil_blur: true,
            aperture_coverage: true,
            diffraction_nm: None,
            noise_weighting: true,
        }
    }
}

/// Blur of a point's shadow on the microlens plane, as full widths of uniform distributions.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Blur {
    /// Width of a pixel's pupil interval, in mm. The width on the plane is |a| times this.
    pub pupil_mm: f64,
    /// Width on the microlens plane itself, in mm, the same at every depth.
    pub plane_mm: f64,
}

/// Depths over which widths are averaged.
const DEPTHS: usize = 32;

/// A uniform distribution of this full width has a variance of 1.
const WIDTH_OF_UNIT_VARIANCE: f64 = 3.464_101_615_137_754_6;

/// Standard deviation of the Gaussian that fits the core of an Airy pattern best, over wavelength times
/// f-number (Zhang, Zerubia and Olivo-Marin, Applied Optics 46, 2007).
pub const AIRY_SIGMA: f64 = 0.42;

impl Blur {
    /// Blur due to diffraction: the main lens' Airy pattern on the microlens plane at its working f-number
    /// s_i/D, and the microlens' pattern on the sensor at f_m/p_m. A spot of width w on the sensor widens a
    /// pixel's pupil interval by w s_i/f_m.
    pub fn of_diffraction(optics: &Optics, wavelength_nm: f64) -> Self {
        let width_mm =
            |f_number: f64| WIDTH_OF_UNIT_VARIANCE * AIRY_SIGMA * wavelength_nm * 1e-6 * f_number;
        let lens = &optics.microlens;
        let pupil_per_sensor = optics.image_distance_mm() / lens.focal_length_mm;
        Self {
            pupil_mm: width_mm(lens.focal_length_mm / lens.pitch_mm) * pupil_per_sensor,
            plane_mm: width_mm(optics.image_distance_mm() / optics.pupil_diameter_mm()),
        }
    }
}

impl Blur {
    /// Width of a point's shadow in object space, in mm, rms over evenly spaced depths between two coordinates
    /// along a camera's axis.
    pub fn rms_width_mm(&self, optics: &Optics, depth_mm: [f64; 2]) -> f64 {
        let [low, high] = depth_mm;
        let square = |n: usize| {
            let share = (n as f64 + 0.5) / DEPTHS as f64;
            let map = RayMap::at_depth(optics, low + share * (high - low));
            let on_plane = (map.pupil * self.pupil_mm).hypot(self.plane_mm);
            (on_plane / map.position).powi(2)
        };
        ((0..DEPTHS).map(square).sum::<f64>() / DEPTHS as f64).sqrt()
    }
}

impl ModelParts {
    /// Blur of shadows in this model.
    pub fn blur(&self, optics: &Optics) -> Blur {
        let cell_mm = if self.pupil_blur { optics.pupil_cell_mm() } else { 0.0 };
        let diffraction = self.diffraction(optics);
        Blur { pupil_mm: cell_mm.hypot(diffraction.pupil_mm), ..diffraction }
    }

    fn diffraction(&self, optics: &Optics) -> Blur {
        self.diffraction_nm.map_or_else(Blur::default, |nm| Blur::of_diffraction(optics, nm))
    }

    /// The layout of a camera's views in this model, for the microlenses of `window`.
    pub(super) fn layout(&self, optics: &Optics, window: &MicrolensWindow) -> ViewLayout {
        ViewLayout::with_edge(optics, window.clone(), self.edge(optics))
    }

    /// As [`Self::layout`], for an arbitrarily oriented array.
    pub(super) fn layout_on_grid(
        &self,
        optics: &Optics,
        window: &MicrolensWindow,
        sampling: &GridSampling,
    ) -> ViewLayout {
        ViewLayout::on_grid(optics, window.clone(), self.edge(optics), sampling.clone())
    }

    fn edge(&self, optics: &Optics) -> ApertureEdge {
        ApertureEdge {
            partly_open_views: self.aperture_coverage,
            interval_mm: optics.pupil_cell_mm().hypot(self.diffraction(optics).pupil_mm),
        }
    }

    /// The layouts of all cameras, for their `windows` of microlenses. Layouts of equal windows are computed
    /// once, or taken from the `known` layouts of a model with the same optics and parts.
    pub(super) fn layouts<'a>(
        &self,
        optics: &Optics,
        windows: impl Iterator<Item = &'a MicrolensWindow>,
        known: &[ViewLayout],
    ) -> Vec<ViewLayout> {
        let mut layouts: Vec<ViewLayout> = Vec::new();
        for window in windows {
            let mut before = known.iter().chain(&layouts);
            let layout = match before.find(|layout| layout.window == *window) {
                Some(layout) => layout.clone(),
                None => self.layout(optics, window),
            };
            layouts.push(layout);
        }
        layouts
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::test_bench;

    #[test]
    fn diffraction_is_a_few_micrometres_and_a_pupil_cell() {
        let blur = Blur::of_diffraction(&test_bench::optics(), 532.0);
        // f/8 twice: sigma 0.42 * 0.532 um * 8 = 1.79 um, on the pupil 250 times that.
        assert!((blur.plane_mm - 3.4641 * 1.788e-3).abs() < 1e-5, "{blur:?}");
        assert!((blur.pupil_mm - 250.0 * blur.plane_mm).abs() < 1e-9);
    }

    #[test]
    fn parts_widen_the_shadow_independently() {
        let optics = test_bench::optics();
        let blur = |pupil_blur, diffraction_nm| {
            ModelParts { pupil_blur, diffraction_nm, ..ModelParts::default() }.blur(&optics)
        };
        assert_eq!(blur(false, None), Blur::default());
        assert_eq!(blur(true, None), Blur { pupil_mm: optics.pupil_cell_mm(), plane_mm: 0.0 });
        let airy = blur(false, Some(532.0));
        let both = blur(true, Some(532.0));
        assert!((both.pupil_mm - airy.pupil_mm.hypot(1.375)).abs() < 1e-12);
        assert_eq!(both.plane_mm, airy.plane_mm);
    }
}
