//! Validation of measured vectors, and replacement of outliers.

use super::{
    VectorGrid, VectorStatus, VelocimetrySettings, VelocityField,
    derived::{Gradients, gradients_within},
    field::unknown_vox,
    flow_nodes::FlowNodes,
    lattice::Lattice,
    peak::Peak,
    settings::SEARCH_MARGIN,
    validate::Candidates,
};
use crate::model::VolumeGrid;

/// Uncertainty of a replaced vector between passes, in voxels: its weight is small compared with a measured one.
const REPLACEMENT_UNCERTAINTY_VOX: f32 = 1.0;

/// A reported vector.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Vector {
    /// Displacement along x, y, z, in voxels.
    pub displacement_vox: [f32; 3],
    /// Its standard uncertainty, in voxels.
    pub uncertainty_vox: [f32; 3],
    /// Its validity.
    pub status: VectorStatus,
}

impl Vector {
    /// A vector without a value, where displacements of up to `max_displacement_vox` are expected.
    pub fn without_value(status: VectorStatus, max_displacement_vox: f64) -> Self {
        let uncertainty_vox = [unknown_vox(max_displacement_vox); 3];
        Self { displacement_vox: [0.0; 3], uncertainty_vox, status }
    }
}

/// The field of `vectors` on `grid`, in voxels of `volume`, with the peak ratio of every correlation.
/// Derivatives use vectors of the same `flow` on `grid` only.
pub fn field_of(
    grid: VectorGrid,
    volume: &VolumeGrid,
    dt_s: f64,
    (vectors, peak_ratios): (&[Vector], &[f32]),
    flow: Option<&FlowNodes>,
) -> VelocityField {
    let displacement_vox: Vec<[f32; 3]> = vectors.iter().map(|v| v.displacement_vox).collect();
    let spacing_vox = grid.spacing_mm / volume.voxel_mm;
    let has_value: Vec<bool> = vectors.iter().map(|v| v.status.has_value()).collect();
    let Gradients { vorticity, divergence, known } =
        gradients_within(grid.vectors, &displacement_vox, &has_value, spacing_vox, flow);
    VelocityField {
        grid,
        uncertainty_vox: vectors.iter().map(|v| v.uncertainty_vox).collect(),
        status: vectors.iter().map(|v| v.status).collect(),
        peak_ratio: peak_ratios.to_vec(),
        displacement_vox,
        vorticity,
        divergence,
        has_gradient: known,
        voxel_mm: volume.voxel_mm,
        dt_s,
    }
}

/// The most probable field, given the last pass's vectors, on the lattice `at_rest`, and the uncertainty of the
/// measured ones; replaced vectors have none. `flow` is that on the lattice.
pub fn settled(
    vectors: &[Vector],
    at_rest: Lattice,
    flow: Option<&FlowNodes>,
) -> (Lattice, Vec<Option<[f32; 3]>>) {
    let measured = |v: &Vector| (v.status == VectorStatus::Valid).then_some(v.uncertainty_vox);
    let uncertainty_vox: Vec<Option<[f32; 3]>> = vectors.iter().map(measured).collect();
    let has_value: Vec<bool> = vectors.iter().map(|v| v.status.has_value()).collect();
    let values = vectors.iter().map(|v| v.displacement_vox).collect();
    let field = Lattice { values, ..at_rest }.filled(&has_value, flow);
    let measured: Vec<bool> = uncertainty_vox.iter().map(Option::is_some).collect();
    (field.likeliest(&uncertainty_vox, &measured, flow), uncertainty_vox)
}

/// Replaces displacements by those of `field` and applies `change` to each vector, given its index. Invalid
/// vectors are unchanged.
pub fn move_to(
    field: &Lattice,
    vectors: &mut [Vector],
    mut change: impl FnMut(usize, &mut Vector),
) {
    for (n, vector) in vectors.iter_mut().enumerate() {
        if vector.status.has_value() {
            vector.displacement_vox = field.values[n];
            change(n, vector);
        }
    }
}

/// The vectors between two passes, outliers replaced.
struct Replaced {
    /// Measured values; interpolated ones in place of outliers; extrapolated ones where there are no neighbours.
    field: Lattice,
    /// Whether a vector keeps its measured value.
    pass: Vec<bool>,
    /// Whether it is measured or interpolated, not extrapolated.
    known: Vec<bool>,
}

/// Validates the vectors of one pass.
#[derive(Debug)]
pub struct Judge<'a> {
    /// Thresholds.
    pub settings: &'a VelocimetrySettings,
    /// The vectors after the pass.
    pub field: &'a Lattice,
    /// The correlation peak of every window, where there is one.
    pub peaks: &'a [Option<Peak>],
    /// Which windows belong to the same flow; all of them if absent.
    pub flow: Option<&'a FlowNodes>,
}

impl Judge<'_> {
    /// The field with outliers interpolated from their neighbours.
    pub fn with_outliers_replaced(&self) -> Lattice {
        self.replace_outliers().field
    }

    /// The field for the next pass: the most probable one, given vectors with standard uncertainty
    /// `uncertainty_vox` where that is known, and [`REPLACEMENT_UNCERTAINTY_VOX`] where it is not. It is
    /// extrapolated to windows without a measured or interpolated vector.
    pub fn predictor(&self, uncertainty_vox: &[Option<[f32; 3]>]) -> Lattice {
        let Replaced { field, pass, known } = self.replace_outliers();
        let own: Vec<Option<[f32; 3]>> =
            uncertainty_vox.iter().zip(pass).map(|(own, pass)| own.filter(|_| pass)).collect();
        let measured: Vec<bool> = own.iter().map(Option::is_some).collect();
        let replacement = |known: bool| known.then_some([REPLACEMENT_UNCERTAINTY_VOX; 3]);
        let weighed: Vec<Option<[f32; 3]>> =
            own.into_iter().zip(known).map(|(own, known)| own.or(replacement(known))).collect();
        field.likeliest(&weighed, &measured, self.flow)
    }

    fn replace_outliers(&self) -> Replaced {
        let found: Vec<bool> = self.peaks.iter().map(Option::is_some).collect();
        let candidates = self.candidates(&found);
        let pass = self.passing(&candidates);
        let values: Vec<Option<[f32; 3]>> = (0..pass.len())
            .map(|n| {
                let replacement =
                    || candidates.interpolated(n, &pass).map(|replacement| replacement.value);
                if pass[n] { Some(self.field.values[n]) } else { replacement() }
            })
            .collect();
        let known: Vec<bool> = values.iter().map(Option::is_some).collect();
        let values = values.into_iter().map(Option::unwrap_or_default).collect();
        Replaced { field: Lattice { values, ..*self.field }.filled(&known, self.flow), pass, known }
    }

    /// The vectors of the last pass, measured or replaced. `uncertainty_vox` is their standard uncertainty where
    /// it is known.
    pub fn vectors(&self, uncertainty_vox: &[Option<[f32; 3]>]) -> Vec<Vector> {
        let trusted: Vec<bool> =
            (0..self.peaks.len()).map(|n| self.trusts(n, uncertainty_vox[n])).collect();
        let candidates = self.candidates(&trusted);
        let pass = self.passing(&candidates);
        (0..pass.len())
            .map(|n| match uncertainty_vox[n] {
                Some(uncertainty_vox) if pass[n] => Vector {
                    displacement_vox: self.field.values[n],
                    uncertainty_vox,
                    status: VectorStatus::Valid,
                },
                _ => self.replacement(n, &candidates, &pass, uncertainty_vox),
            })
            .collect()
    }

    /// Whether a vector may take part in the median test.
    fn trusts(&self, n: usize, uncertainty_vox: Option<[f32; 3]>) -> bool {
        let (Some(peak), Some(uncertainty_vox)) = (self.peaks[n], uncertainty_vox) else {
            return false;
        };
        let limit_vox = SEARCH_MARGIN * self.settings.max_displacement_vox;
        let all = |values: [f32; 3], most: f64| values.iter().all(|v| f64::from(v.abs()) <= most);
        f64::from(peak.ratio) >= self.settings.least_peak_ratio
            && all(self.field.values[n], limit_vox)
            && all(uncertainty_vox, self.settings.largest_uncertainty_vox)
    }

    /// A vector interpolated from neighbours that passed; its variance is the sum of their mean variance and their
    /// scatter. Invalid where there are too few.
    fn replacement(
        &self,
        n: usize,
        candidates: &Candidates,
        pass: &[bool],
        uncertainty_vox: &[Option<[f32; 3]>],
    ) -> Vector {
        match candidates.interpolated(n, pass) {
            Some(replacement) if replacement.supported => {
                let near: Vec<[f32; 3]> =
                    candidates.near(n, pass).filter_map(|other| uncertainty_vox[other]).collect();
                let own = |c: usize| {
                    near.iter().map(|u| u[c].powi(2)).sum::<f32>() / near.len().max(1) as f32
                };
                Vector {
                    displacement_vox: replacement.value,
                    uncertainty_vox: std::array::from_fn(|c| {
                        (own(c) + replacement.spread_vox[c].powi(2)).sqrt()
                    }),
                    status: VectorStatus::Replaced,
                }
            }
            _ => Vector::without_value(VectorStatus::Invalid, self.settings.max_displacement_vox),
        }
    }

    fn candidates<'a>(&'a self, present: &'a [bool]) -> Candidates<'a> {
        Candidates { nodes: self.field.nodes, values: &self.field.values, present, flow: self.flow }
    }

    fn passing(&self, candidates: &Candidates) -> Vec<bool> {
        candidates.passing(self.settings.median_threshold, self.settings.median_epsilon_vox)
    }
}
