//! Particle tracking after correlation.
//!
//! A correlation peak is a mean over a window, including misplaced light. Once the displacement is known to a
//! fraction of a voxel, most particles can be matched between the frames, and each gives a displacement at its
//! own position. A robust fit (`fit`) resolves finer scales than a window and tolerates mismatched particles.

mod divergence;
mod fit;
mod missed;
mod pairs;
mod particles;
mod samples;
mod spline;
mod variance;

pub use self::particles::{LightPeak, particles};
use self::{
    fit::Fit,
    pairs::{FARTHEST_VOX, Pair, pairs},
    samples::Samples,
};
pub use self::{missed::Missed, spline::Spline};
use super::{
    cloud::PointCloud, flow_geometry::FlowGeometry, flow_nodes::FlowNodes, lattice::Lattice,
    layout::Layout,
};

/// Final search radius about the position that the field predicts, in voxels: some standard deviations of a
/// reconstructed particle's position, and less than the distance to its neighbours.
const FINAL_SEARCH_RADIUS_VOX: f32 = 0.6;

/// Most rounds with the large search radius on the windows' nodes. On finer nodes there is one: with more the field is
/// less accurate (docs/decisions.md).
const FAR_ROUNDS: usize = 5;

/// A component of the field has converged if it changes by no more than this, in voxels: its uncertainty on the
/// bench.
const CONVERGED_VOX: f32 = 0.015;

/// Largest share of unconverged components at which iteration stops.
const UNCONVERGED_SHARE: f64 = 0.05;

/// Least number of particles per cell between the finer nodes.
const LEAST_PER_FINER_CELL: f64 = 0.5;

/// Largest voxels, relative to the configured ones, from which particle positions are determined: a particle then
/// extends over two or more along each axis.
const COARSEST_GRAIN_VOX: f32 = 0.5;

/// Whether the voxels of `cloud` are small enough for single particles to be tracked.
pub fn is_fine(cloud: &PointCloud) -> bool {
    cloud.grain_vox <= COARSEST_GRAIN_VOX
}

/// A displacement field from particle tracking, and its standard uncertainty, in voxels.
#[derive(Debug, Clone, PartialEq)]
pub struct Refined {
    /// The field.
    pub spline: Spline,
    /// Its values on its own nodes, which may be closer than the windows.
    pub nodes: Lattice,
    /// Along x, y, z, for every node; greater than zero. `None` where there is neither a vector nor a particle.
    pub uncertainty_vox: Vec<Option<[f32; 3]>>,
    /// Windows whose vector is measured by particles alone.
    pub by_particles: Vec<bool>,
    /// What the fields miss of the flow.
    pub missed: Missed,
}

/// The field fitted to the particles of both frames, starting from the correlation's `field` with standard
/// uncertainty `uncertainty_vox` (`None` where nothing was measured). At least three nodes along every axis.
/// `incompressible`: the field is nearly divergence-free. Particles are used if their centres are in the `flow`;
/// all light of a particle next to a body counts, including the part inside the body.
pub fn follow(
    field: &Lattice,
    uncertainty_vox: &[Option<[f32; 3]>],
    frames: [&PointCloud; 2],
    incompressible: bool,
    flow: Option<&FlowGeometry>,
) -> Refined {
    let fit_on = |nodes: Lattice, uncertainty_vox: &[Option<[f32; 3]>], level: usize| {
        let flow = flow.map(|flow| &flow.splines[level]);
        SplineFit::new(nodes, uncertainty_vox, (field.step_vox, incompressible), flow)
    };
    let mut stage = fit_on(field.clone(), uncertainty_vox, 0);
    let in_flow = |cloud: &PointCloud| -> Vec<LightPeak> {
        let mut found = particles(cloud);
        found.retain(|particle| flow.is_none_or(|flow| flow.is_flow(particle.at_vox)));
        // In the order of the field's coefficients, so that those of the next particle are in the processor's cache.
        let order = stage.spline.nodes.order(found.iter().map(|particle| particle.at_vox));
        order.into_iter().map(|n| found[n]).collect()
    };
    let [a, b] = frames;
    let (a, b) = rayon::join(|| in_flow(a), || in_flow(b));
    let frames: [&[LightPeak]; 2] = [&a, &b];
    stage.iterate(frames);
    let near = pairs(&stage.spline, frames, FINAL_SEARCH_RADIUS_VOX);
    stage.adjust(&near);
    let by_particles = Samples::new(field.nodes, &stage.spline, &near)
        .agree(&stage.spline, FINAL_SEARCH_RADIUS_VOX);
    if !stage.allows_finer(near.len()) {
        let uncertainty_vox = stage.fit.uncertainty_vox();
        let nodes = stage.spline.on_nodes(&stage.nodes);
        let missed = Missed::of(field, &stage.spline, &near);
        let spline = stage.spline;
        return Refined { spline, nodes, uncertainty_vox, by_particles, missed };
    }
    let (nodes, known) = stage.finer(uncertainty_vox, flow.map(|flow| &flow.finer));
    let mut finer = fit_on(nodes, &known, 1);
    finer.adjust(&pairs(&finer.spline, frames, FARTHEST_VOX));
    let near = pairs(&finer.spline, frames, FINAL_SEARCH_RADIUS_VOX);
    finer.adjust(&near);
    let samples = Samples::new(field.nodes, &stage.spline, &near);
    stage.fit.weigh(&samples, &residuals(&finer.spline, &near));
    let nodes = finer.spline.on_nodes(&finer.nodes);
    let uncertainty_vox =
        larger(&nodes, finer.fit.uncertainty_vox(), field, &stage.fit.uncertainty_vox());
    let missed = Missed::of(field, &finer.spline, &near);
    Refined { spline: finer.spline, nodes, uncertainty_vox, by_particles, missed }
}

/// Residuals of the particles' displacements, per component.
fn residuals(spline: &Spline, pairs: &[Pair]) -> [Vec<f64>; 3] {
    let values: Vec<[f64; 3]> =
        pairs.iter().map(|pair| spline.of(&spline.taps(pair.middle_vox))).collect();
    std::array::from_fn(|c| {
        let left =
            |(pair, value): (&Pair, &[f64; 3])| f64::from(pair.displacement_vox[c]) - value[c];
        pairs.iter().zip(&values).map(left).collect()
    })
}

/// The larger standard uncertainty of each fine node and of the window nearest to it. Errors of neighbouring
/// particles are correlated, so a smooth field on fine nodes is not more accurate than on the windows' nodes.
fn larger(
    nodes: &Lattice,
    fine: Vec<Option<[f32; 3]>>,
    windows: &Lattice,
    coarse: &[Option<[f32; 3]>],
) -> Vec<Option<[f32; 3]>> {
    let layout = Layout { nodes: nodes.nodes };
    let near = |n: usize| {
        let place = layout.place(n);
        let at = |axis: usize| nodes.first_vox[axis] + nodes.step_vox * place[axis] as f32;
        coarse[windows.nearest_node(std::array::from_fn(at))]
    };
    let larger = |(n, own): (usize, Option<[f32; 3]>)| match (own, near(n)) {
        (Some(own), Some(near)) => Some(std::array::from_fn(|c| own[c].max(near[c]))),
        (own, near) => own.or(near),
    };
    fine.into_iter().enumerate().map(larger).collect()
}

/// A field on nodes of one spacing, and its fit.
struct SplineFit<'a> {
    nodes: Lattice,
    spline: Spline,
    fit: Fit<'a>,
}

impl<'a> SplineFit<'a> {
    fn new(
        nodes: Lattice,
        uncertainty_vox: &[Option<[f32; 3]>],
        (window_step_vox, incompressible): (f32, bool),
        flow: Option<&'a FlowNodes>,
    ) -> Self {
        let spline = Spline::through(&nodes, flow);
        let fit =
            Fit::new(&nodes, uncertainty_vox, spline.nodes.layout, window_step_vox, incompressible)
                .with_flow(flow);
        Self { nodes, spline, fit }
    }

    /// Pairs particles by the field and fits the field to them, until few of its components change.
    fn iterate(&mut self, frames: [&[LightPeak]; 2]) {
        for _ in 0..FAR_ROUNDS {
            let before = self.spline.on_nodes(&self.nodes);
            self.adjust(&pairs(&self.spline, frames, FARTHEST_VOX));
            if moved(&before, &self.spline.on_nodes(&self.nodes)) <= UNCONVERGED_SHARE {
                return;
            }
        }
    }

    fn adjust(&mut self, pairs: &[Pair]) {
        let samples = Samples::new(self.nodes.nodes, &self.spline, pairs);
        self.fit.adjust(&mut self.spline, &samples);
    }

    /// Whether there are enough particles for nodes at half the spacing.
    fn allows_finer(&self, particles: usize) -> bool {
        let cells: usize = self.nodes.nodes.iter().map(|n| n - 1).product();
        particles as f64 >= LEAST_PER_FINER_CELL * 8.0 * cells as f64
    }

    /// The same field on nodes at half the spacing, and the standard uncertainty `uncertainty_vox` of the windows'
    /// vectors at their nodes.
    fn finer(
        &self,
        uncertainty_vox: &[Option<[f32; 3]>],
        flow: Option<&FlowNodes>,
    ) -> (Lattice, Vec<Option<[f32; 3]>>) {
        let spline = &self.spline;
        let mut nodes =
            self.nodes.finer().sampling(|at| spline.of(&spline.taps(at)).map(|value| value as f32));
        if let Some(flow) = flow {
            // Inside a body the spline changes from one flow to the other.
            let in_flow: Vec<bool> = (0..nodes.values.len()).map(|n| flow.is_flow(n)).collect();
            nodes = nodes.filled(&in_flow, Some(flow));
        }
        let (coarse, fine) = (Layout { nodes: self.nodes.nodes }, Layout { nodes: nodes.nodes });
        let mut known = vec![None; fine.len()];
        for (n, uncertainty) in uncertainty_vox.iter().enumerate() {
            known[fine.number(coarse.place(n).map(|place| 2 * place))] = *uncertainty;
        }
        (nodes, known)
    }
}

/// Share of a field's components that differ from those of the previous round by more than [`CONVERGED_VOX`].
fn moved(before: &Lattice, now: &Lattice) -> f64 {
    let [before, now] = [before, now].map(|field| field.values.as_flattened());
    let moved = before.iter().zip(now).filter(|(a, b)| (**a - **b).abs() > CONVERGED_VOX).count();
    moved as f64 / now.len() as f64
}

#[cfg(test)]
mod tests;
