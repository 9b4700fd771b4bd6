//! Parameters of the cameras from where marks were seen: Levenberg and Marquardt with priors.

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
    mark_fit::SeenMark,
    parameters::{CameraParameters, DESCRIPTIONS, PARAMETERS},
};

/// Least and first standard deviation of a mark's place on the microlens plane, in microlenses: what fits
/// leave on perfect images, and what they may leave at worst. In between the marks' own scatter counts,
/// so that a bad card does not drive parameters far from the drawing.
const LEAST_PLACE_DEVIATION: f64 = 0.003;
const FIRST_PLACE_DEVIATION: f64 = 0.05;

/// Steps of Levenberg and Marquardt; fifteen suffice.
const MOST_STEPS: usize = 60;

/// A step that changes the cost by less than this share is the last.
const LAST_CHANGE: f64 = 1e-6;

/// Marks farther off than this many root mean squares of all are left out.
const OUTLIER: f64 = 6.0;

/// Step of the difference quotients, in prior standard deviations.
const STEP: f64 = 1e-4;

/// The marks that one camera sees at one position of the card.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Sighting {
    pub(super) camera: usize,
    pub(super) position: usize,
    pub(super) marks: Vec<SeenMark>,
}

/// What does not change in an adjustment.
#[derive(Debug, Clone, Copy)]
pub(super) struct Bench<'a> {
    pub(super) optics: &'a Optics,
    pub(super) poses: &'a [Pose],
    pub(super) walls: &'a [Wall],
    pub(super) card: &'a Card,
    pub(super) origins_mm: &'a [Point3<f64>],
    /// Standard deviation of the card's true positions about the stated ones, along each axis, in mm; zero
    /// takes them as they are.
    pub(super) stage_deviation_mm: f64,
    /// Standard deviations of a mark's place, in mm, and of its slopes.
    pub(super) deviations: [f64; 2],
}

/// Deviations before any mark is seen, of place in mm and of slope.
pub(super) fn first_deviations(optics: &Optics) -> [f64; 2] {
    deviations(optics, FIRST_PLACE_DEVIATION)
}

/// Of place, given in microlenses, and of slope, which shows at half the pupil's radius.
fn deviations(optics: &Optics, place: f64) -> [f64; 2] {
    let place_mm = place * optics.microlens.pitch_mm;
    [place_mm, place_mm / (optics.pupil_diameter_mm() / 4.0)]
}

/// Cameras that fit what was seen.
#[derive(Debug, Clone)]
pub(super) struct Adjusted {
    pub(super) cameras: Vec<CameraParameters>,
    /// How far the card was from each told place, in mm.
    pub(super) stage_mm: Vec<Vector3<f64>>,
    /// Posterior standard deviations of the cameras' parameters.
    pub(super) deviations: Vec<[f64; PARAMETERS]>,
    /// Of the normal matrix, in prior standard deviations.
    pub(super) condition_number: f64,
}

impl Bench<'_> {
    /// The camera with these parameters.
    pub(super) fn model(&self, camera: usize, parameters: CameraParameters) -> CameraModel {
        CameraModel::new(self.optics, &self.poses[camera], self.walls.get(camera), parameters)
    }

    /// Where a mark of a camera should be seen, and how its rays move with the pupil.
    pub(super) fn expected(
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

    /// Seen less expected of every mark of a sighting: places in mm, and slopes.
    pub(super) fn differences<'s>(
        &'s self,
        sighting: &'s Sighting,
        adjusted: &Adjusted,
        stage_mm: &'s Vector3<f64>,
    ) -> impl Iterator<Item = (&'s SeenMark, [[f64; 2]; 2])> + use<'s> {
        let model = self.model(sighting.camera, adjusted.cameras[sighting.camera]);
        sighting.marks.iter().filter_map(move |mark| {
            let [place_mm, slopes] =
                self.expected(&model, sighting.position, stage_mm, mark.number)?;
            let off = [
                [mark.place_mm[0] - place_mm[0], mark.place_mm[1] - place_mm[1]],
                [mark.slopes[0] - slopes[0], mark.slopes[1] - slopes[1]],
            ];
            Some((mark, off))
        })
    }

    /// Weights by what the marks scatter about cameras that were fitted to them.
    pub(super) fn weigh(&mut self, sightings: &[Sighting], adjusted: &Adjusted) {
        let (mut sums, mut count) = ([0.0; 2], 0.0);
        for sighting in sightings {
            let stage_mm = &adjusted.stage_mm[sighting.position];
            for (_, off) in self.differences(sighting, adjusted, stage_mm) {
                for (sum, of) in sums.iter_mut().zip(off) {
                    *sum += of[0] * of[0] + of[1] * of[1];
                }
                count += 2.0;
            }
        }
        let least = deviations(self.optics, LEAST_PLACE_DEVIATION);
        let scatter = |n: usize| -> f64 { (sums[n] / f64::max(count, 1.0)).sqrt() };
        self.deviations = [scatter(0).max(least[0]), scatter(1).max(least[1])];
    }

    fn stage_moves(&self) -> bool {
        self.stage_deviation_mm > 0.0
    }

    /// Numbers of all unknowns, each in prior standard deviations: cameras, then places of the card.
    fn unknowns(&self) -> usize {
        let stage = if self.stage_moves() { 3 * self.origins_mm.len() } else { 0 };
        self.poses.len() * PARAMETERS + stage
    }

    fn camera(&self, unknowns: &DVector<f64>, camera: usize) -> CameraParameters {
        let wall = self.walls.get(camera).is_some();
        CameraParameters(std::array::from_fn(|n| {
            // Without a wall there is nothing to tilt.
            let known = wall || n < PARAMETERS - 2;
            if known { unknowns[camera * PARAMETERS + n] * DESCRIPTIONS[n].2 } else { 0.0 }
        }))
    }

    fn stage_mm(&self, unknowns: &DVector<f64>, position: usize) -> Vector3<f64> {
        if !self.stage_moves() {
            return Vector3::zeros();
        }
        let first = self.poses.len() * PARAMETERS + 3 * position;
        Vector3::from_fn(|axis, _| unknowns[first + axis] * self.stage_deviation_mm)
    }

    /// Residuals of one sighting, in standard deviations; `None` where a mark would not be seen.
    fn residuals(
        &self,
        sighting: &Sighting,
        model: &CameraModel,
        stage_mm: &Vector3<f64>,
    ) -> Option<Vec<f64>> {
        let [place, slope] = self.deviations;
        let mut residuals = Vec::with_capacity(4 * sighting.marks.len());
        for mark in &sighting.marks {
            let [place_mm, slopes] =
                self.expected(model, sighting.position, stage_mm, mark.number)?;
            for axis in 0..2 {
                residuals.push((mark.place_mm[axis] - place_mm[axis]) / place);
                residuals.push((mark.slopes[axis] - slopes[axis]) / slope);
            }
        }
        Some(residuals)
    }

    fn residuals_at(&self, sighting: &Sighting, unknowns: &DVector<f64>) -> Option<Vec<f64>> {
        let model = self.model(sighting.camera, self.camera(unknowns, sighting.camera));
        self.residuals(sighting, &model, &self.stage_mm(unknowns, sighting.position))
    }

    /// Which unknowns a sighting depends on.
    fn touched(&self, sighting: &Sighting) -> Vec<usize> {
        let first = sighting.camera * PARAMETERS;
        let stage = self.poses.len() * PARAMETERS + 3 * sighting.position;
        let moves = if self.stage_moves() { stage..stage + 3 } else { 0..0 };
        (first..first + PARAMETERS).chain(moves).collect()
    }

    fn cost(&self, sightings: &[Sighting], unknowns: &DVector<f64>) -> Option<f64> {
        let mut cost = unknowns.norm_squared();
        for sighting in sightings {
            cost += self.residuals_at(sighting, unknowns)?.iter().map(|r| r * r).sum::<f64>();
        }
        Some(cost)
    }

    /// Normal matrix and right side, priors included.
    fn normal(
        &self,
        sightings: &[Sighting],
        unknowns: &DVector<f64>,
    ) -> Option<(DMatrix<f64>, DVector<f64>)> {
        let n = self.unknowns();
        let mut normal = DMatrix::identity(n, n);
        let mut right = -unknowns.clone();
        let parts: Vec<_> = sightings
            .par_iter()
            .map(|sighting| self.normal_of(sighting, unknowns))
            .collect::<Option<_>>()?;
        // In the order of the sightings: the rounding does not depend on the threads.
        for (sighting, (square, gradient)) in sightings.iter().zip(parts) {
            let touched = self.touched(sighting);
            for (a, &row) in touched.iter().enumerate() {
                right[row] -= gradient[a];
                for (b, &column) in touched.iter().enumerate() {
                    normal[(row, column)] += square[(a, b)];
                }
            }
        }
        Some((normal, right))
    }

    /// What one sighting adds to both, for the unknowns that it depends on.
    fn normal_of(
        &self,
        sighting: &Sighting,
        unknowns: &DVector<f64>,
    ) -> Option<(DMatrix<f64>, DVector<f64>)> {
        let here = self.residuals_at(sighting, unknowns)?;
        let touched = self.touched(sighting);
        let mut changes = DMatrix::zeros(here.len(), touched.len());
        for (column, &unknown) in touched.iter().enumerate() {
            let mut moved = unknowns.clone();
            moved[unknown] += STEP;
            let there = self.residuals_at(sighting, &moved)?;
            for (row, (there, here)) in there.iter().zip(&here).enumerate() {
                changes[(row, column)] = (there - here) / STEP;
            }
        }
        let gradient = changes.transpose() * DVector::from_vec(here);
        Some((changes.transpose() * &changes, gradient))
    }

    /// The cameras that fit what was seen, begun at `start`.
    ///
    /// # Errors
    /// Rays miss the card or the wall, or nothing fits.
    pub(super) fn adjust(
        &self,
        sightings: &[Sighting],
        start: Option<&Adjusted>,
    ) -> Result<Adjusted, VolumeError> {
        let mut unknowns = self.start(start);
        let mut cost = self.cost(sightings, &unknowns).ok_or(VolumeError::RaysMiss)?;
        let mut damping = 1e-4;
        for _ in 0..MOST_STEPS {
            let (normal, right) = self.normal(sightings, &unknowns).ok_or(VolumeError::RaysMiss)?;
            let mut damped = normal.clone();
            for n in 0..damped.nrows() {
                damped[(n, n)] *= 1.0 + damping;
            }
            let Some(factors) = damped.cholesky() else { return Err(VolumeError::NothingFits) };
            let trial = &unknowns + factors.solve(&right);
            match self.cost(sightings, &trial) {
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
        self.adjusted(sightings, &unknowns, cost)
    }

    /// Where the card was at a position that `adjusted` does not know, from what its cameras saw there, in
    /// mm beside the told place; zero where the stage is taken as it is.
    ///
    /// # Errors
    /// Rays miss the card or the wall, or nothing fits.
    pub(super) fn place_card(
        &self,
        seen: &[Sighting],
        adjusted: &Adjusted,
        position: usize,
    ) -> Result<Vector3<f64>, VolumeError> {
        if !self.stage_moves() {
            return Ok(Vector3::zeros());
        }
        let mut unknowns = self.start(Some(adjusted));
        let first = self.poses.len() * PARAMETERS + 3 * position;
        // Micrometres: what is seen depends on them all but linearly.
        for _ in 0..2 {
            let (normal, right) = self.normal(seen, &unknowns).ok_or(VolumeError::RaysMiss)?;
            let of_card = normal.fixed_view::<3, 3>(first, first).into_owned();
            let factors = of_card.cholesky().ok_or(VolumeError::NothingFits)?;
            let step = factors.solve(&right.fixed_rows::<3>(first).into_owned());
            unknowns.fixed_rows_mut::<3>(first).add_assign(&step);
        }
        Ok(self.stage_mm(&unknowns, position))
    }

    fn start(&self, start: Option<&Adjusted>) -> DVector<f64> {
        let mut unknowns = DVector::zeros(self.unknowns());
        let Some(start) = start else { return unknowns };
        for (camera, parameters) in start.cameras.iter().enumerate() {
            for (n, value) in parameters.0.iter().enumerate() {
                unknowns[camera * PARAMETERS + n] = value / DESCRIPTIONS[n].2;
            }
        }
        if self.stage_moves() {
            for (position, stage_mm) in start.stage_mm.iter().enumerate() {
                for axis in 0..3 {
                    unknowns[self.poses.len() * PARAMETERS + 3 * position + axis] =
                        stage_mm[axis] / self.stage_deviation_mm;
                }
            }
        }
        unknowns
    }

    fn adjusted(
        &self,
        sightings: &[Sighting],
        unknowns: &DVector<f64>,
        cost: f64,
    ) -> Result<Adjusted, VolumeError> {
        let (normal, _) = self.normal(sightings, unknowns).ok_or(VolumeError::RaysMiss)?;
        let eigenvalues = normal.symmetric_eigenvalues();
        let condition_number = eigenvalues.max() / eigenvalues.min();
        let covariance = normal.try_inverse().ok_or(VolumeError::NothingFits)?;
        let seen: usize = sightings.iter().map(|sighting| 4 * sighting.marks.len()).sum();
        // Where marks are farther off than was assumed, so are the parameters.
        let scale = (cost / seen.max(1) as f64).sqrt().max(1.0);
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

    /// Leaves out marks that are far from where the cameras should see them; whether there were any.
    pub(super) fn drop_outliers(&self, sightings: &mut [Sighting], adjusted: &Adjusted) -> bool {
        let mut all = Vec::new();
        for sighting in sightings.iter() {
            all.extend(self.distances(sighting, adjusted));
        }
        let mut squares: Vec<f64> = all.iter().map(|d| d * d).filter(|d| d.is_finite()).collect();
        squares.sort_by(f64::total_cmp);
        // The median of the square of a normal deviate's length in four dimensions is 3.36, its mean 4.
        let Some(median) = squares.get(squares.len() / 2) else { return false };
        let limit = OUTLIER * (median * 4.0 / 3.36).sqrt();
        let mut dropped = false;
        for sighting in sightings {
            let mut distances = self.distances(sighting, adjusted).into_iter();
            let before = sighting.marks.len();
            sighting.marks.retain(|_| distances.next().is_some_and(|distance| distance <= limit));
            dropped |= sighting.marks.len() < before;
        }
        dropped
    }

    /// Length of each mark's residuals, in standard deviations.
    fn distances(&self, sighting: &Sighting, adjusted: &Adjusted) -> Vec<f64> {
        let model = self.model(sighting.camera, adjusted.cameras[sighting.camera]);
        match self.residuals(sighting, &model, &adjusted.stage_mm[sighting.position]) {
            Some(residuals) => {
                residuals.chunks(4).map(|r| r.iter().map(|r| r * r).sum::<f64>().sqrt()).collect()
            }
            None => vec![f64::INFINITY; sighting.marks.len()],
        }
    }
}
