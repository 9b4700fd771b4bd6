//! Access control: tokens, scopes, host names and origins.

use lfpiv::{
    config::{Config, ServerSettings},
    server::Protection,
};

use crate::{
    bench::configuration,
    client::{Answer, Ask, exchange},
    server::{CONTROL, READ, Server, settings, with_tokens},
};

async fn status(server: &Server, ask: Ask) -> u16 {
    ask.of(server.address).await.status
}

#[tokio::test]
async fn a_token_grants_its_scope() {
    let folder = tempfile::tempdir().unwrap();
    let server = Server::empty(&with_tokens(folder.path())).await;
    let read = ["/api/v1/status", "/api/v1/events", "/api/v1/shots", "/api/v1/control", "/metrics"];
    for path in read {
        let absent = Ask::get(path).of(server.address).await;
        assert!(absent.error(401).contains("Authorization: Bearer"), "{path}");
        assert_eq!(absent.header("www-authenticate"), Some("Bearer realm=\"lfpiv\""));
        let wrong = Ask::get(path).token(&READ.replace('f', "e")).of(server.address).await;
        assert!(wrong.error(401).contains("not known"), "{path}");
        assert!(wrong.header("www-authenticate").unwrap().contains("invalid_token"));
    }
    assert_eq!(status(&server, Ask::get("/api/v1/status").token(READ)).await, 200);
    assert_eq!(status(&server, Ask::get("/api/v1/status").token(CONTROL)).await, 200);
    for command in ["start", "stop", "arm", "disarm", "dt", "note"] {
        let path = format!("/api/v1/control/{command}");
        assert_eq!(status(&server, Ask::post(&path)).await, 401, "{path}");
        let narrow = Ask::post(&path).token(READ).of(server.address).await;
        assert!(narrow.error(403).contains("scope is read, this needs control"));
        assert!(narrow.header("www-authenticate").unwrap().contains("insufficient_scope"));
    }
    let let_in = Ask::post("/api/v1/control/stop").token(CONTROL).of(server.address).await;
    assert!(let_in.error(409).contains("cannot be controlled"));
    assert_eq!(let_in.json()["reasons"].as_array().unwrap().len(), 1);
    for open in ["/healthz", "/docs", "/api/v1/openapi.json"] {
        assert_eq!(server.get(open).await.status, 200, "{open}");
    }
}

#[tokio::test]
async fn a_token_elsewhere_grants_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let server = Server::empty(&with_tokens(folder.path())).await;
    for key in ["token", "access_token", "Authorization", "t", "format"] {
        let path = format!("/api/v1/status?{key}={READ}");
        let refused = Ask::get(&path).token(READ).of(server.address).await;
        assert!(refused.error(400).contains("replace this one"));
    }
    let path = "/api/v1/status";
    let basic = Ask::get(path).with("Authorization", &format!("Basic {READ}"));
    assert_eq!(status(&server, basic).await, 401);
    let cookie = Ask::get(path).with("Cookie", &format!("token={READ}"));
    assert_eq!(status(&server, cookie).await, 401);
    assert_eq!(status(&server, Ask::get(path).with("Authorization", READ)).await, 401);
    assert_eq!(status(&server, Ask::get(path).token("")).await, 401);
    let twice = Ask::get(path).token(READ).token(CONTROL);
    assert_eq!(status(&server, twice).await, 400);
}

#[tokio::test]
async fn without_tokens_loopback_can_read_and_nobody_can_control() {
    let server = Server::empty(&settings()).await;
    assert_eq!(server.get("/api/v1/status").await.status, 200);
    for command in ["start", "stop", "arm", "disarm", "dt", "note"] {
        let ask = Ask::post(&format!("/api/v1/control/{command}")).token(CONTROL);
        let refused = ask.of(server.address).await.error(403);
        assert!(refused.contains("server.tokens"), "{refused}");
    }
}

#[tokio::test]
async fn a_foreign_host_name_is_refused() {
    let settings = ServerSettings { hosts: vec!["bench.lab".to_owned()], ..settings() };
    let server = Server::empty(&settings).await;
    let port = server.address.port();
    let path = "/api/v1/status";
    for host in ["localhost", "127.0.0.1:1", "[::1]", "Bench.Lab:80"] {
        assert_eq!(status(&server, Ask::get(path).with("Host", host)).await, 200, "{host}");
    }
    // Resolved to 127.0.0.1 by the owner of the name.
    for host in
        ["evil.example", &format!("evil.example:{port}"), "localhost.evil.example", "10.1.1.1"]
    {
        let refused = Ask::get(path).with("Host", host).of(server.address).await;
        assert!(refused.error(421).contains("server.hosts"), "{host}");
        assert_eq!(refused.header("access-control-allow-origin"), None);
    }
    let absolute = Ask::get("http://evil.example/api/v1/status").with("Host", "localhost");
    assert_eq!(status(&server, absolute).await, 421);
    let twice = Ask::get(path).with("Host", "localhost").with("Host", "evil.example");
    assert_eq!(status(&server, twice).await, 400);
    let stream = tokio::net::TcpStream::connect(server.address).await.unwrap();
    let nameless: Answer = exchange(stream, b"GET /api/v1/status HTTP/1.0\r\n\r\n").await;
    assert!(nameless.error(400).contains("no Host"));
}

#[tokio::test]
async fn pages_of_other_servers_are_refused_even_with_a_token() {
    let folder = tempfile::tempdir().unwrap();
    let server = Server::empty(&with_tokens(folder.path())).await;
    let own = format!("http://{}", server.address);
    let neighbour = format!("http://127.0.0.1:{}", server.address.port().wrapping_add(1));
    for (origin, expected) in [
        (own.as_str(), 409),
        ("http://evil.example", 403),
        ("null", 403),
        (neighbour.as_str(), 403),
        (&own.replace("http:", "https:"), 403),
    ] {
        let ask = Ask::post("/api/v1/control/stop").token(CONTROL).with("Origin", origin);
        let answer = ask.of(server.address).await;
        assert_eq!(answer.status, expected, "{origin}: {answer:?}");
        assert_eq!(answer.header("access-control-allow-origin"), None);
    }
    let preflight = Ask::new("OPTIONS", "/api/v1/control/stop")
        .with("Origin", "http://evil.example")
        .with("Access-Control-Request-Method", "POST");
    assert_eq!(status(&server, preflight).await, 403);
    // A form can post without a preflight, but cannot state that it posts JSON.
    let form = Ask::post("/api/v1/control/note")
        .token(CONTROL)
        .with("Content-Type", "text/plain")
        .body(br#"{"text": "x"}"#);
    assert_eq!(status(&server, form).await, 415);
}

#[tokio::test]
async fn security_headers_are_sent() {
    let server = Server::empty(&settings()).await;
    for path in ["/api/v1/status", "/docs", "/nothing"] {
        let answer = server.get(path).await;
        for (name, value) in [
            ("x-content-type-options", "nosniff"),
            ("x-frame-options", "DENY"),
            ("cross-origin-resource-policy", "same-origin"),
            ("cache-control", "no-store"),
        ] {
            assert_eq!(answer.header(name), Some(value), "{path}");
        }
    }
    let policy = server.get("/docs").await;
    let policy = policy.header("content-security-policy").unwrap();
    assert!(policy.starts_with("default-src 'none'; script-src 'self'"), "{policy}");
}

#[tokio::test]
async fn a_server_without_tokens_cannot_listen_beyond_loopback() {
    let mut file = configuration(std::path::Path::new("unused"));
    file.config.server.address = "0.0.0.0:0".parse().unwrap();
    let plan =
        lfpiv::cli::daemon::DaemonPlan::new(file, None, lfpiv::acquisition::OverloadPolicy::Shed);
    let refused = lfpiv::cli::daemon::Daemon::prepare(plan).await.err().unwrap().to_string();
    assert!(refused.contains("0.0.0.0:0") && refused.contains("server.tokens"), "{refused}");

    let small = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/small.toml");
    let text = std::fs::read_to_string(small).unwrap();
    let at = text.find("address = ").unwrap();
    let line_end = at + text[at..].find('\n').unwrap();
    let with = |lines: &str| format!("{}{lines}{}", &text[..at], &text[line_end..]);
    let refused = Config::parse("run.toml", &with("address = \"[::]:8640\"")).unwrap_err();
    let refused = refused.to_string();
    assert!(refused.contains("server.address") && refused.contains("tokens"), "{refused}");
    let tokens = with("address = \"[::]:8640\"\ntokens = \"absent\"");
    let settings = Config::parse("run.toml", &tokens).unwrap().server;
    let refused = Protection::open(&settings).err().unwrap().to_string();
    assert!(refused.contains("absent cannot be read"), "{refused}");
    let hosts = with("address = \"127.0.0.1:1\"\nhosts = [\"http://bench\"]");
    let refused = Config::parse("run.toml", &hosts).unwrap_err().to_string();
    assert!(refused.contains("without scheme"), "{refused}");
}

#[tokio::test]
async fn with_tokens_the_server_accepts_its_address_and_names_from_the_network() {
    let folder = tempfile::tempdir().unwrap();
    let address = "0.0.0.0:0".parse().unwrap();
    let server = Server::empty(&ServerSettings { address, ..with_tokens(folder.path()) }).await;
    let here = ([127, 0, 0, 1], server.address.port()).into();
    let ask = Ask::get("/api/v1/status").token(READ);
    assert_eq!(ask.of(here).await.status, 200);
    assert_eq!(ask.clone().with("Host", "evil.example").of(here).await.status, 421);
    assert_eq!(Ask::get("/api/v1/status").of(here).await.status, 401);
}
