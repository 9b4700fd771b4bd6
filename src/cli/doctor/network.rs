//! Checks the network between cameras and host: receive buffers, packet sizes, line speed.

use std::{collections::BTreeMap, fs, net::Ipv4Addr};

use lfpiv_hw::{CameraName, gige::CameraSettings};

use super::{
    Finding, Need,
    need::mb,
    routes::{Interface, interface_to},
};

const RMEM_MAX: &str = "/proc/sys/net/core/rmem_max";
/// Smallest socket buffer: with less, most frames are lost while the receiver is not scheduled.
const LEAST_BUFFER_BYTES: u32 = 1 << 20;
/// Largest share of a line that frames may use.
const LINE_SHARE: f64 = 0.9;
/// Data rate from which packets of 1500 bytes cost too much processor time.
const JUMBO_BYTES_PER_S: f64 = 60e6;
const ETHERNET_MTU_BYTES: u32 = 1500;
/// `CAP_NET_ADMIN`, which overrides `net.core.rmem_max`.
const NET_ADMIN_BIT: u64 = 1 << 12;

/// Checks the receive buffers and each interface that leads to cameras.
pub fn examine(cameras: &[CameraSettings], need: Option<&Need>) -> Vec<Finding> {
    let limit = fs::read_to_string(RMEM_MAX).ok().and_then(|text| text.trim().parse().ok());
    let wanted = cameras.iter().map(|camera| camera.socket_buffer_bytes).max().unwrap_or(0);
    let mut findings = vec![receive_buffer(limit, wanted, may_exceed_limits())];
    let mut lines: BTreeMap<String, (Interface, Vec<usize>)> = BTreeMap::new();
    for (index, camera) in cameras.iter().enumerate() {
        match camera.ip.map(|ip| (ip, interface_to(ip))) {
            Some((_, Some(interface))) => {
                let name = interface.name.clone();
                lines.entry(name).or_insert((interface, Vec::new())).1.push(index);
            }
            Some((ip, None)) => findings.push(no_route(index, ip)),
            None => findings.push(found_by_serial(index)),
        }
    }
    for (interface, indices) in lines.values() {
        let packet_bytes = indices.iter().map(|index| cameras[*index].packet_size_bytes).max();
        findings.push(packets(interface, packet_bytes.unwrap_or(0), indices, need));
        findings.extend(line_speed(interface, indices, need));
    }
    findings
}

/// Whether this process may exceed `net.core.rmem_max`.
fn may_exceed_limits() -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let effective = status.lines().find_map(|line| line.strip_prefix("CapEff:"));
    let bits = effective.and_then(|hex| u64::from_str_radix(hex.trim(), 16).ok());
    bits.is_some_and(|bits| bits & NET_ADMIN_BIT != 0)
}

fn receive_buffer(limit: Option<u32>, wanted: u32, unlimited: bool) -> Finding {
    const CHECK: &str = "receive buffer";
    let todo = format!(
        "sudo sysctl -w net.core.rmem_max={wanted}, and the same line in \
         /etc/sysctl.d/90-lfpiv.conf to keep it"
    );
    let Some(limit) = limit else {
        let found = "net.core.rmem_max cannot be read here (a network namespace)";
        return Finding::advice(CHECK, found, todo);
    };
    let found = format!("{wanted} bytes requested, net.core.rmem_max is {limit}");
    let finding = if limit >= wanted {
        Finding::ok(CHECK, found)
    } else if unlimited {
        Finding::ok(CHECK, format!("{found}; this user may exceed it"))
    } else if limit < LEAST_BUFFER_BYTES.min(wanted) {
        Finding::problem(CHECK, found, todo)
    } else {
        Finding::advice(CHECK, found, todo)
    };
    finding.with("rmem_max_bytes", limit.into()).with("wanted_bytes", wanted.into())
}

fn no_route(camera: usize, ip: Ipv4Addr) -> Finding {
    Finding::problem(
        "network",
        format!("{}: no interface leads to {ip}", CameraName(camera)),
        format!("give the camera's interface an address in the network of {ip}"),
    )
}

fn found_by_serial(camera: usize) -> Finding {
    Finding::advice(
        "network",
        format!("{} is configured by its serial number", CameraName(camera)),
        "lfpiv devices shows its address; set instruments.camera.ip to have its interface checked",
    )
}

fn packets(interface: &Interface, packet: u32, cameras: &[usize], need: Option<&Need>) -> Finding {
    const CHECK: &str = "packet size";
    let Interface { name, mtu_bytes, direct, .. } = interface;
    let Some(mtu) = *mtu_bytes else {
        let found = format!("the MTU of {name} cannot be read");
        return Finding::advice(CHECK, found, format!("ip link show {name} should show {packet}"));
    };
    let found = format!("{packet} bytes over {name}, whose MTU is {mtu}");
    let heavy = need.is_some_and(|need| need.line_bytes_per_s(cameras) > JUMBO_BYTES_PER_S);
    let finding = if packet > mtu {
        let todo = format!(
            "sudo ip link set {name} mtu {packet}, if card and switch support it, or \
             packet_size_bytes = {mtu}"
        );
        Finding::problem(CHECK, found, todo)
    } else if !direct {
        let todo = "GigE Vision needs the camera on the interface's own network: correct the \
                    addresses";
        Finding::advice(CHECK, format!("{found}, behind a gateway"), todo)
    } else if heavy && packet <= ETHERNET_MTU_BYTES {
        let todo = format!(
            "jumbo frames need a sixth of the processor time: sudo ip link set {name} mtu 9000 \
             and packet_size_bytes = 9000"
        );
        Finding::advice(CHECK, found, todo)
    } else {
        Finding::ok(CHECK, found)
    };
    finding.with("mtu_bytes", mtu.into()).with("packet_size_bytes", packet.into())
}

/// Checks whether the line can carry the frames; `None` if its speed is unknown.
fn line_speed(interface: &Interface, cameras: &[usize], need: Option<&Need>) -> Option<Finding> {
    const CHECK: &str = "line speed";
    let (speed, need) = (interface.speed_mbit_s?, need?);
    let produced = need.line_bytes_per_s(cameras);
    let capacity = f64::from(speed) * 1e6 / 8.0;
    let found =
        format!("{} carries {} of {} per second", interface.name, mb(produced), mb(capacity));
    let finding = if produced > LINE_SHARE * capacity {
        let todo = "lower shot.rate_hz, choose a smaller pixel format, or connect each camera to \
                    its own line";
        Finding::problem(CHECK, found, todo)
    } else {
        Finding::ok(CHECK, found)
    };
    Some(finding.with("speed_mbit_per_s", speed.into()).with("brought_mb_per_s", produced / 1e6))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::doctor::Verdict;

    const MB8: u32 = 8 << 20;

    fn need(rate_hz: f64) -> Need {
        Need { frame_bytes: vec![6_000_000; 2], rate_hz, pixels: 4_000_000, shots_in_memory: 4 }
    }

    fn interface(mtu: u32) -> Interface {
        let (mtu_bytes, speed_mbit_s) = (Some(mtu), Some(1000));
        Interface { name: "enp3s0".into(), mtu_bytes, speed_mbit_s, direct: true }
    }

    #[test]
    fn the_receive_buffer_must_be_granted() {
        assert_eq!(receive_buffer(Some(MB8), MB8, false).verdict, Verdict::Ok);
        assert_eq!(receive_buffer(Some(4 << 20), MB8, false).verdict, Verdict::Advice);
        let default = receive_buffer(Some(212_992), MB8, false);
        assert_eq!(default.verdict, Verdict::Problem);
        assert!(default.advice.unwrap().contains("net.core.rmem_max=8388608"));
        assert_eq!(receive_buffer(Some(212_992), MB8, true).verdict, Verdict::Ok);
        assert_eq!(receive_buffer(None, MB8, false).verdict, Verdict::Advice);
    }

    #[test]
    fn packets_must_fit_the_interface() {
        assert_eq!(packets(&interface(9000), 9000, &[0, 1], None).verdict, Verdict::Ok);
        assert_eq!(packets(&interface(1500), 9000, &[0], None).verdict, Verdict::Problem);
        let heavy = packets(&interface(1500), 1500, &[0, 1], Some(&need(5.0)));
        assert_eq!(heavy.verdict, Verdict::Advice, "{heavy:?}");
        let light = packets(&interface(1500), 1500, &[0], Some(&need(2.0)));
        assert_eq!(light.verdict, Verdict::Ok);
        let far = Interface { direct: false, ..interface(9000) };
        assert_eq!(packets(&far, 9000, &[0], None).verdict, Verdict::Advice);
    }

    #[test]
    fn frames_must_fit_through_the_line() {
        let verdict = |cameras: &[usize], rate_hz| {
            line_speed(&interface(9000), cameras, Some(&need(rate_hz))).unwrap().verdict
        };
        assert_eq!(verdict(&[0, 1], 4.0), Verdict::Ok);
        assert_eq!(verdict(&[0, 1], 5.0), Verdict::Problem);
        assert_eq!(verdict(&[0], 5.0), Verdict::Ok);
        let unknown = Interface { speed_mbit_s: None, ..interface(9000) };
        assert_eq!(line_speed(&unknown, &[0], Some(&need(5.0))), None);
    }
}
