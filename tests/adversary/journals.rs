//! Intact logs with impossible contents: the journal of a run with altered entries, next to a
//! damaged ledger.

use std::{fs, path::PathBuf};

use lfpiv_rawlog::{RawLog, RawLogReader, RawLogSettings, Record};
use rand::RngExt;
use tempfile::TempDir;

use crate::{
    bench::{configuration, finished_run},
    campaign::{Campaign, Case},
    exported::argument,
    mutation::spoiled,
};

/// See the module.
pub struct Journals {
    root: TempDir,
    run: PathBuf,
    description: Vec<u8>,
    records: Vec<Record>,
}

impl Journals {
    /// Records a run.
    pub fn prepare() -> Self {
        let root = tempfile::tempdir().expect("a folder");
        let run = finished_run(&configuration(root.path(), ""), "2");
        let reader = RawLogReader::open(&run.join("raw")).expect("a log");
        let records = reader.records().map(|record| record.expect("a record").1).collect();
        Self { root, run, description: reader.description().to_vec(), records }
    }
}

impl Campaign for Journals {
    fn run(&mut self, case: &mut Case<'_>) {
        let folder = self.root.path().join("case");
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).expect("a folder");
        let mut records = self.records.clone();
        let mut description = self.description.clone();
        let ledger = fs::read(self.run.join("ledger.json")).expect("a ledger");
        let mut ledger = String::from_utf8_lossy(&ledger).into_owned().into_bytes();
        let spoil = |bytes: &mut Vec<u8>, case: &mut Case<'_>| {
            *bytes = spoiled(&String::from_utf8_lossy(bytes), &mut case.random);
        };
        match case.random.random_range(0..10) {
            0 => spoil(&mut description, case),
            1 | 2 => spoil(&mut ledger, case),
            3 => drop(records.remove(case.random.random_range(0..records.len()))),
            4 => {
                let (from, to) = (any(&records, case), any(&records, case));
                records.swap(from, to);
            }
            _ => {
                for _ in 0..case.random.random_range(1..3) {
                    let at = any(&records, case);
                    spoil(&mut records[at].head, case);
                }
            }
        }
        case.tally.mutations += 1;
        let run = folder.join("run");
        fs::create_dir(&run).expect("a folder");
        let settings = RawLogSettings::default();
        let made = RawLog::create(&run.join("raw"), &description, &settings).expect("a log");
        let (log, writer) = made;
        for record in records {
            log.append_blocking(record).expect("room");
        }
        writer.close().expect("a closed log");
        if case.random.random_bool(0.7) {
            fs::write(run.join("ledger.json"), ledger).expect("a ledger");
        }
        let (run, out) = (argument(&run).to_owned(), argument(&folder).to_owned());
        case.lfpiv(&["export", "--out", &out, &run]);
        match case.random.random_range(0..3) {
            0 => drop(case.lfpiv(&["replay", "--out", &out, &run])),
            1 => drop(case.lfpiv(&["process", &run])),
            _ => {}
        }
    }
}

fn any(records: &[Record], case: &mut Case<'_>) -> usize {
    case.random.random_range(0..records.len())
}
