//! The image of a point against ray tracing that shares nothing with it.

use lfpiv_core::model::{CameraCalibration, PointBlur, PointCamera, PointFootprint, VolumeGrid};
use lfpiv_hw::{CameraName, Pose};
use lfpiv_sim::imaging::{PointSource, RaySettings, RayTracer};

use crate::test_bench::{optics, poses};

const ELECTRONS: f64 = 1e6;
const RAYS: usize = 1 << 20;

/// In focus, near it, far from it, and off the axis.
const PLACES_MM: [[f64; 3]; 6] = [
    [0.037, 0.013, 0.021],
    [0.537, -0.313, 0.171],
    [-2.113, 0.429, -0.812],
    [3.917, -3.614, 3.873],
    [-4.131, 3.771, -3.952],
    [1.011, -3.127, 0.004],
];

/// Sum of absolute differences between the traced and the modelled image over the traced light, and
/// how much more light the model has.
fn apart(pose: &Pose, camera: usize, place_mm: [f64; 3], diffraction_nm: Option<f64>) -> [f64; 2] {
    let (optics, volume) =
        (optics(), VolumeGrid { voxels: [100, 80, 80], voxel_mm: 0.1, centre_mm: [0.0; 3] });
    // Gaussians of 0.42 wavelengths times f/8, and of as much on the sensor.
    let sigma_mm = diffraction_nm.map_or(0.0, |nm| 0.42 * nm * 1e-6 * 8.0);
    let blur = PointBlur { plane_mm: sigma_mm, sensor_px: sigma_mm / optics.pixel_pitch_mm() };
    let uncalibrated = CameraCalibration::default();
    let model =
        PointCamera::new(&optics, pose, &uncalibrated, &volume, CameraName(camera), blur).unwrap();
    let settings = RaySettings { rays_per_particle: RAYS, diffraction_nm };
    let source = PointSource { id: 0, position_mm: place_mm, electrons: ELECTRONS };
    let traced = RayTracer::new(&optics, pose, &settings).trace(&[source], &[3]);
    let mut footprint = PointFootprint::default();
    model.image(place_mm, &mut footprint);
    let mut image = vec![0.0f64; traced.electrons().len()];
    let unit = ELECTRONS * model.light_per_cell() / 255.0;
    for patch in &footprint.patches {
        for (r, row) in footprint.of(0, &patch.rows).iter().enumerate() {
            let first = (patch.rows.first_px + r) * optics.sensor.columns + patch.columns.first_px;
            let open = &model.open_shares()[patch.open + r * model.open_stride()..];
            for (c, column) in footprint.of(0, &patch.columns).iter().enumerate() {
                image[first + c] += unit * f64::from(row * column) * f64::from(open[c]);
            }
        }
    }
    let total: f64 = image.iter().sum();
    let apart: f64 =
        image.iter().zip(traced.electrons()).map(|(a, &b)| (a - f64::from(b)).abs()).sum();
    [apart / traced.total(), total / traced.total() - 1.0]
}

#[test]
fn the_image_of_a_point_is_that_of_traced_rays() {
    for (camera, pose) in poses().iter().enumerate() {
        for place in PLACES_MM {
            let [sharp, light] = apart(pose, camera, place, None);
            let [blurred, blurred_light] = apart(pose, camera, place, Some(532.0));
            println!(
                "camera {camera}, {place:?}: {:.2} % apart, {:.2} % of light; with diffraction \
                 {:.2} %, {:.2} %",
                100.0 * sharp,
                100.0 * light,
                100.0 * blurred,
                100.0 * blurred_light
            );
            assert!(sharp < 0.03 && light.abs() < 0.005);
            // Some light is spread beyond the micro-images, onto pixels that the model leaves dark.
            assert!(blurred < 0.06 && blurred_light.abs() < 0.02);
        }
    }
}
