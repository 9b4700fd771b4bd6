//! The values of Zhu, Xu, Hossain and Khoo (Physics of Fluids 35, 2023) that ours stand beside: as
//! stated in its text. Curves that exist only in its figures are not read off.

/// Q above which artefacts do not add to the correlation's error (section 4.1, reference 36).
pub const USABLE_QUALITY: f64 = 0.75;

/// Iterations to convergence at 0.1 and 0.5 ppm (Fig. 13a): OS-SART and SART.
pub const PASSES_OS_SART: f64 = 400.0;
/// See [`PASSES_OS_SART`].
pub const PASSES_SART: f64 = 800.0;

/// Iterations to convergence of the example of Fig. 4: OS-SART and SART.
pub const EXAMPLE_PASSES_OS_SART: f64 = 75.0;
/// See [`EXAMPLE_PASSES_OS_SART`].
pub const EXAMPLE_PASSES_SART: f64 = 125.0;

/// Least acceleration of OS-SART over SART at Q = 0.75, 0.1 to 1 ppm (Fig. 13b).
pub const ACCELERATION: f64 = 2.0;

/// Memory of OS-SART's matrices over SART's (section 4.1).
pub const MEMORY_SHARE: f64 = 1.0 / 12.0;

/// FWHM of a particle in focus, one camera, SART or OS-SART, in mm (Fig. 10a).
pub const FWHM_FOCUS_ONE_CAMERA_MM: f64 = 1.0;
/// Mean FWHM over −10 mm < z < 10 mm by OS-SART with one camera, in mm (Fig. 10b).
pub const FWHM_ONE_CAMERA_MM: f64 = 1.83;
/// The same with two cameras, in mm.
pub const FWHM_TWO_CAMERAS_MM: f64 = 0.1;

/// Vorticity of the iso-surface of Fig. 14, in voxel per voxel.
pub const ISO_VORTICITY: f64 = 0.2;

/// Mean error of v and w by OS-SART with two cameras: smaller than this, in voxels (Fig. 17).
pub const ERROR_TWO_CAMERAS_VOX: f64 = 0.1;
/// Mean error of w with one camera, by OS-SART, in voxels (Fig. 17b).
pub const ERROR_W_ONE_CAMERA_VOX: f64 = 0.27;

/// Share of v within 0.3 voxels at 1.6 ppm (Fig. 18a).
pub const WITHIN_V: f64 = 0.97;
/// Share of w within 0.3 voxels at 1.6 ppm by OS-SART with two cameras (Fig. 18b).
pub const WITHIN_W: f64 = 0.96;
/// The same with one camera: lower than this.
pub const WITHIN_W_ONE_CAMERA: f64 = 0.82;
