//! Stiffness of the field: the penalty of third differences with the least cross-validation error
//! (Craven and Wahba, Numer. Math. 31, 1979).

use super::{
    super::conjugate_gradients::Until,
    lanes::{LANES, Lane},
};
use crate::parabola;

/// How a stiffness is searched for.
#[derive(Debug, Clone, Copy)]
pub struct Search {
    /// Stopping criterion of each field.
    pub until: Until,
    /// Number of cross-validation residuals, if there are as many samples.
    pub residuals: usize,
}

/// Cross-validation errors of one component.
#[derive(Default)]
pub struct Scores {
    /// Per penalty: minus the logarithm of the residuals' likelihood.
    pub sums: [f64; LANES],
    /// Per penalty: absolute residuals, in voxels.
    pub missed: [Vec<f64>; LANES],
}

impl Scores {
    /// Adds a residual per penalty, of Student's distribution; `variance` is the squared scale times the degrees of
    /// freedom, in voxel².
    pub fn add(&mut self, missed: [f64; LANES], variance: f64) {
        for (l, missed) in missed.into_iter().enumerate() {
            self.sums[l] += libm::log1p(missed * missed / variance);
            self.missed[l].push(missed.abs());
        }
    }
}

/// Trial penalties, one per lane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ladder {
    /// Ratio of the first penalty to the current one.
    first: f32,
    /// Ratio of successive penalties.
    ratio: f32,
}

impl Ladder {
    /// Penalties for expected third differences of `difference_vox` along each axis and successively `ratio` times
    /// smaller ones; the current penalty is 1.
    pub fn expecting(difference_vox: f32, ratio: f32) -> Self {
        Self { first: 1.0 / (3.0 * difference_vox * difference_vox), ratio: ratio * ratio }
    }

    /// Penalties around the current one.
    pub fn about(ratio: f32) -> Self {
        let ratio = ratio * ratio;
        Self { first: libm::powf(ratio, -0.5 * (LANES - 1) as f32), ratio }
    }

    /// Factor on the current penalty in each lane.
    pub fn factors(&self) -> Lane {
        std::array::from_fn(|l| self.first * self.ratio.powi(l as i32))
    }

    /// The factor at the minimum of the parabola through the least score and its neighbours, and the rung with the
    /// least score.
    pub fn best(&self, scores: &[f64; LANES]) -> (f32, usize) {
        let least = (0..LANES).fold(0, |best, l| if scores[l] < scores[best] { l } else { best });
        let mut rung = least as f32;
        if (1..LANES - 1).contains(&least) {
            let around = [scores[least - 1], scores[least], scores[least + 1]];
            rung += parabola::minimum(around) as f32;
        }
        (self.first * libm::powf(self.ratio, rung), least)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_score_lies_between_rungs() {
        let ladder = Ladder::about(2.0);
        let at = |rung: f32| ladder.first * ladder.ratio.powf(rung);
        let scores = std::array::from_fn(|l| (l as f64 - 3.3).powi(2) + 7.0);
        let (factor, rung) = ladder.best(&scores);
        assert!((factor / at(3.3) - 1.0).abs() < 1e-4 && rung == 3);
        let falling = std::array::from_fn(|l| -(l as f64));
        assert_eq!(ladder.best(&falling), (at((LANES - 1) as f32), LANES - 1));
        assert!((ladder.factors()[3] * ladder.factors()[4] - 1.0).abs() < 1e-4);
    }
}
