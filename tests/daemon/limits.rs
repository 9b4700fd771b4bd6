//! Clients that send too much, too often or too slowly.

use std::{
    net::SocketAddr,
    time::{Duration, Instant},
};

use lfpiv::config::ServerSettings;
use tokio::{
    io::{AsyncReadExt, AsyncWriteExt},
    net::TcpStream,
};

use crate::{
    client::{Answer, Ask, exchange, get},
    previews::lit_board,
    server::{CONTROL, READ, Server, settings, with_tokens},
};

fn impatient() -> ServerSettings {
    ServerSettings { client_patience_s: 0.5, ..settings() }
}

/// Reads until the server closes, and returns the time this took.
async fn until_closed(stream: &mut TcpStream) -> (Duration, Vec<u8>) {
    let (began, mut received) = (Instant::now(), Vec::new());
    let read = stream.read_to_end(&mut received);
    let _ = tokio::time::timeout(Duration::from_secs(10), read).await.expect("never closed");
    (began.elapsed(), received)
}

#[tokio::test]
async fn too_large_a_body_or_header_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let server = Server::empty(&with_tokens(folder.path())).await;
    let note = |length: usize| {
        let text = "x".repeat(length);
        Ask::post("/api/v1/control/note").token(CONTROL).json(&format!("{{\"text\":\"{text}\"}}"))
    };
    let refused = |answer: Answer, words: &str| {
        let error = answer.error(413);
        assert!(error.contains(words), "{error}");
    };
    refused(note(70_000).of(server.address).await, "at most 65536");
    refused(note(4097).of(server.address).await, "at most 4096");
    assert_eq!(note(4096).of(server.address).await.status, 409);
    // A claimed length is refused before the body is read.
    let claimed = Ask::post("/api/v1/control/note")
        .token(CONTROL)
        .with("Content-Type", "application/json")
        .with("Content-Length", "99999999999");
    refused(claimed.of(server.address).await, "99999999999 bytes");
    let chunk = format!("{:x}\r\n{}\r\n", 70_000, "x".repeat(70_000));
    let chunked = Ask::post("/api/v1/control/note")
        .token(CONTROL)
        .with("Content-Type", "application/json")
        .with("Transfer-Encoding", "chunked")
        .unsized_body(chunk.as_bytes());
    refused(chunked.of(server.address).await, "length limit");
    let long = Ask::get("/api/v1/status").token(READ).with("X-Long", &"x".repeat(40_000));
    assert_eq!(long.of(server.address).await.status, 431);
    let many = (0..100).fold(Ask::get("/healthz"), |ask, n| ask.with(&format!("X-{n}"), "x"));
    assert_eq!(many.of(server.address).await.status, 431);
    assert_eq!(get(server.address, "/healthz").await.status, 200);
}

#[tokio::test]
async fn a_client_that_sends_its_header_slowly_is_disconnected() {
    let server = Server::empty(&impatient()).await;
    let mut stream = TcpStream::connect(server.address).await.unwrap();
    stream.write_all(b"GET /healthz HTTP/1.1\r\nHost: localhost\r\n").await.unwrap();
    let began = Instant::now();
    let dribble = async {
        // Each line arrives within the patience, but the whole header does not.
        while stream.write_all(b"X-More: x\r\n").await.is_ok() {
            tokio::time::sleep(Duration::from_millis(50)).await;
        }
    };
    tokio::time::timeout(Duration::from_secs(8), dribble).await.expect("it is still served");
    assert!(began.elapsed() >= Duration::from_millis(450), "{:?}", began.elapsed());
    assert_eq!(get(server.address, "/healthz").await.status, 200);
}

#[tokio::test]
async fn a_silent_or_idle_client_is_disconnected() {
    let server = Server::empty(&impatient()).await;
    let mut silent = TcpStream::connect(server.address).await.unwrap();
    assert!(until_closed(&mut silent).await.0 < Duration::from_secs(5));
    let mut idle = TcpStream::connect(server.address).await.unwrap();
    idle.write_all(b"GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n").await.unwrap();
    let (waited, received) = until_closed(&mut idle).await;
    assert_eq!(Answer::read(&received).status, 200);
    assert!(waited < Duration::from_secs(5), "{waited:?}");
}

#[tokio::test]
async fn a_client_that_sends_its_body_slowly_gets_an_error_and_is_disconnected() {
    let folder = tempfile::tempdir().unwrap();
    let patience = ServerSettings { client_patience_s: 0.5, ..with_tokens(folder.path()) };
    let server = Server::empty(&patience).await;
    let slow = Ask::post("/api/v1/control/note")
        .token(CONTROL)
        .with("Content-Type", "application/json")
        .with("Content-Length", "1000")
        .body(b"{\"text\":");
    let answer = slow.of(server.address).await;
    assert!(answer.error(408).contains("after 0.5 s"), "{answer:?}");
}

/// Waits until the server has closed its end of a connection. The client would notice only after
/// reading everything sent before. /proc/net/tcp has a row for each end: local and remote address,
/// and the state, which is 01 while open.
async fn until_given_up(server: SocketAddr, client: SocketAddr) {
    let [server, client] = [server, client].map(|end| format!(":{:04X}", end.port()));
    let is_open = || {
        let table = std::fs::read_to_string("/proc/net/tcp").unwrap();
        table.lines().any(|row| {
            let fields: Vec<&str> = row.split_whitespace().collect();
            fields[1].ends_with(&server) && fields[2].ends_with(&client) && fields[3] == "01"
        })
    };
    let began = Instant::now();
    while is_open() {
        assert!(began.elapsed() < Duration::from_secs(120), "the server waits for ever");
        tokio::time::sleep(Duration::from_millis(20)).await;
    }
}

#[tokio::test]
async fn a_client_that_does_not_read_its_response_is_disconnected_and_frees_memory() {
    // A volume of 64 MB, which no socket buffer holds; four of them fill the memory for responses.
    let board = lit_board([256, 256, 256]);
    let ledger = lfpiv::acquisition::Ledger::new(2);
    let server = Server::with(ledger, board, &impatient(), |state| state).await;
    let volume = Ask::get("/api/v1/results/7/volumes/a");
    let mut streams = Vec::new();
    for _ in 0..3 {
        let mut stream = TcpStream::connect(server.address).await.unwrap();
        stream.write_all(&volume.bytes(server.address)).await.unwrap();
        streams.push(stream);
    }
    for mut stream in streams {
        until_given_up(server.address, stream.local_addr().unwrap()).await;
        let (_, received) = until_closed(&mut stream).await;
        assert!(received.len() < 64 << 20, "it was sent after all");
    }
    for _ in 0..5 {
        let whole = volume.of(server.address).await;
        assert_eq!((whole.status, whole.body.len()), (200, 80 + (64 << 20)));
    }
}

#[tokio::test]
async fn requests_are_limited_except_those_that_make_the_bench_safe() {
    let folder = tempfile::tempdir().unwrap();
    let slow = ServerSettings { requests_per_s: 0.5, ..with_tokens(folder.path()) };
    let server = Server::empty(&slow).await;
    for _ in 0..4 {
        assert_eq!(get(server.address, "/healthz").await.status, 200);
    }
    let limited = get(server.address, "/healthz").await;
    assert!(limited.error(429).contains("requests_per_s"));
    let seconds: u64 = limited.header("retry-after").unwrap().parse().unwrap();
    assert!((1..=2).contains(&seconds));
    for _ in 0..20 {
        for command in ["stop", "disarm"] {
            let ask = Ask::post(&format!("/api/v1/control/{command}")).token(CONTROL);
            assert_eq!(ask.of(server.address).await.status, 409, "no controls, but let through");
        }
    }
    let arm = Ask::post("/api/v1/control/arm").token(CONTROL);
    assert_eq!(arm.of(server.address).await.status, 429);
    assert_eq!(Ask::get("/api/v1/control/stop").of(server.address).await.status, 429);
}

/// A stream from another address of this machine.
async fn from_elsewhere(server: &Server) -> TcpStream {
    let socket = tokio::net::TcpSocket::new_v4().unwrap();
    socket.bind(std::net::SocketAddr::from(([127, 0, 0, 2], 0))).unwrap();
    socket.connect(server.address).await.unwrap()
}

#[tokio::test]
async fn silent_connections_lock_nobody_out() {
    let few = ServerSettings { guests: 8, client_patience_s: 60.0, ..settings() };
    let server = Server::empty(&few).await;
    let mut silent = Vec::new();
    for _ in 0..12 {
        silent.push(TcpStream::connect(server.address).await.unwrap());
    }
    // From the same address and from another one.
    assert_eq!(get(server.address, "/healthz").await.status, 200);
    let other = from_elsewhere(&server).await;
    assert_eq!(Ask::get("/healthz").over(other, server.address).await.status, 200);
    // They had half of the slots; the oldest one was evicted.
    for stream in &mut silent[..8] {
        assert_eq!(until_closed(stream).await.1, b"");
    }
}

#[tokio::test]
async fn streams_have_few_slots_without_a_token_and_many_with_one() {
    let folder = tempfile::tempdir().unwrap();
    let few = ServerSettings { guests: 8, connections: 40, ..settings() };
    let tokens = ServerSettings { guests: 8, connections: 40, ..with_tokens(folder.path()) };
    for (settings, most, key) in [(few, 4, "server.guests"), (tokens, 20, "server.connections")] {
        let server = Server::empty(&settings).await;
        let events = Ask::get("/api/v1/events").token(READ);
        let mut streams = Vec::new();
        for _ in 0..most {
            let mut stream = TcpStream::connect(server.address).await.unwrap();
            stream.write_all(&events.bytes(server.address)).await.unwrap();
            let mut begun = [0; 12];
            stream.read_exact(&mut begun).await.unwrap();
            assert_eq!(&begun, b"HTTP/1.1 200");
            streams.push(stream);
        }
        let refused = events.of(server.address).await;
        assert!(refused.error(503).contains(key), "{refused:?}");
        // Streams are not guests, so new connections evict none of them.
        for _ in 0..20 {
            assert_eq!(get(server.address, "/healthz").await.status, 200);
        }
        let elsewhere = from_elsewhere(&server).await;
        let status = Ask::get("/api/v1/status").token(READ).over(elsewhere, server.address).await;
        assert_eq!(status.status, 200);
        if settings.tokens.is_some() {
            let disarm = Ask::post("/api/v1/control/disarm").token(CONTROL);
            assert_eq!(disarm.of(server.address).await.status, 409, "no controls, but let through");
        }
        for stream in &mut streams {
            let mut more = [0; 1];
            stream.read_exact(&mut more).await.expect("the stream goes on");
        }
    }
}

#[tokio::test]
async fn bytes_that_are_not_http_are_refused() {
    let server = Server::empty(&impatient()).await;
    for bytes in [
        b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03".as_slice(),
        b"GET\r\n\r\n",
        b"GET /healthz HTTP/9.9\r\n\r\n",
        b"GET /healthz HTTP/1.1\r\nHost: localhost\r\nContent-Length: -1\r\n\r\n",
        b"POST /api/v1/control/stop HTTP/1.1\r\nHost: localhost\r\nContent-Length: 1\r\nContent-Length: 2\r\n\r\n",
        b"\0\0\0\0",
        &[0xff; 100_000],
    ] {
        let stream = TcpStream::connect(server.address).await.unwrap();
        let answer = exchange(stream, bytes).await;
        assert!(matches!(answer.status, 0 | 400 | 408 | 431 | 505), "{answer:?}");
    }
    assert_eq!(get(server.address, "/healthz").await.status, 200);
}
