//! When particles are placed in the images.

use std::fmt;

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

/// When particles are placed in the images: in a configuration `false`, `"auto"` or `true`.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Placing {
    /// Never.
    Never,
    /// Of pairs whose flow correlation does not resolve, see [`super::Unresolved`].
    #[default]
    Auto,
    /// Of all pairs.
    Always,
}

/// The word for [`Placing::Auto`].
const AUTO: &str = "auto";

impl Serialize for Placing {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match self {
            Self::Never => to.serialize_bool(false),
            Self::Auto => to.serialize_str(AUTO),
            Self::Always => to.serialize_bool(true),
        }
    }
}

impl<'de> Deserialize<'de> for Placing {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        struct BoolOrAuto;

        impl de::Visitor<'_> for BoolOrAuto {
            type Value = Placing;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("true, false or \"auto\"")
            }

            fn visit_bool<E: de::Error>(self, always: bool) -> Result<Placing, E> {
                Ok(if always { Placing::Always } else { Placing::Never })
            }

            fn visit_str<E: de::Error>(self, word: &str) -> Result<Placing, E> {
                match word {
                    AUTO => Ok(Placing::Auto),
                    _ => Err(E::invalid_value(de::Unexpected::Str(word), &self)),
                }
            }
        }

        from.deserialize_any(BoolOrAuto)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_setting_is_read_as_it_is_written() {
        for (placing, text) in
            [(Placing::Never, "false"), (Placing::Auto, "\"auto\""), (Placing::Always, "true")]
        {
            assert_eq!(serde_json::to_string(&placing).unwrap(), text);
            assert_eq!(serde_json::from_str::<Placing>(text).unwrap(), placing);
        }
    }

    #[test]
    fn another_word_is_refused_with_those_that_are_known() {
        let error = serde_json::from_str::<Placing>("\"sometimes\"").unwrap_err().to_string();
        assert!(
            error.contains("\"sometimes\"") && error.contains("true, false or \"auto\""),
            "{error}"
        );
    }
}
