//! A network of a given rate, on this machine.

use std::{
    net::{Ipv4Addr, SocketAddr},
    sync::Arc,
    time::Duration,
};

use anyhow::Context;
use parking_lot::Mutex;
use tokio::{
    io::{AsyncRead, AsyncReadExt, AsyncWrite, AsyncWriteExt},
    net::{TcpListener, TcpStream},
    task::{JoinHandle, JoinSet},
    time::Instant,
};

/// Bytes passed on at a time: connections take turns.
const TURN: usize = 16 << 10;
/// What the next turn may be late by at no cost: the senders' buffers are full meanwhile, and timers are not exact.
const LATE: Duration = Duration::from_millis(5);

/// Passes connections on; those to workers share a rate. It ends when it is dropped.
pub(super) struct SlowNetwork {
    address: SocketAddr,
    serving: JoinHandle<()>,
}

impl SlowNetwork {
    /// To the server at `server`, with `bytes_per_s` for what it sends.
    ///
    /// # Errors
    /// There is no free port.
    pub async fn to(server: SocketAddr, bytes_per_s: f64) -> anyhow::Result<Self> {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).await.context("no free port")?;
        let address = listener.local_addr().context("no address")?;
        let link = Arc::new(Link { bytes_per_s, free_at: Mutex::new(Instant::now()) });
        let serving = tokio::spawn(async move {
            let mut connections = JoinSet::new();
            while let Ok((worker, _)) = listener.accept().await {
                connections.spawn(join(worker, server, link.clone()));
                while connections.try_join_next().is_some() {}
            }
        });
        Ok(Self { address, serving })
    }

    /// Where it listens.
    pub fn address(&self) -> SocketAddr {
        self.address
    }
}

impl Drop for SlowNetwork {
    fn drop(&mut self) {
        self.serving.abort();
    }
}

/// The time at which the bytes so far have passed.
struct Link {
    bytes_per_s: f64,
    free_at: Mutex<Instant>,
}

impl Link {
    /// When so many more bytes have passed that come at `now`. An idle link saves nothing up beyond [`LATE`].
    fn passed(&self, bytes: usize, now: Instant) -> Instant {
        let time = Duration::from_secs_f64(bytes as f64 / self.bytes_per_s);
        let mut free_at = self.free_at.lock();
        *free_at = (*free_at).max(now.checked_sub(LATE).unwrap_or(now)) + time;
        *free_at
    }
}

async fn join(worker: TcpStream, server: SocketAddr, link: Arc<Link>) {
    let Ok(server) = TcpStream::connect(server).await else { return };
    let (from_worker, to_worker) = worker.into_split();
    let (from_server, to_server) = server.into_split();
    let asked = pass_on(from_worker, to_server, None);
    let answered = pass_on(from_server, to_worker, Some(&link));
    tokio::join!(asked, answered);
}

async fn pass_on(
    mut from: impl AsyncRead + Unpin,
    mut to: impl AsyncWrite + Unpin,
    link: Option<&Link>,
) {
    let mut bytes = vec![0; TURN];
    while let Ok(read @ 1..) = from.read(&mut bytes).await {
        if let Some(link) = link {
            tokio::time::sleep_until(link.passed(read, Instant::now())).await;
        }
        if to.write_all(&bytes[..read]).await.is_err() {
            break;
        }
    }
    let _ = to.shutdown().await;
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_passes_together_shares_the_rate() {
        let began = Instant::now();
        let after = |s| began + Duration::from_secs(s);
        let link = Link { bytes_per_s: 1000.0, free_at: Mutex::new(began) };
        assert_eq!([1000, 2000].map(|bytes| link.passed(bytes, began)), [after(1), after(3)]);
        assert_eq!(link.passed(1000, after(2)), after(4));
        // Late by less than a turn, and idle for long.
        assert_eq!(link.passed(1000, after(4) + LATE), after(5));
        assert_eq!(link.passed(1000, after(10)), after(11) - LATE);
    }
}
