//! Identification of the unit, by identity string and channel catalogue.

use crate::timing::UnitLimits;

/// An identified unit.
#[derive(Debug, Clone, PartialEq)]
pub struct UnitDescription {
    /// Reply to `*IDN?`: vendor, model, serial number, firmware.
    pub identity: String,
    /// Number of channels.
    pub channels: u8,
    /// Limits of its settings.
    pub limits: UnitLimits,
}

impl UnitDescription {
    /// Parses `BNC,575-4,31707,2.4.2-2.0.11` and `T0, CHA, CHB, CHC, CHD`; `None` for another family.
    pub fn recognise(identity: &str, catalogue: &str) -> Option<Self> {
        let mut fields = identity.split(',').map(str::trim);
        let (vendor, model) = (fields.next()?.to_ascii_uppercase(), fields.next()?);
        let known = match vendor.as_str() {
            "BNC" => model.starts_with("575") || model.starts_with("577"),
            "QC" => model.starts_with("95"),
            _ => false,
        };
        let names = catalogue.split(',').map(|name| name.trim().to_ascii_uppercase());
        let channels = names.filter(|name| name.starts_with("CH")).count();
        let limits = match model.starts_with("953") {
            true => UnitLimits::QUANTUM_COMPOSERS_9530,
            false => UnitLimits::BNC_575,
        };
        (known && (1..=8).contains(&channels)).then(|| Self {
            identity: identity.to_owned(),
            channels: channels as u8,
            limits,
        })
    }
}

/// Whether a line can be the reply to `*IDN?`: no other reply has three commas.
pub fn is_identity(line: &str) -> bool {
    line.matches(',').count() >= 3 && !is_catalogue(line)
}

/// Whether a line can be the reply to `:INST:CAT?`.
pub fn is_catalogue(line: &str) -> bool {
    line.to_ascii_uppercase().starts_with("T0,")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn families_are_distinguished() {
        let catalogue = "T0, CHA, CHB, CHC, CHD, CHE, CHF, CHG, CHH";
        let unit = UnitDescription::recognise("BNC,575-8,31707,2.4.2-2.0.11", catalogue).unwrap();
        assert_eq!((unit.channels, unit.limits.longest_burst), (8, 9_999_999));
        let unit = UnitDescription::recognise("QC,9534,00123,2.1.0", "T0,CHA,CHB,CHC,CHD").unwrap();
        assert_eq!((unit.channels, unit.limits.longest_burst), (4, 1_000_000));
        assert_eq!(UnitDescription::recognise("KEYSIGHT,33500B,1,2", catalogue), None);
        assert_eq!(UnitDescription::recognise("BNC,575-4,31707,2.4.2", "T0"), None);
        assert!(is_identity("BNC,575-4,31707,2.4.2-2.0.11"));
        assert!(!is_identity("T0, CHA, CHB, CHC") && is_catalogue("T0, CHA, CHB, CHC"));
        assert!(!is_identity("0.1"));
    }
}
