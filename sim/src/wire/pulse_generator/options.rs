//! Properties that differ between units, or are unknown without hardware.

/// Behaviour of a simulated BNC 575.
#[derive(Debug, Clone, PartialEq)]
pub struct PulseGeneratorOptions {
    /// Reply to `*IDN?`.
    pub identity: String,
    /// Number of channels, 1 to 8.
    pub channels: u8,
    /// Factory baud rate.
    pub baud_rate: u32,
    /// Whether commands are echoed.
    pub echo: bool,
    /// What happens to commands that come too soon after the last reply.
    pub pacing: Option<Pacing>,
    /// Time from command to reply, in ns.
    pub reply_delay_ns: u64,
    /// Stray bytes before every reply.
    pub stray: Vec<u8>,
    /// Decimals of times in read-backs; all significant ones when absent.
    pub read_back_decimals: Option<usize>,
    /// Rounding of delays and widths, in ps.
    pub time_step_ps: i64,
    /// Whether `?9` is supported (577); other units answer `?5` to values out of bounds.
    pub knows_out_of_bounds: bool,
    /// Whether `*RST` leaves the channels enabled.
    pub reset_enables_channels: bool,
    /// Whether the gate input, as wired and set, passes pulses.
    pub gate_open: bool,
    /// Whether the wait counter delays a burst, or has no effect in burst mode.
    pub wait_counter_delays_bursts: bool,
    /// Whether T0 stops once every burst is complete, although lamps should continue.
    pub drops_off_after_burst: bool,
}

/// Minimum time between commands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Pacing {
    /// Minimum time from a reply to the next command, in ns.
    pub least_gap_ns: u64,
    /// What happens to earlier commands.
    pub too_soon: TooSoon,
}

/// What happens to a command that comes too soon.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TooSoon {
    /// Its first byte is lost.
    Garbled,
    /// It is answered with `?8`.
    Unavailable,
}

impl Default for PulseGeneratorOptions {
    fn default() -> Self {
        Self {
            identity: "BNC,575-8,31707,2.4.2-2.0.11".into(),
            channels: 8,
            baud_rate: 115_200,
            echo: false,
            pacing: None,
            reply_delay_ns: 0,
            stray: Vec::new(),
            read_back_decimals: None,
            time_step_ps: 250,
            knows_out_of_bounds: false,
            reset_enables_channels: false,
            gate_open: true,
            wait_counter_delays_bursts: true,
            drops_off_after_burst: true,
        }
    }
}
