//! Volumes of other programs, read in a process of their own: the HDF5 library may crash on a damaged
//! file, or ask for more memory than there is.
//!
//! The child writes [`VOLUMES`] and the light of frames a and b (f32, little-endian) to its standard
//! output, or [`REASON`] and why it cannot.

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

/// Longest reason that is passed on, in bytes.
const LONGEST_REASON: u64 = 4096;

/// What the child may use: this many seconds of a processor, and memory for so many copies of both
/// volumes and the program itself.
const CPU_SECONDS: u64 = 600;
const COPIES: u64 = 4;
const PROGRAM_BYTES: u64 = 1 << 30;

/// Arguments of the command that the child runs.
#[derive(Debug, clap::Args)]
pub struct ReadVolumesArgs {
    /// The voxels, as JSON.
    pub grid: String,
    /// The file.
    pub volumes: PathBuf,
}

/// Reads frames a and b of the file at `path` in a child process.
///
/// # Errors
/// What is wrong with the file, as [`read_volumes`]; a child that died of it.
pub(super) fn read_safely(path: &Path, grid: &VolumeGrid) -> anyhow::Result<[DenseVolume; 2]> {
    let cannot = || format!("cannot take volumes from {}", path.display());
    open_regular(path).with_context(cannot)?;
    let program = std::env::current_exe().context("the program does not find itself")?;
    let mut child = Command::new(program)
        .arg("read-volumes")
        .arg(serde_json::to_string(grid).context("the voxels are not described")?)
        .arg(path)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .context("cannot start a process that reads volumes")?;
    let answer = answer_of(&mut child, grid);
    let status = child.wait().context("the process that reads volumes is lost")?;
    match answer {
        Ok(Answer::Volumes(volumes)) => Ok(volumes),
        Ok(Answer::Reason(reason)) => bail!(reason),
        Err(_) => {
            let how = status.signal().map_or(format!("it ended with {status}"), |signal| {
                format!("it ended with signal {signal}")
            });
            bail!(
                "{}: the process that read it died ({how}): the file is damaged, or takes more \
                 memory or time than its voxels need",
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

/// What the child does.
pub(super) fn read_for_parent(args: &ReadVolumesArgs) -> anyhow::Result<()> {
    let grid: VolumeGrid = serde_json::from_str(&args.grid).context("the voxels")?;
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
    setrlimit(resource, limits).context("cannot limit the process")
}
