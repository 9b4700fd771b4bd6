//! The kernel's estimate of the host clock's error.

use std::{io, mem::MaybeUninit};

/// The kernel's estimate.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct KernelClock {
    /// Whether the clock is synchronised with UTC.
    pub synchronised: bool,
    /// Maximum error, in µs.
    pub max_error_us: i64,
}

/// Queries the kernel without changing anything.
///
/// # Errors
/// The kernel refuses the query, as in some containers.
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
    // SAFETY: the pointer is to memory of a whole `timex` that lives until the call returns, and for
    // which all zeros is a valid value. `modes` 0 only queries. The kernel writes no further than the
    // struct.
    let (state, answer) = unsafe { (libc::adjtimex(answer.as_mut_ptr()), answer.assume_init()) };
    if state < 0 { Err(io::Error::last_os_error()) } else { Ok((state, answer)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Queries the real kernel; a second query shows that the first changed nothing.
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
