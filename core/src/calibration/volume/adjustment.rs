//! Adjustment of the cameras' parameters to the measured marks: Levenberg-Marquardt method with Gaussian priors.

use std::ops::AddAssign;

use lfpiv_hw::{
    Optics, Pose,
    card::{Card, Wall},
};
use nalgebra::{DMatrix, DVector, Point3, Vector3};
use rayon::prelude::*;

use super::{
    VolumeError,
    camera_model::CameraModel,
    mark_fit::ObservedMark,
    parameters::{CameraParameters, DESCRIPTIONS, PARAMETERS},
};

/// Least standard deviation of a mark's place on the microlens plane, in microlenses: that on ideal images.
/// Otherwise it is estimated from the scatter of the marks, so that an inaccurate card does not distort the
/// parameters.
const LEAST_PLACE_DEVIATION: f64 = 0.003;

/// Initial standard deviation of a mark's place, in microlenses: that of poor images.
const INITIAL_PLACE_DEVIATION: f64 = 0.05;

/// Largest number of Levenberg-Marquardt steps; fifteen suffice.
const MOST_STEPS: usize = 60;

/// Relative change of the cost at convergence.
const LAST_CHANGE: f64 = 1e-6;

/// Marks with residuals larger than this many root mean squares are outliers.
const OUTLIER: f64 = 6.0;

/// Step of the forward differences, in prior standard deviations.
const STEP: f64 = 1e-4;

/// The marks in the image of one camera at one position of the card.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Observation {
    pub(super) camera: usize,
    pub(super) position: usize,
    pub(super) marks: Vec<ObservedMark>,
}

/// Constants of an adjustment.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bench<'a> {
    pub(super) optics: &'a Optics,
    pub(super) poses: &'a [Pose],
    pub(super) walls: &'a [Wall],
    pub(super) card: &'a Card,
    /// Stated positions of mark (0, 0).
    pub(super) origins_mm: &'a [Point3<f64>],
    /// Standard deviation of the card's true positions from the stated ones, along each axis, in mm; 0: the stated
    /// ones are exact.
    pub(super) stage_deviation_mm: f64,
    /// Standard deviations of a mark's place, in mm, and of its parallax slope.
    pub(super) deviations: [f64; 2],
}

/// Initial standard deviations of a mark's place, in mm, and of its parallax slope.
pub(super) fn initial_deviations(optics: &Optics) -> [f64; 2] {
    deviations(optics, INITIAL_PLACE_DEVIATION)
}

/// Standard deviations of place, in mm, and of slope, for one of `place` microlenses. The slope is measured at half
/// the pupil's radius.
fn deviations(optics: &Optics, place: f64) -> [f64; 2] {
    let place_mm = place * optics.microlens.pitch_mm;
    [place_mm, place_mm / (optics.pupil_diameter_mm() / 4.0)]
}

/// Result of an adjustment.
#[derive(Debug, Clone)]
pub(super) struct Adjusted {
    pub(super) cameras: Vec<CameraParameters>,
    /// Fitted minus stated positions of the card, in mm.
    pub(super) stage_mm: Vec<Vector3<f64>>,
    /// Posterior standard deviations of the cameras' parameters.
    pub(super) deviations: Vec<[f64; PARAMETERS]>,
    /// Condition number of the normal matrix, with unknowns in prior standard deviations.
    pub(super) condition_number: f64,
}

impl Bench<'_> {
    /// The camera with these parameters.
    pub(super) fn model(&self, camera: usize, parameters: CameraParameters) -> CameraModel {
        CameraModel::new(self.optics, &self.poses[camera], self.walls.get(camera), parameters)
    }

    /// Predicted place, in mm, and parallax slope of a mark. `None` if its rays miss the wall or the card.
    pub(super) fn predicted(
        &self,
        model: &CameraModel,
        position: usize,
        stage_mm: &Vector3<f64>,
        number: [i32; 2],
    ) -> Option<[[f64; 2]; 2]> {
        let along_mm = number.map(|n| f64::from(n) * self.card.spacing_mm);
        let origin_mm = self.origins_mm[position] + stage_mm;
        model.place_and_slope(&self.card.place_mm(&origin_mm, along_mm, &model.axis()))
    }

    /// Measured minus predicted place, in mm, and slope of every mark of an observation.
    pub(super) fn differences<'s>(
        &'s self,
        observation: &'s Observation,
        adjusted: &Adjusted,
        stage_mm: &'s Vector3<f64>,
    ) -> impl Iterator<Item = (&'s ObservedMark, [[f64; 2]; 2])> + use<'s> {
        let model = self.model(observation.camera, adjusted.cameras[observation.camera]);
        observation.marks.iter().filter_map(move |mark| {
            let [place_mm, slopes] =
                self.predicted(&model, observation.position, stage_mm, mark.number)?;
            let off = [
                [mark.place_mm[0] - place_mm[0], mark.place_mm[1] - place_mm[1]],
                [mark.slopes[0] - slopes[0], mark.slopes[1] - slopes[1]],
            ];
            Some((mark, off))
        })
    }

    /// Sets the standard deviations to the root-mean-square residuals of the marks.
    pub(super) fn update_deviations(&mut self, observations: &[Observation], adjusted: &Adjusted) {
        let (mut sums, mut count) = ([0.0; 2], 0.0);
        for observation in observations {
            let stage_mm = &adjusted.stage_mm[observation.position];
            for (_, off) in self.differences(observation, adjusted, stage_mm) {
                for (sum, of) in sums.iter_mut().zip(off) {
                    *sum += of[0] * of[0] + of[1] * of[1];
                }
                count += 2.0;
            }
        }
        let least = deviations(self.optics, LEAST_PLACE_DEVIATION);
        let rms = |n: usize| -> f64 { (sums[n] / f64::max(count, 1.0)).sqrt() };
        self.deviations = [rms(0).max(least[0]), rms(1).max(least[1])];
    }

    /// Whether the positions of the card are unknowns.
    fn fits_stage(&self) -> bool {
        self.stage_deviation_mm > 0.0
    }

    /// Number of unknowns: parameters of the cameras, then positions of the card, in prior standard deviations.
    fn unknowns(&self) -> usize {
        let stage = if self.fits_stage() { 3 * self.origins_mm.len() } else { 0 };
        self.poses.len() * PARAMETERS + stage
    }

    fn camera(&self, unknowns: &DVector<f64>, camera: usize) -> CameraParameters {
        let wall = self.walls.get(camera).is_some();
        CameraParameters(std::array::from_fn(|n| {
            // The last two parameters are the tilts of the wall.
            let is_used = wall || n < PARAMETERS - 2;
            if is_used { unknowns[camera * PARAMETERS + n] * DESCRIPTIONS[n].2 } else { 0.0 }
        }))
    }

    fn stage_mm(&self, unknowns: &DVector<f64>, position: usize) -> Vector3<f64> {
        if !self.fits_stage() {
            return Vector3::zeros();
        }
        let first = self.poses.len() * PARAMETERS + 3 * position;
        Vector3::from_fn(|axis, _| unknowns[first + axis] * self.stage_deviation_mm)
    }

    /// Residuals of one observation, in standard deviations: x, slope along x, y, slope along y of each mark.
    /// `None` if rays of a mark miss the wall or the card.
    fn residuals(
        &self,
        observation: &Observation,
        model: &CameraModel,
        stage_mm: &Vector3<f64>,
    ) -> Option<Vec<f64>> {
        let [place, slope] = self.deviations;
        let mut residuals = Vec::with_capacity(4 * observation.marks.len());
        for mark in &observation.marks {
            let [place_mm, slopes] =
                self.predicted(model, observation.position, stage_mm, mark.number)?;
            for axis in 0..2 {
                residuals.push((mark.place_mm[axis] - place_mm[axis]) / place);
                residuals.push((mark.slopes[axis] - slopes[axis]) / slope);
            }
        }
        Some(residuals)
    }

    fn residuals_at(&self, observation: &Observation, unknowns: &DVector<f64>) -> Option<Vec<f64>> {
        let model = self.model(observation.camera, self.camera(unknowns, observation.camera));
        self.residuals(observation, &model, &self.stage_mm(unknowns, observation.position))
    }

    /// Indices of the unknowns on which an observation depends.
    fn unknowns_of(&self, observation: &Observation) -> Vec<usize> {
        let first = observation.camera * PARAMETERS;
        let stage = self.poses.len() * PARAMETERS + 3 * observation.position;
        let stage_unknowns = if self.fits_stage() { stage..stage + 3 } else { 0..0 };
        (first..first + PARAMETERS).chain(stage_unknowns).collect()
    }

    /// Sum of squared residuals, plus squared unknowns as the prior term.
    fn cost(&self, observations: &[Observation], unknowns: &DVector<f64>) -> Option<f64> {
        let mut cost = unknowns.norm_squared();
        for observation in observations {
            cost += self.residuals_at(observation, unknowns)?.iter().map(|r| r * r).sum::<f64>();
        }
        Some(cost)
    }

    /// Normal matrix and right-hand side, with priors.
    fn normal(
        &self,
        observations: &[Observation],
        unknowns: &DVector<f64>,
    ) -> Option<(DMatrix<f64>, DVector<f64>)> {
        let n = self.unknowns();
        let mut normal = DMatrix::identity(n, n);
        let mut right = -unknowns.clone();
        let parts: Vec<_> = observations
            .par_iter()
            .map(|observation| self.normal_of(observation, unknowns))
            .collect::<Option<_>>()?;
        // Summed in a fixed order, so that rounding does not depend on the threads.
        for (observation, (square, gradient)) in observations.iter().zip(parts) {
            let indices = self.unknowns_of(observation);
            for (a, &row) in indices.iter().enumerate() {
                right[row] -= gradient[a];
                for (b, &column) in indices.iter().enumerate() {
                    normal[(row, column)] += square[(a, b)];
                }
            }
        }
        Some((normal, right))
    }

    /// Contribution of one observation: JᵀJ and Jᵀr, with the Jacobian J for the unknowns on which it depends.
    fn normal_of(
        &self,
        observation: &Observation,
        unknowns: &DVector<f64>,
    ) -> Option<(DMatrix<f64>, DVector<f64>)> {
        let here = self.residuals_at(observation, unknowns)?;
        let indices = self.unknowns_of(observation);
        let mut jacobian = DMatrix::zeros(here.len(), indices.len());
        for (column, &unknown) in indices.iter().enumerate() {
            let mut moved = unknowns.clone();
            moved[unknown] += STEP;
            let there = self.residuals_at(observation, &moved)?;
            for (row, (there, here)) in there.iter().zip(&here).enumerate() {
                jacobian[(row, column)] = (there - here) / STEP;
            }
        }
        let gradient = jacobian.transpose() * DVector::from_vec(here);
        Some((jacobian.transpose() * &jacobian, gradient))
    }

    /// Fits the cameras to the observations, starting from `start`.
    ///
    /// # Errors
    /// [`VolumeError::RaysMiss`] or [`VolumeError::NothingFits`], if the normal matrix is singular.
    pub(super) fn adjust(
        &self,
        observations: &[Observation],
        start: Option<&Adjusted>,
    ) -> Result<Adjusted, VolumeError> {
        let mut unknowns = self.initial_unknowns(start);
        let mut cost = self.cost(observations, &unknowns).ok_or(VolumeError::RaysMiss)?;
        let mut damping = 1e-4;
        for _ in 0..MOST_STEPS {
            let (normal, right) =
                self.normal(observations, &unknowns).ok_or(VolumeError::RaysMiss)?;
            let mut damped = normal.clone();
            for n in 0..damped.nrows() {
                damped[(n, n)] *= 1.0 + damping;
            }
            let Some(factors) = damped.cholesky() else { return Err(VolumeError::NothingFits) };
            let trial = &unknowns + factors.solve(&right);
            match self.cost(observations, &trial) {
                Some(lower) if lower <= cost => {
                    let change = (cost - lower) / cost.max(f64::MIN_POSITIVE);
                    (unknowns, cost) = (trial, lower);
                    damping = (damping * 0.1).max(1e-12);
                    if change < LAST_CHANGE {
                        break;
                    }
                }
                _ if damping > 1e8 => break,
                _ => damping *= 10.0,
            }
        }
        self.adjusted(observations, &unknowns, cost)
    }

    /// Fits the position of the card to observations at a left-out position, with fixed cameras. Returns fitted
    /// minus stated position, in mm; 0 for an exact stage.
    ///
    /// # Errors
    /// As [`Self::adjust`].
    pub(super) fn fit_stage(
        &self,
        observations: &[Observation],
        adjusted: &Adjusted,
        position: usize,
    ) -> Result<Vector3<f64>, VolumeError> {
        if !self.fits_stage() {
            return Ok(Vector3::zeros());
        }
        let mut unknowns = self.initial_unknowns(Some(adjusted));
        let first = self.poses.len() * PARAMETERS + 3 * position;
        // Two Gauss-Newton steps suffice, because the model is nearly linear for shifts of some micrometres.
        for _ in 0..2 {
            let (normal, right) =
                self.normal(observations, &unknowns).ok_or(VolumeError::RaysMiss)?;
            let of_card = normal.fixed_view::<3, 3>(first, first).into_owned();
            let factors = of_card.cholesky().ok_or(VolumeError::NothingFits)?;
            let step = factors.solve(&right.fixed_rows::<3>(first).into_owned());
            unknowns.fixed_rows_mut::<3>(first).add_assign(&step);
        }
        Ok(self.stage_mm(&unknowns, position))
    }

    fn initial_unknowns(&self, start: Option<&Adjusted>) -> DVector<f64> {
        let mut unknowns = DVector::zeros(self.unknowns());
        let Some(start) = start else { return unknowns };
        for (camera, parameters) in start.cameras.iter().enumerate() {
            for (n, value) in parameters.0.iter().enumerate() {
                unknowns[camera * PARAMETERS + n] = value / DESCRIPTIONS[n].2;
            }
        }
        if self.fits_stage() {
            for (position, stage_mm) in start.stage_mm.iter().enumerate() {
                for axis in 0..3 {
                    unknowns[self.poses.len() * PARAMETERS + 3 * position + axis] =
                        stage_mm[axis] / self.stage_deviation_mm;
                }
            }
        }
        unknowns
    }

    /// Result with these unknowns, with standard deviations from the inverse of the normal matrix.
    fn adjusted(
        &self,
        observations: &[Observation],
        unknowns: &DVector<f64>,
        cost: f64,
    ) -> Result<Adjusted, VolumeError> {
        let (normal, _) = self.normal(observations, unknowns).ok_or(VolumeError::RaysMiss)?;
        let eigenvalues = normal.symmetric_eigenvalues();
        let condition_number = eigenvalues.max() / eigenvalues.min();
        let covariance = normal.try_inverse().ok_or(VolumeError::NothingFits)?;
        let residuals: usize =
            observations.iter().map(|observation| 4 * observation.marks.len()).sum();
        // Scaled by the root of the reduced χ² if that exceeds 1.
        let scale = (cost / residuals.max(1) as f64).sqrt().max(1.0);
        let deviation = |unknown: usize| (covariance[(unknown, unknown)].sqrt() * scale).min(1.0);
        let cameras = self.poses.len();
        Ok(Adjusted {
            cameras: (0..cameras).map(|camera| self.camera(unknowns, camera)).collect(),
            stage_mm: (0..self.origins_mm.len()).map(|n| self.stage_mm(unknowns, n)).collect(),
            deviations: (0..cameras)
                .map(|camera| {
                    std::array::from_fn(|n| deviation(camera * PARAMETERS + n) * DESCRIPTIONS[n].2)
                })
                .collect(),
            condition_number,
        })
    }

    /// Removes marks with large residuals. Returns whether there were any.
    pub(super) fn drop_outliers(
        &self,
        observations: &mut [Observation],
        adjusted: &Adjusted,
    ) -> bool {
        let mut all = Vec::new();
        for observation in observations.iter() {
            all.extend(self.distances(observation, adjusted));
        }
        let mut squares: Vec<f64> = all.iter().map(|d| d * d).filter(|d| d.is_finite()).collect();
        squares.sort_by(f64::total_cmp);
        // The χ² distribution with four degrees of freedom has the median 3.36 and the mean 4.
        let Some(median) = squares.get(squares.len() / 2) else { return false };
        let limit = OUTLIER * (median * 4.0 / 3.36).sqrt();
        let mut dropped = false;
        for observation in observations {
            let mut distances = self.distances(observation, adjusted).into_iter();
            let before = observation.marks.len();
            observation
                .marks
                .retain(|_| distances.next().is_some_and(|distance| distance <= limit));
            dropped |= observation.marks.len() < before;
        }
        dropped
    }

    /// Norm of each mark's residuals, in standard deviations.
    fn distances(&self, observation: &Observation, adjusted: &Adjusted) -> Vec<f64> {
        let model = self.model(observation.camera, adjusted.cameras[observation.camera]);
        match self.residuals(observation, &model, &adjusted.stage_mm[observation.position]) {
            Some(residuals) => {
                residuals.chunks(4).map(|r| r.iter().map(|r| r * r).sum::<f64>().sqrt()).collect()
            }
            None => vec![f64::INFINITY; observation.marks.len()],
        }
    }
}
