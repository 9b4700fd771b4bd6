//! What the kernel believes of the host's clock.

use std::{io, mem::MaybeUninit};

/// The kernel's opinion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct KernelClock {
    /// Somebody keeps it in step with UTC.
    pub synchronised: bool,
    /// Largest error believed possible, in µs.
    pub max_error_us: i64,
}

/// Asks the kernel; changes nothing.
///
/// # Errors
/// The kernel does not allow the question, as some containers do not.
pub fn kernel_clock() -> io::Result<KernelClock> {
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

#[cfg(test)]
mod tests {
    use super::*;

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
}
