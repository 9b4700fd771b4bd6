//! The paper's section 5, on a jet whose truth is known: one light-field camera, two of them, and planar PIV side by
//! side.
//!
//! Every shot has a realisation of the jet of its own, which all instruments see, each with particles, light and
//! noise of its own. Their vectors enter the ensemble statistics that a run's do ([`lfpiv_core::ensemble`]); the
//! means and fluctuations of these are held against the jet's own, and against those of the shots that were seen.

mod comparison;
mod figures;
mod files;
mod instruments;
mod line;
mod planar;
mod tally;

use lfpiv::config::Config;
use lfpiv_core::{lightfield::ImagePair, velocimetry::VectorGrid};
use lfpiv_sim::{BenchGeometry, Flow, PlanarScene, Scene, flow::RoundJet};

use crate::BenchmarkError;
use instruments::LightField;
use planar::PlanarInterrogation;
use tally::Tally;

pub use comparison::{Comparison, Difference, Instrument, Profile, ProfilePoint, Region};
pub use files::write;

/// Displacement of the fastest particles, as a share of the windows that look for them (Keane and Adrian 1990).
const QUARTER: f64 = 0.25;

/// Standard deviations of the fluctuations in the fastest particles over the jet's peak.
const FASTEST: f64 = 3.0;

/// Edge of planar PIV's final windows, in pixels, as in the paper.
const PLANAR_WINDOW_PX: usize = 32;

/// What is simulated and measured.
#[derive(Debug, Clone)]
pub struct Validation {
    /// The light-field bench, its cameras, windows and seeding. Flow and pulse separation are set by this.
    pub config: Config,
    /// The planar measurement; its flow is set by this.
    pub planar: PlanarScene,
    /// Edge of planar PIV's first windows, in pixels: 32 times a power of two.
    pub first_window_px: usize,
    /// The flow.
    pub jet: RoundJet,
    /// Seed of particles, noise and fluctuations.
    pub seed: u64,
}

impl Validation {
    /// The paper's measurement with the light-field bench of `config`: planar PIV from windows of 256 pixels on.
    pub fn new(config: Config, seed: u64) -> Self {
        Self {
            config,
            planar: PlanarScene::default(),
            first_window_px: 256,
            jet: RoundJet::default(),
            seed,
        }
    }

    /// Sets up the instruments; nothing is measured yet.
    ///
    /// # Errors
    /// The configuration has no scene, or a light-field measurement cannot be set up.
    pub fn start(&self) -> Result<Running, BenchmarkError> {
        let (config, scene) = self.light_field_bench()?;
        let light_fields = LightField::all(&config)?;
        let planar_scene =
            PlanarScene { flow: Flow::RoundJet(self.jet.clone()), ..self.planar.clone() };
        let planar_dt_s = self.planar_dt_s();
        let planar = PlanarInterrogation::new(
            &planar_scene.camera,
            [self.first_window_px, PLANAR_WINDOW_PX],
            self.fastest_m_s() * planar_dt_s,
        );
        let region = Region::of(&light_fields[0].vector_grid());
        let tally = |grid, depth| Tally::new(grid, &region, &self.jet, depth);
        Ok(Running {
            seed: self.seed,
            shots: 0,
            jet: self.jet.clone(),
            tallies: light_fields.iter().map(|one| tally(one.vector_grid(), true)).collect(),
            planar_tally: tally(planar.vector_grid(), false),
            bench: config.bench_geometry(),
            config,
            scene,
            light_fields,
            planar_scene,
            planar_dt_s,
            planar,
            region,
        })
    }

    /// The bench with the jet, and with pulses so far apart that the fastest particles move by a quarter of a
    /// window.
    fn light_field_bench(&self) -> Result<(Config, Scene), BenchmarkError> {
        let mut config = self.config.clone();
        let no_scene = || BenchmarkError::NoScene { case: "validate".to_owned() };
        let scene = config.simulation.clone().ok_or_else(no_scene)?;
        let scene = Scene { flow: Flow::RoundJet(self.jet.clone()), ..scene };
        let quarter_mm = QUARTER * config.velocimetry.window_mm;
        config.shot.dt_us = 1e3 * quarter_mm / self.fastest_m_s();
        config.velocimetry.max_displacement_vox = quarter_mm / config.volume.voxel_mm;
        config.simulation = Some(scene.clone());
        Ok((config, scene))
    }

    /// The same for planar PIV and its first windows.
    fn planar_dt_s(&self) -> f64 {
        let quarter_px = QUARTER * self.first_window_px as f64;
        quarter_px * self.planar.camera.object_pixel_mm() * 1e-3 / self.fastest_m_s()
    }

    fn fastest_m_s(&self) -> f64 {
        self.jet.peak_m_s + FASTEST * self.jet.rms_m_s
    }
}

/// A validation under way.
pub struct Running {
    seed: u64,
    shots: u64,
    jet: RoundJet,
    region: Region,
    config: Config,
    scene: Scene,
    bench: BenchGeometry,
    light_fields: Vec<LightField>,
    tallies: Vec<Tally>,
    planar_scene: PlanarScene,
    planar_dt_s: f64,
    planar: PlanarInterrogation,
    planar_tally: Tally,
}

impl Running {
    /// Simulates the next shot and measures it with every instrument.
    ///
    /// # Errors
    /// A light-field pair cannot be measured.
    pub fn next_shot(&mut self) -> Result<(), BenchmarkError> {
        let (seed, shot) = (self.seed, self.shots);
        let simulated = self.scene.shot(&self.bench, seed, shot);
        let pair = ImagePair { cameras: simulated.images };
        for (instrument, tally) in self.light_fields.iter().zip(&mut self.tallies) {
            tally.add(shot, &instrument.measure(&pair)?, &simulated.truth.flow);
        }
        let simulated = self.planar_scene.shot(self.planar_dt_s, seed, shot);
        let field = self.planar.measure(&simulated.images, self.planar_dt_s);
        self.planar_tally.add(shot, &field, &simulated.flow);
        self.shots += 1;
        Ok(())
    }

    /// What the shots so far say.
    pub fn comparison(&self) -> Comparison {
        let mut instruments: Vec<Instrument> = self
            .light_fields
            .iter()
            .zip(&self.tallies)
            .map(|(light_field, tally)| Instrument {
                name: light_field.name().to_owned(),
                dt_us: self.config.shot.dt_us,
                window_mm: self.config.velocimetry.window_mm,
                ..tally.instrument()
            })
            .collect();
        instruments.push(Instrument {
            name: "planar PIV".to_owned(),
            dt_us: 1e6 * self.planar_dt_s,
            window_mm: PLANAR_WINDOW_PX as f64 * self.planar_scene.camera.object_pixel_mm(),
            ..self.planar_tally.instrument()
        });
        Comparison {
            shots: self.shots,
            seed: self.seed,
            jet: self.jet.clone(),
            region: self.region.clone(),
            instruments,
        }
    }
}

/// Places of a lattice nearest to a coordinate along an axis: one layer of it, or two that are as near.
fn layers_nearest(grid: &VectorGrid, axis: usize, coordinate_mm: f64) -> Vec<usize> {
    let away: Vec<f64> =
        grid.axis_mm(axis).iter().map(|place| (place - coordinate_mm).abs()).collect();
    let nearest = away.iter().copied().fold(f64::INFINITY, f64::min);
    (0..away.len()).filter(|&n| away[n] <= nearest + 1e-6 * grid.spacing_mm).collect()
}
