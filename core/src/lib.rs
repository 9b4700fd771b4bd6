//! Light-field images to velocity: no files, no devices and no clock.
//!
//! The modules, the lowest first: [`lightfield`] decodes images into views, [`model`] says which pixel
//! sees which voxel, [`reconstruction`] finds the volume behind the views, [`particles`] places
//! particles in the images, [`velocimetry`] finds the displacement between two volumes, [`ensemble`]
//! what many shots say together, [`calibration`] how a camera sees the volume, [`measurement`] does
//! all of it for a pair of images.
//!
//! # Images in, vectors out
//!
//! Lengths are in mm, displacements in voxels, times in s; arrays are stored in the order z, y, x.
//!
//! ```
//! use lfpiv_core::{
//!     lightfield::{ImagePair, ImageSettings},
//!     measurement::{Measurement, Processor},
//!     model::{ModelSettings, VolumeGrid},
//!     reconstruction::ReconstructionSettings,
//!     velocimetry::VelocimetrySettings,
//! };
//! use lfpiv_hw::{MicrolensArray, Optics, Pose, Sensor};
//! use nalgebra::Vector3;
//!
//! let optics = Optics {
//!     focal_length_mm: 100.0,
//!     f_number: 4.0,
//!     object_distance_mm: 200.0,
//!     microlens: MicrolensArray { pitch_mm: 0.1, focal_length_mm: 0.8, columns: 41, rows: 41 },
//!     sensor: Sensor { columns: 748, rows: 748, pixel_pitch_um: 5.5 },
//! };
//! // right, up and axis of each camera; axis points from the volume to the camera.
//! let (x, y, z) = (Vector3::x(), Vector3::y(), Vector3::z());
//! let cameras = vec![
//!     Pose { right: x, up: y, axis: z, origin_mm: Vector3::zeros() },
//!     Pose { right: x, up: -z, axis: y, origin_mm: Vector3::zeros() },
//! ];
//! let volume = VolumeGrid { voxels: [24, 20, 20], voxel_mm: 0.1, centre_mm: [0.0; 3] };
//! # let velocity_m_s = [1.0, 0.5, -0.5];
//! # let bench = lfpiv_sim::BenchGeometry {
//! #     optics: optics.clone(),
//! #     poses: cameras.clone(),
//! #     volume: lfpiv_sim::Volume { voxels: [24, 20, 20], voxel_mm: 0.1, centre_mm: [0.0; 3] },
//! #     dt_s: 1e-4,
//! #     empty: None,
//! # };
//! # let flow = lfpiv_sim::Flow::Uniform(lfpiv_sim::flow::Uniform { velocity_m_s });
//! # let images = lfpiv_sim::Scene { ppm: 0.5, flow, ..Default::default() }.shot(&bench, 1, 0).images;
//!
//! // `images`: frames a and b (`lfpiv_hw::RawImage`) of every camera.
//! let pair = ImagePair { cameras: images };
//! let processor = Processor::new(Measurement {
//!     optics,
//!     cameras,
//!     calibrations: Vec::new(), // Uncalibrated cameras.
//!     volume,
//!     mask: None, // All of the volume is flow.
//!     image: ImageSettings::default(),
//!     model: ModelSettings::default(),
//!     reconstruction: ReconstructionSettings::default(),
//!     velocimetry: VelocimetrySettings {
//!         window_mm: 0.8,
//!         max_displacement_vox: 2.0,
//!         ..VelocimetrySettings::default()
//!     },
//!     spacing_mm: None, // As far apart as the windows.
//!     dt_s: 1e-4,
//! })?;
//! let result = processor.process(pair)?;
//!
//! let field = &result.field;
//! for (n, displacement_vox) in field.displacement_vox.iter().enumerate() {
//!     let place_mm = field.grid.position_mm(n);
//!     println!("{place_mm:?}: {displacement_vox:?}, {:?}", field.status[n]);
//! }
//! # let mean = |c: usize| {
//! #     field.displacement_vox.iter().map(|d| f64::from(d[c])).sum::<f64>() / field.grid.len() as f64
//! # };
//! # assert!(field.valid_share() > 0.8, "{}", field.valid_share());
//! # for c in 0..3 {
//! #     assert!((mean(c) - velocity_m_s[c]).abs() < 0.1, "{c}: {}", mean(c));
//! # }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A [`measurement::Processor`] is made once, with tables and plans, and measures any number of pairs on
//! rayon's threads. The stages can be had one by one: [`reconstruction::Reconstructor`] from views to
//! a volume, [`velocimetry::Interrogation`] from two volumes to vectors.

pub mod calibration;
mod clock;
pub mod ensemble;
pub mod lightfield;
pub mod measurement;
pub mod model;
mod parabola;
pub mod particles;
pub mod reconstruction;
pub mod statistics;
pub mod velocimetry;

pub use clock::{Clock, untimed};

#[cfg(test)]
mod test_bench;
