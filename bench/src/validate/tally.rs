//! What an instrument has measured so far, beside what was there.

use lfpiv_core::{
    ensemble::{Ensemble, Estimates, Quantity, Sample, Snapshot},
    velocimetry::{VectorGrid, VelocityField},
};
use lfpiv_sim::{Flow, flow::RoundJet};
use rayon::prelude::*;

use super::{
    Difference, Instrument, Profile, ProfilePoint, Region,
    comparison::{Slices, root_mean_square},
    line::Line,
};

/// The streamwise component.
const ALONG: usize = 1;

/// Measured and true statistics of an instrument's places.
pub(super) struct Tally {
    jet: RoundJet,
    measured: Ensemble,
    truth: Ensemble,
    lines: Vec<LineTally>,
    valid_shares: f64,
    has_depth: bool,
}

struct LineTally {
    line: Line,
    measured: Ensemble,
    truth: Ensemble,
}

impl Tally {
    /// Nothing yet, on the places of `grid`; with a profile along z where it `has_depth`.
    pub fn new(grid: VectorGrid, region: &Region, jet: &RoundJet, has_depth: bool) -> Self {
        let axes: &[usize] = if has_depth { &[0, 2] } else { &[0] };
        let lines = axes.iter().map(|&axis| {
            let line = Line::through(&grid, axis, region);
            let [measured, truth] = [(); 2].map(|()| Ensemble::new(line.grid.clone()));
            LineTally { line, measured, truth }
        });
        Self {
            jet: jet.clone(),
            lines: lines.collect(),
            measured: Ensemble::new(grid.clone()),
            truth: Ensemble::new(grid),
            valid_shares: 0.0,
            has_depth,
        }
    }

    /// Adds a shot: what was measured, and the flow of the shot.
    pub fn add(&mut self, shot: u64, field: &VelocityField, flow: &Flow) {
        let measured = Snapshot::of_field(shot, field);
        let grid = self.truth.grid();
        let samples = (0..grid.len())
            .into_par_iter()
            .map(|n| {
                let velocity_m_s = flow.velocity_m_s(grid.position_mm(n));
                Some(Sample { velocity_m_s, uncertainty_m_s: [0.0; 3] })
            })
            .collect();
        let truth = Snapshot { shot, samples };
        for line in &mut self.lines {
            line.measured.add(&line.line.averaged(&measured));
            line.truth.add(&line.line.averaged(&truth));
        }
        self.measured.add(&measured);
        self.truth.add(&truth);
        self.valid_shares += field.valid_share();
    }

    /// What came out; name, dt and windows are to be filled in.
    pub fn instrument(&self) -> Instrument {
        let (measured, truth) = (self.measured.estimates(), self.truth.estimates());
        let profiles =
            self.lines.iter().map(|line| self.profile(line, &measured, &truth)).collect();
        Instrument {
            name: String::new(),
            dt_us: 0.0,
            window_mm: 0.0,
            valid_share: self.valid_shares / (self.measured.shots() as f64).max(1.0),
            profiles,
            volume: self.has_depth.then(|| self.over_all_places(&measured, &truth)),
            slices: Slices::of(self.measured.grid(), |n| {
                measured.of(Quantity::Mean(ALONG))[n].map(|estimate| estimate.value)
            }),
        }
    }

    fn profile(&self, line: &LineTally, measured: &Estimates, truth: &Estimates) -> Profile {
        let grid = self.measured.grid();
        let stress = Quantity::Stress(ALONG, ALONG);
        let of_line = [&line.measured, &line.truth].map(Ensemble::estimates);
        let [means, true_means] = of_line.each_ref().map(|all| all.of(Quantity::Mean(ALONG)));
        let point = |place: usize, place_mm: f64| {
            let at = |n: usize| grid.position_mm(n);
            let mean_of = |of: &dyn Fn(usize) -> Option<f64>| line.line.mean_of(place, of);
            let rms = |estimates: &Estimates| {
                let variance = mean_of(&|n| estimates.of(stress)[n].map(|e| e.value));
                variance.map(|variance| variance.max(0.0).sqrt())
            };
            let variance = mean_of(&|n| Some(self.jet.rms_m_s(at(n))[ALONG].powi(2)));
            ProfilePoint {
                place_mm,
                place_over_d: (place_mm - self.jet.outlet_mm[line.line.axis])
                    / self.jet.diameter_mm,
                true_mean_m_s: mean_of(&|n| Some(self.jet.mean_m_s(at(n))[ALONG])).unwrap_or(0.0),
                true_rms_m_s: variance.unwrap_or(0.0).sqrt(),
                shots_mean_m_s: true_means[place].map(|e| e.value),
                shots_rms_m_s: rms(truth),
                mean_m_s: means[place].map(|e| e.value),
                mean_interval_95_m_s: means[place].map(|e| e.interval_95),
                rms_m_s: rms(measured),
            }
        };
        let places = line.line.grid.axis_mm(line.line.axis);
        let points = places.iter().enumerate().map(|(n, place_mm)| point(n, *place_mm)).collect();
        Profile { axis: ["x", "y", "z"][line.line.axis].to_owned(), points }
    }

    fn over_all_places(&self, measured: &Estimates, truth: &Estimates) -> Vec<Difference> {
        let grid = self.measured.grid();
        let of_component = |c: usize| {
            let (mean, stress) = (Quantity::Mean(c), Quantity::Stress(c, c));
            let over = |expected: &dyn Fn(usize) -> Option<f64>,
                        found: &dyn Fn(usize) -> Option<f64>| {
                root_mean_square((0..grid.len()).filter_map(|n| Some(found(n)? - expected(n)?)))
            };
            let value = |estimates: &Estimates, quantity: Quantity, n: usize| {
                estimates.of(quantity)[n].map(|estimate| estimate.value)
            };
            let root = |variance: Option<f64>| variance.map(|variance| variance.max(0.0).sqrt());
            let found_mean = |n: usize| value(measured, mean, n);
            let found_rms = |n: usize| root(value(measured, stress, n));
            Difference {
                component: ["u", "v", "w"][c].to_owned(),
                mean_m_s: over(&|n| Some(self.jet.mean_m_s(grid.position_mm(n))[c]), &found_mean),
                rms_m_s: over(&|n| Some(self.jet.rms_m_s(grid.position_mm(n))[c]), &found_rms),
                mean_from_shots_m_s: over(&|n| value(truth, mean, n), &found_mean),
                rms_from_shots_m_s: over(&|n| root(value(truth, stress, n)), &found_rms),
            }
        };
        (0..3).map(of_component).collect()
    }
}
