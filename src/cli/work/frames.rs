//! Where a worker's frames come from.

use std::path::{Component, Path, PathBuf};

use lfpiv_core::lightfield::ImagePair;
use lfpiv_hw::RawImage;

use crate::{
    acquisition::journal::RecordedRun,
    cli::process_run::is_run,
    cluster::{ClientError, CoordinatorClient, Frame, Shot},
};

/// See the module.
pub(super) enum Frames {
    /// A folder that this machine shares with the coordinator.
    Shared(Box<RecordedRun>),
    /// The coordinator.
    Coordinator,
}

impl Frames {
    /// The images of a shot, each checked against the job.
    ///
    /// # Errors
    /// A frame cannot be read.
    pub fn pair(&self, client: &CoordinatorClient, shot: &Shot) -> Result<ImagePair, ClientError> {
        let image = |frame: &Frame| match self.shared_image(frame) {
            Some(image) => Ok(image),
            None => client.frame(frame),
        };
        let cameras = shot.frames.iter().map(|[a, b]| Ok([image(a)?, image(b)?]));
        Ok(ImagePair { cameras: cameras.collect::<Result<_, ClientError>>()? })
    }

    /// The image in the shared folder, if it is the right one: a copy may be damaged, or late.
    fn shared_image(&self, frame: &Frame) -> Option<RawImage> {
        let Self::Shared(run) = self else { return None };
        match run.image(frame.position()) {
            Ok(image) if image.crc32() == frame.crc32 => return Some(image),
            Ok(_) => tracing::warn!("the shared folder has another image than the coordinator"),
            Err(error) => tracing::debug!("{error}: the frame is read from the coordinator"),
        }
        None
    }
}

/// The folder of a run in a shared one; `None` if it is not there.
pub(super) fn shared_run(shared: &Path, run_name: &str) -> Option<PathBuf> {
    if is_run(shared) {
        return Some(shared.to_owned());
    }
    // The name comes over the network: it must be that of a folder right here.
    let mut parts = Path::new(run_name).components();
    let (Some(Component::Normal(name)), None) = (parts.next(), parts.next()) else { return None };
    Some(shared.join(name)).filter(|folder| is_run(folder))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_is_found_in_the_shared_folder_and_nowhere_else() {
        let root = tempfile::tempdir().unwrap();
        let shared = root.path().join("shared");
        for run in ["outside", "shared/run"] {
            std::fs::create_dir_all(root.path().join(run).join("raw")).unwrap();
        }
        assert_eq!(shared_run(&shared, "run"), Some(shared.join("run")));
        assert_eq!(shared_run(&shared.join("run"), "any"), Some(shared.join("run")));
        let outside = root.path().join("outside");
        for name in ["other", "", "..", "../outside", outside.to_str().unwrap()] {
            assert_eq!(shared_run(&shared, name), None, "{name}");
        }
    }
}
