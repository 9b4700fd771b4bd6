//! The parts of a forward model and the size of its voxels.

/// One combination of parts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Combination {
    pub pupil_blur: bool,
    pub aperture_coverage: bool,
    pub diffraction: bool,
    pub noise_weighting: bool,
    /// Voxels along the edge of a voxel of the volume.
    pub refinement: usize,
}
