//! Names of cameras for users.

use std::{fmt, str::FromStr};

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

/// The name of a camera, as on its cable and in the file names of its images: `cam1` is the first
/// `[[camera]]` table. Code counts cameras from 0, users from 1; this type converts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct CameraName(
    /// The camera's index, from 0.
    pub usize,
);

impl fmt::Display for CameraName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&format!("cam{}", self.0 + 1))
    }
}

impl FromStr for CameraName {
    type Err = String;

    /// Reads `cam1`, or the number alone.
    fn from_str(text: &str) -> Result<Self, String> {
        let number = text.strip_prefix("cam").unwrap_or(text).parse().ok();
        let index = number.and_then(|number: usize| number.checked_sub(1));
        index.map(Self).ok_or_else(|| format!("'{text}' is not a camera: allowed: cam1, cam2"))
    }
}

impl Serialize for CameraName {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

impl<'de> Deserialize<'de> for CameraName {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        String::deserialize(deserializer)?.parse().map_err(de::Error::custom)
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;

    #[test]
    fn people_count_from_one() {
        assert_eq!(CameraName(0).to_string(), "cam1");
        assert_eq!(format!("{:<6}|", CameraName(1)), "cam2  |");
        for text in ["cam2", "2"] {
            assert_eq!(text.parse(), Ok(CameraName(1)));
        }
        for wrong in ["cam0", "0", "cam", "camera 1", "-1", ""] {
            assert!(wrong.parse::<CameraName>().is_err(), "{wrong}");
        }
        let table: BTreeMap<String, Vec<CameraName>> =
            toml::from_str("only = [\"cam1\", \"cam2\"]").unwrap();
        assert_eq!(table["only"], [CameraName(0), CameraName(1)]);
        assert_eq!(toml::to_string(&table).unwrap(), "only = [\"cam1\", \"cam2\"]\n");
    }
}
