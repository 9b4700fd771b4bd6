//! A velocity field given by its samples on a grid, such as one of a numerical simulation.

use std::{
    fs, io,
    path::{Path, PathBuf},
    sync::{Arc, OnceLock},
};

use garde::Validate;
use lfpiv_hw::check::finite;
use npyz::{NpyFile, Order};
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// Components of a velocity.
const COMPONENTS: usize = 3;

/// Samples along an axis that cubic convolution uses.
const TAPS: usize = 4;

/// Why the samples of a flow cannot be used.
#[derive(Debug, Clone, PartialEq, Error)]
#[error("the flow's samples {}: {reason}", file.display())]
pub struct SampledFlowError {
    /// The file.
    pub file: PathBuf,
    /// What is wrong, and what is allowed.
    pub reason: String,
}

/// A velocity field sampled on a regular grid, interpolated by cubic convolution (Keys, IEEE Trans. Acoust. 29, 1981).
/// Beyond the grid the velocity is that on its face. The file is read when the flow is first needed.
#[derive(Debug, Clone, Serialize, Deserialize, Validate)]
#[serde(deny_unknown_fields)]
pub struct SampledFlow {
    /// A NumPy file (`.npy`) with u, v, w: shape (3, x, y, z), 32 or 64 bits each. A relative path is relative to the
    /// configuration's folder.
    #[garde(skip)]
    pub file: PathBuf,
    /// Distance of samples along x, y, z, in mm.
    #[garde(inner(custom(finite), range(min = 1e-6, max = 1e6)))]
    pub spacing_mm: [f64; 3],
    /// Centre of the grid, in mm.
    #[serde(default)]
    #[garde(inner(custom(finite), range(min = -1e6, max = 1e6)))]
    pub centre_mm: [f64; 3],
    /// Velocity of a sample of 1, in m/s.
    #[serde(default = "one")]
    #[garde(custom(finite), range(min = -1e6, max = 1e6))]
    pub unit_m_s: f64,
    /// Shared by clones, so that the file is read once.
    #[serde(skip)]
    #[garde(skip)]
    samples: Arc<OnceLock<Result<Samples, SampledFlowError>>>,
}

fn one() -> f64 {
    1.0
}

/// Equal settings name equal samples.
impl PartialEq for SampledFlow {
    fn eq(&self, other: &Self) -> bool {
        let settings = |flow: &Self| (flow.spacing_mm, flow.centre_mm, flow.unit_m_s);
        self.file == other.file && settings(self) == settings(other)
    }
}

/// u, v, w at each point of a grid; z runs fastest.
#[derive(Debug)]
struct Samples {
    points: [usize; COMPONENTS],
    velocities: Vec<[f32; COMPONENTS]>,
}

impl SampledFlow {
    /// Makes a relative path of the file one relative to `folder`.
    pub(super) fn in_folder(&mut self, folder: &Path) {
        self.file = folder.join(&self.file);
    }

    /// Reads the file, once.
    ///
    /// # Errors
    /// It cannot be read, or holds something else than samples of a velocity.
    pub(super) fn load(&self) -> Result<(), SampledFlowError> {
        self.samples().as_ref().map(|_| ()).map_err(Clone::clone)
    }

    /// At rest if the file cannot be read: [`crate::Scene::check`] refuses such a scene.
    pub(super) fn velocity_m_s(&self, at_mm: [f64; 3]) -> [f64; 3] {
        let Ok(samples) = self.samples() else { return [0.0; COMPONENTS] };
        let taps: [Taps; 3] = std::array::from_fn(|axis| {
            let last = samples.points[axis] - 1;
            let first_mm = self.centre_mm[axis] - self.spacing_mm[axis] * last as f64 / 2.0;
            Taps::at((at_mm[axis] - first_mm) / self.spacing_mm[axis], last)
        });
        samples.interpolated(&taps).map(|value| self.unit_m_s * value)
    }

    fn samples(&self) -> &Result<Samples, SampledFlowError> {
        let read = || {
            let file = fs::read(&self.file).map_err(|error| error.to_string());
            let samples = file.and_then(|bytes| Samples::read(&bytes));
            samples.map_err(|reason| SampledFlowError { file: self.file.clone(), reason })
        };
        self.samples.get_or_init(read)
    }
}

impl Samples {
    fn read(bytes: &[u8]) -> Result<Self, String> {
        let foreign = |error: io::Error| format!("it is not a NumPy file: {error}");
        let file = NpyFile::new(bytes).map_err(foreign)?;
        let points = match *file.shape() {
            [3, x, y, z] if x > 0 && y > 0 && z > 0 => [x, y, z].map(|count| count as usize),
            ref other => return Err(format!("its shape is {other:?}; allowed: (3, x, y, z)")),
        };
        if file.order() == Order::Fortran {
            return Err("its first index runs fastest; allowed: C order, as numpy.save writes \
                        numpy.ascontiguousarray(u_v_w)"
                .to_owned());
        }
        let values: Vec<f32> = match file.try_data::<f32>() {
            Ok(data) => data.collect::<Result<_, _>>().map_err(|error| error.to_string())?,
            Err(file) => match file.try_data::<f64>() {
                Ok(data) => data
                    .map(|value| value.map(|value| value as f32))
                    .collect::<Result<_, _>>()
                    .map_err(|error| error.to_string())?,
                Err(file) => {
                    let found = file.dtype().descr();
                    return Err(format!(
                        "its numbers are {found}; allowed: floats of 32 or 64 bits"
                    ));
                }
            },
        };
        if let Some(n) = values.iter().position(|value| !value.is_finite()) {
            return Err(format!("its number {n} is {}; allowed: finite numbers", values[n]));
        }
        let count: usize = points.iter().product();
        let velocity = |n: usize| std::array::from_fn(|c| values[c * count + n]);
        Ok(Self { points, velocities: (0..count).map(velocity).collect() })
    }

    fn interpolated(&self, [x, y, z]: &[Taps; 3]) -> [f64; COMPONENTS] {
        let mut sum = [0.0; COMPONENTS];
        for (i, of_x) in x.iter() {
            for (j, of_y) in y.iter() {
                let row = (i * self.points[1] + j) * self.points[2];
                for (k, of_z) in z.iter() {
                    let weight = of_x * of_y * of_z;
                    for (sum, &value) in sum.iter_mut().zip(&self.velocities[row + k]) {
                        *sum += weight * f64::from(value);
                    }
                }
            }
        }
        sum
    }
}

/// Samples and weights for a position along one axis.
struct Taps {
    points: [usize; TAPS],
    weights: [f64; TAPS],
}

impl Taps {
    /// At `at` samples from the first; the last one has the number `last`.
    fn at(at: f64, last: usize) -> Self {
        let at = at.clamp(0.0, last as f64);
        let before = at.floor();
        let t = at - before;
        // Keys' kernel with a = −1/2.
        let weights = [
            ((2.0 - t) * t - 1.0) * t / 2.0,
            ((3.0 * t - 5.0) * t * t + 2.0) / 2.0,
            ((4.0 - 3.0 * t) * t + 1.0) * t / 2.0,
            (t - 1.0) * t * t / 2.0,
        ];
        let point = |tap: usize| (before as usize + tap).saturating_sub(1).min(last);
        Self { points: std::array::from_fn(point), weights }
    }

    fn iter(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.points.iter().copied().zip(self.weights)
    }
}

#[cfg(test)]
mod tests {
    use npyz::WriterBuilder;

    use super::*;
    use crate::Flow;

    fn written<T: npyz::AutoSerialize + Copy>(path: &Path, shape: &[u64], values: &[T]) {
        let options = npyz::WriteOptions::new().default_dtype().shape(shape);
        let mut writer = options.writer(fs::File::create(path).unwrap()).begin_nd().unwrap();
        writer.extend(values.iter().copied()).unwrap();
        writer.finish().unwrap();
    }

    fn sampled(file: &Path) -> SampledFlow {
        SampledFlow {
            file: file.to_owned(),
            spacing_mm: [0.5, 0.25, 1.0],
            centre_mm: [1.0, 0.0, -1.0],
            unit_m_s: 2.0,
            samples: Arc::default(),
        }
    }

    /// Cubic convolution is exact for a parabola.
    fn parabola([x, y, z]: [f64; 3]) -> [f64; 3] {
        [0.1 + 0.2 * x - 0.3 * y * y, z + 0.5 * x * y, 0.3 * x * x - z]
    }

    #[test]
    fn samples_of_32_and_64_bits_are_interpolated() {
        let folder = tempfile::tempdir().unwrap();
        let points = [9usize, 7, 6];
        let place = |n: usize| {
            let at = [n / 42, n / 6 % 7, n % 6];
            let spacing_mm = [0.5, 0.25, 1.0];
            let centre_mm = [1.0, 0.0, -1.0];
            std::array::from_fn(|axis| {
                let middle = (points[axis] - 1) as f64 / 2.0;
                centre_mm[axis] + spacing_mm[axis] * (at[axis] as f64 - middle)
            })
        };
        let values: Vec<f64> =
            (0..3).flat_map(|c| (0..9 * 7 * 6).map(move |n| parabola(place(n))[c] / 2.0)).collect();
        let single: Vec<f32> = values.iter().map(|&value| value as f32).collect();
        let [one, two] = ["a.npy", "b.npy"].map(|name| folder.path().join(name));
        written(&one, &[3, 9, 7, 6], &values);
        written(&two, &[3, 9, 7, 6], &single);
        for path in [one, two] {
            let flow = sampled(&path);
            assert_eq!(flow.load(), Ok(()));
            for at_mm in [[1.0, 0.0, -1.0], [0.3, 0.21, -1.4], [1.9, -0.4, -0.2]] {
                let (found, expected) = (flow.velocity_m_s(at_mm), parabola(at_mm));
                let off = |c: usize| (found[c] - expected[c]).abs();
                assert!((0..3).all(|c| off(c) < 1e-5), "{found:?} {expected:?}");
            }
            let [inside, outside] = [3.0, 30.0].map(|x| flow.velocity_m_s([x, 0.1, -1.0]));
            assert_eq!(inside, outside, "beyond the grid as on its face");
        }
    }

    #[test]
    fn a_file_of_something_else_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.npy");
        let refused = |expected: &str| {
            let flow = Flow::Sampled(sampled(&path));
            let error = flow.load().unwrap_err().to_string();
            assert!(error.contains(expected) && error.contains("a.npy"), "{error}");
            assert_eq!(flow.velocity_m_s([0.0; 3]), [0.0; 3]);
        };
        refused("No such file");
        fs::write(&path, "velocity").unwrap();
        refused("not a NumPy file");
        written(&path, &[3, 2, 2], &[0.0f32; 12]);
        refused("[3, 2, 2]");
        written(&path, &[3, 1, 1, 2], &[0i32; 6]);
        refused("floats of 32 or 64 bits");
        written(&path, &[3, 1, 1, 2], &[0.0, 0.0, f64::NAN, 0.0, 0.0, 0.0]);
        refused("NaN");
    }

    #[test]
    fn a_relative_path_starts_at_the_configurations_folder() {
        let text = "kind = 'sampled'\nfile = 'flow.npy'\nspacing_mm = [1.0, 1.0, 1.0]";
        let mut flow: Flow = toml::from_str(text).unwrap();
        assert!(flow.validate().is_ok());
        flow.in_folder(Path::new("/bench"));
        assert!(matches!(&flow, Flow::Sampled(flow) if flow.file == Path::new("/bench/flow.npy")));
        assert!(toml::from_str::<Flow>(&text.replace("1.0", "0.0")).unwrap().validate().is_err());
    }
}
