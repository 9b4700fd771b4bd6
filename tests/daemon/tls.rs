//! TLS with a certificate made by the test.

use std::{os::unix::fs::PermissionsExt, path::Path, sync::Arc};

use lfpiv::{
    config::{ServerSettings, TlsSettings},
    server::Protection,
};
use rcgen::{CertifiedKey, generate_simple_self_signed};
use rustls::{ClientConfig, RootCertStore, crypto::ring::default_provider, pki_types::ServerName};
use tokio::net::TcpStream;
use tokio_rustls::{TlsConnector, client::TlsStream};

use crate::{
    client::Ask,
    server::{READ, Server, with_tokens},
};

fn secured(folder: &Path) -> (ServerSettings, RootCertStore) {
    let CertifiedKey { cert, signing_key } =
        generate_simple_self_signed(vec!["localhost".to_owned()]).unwrap();
    let tls =
        TlsSettings { certificate: folder.join("certificate.pem"), key: folder.join("key.pem") };
    std::fs::write(&tls.certificate, cert.pem()).unwrap();
    std::fs::write(&tls.key, signing_key.serialize_pem()).unwrap();
    std::fs::set_permissions(&tls.key, PermissionsExt::from_mode(0o600)).unwrap();
    let mut roots = RootCertStore::empty();
    roots.add(cert.der().clone()).unwrap();
    (ServerSettings { tls: Some(tls), ..with_tokens(folder) }, roots)
}

async fn connect(server: &Server, roots: RootCertStore) -> std::io::Result<TlsStream<TcpStream>> {
    let config = ClientConfig::builder_with_provider(Arc::new(default_provider()))
        .with_safe_default_protocol_versions()
        .unwrap()
        .with_root_certificates(roots)
        .with_no_client_auth();
    let name = ServerName::try_from("localhost").unwrap();
    let stream = TcpStream::connect(server.address).await.unwrap();
    TlsConnector::from(Arc::new(config)).connect(name, stream).await
}

#[tokio::test]
async fn with_a_certificate_the_server_accepts_only_tls() {
    let folder = tempfile::tempdir().unwrap();
    let (settings, roots) = secured(folder.path());
    assert!(settings.url(settings.address).starts_with("https://127.0.0.1"));
    let server = Server::empty(&settings).await;
    let ask = Ask::get("/api/v1/status").token(READ);
    let stream = connect(&server, roots.clone()).await.unwrap();
    let answer = ask.over(stream, server.address).await;
    assert_eq!((answer.status, &answer.json()["state"]), (200, &"running".into()));
    let own = ask.clone().with("Origin", &format!("https://{}", server.address));
    let stream = connect(&server, roots).await.unwrap();
    assert_eq!(own.over(stream, server.address).await.status, 200);

    let in_the_clear = ask.of(server.address).await;
    assert_eq!(in_the_clear.status, 0, "{in_the_clear:?}");
    let stranger = connect(&server, RootCertStore::empty()).await;
    assert!(stranger.err().unwrap().to_string().contains("certificate"));
}

#[tokio::test]
async fn a_client_without_a_handshake_is_disconnected() {
    let folder = tempfile::tempdir().unwrap();
    let (settings, _) = secured(folder.path());
    let server = Server::empty(&ServerSettings { client_patience_s: 0.3, ..settings }).await;
    let stream = TcpStream::connect(server.address).await.unwrap();
    let closed = crate::client::exchange(stream, b"\x16\x03\x01").await;
    assert_eq!(closed.status, 0);
}

#[tokio::test]
async fn unusable_certificates_and_keys_are_refused_with_what_to_do() {
    let folder = tempfile::tempdir().unwrap();
    let (settings, _) = secured(folder.path());
    let tls = settings.tls.clone().unwrap();
    let refusal = |tls: TlsSettings| {
        let settings = ServerSettings { tls: Some(tls), ..settings.clone() };
        Protection::open(&settings).err().unwrap().to_string()
    };
    let open = |mode| std::fs::set_permissions(&tls.key, PermissionsExt::from_mode(mode)).unwrap();
    open(0o644);
    assert!(refusal(tls.clone()).contains("chmod 600"));
    open(0o600);
    let absent = refusal(TlsSettings { key: folder.path().join("absent"), ..tls.clone() });
    assert!(absent.contains("server.tls.key"), "{absent}");
    let swapped = TlsSettings { certificate: tls.key.clone(), key: tls.key.clone() };
    assert!(refusal(swapped).contains("contains no certificate"));
    let other = tempfile::tempdir().unwrap();
    let (others, _) = secured(other.path());
    let foreign = refusal(TlsSettings { key: others.tls.unwrap().key, ..tls });
    assert!(foreign.contains("cannot be used"), "{foreign}");
}
