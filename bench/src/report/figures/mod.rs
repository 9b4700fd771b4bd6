//! The figures of the report, one file each. A figure without data is not shown.

pub mod convergence;
mod displacement;
mod elongation;
pub mod growth;
mod imperfect;
mod loopback;
mod memory;
mod model_parts;
mod pareto;
mod peers;
mod projection;
mod quality;
mod rough;
mod vortex;

use super::{Report, section::Section};

/// All figures that the record has data for, in the order of the page.
pub fn sections(report: &Report) -> Vec<Section> {
    [
        pareto::error_seconds,
        pareto::quality_seconds,
        quality::quality_ppm,
        convergence::quality_iterations,
        convergence::error_iterations,
        projection::projections,
        elongation::elongation,
        vortex::iso_surface,
        vortex::slices,
        displacement::error_ppm,
        displacement::cumulative,
        memory::matrices,
        growth::whole_process,
        growth::growth,
        peers::beside,
        rough::rough_flows,
        rough::gain,
        imperfect::imperfect_bench,
        imperfect::calibration,
        model_parts::model_parts,
        loopback::streams,
    ]
    .into_iter()
    .filter_map(|figure| figure(report))
    .collect()
}
