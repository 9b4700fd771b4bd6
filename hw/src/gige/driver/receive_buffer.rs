//! Enlarges the kernel's receive buffer before the first packet.
//!
//! Aravis enlarges it after the first packet. That is too late for the rest of the first frame: packets
//! that arrive before its thread wakes up overflow the default of 208 KiB. Aravis does not expose the
//! socket, so it is found by its port among the process's own sockets.

use std::{fs, io};

use rustix::{
    fd::OwnedFd,
    net::{SocketAddrV4, getsockname, sockopt},
    process::{PidfdFlags, PidfdGetfdFlags, getpid, pidfd_getfd, pidfd_open},
};

/// Sets the receive buffer of the socket at `port` to `bytes`; returns the size granted by the kernel,
/// which without `CAP_NET_ADMIN` is at most `net.core.rmem_max`.
///
/// # Errors
/// The socket is not found, or the process may not inspect its own descriptors.
pub(super) fn enlarge(port: u16, bytes: usize) -> io::Result<usize> {
    let socket = socket_at(port)?;
    if sockopt::set_socket_recv_buffer_size_force(&socket, bytes).is_err() {
        sockopt::set_socket_recv_buffer_size(&socket, bytes)?;
    }
    // The kernel reports twice the requested size, to include its overhead.
    Ok(sockopt::socket_recv_buffer_size(&socket)? / 2)
}

/// A duplicate of our descriptor for that socket. It is obtained as from another process, because only
/// the kernel can tell whether a number is still a descriptor.
fn socket_at(port: u16) -> io::Result<OwnedFd> {
    let own = pidfd_open(getpid(), PidfdFlags::empty())?;
    for entry in fs::read_dir("/proc/self/fd")? {
        let Some(number) = entry?.file_name().to_str().and_then(|name| name.parse().ok()) else {
            continue;
        };
        let Ok(descriptor) = pidfd_getfd(&own, number, PidfdGetfdFlags::empty()) else { continue };
        let at_port = getsockname(&descriptor)
            .ok()
            .and_then(|address| SocketAddrV4::try_from(address).ok())
            .is_some_and(|address| address.port() == port);
        let datagrams = sockopt::socket_type(&descriptor) == Ok(rustix::net::SocketType::DGRAM);
        if at_port && datagrams {
            return Ok(descriptor);
        }
    }
    Err(io::Error::new(io::ErrorKind::NotFound, format!("no socket with port {port}")))
}

#[cfg(test)]
mod tests {
    use std::net::UdpSocket;

    use super::*;

    #[test]
    fn the_right_socket_grows() {
        let sockets = [0, 1].map(|_| UdpSocket::bind("127.0.0.1:0").unwrap());
        let before = sockets.each_ref().map(|s| sockopt::socket_recv_buffer_size(s).unwrap());
        let port = sockets[1].local_addr().unwrap().port();
        let granted = enlarge(port, 100_000).unwrap();
        let after = sockets.each_ref().map(|s| sockopt::socket_recv_buffer_size(s).unwrap());
        assert_eq!(granted, 100_000);
        assert_eq!(after, [before[0], 200_000]);
    }

    #[test]
    fn a_port_without_a_socket_is_an_error() {
        let port = UdpSocket::bind("127.0.0.1:0").unwrap().local_addr().unwrap().port();
        assert_eq!(enlarge(port, 100_000).unwrap_err().kind(), io::ErrorKind::NotFound);
    }
}
