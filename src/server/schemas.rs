//! JSON schemas of types from other modules, for the OpenAPI document. `tests/daemon` checks real
//! responses against it. Types of other crates are represented by a type here, which fields name as
//! `#[schema(value_type = …)]`.

use std::borrow::Cow;

use utoipa::{
    PartialSchema, ToSchema,
    openapi::{
        ObjectBuilder, Ref, RefOr, Schema,
        schema::{SchemaType, Type},
    },
};

use crate::{
    acquisition::{Account, ControlState, Mode, Outcome, OutcomeCounts},
    pipeline::{LatencyQuantiles, Watermarks},
};

/// An object whose members are required and have the same type.
fn numbers(of: Type, names: &[&str], description: &str) -> ObjectBuilder {
    names.iter().fold(ObjectBuilder::new().description(Some(description)), |object, name| {
        object
            .property(*name, ObjectBuilder::new().schema_type(SchemaType::Type(of.clone())))
            .required(*name)
    })
}

fn words(words: &[&str], description: &str) -> RefOr<Schema> {
    let object = ObjectBuilder::new().schema_type(SchemaType::Type(Type::String));
    object.enum_values(Some(words.iter().copied())).description(Some(description)).into()
}

macro_rules! schema {
    ($type:ty, $name:literal, $schema:expr) => {
        impl PartialSchema for $type {
            fn schema() -> RefOr<Schema> {
                $schema
            }
        }

        impl ToSchema for $type {
            fn name() -> Cow<'static, str> {
                Cow::Borrowed($name)
            }
        }
    };
}

/// The schema of [`lfpiv_core::velocimetry::StageSeconds`].
pub struct StageSecondsSchema;

/// The schema of [`lfpiv_core::velocimetry::VectorStatus`].
pub struct VectorStatusSchema;

/// The schema of [`lfpiv_core::reconstruction::FitVerdict`].
pub struct FitVerdictSchema;

/// The schema of [`lfpiv_core::reconstruction::ModelFit`].
pub struct ModelFitSchema;

/// The schema of [`crate::archive::RawLevel`].
pub struct RawLevelSchema;

/// The schema of [`crate::archive::ShotTime`].
pub struct ShotTimeSchema;

schema!(
    Outcome,
    "Outcome",
    words(&Outcome::ALL.map(Outcome::name), "Outcome of a trigger for one camera.")
);

schema!(
    OutcomeCounts,
    "OutcomeCounts",
    numbers(Type::Integer, &Outcome::ALL.map(Outcome::name), "Number of triggers by outcome.")
        .into()
);

impl PartialSchema for Account {
    fn schema() -> RefOr<Schema> {
        numbers(Type::Integer, &["triggers", "open"], "triggers = open + all outcomes.")
            .property("outcomes", Ref::from_schema_name("OutcomeCounts"))
            .required("outcomes")
            .into()
    }
}

impl ToSchema for Account {
    fn schemas(schemas: &mut Vec<(String, RefOr<Schema>)>) {
        schemas.push(("OutcomeCounts".to_owned(), OutcomeCounts::schema()));
    }
}

schema!(
    StageSecondsSchema,
    "StageSeconds",
    numbers(
        Type::Number,
        &["decode_s", "reconstruct_s", "correlate_s", "judge_s"],
        "Time per stage, in s."
    )
    .into()
);

schema!(
    Watermarks,
    "Watermarks",
    numbers(
        Type::Integer,
        &["acquired", "paired", "written", "fsynced", "processed"],
        "Number of shots that have reached each level."
    )
    .into()
);

schema!(
    Mode,
    "Mode",
    words(&["disarmed", "armed", "firing", "lost", "stopping"], "Whether the laser can fire.")
);

impl PartialSchema for ControlState {
    fn schema() -> RefOr<Schema> {
        let text = ObjectBuilder::new().schema_type(SchemaType::Type(Type::String));
        numbers(Type::Number, &["dt_us"], "Mode of the run, and what keeps it from firing.")
            .property("mode", Ref::from_schema_name("Mode"))
            .required("mode")
            .property("held", utoipa::openapi::ArrayBuilder::new().items(text))
            .required("held")
            .into()
    }
}

impl ToSchema for ControlState {
    fn schemas(schemas: &mut Vec<(String, RefOr<Schema>)>) {
        schemas.push(("Mode".to_owned(), Mode::schema()));
    }
}

schema!(
    RawLevelSchema,
    "RawLevel",
    words(
        &["not_kept", "lost", "acquired", "written", "synced"],
        "Durability of the raw images: not recorded, lost, in memory, handed to the system, on the \
         disk."
    )
);

impl PartialSchema for ShotTimeSchema {
    fn schema() -> RefOr<Schema> {
        let kind = |of: Type| ObjectBuilder::new().schema_type(SchemaType::Type(of));
        let about = "Time of the trigger: UTC (RFC 3339) by the host's clock, its standard \
                     uncertainty, and whether that clock was known to be synchronised.";
        numbers(Type::Number, &["uncertainty_s"], about)
            .property("utc", kind(Type::String))
            .required("utc")
            .property("clock_synchronised", kind(Type::Boolean))
            .required("clock_synchronised")
            .into()
    }
}

impl ToSchema for ShotTimeSchema {
    fn name() -> Cow<'static, str> {
        Cow::Borrowed("ShotTime")
    }
}

schema!(
    LatencyQuantiles,
    "LatencyQuantiles",
    numbers(
        Type::Number,
        &["shots", "p50_s", "p95_s", "p99_s"],
        "Latency from trigger to stored velocity, over the last shots."
    )
    .into()
);

schema!(
    VectorStatusSchema,
    "VectorStatus",
    words(
        &["valid", "replaced", "invalid", "masked"],
        "Whether a vector is measured, interpolated from its neighbours, missing, or not in the flow."
    )
);

schema!(
    FitVerdictSchema,
    "FitVerdict",
    words(
        &["good", "doubtful", "poor"],
        "How well the configured bench explains the images; with a poor fit no vector is valid."
    )
);

impl PartialSchema for ModelFitSchema {
    fn schema() -> RefOr<Schema> {
        let number = || ObjectBuilder::new().schema_type(SchemaType::Type(Type::Number));
        let or_null = || {
            let types = SchemaType::Array(vec![Type::Number, Type::Null]);
            ObjectBuilder::new().schema_type(types)
        };
        let camera = ObjectBuilder::new()
            .property("unexplained", number())
            .required("unexplained")
            .property("micro_image_offset_px", or_null())
            .required("micro_image_offset_px");
        let text = ObjectBuilder::new().schema_type(SchemaType::Type(Type::String));
        numbers(
            Type::Number,
            &["valid_share"],
            "Agreement of the images with the configured bench.",
        )
        .property("verdict", Ref::from_schema_name("FitVerdict"))
        .required("verdict")
        .property("cameras", utoipa::openapi::ArrayBuilder::new().items(camera))
        .required("cameras")
        .property("camera_agreement", or_null())
        .required("camera_agreement")
        .property("camera_disparity_mm", or_null())
        .required("camera_disparity_mm")
        .property("causes", utoipa::openapi::ArrayBuilder::new().items(text))
        .required("causes")
        .into()
    }
}

impl ToSchema for ModelFitSchema {
    fn name() -> Cow<'static, str> {
        Cow::Borrowed("ModelFit")
    }

    fn schemas(schemas: &mut Vec<(String, RefOr<Schema>)>) {
        schemas.push(("FitVerdict".to_owned(), FitVerdictSchema::schema()));
    }
}
