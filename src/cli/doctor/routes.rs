//! Finds the network interface for an address in the kernel's routing table.

use std::{
    fs,
    net::Ipv4Addr,
    path::{Path, PathBuf},
};

const ROUTES: &str = "/proc/net/route";
const INTERFACES: &str = "/sys/class/net";

/// A network interface.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Interface {
    /// The name as shown by `ip link`.
    pub name: String,
    /// Largest packet, in bytes.
    pub mtu_bytes: Option<u32>,
    /// Speed of the line, in Mbit/s; `None` if unknown.
    pub speed_mbit_s: Option<u32>,
    /// Whether the address is on the interface's own network, without a gateway.
    pub direct: bool,
}

/// The interface for `address`; `None` if there is no route.
pub fn interface_to(address: Ipv4Addr) -> Option<Interface> {
    let (name, direct) = if address.is_loopback() {
        ("lo".to_owned(), true)
    } else {
        route_to(&fs::read_to_string(ROUTES).ok()?, address)?
    };
    let folder: PathBuf = Path::new(INTERFACES).join(&name);
    let number = |file: &str| {
        fs::read_to_string(folder.join(file)).ok().and_then(|text| text.trim().parse().ok())
    };
    Some(Interface { mtu_bytes: number("mtu"), speed_mbit_s: number("speed"), name, direct })
}

/// The interface of the most specific route in the text of /proc/net/route, and whether the route
/// is direct.
fn route_to(table: &str, address: Ipv4Addr) -> Option<(String, bool)> {
    let routes = table.lines().skip(1).filter_map(|line| {
        let words: Vec<&str> = line.split_whitespace().collect();
        // The address's bytes in order, printed as a number in this machine's byte order.
        let number = |n: usize| u32::from_str_radix(words.get(n)?, 16).ok().map(u32::from_be);
        let (destination, gateway, mask) = (number(1)?, number(2)?, number(7)?);
        let leads_there = u32::from(address) & mask == destination;
        leads_there.then(|| (mask, words[0].to_owned(), gateway == 0))
    });
    routes.max_by_key(|(mask, ..)| *mask).map(|(_, name, direct)| (name, direct))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TABLE: &str = "\
Iface\tDestination\tGateway \tFlags\tRefCnt\tUse\tMetric\tMask\t\tMTU\tWindow\tIRTT
eth0\t00000000\t0102A8C0\t0003\t0\t0\t100\t00000000\t0\t0\t0
eth0\t0002A8C0\t00000000\t0001\t0\t0\t100\t00FFFFFF\t0\t0\t0
enp3s0\t000AA8C0\t00000000\t0001\t0\t0\t101\t00FFFFFF\t0\t0\t0
";

    #[test]
    fn the_most_specific_route_leads_to_an_address() {
        let to = |address: &str| route_to(TABLE, address.parse().unwrap());
        assert_eq!(to("192.168.10.11"), Some(("enp3s0".to_owned(), true)));
        assert_eq!(to("192.168.2.7"), Some(("eth0".to_owned(), true)));
        assert_eq!(to("10.1.2.3"), Some(("eth0".to_owned(), false)));
        assert_eq!(route_to("Iface\n", "10.1.2.3".parse().unwrap()), None);
    }

    #[test]
    fn loopback_is_always_there() {
        let interface = interface_to("127.0.0.2".parse().unwrap()).unwrap();
        assert_eq!((interface.name.as_str(), interface.direct), ("lo", true));
        assert!(interface.mtu_bytes.is_some());
    }
}
