//! Rows of other programs, measured on the same images by their own script.

use std::path::Path;

use lfpiv_rawlog::regular_file::read_text;
use serde::Deserialize;

use crate::{BenchmarkError, Row};

/// A row as the peers' script writes it; keys may be absent.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct PeerRow {
    case: String,
    method: String,
    peer: String,
    threads: usize,
    seconds: Option<f64>,
    cpu_seconds: Option<f64>,
    seconds_of: String,
    assembly_seconds: Option<f64>,
    q: Option<f64>,
    iterations: Option<usize>,
    vectors: Option<usize>,
    mean_abs_error_vox: Option<[f64; 3]>,
    peak_mb: Option<f64>,
    version: String,
    seed: u64,
}

/// Reads a JSON array of the peers' rows.
///
/// # Errors
/// The file cannot be read, or is no such array.
pub fn read_peers(path: &Path) -> Result<Vec<Row>, BenchmarkError> {
    let text = read_text(path)
        .map_err(|reason| BenchmarkError::Unreadable { path: path.into(), reason })?;
    let rows: Vec<PeerRow> = serde_json::from_str(&text).map_err(|error| {
        BenchmarkError::Malformed { path: path.into(), reason: error.to_string() }
    })?;
    Ok(rows.into_iter().map(Row::from).collect())
}

impl From<PeerRow> for Row {
    fn from(peer: PeerRow) -> Self {
        let mut row = Self {
            set: "peers".to_owned(),
            case: peer.case,
            measure: if peer.q.is_some() { "volume" } else { "velocity" }.to_owned(),
            method: peer.method,
            peer: Some(peer.peer),
            seconds: peer.seconds,
            cpu_s: peer.cpu_seconds,
            seconds_of: peer.seconds_of,
            assembly_s: peer.assembly_seconds,
            q: peer.q,
            iterations: peer.iterations,
            vectors: peer.vectors,
            peak_mb: peer.peak_mb,
            seed: peer.seed,
            threads: peer.threads,
            version: peer.version,
            ..Self::default()
        };
        if let Some(error) = peer.mean_abs_error_vox {
            row.set_error(error);
        }
        row
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn absent_keys_are_absent_figures() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("peers.json");
        let text = r#"[{"case": "a", "method": "sart-20", "peer": "astra", "threads": 2,
            "seconds": 1.5, "seconds_of": "solve", "q": 0.7},
            {"case": "b", "peer": "openpiv", "mean_abs_error_vox": [0.1, 0.2, 0.3]}]"#;
        fs::write(&path, text).unwrap();
        let rows = read_peers(&path).unwrap();
        assert_eq!((rows[0].q, rows[0].error_vox()), (Some(0.7), None));
        assert_eq!(rows[1].error_vox(), Some([0.1, 0.2, 0.3]));
        assert_eq!(rows[1].peer.as_deref(), Some("openpiv"));
    }
}
