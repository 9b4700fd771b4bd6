//! The shots of a run, measured on several machines by way of a broker.
//!
//! ```text
//! coordinator ── jobs (some 500 bytes) ──> NATS JetStream ── jobs ──> workers
//!      ^  └──────── packed records over HTTP, or a shared folder ───────┘ │
//!      └────────────────────── results over HTTP ─────────────────────────┘
//! ```
//!
//! - [`Job`]: a shot to measure, with everything it depends on by hash ([`Conditions`], [`Reference`]).
//! - [`JobQueue`]: jobs in a work queue of JetStream. It may lose everything at any time: the record on disk is
//!   the truth, and what has no result is offered again.
//! - [`Tally`]: who was first, and how often a shot was tried. A function of what was reported, in any order.
//! - [`DeliveryLog`]: the same on disk, with the results, so that a coordinator that was killed goes on.
//! - [`Coordinator`]: takes results in, hands records out; [`coordinator_routes`] is its HTTP side,
//!   [`CoordinatorClient`] the worker's end.
//! - [`WorkService`]: serves the HTTP side and keeps the jobs in the broker as they should be.
//! - [`ClusterProgress`]: workers, rates and backlog, for readers.
//!
//! Neither pixels nor results go through the broker.

mod byte_range;
mod conditions;
mod coordinator;
mod coordinator_client;
mod crew;
mod delivery;
mod delivery_log;
mod error;
mod expected;
mod job;
mod offers;
mod progress;
mod queue;
mod remaining;
mod routes;
mod service;
mod settings;
mod tally;

pub use byte_range::{RangeRequest, parse_range};
pub use conditions::Conditions;
pub use coordinator::{Begin, Coordinator, CoordinatorSetup, ResultTaker, model_sha256};
pub use coordinator_client::{ClientError, CoordinatorClient};
pub use crew::{WorkerState, WorkerView};
pub use delivery::Delivery;
pub use delivery_log::{DeliveryLog, LoggedDeliveries};
pub use error::ClusterError;
pub use job::{Assignment, Frame, Job, PROTOCOL, Reference, Shot, Tokens};
pub use progress::{ClusterProgress, ClusterView, GivenUpView, Progress, ShotsView};
pub use queue::{Broker, JobQueue, TakenJob};
pub use routes::coordinator_routes;
pub use service::{ServiceSettings, WorkService, WorkersAddress};
pub use settings::ClusterSettings;
pub use tally::{Attempt, Report, ShotState, Tally, Tries, Verdict};
