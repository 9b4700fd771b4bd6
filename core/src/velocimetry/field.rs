//! The result: displacement vectors on a regular grid.

use serde::{Deserialize, Serialize};

/// Where the vectors are: the centres of the interrogation windows, or places between the first and the last
/// of them.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct VectorGrid {
    /// Vector counts along x, y, z.
    pub vectors: [usize; 3],
    /// World position of vector (0, 0, 0), in mm.
    pub first_mm: [f64; 3],
    /// Distance between neighbouring vectors, in mm.
    pub spacing_mm: f64,
}

impl VectorGrid {
    /// Number of vectors.
    pub fn len(&self) -> usize {
        self.vectors.iter().product()
    }

    /// Whether there is no vector.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// World position of the vector stored at `index` (order z, y, x), in mm.
    pub fn position_mm(&self, index: usize) -> [f64; 3] {
        let [nx, ny, _] = self.vectors;
        let ijk = [index % nx, index / nx % ny, index / (nx * ny)];
        std::array::from_fn(|a| self.first_mm[a] + ijk[a] as f64 * self.spacing_mm)
    }

    /// Vectors `spacing_mm` apart within the same box, in its middle.
    pub fn with_spacing_mm(&self, spacing_mm: f64) -> Self {
        // What rounding takes off the last vector is given back.
        const ROUNDING: f64 = 1e-6;
        let length_mm = self.vectors.map(|count| (count.max(1) - 1) as f64 * self.spacing_mm);
        let steps = length_mm.map(|length| (length / spacing_mm + ROUNDING).floor());
        Self {
            vectors: steps.map(|steps| steps as usize + 1),
            first_mm: std::array::from_fn(|axis| {
                self.first_mm[axis] + (length_mm[axis] - steps[axis] * spacing_mm) / 2.0
            }),
            spacing_mm,
        }
    }

    /// World coordinates of the vectors along one axis (0 is x), in mm.
    pub fn axis_mm(&self, axis: usize) -> Vec<f64> {
        (0..self.vectors[axis]).map(|i| self.first_mm[axis] + i as f64 * self.spacing_mm).collect()
    }
}

/// Validity of a vector.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum VectorStatus {
    /// Measured, and consistent with its neighbours or with the particles around it.
    Valid,
    /// Measured value discarded; the stored one is interpolated from valid neighbours.
    Replaced,
    /// No value: the window contains no light, or its vector was rejected and has too few valid neighbours.
    /// Stored as zero.
    Invalid,
    /// No value: the mask excludes the position from the flow. Stored as zero.
    Masked,
}

impl VectorStatus {
    /// Whether the vector has a measured or interpolated value.
    pub fn has_value(self) -> bool {
        matches!(self, Self::Valid | Self::Replaced)
    }
}

/// A displacement field on a [`VectorGrid`]; every array is stored z, y, x (x fastest) and every
/// number is finite.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct VelocityField {
    /// Positions of the vectors.
    pub grid: VectorGrid,
    /// Displacement from frame a to frame b along x, y, z, in voxels.
    pub displacement_vox: Vec<[f32; 3]>,
    /// Standard uncertainty of the displacement along x, y, z, in voxels; greater than zero. For
    /// a vector without a value that of a uniform distribution up to the largest displacement expected.
    pub uncertainty_vox: Vec<[f32; 3]>,
    /// Validity of each vector.
    pub status: Vec<VectorStatus>,
    /// Highest over second highest correlation peak; 0 where there is no peak.
    pub peak_ratio: Vec<f32>,
    /// Curl of the displacement, in voxel per voxel; zero where it is not known.
    pub vorticity: Vec<[f32; 3]>,
    /// Divergence of the displacement, in voxel per voxel; zero where it is not known.
    pub divergence: Vec<f32>,
    /// Whether vorticity and divergence are known: the vector and, along every axis, a neighbour of it in
    /// the same flow have values.
    pub has_gradient: Vec<bool>,
    /// Edge length of a voxel, in mm.
    pub voxel_mm: f64,
    /// Time between the frames, in s.
    pub dt_s: f64,
}

impl VelocityField {
    /// Factor from displacement in voxels to velocity in m/s.
    pub fn metres_per_second_per_voxel(&self) -> f64 {
        self.voxel_mm * 1e-3 / self.dt_s
    }

    /// Marks every vector invalid that is not masked, and sets it to zero, with the uncertainty of anything
    /// within `max_displacement_vox`.
    pub fn invalidate(&mut self, max_displacement_vox: f64) {
        self.displacement_vox.fill([0.0; 3]);
        self.uncertainty_vox.fill([unknown_vox(max_displacement_vox); 3]);
        for status in self.status.iter_mut().filter(|status| status.has_value()) {
            *status = VectorStatus::Invalid;
        }
        self.peak_ratio.fill(0.0);
        self.vorticity.fill([0.0; 3]);
        self.divergence.fill(0.0);
        self.has_gradient.fill(false);
    }

    /// `values`, one per vector, where the vector has a value, and NaN where it has none: for files and
    /// answers, at whose edge a missing value is said so.
    pub fn or_nan(&self, values: &[[f32; 3]]) -> impl Iterator<Item = [f32; 3]> {
        let has_value = self.status.iter().map(|status| status.has_value());
        values
            .iter()
            .zip(has_value)
            .map(|(v, has_value)| if has_value { *v } else { [f32::NAN; 3] })
    }

    /// Vorticity where it is known, and NaN where not.
    pub fn vorticity_or_nan(&self) -> impl Iterator<Item = [f32; 3]> {
        let known = self.vorticity.iter().zip(&self.has_gradient);
        known.map(|(v, known)| if *known { *v } else { [f32::NAN; 3] })
    }

    /// Divergence where it is known, and NaN where not.
    pub fn divergence_or_nan(&self) -> impl Iterator<Item = f32> {
        let known = self.divergence.iter().zip(&self.has_gradient);
        known.map(|(d, known)| if *known { *d } else { f32::NAN })
    }

    /// Share of the vectors in the flow that were measured and accepted, 0 to 1; 0 where none is in the flow.
    pub fn valid_share(&self) -> f64 {
        let valid = self.status.iter().filter(|s| **s == VectorStatus::Valid).count();
        let masked = self.status.iter().filter(|s| **s == VectorStatus::Masked).count();
        valid as f64 / (self.status.len() - masked).max(1) as f64
    }
}

/// Standard uncertainty of a component of which only its bounds are known: a rectangular
/// distribution of this half-width (GUM 4.3.7).
pub(super) fn unknown_vox(max_displacement_vox: f64) -> f32 {
    (max_displacement_vox / 3f64.sqrt()) as f32
}
