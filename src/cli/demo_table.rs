//! The table at the end of a bounded run: results, errors, and processing times.

use std::{collections::VecDeque, fmt::Write};

use lfpiv_core::velocimetry::{StageSeconds, VectorStatus, VelocityField};
use lfpiv_hw::{CameraName, device::StreamStatistics};
use lfpiv_sim::Flow;

use crate::{
    archive::ShotResult,
    pipeline::{ShotRecord, Stage},
};

/// One row of the table.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// State in which the shot ended.
    stage: Stage,
    shot: u64,
    message: Option<String>,
    vectors: usize,
    valid_share: f64,
    /// Mean |error| of the valid vectors along x, y, z; `None` if none is valid.
    error_vox: Option<[f64; 3]>,
    seconds: StageSeconds,
}

impl Row {
    /// A row for a shot, with errors against the true flow, if known.
    pub fn new(record: &ShotRecord, result: Option<&ShotResult>, truth: Option<&Flow>) -> Self {
        Self {
            stage: record.stage,
            shot: record.shot,
            message: record.message.clone(),
            vectors: record.vectors.unwrap_or(0),
            valid_share: record.valid_share.unwrap_or(0.0),
            error_vox: result
                .zip(truth)
                .and_then(|(result, flow)| mean_error_vox(&result.measured.field, flow)),
            seconds: record.seconds.unwrap_or_default(),
        }
    }

    fn line(&self) -> String {
        if let (Stage::Failed, Some(message)) = (self.stage, &self.message) {
            return format!("{:>4}  no result: {message}", self.shot);
        }
        let [x, y, z] = self.error_vox.map_or(["-"; 3].map(String::from), |error| {
            error.map(|component| format!("{component:.3}"))
        });
        format!(
            "{:>4}  {:>7}  {:>6.1} %  {x:>6} {y:>6} {z:>6}  {:>7.2} {:>12.2} {:>10.2} {:>6.2}",
            self.shot,
            self.vectors,
            100.0 * self.valid_share,
            self.seconds.decode_s,
            self.seconds.reconstruct_s,
            self.seconds.correlate_s,
            self.seconds.judge_s
        )
    }
}

/// Mean |measured − true| per component over the valid vectors, in voxels. The true value is the
/// displacement of the particle that is at the vector's position half-way between the frames.
fn mean_error_vox(field: &VelocityField, flow: &Flow) -> Option<[f64; 3]> {
    let valid = |index: &usize| field.status[*index] == VectorStatus::Valid;
    let (mut sum, mut count) = ([0.0; 3], 0_usize);
    for index in (0..field.grid.len()).filter(valid) {
        let truth_mm = flow.displacement_mm(field.grid.position_mm(index), field.dt_s);
        for axis in 0..3 {
            let measured_vox = f64::from(field.displacement_vox[index][axis]);
            sum[axis] += (measured_vox - truth_mm[axis] / field.voxel_mm).abs();
        }
        count += 1;
    }
    (count > 0).then(|| sum.map(|total| total / count as f64))
}

/// Explanation of the numbers.
const NOTE: &str = "Errors are those of valid vectors against the simulated flow. Seconds are \
wall-clock, while\nthe same cores render the next shots: `lfpiv process` times processing alone. fit: the check of\nthe images against the model.";

/// Largest number of rows: a run may have a million shots.
const ROWS: usize = 100;

/// The last shots of a run, and the number of all shots.
#[derive(Debug, Default)]
pub struct Table {
    rows: VecDeque<Row>,
    ended: u64,
    measured: u64,
}

impl Table {
    /// Adds a shot that has left the pool.
    pub fn push(&mut self, row: Row) {
        self.ended += 1;
        self.measured += u64::from(row.stage == Stage::Done);
        self.rows.push_back(row);
        if self.rows.len() > ROWS {
            self.rows.pop_front();
        }
    }

    /// Number of shots added.
    pub fn ended(&self) -> u64 {
        self.ended
    }

    /// Number of shots that were measured and stored.
    pub fn measured(&self) -> u64 {
        self.measured
    }

    /// The table, ordered by shot.
    pub fn text(&self) -> String {
        let text = table(&self.rows);
        match self.ended > self.rows.len() as u64 {
            true => format!("The last {} of {} shots:\n{text}", self.rows.len(), self.ended),
            false => text,
        }
    }
}

fn table(rows: &VecDeque<Row>) -> String {
    let mut sorted: Vec<&Row> = rows.iter().collect();
    sorted.sort_by_key(|row| row.shot);
    let mut text = String::new();
    // Writing to a String does not fail.
    let _ = writeln!(text, "{:>24}  {:^20}  {:^38}", "", "mean |error|, voxel", "seconds");
    let _ = write!(
        text,
        "{:>4}  {:>7}  {:>8}  {:>6} {:>6} {:>6}  {:>7} {:>12} {:>10} {:>6}",
        "shot", "vectors", "valid", "x", "y", "z", "decode", "reconstruct", "correlate", "fit"
    );
    for row in sorted {
        let _ = write!(text, "\n{}", row.line());
    }
    let _ = write!(text, "\n{NOTE}");
    text
}

/// Counters of the cameras' drivers, one line per camera.
pub fn stream_table(streams: &[StreamStatistics]) -> String {
    let mut text = format!(
        "{:<7}  {:>9} {:>7} {:>9}  {:>8} {:>8}  {:>10}",
        "stream", "completed", "failed", "underruns", "resent", "missing", "reconnects"
    );
    for (index, counted) in streams.iter().enumerate() {
        let StreamStatistics { completed, failed, underruns, resent, missing, reconnects } =
            counted;
        // Writing to a String does not fail.
        let _ = write!(
            text,
            "\n{:<7}  {completed:>9} {failed:>7} {underruns:>9}  {resent:>8} {missing:>8}  \
             {reconnects:>10}",
            CameraName(index)
        );
    }
    text
}

#[cfg(test)]
mod tests {
    use lfpiv_sim::flow::Uniform;

    use super::*;
    use crate::pipeline::Board;
    use lfpiv_core::velocimetry::{PairResult, VectorGrid};

    /// Two vectors, the second invalid and far off.
    fn result() -> PairResult {
        PairResult {
            field: VelocityField {
                grid: VectorGrid { vectors: [2, 1, 1], first_mm: [0.0; 3], spacing_mm: 0.8 },
                displacement_vox: vec![[1.5, 0.0, -0.25], [99.0; 3]],
                uncertainty_vox: vec![[0.1; 3]; 2],
                status: vec![VectorStatus::Valid, VectorStatus::Invalid],
                peak_ratio: vec![2.0; 2],
                vorticity: vec![[0.0; 3]; 2],
                divergence: vec![0.0; 2],
                has_gradient: vec![true, false],
                voxel_mm: 0.1,
                dt_s: 1e-4,
            },
            seconds: StageSeconds {
                decode_s: 0.25,
                reconstruct_s: 1.5,
                correlate_s: 0.75,
                judge_s: 0.25,
            },
            warnings: Vec::new(),
            model: Default::default(),
            fit: None,
            light: None,
            particles: None,
        }
    }

    #[test]
    fn errors_are_taken_against_the_flow_over_valid_vectors() {
        // 1 m/s during 100 us is 0.1 mm, one voxel.
        let flow = Flow::Uniform(Uniform { velocity_m_s: [1.0, 0.0, 0.0] });
        let error = mean_error_vox(&result().field, &flow).unwrap();
        for (found, expected) in error.into_iter().zip([0.5, 0.0, 0.25]) {
            assert!((found - expected).abs() < 1e-9, "{error:?}");
        }
    }

    #[test]
    fn the_table_lists_results_and_failures_in_order() {
        let board = Board::new();
        let flow = Flow::default();
        let failed = Row::new(&board.failed(1, "camera 2 is dark".to_owned()), None, Some(&flow));
        let good = ShotResult::from(result());
        let done =
            Row::new(&board.done(0, ShotResult::from(result()).into()), Some(&good), Some(&flow));
        let mut shots = Table::default();
        for row in [failed, done] {
            shots.push(row);
        }
        assert_eq!((shots.ended(), shots.measured()), (2, 1));
        let text = shots.text();
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines.len(), 7);
        assert!(lines[2].contains("50.0 %") && lines[2].contains("1.500  0.000  0.250"), "{text}");
        assert!(lines[3].ends_with("1  no result: camera 2 is dark"), "{text}");
        let columns = lines[1].find("fit").map(|at| at + "fit".len());
        assert_eq!(Some(lines[2].len()), columns, "{text}");
    }
    #[test]
    fn a_long_run_has_a_table_of_its_last_shots() {
        let board = Board::new();
        let mut shots = Table::default();
        for shot in 0..3 * ROWS as u64 {
            shots.push(Row::new(&board.done(shot, ShotResult::from(result()).into()), None, None));
        }
        let text = shots.text();
        assert!(text.starts_with("The last 100 of 300 shots:\n"), "{text}");
        assert_eq!((shots.rows.len(), shots.measured()), (ROWS, 300));
        assert!(text.contains("\n 200 ") && text.contains("\n 299 ") && !text.contains("\n 199 "));
    }
}
