//! Jobs in a work queue of NATS JetStream.
//!
//! One stream holds the jobs of all runs, each under a subject of its own, `lfpiv.jobs.RUN.SHOT`, so that offering a
//! shot twice leaves one job. A job stays until it is acknowledged; what is not acknowledged or kept alive within
//! the heartbeat timeout goes to another worker, without limit: the [`super::Tally`] gives shots up. Nothing in the broker
//! is relied on: [`JobQueue::missing`] makes stream and consumer again when they are gone, and what is absent is
//! offered again.

use std::{collections::HashSet, error::Error as _, io, path::PathBuf, sync::Arc, time::Duration};

use async_nats::{
    Client, ConnectError, ConnectErrorKind, ConnectOptions, Event, ServerAddr,
    connection::State,
    jetstream::{
        self, AckKind, Context,
        consumer::{AckPolicy, PullConsumer, pull},
        stream,
    },
};
use futures_util::{StreamExt, TryStreamExt};
use percent_encoding::percent_decode_str;
use tokio::sync::Notify;

use super::{Attempt, ClusterError, Job};

/// The stream of jobs.
const STREAM: &str = "LFPIV_JOBS";
/// Its subjects are below this one.
const SUBJECT: &str = "lfpiv.jobs";
/// The consumer that all workers share.
const CONSUMER: &str = "workers";
/// Jobs that workers may have at once.
const MOST_TAKEN: i64 = 10_000;
/// How long a worker's request for a job waits in the broker.
const REQUEST: Duration = Duration::from_secs(1);
/// Pause before a job that this version does not understand is handed out again.
const REDELIVERY_PAUSE: Duration = Duration::from_millis(500);
/// Age at which a job is dropped. Coordinators offer again what is missing; those that were killed do not.
const LONGEST_AGE: Duration = Duration::from_secs(24 * 3600);

/// Where the broker is, and the credentials it asks for.
#[derive(Debug, Clone, Default)]
pub struct Broker {
    /// `nats://host:port`, or `tls://`; also with `user:password@`.
    pub url: String,
    /// A file of credentials as NATS has them (`.creds`).
    pub credentials: Option<PathBuf>,
    /// Certificate of the authority that the broker's certificate is from, if the system does not know it.
    pub authority: Option<PathBuf>,
}

/// A connection to the broker, made again whenever it breaks.
#[derive(Debug, Clone)]
pub struct JobQueue {
    jetstream: Context,
    client: Client,
    connected: Arc<Notify>,
    shown: String,
}

/// A job, until it is done with.
pub struct TakenJob {
    pub job: Job,
    pub attempt: Attempt,
    message: jetstream::Message,
}

impl JobQueue {
    /// Connects as `name`. Without an answer it goes on trying in the background, and returns; `meanwhile` tells the
    /// user what happens until then.
    ///
    /// # Errors
    /// The address or a file cannot be used, or the broker does not let us in.
    pub async fn connect(
        broker: &Broker,
        name: &str,
        meanwhile: &'static str,
    ) -> Result<Self, ClusterError> {
        let address: ServerAddr = broker.url.parse().map_err(|reason: io::Error| {
            // Not the address itself, which may have a password.
            ClusterError::Connect { url: "this address".into(), reason: reason.to_string() }
        })?;
        let shown = format!("{}://{}:{}", address.scheme(), address.host(), address.port());
        let failed = |reason: String| ClusterError::Connect { url: shown.clone(), reason };
        let connected = Arc::new(Notify::new());
        let mut options = options(name, &shown, &connected, meanwhile);
        if let (Some(user), Some(password)) = (address.username(), address.password()) {
            let plain = |text: &str| percent_decode_str(text).decode_utf8_lossy().into_owned();
            options = options.user_and_password(plain(user), plain(password));
        }
        if let Some(file) = &broker.credentials {
            options =
                options.credentials_file(file).await.map_err(|error| failed(error.to_string()))?;
        }
        if let Some(file) = &broker.authority {
            options = options.add_root_certificates(file.clone());
        }
        let client = match options.clone().connect(&address).await {
            Err(error) if may_come(&error) => {
                tracing::warn!("no broker at {shown} ({error}): it is tried again; {meanwhile}");
                options.retry_on_initial_connect().connect(&address).await
            }
            tried => tried,
        };
        let client = client.map_err(|error| failed(error.to_string()))?;
        Ok(Self { jetstream: jetstream::new(client.clone()), client, connected, shown })
    }

    /// Whether there is a connection now.
    pub fn is_connected(&self) -> bool {
        self.client.connection_state() == State::Connected
    }

    /// The broker's address, without a password.
    pub fn address(&self) -> &str {
        &self.shown
    }

    /// Completes when a connection has been made since the last call.
    pub async fn reconnected(&self) {
        self.connected.notified().await;
    }

    /// Makes stream and consumer where they are missing. A job that is not kept alive for `heartbeat_timeout` goes to
    /// another worker.
    async fn open(&self, heartbeat_timeout: Duration) -> Result<stream::Stream, ClusterError> {
        let stream = self
            .jetstream
            .get_or_create_stream(stream::Config {
                name: STREAM.into(),
                subjects: vec![format!("{SUBJECT}.>")],
                retention: stream::RetentionPolicy::WorkQueue,
                discard: stream::DiscardPolicy::New,
                discard_new_per_subject: true,
                max_messages_per_subject: 1,
                max_age: LONGEST_AGE,
                ..stream::Config::default()
            })
            .await
            .map_err(ClusterError::broker("make a stream"))?;
        let consumer = pull::Config {
            durable_name: Some(CONSUMER.into()),
            ack_policy: AckPolicy::Explicit,
            ack_wait: heartbeat_timeout,
            max_deliver: -1,
            max_ack_pending: MOST_TAKEN,
            ..pull::Config::default()
        };
        let made: Result<PullConsumer, _> = stream.create_consumer(consumer).await;
        made.map_err(ClusterError::broker("make a consumer"))?;
        Ok(stream)
    }

    /// Those of `shots` of which the broker has no job. Stream and consumer are there afterwards.
    ///
    /// # Errors
    /// The broker does not answer.
    pub async fn missing(
        &self,
        run: &str,
        shots: &[u64],
        heartbeat_timeout: Duration,
    ) -> Result<HashSet<u64>, ClusterError> {
        let stream = self.open(heartbeat_timeout).await?;
        let there = stream
            .info_with_subjects(format!("{SUBJECT}.{run}.>"))
            .await
            .map_err(ClusterError::broker("list its jobs"))?;
        let there: HashSet<String> = there
            .map_ok(|(subject, _)| subject)
            .try_collect()
            .await
            .map_err(ClusterError::broker("list its jobs"))?;
        let is_missing = |shot: &u64| !there.contains(&subject(run, *shot));
        Ok(shots.iter().copied().filter(is_missing).collect())
    }

    /// Adds a job of which the broker has none.
    ///
    /// # Errors
    /// The broker does not answer, or has one.
    pub async fn publish(&self, job: &Job) -> Result<(), ClusterError> {
        let text = serde_json::to_vec(job).unwrap_or_default();
        let published = self
            .jetstream
            .publish(subject(&job.run, job.shot.number), text.into())
            .await
            .map_err(ClusterError::broker("take a job"))?;
        published.await.map_err(ClusterError::broker("keep a job"))?;
        Ok(())
    }

    /// Removes all jobs of a run.
    ///
    /// # Errors
    /// The broker does not answer.
    pub async fn withdraw(
        &self,
        run: &str,
        heartbeat_timeout: Duration,
    ) -> Result<(), ClusterError> {
        let stream = self.open(heartbeat_timeout).await?;
        let purged = stream.purge().filter(format!("{SUBJECT}.{run}.>")).await;
        purged.map(|_| ()).map_err(ClusterError::broker("remove jobs"))
    }

    /// Waits for a job a second at most.
    ///
    /// # Errors
    /// There is no broker, or no coordinator has made its stream yet.
    pub async fn take(&self) -> Result<Option<TakenJob>, ClusterError> {
        let consumer: PullConsumer = self
            .jetstream
            .get_consumer_from_stream(CONSUMER, STREAM)
            .await
            .map_err(ClusterError::broker("know of any jobs"))?;
        let mut batch = consumer
            .batch()
            .max_messages(1)
            .expires(REQUEST)
            .messages()
            .await
            .map_err(ClusterError::broker("hand a job out"))?;
        let Some(message) = batch.next().await else { return Ok(None) };
        let message = message.map_err(ClusterError::broker("hand a job out"))?;
        let delivered = message.info().map(|info| info.delivered).unwrap_or(1);
        match serde_json::from_slice::<Job>(&message.payload) {
            Ok(job) => {
                let delivery = u32::try_from(delivered).unwrap_or(u32::MAX);
                let attempt = Attempt { issue: job.issue, delivery };
                Ok(Some(TakenJob { job, attempt, message }))
            }
            Err(error) => {
                tracing::warn!("a job of another version of lfpiv is left to others: {error}");
                // Others are asked first.
                let _ = message.ack_with(AckKind::Nak(Some(REDELIVERY_PAUSE))).await;
                Ok(None)
            }
        }
    }
}

impl TakenJob {
    /// Tells the broker that the shot is being measured.
    ///
    /// # Errors
    /// There is no broker.
    pub async fn keep_alive(&self) -> Result<(), ClusterError> {
        let told = self.message.ack_with(AckKind::Progress).await;
        told.map_err(ClusterError::broker("take heartbeats"))
    }

    /// Removes the job: the shot is settled, or the job is stale.
    ///
    /// # Errors
    /// There is no broker: the job will come again, and be found settled.
    pub async fn done(&self) -> Result<(), ClusterError> {
        let told = self.message.double_ack().await;
        told.map_err(ClusterError::broker("take an acknowledgement"))
    }

    /// Gives the job back, for another worker or a later try, not before `pause`.
    ///
    /// # Errors
    /// There is no broker: it hands the job out again by itself.
    pub async fn give_back(&self, pause: Duration) -> Result<(), ClusterError> {
        let told = self.message.ack_with(AckKind::Nak(Some(pause))).await;
        told.map_err(ClusterError::broker("take a job back"))
    }
}

fn options(
    name: &str,
    shown: &str,
    connected: &Arc<Notify>,
    meanwhile: &'static str,
) -> ConnectOptions {
    let (told, shown) = (connected.clone(), shown.to_owned());
    ConnectOptions::new()
        .name(name)
        .max_reconnects(None)
        .reconnect_delay_callback(|attempts| Duration::from_millis(100 << attempts.min(4)))
        .event_callback(move |event| {
            match event {
                Event::Connected => {
                    tracing::info!("connected to the broker at {shown}");
                    told.notify_one();
                }
                Event::Disconnected => {
                    tracing::warn!(
                        "no connection to the broker at {shown}: it is tried again; {meanwhile}"
                    );
                }
                other => tracing::debug!("broker: {other}"),
            }
            std::future::ready(())
        })
}

/// Whether a broker that could not be reached may be there later.
fn may_come(error: &ConnectError) -> bool {
    use ConnectErrorKind::{Dns, Io, MaxReconnects, TimedOut};
    // That is what TLS calls a certificate that it does not accept.
    let cause = error.source().and_then(|cause| cause.downcast_ref::<io::Error>());
    let is_foreign = cause.is_some_and(|cause| cause.kind() == io::ErrorKind::InvalidData);
    !is_foreign && matches!(error.kind(), Dns | Io | MaxReconnects | TimedOut)
}

fn subject(run: &str, shot: u64) -> String {
    format!("{SUBJECT}.{run}.{shot}")
}
