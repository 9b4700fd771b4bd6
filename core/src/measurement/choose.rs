//! The cheapest model whose own error stays below the correlation's.
//!
//! Each part of the forward model that is left out adds an error to the displacement; the errors
//! are independent and add in squares. Of all combinations that the configuration allows, the
//! cheapest is taken whose sum stays below a share of the error that correlation alone makes
//! ([`correlation_error_vox`]); among equally cheap ones, or if none stays below, the most accurate.

use crate::{
    model::{ModelChoice, ModelMode, ModelParts, ModelSettings, Part, PartChoice, SceneMeasure},
    velocimetry::correlation_error_vox,
};

use super::combination::Combination;
use super::part_errors::{cost, errors_without};

/// The parts left out may add this share of the correlation's error: 12 % in the sum of squares.
const SHARE_OF_CORRELATION: f64 = 0.5;

/// Models that differ in time by less than this share are equally cheap: it could not be measured.
const EQUALLY_CHEAP: f64 = 0.05;

/// What the configuration leaves open.
#[derive(Debug, Clone, Copy)]
pub(super) struct Allowed<'a> {
    pub settings: &'a ModelSettings,
    /// The finest grid that the configuration asks for; 1 where the solver has no other.
    pub finest: usize,
}

impl Allowed<'_> {
    /// Without a choice: every part that is not forced as by default.
    fn configured(&self) -> Combination {
        let forced_or = |switch: crate::model::Switch, default| switch.forced().unwrap_or(default);
        let ModelSettings { pupil_blur, aperture_coverage, diffraction, noise_weighting, .. } =
            *self.settings;
        let fine = forced_or(self.settings.fine_voxels, true);
        Combination {
            pupil_blur: forced_or(pupil_blur, true),
            aperture_coverage: forced_or(aperture_coverage, true),
            diffraction: forced_or(diffraction, false),
            noise_weighting: forced_or(noise_weighting, true),
            refinement: if fine { self.finest } else { 1 },
        }
    }

    /// Every combination that the configuration allows.
    fn combinations(&self) -> Vec<Combination> {
        let either = |forced: Option<bool>| forced.map_or(vec![true, false], |on| vec![on]);
        let settings = self.settings;
        let diffraction = match settings.wavelength_nm {
            Some(_) => either(settings.diffraction.forced()),
            None => vec![false],
        };
        let refinements = match settings.fine_voxels.forced() {
            Some(true) => vec![self.finest],
            Some(false) => vec![1],
            None => [1, 2, self.finest].into_iter().filter(|&n| n <= self.finest).collect(),
        };
        let mut all = Vec::new();
        for pupil_blur in either(settings.pupil_blur.forced()) {
            for aperture_coverage in either(settings.aperture_coverage.forced()) {
                for &diffraction in &diffraction {
                    for noise_weighting in either(settings.noise_weighting.forced()) {
                        all.extend(refinements.iter().map(|&refinement| Combination {
                            pupil_blur,
                            aperture_coverage,
                            diffraction,
                            noise_weighting,
                            refinement,
                        }));
                    }
                }
            }
        }
        all
    }

    fn forced(&self, part: Part) -> bool {
        let settings = self.settings;
        let switch = match part {
            Part::PupilBlur => settings.pupil_blur,
            Part::ApertureCoverage => settings.aperture_coverage,
            Part::Diffraction => settings.diffraction,
            Part::NoiseWeighting => settings.noise_weighting,
            Part::FineVoxels => settings.fine_voxels,
        };
        switch.forced().is_some()
    }

    fn parts(&self, taken: &Combination) -> ModelParts {
        ModelParts {
            pupil_blur: taken.pupil_blur,
            aperture_coverage: taken.aperture_coverage,
            diffraction_nm: self.settings.wavelength_nm.filter(|_| taken.diffraction),
            noise_weighting: taken.noise_weighting,
        }
    }
}

/// All parts, in the order of a report.
const PARTS: [Part; 5] = [
    Part::PupilBlur,
    Part::ApertureCoverage,
    Part::Diffraction,
    Part::NoiseWeighting,
    Part::FineVoxels,
];

impl Combination {
    /// Whether this part is in.
    pub fn has(&self, part: Part) -> bool {
        match part {
            Part::PupilBlur => self.pupil_blur,
            Part::ApertureCoverage => self.aperture_coverage,
            Part::Diffraction => self.diffraction,
            Part::NoiseWeighting => self.noise_weighting,
            Part::FineVoxels => self.refinement > 1,
        }
    }

    /// The same with one part in or out; fine voxels, if in, as fine as `finest`.
    pub fn with(self, part: Part, on: bool, finest: usize) -> Self {
        match part {
            Part::PupilBlur => Self { pupil_blur: on, ..self },
            Part::ApertureCoverage => Self { aperture_coverage: on, ..self },
            Part::Diffraction => Self { diffraction: on, ..self },
            Part::NoiseWeighting => Self { noise_weighting: on, ..self },
            Part::FineVoxels => Self { refinement: if on { finest } else { 1 }, ..self },
        }
    }
}

/// The configured model, before or without a look at the scene.
pub(super) fn configured(allowed: &Allowed<'_>) -> ModelChoice {
    let taken = allowed.configured();
    let unforced = match allowed.settings.mode {
        ModelMode::Explicit => "as by default",
        ModelMode::Auto => "no particles have been seen yet",
    };
    let parts = PARTS.map(|part| {
        let forced = allowed.forced(part);
        PartChoice {
            part,
            on: taken.has(part),
            forced,
            error_without_vox: None,
            cost: None,
            reason: if forced { "forced by the configuration" } else { unforced }.to_owned(),
        }
    });
    ModelChoice {
        mode: allowed.settings.mode,
        model: allowed.parts(&taken),
        refinement: taken.refinement,
        parts: parts.into(),
        ..ModelChoice::default()
    }
}

/// The model that a scene needs.
pub(super) fn choose(scene: &SceneMeasure, allowed: &Allowed<'_>) -> ModelChoice {
    let correlation_vox = correlation_error_vox(scene.window_vox, scene.particles_per_window);
    let budget_vox = SHARE_OF_CORRELATION * correlation_vox;
    let error = |c: &Combination| model_error_vox(scene, c, allowed.finest);
    let price = |c: &Combination| cost(scene, c);
    let mut candidates = allowed.combinations();
    if candidates.iter().any(|c| error(c) <= budget_vox) {
        candidates.retain(|c| error(c) <= budget_vox);
        let cheapest = candidates.iter().map(price).fold(f64::INFINITY, f64::min);
        candidates.retain(|c| price(c) <= cheapest * (1.0 + EQUALLY_CHEAP));
    }
    let by_error = |a: &&Combination, b: &&Combination| {
        error(a).total_cmp(&error(b)).then(price(a).total_cmp(&price(b)))
    };
    let taken = candidates.iter().min_by(by_error).copied();
    let taken = taken.unwrap_or_else(|| allowed.configured());
    let comparison = Comparison { scene, allowed, taken, correlation_vox, budget_vox };
    ModelChoice {
        mode: ModelMode::Auto,
        model: allowed.parts(&taken),
        refinement: taken.refinement,
        parts: PARTS.map(|part| comparison.choice(part)).into(),
        correlation_error_vox: Some(correlation_vox),
        model_error_vox: Some(error(&taken)),
        scene: Some(*scene),
    }
}

/// What the parts that a combination lacks add to the displacement's error, in voxels.
fn model_error_vox(scene: &SceneMeasure, combination: &Combination, finest: usize) -> f64 {
    let errors = errors_without(scene, combination.refinement, finest);
    let missing = |part: &Part| *part == Part::FineVoxels || !combination.has(*part);
    let square = |part: Part| errors.of(part).powi(2);
    PARTS.into_iter().filter(missing).map(square).sum::<f64>().sqrt()
}

/// Says why a part was taken or left out.
struct Comparison<'a> {
    scene: &'a SceneMeasure,
    allowed: &'a Allowed<'a>,
    taken: Combination,
    correlation_vox: f64,
    budget_vox: f64,
}

impl Comparison<'_> {
    fn choice(&self, part: Part) -> PartChoice {
        let finest = self.allowed.finest;
        let without = self.taken.with(part, false, finest);
        let error_vox = errors_without(self.scene, without.refinement, finest).of(part);
        let with = self.taken.with(part, true, self.taken.refinement.max(2).min(finest));
        let cost = cost(self.scene, &with) / cost(self.scene, &without);
        let (on, forced) = (self.taken.has(part), self.allowed.forced(part));
        PartChoice {
            part,
            on,
            forced,
            error_without_vox: Some(error_vox),
            cost: Some(cost),
            reason: self.reason(part, on, forced, error_vox, cost),
        }
    }

    fn reason(&self, part: Part, on: bool, forced: bool, error_vox: f64, cost: f64) -> String {
        let (budget, floor) = (self.budget_vox, self.correlation_vox);
        let because = match part {
            _ if forced => "forced by the configuration".to_owned(),
            Part::Diffraction if self.allowed.settings.wavelength_nm.is_none() => {
                return "left out: [model] names no wavelength_nm".to_owned();
            }
            Part::FineVoxels if self.allowed.finest == 1 => {
                return "left out: reconstruction.refinement or the solver allows none".to_owned();
            }
            _ if on && cost <= 1.0 + EQUALLY_CHEAP => "taken: it costs next to nothing".to_owned(),
            _ if on => {
                format!("taken: without it the model would be off by more than {budget:.4} voxel")
            }
            _ => format!("left out: all that is left out adds less than {budget:.4} voxel"),
        };
        let fine = match part {
            Part::FineVoxels if on => format!(" (split by {})", self.taken.refinement),
            _ => String::new(),
        };
        format!(
            "{because}{fine}; without it {error_vox:.4} voxel are added to the correlation's \
             {floor:.4}, with it a reconstruction takes {cost:.2} times as long"
        )
    }
}

#[cfg(test)]
mod tests;
