//! A small ext4 file system on a loop device, for fault injection.

use std::{
    fs::{self, File},
    os::fd::AsRawFd,
    path::{Path, PathBuf},
    process::{Command, Stdio},
};

/// `EXT4_IOC_SHUTDOWN`, `_IOR('X', 125, __u32)` (fs/ext4/ext4.h).
const SHUTDOWN: libc::Ioctl = 0x8004_587d_u32 as libc::Ioctl;

/// A mounted file system, removed on drop.
pub struct LoopDisk {
    image: PathBuf,
    folder: PathBuf,
}

impl LoopDisk {
    /// Creates a file system of this many megabytes and mounts it at `folder`; `None` if this is
    /// not permitted.
    pub fn mount(scratch: &Path, folder: &Path, megabytes: u32) -> Option<Self> {
        let disk = Self { image: scratch.join("image"), folder: folder.into() };
        fs::create_dir_all(folder).ok()?;
        let image = File::create(&disk.image).ok()?;
        image.set_len(u64::from(megabytes) << 20).ok()?;
        let made = run("mkfs.ext4", &["-q", "-F"], &[&disk.image]);
        (made && disk.attach()).then_some(disk)
    }

    /// Mount point.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Makes it read-only, as the kernel does after a disk error.
    pub fn make_read_only(&self) {
        let device = fs::read_to_string("/proc/mounts").expect("what is mounted");
        let folder = self.folder.to_str().expect("a path in UTF-8");
        let mount = device.lines().find(|line| line.split(' ').nth(1) == Some(folder));
        let device = mount.and_then(|line| line.split(' ').next()).expect("its own mount");
        let device = device.trim_start_matches("/dev/");
        fs::write(format!("/sys/fs/ext4/{device}/trigger_fs_error"), "adversary")
            .expect("an error of the file system");
    }

    /// Shuts it down, as when the device is removed: 0 writes everything first, 1 the journal, 2
    /// nothing.
    pub fn shut_down(&self, flags: u32) {
        let folder = File::open(&self.folder).expect("its folder");
        shut_down(&folder, flags).expect("a shutdown of the file system");
    }

    /// Unmounts and remounts it, which replays its journal.
    pub fn mount_again(&mut self) {
        assert!(self.detach() && self.attach(), "the file system cannot be mounted again");
    }

    fn attach(&self) -> bool {
        run("mount", &["-o", "loop,errors=remount-ro"], &[&self.image, &self.folder])
    }

    fn detach(&self) -> bool {
        run("umount", &[], &[&self.folder])
    }
}

impl Drop for LoopDisk {
    fn drop(&mut self) {
        self.detach();
    }
}

fn run(program: &str, options: &[&str], paths: &[&Path]) -> bool {
    let mut command = Command::new(program);
    command.args(options).args(paths).stdout(Stdio::null()).stderr(Stdio::null());
    command.status().is_ok_and(|status| status.success())
}

#[expect(unsafe_code)]
fn shut_down(file: &File, flags: u32) -> std::io::Result<()> {
    // SAFETY: the descriptor is open through the call, and the number is read, not kept.
    let done = unsafe { libc::ioctl(file.as_raw_fd(), SHUTDOWN, &flags) };
    if done == 0 { Ok(()) } else { Err(std::io::Error::last_os_error()) }
}
