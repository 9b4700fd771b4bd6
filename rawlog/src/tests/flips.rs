//! A flipped bit anywhere costs at most the record that it hits, and is always reported.

use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg64Mcg;

use super::{
    super::{
        recovery::recover_on,
        storage::model::{Content, ModelDisk},
    },
    limits, reader,
    reading::read_all,
    recovering::unsealed,
    sealed_log,
};

const RECORDS: u64 = 30;
const FLIPS: usize = 500;

/// Flips one bit of one of the log's files; returns a description.
fn flip(content: &mut Content, random: &mut Pcg64Mcg) -> String {
    let paths: Vec<_> = content.named().keys().map(|path| path.to_path_buf()).collect();
    let all: usize = content.named().values().map(|bytes| bytes.len()).sum();
    let mut bit = random.random_range(0..8 * all);
    for path in paths {
        let file = content.file_mut(&path).unwrap();
        if bit < 8 * file.len() {
            file[bit / 8] ^= 1 << (bit % 8);
            return format!("{}, byte {}, bit {}", path.display(), bit / 8, bit % 8);
        }
        bit -= 8 * file.len();
    }
    unreachable!("the bit lies in one of the files")
}

/// At most one record is lost, and an error was reported.
fn assert_one_at_most(right: &[u64], said: usize, place: &str) {
    assert!(right.len() as u64 + 1 >= RECORDS, "{place}: only {right:?} are left");
    assert!(said > 0, "{place}: nothing was reported");
}

#[test]
fn a_flipped_bit_of_a_closed_log_costs_one_record_at_most() {
    let whole = sealed_log(RECORDS, &limits()).content();
    let mut random = Pcg64Mcg::seed_from_u64(1);
    for _ in 0..FLIPS {
        let mut content = whole.clone();
        let place = flip(&mut content, &mut random);
        let (right, errors) = read_all(&reader(&content).expect(&place));
        assert_one_at_most(&right, errors.len(), &place);
        // Nothing needs recovery, so nothing is changed.
        let disk = ModelDisk::holding(content.clone());
        assert!(recover_on(&disk, super::folder()).unwrap().segments.is_empty());
        assert!(disk.content() == content);
    }
}

#[test]
fn a_flipped_bit_of_a_log_that_was_cut_off_costs_one_record_at_most() {
    let (whole, _) = unsealed(&sealed_log(RECORDS, &limits()));
    let mut random = Pcg64Mcg::seed_from_u64(2);
    for _ in 0..FLIPS {
        let mut content = whole.clone();
        let place = flip(&mut content, &mut random);
        let (right, errors) = read_all(&reader(&content).expect(&place));
        assert_one_at_most(&right, errors.len(), &place);
        let disk = ModelDisk::holding(content);
        recover_on(&disk, super::folder()).expect(&place);
        let (again, errors) = read_all(&reader(&disk.content()).expect(&place));
        assert_eq!(again, right, "{place}: after recovery");
        assert_one_at_most(&again, errors.len(), &place);
    }
}
