//! From a declared case to configurations that can be simulated and measured.

use std::path::{Path, PathBuf};

use lfpiv::config::{Config, read_or_shipped};
use lfpiv_sim::{BenchGeometry, Flow, Placement, Scene, flow::PlaneWave};
use toml::{Table, Value};

use super::{BenchmarkError, Case, Method, Row, Sweep, suite::AS_CONFIGURED};

/// A case at one seeding density with so many cameras.
#[derive(Debug, Clone)]
pub struct Setting<'a> {
    /// What it belongs to.
    pub case: &'a Case,
    /// Everything about it; its `[reconstruction]` is the file's, with the case's changes.
    pub config: Config,
    /// What is in front of the cameras.
    pub scene: Scene,
    /// The bench as the simulator sees it.
    pub bench: BenchGeometry,
    /// The calibration card's file.
    pub card: Option<PathBuf>,
}

impl Case {
    /// The case at each of its seeding densities and numbers of cameras, with each of its waves.
    pub(super) fn settings(&self, folder: &Path) -> Result<Vec<Setting<'_>>, BenchmarkError> {
        let config = self.configuration(folder)?;
        let no_scene = || BenchmarkError::NoScene { case: self.name.clone() };
        let mut scene = config.simulation.clone().ok_or_else(no_scene)?;
        scene.flow.in_folder(folder);
        scene
            .flow
            .load()
            .map_err(|reason| BenchmarkError::Flow { case: self.name.clone(), reason })?;
        let densities = if self.ppm.is_empty() { vec![scene.ppm] } else { self.ppm.clone() };
        let cameras =
            if self.cameras.is_empty() { vec![config.camera.len()] } else { self.cameras.clone() };
        let mut settings = Vec::new();
        for &cameras in &cameras {
            for &ppm in &densities {
                let mut config = config.clone();
                config.camera.truncate(cameras);
                for flow in self.flows(&config, &scene) {
                    let scene = Scene { ppm, flow, ..scene.clone() };
                    let config = Config { simulation: Some(scene.clone()), ..config.clone() };
                    let bench = config.bench_geometry();
                    let card = self.card.as_ref().map(|card| folder.join(card));
                    settings.push(Setting { case: self, config, scene, bench, card });
                }
            }
        }
        Ok(settings)
    }

    /// The waves of a sweep, or the scene's own flow.
    fn flows(&self, config: &Config, scene: &Scene) -> Vec<Flow> {
        let Some(sweep) = &self.sweep else { return vec![scene.flow.clone()] };
        sweep.waves(config.volume.voxel_mm, config.bench_geometry().dt_s)
    }

    /// The configuration file, relative to the suite's `folder`, with the case's changes, checked as
    /// any configuration is.
    ///
    /// # Errors
    /// The file cannot be read, or is no configuration with these changes.
    pub fn configuration(&self, folder: &Path) -> Result<Config, BenchmarkError> {
        let path = folder.join(&self.config);
        let text = read_or_shipped(&path)
            .map_err(|reason| BenchmarkError::Unreadable { path: path.clone(), reason })?;
        let malformed = |reason: String| BenchmarkError::Malformed { path: path.clone(), reason };
        let mut table: Table =
            text.parse().map_err(|e: toml::de::Error| malformed(e.to_string()))?;
        merge(&mut table, &self.with);
        let text = toml::to_string(&table).map_err(|error| malformed(error.to_string()))?;
        let name = format!("{} changed by case {}", path.display(), self.name);
        Config::parse(&name, &text)
            .map_err(|reason| BenchmarkError::Configuration { case: self.name.clone(), reason })
    }
}

impl Sweep {
    /// Its waves on voxels of `voxel_mm`, for frames `dt_s` apart.
    fn waves(&self, voxel_mm: f64, dt_s: f64) -> Vec<Flow> {
        let mut waves = Vec::new();
        for &wavelength_vox in &self.wavelengths_vox {
            for &amplitude_vox in &self.amplitudes_vox {
                for &[along, component] in &self.directions {
                    waves.push(Flow::PlaneWave(PlaneWave {
                        wavelength_mm: wavelength_vox * voxel_mm,
                        amplitude_m_s: amplitude_vox * voxel_mm * 1e-3 / dt_s,
                        along,
                        component,
                        // On no node of the vectors' lattice.
                        phase_rad: 0.7,
                    }));
                }
            }
        }
        waves
    }
}

/// Puts `changes` into `table`, table by table. One that names its kind is another thing, not a
/// change of the same.
fn merge(table: &mut Table, changes: &Table) {
    for (key, change) in changes {
        match (table.get_mut(key), change) {
            (Some(Value::Table(old)), Value::Table(new)) if !new.contains_key("kind") => {
                merge(old, new);
            }
            _ => {
                table.insert(key.clone(), change.clone());
            }
        }
    }
}

impl Setting<'_> {
    /// The configuration with a method's settings.
    pub fn config_with(&self, method: Option<&Method>) -> Config {
        let mut config = self.config.clone();
        if let Some(method) = method {
            config.reconstruction = method.reconstruction.clone();
            let own = config.velocimetry.place_particles;
            config.velocimetry.place_particles = method.place_particles.unwrap_or(own);
        }
        config
    }

    /// The plane wave, where the flow is one.
    pub fn wave(&self) -> Option<&PlaneWave> {
        match &self.scene.flow {
            Flow::PlaneWave(wave) => Some(wave),
            _ => None,
        }
    }

    /// A row that says what is measured, and nothing of the result.
    pub fn row(&self, method: Option<&Method>, seed: u64) -> Row {
        let volume = &self.config.volume.grid();
        let [x, y, z] = volume.voxels;
        let sensor = &self.scene.sensor;
        let noisy = sensor.shot_noise || sensor.read_noise_electrons > 0.0;
        Row {
            set: self.case.set.clone(),
            case: self.case.name.clone(),
            measure: kebab(&self.case.measure),
            method: method.map_or(AS_CONFIGURED, |method| &method.name).to_owned(),
            flow: flow_name(&self.scene.flow).to_owned(),
            ppm: self.scene.ppm,
            placement: match self.scene.placement {
                Placement::OffGrid => "off-grid".to_owned(),
                Placement::OnGrid => "on-grid".to_owned(),
            },
            noise: if noisy { "shot and read noise" } else { "none" }.to_owned(),
            cameras: self.config.camera.len(),
            voxels: format!("{x}x{y}x{z}"),
            voxel_mm: volume.voxel_mm,
            seed,
            wavelength_vox: self.wave().map(|wave| wave.wavelength_mm / volume.voxel_mm),
            amplitude_vox: self
                .wave()
                .map(|wave| wave.amplitude_m_s * 1e3 * self.bench.dt_s / volume.voxel_mm),
            ..Row::default()
        }
    }
}

/// A unit variant's name as it is written in TOML.
fn kebab(value: &impl serde::Serialize) -> String {
    serde_json::to_value(value).ok().and_then(|v| v.as_str().map(str::to_owned)).unwrap_or_default()
}

fn flow_name(flow: &Flow) -> &'static str {
    match flow {
        Flow::Uniform(uniform) if uniform.velocity_m_s == [0.0; 3] => "none",
        Flow::Uniform(_) => "uniform",
        Flow::LinearShear(_) => "linear shear",
        Flow::SolidRotation(_) => "solid rotation",
        Flow::RingVortex(_) => "ring vortex",
        Flow::Jet(_) => "jet",
        Flow::Abc(_) => "ABC",
        Flow::ShearLayer(_) => "shear layer",
        Flow::PlaneWave(_) => "plane wave",
        Flow::Turbulence(_) => "turbulence",
        Flow::RoundJet(_) => "round jet",
        Flow::Sampled(_) => "samples",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changes_reach_into_tables_and_a_kind_replaces_one() {
        let mut table: Table =
            "[a]\nx = 1\ny = 2\n[a.flow]\nkind = 'abc'\nlong = 3\n".parse().unwrap();
        let changes: Table = "[a]\ny = 5\n[a.flow]\nkind = 'uniform'\n".parse().unwrap();
        merge(&mut table, &changes);
        let expected: Table = "[a]\nx = 1\ny = 5\n[a.flow]\nkind = 'uniform'\n".parse().unwrap();
        assert_eq!(table, expected);
    }
}
