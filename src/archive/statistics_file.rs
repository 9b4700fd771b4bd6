//! The statistics of a run as NetCDF-4/CF: statistics per point, convergence, two-point
//! correlations and spectra.
//!
//! Per point (`z, y, x`): `samples`, and for each quantity (`u_mean`, `u_rms`, `uv`, `u_skewness`,
//! ...) its value, the standard uncertainty `_uncertainty` with its parts `_uncertainty_flow` and
//! `_uncertainty_measurement`, and the 95 % interval `_interval` over `bound`. Unknown numbers are
//! NaN. Over `part`: convergence. Along each axis: `covariance_x`, `correlation_x` over
//! `separation_x`, `spectrum_x` over `wavenumber_x`.

use std::path::Path;

use lfpiv_core::ensemble::{Convergence, Correlation, Ensemble, Estimate, Quantity, Spectrum};

use super::{
    ArchiveError,
    netcdf_file::{Described, NetCdfFile},
};

const POINTS: [&str; 3] = ["z", "y", "x"];
const AXES: [&str; 3] = ["x", "y", "z"];
/// Bytes per point: value, three uncertainties and two bounds of each quantity, and a count.
const POINT_BYTES: u64 = 6 * 4 * Quantity::ALL.len() as u64 + 8;
const REST_BYTES: u64 = 4 << 20;

/// A number of an estimate: suffix of its name, prefix of its description, accessor.
type Part = (&'static str, &'static str, fn(&Estimate) -> f64);

const PARTS: [Part; 4] = [
    ("", "", |estimate| estimate.value),
    ("_uncertainty", "standard uncertainty of ", Estimate::uncertainty),
    (
        "_uncertainty_flow",
        "part due to the flow's fluctuations of the standard uncertainty of ",
        |e| e.flow_uncertainty,
    ),
    (
        "_uncertainty_measurement",
        "part due to the uncertainty of each measured velocity of the standard uncertainty of ",
        |e| e.measurement_uncertainty,
    ),
];

/// Writes the statistics of a run, replacing an older file; `configuration` is the TOML text of the
/// measurement.
pub fn write_statistics(
    path: &Path,
    configuration: &str,
    ensemble: &Ensemble,
) -> Result<(), ArchiveError> {
    let grid = ensemble.grid();
    let bytes = 2 * (REST_BYTES + POINT_BYTES * grid.len() as u64);
    let mut file = NetCdfFile::create(path, bytes, "Statistics of velocity", configuration)?;
    file.add_axes([0, 1, 2].map(|axis| grid.axis_mm(axis)))?;
    file.add_dimension("bound", 2)?;
    file.add_dimension("component", 3)?;
    write_points(&mut file, ensemble)?;
    write_convergence(&mut file, &ensemble.convergence())?;
    for correlation in ensemble.correlations() {
        write_correlation(&mut file, &correlation)?;
        write_spectrum(&mut file, &correlation.spectrum())?;
    }
    file.store()
}

fn write_points(file: &mut NetCdfFile, ensemble: &Ensemble) -> Result<(), ArchiveError> {
    let estimates = ensemble.estimates();
    let shots = Described { name: "shots", units: "1", long_name: "number of shots" };
    file.add::<i64>(&shots, &[])?;
    file.put(shots.name, &[ensemble.shots() as i64])?;
    let samples = Described {
        name: "samples",
        units: "1",
        long_name: "number of valid vectors, or particles, at each point",
    };
    file.add::<i64>(&samples, &POINTS)?;
    let counts: Vec<i64> = estimates.counts.iter().map(|count| *count as i64).collect();
    file.put(samples.name, &counts)?;
    for quantity in Quantity::ALL {
        let (units, what) = (units(quantity), meaning(quantity));
        let points = estimates.of(quantity);
        let or_nan = |part: fn(&Estimate) -> f64| {
            let number = |point: &Option<Estimate>| point.as_ref().map_or(f64::NAN, part) as f32;
            points.iter().map(number).collect::<Vec<f32>>()
        };
        for (ending, words, part) in PARTS {
            let name = format!("{}{ending}", quantity.name());
            let long_name = format!("{words}{what}");
            let described = Described { name: &name, units, long_name: &long_name };
            file.add_with_gaps(&described, &POINTS)?;
            file.put(&name, &or_nan(part))?;
        }
        let name = format!("{}_interval", quantity.name());
        let long_name = format!("95 % interval of {what}");
        let described = Described { name: &name, units, long_name: &long_name };
        file.add_with_gaps(&described, &["z", "y", "x", "bound"])?;
        let bounds = or_nan(|e| e.interval_95[0]).into_iter().zip(or_nan(|e| e.interval_95[1]));
        file.put(&name, &bounds.flat_map(|(low, high)| [low, high]).collect::<Vec<f32>>())?;
    }
    Ok(())
}

fn units(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Mean(_) | Quantity::Rms(_) => "m s-1",
        Quantity::Stress(..) => "m2 s-2",
        Quantity::Skewness(_) => "1",
    }
}

fn meaning(quantity: Quantity) -> String {
    let along = |component: usize| AXES[component];
    match quantity {
        Quantity::Mean(c) => format!("the mean velocity along {}", along(c)),
        Quantity::Rms(c) => format!(
            "the root-mean-square of the flow's fluctuations along {}, without the measurement's noise",
            along(c)
        ),
        Quantity::Stress(i, j) => format!(
            "the Reynolds stress over the density, of the flow's fluctuations along {} and {}",
            along(i),
            along(j)
        ),
        Quantity::Skewness(c) => {
            format!("the skewness of the flow's fluctuations along {}", along(c))
        }
    }
}

fn write_convergence(file: &mut NetCdfFile, steps: &[Convergence]) -> Result<(), ArchiveError> {
    type OfStep = fn(&Convergence) -> [f64; 3];
    const COLUMNS: [(&str, &str, OfStep); 4] = [
        (
            "convergence_mean_uncertainty",
            "root mean square over the points of the standard uncertainty of the mean",
            |s| s.mean_uncertainty_m_s,
        ),
        (
            "convergence_mean_difference",
            "root-mean-square difference between the means of these shots and of all shots",
            |s| s.mean_difference_m_s,
        ),
        (
            "convergence_mean_difference_expected",
            "expected difference for independent shots",
            |s| s.mean_difference_expected_m_s,
        ),
        (
            "convergence_rms_difference",
            "root-mean-square difference between the standard deviations of these shots and of all shots",
            |s| s.rms_difference_m_s,
        ),
    ];
    file.add_dimension("part", steps.len().max(1))?;
    let shots = Described {
        name: "convergence_shots",
        units: "1",
        long_name: "number of shots in each part of the run",
    };
    file.add::<i64>(&shots, &["part"])?;
    if steps.is_empty() {
        return Ok(());
    }
    file.put(shots.name, &steps.iter().map(|step| step.shots as i64).collect::<Vec<_>>())?;
    for (name, long_name, of) in COLUMNS {
        file.add::<f64>(&Described { name, units: "m s-1", long_name }, &["part", "component"])?;
        file.put(name, &steps.iter().flat_map(of).collect::<Vec<f64>>())?;
    }
    Ok(())
}

fn write_correlation(file: &mut NetCdfFile, correlation: &Correlation) -> Result<(), ArchiveError> {
    let axis = AXES[correlation.axis];
    let separation = format!("separation_{axis}");
    file.add_dimension(&separation, correlation.separation_mm.len())?;
    let along = format!("distance between two points along {axis}");
    file.add::<f64>(
        &Described { name: &separation, units: "mm", long_name: &along },
        &[&separation],
    )?;
    file.put(&separation, &correlation.separation_mm)?;
    let (name, long_name) = (
        format!("covariance_{axis}"),
        format!("covariance of u, v, w with itself at this distance along {axis}, over all points"),
    );
    let described = Described { name: &name, units: "m2 s-2", long_name: &long_name };
    file.add::<f64>(&described, &[&separation, "component"])?;
    file.put(&name, correlation.covariance_m2_s2.as_flattened())?;
    let (name, long_name) = (
        format!("correlation_{axis}"),
        format!("correlation coefficient of u, v, w with itself at this distance along {axis}"),
    );
    let described = Described { name: &name, units: "1", long_name: &long_name };
    file.add_with_gaps(&described, &[&separation, "component"])?;
    let known = |number: &Option<f64>| number.unwrap_or(f64::NAN) as f32;
    file.put(&name, &correlation.coefficient.iter().flatten().map(known).collect::<Vec<f32>>())?;
    let (name, long_name) = (
        format!("integral_scale_{axis}"),
        format!(
            "integral of the correlation coefficient of u, v, w along {axis} up to its first zero"
        ),
    );
    let described = Described { name: &name, units: "mm", long_name: &long_name };
    file.add_with_gaps(&described, &["component"])?;
    file.put(&name, &correlation.integral_scale_mm().map(|scale| known(&scale)))
}

fn write_spectrum(file: &mut NetCdfFile, spectrum: &Spectrum) -> Result<(), ArchiveError> {
    if spectrum.wavenumber_rad_mm.is_empty() {
        return Ok(());
    }
    let axis = AXES[spectrum.axis];
    let wavenumber = format!("wavenumber_{axis}");
    file.add_dimension(&wavenumber, spectrum.wavenumber_rad_mm.len())?;
    let along = format!("wavenumber along {axis}: 2 pi over the wavelength");
    let described = Described { name: &wavenumber, units: "rad mm-1", long_name: &along };
    file.add::<f64>(&described, &[&wavenumber])?;
    file.put(&wavenumber, &spectrum.wavenumber_rad_mm)?;
    let (name, long_name) = (
        format!("spectrum_{axis}"),
        format!("one-dimensional, one-sided spectrum of u, v, w along {axis}"),
    );
    let described = Described { name: &name, units: "m2 s-2 mm rad-1", long_name: &long_name };
    file.add::<f64>(&described, &[&wavenumber, "component"])?;
    file.put(&name, spectrum.energy_m2_s2_mm.as_flattened())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::archive::test_data::result;
    use lfpiv_core::ensemble::Snapshot;

    #[test]
    fn statistics_of_one_shot_and_of_several_can_be_written() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("statistics.nc");
        let field = result([4, 3, 2]).measured.field;
        let mut ensemble = Ensemble::new(field.grid.clone());
        for shot in 0..5 {
            let mut field = field.clone();
            let scatter = |v: [f32; 3]| v.map(|c| c * (1.0 + 0.1 * (shot as f32 - 2.0)));
            field.displacement_vox = field.displacement_vox.into_iter().map(scatter).collect();
            ensemble.add(&Snapshot::of_field(shot, &field));
            write_statistics(&path, "[volume]", &ensemble).unwrap();
        }
        let file = netcdf::open(&path).unwrap();
        let numbers = |name: &str| file.variable(name).unwrap().get_values::<f64, _>(..).unwrap();
        // One of three vectors is valid.
        assert_eq!(numbers("samples")[..3], [5.0, 0.0, 0.0]);
        assert_eq!(numbers("shots"), [5.0]);
        // A voxel of 0.1 mm in 100 us is 1 m/s.
        let mean = f64::from(field.displacement_vox[3][1]);
        assert!((numbers("v_mean")[3] - mean).abs() < 1e-6);
        assert!(numbers("v_mean")[1].is_nan() && numbers("uv_interval")[2].is_nan());
        let [low, high] = [0, 1].map(|bound| numbers("v_mean_interval")[6 + bound]);
        assert!(low < mean && mean < high, "{low} {mean} {high}");
        assert_eq!(numbers("separation_x").len(), 4);
        assert_eq!(numbers("spectrum_y").len(), 3 * 4);
    }
}
