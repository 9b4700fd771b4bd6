//! A real full disk: a small tmpfs in namespaces of its own.

use std::{
    path::Path,
    process::{Command, Output},
};

use super::{
    super::{Codec, RawLog, RawLogReader, RawLogSettings, recover},
    DESCRIPTION, Record,
};

/// Environment variable that tells the test, when run inside the namespaces, where the disk is.
const DISK: &str = "LFPIV_TEST_SMALL_DISK";
const NAME: &str = "tests::disk_full::on_a_small_disk";

/// Mounts 4 MiB over the folder, visible to this command only.
const MOUNT: &str = r#"mount -t tmpfs -o size=4m tmpfs "$0" && exec "$@""#;

#[test]
fn a_real_disk_that_fills_up_keeps_what_was_written() {
    let folder = tempfile::tempdir().unwrap();
    let may_mount = |options: &&str| {
        let tried = in_namespaces(options, folder.path(), Path::new("true"));
        tried.is_ok_and(|output| output.status.success())
    };
    let Some(options) = ["-Urm", "-m"].into_iter().find(may_mount) else {
        eprintln!("SKIPPED: cannot mount a private file system (unshare, mount)");
        return;
    };
    let test = std::env::current_exe().unwrap();
    let output = in_namespaces(options, folder.path(), &test).unwrap();
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{text}{}", String::from_utf8_lossy(&output.stderr));
    assert!(text.contains("1 passed"), "{text}");
}

fn in_namespaces(options: &str, folder: &Path, program: &Path) -> std::io::Result<Output> {
    Command::new("unshare")
        .args([options, "sh", "-c", MOUNT])
        .arg(folder)
        .arg(program)
        .args([NAME, "--exact", "--ignored", "--test-threads=1"])
        .env(DISK, folder)
        .output()
}

fn noise(number: u64) -> Record {
    let counts = (0..40_000_u64).map(|n| (n.wrapping_mul(n + number) >> 3) as u16 & 0xFFF);
    let image = lfpiv_hw::RawImage::new(200, 200, counts.collect()).unwrap();
    Record { head: number.to_string().into_bytes(), image: Some(image) }
}

#[test]
#[ignore = "started by a_real_disk_that_fills_up_keeps_what_was_written on its small disk"]
fn on_a_small_disk() {
    let Ok(disk) = std::env::var(DISK) else { return };
    let folder = Path::new(&disk).join("raw");
    let settings =
        RawLogSettings { codec: Codec::Raw, segment_mb: 1, reserve_mb: 0, ..Default::default() };
    let (log, writer) = RawLog::create(&folder, DESCRIPTION, &settings).unwrap();
    log.reserve(1_000_000).unwrap();
    let message = log.reserve(1_000_000_000).unwrap_err().to_string();
    assert!(message.contains("has 4 MB free"), "{message}");
    let taken = (0..).take_while(|number| log.append_blocking(noise(*number)).is_ok()).count();
    let message = writer.close().unwrap_err().to_string();
    assert!(message.contains("No space left on device"), "{message}");
    assert!(message.contains("free space on the disk of"), "{message}");
    let marks = log.watermarks();
    assert_eq!(marks.synced, marks.written);
    assert!(marks.written > 30 && marks.written < taken as u64, "{marks:?}");
    let count_right = || {
        let reader = RawLogReader::open(&folder).unwrap();
        let right = |(number, read)| read == noise(number);
        reader.records().map(Result::unwrap).map(right).filter(|is_right| *is_right).count() as u64
    };
    assert_eq!(count_right(), marks.written);
    // Space is freed.
    std::fs::remove_file(folder.join("segment_000000.raw")).unwrap();
    let recovery = recover(&folder).unwrap();
    assert_eq!(recovery.segments.len(), 1);
    assert_eq!(recovery.segments[0].torn, None, "the torn record was cut when the write failed");
}
