//! One image pair to one velocity field.

use std::time::Instant;

use lfpiv_hw::{Optics, Pose, RawImage};
use thiserror::Error;

use crate::{
    lightfield::{
        Background, Condensation, ImageSettings, LightLevels, PhotometricZones, StationaryLight,
        ViewStack,
    },
    model::{ModelError, VolumeGrid},
    pipeline::{ImagePair, PairResult, StageSeconds, plan::Plan},
    reconstruction::{
        DenseVolume, ReconstructionSettings, Reconstructor, SparseVolume, ViewLevels,
    },
    velocimetry::{Interrogation, PointCloud, VelocimetrySettings},
};

/// Everything that turns image pairs into vectors.
#[derive(Debug, Clone, PartialEq)]
pub struct Measurement {
    /// The optics that all cameras share.
    pub optics: Optics,
    /// Where the cameras stand.
    pub cameras: Vec<Pose>,
    /// The measurement volume.
    pub volume: VolumeGrid,
    /// What is known about the images.
    pub image: ImageSettings,
    /// How volumes are reconstructed.
    pub reconstruction: ReconstructionSettings,
    /// How volumes are correlated.
    pub velocimetry: VelocimetrySettings,
    /// Time between the frames, in s.
    pub dt_s: f64,
}

/// Why a measurement cannot be set up.
#[derive(Debug, Error)]
pub enum SetupError {
    /// The optics cannot see the volume.
    #[error(transparent)]
    Model(#[from] ModelError),
}

/// Why a pair gave no result.
#[derive(Debug, Error, PartialEq)]
pub enum ProcessError {
    /// Not one pair of images per configured camera.
    #[error("the pair holds images of {found} cameras, the configuration has {expected}")]
    CameraCount { expected: usize, found: usize },
    /// An image that does not match the sensor.
    #[error(
        "camera {camera}, frame {frame}: the image has {columns} x {rows} pixels, the configured \
         sensor {expected_columns} x {expected_rows}; correct [optics.sensor] or use images of \
         this camera"
    )]
    ImageSize {
        camera: usize,
        frame: char,
        columns: usize,
        rows: usize,
        expected_columns: usize,
        expected_rows: usize,
    },
}

/// A camera sees nothing when no more of its lit pixels than this are brighter than noise: less
/// than one particle on the bench's sensor, or the hot pixels of a good one.
const DARK_BRIGHT_SHARE: f64 = 5e-5;

/// Without bright pixels, this share of saturated ones tells too much light from none.
const OVEREXPOSED_SHARE: f64 = 0.5;

/// Saturated pixels beyond this share are worth a warning.
const SATURATED_SHARE: f64 = 1e-3;

/// Tables and plans that are made once and used for every pair. Shared between workers.
pub struct Processor {
    measurement: Measurement,
    reconstructor: Reconstructor,
    zones: PhotometricZones,
    interrogation: Interrogation,
    /// Per camera and frame, where stationary light has been learned.
    stationary: Vec<[StationaryLight; 2]>,
}

/// One frame of all cameras, cut into views.
struct Frame {
    views: Vec<ViewStack>,
    levels: Vec<ViewLevels>,
    warnings: Vec<String>,
    /// Whether every camera sees light.
    lit: bool,
}

impl Processor {
    /// Builds the tables. Errors when a camera does not see the volume.
    pub fn new(measurement: Measurement) -> Result<Self, SetupError> {
        let Measurement { optics, cameras, volume, reconstruction, velocimetry, .. } = &measurement;
        // Light that crosses a face between the frames must have voxels on both sides of it.
        let margin = (velocimetry.max_displacement_vox / 2.0).ceil() as usize + 1;
        let reconstructor =
            Reconstructor::new(optics, cameras, &volume.padded(margin), reconstruction)?;
        let layout = &reconstructor.layouts()[0];
        let zones = PhotometricZones::new(optics, &layout.columns, &layout.rows);
        let interrogation = Interrogation::new(volume, margin, velocimetry);
        Ok(Self { measurement, reconstructor, zones, interrogation, stationary: Vec::new() })
    }

    /// What is measured and how.
    pub fn measurement(&self) -> &Measurement {
        &self.measurement
    }

    /// The windows that volumes are correlated with.
    pub fn interrogation(&self) -> &Interrogation {
        &self.interrogation
    }

    /// What will be done with each pair.
    pub fn plan(&self) -> Plan {
        Plan::new(&self.measurement, &self.reconstructor, &self.interrogation)
    }

    /// Takes a pair into account for the removal of stationary light, where the configuration
    /// asks for it. To be called with the pairs of a run before they are processed.
    pub fn learn_background(&mut self, pair: &ImagePair) -> Result<(), ProcessError> {
        self.check(pair)?;
        let condensation = match self.measurement.image.background {
            Background::Constant => return Ok(()),
            Background::Minimum => Condensation::Minimum,
            Background::Mean | Background::Images => Condensation::Mean,
        };
        if self.stationary.is_empty() {
            let start = |frames: &[RawImage; 2]| {
                frames.each_ref().map(|image| StationaryLight::new(condensation, image))
            };
            self.stationary = pair.cameras.iter().map(start).collect();
        } else {
            for (lights, frames) in self.stationary.iter_mut().zip(&pair.cameras) {
                for (light, image) in lights.iter_mut().zip(frames) {
                    light.learn(image);
                }
            }
        }
        Ok(())
    }

    /// Measures one pair.
    pub fn process(&self, pair: &ImagePair) -> Result<PairResult, ProcessError> {
        self.measure(pair).map(|(result, _)| result)
    }

    /// Measures one pair and hands out the volumes of frames a and b, on the configured grid.
    pub fn process_with_volumes(
        &self,
        pair: &ImagePair,
    ) -> Result<(PairResult, [DenseVolume; 2]), ProcessError> {
        let (result, volumes) = self.measure(pair)?;
        let volumes = volumes.map(|volume| volume.on_grid(&self.measurement.volume));
        Ok((result, volumes))
    }

    fn measure(&self, pair: &ImagePair) -> Result<(PairResult, [SparseVolume; 2]), ProcessError> {
        self.check(pair)?;
        let started = Instant::now();
        let (a, b) = rayon::join(|| self.decode(pair, 0), || self.decode(pair, 1));
        let decode_s = started.elapsed().as_secs_f64();

        let started = Instant::now();
        let solve = |frame: &Frame| self.reconstructor.reconstruct(&frame.views, &frame.levels);
        let (solved_a, solved_b) = rayon::join(|| solve(&a), || solve(&b));
        let (volume_a, volume_b) = (solved_a.volume, solved_b.volume);
        let reconstruct_s = started.elapsed().as_secs_f64();

        let started = Instant::now();
        let grid = self.interrogation.cloud_grid();
        let cloud = |volume| PointCloud::from_volume(volume, &grid);
        let mut field =
            self.interrogation.measure(&cloud(&volume_a), &cloud(&volume_b), self.measurement.dt_s);
        let correlate_s = started.elapsed().as_secs_f64();

        let lit = a.lit && b.lit;
        let mut warnings: Vec<String> = a.warnings.into_iter().chain(b.warnings).collect();
        if !lit {
            field.invalidate(self.measurement.velocimetry.max_displacement_vox);
        } else if volume_a.voxels.is_empty() || volume_b.voxels.is_empty() {
            warnings.push(
                "no voxel is lit in all views: check the camera poses and that both cameras see \
                 the same volume"
                    .to_owned(),
            );
        }
        let seconds = StageSeconds { decode_s, reconstruct_s, correlate_s };
        Ok((PairResult { field, seconds, warnings }, [volume_a, volume_b]))
    }

    fn check(&self, pair: &ImagePair) -> Result<(), ProcessError> {
        let expected = self.measurement.cameras.len();
        if pair.cameras.len() != expected {
            return Err(ProcessError::CameraCount { expected, found: pair.cameras.len() });
        }
        let sensor = &self.measurement.optics.sensor;
        for (camera, frames) in pair.cameras.iter().enumerate() {
            for (image, frame) in frames.iter().zip(['a', 'b']) {
                if (image.columns(), image.rows()) != (sensor.columns, sensor.rows) {
                    return Err(ProcessError::ImageSize {
                        camera: camera + 1,
                        frame,
                        columns: image.columns(),
                        rows: image.rows(),
                        expected_columns: sensor.columns,
                        expected_rows: sensor.rows,
                    });
                }
            }
        }
        Ok(())
    }

    fn decode(&self, pair: &ImagePair, frame: usize) -> Frame {
        let mut decoded =
            Frame { views: Vec::new(), levels: Vec::new(), warnings: Vec::new(), lit: true };
        for (camera, layout) in self.reconstructor.layouts().iter().enumerate() {
            let raw = &pair.cameras[camera][frame];
            let corrected;
            let mut settings = self.measurement.image.clone();
            let image = match self.stationary.get(camera) {
                None => raw,
                Some(lights) => {
                    settings.offset_counts = None;
                    corrected = lights[frame].remove_from(raw);
                    &corrected
                }
            };
            let levels = self.zones.levels(image, &settings);
            let black = (levels.offset_counts + levels.background_counts) as f32;
            let views = layout.decode(image, |_, _, count| f32::from(count) - black);
            let name = format!("camera {}, frame {}", camera + 1, ['a', 'b'][frame]);
            decoded.judge(&name, &levels);
            decoded.levels.push(ViewLevels::of(&views, levels.noise_counts));
            decoded.views.push(views);
        }
        decoded
    }
}

impl Frame {
    /// Notes what the light levels of an image say about its use.
    fn judge(&mut self, name: &str, levels: &LightLevels) {
        let dark = levels.bright_share <= DARK_BRIGHT_SHARE;
        self.lit &= !dark;
        if dark && levels.saturated_share > OVEREXPOSED_SHARE {
            self.warnings.push(format!(
                "{name}: {:.0} % of the lit pixels are saturated at {} counts and no particle \
                 stands out; every vector is marked invalid. Reduce gain or laser energy",
                100.0 * levels.saturated_share,
                levels.saturation_counts.unwrap_or(u16::MAX)
            ));
        } else if dark {
            self.warnings.push(format!(
                "{name}: no particle above the noise; every vector is marked invalid. Check laser, \
                 seeding and lens cap"
            ));
        } else if levels.saturated_share > SATURATED_SHARE {
            self.warnings.push(format!(
                "{name}: {:.1} % of the lit pixels are saturated at {} counts; reduce gain or \
                 laser energy",
                100.0 * levels.saturated_share,
                levels.saturation_counts.unwrap_or(u16::MAX)
            ));
        }
    }
}
