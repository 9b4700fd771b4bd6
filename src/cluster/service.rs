//! Serves workers: the coordinator's HTTP interface, and the jobs in the broker.

use std::{collections::BTreeMap, fmt::Write as _, net::SocketAddr, sync::Arc, time::Duration};

use ring::rand::{SecureRandom, SystemRandom};
use tokio::{net::TcpListener, task::JoinHandle};
use tokio_util::sync::CancellationToken;

use super::{ClusterError, Coordinator, JobQueue, Tokens, coordinator_routes, offers::Offers};

/// How long jobs and connections are waited for at the end.
const SHUTDOWN_TIMEOUT: Duration = Duration::from_secs(2);
/// Characters of the hash that identify a run to the broker.
const RUN_CHARACTERS: usize = 16;

/// Where workers read frames and deliver results.
pub struct WorkersAddress {
    listener: TcpListener,
    address: SocketAddr,
}

impl WorkersAddress {
    /// Listens; connections wait until a [`WorkService`] starts.
    ///
    /// # Errors
    /// Another program has the address, or it is none of this machine's.
    pub async fn bind(address: SocketAddr) -> Result<Self, ClusterError> {
        let failed = |reason| ClusterError::Listen { address, reason };
        let listener = TcpListener::bind(address).await.map_err(failed)?;
        let address = listener.local_addr().map_err(failed)?;
        Ok(Self { listener, address })
    }

    /// The address, with the port that was chosen.
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// What the address means for those who may use it.
    pub fn warn(&self, broker: &JobQueue) {
        let address = self.address;
        let own = ["127.0.0.1", "localhost", "[::1]"];
        let is_broker_here =
            own.iter().any(|host| broker.address().contains(&format!("//{host}:")));
        match address.ip().is_loopback() {
            true if !is_broker_here => tracing::warn!(
                "only workers on this machine reach {address}: give an address that others reach (--serve, or \
                 cluster.serve)"
            ),
            false => tracing::warn!("frames and results at {address} are not encrypted"),
            true => {}
        }
        tracing::info!("workers read frames and deliver results at http://{address}");
    }
}

/// How a run is served.
pub struct ServiceSettings {
    /// Name of the run's folder.
    pub run_name: String,
    /// A worker without a heartbeat for so long is lost.
    pub heartbeat_timeout: Duration,
    /// Longest time for a shot.
    pub deadline: Duration,
    /// The first number of an offer.
    pub first_issue: u32,
}

/// See the module. Its tasks live until [`Self::end`].
pub struct WorkService {
    queue: JobQueue,
    run: String,
    heartbeat_timeout: Duration,
    closing: CancellationToken,
    server: JoinHandle<std::io::Result<()>>,
    offering: JoinHandle<()>,
}

impl WorkService {
    /// Starts to serve workers and to offer jobs. The broker may come later.
    ///
    /// # Errors
    /// There are no random numbers.
    pub fn start(
        coordinator: &Arc<Coordinator>,
        at: WorkersAddress,
        queue: JobQueue,
        settings: ServiceSettings,
    ) -> Result<Self, ClusterError> {
        let tokens = Tokens { read: random_token()?, work: random_token()? };
        let assignment = coordinator.assignment();
        let run: String = assignment.conditions.shots_sha256.chars().take(RUN_CHARACTERS).collect();
        let offers = Offers {
            coordinator: coordinator.clone(),
            run: run.clone(),
            run_name: settings.run_name,
            conditions: assignment.conditions.clone(),
            model_sha256: assignment.reference.model_sha256.clone(),
            address: format!("http://{}", at.address),
            tokens: tokens.clone(),
            heartbeat_timeout: settings.heartbeat_timeout,
            deadline: settings.deadline,
            issues: BTreeMap::new(),
            first_issue: settings.first_issue,
        };
        let closing = CancellationToken::new();
        let server = axum::serve(at.listener, coordinator_routes(coordinator.clone(), &tokens))
            .with_graceful_shutdown(closing.clone().cancelled_owned());
        Ok(Self {
            run,
            heartbeat_timeout: settings.heartbeat_timeout,
            closing,
            server: tokio::spawn(async { server.await }),
            offering: tokio::spawn(offers.keep_up(queue.clone())),
            queue,
        })
    }

    /// Withdraws the jobs, and lets requests in progress end, within some seconds.
    pub async fn end(self) {
        self.offering.abort();
        let _ = self.offering.await;
        // Workers do not look at jobs that nobody waits for. Without a broker there are none.
        let withdrawn = self.queue.withdraw(&self.run, self.heartbeat_timeout);
        let _ = tokio::time::timeout(SHUTDOWN_TIMEOUT, withdrawn).await;
        self.closing.cancel();
        let mut server = self.server;
        match tokio::time::timeout(SHUTDOWN_TIMEOUT, &mut server).await {
            Ok(Ok(Ok(()))) => {}
            Ok(Ok(Err(error))) => tracing::warn!("workers could not be served: {error}"),
            Ok(Err(panic)) => tracing::error!("the server of workers has panicked: {panic}"),
            // Somebody keeps a connection open.
            Err(_) => server.abort(),
        }
    }
}

/// 128 random bits.
fn random_token() -> Result<String, ClusterError> {
    let mut bytes = [0u8; 16];
    SystemRandom::new().fill(&mut bytes).map_err(|_| ClusterError::NoRandom)?;
    let mut token = String::new();
    for byte in bytes {
        let _ = write!(token, "{byte:02x}");
    }
    Ok(token)
}
