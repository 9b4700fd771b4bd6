//! Connections: accepted within limits, secured where configured, cut off when a client is too
//! slow, and ended in order.

use std::{collections::HashMap, net::IpAddr, sync::Arc, time::Duration};

use axum::{Router, body::Body};
use hyper::{Request, body::Incoming, server::conn::http1, service::service_fn};
use hyper_util::{
    rt::{TokioIo, TokioTimer},
    server::graceful::{GracefulShutdown, Watcher},
};
use parking_lot::Mutex;
use tokio::{
    io::{AsyncRead, AsyncWrite},
    net::{TcpListener, TcpStream},
    task::JoinSet,
};
use tokio_io_timeout::TimeoutStream;
use tokio_util::sync::CancellationToken;
use tower::ServiceExt;

use super::{app::Connection, protection::Protection};

/// Largest header of a request.
const HEADER_BYTES: usize = 32 << 10;
/// Most fields of a header.
const HEADER_FIELDS: usize = 64;
/// Pause after the system refused a connection: it is out of file descriptors.
const REFUSED_PAUSE: Duration = Duration::from_millis(100);

/// Serves connections until `stop` is cancelled and those open have ended.
pub(super) async fn listen(
    listener: TcpListener,
    router: Router,
    protection: Arc<Protection>,
    stop: CancellationToken,
) {
    let graceful = GracefulShutdown::new();
    let seats = Arc::new(Seats::new(protection.connections));
    // Dropped with this future: then no connection outlives it.
    let mut connections = JoinSet::new();
    loop {
        let accepted = tokio::select! {
            accepted = listener.accept() => accepted,
            () = stop.cancelled() => break,
            Some(_) = connections.join_next() => continue,
        };
        let (stream, peer) = match accepted {
            Ok(accepted) => accepted,
            Err(error) => {
                tracing::warn!(%error, "a connection could not be accepted");
                tokio::time::sleep(REFUSED_PAUSE).await;
                continue;
            }
        };
        // Without a seat the stream is closed at once: an answer would cost what there is none of.
        let Some(seat) = Seat::take(&seats, peer.ip()) else {
            tracing::debug!(%peer, "no more connections; see server.connections");
            continue;
        };
        let (router, protection, watcher) =
            (router.clone(), protection.clone(), graceful.watcher());
        connections.spawn(async move {
            if let Err(error) = serve_connection(stream, router, &protection, watcher).await {
                tracing::debug!(%peer, %error, "the connection ended");
            }
            drop(seat);
        });
    }
    drop(listener);
    graceful.shutdown().await;
    while connections.join_next().await.is_some() {}
}

type Ended = Result<(), Box<dyn std::error::Error + Send + Sync>>;

async fn serve_connection(
    stream: TcpStream,
    router: Router,
    protection: &Protection,
    watcher: Watcher,
) -> Ended {
    let connection = Connection { peer: stream.peer_addr()?, local: stream.local_addr()? };
    stream.set_nodelay(true)?;
    match &protection.tls {
        None => serve_http(stream, connection, router, protection.patience, watcher).await,
        Some(tls) => {
            let stream = tokio::time::timeout(protection.patience, tls.accept(stream)).await??;
            serve_http(stream, connection, router, protection.patience, watcher).await
        }
    }
}

async fn serve_http(
    stream: impl AsyncRead + AsyncWrite + Send + 'static,
    connection: Connection,
    router: Router,
    patience: Duration,
    watcher: Watcher,
) -> Ended {
    // A client that takes nothing for so long has gone, or holds an answer's memory for nothing.
    let mut stream = Box::pin(TimeoutStream::new(stream));
    stream.as_mut().set_write_timeout_pinned(Some(patience));
    let service = service_fn(move |mut request: Request<Incoming>| {
        request.extensions_mut().insert(connection);
        router.clone().oneshot(request.map(Body::new))
    });
    let served = http1::Builder::new()
        .timer(TokioTimer::new())
        .header_read_timeout(patience)
        .max_headers(HEADER_FIELDS)
        .max_header_size(HEADER_BYTES)
        .max_buf_size(2 * HEADER_BYTES)
        .serve_connection(TokioIo::new(stream), service);
    watcher.watch(served).await?;
    Ok(())
}

/// Places for connections; one client may have half of them.
struct Seats {
    most: usize,
    taken: Mutex<HashMap<IpAddr, usize>>,
}

impl Seats {
    fn new(most: usize) -> Self {
        Self { most, taken: Mutex::default() }
    }
}

/// Given back when it is dropped.
struct Seat {
    seats: Arc<Seats>,
    client: IpAddr,
}

impl Seat {
    fn take(seats: &Arc<Seats>, client: IpAddr) -> Option<Self> {
        let mut taken = seats.taken.lock();
        let all: usize = taken.values().sum();
        let own = taken.get(&client).copied().unwrap_or_default();
        if all >= seats.most || own >= seats.most / 2 {
            return None;
        }
        taken.insert(client, own + 1);
        Some(Self { seats: seats.clone(), client })
    }
}

impl Drop for Seat {
    fn drop(&mut self) {
        let mut taken = self.seats.taken.lock();
        match taken.get_mut(&self.client) {
            Some(own) if *own > 1 => *own -= 1,
            _ => drop(taken.remove(&self.client)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_client_gets_half_of_the_seats_and_gives_them_back() {
        let seats = Arc::new(Seats::new(8));
        let take = |client: u8, count: usize| -> Vec<Seat> {
            let client = IpAddr::from([10, 0, 0, client]);
            (0..count).map_while(|_| Seat::take(&seats, client)).collect()
        };
        let first = take(1, 8);
        let (second, third) = (take(2, 3), take(3, 3));
        assert_eq!([first.len(), second.len(), third.len()], [4, 3, 1]);
        drop(first);
        assert_eq!(take(3, 8).len(), 3, "half of eight, less the one it has");
        drop((second, third));
        assert!(seats.taken.lock().is_empty());
    }
}
