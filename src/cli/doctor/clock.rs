//! Is the clock synchronised? Host times stand in results and logs.

use std::{io, mem::MaybeUninit, path::Path};

use super::Finding;

const CHECK: &str = "clock";
/// Made by systemd-timesyncd once it has set the clock.
const TIMESYNCD_MARK: &str = "/run/systemd/timesync/synchronized";

/// What the kernel says of its clock, and systemd where the kernel is not allowed to.
pub fn examine() -> Finding {
    judge(kernel_clock(), Path::new(TIMESYNCD_MARK).exists())
}

/// The kernel's opinion.
#[derive(Debug, Clone, Copy, PartialEq)]
struct KernelClock {
    synchronised: bool,
    /// Largest error believed possible.
    max_error_us: i64,
}

/// Asks the kernel; changes nothing.
///
/// # Errors
/// The kernel does not allow the question, as some containers do not.
fn kernel_clock() -> io::Result<KernelClock> {
    let (state, answer) = adjtimex()?;
    let synchronised = state != libc::TIME_ERROR && answer.status & libc::STA_UNSYNC == 0;
    #[allow(clippy::useless_conversion)] // 32 bits on some machines.
    let max_error_us = i64::from(answer.maxerror);
    Ok(KernelClock { synchronised, max_error_us })
}

#[expect(unsafe_code)]
fn adjtimex() -> io::Result<(i32, libc::timex)> {
    let mut answer = MaybeUninit::<libc::timex>::zeroed();
    // SAFETY: the pointer is to memory of a whole `timex`, which lives until the call returns and
    // of which all zeros is a valid value: `modes` 0 asks and sets nothing. The kernel writes no
    // further than that.
    let (state, answer) = unsafe { (libc::adjtimex(answer.as_mut_ptr()), answer.assume_init()) };
    if state < 0 { Err(io::Error::last_os_error()) } else { Ok((state, answer)) }
}

fn judge(kernel: io::Result<KernelClock>, timesyncd: bool) -> Finding {
    let todo = "install chrony or enable systemd-timesyncd (timedatectl set-ntp true), so that \
                times of results and logs can be compared with other instruments'";
    match kernel {
        Ok(KernelClock { synchronised: true, max_error_us }) => {
            let found = format!("synchronised, at most {} ms off", max_error_us / 1000);
            Finding::ok(CHECK, found).with("max_error_us", max_error_us as f64)
        }
        _ if timesyncd => Finding::ok(CHECK, "synchronised, says systemd-timesyncd"),
        Ok(_) => Finding::advice(CHECK, "not synchronised", todo),
        Err(error) => Finding::advice(CHECK, format!("the kernel does not tell: {error}"), todo),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::doctor::Verdict;

    /// The kernel is asked for real; asking twice shows that asking changes nothing.
    #[test]
    fn the_kernel_answers_or_refuses() {
        match (kernel_clock(), kernel_clock()) {
            (Ok(first), Ok(second)) => {
                assert!(first.max_error_us >= 0);
                assert_eq!(first.synchronised, second.synchronised);
            }
            (first, _) => {
                let error = first.unwrap_err();
                assert_eq!(error.kind(), io::ErrorKind::PermissionDenied, "{error}");
            }
        }
    }

    #[test]
    fn either_witness_is_enough() {
        let kernel = |synchronised| Ok(KernelClock { synchronised, max_error_us: 2500 });
        assert!(judge(kernel(true), false).found.contains("at most 2 ms"));
        assert_eq!(judge(kernel(false), true).verdict, Verdict::Ok);
        assert_eq!(judge(kernel(false), false).verdict, Verdict::Advice);
        let refused = || Err(io::ErrorKind::PermissionDenied.into());
        assert_eq!(judge(refused(), true).verdict, Verdict::Ok);
        assert!(judge(refused(), false).found.contains("does not tell"));
    }
}
