//! The simulated scene: the `[simulation]` table of the configuration.

mod card;
mod lighting;
mod pulses;
mod white;

use garde::Validate;
use lfpiv_hw::{RawImage, check::finite};
use serde::{Deserialize, Serialize};
use thiserror::Error;

use crate::{
    flow::{Flow, SampledFlowError},
    geometry::BenchGeometry,
    imaging::{CameraFlaws, ElectronImage, PointSource, RaySettings, RayTracer},
    particles::{FrameOfPair, Placement, Seeding, Tracer},
    sensor::SensorSettings,
};

pub use card::CardErrors;
pub use lighting::Lighting;
pub use pulses::LightPulse;

/// Largest number of particles in a shot: ten million take minutes and about a gigabyte.
pub const PARTICLE_LIMIT: f64 = 1e7;

/// Why a scene cannot be simulated.
#[derive(Debug, Clone, PartialEq, Error)]
pub enum SceneError {
    /// ppm, light sheet and volume together give too many particles.
    #[error(
        "ppm, sheet_mm and the volume give {particles:.0} particles: allowed: at most \
         {PARTICLE_LIMIT:.0}"
    )]
    TooManyParticles { particles: f64 },
    /// A stop or an aperture at the microlenses or behind them.
    #[error(
        "simulation.camera[{camera}].{key} = {behind_lens_mm}: allowed: less than the image \
         distance, {image_distance_mm} mm, so that light passes it before the microlenses"
    )]
    BehindMicrolenses {
        camera: usize,
        key: &'static str,
        behind_lens_mm: f64,
        image_distance_mm: f64,
    },
    /// A wall among the particles, or behind the lens.
    #[error(
        "simulation.camera[{camera}].wall: allowed: a wall between the whole light sheet and the \
         lens; change its distance_mm, thickness_mm or tilt_deg"
    )]
    WallElsewhere { camera: usize },
    /// A flow without samples.
    #[error("simulation.flow.file: {0}")]
    Flow(#[from] SampledFlowError),
}

/// Flow, particles, light and sensor of a simulated run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct Scene {
    /// Particles per microlens (ppm): 1 over 100 × 100 microlenses is 10,000 particles inside
    /// the measurement volume.
    #[garde(custom(finite), range(min = 0.0, max = 20.0))]
    pub ppm: f64,
    /// Whether particles are anywhere (`off-grid`) or at voxel centres (`on-grid`).
    #[garde(skip)]
    pub placement: Placement,
    /// Half-width s of the uniform distribution of relative brightness on [1 − s, 1 + s].
    #[garde(custom(finite), range(min = 0.0, max = 1.0))]
    pub intensity_spread: f64,
    /// Edge lengths (x, y, z) of the sharp-edged light sheet, centred on the volume, in mm;
    /// default: those of the volume. Other sizes have the same number density.
    #[garde(inner(inner(custom(finite), range(min = 0.01, max = 1000.0))))]
    pub sheet_mm: Option<[f64; 3]>,
    /// Whether particles are also where the bench has none, such as in what `[volume] mask` leaves out: the
    /// surroundings of a region of interest have some, a body has none.
    #[garde(skip)]
    pub particles_in_mask: bool,
    /// Default seed of a run.
    #[garde(skip)]
    pub seed: u64,
    /// Displacement of each camera from its pose (x, y, z of the world), in mm, in the order of the
    /// cameras: a calibration error that is unknown to the reconstruction. Cameras that are not
    /// listed are at their poses.
    #[garde(inner(inner(custom(finite), range(min = -10.0, max = 10.0))))]
    pub camera_shift_mm: Vec<[f64; 3]>,
    /// Photo-electrons that a particle of mean brightness releases per exposure if no ray is lost.
    /// In focus they are spread over about 256 pixels of the bench's cameras.
    #[garde(custom(finite), range(min = 0.0, max = 1e9))]
    pub particle_photoelectrons: f64,
    /// Differences of light between frames and cameras.
    #[garde(dive)]
    pub lighting: Lighting,
    /// Deviations of each camera, in the order of the cameras; cameras that are not listed are
    /// perfect.
    #[garde(dive)]
    pub camera: Vec<CameraFlaws>,
    /// Deviations of a calibration card from its file.
    #[garde(dive)]
    pub card: CardErrors,
    /// Rays per particle and frame, rounded up to a square number. White images and images of a
    /// card have 8 times as many per microlens.
    #[garde(range(min = 1, max = 4_000_000))]
    pub rays_per_particle: usize,
    /// Whether light is spread by diffraction at the main lens and at the microlenses.
    #[garde(skip)]
    pub diffraction: bool,
    /// Wavelength of the laser, in nm; only diffraction depends on it.
    #[garde(custom(finite), range(min = 100.0, max = 2000.0))]
    pub wavelength_nm: f64,
    /// The flow that carries the particles.
    #[garde(dive)]
    pub flow: Flow,
    /// Conversion of light into counts.
    #[garde(dive)]
    pub sensor: SensorSettings,
}

impl Default for Scene {
    fn default() -> Self {
        Self {
            ppm: 1.0,
            placement: Placement::OffGrid,
            intensity_spread: 0.2,
            sheet_mm: None,
            particles_in_mask: false,
            seed: 1,
            camera_shift_mm: Vec::new(),
            particle_photoelectrons: 100_000.0,
            lighting: Lighting::default(),
            camera: Vec::new(),
            card: CardErrors::default(),
            rays_per_particle: 4096,
            diffraction: false,
            wavelength_nm: 532.0,
            flow: Flow::default(),
            sensor: SensorSettings::default(),
        }
    }
}

/// The images of one shot and the true particles.
#[derive(Debug, Clone, PartialEq)]
pub struct SimulatedShot {
    /// Exposures 1 and 2 of every camera, in the order of the poses.
    pub images: Vec<[RawImage; 2]>,
    /// The particles in the images.
    pub truth: Truth,
}

/// The true content of a simulated shot.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Truth {
    /// Seed of the run.
    pub seed: u64,
    /// Number of the shot in the run.
    pub shot: u64,
    /// Time between the pulses, in s.
    pub dt_s: f64,
    /// The velocity field.
    pub flow: Flow,
    /// All particles that are lit in at least one frame.
    pub particles: Vec<Tracer>,
}

impl Scene {
    /// Checks whether this scene can be simulated on `bench`. Call it once before requesting shots.
    ///
    /// Errors: more particles than [`PARTICLE_LIMIT`]; an impossible position of a stop, an
    /// aperture or a wall; a flow whose samples cannot be read.
    pub fn check(&self, bench: &BenchGeometry) -> Result<(), SceneError> {
        self.flow.load()?;
        let particles = self.seeding(bench).drawn(
            &bench.volume,
            bench.object_pitch_mm(),
            &self.flow,
            bench.dt_s,
        );
        if particles > PARTICLE_LIMIT {
            return Err(SceneError::TooManyParticles { particles });
        }
        (0..bench.poses.len()).try_for_each(|camera| self.check_camera(bench, camera))
    }

    fn check_camera(&self, bench: &BenchGeometry, camera: usize) -> Result<(), SceneError> {
        let (flaws, image_distance_mm) = (self.flaws(camera), bench.optics.image_distance_mm());
        let second_mm = flaws.vignetting.as_ref().map_or(0.0, |aperture| aperture.behind_lens_mm);
        for (key, behind_lens_mm) in
            [("exit_pupil_mm", flaws.exit_pupil_mm), ("vignetting.behind_lens_mm", second_mm)]
        {
            if behind_lens_mm >= image_distance_mm {
                return Err(SceneError::BehindMicrolenses {
                    camera,
                    key,
                    behind_lens_mm,
                    image_distance_mm,
                });
            }
        }
        let tracer = self.tracer(bench, camera);
        let extents_mm = self.sheet_mm.unwrap_or(bench.volume.extents_mm());
        let corner_mm = |corner: usize| {
            std::array::from_fn(|axis| {
                let side = if corner >> axis & 1 == 0 { -0.5 } else { 0.5 };
                bench.volume.centre_mm[axis] + side * extents_mm[axis]
            })
        };
        let seen = |corner| tracer.as_ref()?.on_microlenses_mm(corner_mm(corner), [0.0; 2]);
        if flaws.wall.is_some() && (0..8).any(|corner| seen(corner).is_none()) {
            return Err(SceneError::WallElsewhere { camera });
        }
        Ok(())
    }

    /// The particles of one shot, without images.
    pub fn truth(&self, bench: &BenchGeometry, seed: u64, shot: u64) -> Truth {
        let flow = self.flow.of_shot(seed, shot);
        let particles = self.seeding(bench).particles(
            &bench.volume,
            bench.object_pitch_mm(),
            &flow,
            bench.dt_s,
            (seed, shot),
        );
        Truth { seed, shot, dt_s: bench.dt_s, flow, particles }
    }

    /// One shot as recorded by all cameras. Equal scene, bench, seed and shot give equal results
    /// for any number of threads.
    pub fn shot(&self, bench: &BenchGeometry, seed: u64, shot: u64) -> SimulatedShot {
        let truth = self.truth(bench, seed, shot);
        let images = (0..bench.poses.len())
            .map(|camera| {
                [FrameOfPair::A, FrameOfPair::B].map(|frame| {
                    let light = self.light(bench, &truth, camera, frame);
                    self.sensor_of(camera).expose(&light, &stream_key(&truth, camera, frame))
                })
            })
            .collect();
        SimulatedShot { images, truth }
    }

    /// The light on one camera's sensor in one frame, without background and noise.
    pub fn light(
        &self,
        bench: &BenchGeometry,
        truth: &Truth,
        camera: usize,
        frame: FrameOfPair,
    ) -> ElectronImage {
        let Some(tracer) = self.tracer(bench, camera) else {
            return ElectronImage::dark(&bench.optics);
        };
        let key = stream_key(truth, camera, frame);
        tracer.trace(&self.sources(&truth.particles, frame, key), &key)
    }

    /// The ray tracer of a camera with its deviations; `None` if the bench has no such camera. It
    /// gives the positions of rays on the microlens plane and the true micro-image grid.
    pub fn tracer<'a>(&self, bench: &'a BenchGeometry, camera: usize) -> Option<RayTracer<'a>> {
        let pose = bench.poses.get(camera)?;
        let shift_mm = self.camera_shift_mm.get(camera).copied().unwrap_or_default();
        let flaws = self.flaws(camera);
        Some(RayTracer::imperfect(&bench.optics, pose, shift_mm, &flaws, &self.rays()))
    }

    /// Deviations of a camera.
    fn flaws(&self, camera: usize) -> CameraFlaws {
        self.camera.get(camera).cloned().unwrap_or_default()
    }

    /// Sensor settings of a camera, with its own gain.
    fn sensor_of(&self, camera: usize) -> SensorSettings {
        let gain = self.sensor.gain_counts_per_electron * self.flaws(camera).gain;
        SensorSettings { gain_counts_per_electron: gain, ..self.sensor.clone() }
    }

    fn rays(&self) -> RaySettings {
        RaySettings {
            rays_per_particle: self.rays_per_particle,
            diffraction_nm: self.diffraction.then_some(self.wavelength_nm),
        }
    }

    fn seeding(&self, bench: &BenchGeometry) -> Seeding {
        Seeding {
            ppm: self.ppm,
            placement: self.placement,
            intensity_spread: self.intensity_spread,
            sheet_mm: self.sheet_mm,
            empty: bench.empty.clone().filter(|_| !self.particles_in_mask),
        }
    }

    fn sources(
        &self,
        particles: &[Tracer],
        frame: FrameOfPair,
        exposure: [u64; 4],
    ) -> Vec<PointSource> {
        let lit = particles.iter().zip(0..).filter_map(|(particle, id)| {
            let electrons = self.electrons(particle, id, exposure);
            let position_mm = particle.lit_mm(frame)?;
            Some(PointSource { id, position_mm, electrons })
        });
        lit.collect()
    }

    /// Photo-electrons that a particle releases in the exposure `[seed, shot, camera, frame]` if no
    /// ray is lost.
    fn electrons(&self, particle: &Tracer, id: u64, exposure: [u64; 4]) -> f64 {
        particle.intensity * self.particle_photoelectrons * self.lighting.factor(exposure, id)
    }
}

/// Key of the random streams of one exposure.
fn stream_key(truth: &Truth, camera: usize, frame: FrameOfPair) -> [u64; 4] {
    [truth.seed, truth.shot, camera as u64, frame as u64]
}

#[cfg(test)]
mod tests;
