//! Checks whether the clock is synchronised: results and logs contain the host's time.

use std::{io, path::Path};

use super::Finding;
use crate::acquisition::{KernelClock, kernel_clock};

const CHECK: &str = "clock";
/// Created by systemd-timesyncd once it has set the clock.
const TIMESYNCD_MARK: &str = "/run/systemd/timesync/synchronized";

/// Asks the kernel, and systemd in case the kernel refuses.
pub fn examine() -> Finding {
    judge(kernel_clock(), Path::new(TIMESYNCD_MARK).exists())
}

fn judge(kernel: io::Result<KernelClock>, timesyncd: bool) -> Finding {
    let todo = "install chrony or enable systemd-timesyncd (timedatectl set-ntp true), so that \
                times of results and logs can be compared with those of other instruments";
    match kernel {
        Ok(KernelClock { synchronised: true, max_error_us }) => {
            let found = format!("synchronised, at most {} ms off", max_error_us / 1000);
            Finding::ok(CHECK, found).with("max_error_us", max_error_us as f64)
        }
        _ if timesyncd => Finding::ok(CHECK, "synchronised, according to systemd-timesyncd"),
        Ok(_) => Finding::advice(CHECK, "not synchronised", todo),
        Err(error) => {
            Finding::advice(CHECK, format!("the kernel does not report its state: {error}"), todo)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::doctor::Verdict;

    #[test]
    fn kernel_or_timesyncd_is_sufficient() {
        let kernel = |synchronised| Ok(KernelClock { synchronised, max_error_us: 2500 });
        assert!(judge(kernel(true), false).found.contains("at most 2 ms"));
        assert_eq!(judge(kernel(false), true).verdict, Verdict::Ok);
        assert_eq!(judge(kernel(false), false).verdict, Verdict::Advice);
        let refused = || Err(io::ErrorKind::PermissionDenied.into());
        assert_eq!(judge(refused(), true).verdict, Verdict::Ok);
        assert!(judge(refused(), false).found.contains("does not report"));
    }
}
