//! Reads volumes of other programs in a child process, because the HDF5 library may crash on a
//! damaged file or request too much memory.
//!
//! The child writes [`VOLUMES`] and the light of frames a and b (f32, little-endian) to its
//! standard output, or [`REASON`] and an error message.

use std::{
    io::{self, Read, Write},
    os::unix::process::ExitStatusExt,
    path::{Path, PathBuf},
    process::{Child, Command, Stdio},
};

use anyhow::{Context, bail};
use lfpiv_core::{model::VolumeGrid, reconstruction::DenseVolume};
use lfpiv_rawlog::regular_file::open_regular;
use rustix::process::{Resource, Rlimit, setrlimit};

use crate::archive::read_volumes;

const VOLUMES: u8 = 1;
const REASON: u8 = 0;

/// Largest length of the error message, in bytes.
const LONGEST_REASON: u64 = 4096;

/// Limits of the child: processor seconds, and memory for this many copies of both volumes in
/// addition to the program.
const CPU_SECONDS: u64 = 600;
const COPIES: u64 = 4;
const PROGRAM_BYTES: u64 = 1 << 30;

/// Arguments of the command that the child runs.
#[derive(Debug, clap::Args)]
pub struct ReadVolumesArgs {
    /// The voxel grid as JSON.
    pub grid: String,
    /// The file.
    pub volumes: PathBuf,
}

/// Reads frames a and b of the file at `path` in a child process.
///
/// # Errors
/// An error of [`read_volumes`], or the child's death.
pub(super) fn read_safely(path: &Path, grid: &VolumeGrid) -> anyhow::Result<[DenseVolume; 2]> {
    let cannot = || format!("cannot read volumes from {}", path.display());
    open_regular(path).with_context(cannot)?;
    let program = std::env::current_exe().context("cannot find this program's own file")?;
    let mut child = Command::new(program)
        .arg("read-volumes")
        .arg(serde_json::to_string(grid).context("cannot serialize the voxel grid")?)
        .arg(path)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .context("cannot start a process that reads volumes")?;
    let answer = answer_of(&mut child, grid);
    let status = child.wait().context("cannot wait for the process that reads volumes")?;
    match answer {
        Ok(Answer::Volumes(volumes)) => Ok(volumes),
        Ok(Answer::Reason(reason)) => bail!(reason),
        Err(_) => {
            let how = status.signal().map_or(format!("it ended with {status}"), |signal| {
                format!("it ended with signal {signal}")
            });
            bail!(
                "{}: the reading process died ({how}): the file is damaged, or needs more \
                 memory or time than its voxels justify",
                cannot()
            )
        }
    }
}

enum Answer {
    Volumes([DenseVolume; 2]),
    Reason(String),
}

fn answer_of(child: &mut Child, grid: &VolumeGrid) -> io::Result<Answer> {
    let Some(mut answer) = child.stdout.take() else { return Err(io::ErrorKind::NotFound.into()) };
    let mut kind = [0];
    answer.read_exact(&mut kind)?;
    if kind == [REASON] {
        let mut reason = String::new();
        answer.take(LONGEST_REASON).read_to_string(&mut reason)?;
        return Ok(Answer::Reason(reason));
    }
    let mut frame = || -> io::Result<DenseVolume> {
        let mut bytes = vec![0; size_of::<f32>() * grid.len()];
        answer.read_exact(&mut bytes)?;
        let (numbers, _) = bytes.as_chunks::<4>();
        let intensity = numbers.iter().map(|&number| f32::from_le_bytes(number)).collect();
        Ok(DenseVolume { grid: grid.clone(), intensity })
    };
    Ok(Answer::Volumes([frame()?, frame()?]))
}

/// Runs in the child.
pub(super) fn read_for_parent(args: &ReadVolumesArgs) -> anyhow::Result<()> {
    let grid: VolumeGrid =
        serde_json::from_str(&args.grid).context("cannot parse the voxel grid")?;
    let bytes = 2 * (size_of::<f32>() * grid.len()) as u64;
    limit(Resource::As, COPIES * bytes + PROGRAM_BYTES)?;
    limit(Resource::Cpu, CPU_SECONDS)?;
    limit(Resource::Core, 0)?;
    let mut out = io::stdout().lock();
    match read_volumes(&args.volumes, &grid) {
        Ok(volumes) => {
            out.write_all(&[VOLUMES])?;
            for light in volumes.iter().flat_map(|volume| &volume.intensity) {
                out.write_all(&light.to_le_bytes())?;
            }
        }
        Err(error) => {
            out.write_all(&[REASON])?;
            out.write_all(error.to_string().as_bytes())?;
        }
    }
    Ok(out.flush()?)
}

fn limit(resource: Resource, most: u64) -> anyhow::Result<()> {
    let limits = Rlimit { current: Some(most), maximum: Some(most) };
    setrlimit(resource, limits).context("cannot set the limits of the process")
}
