//! The time of a shot.

use std::fmt::{self, Display};

use serde::{Serialize, Serializer, ser::SerializeStruct};
use time::{OffsetDateTime, format_description::well_known::Rfc3339};

/// Time of a shot's trigger (T0 of its pulse schedule).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ShotTime {
    /// UTC in ns since 1970-01-01T00:00:00Z, without leap seconds, as computers count it.
    pub utc_ns: i64,
    /// Standard uncertainty, in ns. It includes the error of the host's clock, if that is known.
    pub uncertainty_ns: u64,
    /// Whether the host's clock was known to be synchronised with UTC. If not, the error of that
    /// clock is not in the uncertainty.
    pub clock_synchronised: bool,
}

impl ShotTime {
    /// UTC in seconds since 1970-01-01T00:00:00Z, rounded to 0.3 µs.
    pub fn utc_s(&self) -> f64 {
        let (seconds, rest_ns) =
            (self.utc_ns.div_euclid(1_000_000_000), self.utc_ns.rem_euclid(1_000_000_000));
        seconds as f64 + rest_ns as f64 / 1e9
    }

    /// Standard uncertainty in s.
    pub fn uncertainty_s(&self) -> f64 {
        self.uncertainty_ns as f64 / 1e9
    }
}

/// Formats as RFC 3339 with microseconds.
impl Display for ShotTime {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let whole_us = i128::from(self.utc_ns).div_euclid(1000) * 1000;
        // Every `i64` of nanoseconds is a date between 1677 and 2262.
        let date = OffsetDateTime::from_unix_timestamp_nanos(whole_us).map_err(|_| fmt::Error)?;
        f.write_str(&date.format(&Rfc3339).map_err(|_| fmt::Error)?)
    }
}

impl Serialize for ShotTime {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut time = serializer.serialize_struct("ShotTime", 3)?;
        time.serialize_field("utc", &self.to_string())?;
        time.serialize_field("uncertainty_s", &self.uncertainty_s())?;
        time.serialize_field("clock_synchronised", &self.clock_synchronised)?;
        time.end()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_is_serialized_as_a_date_with_its_uncertainty() {
        let time = ShotTime {
            utc_ns: 1_700_000_000_123_456_789,
            uncertainty_ns: 2_500_000,
            clock_synchronised: true,
        };
        assert_eq!(time.to_string(), "2023-11-14T22:13:20.123456Z");
        let json = serde_json::to_value(time).unwrap();
        let expected = serde_json::json!({
            "utc": "2023-11-14T22:13:20.123456Z", "uncertainty_s": 0.0025, "clock_synchronised": true
        });
        assert_eq!(json, expected);
        assert!((time.utc_s() - 1_700_000_000.123_456_8).abs() < 3e-7);
    }
}
