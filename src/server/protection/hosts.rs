//! Host names and origins that the server accepts.
//!
//! A page in the operator's browser can make any name resolve to 127.0.0.1 (DNS rebinding) and then
//! send requests to this server. It cannot forge the `Host` and `Origin` headers of the browser, so
//! these are checked, also on loopback.

use std::net::IpAddr;

use axum::http::uri::Authority;

/// The accepted host names.
pub(in crate::server) struct Hosts {
    names: Vec<String>,
    scheme: &'static str,
}

/// The page that a request comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::server) enum Origin {
    /// A page of this server.
    Own,
    /// Another page, or an unknown one.
    Foreign,
}

impl Hosts {
    /// Accepts `names` in addition to loopback and the address of the connection.
    pub fn new(names: &[String], tls: bool) -> Self {
        let names = names.iter().map(|name| normalized(name)).collect();
        Self { names, scheme: if tls { "https" } else { "http" } }
    }

    /// Whether `host`, with or without a port, names this server. Ports are ignored, because
    /// tunnels change them. `local` is the local address of the connection.
    pub fn allows(&self, host: &str, local: IpAddr) -> bool {
        let Ok(authority) = host.parse::<Authority>() else { return false };
        if authority.as_str().contains('@') {
            return false;
        }
        let name = normalized(authority.host());
        match name.parse::<IpAddr>() {
            // DNS rebinding cannot change an address.
            Ok(address) if address.is_loopback() || address == local.to_canonical() => true,
            _ => name == "localhost" || self.names.contains(&name),
        }
    }

    /// Whether `origin` is a page served under `host`.
    pub fn origin(&self, origin: &str, host: &str) -> Origin {
        let own = origin.split_once("://").is_some_and(|(scheme, authority)| {
            scheme == self.scheme && authority.eq_ignore_ascii_case(host)
        });
        if own { Origin::Own } else { Origin::Foreign }
    }
}

/// Lower case, without brackets of an IPv6 address and trailing dot.
fn normalized(host: &str) -> String {
    let host = host.strip_prefix('[').and_then(|host| host.strip_suffix(']')).unwrap_or(host);
    host.strip_suffix('.').unwrap_or(host).to_ascii_lowercase()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_names_of_this_server_are_allowed() {
        let hosts = Hosts::new(&["Bench.lab.example".to_owned()], false);
        let local: IpAddr = "192.168.7.5".parse().unwrap();
        for host in [
            "localhost",
            "LOCALHOST:8640",
            "localhost.",
            "127.0.0.1:1",
            "127.8.8.8",
            "[::1]:8640",
            "192.168.7.5:8640",
            "bench.LAB.example:8640",
        ] {
            assert!(hosts.allows(host, local), "{host}");
        }
        for host in [
            "",
            "evil.example",
            "localhost.evil.example",
            "evil.example:8640",
            "192.168.7.6",
            "127.0.0.1.evil.example",
            "[::2]",
            "0.0.0.0",
            "localhost@evil.example",
            "evil@localhost",
            "local host",
            "[::1",
        ] {
            assert!(!hosts.allows(host, local), "{host}");
        }
    }

    #[test]
    fn an_ipv4_address_mapped_to_ipv6_is_recognized() {
        let hosts = Hosts::new(&[], false);
        assert!(hosts.allows("192.168.7.5", "::ffff:192.168.7.5".parse().unwrap()));
    }

    #[test]
    fn only_pages_of_this_server_are_own_origins() {
        let hosts = Hosts::new(&[], false);
        assert_eq!(hosts.origin("http://localhost:8640", "localhost:8640"), Origin::Own);
        for origin in [
            "null",
            "",
            "http://localhost",
            "http://localhost:8641",
            "https://localhost:8640",
            "http://evil.example",
            "http://localhost:8640.evil.example",
        ] {
            assert_eq!(hosts.origin(origin, "localhost:8640"), Origin::Foreign, "{origin}");
        }
        let secure = Hosts::new(&[], true);
        assert_eq!(secure.origin("https://bench:8640", "bench:8640"), Origin::Own);
        assert_eq!(secure.origin("http://bench:8640", "bench:8640"), Origin::Foreign);
    }
}
