//! What is to be measured: the declaration of methods and cases.

use std::path::{Path, PathBuf};

use lfpiv::config::read_or_shipped;
use lfpiv_core::{
    reconstruction::{ReconstructionSettings, Solver},
    velocimetry::Placing,
};
use serde::{Deserialize, Serialize};

use super::BenchmarkError;

/// The method that is a case's own `[reconstruction]` table, whatever it says.
pub const AS_CONFIGURED: &str = "configured";

/// Methods, and cases to measure them on.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Suite {
    /// Ways to measure.
    #[serde(rename = "method", default)]
    pub methods: Vec<Method>,
    /// What to reconstruct.
    #[serde(rename = "case")]
    pub cases: Vec<Case>,
    /// Folder that the cases' configuration files are relative to: the suite's own.
    #[serde(skip)]
    pub folder: PathBuf,
}

/// A way to measure.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Method {
    /// Name by which cases ask for it, and in every row.
    pub name: String,
    /// Name in figures.
    pub label: String,
    /// The whole `[reconstruction]` table.
    pub reconstruction: ReconstructionSettings,
    /// When particles are placed, instead of what the configuration says.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub place_particles: Option<Placing>,
}

/// A family of simulated shots and what is measured on them.
#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// Name in every row.
    pub name: String,
    /// Set by which the command line selects it.
    pub set: String,
    /// What is measured.
    pub measure: Measure,
    /// Configuration file, relative to the suite's folder.
    pub config: PathBuf,
    /// What is different from the file: tables and keys as in a configuration. A flow that names
    /// its kind replaces the file's.
    #[serde(default)]
    pub with: toml::Table,
    /// Seeding densities, in particles per microlens; the configuration's when empty.
    #[serde(default)]
    pub ppm: Vec<f64>,
    /// Numbers of cameras, the first ones of the configuration; all of them when empty.
    #[serde(default)]
    pub cameras: Vec<usize>,
    /// Seeds of the random numbers.
    #[serde(default = "one_seed")]
    pub seeds: Vec<u64>,
    /// Methods by name; the configuration's own `[reconstruction]` when empty.
    #[serde(default)]
    pub methods: Vec<String>,
    /// Depths of single particles from camera 1's focal plane, in mm ([`Measure::Elongation`]).
    #[serde(default)]
    pub depths_mm: Vec<f64>,
    /// Single particles at random places instead ([`Measure::Elongation`]).
    #[serde(default)]
    pub random: Option<RandomPlaces>,
    /// Times that the whole process is run ([`Measure::Process`]); the median is reported.
    #[serde(default = "one")]
    pub repeats: usize,
    /// Shots per second that are tried ([`Measure::Loopback`]); the configuration's when empty.
    #[serde(default)]
    pub rates_hz: Vec<f64>,
    /// Plane waves that take the place of the configuration's flow one after the other
    /// ([`Measure::Velocity`]).
    #[serde(default)]
    pub sweep: Option<Sweep>,
    /// How the cameras are calibrated for the reconstruction.
    #[serde(default)]
    pub calibration: Calibration,
    /// The card of calibrations by command, relative to the suite's folder.
    #[serde(default)]
    pub card: Option<PathBuf>,
    /// Whether the program must refuse to measure this bench: no vector may be valid.
    #[serde(default)]
    pub refused: bool,
    /// What this case may cost beside another of the same set.
    #[serde(default)]
    pub beside: Option<Beside>,
    /// Figures that show this case.
    #[serde(default)]
    pub figures: Vec<Figure>,
    /// Bars that this case is held against.
    #[serde(default)]
    pub bars: Vec<Bar>,
    /// What README says of this case.
    #[serde(rename = "claim", default)]
    pub claims: Vec<Claim>,
}

/// Transverse plane waves, every length with every amplitude along every direction.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sweep {
    /// Wavelengths, in voxels.
    pub wavelengths_vox: Vec<f64>,
    /// Amplitudes of the displacement, in voxels.
    pub amplitudes_vox: Vec<f64>,
    /// Directions in which the phase grows, and of the displacement, of any length.
    pub directions: Vec<[[f64; 3]; 2]>,
}

/// Calibration of the cameras that a reconstruction is given.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Calibration {
    /// Nothing.
    #[default]
    None,
    /// Everything in which the simulated cameras are not as drawn, from their own rays.
    TrueMap,
    /// What this program's own commands find in simulated white, dark and card images.
    Commands,
    /// The same without a card: where micro-images are, and nothing of the volume.
    GridAlone,
}

/// What a case may cost beside another one of the same run, at every seeding density of both: medians
/// of the seconds, means of the errors.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Beside {
    /// The other case.
    pub case: String,
    /// How many times its error.
    pub error: f64,
    /// How many times its seconds.
    pub seconds: f64,
    /// What the error is held against instead of the other case's: of the same seeds by the
    /// voxelwise model, in voxels, mean over the components, for each density.
    #[serde(default)]
    pub exact_error_vox: Vec<f64>,
    /// How far from 68 and 95 the per cent of vectors may be that lie within their stated intervals.
    #[serde(default)]
    pub intervals_within: Option<f64>,
}

/// What README says of a case with two cameras at one seeding density, the case's first method. The
/// report holds what it measures against it, and the tests what they do: see [`Claim::MARGIN`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Claim {
    /// Particles per microlens.
    pub ppm: f64,
    /// Mean |error| along x, y, z, in voxels.
    pub error_vox: [f64; 3],
    /// The same of the true particles, windows only.
    pub true_windows_vox: [f64; 3],
    /// The same of the true particles, tracked.
    pub true_followed_vox: [f64; 3],
}

impl Claim {
    /// How many times the claimed error may be measured: mean errors scatter by a tenth from scene to
    /// scene.
    pub const MARGIN: f64 = 1.3;
}

/// Random places of single particles.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RandomPlaces {
    /// How many.
    pub positions: usize,
    /// Edges (x, y, z) of the box about the origin that they lie in, in mm.
    pub within_mm: [f64; 3],
}

/// What is measured on a case.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Measure {
    /// Four images to vectors, in this process: error beside that of the true particles, seconds by
    /// stage.
    Velocity,
    /// Four images to particles placed in them: how many are found, how many are false, and how well they
    /// are known.
    Particles,
    /// One frame to a volume: Q and seconds of the solver, its start counted.
    Volume,
    /// Q and ε after every pass of a solver of the SART family.
    Convergence,
    /// Single particles: width and place of what is reconstructed.
    Elongation,
    /// `lfpiv process` as a process of its own: seconds and peak memory.
    Process,
    /// Bytes of the explicit weight matrix, whole and by ordered subsets.
    Matrix,
    /// Frames of both cameras over GigE Vision to this program's drivers, triggered over serial.
    Loopback,
}

/// A figure of the report.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Figure {
    /// Error against seconds, the Pareto front marked.
    ErrorSeconds,
    /// Q against seconds, the Pareto front marked.
    QualitySeconds,
    /// Q against seeding density (paper, Fig. 12).
    QualityPpm,
    /// Q and ε against iterations, acceleration at Q = 0.75 (paper, Figs. 4 and 13).
    Convergence,
    /// A reconstructed volume projected along x (paper, Figs. 9 and 11).
    Projection,
    /// Width of single particles against depth (paper, Fig. 10).
    Elongation,
    /// Vorticity iso-surface and central slices (paper, Figs. 14 to 16).
    Vortex,
    /// Mean displacement error against seeding density (paper, Fig. 17).
    ErrorPpm,
    /// Cumulative distribution of the displacement error (paper, Fig. 18).
    Cumulative,
    /// Time and memory against the number of voxels.
    Growth,
    /// What each part of the forward model costs and buys: the first such case has all of them.
    ModelParts,
    /// What a bench that is not as drawn costs: the first such case is the bench as drawn.
    ImperfectBench,
    /// Flows with small scales: error at the vectors and between them, and whether intervals hold.
    RoughFlows,
    /// What of a plane wave is measured, against its length.
    Gain,
    /// A bench that is not as drawn, calibrated: the first such case has the true map.
    Calibration,
}

/// A demand on the program, each with its row in the report's first table.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Bar {
    /// Four raw images to velocity at 1 ppm: seconds and error.
    #[serde(rename = "process-1-ppm")]
    Process1Ppm,
    /// The same at 0.3 ppm.
    #[serde(rename = "process-0.3-ppm")]
    Process03Ppm,
    /// Error of the true particles by windows alone.
    TrueParticles,
    /// OS-SART against SART at Q = 0.75.
    Acceleration,
    /// The fast solver against OS-SART at its final Q.
    AgainstOsSart,
    /// Peak memory of the whole process on 100³ voxels.
    Memory,
    /// Growth of time and memory with the volume.
    Growth,
    /// The paper's ring vortex at 1 ppm.
    #[serde(rename = "ring-1-ppm")]
    Ring1Ppm,
    /// The paper's ring vortex at 1.6 ppm.
    #[serde(rename = "ring-1.6-ppm")]
    Ring16Ppm,
    /// Width of a particle on a voxel centre.
    ElongationOnGrid,
    /// Width and centroid of particles anywhere.
    ElongationOffGrid,
    /// OS-SART beside OS-MART: seconds and error of a pair.
    OsSartPair,
    /// OS-SART: memory of the whole process.
    OsSartMemory,
    /// OS-SART beside OS-MART: seconds to a good Q, particles on voxel centres.
    OsSartOnGrid,
}

fn one_seed() -> Vec<u64> {
    vec![1]
}

fn one() -> usize {
    1
}

impl Suite {
    /// Reads a suite.
    ///
    /// # Errors
    /// The file cannot be read or understood, or a case names a method that is not declared.
    pub fn load(path: &Path) -> Result<Self, BenchmarkError> {
        let text = read_or_shipped(path)
            .map_err(|reason| BenchmarkError::Unreadable { path: path.into(), reason })?;
        let mut suite: Self = toml::from_str(&text).map_err(|error| BenchmarkError::Malformed {
            path: path.into(),
            reason: error.to_string(),
        })?;
        suite.folder = path.parent().unwrap_or(Path::new(".")).to_owned();
        for case in &suite.cases {
            suite.methods_of(case)?;
        }
        Ok(suite)
    }

    /// Leaves only the cases of these sets; all of them when none is named.
    ///
    /// # Errors
    /// A set that no case belongs to.
    pub fn select(&mut self, sets: &[String]) -> Result<(), BenchmarkError> {
        if let Some(set) = sets.iter().find(|set| self.cases.iter().all(|case| case.set != **set)) {
            let mut known: Vec<&str> = self.cases.iter().map(|case| case.set.as_str()).collect();
            known.dedup();
            return Err(BenchmarkError::UnknownSet { set: set.clone(), known: known.join(", ") });
        }
        self.cases.retain(|case| sets.is_empty() || sets.contains(&case.set));
        Ok(())
    }

    /// The methods of a case; `None` stands for the configuration's own settings.
    pub(super) fn methods_of(&self, case: &Case) -> Result<Vec<Option<&Method>>, BenchmarkError> {
        if case.methods.is_empty() {
            return Ok(vec![None]);
        }
        let declared = |name: &String| {
            let method = self.methods.iter().find(|method| method.name == *name);
            method.map(Some).ok_or_else(|| BenchmarkError::UnknownMethod {
                case: case.name.clone(),
                method: name.clone(),
            })
        };
        case.methods.iter().map(declared).collect()
    }

    /// A method's name in figures.
    pub fn label_of(&self, method: &str) -> String {
        let as_configured = || method.replace(AS_CONFIGURED, "as configured");
        self.method(method).map_or_else(as_configured, |declared| declared.label.clone())
    }

    /// The solver of a declared method.
    pub fn solver_of(&self, method: &str) -> Option<Solver> {
        Some(self.method(method)?.reconstruction.solver)
    }

    fn method(&self, name: &str) -> Option<&Method> {
        self.methods.iter().find(|declared| declared.name == name)
    }

    /// What README says of a case.
    pub fn claim(&self, case: &str, ppm: f64) -> Option<&Claim> {
        let case = self.cases.iter().find(|declared| declared.name == case)?;
        case.claims.iter().find(|claim| claim.ppm == ppm)
    }

    /// The cases that a figure shows.
    pub fn shown_in(&self, figure: Figure) -> impl Iterator<Item = &Case> {
        self.cases.iter().filter(move |case| case.figures.contains(&figure))
    }

    /// The cases held against a bar.
    pub fn held_against(&self, bar: Bar) -> impl Iterator<Item = &Case> {
        self.cases.iter().filter(move |case| case.bars.contains(&bar))
    }
}
