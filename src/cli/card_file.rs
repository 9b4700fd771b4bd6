//! Reads the file of a calibration card.

use std::path::Path;

use anyhow::{Context, bail};
use garde::Validate;
use lfpiv_hw::card::CalibrationCard;

use crate::config::read_or_shipped;

/// Reads a card file and checks the described card.
///
/// # Errors
/// The file cannot be read or parsed, or describes an impossible card.
pub(super) fn read_card(path: &Path) -> anyhow::Result<CalibrationCard> {
    let text = read_or_shipped(path)
        .with_context(|| format!("cannot read the card file {}", path.display()))?;
    let card: CalibrationCard = toml::from_str(&text).with_context(|| {
        format!(
            "{} is not a card file (config/card.toml is an example with every key)",
            path.display()
        )
    })?;
    if let Err(problems) = card.validate() {
        bail!("{}: {}", path.display(), problems.to_string().trim_end());
    }
    match card.card.fault() {
        None => Ok(card),
        Some(fault) => bail!("{}: {fault}", path.display()),
    }
}
