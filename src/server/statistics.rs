//! `/api/v1/statistics`: ensemble statistics of the shots so far.

use axum::{
    extract::State,
    http::{HeaderMap, HeaderValue, header},
    response::{IntoResponse, Response},
};
use lfpiv_core::ensemble::{Convergence, Correlation, Ensemble, Estimate, Estimates, Quantity};
use serde::{Deserialize, Serialize};
use utoipa::{IntoParams, ToSchema};

use super::{ApiError, app::App, extract::Arguments, results::GridView};

/// Upper bounds for the JSON size of a quantity at a point, and of everything else.
const JSON_PLACE_BYTES: usize = 160;
const JSON_REST_BYTES: usize = 1 << 16;

#[derive(Debug, Deserialize, IntoParams)]
#[serde(deny_unknown_fields)]
#[into_params(parameter_in = Query)]
pub(super) struct StatisticsQuery {
    /// Quantities to return as maps, separated by commas: `u_mean`, `v_mean`, `w_mean`, `u_rms`, ...,
    /// `uu`, `vv`, `ww`, `uv`, `uw`, `vw`, `u_skewness`, ..., or `all`. Default: none.
    quantities: Option<String>,
}

/// The statistics of the run so far.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = Statistics)]
pub(super) struct StatisticsView {
    /// Number of shots.
    shots: u64,
    grid: GridView,
    /// Number of valid vectors at each point.
    samples: Vec<u64>,
    maps: Vec<MapView>,
    /// Parts of the run, from a twenty-third of the shots to all.
    convergence: Vec<ConvergenceView>,
    /// One per axis: x, y, z.
    correlations: Vec<CorrelationView>,
}

/// A quantity at each point, in the order z, y, x; null where there are too few samples.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = StatisticsMap)]
struct MapView {
    quantity: String,
    /// `m/s`, `m2/s2` or `1`.
    unit: &'static str,
    value: Vec<Option<f32>>,
    /// Standard uncertainty due to the flow's fluctuations and the finite number of shots.
    flow_uncertainty: Vec<Option<f32>>,
    /// Standard uncertainty due to the uncertainty of each measured velocity.
    measurement_uncertainty: Vec<Option<f32>>,
    /// Bounds of the 95 % interval, from both uncertainties.
    low: Vec<Option<f32>>,
    high: Vec<Option<f32>>,
}

/// Root-mean-square over the points of means and standard deviations of u, v, w, from the first
/// shots.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = StatisticsConvergence)]
struct ConvergenceView {
    shots: u64,
    mean_uncertainty_m_s: [f64; 3],
    mean_difference_m_s: [f64; 3],
    /// Expected difference for independent shots.
    mean_difference_expected_m_s: [f64; 3],
    rms_difference_m_s: [f64; 3],
}

/// Two-point correlation and spectrum of u, v, w along an axis.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = StatisticsCorrelation)]
struct CorrelationView {
    axis: &'static str,
    separation_mm: Vec<f64>,
    covariance_m2_s2: Vec<[f64; 3]>,
    coefficient: Vec<[Option<f64>; 3]>,
    integral_scale_mm: [Option<f64>; 3],
    wavenumber_rad_mm: Vec<f64>,
    energy_m2_s2_mm: Vec<[f64; 3]>,
}

impl StatisticsView {
    fn new(ensemble: &Ensemble, quantities: &[Quantity]) -> Self {
        let estimates = match quantities.is_empty() {
            true => Estimates { counts: ensemble.counts(), values: Vec::new() },
            false => ensemble.estimates(),
        };
        let maps = quantities.iter().map(|quantity| MapView::new(&estimates, *quantity));
        Self {
            shots: ensemble.shots(),
            grid: GridView::new(ensemble.grid()),
            maps: maps.collect(),
            samples: estimates.counts,
            convergence: ensemble.convergence().into_iter().map(ConvergenceView::from).collect(),
            correlations: ensemble.correlations().into_iter().map(CorrelationView::from).collect(),
        }
    }
}

impl MapView {
    fn new(estimates: &Estimates, quantity: Quantity) -> Self {
        let of = |part: fn(&Estimate) -> f64| {
            let number = |estimate: &Option<Estimate>| estimate.as_ref().map(|e| part(e) as f32);
            estimates.of(quantity).iter().map(number).collect()
        };
        Self {
            quantity: quantity.name(),
            unit: match quantity {
                Quantity::Mean(_) | Quantity::Rms(_) => "m/s",
                Quantity::Stress(..) => "m2/s2",
                Quantity::Skewness(_) => "1",
            },
            value: of(|e| e.value),
            flow_uncertainty: of(|e| e.flow_uncertainty),
            measurement_uncertainty: of(|e| e.measurement_uncertainty),
            low: of(|e| e.interval_95[0]),
            high: of(|e| e.interval_95[1]),
        }
    }
}

impl From<Convergence> for ConvergenceView {
    fn from(step: Convergence) -> Self {
        Self {
            shots: step.shots,
            mean_uncertainty_m_s: step.mean_uncertainty_m_s,
            mean_difference_m_s: step.mean_difference_m_s,
            mean_difference_expected_m_s: step.mean_difference_expected_m_s,
            rms_difference_m_s: step.rms_difference_m_s,
        }
    }
}

impl From<Correlation> for CorrelationView {
    fn from(correlation: Correlation) -> Self {
        let spectrum = correlation.spectrum();
        Self {
            axis: ["x", "y", "z"][correlation.axis],
            integral_scale_mm: correlation.integral_scale_mm(),
            separation_mm: correlation.separation_mm,
            covariance_m2_s2: correlation.covariance_m2_s2,
            coefficient: correlation.coefficient,
            wavenumber_rad_mm: spectrum.wavenumber_rad_mm,
            energy_m2_s2_mm: spectrum.energy_m2_s2_mm,
        }
    }
}

/// Ensemble statistics of the valid vectors so far: means, fluctuations, Reynolds stresses, skewness with
/// intervals; convergence; two-point correlations and spectra.
#[utoipa::path(get, path = "/api/v1/statistics", tag = "results",
    params(StatisticsQuery),
    responses(
        (status = 200, description = "The statistics", body = StatisticsView),
        (status = 404, description = "No shot has a result yet", body = super::error::ErrorBody)))]
pub(super) async fn statistics(
    State(app): State<App>,
    Arguments(query): Arguments<StatisticsQuery>,
) -> Result<Response, ApiError> {
    let quantities = wanted(query.quantities.as_deref().unwrap_or_default())?;
    let Some(ensemble) = app.run.board.statistics().now() else {
        return Err(ApiError::not_found("no shot has a result yet"));
    };
    let bytes = JSON_REST_BYTES + ensemble.grid().len() * JSON_PLACE_BYTES * (1 + quantities.len());
    let made = move || {
        serde_json::to_vec(&StatisticsView::new(&ensemble, &quantities)).map_err(|error| {
            ApiError::internal(format!("the statistics cannot be encoded as JSON: {error}"))
        })
    };
    let body = app.work.make(bytes, made).await?;
    let mut headers = HeaderMap::new();
    headers.insert(header::CONTENT_TYPE, HeaderValue::from_static("application/json"));
    headers.insert(header::CACHE_CONTROL, HeaderValue::from_static("no-store"));
    Ok((headers, body).into_response())
}

/// Parses a comma-separated list of quantities.
fn wanted(list: &str) -> Result<Vec<Quantity>, ApiError> {
    let names = list.split(',').map(str::trim).filter(|name| !name.is_empty());
    let mut quantities = Vec::new();
    for name in names {
        match Quantity::ALL.into_iter().find(|quantity| quantity.name() == name) {
            _ if name == "all" => return Ok(Quantity::ALL.to_vec()),
            Some(quantity) if quantities.contains(&quantity) => {}
            Some(quantity) => quantities.push(quantity),
            None => {
                let known = Quantity::ALL.map(Quantity::name).join(", ");
                return Err(ApiError::bad_request(format!(
                    "'{name}' is not a quantity: give some of {known}, or all"
                )));
            }
        }
    }
    Ok(quantities)
}
