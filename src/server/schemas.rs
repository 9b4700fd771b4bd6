//! How types of other rooms look in JSON, for the OpenAPI document. `tests/daemon` holds real
//! answers against it.

use std::borrow::Cow;

use utoipa::{
    PartialSchema, ToSchema,
    openapi::{
        ObjectBuilder, Ref, RefOr, Schema,
        schema::{SchemaType, Type},
    },
};

use crate::{
    acquisition::{Account, Outcome, OutcomeCounts},
    pipeline::{StageSeconds, Watermarks},
    velocimetry::VectorStatus,
};

/// An object of required members of one type.
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

schema!(
    Outcome,
    "Outcome",
    words(&Outcome::ALL.map(Outcome::name), "How a trigger ended for one camera.")
);

schema!(
    OutcomeCounts,
    "OutcomeCounts",
    numbers(Type::Integer, &Outcome::ALL.map(Outcome::name), "Triggers by how they ended.").into()
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
    StageSeconds,
    "StageSeconds",
    numbers(Type::Number, &["decode_s", "reconstruct_s", "correlate_s"], "Time per stage, in s.")
        .into()
);

schema!(
    Watermarks,
    "Watermarks",
    numbers(
        Type::Integer,
        &["acquired", "paired", "written", "fsynced", "processed"],
        "Numbers of shots: all before that number have got that far, or are lost and accounted for."
    )
    .into()
);

schema!(
    VectorStatus,
    "VectorStatus",
    words(
        &["valid", "replaced", "invalid"],
        "Whether a vector is measured, stood in for, or none."
    )
);
