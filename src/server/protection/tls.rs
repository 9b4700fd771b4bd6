//! TLS by rustls, from PEM files.

use std::{path::Path, sync::Arc};

use rustls::{
    ServerConfig,
    crypto::ring::default_provider,
    pki_types::{CertificateDer, PrivateKeyDer, pem::PemObject},
};
use tokio_rustls::TlsAcceptor;

use super::{ProtectionError, tokens::read_secret};
use crate::config::TlsSettings;

/// Accepts TLS 1.2 and 1.3 and HTTP/1.1, without client certificates.
pub(super) fn acceptor(settings: &TlsSettings) -> Result<TlsAcceptor, ProtectionError> {
    let certificates = certificates(&settings.certificate)?;
    let key = key(&settings.key)?;
    let mut config = ServerConfig::builder_with_provider(Arc::new(default_provider()))
        .with_safe_default_protocol_versions()?
        .with_no_client_auth()
        .with_single_cert(certificates, key)?;
    config.alpn_protocols = vec![b"http/1.1".to_vec()];
    Ok(TlsAcceptor::from(Arc::new(config)))
}

fn certificates(path: &Path) -> Result<Vec<CertificateDer<'static>>, ProtectionError> {
    let (what, key) = ("certificate", "server.tls.certificate");
    let text = read_secret(what, key, path, 0)?;
    let found: Result<Vec<_>, _> = CertificateDer::pem_slice_iter(text.as_bytes()).collect();
    let refused =
        |reason: String| ProtectionError::Pem { what, key, path: path.to_owned(), reason };
    let found = found.map_err(|error| refused(error.to_string()))?;
    match found.is_empty() {
        true => Err(refused("it contains no certificate".to_owned())),
        false => Ok(found),
    }
}

/// Reads the private key. Its group may read it, as with Debian's `ssl-cert`.
fn key(path: &Path) -> Result<PrivateKeyDer<'static>, ProtectionError> {
    let (what, key) = ("key", "server.tls.key");
    let text = read_secret(what, key, path, 0o027)?;
    PrivateKeyDer::from_pem_slice(text.as_bytes()).map_err(|error| ProtectionError::Pem {
        what,
        key,
        path: path.to_owned(),
        reason: error.to_string(),
    })
}
