//! Accepts connections within limits, with TLS where configured, disconnects slow clients, and
//! shuts down gracefully.

use std::{io, net::SocketAddr, sync::Arc, time::Duration};

use axum::{Router, body::Body};
use hyper::{Request, body::Incoming, server::conn::http1, service::service_fn};
use hyper_util::{
    rt::{TokioIo, TokioTimer},
    server::graceful::{GracefulShutdown, Watcher},
};
use tokio::{
    io::{AsyncRead, AsyncWrite},
    net::{TcpListener, TcpStream},
    sync::OwnedSemaphorePermit,
    task::JoinSet,
};
use tokio_io_timeout::TimeoutStream;
use tokio_util::sync::CancellationToken;
use tower::ServiceExt;

use super::{
    app::Connection,
    connection_slots::{ConnectionSlots, SlotHandle},
    protection::Protection,
};

/// Largest size of a request's header.
const HEADER_BYTES: usize = 32 << 10;
/// Largest number of header fields.
const HEADER_FIELDS: usize = 64;
/// Pause after `accept` fails, mostly because the process is out of file descriptors.
const REFUSED_PAUSE: Duration = Duration::from_millis(100);

/// Serves connections until `stop` is cancelled and the open connections have ended.
pub(super) async fn listen(
    listener: TcpListener,
    router: Router,
    protection: Arc<Protection>,
    stop: CancellationToken,
) {
    let graceful = GracefulShutdown::new();
    let slots = ConnectionSlots::new(protection.connection_limits);
    // Dropped with this future, so no connection outlives it.
    let mut connections = JoinSet::new();
    loop {
        let accepted = tokio::select! {
            accepted = accept(&listener, &slots) => accepted,
            () = stop.cancelled() => break,
            Some(_) = connections.join_next() => continue,
        };
        let (stream, peer, socket) = match accepted {
            Ok(accepted) => accepted,
            Err(error) => {
                tracing::warn!(%error, "a connection could not be accepted");
                tokio::time::sleep(REFUSED_PAUSE).await;
                continue;
            }
        };
        let slot = slots.arrive(peer.ip(), socket);
        let (router, protection, watcher) =
            (router.clone(), protection.clone(), graceful.watcher());
        connections.spawn(async move {
            let served = serve_connection(stream, router, slot.handle(), &protection, watcher);
            let ended = tokio::select! {
                ended = served => ended,
                // Close without a response: resources are scarce.
                () = slot.evicted() => Ok(()),
            };
            if let Err(error) = ended {
                tracing::debug!(%peer, %error, "the connection ended");
            }
        });
    }
    drop(listener);
    graceful.shutdown().await;
    while connections.join_next().await.is_some() {}
}

/// Accepts the next connection once the limit of open sockets allows it.
async fn accept(
    listener: &TcpListener,
    slots: &ConnectionSlots,
) -> io::Result<(TcpStream, SocketAddr, OwnedSemaphorePermit)> {
    let socket = slots.socket().await.ok_or(io::ErrorKind::NotConnected)?;
    let (stream, peer) = listener.accept().await?;
    Ok((stream, peer, socket))
}

type Ended = Result<(), Box<dyn std::error::Error + Send + Sync>>;

async fn serve_connection(
    stream: TcpStream,
    router: Router,
    slot: SlotHandle,
    protection: &Protection,
    watcher: Watcher,
) -> Ended {
    let patience = protection.patience;
    let connection = Connection { peer: stream.peer_addr()?, local: stream.local_addr()? };
    stream.set_nodelay(true)?;
    match &protection.tls {
        None => serve_http(stream, (connection, slot), router, patience, watcher).await,
        Some(tls) => {
            let stream = tokio::time::timeout(patience, tls.accept(stream)).await??;
            serve_http(stream, (connection, slot), router, patience, watcher).await
        }
    }
}

async fn serve_http(
    stream: impl AsyncRead + AsyncWrite + Send + 'static,
    (connection, slot): (Connection, SlotHandle),
    router: Router,
    patience: Duration,
    watcher: Watcher,
) -> Ended {
    // A client that accepts no data for this long is gone or blocks the response's memory.
    let mut stream = Box::pin(TimeoutStream::new(stream));
    stream.as_mut().set_write_timeout_pinned(Some(patience));
    let service = service_fn(move |mut request: Request<Incoming>| {
        request.extensions_mut().insert(connection);
        request.extensions_mut().insert(slot.clone());
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
