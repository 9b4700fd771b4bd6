//! The OpenAPI document compared with the server, and the page that shows it.

use serde_json::Value;

use crate::{
    client::{Answer, Ask},
    http::busy_server,
    schema::differences,
    server::Server,
};

pub async fn document(server: &Server) -> Value {
    server.get("/api/v1/openapi.json").await.json()
}

/// Every (method, path) of the document.
pub fn operations(document: &Value) -> Vec<(String, String)> {
    let paths = document["paths"].as_object().unwrap();
    let of_path = |(path, item): (&String, &Value)| {
        let methods = item.as_object().unwrap().keys();
        methods.map(|method| (method.to_uppercase(), path.clone())).collect::<Vec<_>>()
    };
    paths.iter().flat_map(of_path).collect()
}

/// The path with valid parameters.
fn filled(path: &str) -> String {
    [("{shot}", "1"), ("{camera}", "1"), ("{frame}", "a"), ("{image}", "xy.png")]
        .iter()
        .fold(path.replace("frames/{camera}/{image}", "frames/1/a.png"), |path, (name, value)| {
            path.replace(name, value)
        })
}

/// The head of a response, and the part of its body that arrived with it.
pub async fn head_of(server: &Server, ask: &Ask) -> Answer {
    use tokio::io::{AsyncReadExt, AsyncWriteExt};
    let mut stream = tokio::net::TcpStream::connect(server.address).await.unwrap();
    stream.write_all(&ask.bytes(server.address)).await.unwrap();
    let mut received = Vec::new();
    while !received.windows(4).any(|four| four == b"\r\n\r\n") {
        let read = stream.read_buf(&mut received);
        let read = tokio::time::timeout(std::time::Duration::from_secs(10), read).await;
        if read.expect("the server hangs").unwrap_or(0) == 0 {
            break;
        }
    }
    Answer::read(&received)
}

#[tokio::test]
async fn every_documented_endpoint_exists_and_accepts_no_other_method() {
    let (server, _) = busy_server().await;
    let document = document(&server).await;
    let operations = operations(&document);
    assert_eq!(operations.len(), 31, "{operations:?}");
    for (method, path) in &operations {
        let address = filled(path);
        assert!(!address.contains('{'), "{address}");
        let answer = head_of(&server, &Ask::new(method, &address)).await;
        let body = String::from_utf8_lossy(&answer.body).into_owned();
        assert!(!body.contains("no such endpoint") && answer.status != 405, "{path}: {answer:?}");
        let documented = &document["paths"][path][method.to_lowercase()]["responses"];
        assert!(
            !documented[answer.status.to_string()].is_null(),
            "{method} {path} answers {}, which is not documented",
            answer.status
        );
        for other in ["GET", "POST", "PUT", "DELETE", "PATCH", "OPTIONS"] {
            if !operations.contains(&(other.to_owned(), path.clone())) {
                let refused = Ask::new(other, &address).of(server.address).await;
                assert!(
                    refused.error(405).contains("this method is not allowed"),
                    "{other} {path}"
                );
            }
        }
    }
}

#[tokio::test]
async fn responses_match_their_schemas() {
    let (server, done) = busy_server().await;
    let document = document(&server).await;
    for (address, path) in [
        ("/api/v1/status".to_owned(), "/api/v1/status"),
        ("/api/v1/shots".to_owned(), "/api/v1/shots"),
        (format!("/api/v1/shots/{}", done - 1), "/api/v1/shots/{shot}"),
        (format!("/api/v1/shots/{done}"), "/api/v1/shots/{shot}"),
        ("/api/v1/results/latest".to_owned(), "/api/v1/results/{shot}"),
        ("/api/v1/results/0".to_owned(), "/api/v1/results/{shot}"),
        ("/api/v1/results/x".to_owned(), "/api/v1/results/{shot}"),
        ("/api/v1/results/latest/particles".to_owned(), "/api/v1/results/{shot}/particles"),
        ("/api/v1/results/0/particles".to_owned(), "/api/v1/results/{shot}/particles"),
        ("/api/v1/statistics".to_owned(), "/api/v1/statistics"),
        ("/api/v1/statistics?quantities=all".to_owned(), "/api/v1/statistics"),
        ("/api/v1/control".to_owned(), "/api/v1/control"),
    ] {
        let answer = server.get(&address).await;
        let status = answer.status.to_string();
        let documented = &document["paths"][path]["get"]["responses"][status];
        let documented = match documented["$ref"].as_str() {
            Some(place) => document.pointer(&place[1..]).unwrap(),
            None => documented,
        };
        let schema = &documented["content"]["application/json"]["schema"];
        assert!(schema.is_object(), "{address}: {documented}");
        let wrong = differences(&document, schema, &answer.json(), "");
        // An error may have more members than its message.
        let wrong: Vec<_> = wrong
            .iter()
            .filter(|w| answer.status == 200 || !w.contains("not documented"))
            .collect();
        assert!(wrong.is_empty(), "{address}: {wrong:#?}");
    }
}

#[tokio::test]
async fn required_tokens_are_documented() {
    let (server, _) = busy_server().await;
    let document = document(&server).await;
    assert_eq!(document["components"]["securitySchemes"]["bearer"]["scheme"], "bearer");
    assert_eq!(document["security"][0]["bearer"], serde_json::json!([]));
    let open = [
        "/healthz",
        "/",
        "/bench/bench.js",
        "/bench/bench.css",
        "/bench/icon.svg",
        "/docs",
        "/docs/viewer.js",
        "/docs/viewer.css",
        "/api/v1/openapi.json",
    ];
    for (method, path) in operations(&document) {
        let operation = &document["paths"][&path][method.to_lowercase()];
        let needs_none = operation["security"] == serde_json::json!([{}]);
        assert_eq!(needs_none, open.contains(&path.as_str()), "{path}");
        assert!(!operation["summary"].as_str().unwrap().is_empty(), "{path}");
    }
}

#[tokio::test]
async fn the_page_loads_from_this_server_only() {
    let (server, _) = busy_server().await;
    for (path, media_type) in [
        ("/docs", "text/html; charset=utf-8"),
        ("/docs/viewer.js", "text/javascript; charset=utf-8"),
        ("/docs/viewer.css", "text/css; charset=utf-8"),
    ] {
        let answer = server.get(path).await;
        assert_eq!((answer.status, answer.media_type.as_str()), (200, media_type));
        let text = String::from_utf8(answer.body).unwrap();
        assert!(text.len() > 200);
        assert!(!text.contains("http:") && !text.contains("https:"), "{path} looks elsewhere");
        assert!(!text.contains("innerHTML"), "text from the server is never markup");
    }
}

#[tokio::test]
async fn the_handbook_names_every_endpoint() {
    let (server, _) = busy_server().await;
    let handbook = include_str!("../../docs/http.md");
    for (method, path) in operations(&document(&server).await) {
        if !path.starts_with("/docs/") && !path.starts_with("/bench/") {
            let line = format!("`{method} {path}");
            assert!(handbook.contains(&line), "docs/http.md says nothing of {line}`");
        }
    }
}
