//! How far a displacement field is from the known flow.

use lfpiv_core::velocimetry::{Gradients, VectorStatus, VelocityField, curl_and_divergence};
use lfpiv_sim::Flow;

/// Errors up to this count as measured (paper, Fig. 18), in voxels.
const WITHIN_VOX: f64 = 0.3;

/// Points of a cumulative distribution.
const CDF_POINTS: usize = 100;

/// The known flow, and whose displacement a vector is taken for.
#[derive(Debug, Clone, Copy)]
pub enum KnownFlow<'a> {
    /// That of the particle that is at the vector's place in the middle of the pair: windows.
    InTheMiddle(&'a Flow),
    /// That of the particle whose two positions average to the place: a field through placed particles.
    OnAverage(&'a Flow),
}

impl KnownFlow<'_> {
    /// The displacement that a vector at `at_mm` should have, in mm.
    pub fn displacement_mm(&self, at_mm: [f64; 3], dt_s: f64) -> [f64; 3] {
        match self {
            Self::InTheMiddle(flow) => flow.displacement_mm(at_mm, dt_s),
            Self::OnAverage(flow) => flow.displacement_about_mm(at_mm, dt_s),
        }
    }
}

/// The error of a field.
#[derive(Debug, Clone)]
pub struct Score {
    /// Mean |error| along x, y, z over all vectors, valid or not, in voxels (paper, Eq. 6).
    pub mean_vox: [f64; 3],
    /// Share of the components within 0.3 voxels; those of invalid vectors count as misses.
    pub within: [f64; 3],
    /// Shares of the valid vectors' components within one and within 1.96 stated standard
    /// uncertainties of the truth; 0 without valid vectors.
    pub covered: [f64; 2],
    /// |error| along x, y, z, ascending, in voxels.
    sorted_vox: [Vec<f64>; 3],
}

impl Score {
    /// Compares a field with the analytic solution.
    pub fn of(field: &VelocityField, truth: KnownFlow<'_>) -> Self {
        let truth = true_field(field, truth);
        let count = field.grid.len().max(1) as f64;
        let mut score = Self {
            mean_vox: [0.0; 3],
            within: [0.0; 3],
            covered: [1.0, 1.96].map(|widths| covered(field, &truth, widths)),
            sorted_vox: Default::default(),
        };
        for axis in 0..3 {
            let error = |n: usize| {
                let (got, wanted) =
                    (field.displacement_vox[n][axis], truth.displacement_vox[n][axis]);
                f64::from(got - wanted).abs()
            };
            let mut errors: Vec<f64> = (0..field.grid.len()).map(error).collect();
            let hit =
                |n: &usize| errors[*n] <= WITHIN_VOX && field.status[*n] == VectorStatus::Valid;
            score.within[axis] = (0..errors.len()).filter(hit).count() as f64 / count;
            score.mean_vox[axis] = errors.iter().sum::<f64>() / count;
            errors.sort_by(f64::total_cmp);
            score.sorted_vox[axis] = errors;
        }
        score
    }

    /// Points (|error| in voxels, share of the vectors with at most that) of one component.
    pub fn distribution(&self, axis: usize) -> Vec<[f64; 2]> {
        let errors = &self.sorted_vox[axis];
        let last = errors.len().saturating_sub(1);
        (0..=CDF_POINTS)
            .filter_map(|n| {
                let at = (n * last) as f64 / CDF_POINTS as f64;
                let index = at.round() as usize;
                let error = errors.get(index)?;
                Some([*error, (index + 1) as f64 / errors.len() as f64])
            })
            .collect()
    }
}

/// Share of the valid vectors' components within so many standard uncertainties of the truth.
fn covered(field: &VelocityField, truth: &VelocityField, widths: f64) -> f64 {
    let (mut hits, mut all) = (0usize, 0usize);
    for n in (0..field.grid.len()).filter(|&n| field.status[n] == VectorStatus::Valid) {
        let errors = field.displacement_vox[n].iter().zip(&truth.displacement_vox[n]);
        let uncertainties = field.uncertainty_vox[n].iter().map(|&u| widths * f64::from(u));
        let hit = errors
            .zip(uncertainties)
            .filter(|((got, want), u)| f64::from((*got - *want).abs()) <= *u);
        hits += hit.count();
        all += 3;
    }
    hits as f64 / all.max(1) as f64
}

/// The analytic solution at a field's places.
pub fn true_field(field: &VelocityField, truth: KnownFlow<'_>) -> VelocityField {
    let displacement_vox: Vec<[f32; 3]> = (0..field.grid.len())
        .map(|n| {
            let moved_mm = truth.displacement_mm(field.grid.position_mm(n), field.dt_s);
            moved_mm.map(|mm| (mm / field.voxel_mm) as f32)
        })
        .collect();
    let step_vox = field.grid.spacing_mm / field.voxel_mm;
    let everywhere = vec![true; field.grid.len()];
    let Gradients { vorticity, divergence, known } =
        curl_and_divergence(field.grid.vectors, &displacement_vox, &everywhere, step_vox);
    VelocityField {
        displacement_vox,
        vorticity,
        divergence,
        has_gradient: known,
        status: vec![VectorStatus::Valid; field.grid.len()],
        ..field.clone()
    }
}
