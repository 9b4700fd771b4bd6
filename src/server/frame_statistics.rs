//! `/api/v1/shots/{shot}/frames/{camera}/statistics`: light, focus and aperture from a camera's
//! images.

use axum::{
    extract::State,
    http::{HeaderMap, HeaderValue, header},
    response::{IntoResponse, Response},
};
use lfpiv_core::lightfield::{
    AxisSampling, ImageSettings, LightLevels, MeanMicroImage, PhotometricZones,
};
use lfpiv_hw::{Optics, RawImage};
use serde::Serialize;
use utoipa::ToSchema;

use super::{
    ApiError,
    app::App,
    extract::Params,
    frames::{camera_index, frame_shot, unavailable},
};

/// Largest number of histogram bins.
const BINS: usize = 256;
/// Upper bound for the size of a response.
const ANSWER_BYTES: usize = 64 << 10;

/// Statistics of a camera's two images of a shot.
#[derive(Debug, Serialize, ToSchema)]
#[schema(as = FrameStatistics)]
pub(super) struct StatisticsView {
    shot: u64,
    camera: String,
    configured: ConfiguredMicroImages,
    /// Frames a and b.
    frames: Vec<FrameView>,
    /// Light of frame a over that of frame b; absent if b is dark.
    a_over_b: Option<f64>,
}

/// Micro-images according to the configured optics.
#[derive(Debug, Serialize, ToSchema)]
struct ConfiguredMicroImages {
    /// Columns and rows of the sensor.
    sensor_px: [usize; 2],
    pitch_px: f64,
    /// Diameter of the image of the aperture.
    diameter_px: f64,
    /// Column and row of the centre of the micro-image nearest to the sensor's centre, measured
    /// from the centre of the first pixel.
    middle_px: [f64; 2],
    /// F-number of the main lens.
    f_number: f64,
}

/// Statistics of one image.
#[derive(Debug, Serialize, ToSchema)]
struct FrameView {
    least_counts: u16,
    greatest_counts: u16,
    /// Black level, from the dark corners of the micro-images.
    offset_counts: f64,
    noise_counts: f64,
    /// Mean light of the open pixels, above black level and background.
    light_counts: f64,
    background_counts: f64,
    /// Share of the open pixels with light of particles.
    bright_share: f64,
    /// Particles per microlens in the middle of the volume; absent if no light stands out.
    seeding_ppm: Option<f64>,
    /// Absent if no pixel is saturated.
    saturation_counts: Option<u16>,
    saturated_share: f64,
    /// Pixels per bin, starting at 0 counts.
    histogram: Vec<u64>,
    /// Counts per bin.
    bin_counts: u32,
    /// Absent if the micro-images cannot be distinguished.
    micro_image: Option<MicroImageView>,
}

/// The mean micro-image.
#[derive(Debug, Serialize, ToSchema)]
struct MicroImageView {
    /// Number of cells along an edge.
    cells: usize,
    /// Light of each cell in counts above black level, row by row, top row first.
    light: Vec<f64>,
    /// Diameter of the image of the aperture in pitches; absent if light does not fall to half.
    diameter_pitches: Option<f64>,
    /// The f-number of the main lens that gives this diameter.
    f_number: Option<f64>,
    /// Distance over which light falls from 80 % to 20 %.
    edge_px: Option<f64>,
    /// Light in the corners over light in the centre.
    corner_share: f64,
}

/// Statistics of a camera's two images: histogram, saturation, light, and the mean micro-image,
/// from which aperture and focus can be judged.
#[utoipa::path(get, path = "/api/v1/shots/{shot}/frames/{camera}/statistics", tag = "shots",
    params(
        ("shot" = String, Path, description = "Shot number, from 0, or `latest`."),
        ("camera" = usize, Path, minimum = 1, description = "Camera: 1 or cam1 for the first.")),
    responses(
        (status = 200, body = StatisticsView),
        (status = 404, description = "No such shot or camera", body = super::error::ErrorBody),
        (status = 410, description = "The frames are no longer available", body = super::error::ErrorBody)))]
pub(super) async fn statistics(
    State(app): State<App>,
    Params((shot, camera)): Params<(String, String)>,
) -> Result<Response, ApiError> {
    let shot = frame_shot(&app, &shot)?;
    let names = &app.run.info.configuration.cameras;
    let camera = camera_index(&camera, names.len())?;
    let name = names[camera].clone();
    let bench = app.run.bench.clone();
    let bench =
        bench.ok_or_else(|| ApiError::not_found("this server has no configuration of a bench"))?;
    let known = app.run.ledger.lock().entry(shot).is_some();
    let frames = app.run.frames.clone();
    let made = move || {
        let image = |half| frames.frame(shot, camera, half).ok_or_else(|| unavailable(shot, known));
        let images = [image(0)?, image(1)?];
        let view = view((shot, name), &bench.optics, &images, |image, levels| {
            bench.views.seeding_ppm(camera, image, levels)
        });
        serde_json::to_vec(&view).map_err(|error| ApiError::internal(error.to_string()))
    };
    let json = app.work.make(ANSWER_BYTES, made).await?;
    let mut headers = HeaderMap::new();
    headers.insert(header::CONTENT_TYPE, HeaderValue::from_static("application/json"));
    Ok((headers, json).into_response())
}

fn view(
    (shot, camera): (u64, String),
    optics: &Optics,
    images: &[RawImage; 2],
    seeding_ppm: impl Fn(&RawImage, &LightLevels) -> Option<f64>,
) -> StatisticsView {
    let zones =
        PhotometricZones::new(optics, &AxisSampling::columns(optics), &AxisSampling::rows(optics));
    let levels = images.each_ref().map(|image| zones.levels(image, &ImageSettings::default()));
    let [a, b] = levels.each_ref().map(|levels| levels.mean_signal_counts);
    let frames = images
        .iter()
        .zip(&levels)
        .map(|(image, levels)| frame(optics, image, levels, seeding_ppm(image, levels)));
    StatisticsView {
        shot,
        camera,
        configured: configured(optics),
        frames: frames.collect(),
        a_over_b: (b > 0.0).then(|| a / b),
    }
}

fn configured(optics: &Optics) -> ConfiguredMicroImages {
    let (sensor, lens) = (&optics.sensor, &optics.microlens);
    let pixel_mm = optics.pixel_pitch_mm();
    let magnification = optics.micro_image_magnification();
    let middle = [lens.column_centre_mm(lens.columns / 2), lens.row_centre_mm(lens.rows / 2)];
    ConfiguredMicroImages {
        sensor_px: [sensor.columns, sensor.rows],
        pitch_px: optics.micro_image_pitch_mm() / pixel_mm,
        diameter_px: diameter_pitches(optics) * optics.micro_image_pitch_mm() / pixel_mm,
        middle_px: [
            (sensor.columns as f64 - 1.0) / 2.0 + middle[0] * magnification / pixel_mm,
            (sensor.rows as f64 - 1.0) / 2.0 - middle[1] * magnification / pixel_mm,
        ],
        f_number: optics.f_number,
    }
}

/// Diameter of the configured aperture's image over the micro-image pitch.
fn diameter_pitches(optics: &Optics) -> f64 {
    let picture_mm =
        optics.pupil_diameter_mm() * optics.microlens.focal_length_mm / optics.image_distance_mm();
    picture_mm / optics.micro_image_pitch_mm()
}

fn frame(
    optics: &Optics,
    image: &RawImage,
    levels: &LightLevels,
    seeding_ppm: Option<f64>,
) -> FrameView {
    let counts = image.counts();
    let greatest_counts = counts.iter().copied().max().unwrap_or_default();
    let bin_counts = (u32::from(greatest_counts) + 1).div_ceil(BINS as u32);
    let mut histogram = vec![0u64; (u32::from(greatest_counts) / bin_counts + 1) as usize];
    counts.iter().for_each(|&count| histogram[(u32::from(count) / bin_counts) as usize] += 1);
    FrameView {
        least_counts: counts.iter().copied().min().unwrap_or_default(),
        greatest_counts,
        offset_counts: levels.offset_counts,
        noise_counts: levels.noise_counts,
        light_counts: levels.mean_signal_counts,
        background_counts: levels.background_counts,
        bright_share: levels.bright_share,
        seeding_ppm,
        saturation_counts: levels.saturation_counts,
        saturated_share: levels.saturated_share,
        histogram,
        bin_counts,
        micro_image: MeanMicroImage::of(optics, image).map(|mean| micro_image(optics, mean)),
    }
}

fn micro_image(optics: &Optics, mean: MeanMicroImage) -> MicroImageView {
    let f_number =
        mean.diameter_pitches.map(|diameter| optics.f_number * diameter_pitches(optics) / diameter);
    MicroImageView {
        cells: mean.cells,
        light: mean.light,
        diameter_pitches: mean.diameter_pitches,
        f_number,
        edge_px: mean.edge_px,
        corner_share: mean.corner_share,
    }
}
