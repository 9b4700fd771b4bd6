//! Seats for connections: who may stay when many come.
//!
//! A connection arrives as a guest. There are few seats for guests, and there is always one for
//! who comes next: the guest that has been there longest goes, of the same address when that has
//! its half. So nobody can keep others out by sitting there. Once a request is let in, its
//! connection takes a seat of another kind, where it is not sent away: one for who may make the
//! laser safe and does, or one of those for all who were let in, as long as there is one.

use std::{
    collections::{BTreeMap, HashMap},
    net::IpAddr,
    sync::Arc,
};

use parking_lot::Mutex;
use tokio::sync::{OwnedSemaphorePermit, Semaphore};
use tokio_util::sync::CancellationToken;

use super::protection::{Places, SAFETY, network};

/// See the module.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    /// Nothing is known of the client.
    Guest,
    /// A request was let in.
    Admitted,
    /// It makes the laser safe.
    Safety,
}

/// All seats. One client has half of those of each kind at most.
pub(super) struct Seats {
    places: Places,
    /// A permit for each connection that is open, those included that are being closed.
    sockets: Arc<Semaphore>,
    state: Mutex<State>,
}

#[derive(Default)]
struct State {
    arrivals: u64,
    /// In the order of arrival.
    taken: BTreeMap<u64, Taken>,
}

struct Taken {
    client: IpAddr,
    kind: Kind,
    leave: CancellationToken,
}

/// Given back when it is dropped.
pub(super) struct Seat {
    handle: SeatHandle,
    leave: CancellationToken,
    _socket: OwnedSemaphorePermit,
}

/// What a request knows of its connection's seat.
#[derive(Clone)]
pub(super) struct SeatHandle {
    seats: Arc<Seats>,
    arrival: u64,
}

impl Seats {
    pub fn new(places: Places) -> Arc<Self> {
        let sockets = Arc::new(Semaphore::new(places.sockets()));
        Arc::new(Self { places, sockets, state: Mutex::default() })
    }

    /// Waits until another connection may be accepted: until those that were sent away are closed.
    pub async fn socket(&self) -> Option<OwnedSemaphorePermit> {
        self.sockets.clone().acquire_owned().await.ok()
    }

    /// A guest has come; another may have to go.
    pub fn arrive(self: &Arc<Self>, client: IpAddr, socket: OwnedSemaphorePermit) -> Seat {
        let (client, leave) = (network(client), CancellationToken::new());
        let mut state = self.state.lock();
        if let Some(longest) = state.guest_to_go(client, self.places.guests)
            && let Some(gone) = state.taken.remove(&longest)
        {
            tracing::debug!(client = %gone.client, "sent away for another; see server.guests");
            gone.leave.cancel();
        }
        let arrival = state.arrivals;
        state.arrivals += 1;
        state.taken.insert(arrival, Taken { client, kind: Kind::Guest, leave: leave.clone() });
        Seat { handle: SeatHandle { seats: self.clone(), arrival }, leave, _socket: socket }
    }
}

impl State {
    /// Who makes room for a guest from `client`; `None` where there is room.
    fn guest_to_go(&self, client: IpAddr, guests: usize) -> Option<u64> {
        let mut of: HashMap<IpAddr, usize> = HashMap::new();
        let waiting = self.taken.iter().filter(|(_, seat)| seat.kind == Kind::Guest);
        waiting.clone().for_each(|(_, seat)| *of.entry(seat.client).or_default() += 1);
        let goes = if of.get(&client).is_some_and(|own| *own >= half(guests)) {
            client
        } else if of.values().sum::<usize>() >= guests {
            *of.iter().max_by_key(|(_, count)| **count)?.0
        } else {
            return None;
        };
        waiting.into_iter().find(|(_, seat)| seat.client == goes).map(|(arrival, _)| *arrival)
    }

    fn count(&self, choose: impl Fn(&Taken) -> bool) -> usize {
        self.taken.values().filter(|seat| choose(seat)).count()
    }
}

fn half(places: usize) -> usize {
    (places / 2).max(1)
}

impl Seat {
    pub fn handle(&self) -> SeatHandle {
        self.handle.clone()
    }

    /// Completes when the seat is needed for somebody else.
    pub async fn needed(&self) {
        self.leave.cancelled().await;
    }
}

impl Drop for Seat {
    fn drop(&mut self) {
        self.handle.seats.state.lock().taken.remove(&self.handle.arrival);
    }
}

impl SeatHandle {
    /// A request was let in: its connection takes a seat for those, unless it has one. `false`
    /// where there is none for this client.
    pub fn admit(&self) -> bool {
        let admitted = self.seats.places.admitted;
        self.take(Kind::Admitted, |state, client| {
            let own = state.count(|seat| seat.kind == Kind::Admitted && seat.client == client);
            own < half(admitted) && state.count(|seat| seat.kind == Kind::Admitted) < admitted
        })
    }

    /// The laser is made safe by this connection. Where all seats for that are taken it keeps
    /// its own.
    pub fn make_safe(&self) {
        self.take(Kind::Safety, |state, _| state.count(|seat| seat.kind == Kind::Safety) < SAFETY);
    }

    fn take(&self, kind: Kind, has_room: impl Fn(&State, IpAddr) -> bool) -> bool {
        let mut state = self.seats.state.lock();
        let Some((client, had)) =
            state.taken.get(&self.arrival).map(|seat| (seat.client, seat.kind))
        else {
            return false;
        };
        if had == Kind::Admitted {
            return true;
        }
        let has_room = has_room(&state, client);
        if let Some(seat) = state.taken.get_mut(&self.arrival).filter(|_| has_room) {
            seat.kind = kind;
        }
        has_room
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLACES: Places = Places { guests: 8, admitted: 6 };

    struct House(Arc<Seats>);

    impl House {
        fn new() -> Self {
            Self(Seats::new(PLACES))
        }

        fn arrive(&self, client: u8, count: usize) -> Vec<Seat> {
            let one = |_| {
                let socket = self.0.sockets.clone().try_acquire_owned().unwrap();
                self.0.arrive(IpAddr::from([10, 0, 0, client]), socket)
            };
            (0..count).map(one).collect()
        }
    }

    fn stay(seats: &[Seat]) -> Vec<bool> {
        seats.iter().map(|seat| !seat.leave.is_cancelled()).collect()
    }

    #[test]
    fn the_guest_who_has_been_there_longest_makes_room() {
        let house = House::new();
        let crowd = house.arrive(1, 6);
        assert_eq!(stay(&crowd), [false, false, true, true, true, true], "half are for others");
        let mut others = house.arrive(2, 2);
        others.extend(house.arrive(3, 2));
        assert_eq!(stay(&crowd), [false, false, true, true, true, true]);
        // The house is full: the address with most of them gives way.
        let last = house.arrive(4, 1);
        assert_eq!(stay(&crowd), [false, false, false, true, true, true]);
        assert!(stay(&others).iter().chain(&stay(&last)).all(|stays| *stays));
    }

    #[test]
    fn who_was_let_in_is_not_sent_away_and_one_client_has_half_of_these_seats() {
        let house = House::new();
        let first = house.arrive(1, 4);
        let let_in = |seats: &[Seat]| -> Vec<bool> {
            seats.iter().map(|seat| seat.handle().admit()).collect()
        };
        assert_eq!(let_in(&first), [true, true, true, false]);
        assert_eq!(let_in(&first[..1]), [true], "once is enough");
        let more = house.arrive(1, 8);
        assert_eq!(stay(&first), [true, true, true, false], "the fourth was a guest");
        let (second, third) = (house.arrive(2, 2), house.arrive(3, 2));
        assert_eq!(let_in(&second), [true, true]);
        assert_eq!(let_in(&third), [true, false], "six in all");
        drop((first, more));
        assert_eq!(let_in(&third), [true, true], "seats are given back");
        drop((second, third));
        assert!(house.0.state.lock().taken.is_empty());
        assert_eq!(house.0.sockets.available_permits(), PLACES.sockets());
    }

    #[test]
    fn whoever_makes_safe_has_a_seat_when_all_others_are_taken() {
        let house = House::new();
        let mut crowd: Vec<Seat> = (1..=3).flat_map(|client| house.arrive(client, 2)).collect();
        assert!(crowd.iter().all(|seat| seat.handle().admit()));
        crowd.extend((1..=2).flat_map(|client| house.arrive(client, 4)));
        let operator = house.arrive(1, 1);
        assert!(!operator[0].handle().admit());
        operator[0].handle().make_safe();
        crowd.extend((1..=2).flat_map(|client| house.arrive(client, 4)));
        assert_eq!(stay(&operator), [true]);
    }
}
