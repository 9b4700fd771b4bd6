//! The result: instruments beside each other and beside the truth.

use lfpiv_core::velocimetry::VectorGrid;
use lfpiv_sim::flow::RoundJet;
use serde::Serialize;

use super::layers_nearest;

/// Everything that came out.
#[derive(Debug, Clone, Serialize)]
pub struct Comparison {
    /// Number of shots.
    pub shots: u64,
    /// Seed of particles, noise and fluctuations.
    pub seed: u64,
    /// The flow.
    pub jet: RoundJet,
    /// Where all instruments have vectors.
    pub region: Region,
    /// Both single cameras, the dual ones, planar PIV.
    pub instruments: Vec<Instrument>,
}

/// From the first to the last vector of the light-field cameras.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Region {
    /// Lowest and highest x, y, z, in mm.
    pub range_mm: [[f64; 2]; 3],
}

impl Region {
    pub(super) fn of(grid: &VectorGrid) -> Self {
        let range_mm = std::array::from_fn(|axis| {
            let length_mm = (grid.vectors[axis].max(1) - 1) as f64 * grid.spacing_mm;
            [grid.first_mm[axis], grid.first_mm[axis] + length_mm]
        });
        Self { range_mm }
    }
}

/// One instrument's statistics.
#[derive(Debug, Clone, Serialize)]
pub struct Instrument {
    /// What it is.
    pub name: String,
    /// Time between its pulses, in µs.
    pub dt_us: f64,
    /// Edge of its final windows, in mm.
    pub window_mm: f64,
    /// Share of its vectors that are valid, over all shots.
    pub valid_share: f64,
    /// Streamwise velocity along x in the middle of the depth, and where the instrument has depth, along z in the
    /// middle of the width; both averaged along y over the region.
    pub profiles: Vec<Profile>,
    /// Differences over all vectors of the volume, where there is one.
    pub volume: Option<Vec<Difference>>,
    /// Mean streamwise velocity in planes.
    #[serde(skip)]
    pub slices: Slices,
}

/// A profile of the streamwise velocity.
#[derive(Debug, Clone, Serialize)]
pub struct Profile {
    /// Along this axis.
    pub axis: String,
    /// Its points.
    pub points: Vec<ProfilePoint>,
}

/// A point of a profile. Velocities in m/s; absent where too little was measured.
#[derive(Debug, Clone, Serialize)]
pub struct ProfilePoint {
    /// Its coordinate, in mm.
    pub place_mm: f64,
    /// Its distance from the jet's axis over the diameter of the nozzle.
    pub place_over_d: f64,
    /// Mean of the jet.
    pub true_mean_m_s: f64,
    /// Root mean square of its fluctuations.
    pub true_rms_m_s: f64,
    /// Mean of the jet in the shots that were seen.
    pub shots_mean_m_s: Option<f64>,
    /// Root mean square of its fluctuations in these.
    pub shots_rms_m_s: Option<f64>,
    /// Measured mean.
    pub mean_m_s: Option<f64>,
    /// Interval of 95 % of that, with the scatter of the flow.
    pub mean_interval_95_m_s: Option<[f64; 2]>,
    /// Measured root mean square, without the measurement's scatter.
    pub rms_m_s: Option<f64>,
}

/// Root-mean-square differences of a component's statistics over some places, in m/s.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Difference {
    /// u, v or w.
    pub component: String,
    /// Measured mean from that of the jet. The scatter of a finite number of shots is in it.
    pub mean_m_s: f64,
    /// Measured root mean square from that of the jet.
    pub rms_m_s: f64,
    /// Measured mean from the true mean of the same shots: the instrument's part.
    pub mean_from_shots_m_s: f64,
    /// The same of the root mean square.
    pub rms_from_shots_m_s: f64,
}

impl Instrument {
    /// The profile along an axis (`x` or `z`).
    pub fn profile(&self, axis: &str) -> Option<&Profile> {
        self.profiles.iter().find(|profile| profile.axis == axis)
    }
}

impl Profile {
    /// The points whose coordinate is within `range_mm`.
    pub fn within(&self, range_mm: [f64; 2]) -> impl Iterator<Item = &ProfilePoint> {
        let range = range_mm[0] - 1e-6..=range_mm[1] + 1e-6;
        self.points.iter().filter(move |point| range.contains(&point.place_mm))
    }

    /// Points within `range_mm` whose interval holds the mean of the jet, and all that have an interval. Shots that
    /// happen to be slow are slow at all places: intervals of neighbours hold together or not.
    pub fn intervals_that_hold(&self, range_mm: [f64; 2]) -> [usize; 2] {
        self.within(range_mm).fold([0, 0], |[held, all], point| {
            let holds = |[low, high]: [f64; 2]| (low..=high).contains(&point.true_mean_m_s);
            match point.mean_interval_95_m_s {
                None => [held, all],
                Some(interval) => [held + usize::from(holds(interval)), all + 1],
            }
        })
    }

    /// Root-mean-square differences from the truth over the points within `range_mm`.
    pub fn difference(&self, range_mm: [f64; 2]) -> Difference {
        let within: Vec<&ProfilePoint> = self.within(range_mm).collect();
        let over = |of: fn(&ProfilePoint) -> Option<f64>| {
            root_mean_square(within.iter().filter_map(|point| of(point)))
        };
        Difference {
            component: "v".to_owned(),
            mean_m_s: over(|p| Some(p.mean_m_s? - p.true_mean_m_s)),
            rms_m_s: over(|p| Some(p.rms_m_s? - p.true_rms_m_s)),
            mean_from_shots_m_s: over(|p| Some(p.mean_m_s? - p.shots_mean_m_s?)),
            rms_from_shots_m_s: over(|p| Some(p.rms_m_s? - p.shots_rms_m_s?)),
        }
    }
}

/// Zero without values.
pub(super) fn root_mean_square(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0.0), |(sum, count), v| (sum + v * v, count + 1.0));
    if count > 0.0 { (sum / count).sqrt() } else { 0.0 }
}

/// The mean streamwise velocity on planes of a lattice, in m/s; zero where nothing is known.
#[derive(Debug, Clone, Default)]
pub struct Slices {
    /// The lattice.
    pub grid: Option<VectorGrid>,
    /// Nearest to z = 0, rows along x from the lowest y on.
    pub along_xy: Vec<f32>,
    /// In the middle of y, rows along x from the lowest z on.
    pub along_xz: Vec<f32>,
}

impl Slices {
    /// The slices of a mean, given at every place of the lattice.
    pub(super) fn of(grid: &VectorGrid, mean: impl Fn(usize) -> Option<f64>) -> Self {
        let [nx, ny, nz] = grid.vectors;
        let value = |x: usize, y: usize, z: usize| {
            mean((z * ny + y) * nx + x).map_or(0.0, |mean| mean as f32)
        };
        let layer = layers_nearest(grid, 2, 0.0)[0];
        let row = ny / 2;
        Self {
            grid: Some(grid.clone()),
            along_xy: (0..nx * ny).map(|n| value(n % nx, n / nx, layer)).collect(),
            along_xz: (0..nx * nz).map(|n| value(n % nx, row, n / nx)).collect(),
        }
    }
}
