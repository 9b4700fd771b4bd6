//! The bytes of a delivered result. All numbers are little-endian; floating-point numbers go by their bits.
//!
//! | bytes | content |
//! |---|---|
//! | 8 | `LFPIVRES` |
//! | 4 | version: [`PROTOCOL`] |
//! | | issue and delivery of the attempt (4 each), name of the worker, seconds of the four stages |
//! | | the result: what [`super::Delivery::result_sha256`] covers |
//! | | the light's largest intensities along z, y and x in frames a and b, where the page is to show them |
//! | 32 | SHA-256 of all bytes before it |
//!
//! A text or a list is its length in 4 bytes and its items; what may be absent has a byte 0 or 1 before it.

use lfpiv_core::{
    reconstruction::{CameraFit, FitVerdict, FrameLight, MaximumProjection, ModelFit},
    velocimetry::{
        MeasuredParticle, PairResult, StageSeconds, VectorGrid, VectorStatus, VelocityField,
    },
};
use ring::digest::{SHA256, SHA256_OUTPUT_LEN, digest};

use super::{Attempt, Delivery};
use crate::{
    archive::{RawLevel, ShotResult, ShotTime},
    cluster::PROTOCOL,
};

const MAGIC: [u8; 8] = *b"LFPIVRES";
const STATUS: [VectorStatus; 4] =
    [VectorStatus::Valid, VectorStatus::Replaced, VectorStatus::Invalid, VectorStatus::Masked];
const VERDICTS: [FitVerdict; 3] = [FitVerdict::Good, FitVerdict::Doubtful, FitVerdict::Poor];
const LEVELS: [RawLevel; 5] =
    [RawLevel::NotKept, RawLevel::Lost, RawLevel::Acquired, RawLevel::Written, RawLevel::Synced];

pub(super) fn encode(delivery: &Delivery) -> Vec<u8> {
    let mut to = Sink(MAGIC.to_vec());
    to.u32(PROTOCOL);
    to.u32(delivery.attempt.issue);
    to.u32(delivery.attempt.delivery);
    to.text(&delivery.worker);
    let StageSeconds { decode_s, reconstruct_s, correlate_s, judge_s } =
        delivery.result.measured.seconds;
    [decode_s, reconstruct_s, correlate_s, judge_s].into_iter().for_each(|seconds| to.f64(seconds));
    to.0.extend(result_bytes(delivery));
    to.optional(delivery.result.measured.light.as_ref(), |to, frames| {
        for plane in frames.iter().flat_map(|frame| &frame.projections) {
            plane.size.iter().for_each(|pixels| to.u32(*pixels as u32));
            to.list(&plane.intensity, |to, light| to.f32(*light));
        }
    });
    let checksum = digest(&SHA256, &to.0);
    to.0.extend(checksum.as_ref());
    to.0
}

/// What was measured.
pub(super) fn result_bytes(delivery: &Delivery) -> Vec<u8> {
    let mut to = Sink(Vec::new());
    to.u64(delivery.shot);
    to.text(&delivery.model_sha256);
    let ShotResult { measured, time, raw } = &delivery.result;
    to.index(&LEVELS, raw);
    to.optional(time.as_ref(), |to, time| {
        to.u64(time.utc_ns.cast_unsigned());
        to.u64(time.uncertainty_ns);
        to.0.push(u8::from(time.clock_synchronised));
    });
    to.list(&measured.warnings, |to, warning| to.text(warning));
    to.optional(measured.fit.as_ref(), put_fit);
    put_field(&mut to, &measured.field);
    to.optional(measured.particles.as_ref(), |to, particles| to.list(particles, put_particle));
    to.0
}

fn put_particle(to: &mut Sink, particle: &MeasuredParticle) {
    let MeasuredParticle {
        at_mm,
        place_uncertainty_vox,
        displacement_vox,
        uncertainty_vox,
        light,
        agrees,
    } = particle;
    at_mm.iter().for_each(|mm| to.f64(*mm));
    let vectors = [place_uncertainty_vox, displacement_vox, uncertainty_vox];
    for number in vectors.into_iter().flatten().chain(light) {
        to.f32(*number);
    }
    to.0.push(u8::from(*agrees));
}

fn put_fit(to: &mut Sink, fit: &ModelFit) {
    to.index(&VERDICTS, &fit.verdict);
    to.list(&fit.cameras, |to, camera| {
        to.f64(camera.unexplained);
        to.optional(camera.micro_image_offset_px.as_ref(), |to, offset| to.f64(*offset));
    });
    for number in [&fit.camera_agreement, &fit.camera_disparity_mm] {
        to.optional(number.as_ref(), |to, number| to.f64(*number));
    }
    to.f64(fit.valid_share);
    to.list(&fit.causes, |to, cause| to.text(cause));
}

fn put_field(to: &mut Sink, field: &VelocityField) {
    let VectorGrid { vectors, first_mm, spacing_mm } = &field.grid;
    vectors.iter().for_each(|count| to.u64(*count as u64));
    first_mm.iter().for_each(|mm| to.f64(*mm));
    for number in [*spacing_mm, field.voxel_mm, field.dt_s] {
        to.f64(number);
    }
    for triples in [&field.displacement_vox, &field.uncertainty_vox, &field.vorticity] {
        to.list(triples, |to, triple| triple.iter().for_each(|number| to.f32(*number)));
    }
    for numbers in [&field.peak_ratio, &field.divergence] {
        to.list(numbers, |to, number| to.f32(*number));
    }
    to.list(&field.status, |to, status| to.index(&STATUS, status));
    to.list(&field.has_gradient, |to, has| to.0.push(u8::from(*has)));
}

/// Reads [`encode`]'s bytes; the forward model is the default. The error says what is wrong.
pub(super) fn decode(bytes: &[u8]) -> Result<Delivery, String> {
    let content = bytes.len().checked_sub(SHA256_OUTPUT_LEN).map(|at| bytes.split_at(at));
    let Some((content, checksum)) = content.filter(|(content, _)| content.starts_with(&MAGIC))
    else {
        return Err("these bytes are no result".into());
    };
    if digest(&SHA256, content).as_ref() != checksum {
        return Err("its bytes have changed on the way".into());
    }
    let mut from = Unread(&content[MAGIC.len()..]);
    match from.u32() {
        Some(PROTOCOL) => {}
        version => return Err(format!("it has version {version:?}, and this is {PROTOCOL}")),
    }
    let delivery = take_delivery(&mut from).filter(|_| from.0.is_empty());
    let delivery = delivery.ok_or("its form is unknown")?;
    let field = &delivery.result.measured.field;
    let vectors = field.grid.vectors.iter().try_fold(1usize, |all, n| all.checked_mul(*n));
    let lengths = [
        field.displacement_vox.len(),
        field.uncertainty_vox.len(),
        field.vorticity.len(),
        field.peak_ratio.len(),
        field.divergence.len(),
        field.status.len(),
        field.has_gradient.len(),
    ];
    match lengths.iter().all(|length| Some(*length) == vectors) {
        true => Ok(delivery),
        false => Err("it does not have a value for each vector".into()),
    }
}

fn take_delivery(from: &mut Unread<'_>) -> Option<Delivery> {
    let attempt = Attempt { issue: from.u32()?, delivery: from.u32()? };
    let worker = from.text()?;
    let seconds = StageSeconds {
        decode_s: from.f64()?,
        reconstruct_s: from.f64()?,
        correlate_s: from.f64()?,
        judge_s: from.f64()?,
    };
    let shot = from.u64()?;
    let model_sha256 = from.text()?;
    let raw = from.index(&LEVELS)?;
    let time = from.optional(|from| {
        Some(ShotTime {
            utc_ns: from.u64()?.cast_signed(),
            uncertainty_ns: from.u64()?,
            clock_synchronised: from.flag()?,
        })
    })?;
    let warnings = from.list(Unread::text)?;
    let fit = from.optional(take_fit)?;
    let field = take_field(from)?;
    let particles = from.optional(|from| from.list(take_particle))?;
    let light = from.optional(|from| Some([take_light(from)?, take_light(from)?]))?;
    let measured =
        PairResult { field, seconds, warnings, model: Default::default(), fit, light, particles };
    let result = ShotResult { measured, time, raw };
    Some(Delivery { shot, attempt, worker, model_sha256, result })
}

fn take_fit(from: &mut Unread<'_>) -> Option<ModelFit> {
    Some(ModelFit {
        verdict: from.index(&VERDICTS)?,
        cameras: from.list(|from| {
            Some(CameraFit {
                unexplained: from.f64()?,
                micro_image_offset_px: from.optional(Unread::f64)?,
            })
        })?,
        camera_agreement: from.optional(Unread::f64)?,
        camera_disparity_mm: from.optional(Unread::f64)?,
        valid_share: from.f64()?,
        causes: from.list(Unread::text)?,
    })
}

fn take_field(from: &mut Unread<'_>) -> Option<VelocityField> {
    let count = |from: &mut Unread<'_>| usize::try_from(from.u64()?).ok();
    let vectors = [count(from)?, count(from)?, count(from)?];
    let first_mm = [from.f64()?, from.f64()?, from.f64()?];
    let (spacing_mm, voxel_mm, dt_s) = (from.f64()?, from.f64()?, from.f64()?);
    let triple = |from: &mut Unread<'_>| Some([from.f32()?, from.f32()?, from.f32()?]);
    Some(VelocityField {
        grid: VectorGrid { vectors, first_mm, spacing_mm },
        displacement_vox: from.list(triple)?,
        uncertainty_vox: from.list(triple)?,
        vorticity: from.list(triple)?,
        peak_ratio: from.list(Unread::f32)?,
        divergence: from.list(Unread::f32)?,
        status: from.list(|from| from.index(&STATUS))?,
        has_gradient: from.list(Unread::flag)?,
        voxel_mm,
        dt_s,
    })
}

/// The projections of a frame's light, each with all of its pixels.
fn take_light(from: &mut Unread<'_>) -> Option<FrameLight> {
    let projections = [take_plane(from)?, take_plane(from)?, take_plane(from)?];
    Some(FrameLight { volume: None, projections })
}

fn take_plane(from: &mut Unread<'_>) -> Option<MaximumProjection> {
    let size = [from.u32()? as usize, from.u32()? as usize];
    let intensity = from.list(Unread::f32)?;
    (size[0].checked_mul(size[1]) == Some(intensity.len()))
        .then_some(MaximumProjection { size, intensity })
}

fn take_particle(from: &mut Unread<'_>) -> Option<MeasuredParticle> {
    let mut particle = MeasuredParticle {
        at_mm: [from.f64()?, from.f64()?, from.f64()?],
        place_uncertainty_vox: [from.f32()?, from.f32()?, from.f32()?],
        displacement_vox: [from.f32()?, from.f32()?, from.f32()?],
        uncertainty_vox: [from.f32()?, from.f32()?, from.f32()?],
        light: Default::default(),
        agrees: false,
    };
    for light in &mut particle.light {
        *light = from.f32()?;
    }
    particle.agrees = from.flag()?;
    Some(particle)
}

struct Sink(Vec<u8>);

impl Sink {
    fn u32(&mut self, number: u32) {
        self.0.extend(number.to_le_bytes());
    }

    fn u64(&mut self, number: u64) {
        self.0.extend(number.to_le_bytes());
    }

    fn f32(&mut self, number: f32) {
        self.u32(number.to_bits());
    }

    fn f64(&mut self, number: f64) {
        self.u64(number.to_bits());
    }

    fn text(&mut self, text: &str) {
        self.u32(text.len() as u32);
        self.0.extend(text.as_bytes());
    }

    fn list<T>(&mut self, items: &[T], put: impl Fn(&mut Self, &T)) {
        self.u32(items.len() as u32);
        items.iter().for_each(|item| put(self, item));
    }

    fn optional<T: ?Sized>(&mut self, item: Option<&T>, put: impl Fn(&mut Self, &T)) {
        self.0.push(u8::from(item.is_some()));
        if let Some(item) = item {
            put(self, item);
        }
    }

    /// The item's place among all that there are.
    fn index<T: PartialEq>(&mut self, all: &[T], item: &T) {
        let at = all.iter().position(|other| other == item);
        self.0.push(at.map_or(u8::MAX, |at| at as u8));
    }
}

/// The bytes that are left. `None`: there are too few, or they mean nothing.
struct Unread<'a>(&'a [u8]);

impl Unread<'_> {
    fn array<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (found, left) = self.0.split_first_chunk()?;
        self.0 = left;
        Some(*found)
    }

    fn u32(&mut self) -> Option<u32> {
        self.array().map(u32::from_le_bytes)
    }

    fn u64(&mut self) -> Option<u64> {
        self.array().map(u64::from_le_bytes)
    }

    fn f32(&mut self) -> Option<f32> {
        self.u32().map(f32::from_bits)
    }

    fn f64(&mut self) -> Option<f64> {
        self.u64().map(f64::from_bits)
    }

    fn flag(&mut self) -> Option<bool> {
        self.index(&[false, true])
    }

    fn text(&mut self) -> Option<String> {
        let length = self.u32()? as usize;
        let (text, left) = self.0.split_at_checked(length)?;
        self.0 = left;
        String::from_utf8(text.to_vec()).ok()
    }

    fn list<T>(&mut self, take: impl Fn(&mut Self) -> Option<T>) -> Option<Vec<T>> {
        let length = self.u32()? as usize;
        // Every item has a byte at least: no length is believed beyond that.
        (length <= self.0.len()).then(|| (0..length).map(|_| take(self)).collect())?
    }

    fn optional<T>(&mut self, take: impl Fn(&mut Self) -> Option<T>) -> Option<Option<T>> {
        if self.flag()? { take(self).map(Some) } else { Some(None) }
    }

    fn index<T: Clone>(&mut self, all: &[T]) -> Option<T> {
        let [at] = self.array()?;
        all.get(usize::from(at)).cloned()
    }
}
