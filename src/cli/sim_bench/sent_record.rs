//! The list of sent frames, as comma-separated values.

use std::{
    fs::File,
    io::{self, LineWriter, Write},
    path::Path,
};

use anyhow::Context;
use lfpiv_hw::CameraName;
use lfpiv_sim::wire::bench::SentFrame;

/// A list that grows as frames are sent.
pub(super) struct SentRecord(LineWriter<File>);

impl SentRecord {
    pub fn create(path: &Path) -> anyhow::Result<Self> {
        let create = || {
            if let Some(folder) = path.parent() {
                std::fs::create_dir_all(folder)?;
            }
            let mut file = LineWriter::new(File::create(path)?);
            writeln!(file, "camera,shot,exposure,device_timestamp_ns,crc32")?;
            Ok::<_, io::Error>(file)
        };
        let file = create().with_context(|| format!("cannot write {}", path.display()))?;
        Ok(Self(file))
    }

    pub fn list(&mut self, frame: &SentFrame) -> io::Result<()> {
        let camera = CameraName(frame.camera);
        let (shot, exposure) = (frame.shot, frame.exposure);
        let (timestamp_ns, crc32) = (frame.device_timestamp_ns, frame.crc32);
        writeln!(self.0, "{camera},{shot},{exposure},{timestamp_ns},{crc32:08x}")
    }
}
