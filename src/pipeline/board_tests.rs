use super::*;
use crate::pipeline::Event;

fn told(board: &Board) -> Vec<(&'static str, serde_json::Value)> {
    let events = board.events().after(0, usize::MAX).events;
    let json = |event: &Event| serde_json::from_str(&event.data).unwrap();
    events.iter().map(|event| (event.kind.name(), json(event))).collect()
}

#[test]
fn a_finished_shot_is_published_before_its_result() {
    let board = Board::new();
    board.processing(3);
    let result = crate::pipeline::test_data::result();
    board.done(3, Arc::new(result.into()));
    board.failed(4, "dark".to_owned());
    let told = told(&board);
    let kinds: Vec<_> = told.iter().map(|(kind, data)| (*kind, data["shot"].clone())).collect();
    assert_eq!(kinds, [("shot", 3.into()), ("result", 3.into()), ("shot", 4.into())]);
    assert_eq!(told[0].1["stage"], "done");
    assert_eq!(told[2].1["message"], "dark");
}

#[test]
fn watermarks_are_published_when_they_rise() {
    let board = Board::new();
    assert_eq!(board.watermarks(), None);
    let marks = Watermarks { acquired: 3, paired: 3, written: 2, fsynced: 1, processed: 1 };
    board.set_watermarks(marks);
    board.set_watermarks(marks);
    assert_eq!(board.watermarks(), Some(marks));
    let told = told(&board);
    assert_eq!(told.len(), 1);
    assert_eq!((told[0].0, &told[0].1["fsynced"]), ("watermarks", &1.into()));
}
