//! Floods of connections: acquisition is not affected, and the laser can still be made safe.

use std::process::Stdio;

use crate::{
    bench::{Running, configuration},
    connections::{
        EACH, Flood, OPEN_FILES, OPERATOR, OTHER, RAW_LOG, READ, UNFINISHED, assert_nothing_lost,
        disarm, stream, wait_for_segments, with_tokens,
    },
};

#[test]
fn a_flood_with_tokens_costs_no_shot_and_the_laser_can_be_made_safe() {
    let root = tempfile::tempdir().expect("a folder");
    let config = with_tokens(root.path());
    let mut running = Running::limited(&config, OPEN_FILES, Stdio::null()).with_token(READ);
    running.wait_until(|status| status["shots"]["done"].as_u64() > Some(2));
    let mut flood = Flood::of(&running);
    flood.pour(OPERATOR, EACH, &stream(READ));
    flood.pour(OTHER, EACH, &stream(READ));
    flood.pour(OPERATOR, EACH, &stream("not-a-token"));
    flood.pour(OTHER, EACH, UNFINISHED);
    wait_for_segments(&mut running);
    flood.pour(OPERATOR, EACH, UNFINISHED);
    println!("disarm was answered after {:.3} s", disarm(&running).as_secs_f64());
    drop(flood);
    running.wait_until(|status| status["shots"]["awaiting_frames"] == 0);
    let (triggers, kept) = assert_nothing_lost(&running.terminate());
    assert_eq!(triggers, kept);
}

#[test]
fn a_flood_without_tokens_costs_no_shot() {
    let root = tempfile::tempdir().expect("a folder");
    let config = configuration(root.path(), RAW_LOG);
    let mut running = Running::limited(&config, OPEN_FILES, Stdio::null());
    running.wait_until(|status| status["shots"]["done"].as_u64() > Some(2));
    let mut flood = Flood::of(&running);
    flood.pour(OPERATOR, EACH, &stream("none-is-needed"));
    flood.pour(OTHER, EACH, UNFINISHED);
    wait_for_segments(&mut running);
    drop(flood);
    assert_nothing_lost(&running.terminate());
}
