//! One image pair to one velocity field.

use std::{borrow::Borrow, sync::OnceLock};

use lfpiv_hw::{CameraName, RawImage};
use thiserror::Error;

use crate::{
    Clock,
    clock::{seconds_since, untimed},
    lightfield::{Background, Condensation, ImagePair, PhotometricZones, StationaryLight},
    measurement::{
        fitted::Models,
        frame::{Correction, Frame},
        model_fit,
        placed::{PairForPlacing, measured_particles, point_cameras, positions, samples},
        plan::Plan,
        setup::{Measurement, SetupError},
    },
    model::{ModelError, PointCamera, VolumeGrid},
    particles::PlacedParticles,
    reconstruction::{DenseVolume, FitVerdict, FrameLight, ModelFit, SparseVolume},
    velocimetry::{
        CorrectedField, DisplacementField, Interrogation, MeasuredParticle, PairResult, Placing,
        PointCloud, StageSeconds, VelocityField,
    },
};

/// Why a pair gave no result.
#[derive(Debug, Error, PartialEq)]
pub enum ProcessError {
    /// Cameras that cannot be modelled.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// Not one pair of images per configured camera.
    #[error("the pair holds images of {found} cameras, the configuration has {expected}")]
    CameraCount { expected: usize, found: usize },
    /// An image that does not match the sensor.
    #[error(
        "{camera}, frame {frame}: the image has {columns} x {rows} pixels, the configured \
         sensor {expected_columns} x {expected_rows}; correct [optics.sensor] or use images of \
         this camera"
    )]
    ImageSize {
        camera: CameraName,
        frame: char,
        columns: usize,
        rows: usize,
        expected_columns: usize,
        expected_rows: usize,
    },
}

/// Tables and plans that are made once and used for every pair. Shared between workers.
pub struct Processor {
    measurement: Measurement,
    models: Models,
    clock: Clock,
    /// Per camera.
    zones: Vec<PhotometricZones>,
    interrogation: Interrogation,
    /// Set by the first pair whose particles are placed.
    point_cameras: OnceLock<Vec<PointCamera>>,
    /// Per camera and frame, where stationary light has been learned.
    stationary: Vec<[StationaryLight; 2]>,
}

/// A pair's vectors and what they come from.
struct Measured {
    result: PairResult,
    /// The light of frames a and b.
    volumes: [SparseVolume; 2],
    /// The field behind the vectors by correlation.
    everywhere: DisplacementField,
    /// The particles in the images, where the field follows them.
    placed: Option<PlacedParticles>,
}

/// A field through placed particles.
struct ThroughParticles {
    field: VelocityField,
    /// For the result, in the order of `placed.pairs`.
    particles: Vec<MeasuredParticle>,
    placed: PlacedParticles,
}

impl Processor {
    /// Builds the tables. Errors when a camera does not see the volume.
    pub fn new(measurement: Measurement) -> Result<Self, SetupError> {
        Self::timed(measurement, untimed)
    }

    /// [`Self::new`] with a clock that the stages of every pair are timed by.
    ///
    /// # Errors
    /// A camera does not see the volume.
    pub fn timed(measurement: Measurement, clock: Clock) -> Result<Self, SetupError> {
        let Measurement { optics, volume, mask, velocimetry, spacing_mm, .. } = &measurement;
        let margin = velocimetry.margin_vox();
        let models = Models::new(&measurement, margin, clock)?;
        let layouts = models.configured().reconstructor.layouts();
        let zones = layouts.iter().map(|layout| PhotometricZones::of(optics, layout)).collect();
        let interrogation =
            Interrogation::new(volume, margin, velocimetry).with_spacing_mm(*spacing_mm);
        let interrogation = interrogation.with_mask(mask.clone());
        Ok(Self {
            measurement,
            models,
            clock,
            zones,
            interrogation,
            point_cameras: OnceLock::new(),
            stationary: Vec::new(),
        })
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
        Plan::new(&self.measurement, self.models.configured(), &self.interrogation)
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

    /// Measures one pair. A pair that is handed over is dropped as soon as it is decoded, unless particles may
    /// be placed in its images: on large sensors these are the largest part of the memory.
    pub fn process(&self, pair: impl Borrow<ImagePair>) -> Result<PairResult, ProcessError> {
        self.measure(pair).map(|measured| measured.result)
    }

    /// Measures one pair and keeps the light of both frames beside the vectors, to look at.
    ///
    /// # Errors
    /// [`ProcessError`]: images that do not fit the configuration.
    pub fn process_with_light(
        &self,
        pair: impl Borrow<ImagePair>,
    ) -> Result<PairResult, ProcessError> {
        let Measured { mut result, volumes: [a, b], .. } = self.measure(pair)?;
        let grid = &self.measurement.volume;
        let (a, b) = rayon::join(|| FrameLight::new(&a, grid), || FrameLight::new(&b, grid));
        result.light = Some([a, b]);
        Ok(result)
    }

    /// Measures one pair and hands out the volumes of frames a and b, on the configured grid.
    pub fn process_with_volumes(
        &self,
        pair: impl Borrow<ImagePair>,
    ) -> Result<(PairResult, [DenseVolume; 2]), ProcessError> {
        let Measured { result, volumes, .. } = self.measure(pair)?;
        let volumes = volumes.map(|volume| volume.on_grid(&self.measurement.volume));
        Ok((result, volumes))
    }

    /// Measures one pair and places its particles in its images.
    ///
    /// # Errors
    /// [`ProcessError`]: images that do not fit the configuration.
    pub fn process_with_particles(
        &self,
        pair: &ImagePair,
    ) -> Result<(PairResult, PlacedParticles), ProcessError> {
        let Measured { result, volumes, everywhere, placed } = self.measure(pair)?;
        let placed = match placed {
            Some(placed) => placed,
            None => self.place(pair, &volumes, &mut self.interrogation.to_correct(&everywhere))?,
        };
        Ok((result, placed))
    }

    /// The particles of a pair whose light is in `volumes`.
    fn place(
        &self,
        pair: &ImagePair,
        volumes: &[SparseVolume; 2],
        field: &mut CorrectedField<'_>,
    ) -> Result<PlacedParticles, ProcessError> {
        let grid = self.interrogation.cloud_grid();
        let found = PairForPlacing {
            cameras: self.point_cameras(&grid)?,
            correction: &self.correction(),
            volumes: volumes.each_ref(),
            grid: &grid,
        };
        Ok(found.place(pair, field))
    }

    /// How the cameras image points of `grid`.
    fn point_cameras(&self, grid: &VolumeGrid) -> Result<&[PointCamera], ModelError> {
        if let Some(cameras) = self.point_cameras.get() {
            return Ok(cameras);
        }
        // Not under the lock of `get_or_init`, as for the models of a run (`Models::fitted`).
        let cameras = point_cameras(&self.measurement, grid)?;
        Ok(self.point_cameras.get_or_init(|| cameras))
    }

    /// Whether particles are placed in a pair's images after correlation gave `field`, which was sampled from
    /// `everywhere`.
    fn is_to_place(&self, field: &VelocityField, everywhere: &DisplacementField) -> bool {
        if self.measurement.velocimetry.place_particles == Placing::Always {
            return true;
        }
        let unresolved = self.interrogation.unresolved(field, everywhere);
        if let Some(unresolved) = unresolved {
            tracing::debug!("particles are placed in the images: {unresolved}");
        }
        unresolved.is_some()
    }

    fn correction(&self) -> Correction<'_> {
        Correction {
            image: &self.measurement.image,
            zones: &self.zones,
            stationary: &self.stationary,
        }
    }

    fn measure(&self, handed: impl Borrow<ImagePair>) -> Result<Measured, ProcessError> {
        let pair = handed.borrow();
        self.check(pair)?;
        let correction = self.correction();
        let fitted = self.models.fitted(&self.measurement, pair, &correction);
        let mut seconds = StageSeconds::default();
        let layouts = fitted.reconstructor.layouts();
        let decode = |frame| Frame::decode(pair, frame, layouts, &correction);
        let (a, b) =
            self.timed_in(&mut seconds.decode_s, || rayon::join(|| decode(0), || decode(1)));
        let (micro_images, identical) = self.timed_in(&mut seconds.judge_s, || {
            let identical: Vec<CameraName> = model_fit::identical_frames(pair).collect();
            (model_fit::micro_images(&self.measurement, pair), identical)
        });
        let Measurement { velocimetry, mask, dt_s, .. } = &self.measurement;
        let kept = velocimetry.may_place(mask.is_some()).then_some(handed);

        let solve = |frame: &Frame| fitted.reconstructor.reconstruct(&frame.views, &frame.levels);
        let (solved_a, solved_b) =
            self.timed_in(&mut seconds.reconstruct_s, || rayon::join(|| solve(&a), || solve(&b)));
        let (mut field, everywhere) = self.timed_in(&mut seconds.correlate_s, || {
            let grid = self.interrogation.cloud_grid();
            let [a, b] =
                [&solved_a, &solved_b].map(|solved| PointCloud::from_volume(&solved.volume, &grid));
            self.interrogation.measure_everywhere(&a, &b, *dt_s)
        });
        let fit = self.timed_in(&mut seconds.judge_s, || {
            let inputs = model_fit::FitInputs {
                measurement: &self.measurement,
                fitted,
                frames: [&a, &b],
                solved: [&solved_a, &solved_b],
                field: &field,
                micro_images,
            };
            inputs.fit()
        });
        let volumes = [solved_a.volume, solved_b.volume];
        let (mut placed, mut particles) = (None, None);
        if fit.verdict == FitVerdict::Poor || !(a.lit && b.lit) {
            field.invalidate(velocimetry.max_displacement_vox);
        } else if let Some(pair) = kept.filter(|_| self.is_to_place(&field, &everywhere)) {
            let through = self.timed_in(&mut seconds.correlate_s, || {
                self.through_particles(pair.borrow(), &volumes, &field, &everywhere)
            })?;
            (field, particles, placed) =
                (through.field, Some(through.particles), Some(through.placed));
        }
        tracing::debug!(
            "model fit {}: {}",
            fit.verdict,
            fit.numbers(self.measurement.optics.object_pitch_mm())
        );
        let result = PairResult {
            field,
            seconds,
            warnings: self.warnings(&fit, [&a, &b], &identical),
            model: fitted.choice.clone(),
            light: None,
            particles,
            fit: Some(fit),
        };
        Ok(Measured { result, volumes, everywhere, placed })
    }

    /// The result of `act`, whose duration is added to `seconds`.
    fn timed_in<T>(&self, seconds: &mut f64, act: impl FnOnce() -> T) -> T {
        let started = (self.clock)();
        let made = act();
        *seconds += seconds_since(self.clock, started);
        made
    }

    /// The field through the particles placed in a pair's images, after correlation gave `field`, which was sampled
    /// from `everywhere`.
    fn through_particles(
        &self,
        pair: &ImagePair,
        volumes: &[SparseVolume; 2],
        field: &VelocityField,
        everywhere: &DisplacementField,
    ) -> Result<ThroughParticles, ProcessError> {
        let grid = self.interrogation.cloud_grid();
        let mut corrected = self.interrogation.to_correct(everywhere);
        let placed = self.place(pair, volumes, &mut corrected)?;
        let samples = samples(&placed.pairs, &grid);
        let positions = positions(&placed, &grid);
        let (field, predictions) =
            self.interrogation.through_placed(field, &corrected, &samples, &positions);
        let particles = measured_particles(&placed.pairs, &predictions, &grid);
        Ok(ThroughParticles { field, particles, placed })
    }

    /// What the reader should know about a pair, the worst first.
    fn warnings(
        &self,
        fit: &ModelFit,
        frames: [&Frame; 2],
        identical: &[CameraName],
    ) -> Vec<String> {
        let mut warnings: Vec<String> =
            fit.warning(self.measurement.optics.object_pitch_mm()).into_iter().collect();
        // Where micro-images are misplaced, nothing that is said of dark or bright pixels is true.
        if warnings.is_empty() || frames.iter().all(|frame| frame.lit) {
            warnings.extend(frames.iter().flat_map(|frame| frame.warnings.iter().cloned()));
        }
        warnings.extend(identical.iter().map(|camera| {
            format!("{camera}: frames a and b are the same image; is one file there twice?")
        }));
        warnings
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
                        camera: CameraName(camera),
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
}
