//! A measured shot on its way to the coordinator.

mod bytes;

use std::sync::Arc;

use lfpiv_core::{model::ModelChoice, reconstruction::FrameLight};

use super::{Attempt, ClusterError, Report};
use crate::archive::{ShotResult, sha256};

/// The result of a shot, and who made it. In bytes it is complete and exact, except that the forward model's choice
/// goes by its hash: coordinator and worker have made the same. Of the light, which is only looked at, it has the
/// projections.
#[derive(Debug, Clone)]
pub struct Delivery {
    pub shot: u64,
    pub attempt: Attempt,
    /// Name of the worker.
    pub worker: String,
    /// Hash of the choice in `result`.
    pub model_sha256: String,
    pub result: ShotResult,
}

impl Delivery {
    /// Bytes that [`Self::decode`] reads; they end in a checksum.
    pub fn encode(&self) -> Vec<u8> {
        bytes::encode(self)
    }

    /// Reads and checks a delivered result. Its forward model is `model`, which must be the one that it was made
    /// with.
    ///
    /// # Errors
    /// [`ClusterError::Refused`]: the bytes have changed, or the model is another one.
    pub fn decode(
        content: &[u8],
        model: &Arc<ModelChoice>,
        model_sha256: &str,
    ) -> Result<Self, ClusterError> {
        let mut delivery = bytes::decode(content).map_err(ClusterError::Refused)?;
        if delivery.model_sha256 != model_sha256 {
            return Err(ClusterError::Refused(format!(
                "shot {} was measured with another forward model than the run's",
                delivery.shot
            )));
        }
        delivery.result.measured.model = model.clone();
        Ok(delivery)
    }

    /// Takes the light out, which is for now only, and not for the log.
    pub fn take_light(&mut self) -> Option<[FrameLight; 2]> {
        self.result.measured.light.take()
    }

    /// What a [`super::Tally`] takes in.
    pub fn report(&self) -> Report {
        Report::Delivered {
            attempt: self.attempt,
            worker: self.worker.clone(),
            result_sha256: self.result_sha256(),
        }
    }

    /// Hash of what was measured: equal for equal results, whoever made them and however long it took.
    pub fn result_sha256(&self) -> String {
        sha256(&bytes::result_bytes(self))
    }
}

#[cfg(test)]
mod tests {
    use lfpiv_core::{
        reconstruction::{CameraFit, FitVerdict, MaximumProjection, ModelFit},
        velocimetry::{
            MeasuredParticle, PairResult, StageSeconds, VectorGrid, VectorStatus, VelocityField,
        },
    };
    use proptest::prelude::*;

    use super::*;
    use crate::archive::{RawLevel, ShotTime};

    fn particle() -> impl Strategy<Value = MeasuredParticle> {
        (any::<[f64; 3]>(), any::<[u32; 11]>(), any::<bool>()).prop_map(|(at_mm, bits, agrees)| {
            let [a, b, c, d, e, f, g, h, i, j, k] = bits.map(f32::from_bits);
            MeasuredParticle {
                at_mm,
                place_uncertainty_vox: [a, b, c],
                displacement_vox: [d, e, f],
                uncertainty_vox: [g, h, i],
                light: [j, k],
                agrees,
            }
        })
    }

    /// The projections of a frame of 2 × 1 × 1 voxels.
    fn light() -> impl Strategy<Value = FrameLight> {
        any::<[u32; 5]>().prop_map(|bits| {
            let [a, b, c, d, e] = bits.map(f32::from_bits);
            let plane = |size, intensity| MaximumProjection { size, intensity };
            let projections =
                [plane([2, 1], vec![a, b]), plane([2, 1], vec![c, d]), plane([1, 1], vec![e])];
            FrameLight { volume: None, projections }
        })
    }

    /// Any result of 3 × 2 × 1 vectors.
    fn delivery() -> impl Strategy<Value = Delivery> {
        let numbers = || any::<[u32; 6]>().prop_map(|bits| bits.map(f32::from_bits));
        let triples = move || {
            (numbers(), numbers(), numbers())
                .prop_map(|(x, y, z)| (0..6).map(|n| [x[n], y[n], z[n]]).collect::<Vec<_>>())
        };
        let fit = proptest::option::of((any::<[f64; 3]>(), any::<Option<f64>>(), ".{0,9}"));
        let light = proptest::option::of([light(), light()]);
        let fit = (fit, proptest::option::of(proptest::collection::vec(particle(), 0..4)), light);
        let arrays = (triples(), triples(), triples(), numbers(), numbers(), any::<[u8; 6]>());
        let scalars = (any::<[f64; 10]>(), proptest::option::of(any::<(i64, u64, bool)>()));
        let names = (any::<u64>(), any::<[u32; 2]>(), ".{0,9}", ".{0,9}");
        (arrays, scalars, fit, names).prop_map(
            |(arrays, (f, time), (fit, particles, light), names)| {
                let (displacement_vox, uncertainty_vox, vorticity, peaks, divergence, states) =
                    arrays;
                let cycle = [
                    VectorStatus::Valid,
                    VectorStatus::Replaced,
                    VectorStatus::Invalid,
                    VectorStatus::Masked,
                ];
                let field = VelocityField {
                    grid: VectorGrid {
                        vectors: [3, 2, 1],
                        first_mm: [f[0], f[1], f[2]],
                        spacing_mm: f[3],
                    },
                    displacement_vox,
                    uncertainty_vox,
                    status: states.iter().map(|n| cycle[usize::from(*n) % 4]).collect(),
                    peak_ratio: peaks.to_vec(),
                    vorticity,
                    divergence: divergence.to_vec(),
                    has_gradient: states.iter().map(|n| n & 64 != 0).collect(),
                    voxel_mm: f[4],
                    dt_s: f[5],
                };
                let seconds = StageSeconds {
                    decode_s: f[6],
                    reconstruct_s: f[7],
                    correlate_s: f[8],
                    judge_s: f[9],
                };
                let fit = fit.map(|(numbers, unknown, cause)| ModelFit {
                    verdict: FitVerdict::Doubtful,
                    cameras: vec![CameraFit {
                        unexplained: numbers[0],
                        micro_image_offset_px: unknown,
                    }],
                    camera_agreement: unknown,
                    camera_disparity_mm: Some(numbers[1]),
                    valid_share: numbers[2],
                    causes: vec![cause],
                });
                let (shot, [issue, delivery], worker, warning) = names;
                let time = time.map(|(utc_ns, uncertainty_ns, clock_synchronised)| ShotTime {
                    utc_ns,
                    uncertainty_ns,
                    clock_synchronised,
                });
                let measured = PairResult {
                    field,
                    seconds,
                    warnings: vec![warning],
                    model: Default::default(),
                    fit,
                    light,
                    particles,
                };
                Delivery {
                    shot,
                    attempt: Attempt { issue, delivery },
                    worker,
                    model_sha256: "model".into(),
                    result: ShotResult { measured, time, raw: RawLevel::Synced },
                }
            },
        )
    }

    proptest! {
        #[test]
        fn a_result_is_read_bit_for_bit_as_it_was_delivered(delivery in delivery()) {
            let bytes = delivery.encode();
            let model = Arc::new(ModelChoice::default());
            let read = Delivery::decode(&bytes, &model, "model").unwrap();
            // Debug text tells numbers apart, except for kinds of NaN; the bytes do that.
            prop_assert_eq!(format!("{read:?}"), format!("{delivery:?}"));
            prop_assert_eq!(read.encode(), bytes);
            prop_assert_eq!(read.result_sha256(), delivery.result_sha256());
            prop_assert!(Delivery::decode(&read.encode(), &model, "other").is_err());
        }

        #[test]
        fn changed_bytes_are_refused(delivery in delivery(), at: prop::sample::Index, bit in 0..8_u8) {
            let mut bytes = delivery.encode();
            let model = Arc::new(ModelChoice::default());
            let at = at.index(bytes.len());
            prop_assert!(Delivery::decode(&bytes[..at], &model, "model").is_err());
            bytes[at] ^= 1 << bit;
            prop_assert!(Delivery::decode(&bytes, &model, "model").is_err());
        }

        #[test]
        fn the_hash_tells_what_was_measured_and_not_by_whom(delivery in delivery()) {
            let mut other = delivery.clone();
            other.worker.push('x');
            other.attempt.delivery = other.attempt.delivery.wrapping_add(1);
            other.result.measured.seconds.judge_s = 1.5;
            other.take_light();
            prop_assert_eq!(other.result_sha256(), delivery.result_sha256());
            let number = &mut other.result.measured.field.displacement_vox[2][1];
            *number = f32::from_bits(number.to_bits() ^ 1);
            prop_assert_ne!(other.result_sha256(), delivery.result_sha256());
        }
    }
}
