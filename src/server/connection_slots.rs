//! Slots for connections: which connections stay open when many clients connect.
//!
//! A new connection takes one of the few guest slots. If these are full, the oldest guest
//! connection is closed; if the client's address already has half of the guest slots, its own
//! oldest one. So no client can lock out others by holding connections. When a request of a
//! connection is accepted, the connection moves to another kind of slot and is no longer closed for
//! others: a safety slot for requests that make the laser safe, or an admitted slot, as long as one
//! is free.

use std::{
    collections::{BTreeMap, HashMap},
    net::IpAddr,
    sync::Arc,
};

use parking_lot::Mutex;
use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio_util::sync::CancellationToken;

use super::protection::{ConnectionLimits, SAFETY_SLOTS, network};

/// Kind of a slot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// No request has been accepted yet.
    Guest,
    /// A request was accepted.
    Admitted,
    /// A request makes the laser safe.
    Safety,
}

/// All slots. One client has at most half of the slots of each kind.
pub(super) struct ConnectionSlots {
    limits: ConnectionLimits,
    /// One permit per open socket, including those being closed.
    sockets: Arc<Semaphore>,
    state: Mutex<State>,
}

#[derive(Default)]
struct State {
    arrivals: u64,
    /// The occupied slots, in order of arrival.
    occupied: BTreeMap<u64, Occupied>,
}

struct Occupied {
    client: IpAddr,
    kind: Kind,
    eviction: CancellationToken,
}

/// A connection's slot, released on drop.
pub(super) struct Slot {
    handle: SlotHandle,
    eviction: CancellationToken,
    _socket: OwnedSemaphorePermit,
}

/// Handle to a connection's slot, stored in its requests.
#[derive(Clone)]
pub(super) struct SlotHandle {
    slots: Arc<ConnectionSlots>,
    arrival: u64,
}

impl ConnectionSlots {
    pub fn new(limits: ConnectionLimits) -> Arc<Self> {
        let sockets = Arc::new(Semaphore::new(limits.sockets()));
        Arc::new(Self { limits, sockets, state: Mutex::default() })
    }

    /// Waits until another connection may be accepted, that is, until evicted ones are closed.
    pub async fn socket(&self) -> Option<OwnedSemaphorePermit> {
        self.sockets.clone().acquire_owned().await.ok()
    }

    /// Gives a new connection a guest slot, evicting another guest if necessary.
    pub fn arrive(self: &Arc<Self>, client: IpAddr, socket: OwnedSemaphorePermit) -> Slot {
        let (client, eviction) = (network(client), CancellationToken::new());
        let mut state = self.state.lock();
        if let Some(oldest) = state.guest_to_evict(client, self.limits.guests)
            && let Some(evicted) = state.occupied.remove(&oldest)
        {
            tracing::debug!(client = %evicted.client, "connection closed for a new one; see server.guests");
            evicted.eviction.cancel();
        }
        let arrival = state.arrivals;
        state.arrivals += 1;
        state
            .occupied
            .insert(arrival, Occupied { client, kind: Kind::Guest, eviction: eviction.clone() });
        Slot { handle: SlotHandle { slots: self.clone(), arrival }, eviction, _socket: socket }
    }
}

impl State {
    /// The guest to evict for a new guest from `client`; `None` if a slot is free.
    fn guest_to_evict(&self, client: IpAddr, guests: usize) -> Option<u64> {
        let mut guests_of: HashMap<IpAddr, usize> = HashMap::new();
        let waiting = self.occupied.iter().filter(|(_, slot)| slot.kind == Kind::Guest);
        waiting.clone().for_each(|(_, slot)| *guests_of.entry(slot.client).or_default() += 1);
        let evicted_client = if guests_of.get(&client).is_some_and(|own| *own >= half(guests)) {
            client
        } else if guests_of.values().sum::<usize>() >= guests {
            *guests_of.iter().max_by_key(|(_, count)| **count)?.0
        } else {
            return None;
        };
        waiting
            .into_iter()
            .find(|(_, slot)| slot.client == evicted_client)
            .map(|(arrival, _)| *arrival)
    }

    fn count(&self, choose: impl Fn(&Occupied) -> bool) -> usize {
        self.occupied.values().filter(|slot| choose(slot)).count()
    }
}

fn half(slots: usize) -> usize {
    (slots / 2).max(1)
}

impl Slot {
    pub fn handle(&self) -> SlotHandle {
        self.handle.clone()
    }

    /// Completes when the slot is evicted for another connection.
    pub async fn evicted(&self) {
        self.eviction.cancelled().await;
    }
}

impl Drop for Slot {
    fn drop(&mut self) {
        self.handle.slots.state.lock().occupied.remove(&self.handle.arrival);
    }
}

impl SlotHandle {
    /// Moves the connection to an admitted slot, unless it has one. Returns `false` if none is free
    /// for this client.
    pub fn admit(&self) -> bool {
        let admitted = self.slots.limits.admitted;
        self.take(Kind::Admitted, |state, client| {
            let own = state.count(|slot| slot.kind == Kind::Admitted && slot.client == client);
            own < half(admitted) && state.count(|slot| slot.kind == Kind::Admitted) < admitted
        })
    }

    /// Moves the connection to a safety slot. If none is free it keeps its slot.
    pub fn make_safe(&self) {
        self.take(Kind::Safety, |state, _| {
            state.count(|slot| slot.kind == Kind::Safety) < SAFETY_SLOTS
        });
    }

    fn take(&self, kind: Kind, has_room: impl Fn(&State, IpAddr) -> bool) -> bool {
        let mut state = self.slots.state.lock();
        let Some((client, had)) =
            state.occupied.get(&self.arrival).map(|slot| (slot.client, slot.kind))
        else {
            return false;
        };
        if had == Kind::Admitted {
            return true;
        }
        let has_room = has_room(&state, client);
        if let Some(slot) = state.occupied.get_mut(&self.arrival).filter(|_| has_room) {
            slot.kind = kind;
        }
        has_room
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIMITS: ConnectionLimits = ConnectionLimits { guests: 8, admitted: 6 };

    struct TestSlots(Arc<ConnectionSlots>);

    impl TestSlots {
        fn new() -> Self {
            Self(ConnectionSlots::new(LIMITS))
        }

        fn arrive(&self, client: u8, count: usize) -> Vec<Slot> {
            let one = |_| {
                let socket = self.0.sockets.clone().try_acquire_owned().unwrap();
                self.0.arrive(IpAddr::from([10, 0, 0, client]), socket)
            };
            (0..count).map(one).collect()
        }
    }

    fn stay(slots: &[Slot]) -> Vec<bool> {
        slots.iter().map(|slot| !slot.eviction.is_cancelled()).collect()
    }

    #[test]
    fn the_oldest_guest_is_evicted() {
        let slots_under_test = TestSlots::new();
        let crowd = slots_under_test.arrive(1, 6);
        assert_eq!(stay(&crowd), [false, false, true, true, true, true], "half are for others");
        let mut others = slots_under_test.arrive(2, 2);
        others.extend(slots_under_test.arrive(3, 2));
        assert_eq!(stay(&crowd), [false, false, true, true, true, true]);
        // All slots are occupied: the address with the most guests loses one.
        let last = slots_under_test.arrive(4, 1);
        assert_eq!(stay(&crowd), [false, false, false, true, true, true]);
        assert!(stay(&others).iter().chain(&stay(&last)).all(|stays| *stays));
    }

    #[test]
    fn admitted_connections_are_not_evicted_and_one_client_has_half_of_the_slots() {
        let slots_under_test = TestSlots::new();
        let first = slots_under_test.arrive(1, 4);
        let let_in = |slots: &[Slot]| -> Vec<bool> {
            slots.iter().map(|slot| slot.handle().admit()).collect()
        };
        assert_eq!(let_in(&first), [true, true, true, false]);
        assert_eq!(let_in(&first[..1]), [true], "once is enough");
        let more = slots_under_test.arrive(1, 8);
        assert_eq!(stay(&first), [true, true, true, false], "the fourth was a guest");
        let (second, third) = (slots_under_test.arrive(2, 2), slots_under_test.arrive(3, 2));
        assert_eq!(let_in(&second), [true, true]);
        assert_eq!(let_in(&third), [true, false], "six in total");
        drop((first, more));
        assert_eq!(let_in(&third), [true, true], "slots are released");
        drop((second, third));
        assert!(slots_under_test.0.state.lock().occupied.is_empty());
        assert_eq!(slots_under_test.0.sockets.available_permits(), LIMITS.sockets());
    }

    #[test]
    fn making_the_laser_safe_has_a_slot_when_all_others_are_taken() {
        let slots_under_test = TestSlots::new();
        let mut crowd: Vec<Slot> =
            (1..=3).flat_map(|client| slots_under_test.arrive(client, 2)).collect();
        assert!(crowd.iter().all(|slot| slot.handle().admit()));
        crowd.extend((1..=2).flat_map(|client| slots_under_test.arrive(client, 4)));
        let operator = slots_under_test.arrive(1, 1);
        assert!(!operator[0].handle().admit());
        operator[0].handle().make_safe();
        crowd.extend((1..=2).flat_map(|client| slots_under_test.arrive(client, 4)));
        assert_eq!(stay(&operator), [true]);
    }
}
