//! Rate limit for requests: a token bucket per client address.

use std::{
    collections::HashMap,
    net::{IpAddr, Ipv6Addr},
    time::{Duration, Instant},
};

use parking_lot::Mutex;

/// Largest number of stored clients. Clients with full buckets are removed first.
const MAX_CLIENTS: usize = 4096;

/// Request rates of all clients.
pub(in crate::server) struct RateLimits {
    per_s: f64,
    burst: f64,
    clients: Mutex<HashMap<IpAddr, Bucket>>,
}

struct Bucket {
    tokens: f64,
    filled: Instant,
}

impl RateLimits {
    /// Allows `per_s` requests per second on average and bursts of `burst` requests.
    pub fn new(per_s: f64, burst: f64) -> Self {
        Self { per_s, burst: burst.max(1.0), clients: Mutex::default() }
    }

    /// Counts a request of `client` at time `now`.
    ///
    /// # Errors
    /// The request is refused; the value is the time to wait.
    pub fn take(&self, client: IpAddr, now: Instant) -> Result<(), Duration> {
        let client = network(client);
        let mut clients = self.clients.lock();
        if clients.len() >= MAX_CLIENTS && !clients.contains_key(&client) {
            clients.retain(|_, bucket| self.filled(bucket, now) < self.burst);
            if clients.len() >= MAX_CLIENTS {
                return Err(Duration::from_secs_f64(1.0 / self.per_s));
            }
        }
        let bucket = clients.entry(client).or_insert(Bucket { tokens: self.burst, filled: now });
        bucket.tokens = self.filled(bucket, now);
        bucket.filled = now;
        if bucket.tokens >= 1.0 {
            bucket.tokens -= 1.0;
            return Ok(());
        }
        Err(Duration::from_secs_f64((1.0 - bucket.tokens) / self.per_s))
    }

    fn filled(&self, bucket: &Bucket, now: Instant) -> f64 {
        let since = now.saturating_duration_since(bucket.filled).as_secs_f64();
        (bucket.tokens + since * self.per_s).min(self.burst)
    }
}

/// The address, or the /64 network of an IPv6 address: a host can use all addresses of its network.
pub(in crate::server) fn network(client: IpAddr) -> IpAddr {
    match client.to_canonical() {
        IpAddr::V6(address) => {
            let [a, b, c, d, ..] = address.segments();
            IpAddr::V6(Ipv6Addr::new(a, b, c, d, 0, 0, 0, 0))
        }
        address => address,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn address(n: u32) -> IpAddr {
        IpAddr::V4(n.into())
    }

    #[test]
    fn a_burst_is_followed_by_the_average() {
        let limits = RateLimits::new(10.0, 5.0);
        let start = Instant::now();
        let taken = |at_ms: u64, client| {
            let now = start + Duration::from_millis(at_ms);
            (0..100).filter(|_| limits.take(address(client), now).is_ok()).count()
        };
        assert_eq!(taken(0, 1), 5);
        assert_eq!(taken(0, 2), 5, "clients do not share");
        assert_eq!(taken(1000, 1), 5);
        assert_eq!(taken(1250, 1), 2);
        let wait = limits.take(address(1), start + Duration::from_millis(1250)).unwrap_err();
        assert!((wait.as_secs_f64() - 0.05).abs() < 1e-6, "{wait:?}");
    }

    #[test]
    fn memory_is_bounded_and_idle_clients_are_removed() {
        let limits = RateLimits::new(1.0, 2.0);
        let start = Instant::now();
        for client in 0..MAX_CLIENTS as u32 {
            limits.take(address(client), start).unwrap();
        }
        assert!(limits.take(address(u32::MAX), start).is_err());
        assert!(limits.take(address(0), start).is_ok(), "the known are served");
        let later = start + Duration::from_secs(3);
        limits.take(address(u32::MAX), later).unwrap();
        assert_eq!(limits.clients.lock().len(), 1);
    }

    #[test]
    fn a_host_cannot_hide_behind_its_ipv6_addresses() {
        let limits = RateLimits::new(1.0, 1.0);
        let now = Instant::now();
        limits.take("2001:db8::1".parse().unwrap(), now).unwrap();
        assert!(limits.take("2001:db8::2".parse().unwrap(), now).is_err());
        assert!(limits.take("2001:db8:0:1::2".parse().unwrap(), now).is_ok());
    }
}
