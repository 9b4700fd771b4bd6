//! Every documented endpoint under random paths, queries, headers and bodies: never a server error
//! or a hang, and every refusal is JSON.

use lfpiv::config::ServerSettings;
use proptest::{
    prelude::*,
    test_runner::{Config, RngAlgorithm, TestRng, TestRunner},
};
use tokio::net::TcpStream;

use crate::{
    client::{Answer, Ask, exchange},
    control::{Bench, Recording},
    document::{document, head_of, operations},
    previews::lit_board,
    server::{CONTROL, READ, Server, with_tokens},
};

/// Cases per endpoint.
const CASES: u32 = 60;

/// A value in the place of a parameter.
fn parameter() -> impl Strategy<Value = String> {
    prop_oneof![
        3 => (0u64..12).prop_map(|n| n.to_string()),
        2 => prop::sample::select(vec![
            "latest", "a", "b", "xy.png", "a.png", "c.png", ".png", "-1", "1e9", "0x1", "%00",
            "18446744073709551615", "18446744073709551616", "%2e%2e", "..", "%ff%fe", "%", "",
            "a%0d%0aX:1",
        ]).prop_map(str::to_owned),
        2 => prop::collection::vec(any::<u8>(), 0..12).prop_map(encoded),
    ]
}

fn encoded(bytes: Vec<u8>) -> String {
    bytes.iter().map(|byte| format!("%{byte:02x}")).collect()
}

fn query() -> impl Strategy<Value = String> {
    let key = prop::sample::select(vec!["limit", "width", "format", "token", "x", ""]);
    let pair = (key, parameter()).prop_map(|(key, value)| format!("{key}={value}"));
    prop::collection::vec(pair, 0..3).prop_map(|pairs| match pairs.is_empty() {
        true => String::new(),
        false => format!("?{}", pairs.join("&")),
    })
}

fn headers() -> impl Strategy<Value = Vec<(String, String)>> {
    let name = prop::sample::select(vec![
        "Accept",
        "Range",
        "If-None-Match",
        "If-Range",
        "Last-Event-ID",
        "Origin",
        "Content-Type",
        "Authorization",
        "Host",
        "Cookie",
        "Expect",
        "X-Forwarded-For",
        "Upgrade",
    ]);
    let value = prop_oneof![
        prop::sample::select(vec![
            "application/json",
            "application/octet-stream",
            "bytes=0-3",
            "bytes=9-2",
            "bytes=-",
            "*",
            "\"\"",
            "W/\"x\"",
            "1-1",
            "null",
            "localhost",
            "100-continue",
            "websocket",
            "Bearer ",
            "Bearer x",
        ])
        .prop_map(str::to_owned),
        "[ -~]{0,40}",
        "[\u{a0}-\u{ff}]{1,8}",
    ];
    prop::collection::vec((name.prop_map(str::to_owned), value), 0..3)
}

fn body() -> impl Strategy<Value = Vec<u8>> {
    prop_oneof![
        2 => Just(Vec::new()),
        2 => prop::sample::select(vec![
            "{}", "{\"dt_us\": 50}", "{\"dt_us\": 1e308}", "{\"dt_us\": null}", "[]", "\"\"", "1",
            "{\"text\": \
             \"x\"}", "{\"text\": 1}", "{\"text\": \"\\ud800\"}", "{\"a\":{\"a\":{\"a\":",
        ]).prop_map(|text| text.as_bytes().to_vec()),
        1 => prop::collection::vec(any::<u8>(), 1..200),
        1 => (1usize..2000).prop_map(|depth| "[".repeat(depth).into_bytes()),
    ]
}

fn token() -> impl Strategy<Value = Option<&'static str>> {
    prop::sample::select(vec![Some(CONTROL), Some(CONTROL), Some(READ), None])
}

/// The path with its parameters filled from `values`.
fn filled(path: &str, values: &[String]) -> String {
    let mut values = values.iter();
    let parts = path.split('/').map(|part| match part.starts_with('{') {
        true => values.next().map_or("1", String::as_str),
        false => part,
    });
    parts.collect::<Vec<_>>().join("/")
}

fn judge(answer: &Answer) -> Result<(), TestCaseError> {
    prop_assert!((200..500).contains(&answer.status), "{answer:?}");
    // Requests refused by the HTTP library have no body.
    let unread = matches!(answer.status, 400 | 431) && answer.body.is_empty();
    if answer.status >= 400 && !unread {
        prop_assert_eq!(&answer.media_type, "application/json", "{:?}", answer);
        let error: serde_json::Value = serde_json::from_slice(&answer.body).unwrap_or_default();
        prop_assert!(error["error"].is_string(), "{answer:?}");
    }
    Ok(())
}

async fn fuzzed_server(folder: &std::path::Path) -> Server {
    let settings = ServerSettings { remote_arming: true, ..with_tokens(folder) };
    let mut ledger = lfpiv::acquisition::Ledger::new(2);
    for shot in 5..9 {
        ledger.enter(shot).unwrap();
    }
    let equip = |state: lfpiv::server::ApiState| {
        state.with_controls(std::sync::Arc::new(Bench(Recording::new())), true)
    };
    Server::with(ledger, lit_board([8, 6, 4]), &settings, equip).await
}

fn runner(cases: u32) -> TestRunner {
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha))
}

#[test]
fn no_request_to_any_endpoint_breaks_the_server() {
    let folder = tempfile::tempdir().unwrap();
    let runtime = tokio::runtime::Builder::new_multi_thread().enable_all().build().unwrap();
    let server = runtime.block_on(fuzzed_server(folder.path()));
    let document = runtime.block_on(document(&server));
    let mut answered = std::collections::BTreeMap::new();
    for (method, path) in operations(&document) {
        let request = (
            prop::collection::vec(parameter(), 3),
            query(),
            headers(),
            body(),
            token(),
            any::<bool>(),
        );
        // The double disarms slowly.
        let cases = if path.ends_with("disarm") { 3 } else { CASES };
        let tried = runner(cases).run(&request, |(values, query, headers, body, token, json)| {
            let ask = Ask::new(&method, &format!("{}{query}", filled(&path, &values))).body(&body);
            let ask = token.map_or(ask.clone(), |token| ask.token(token));
            let ask = if json { ask.with("Content-Type", "application/json") } else { ask };
            let ask = headers.iter().fold(ask, |ask, (name, value)| ask.with(name, value));
            // An event stream has no end, so its head is sufficient.
            let answer = match path.ends_with("/events") {
                true => runtime.block_on(head_of(&server, &ask)),
                false => runtime.block_on(ask.of(server.address)),
            };
            if !(path.ends_with("/events") && answer.status >= 400) {
                judge(&answer)?;
            }
            Ok(())
        });
        if let Err(error) = tried {
            panic!("{method} {path}: {error}");
        }
        let well = Ask::get("/api/v1/status").token(READ);
        let well = runtime.block_on(well.of(server.address));
        answered.insert(path, well.status);
    }
    assert!(answered.len() > 15 && answered.values().all(|status| *status == 200), "{answered:?}");
}

#[test]
fn no_bytes_break_the_server() {
    let folder = tempfile::tempdir().unwrap();
    let runtime = tokio::runtime::Builder::new_multi_thread().enable_all().build().unwrap();
    let server = runtime.block_on(fuzzed_server(folder.path()));
    let line = prop_oneof![
        "[ -~]{0,30}".prop_map(String::into_bytes),
        Just(b"GET /api/v1/status HTTP/1.1".to_vec()),
        Just(b"Host: localhost".to_vec()),
        Just(b"Transfer-Encoding: chunked".to_vec()),
        Just(b"Content-Length: 3".to_vec()),
        prop::collection::vec(any::<u8>(), 0..30),
    ];
    let lines = prop::collection::vec(line, 0..8).prop_map(|lines| lines.join(b"\r\n".as_slice()));
    let tried = runner(150).run(&lines, |mut bytes| {
        bytes.extend_from_slice(b"\r\n\r\n");
        let answer = runtime.block_on(async {
            let stream = TcpStream::connect(server.address).await.unwrap();
            let (read, mut write) = stream.into_split();
            tokio::io::AsyncWriteExt::write_all(&mut write, &bytes).await.ok();
            drop(write);
            exchange(tokio::io::join(read, tokio::io::sink()), b"").await
        });
        match answer.status {
            // Closed without a response, as is correct for bytes that are not HTTP.
            0 => Ok(()),
            _ => judge(&answer),
        }
    });
    tried.unwrap();
    assert_eq!(runtime.block_on(server.get("/healthz")).status, 200);
}
