//! What differs between units, or is not known without one.

/// How a simulated BNC 575 behaves.
#[derive(Debug, Clone, PartialEq)]
pub struct PulseGeneratorOptions {
    /// Answer to `*IDN?`.
    pub identity: String,
    /// Number of channels, 1 to 8.
    pub channels: u8,
    /// Factory speed of the serial line, in baud.
    pub baud_rate: u32,
    /// Whether commands are repeated before they are answered.
    pub echo: bool,
    /// What becomes of commands that come too soon after the last reply.
    pub pacing: Option<Pacing>,
    /// From command to reply, in ns.
    pub reply_delay_ns: u64,
    /// Bytes that come before every reply.
    pub stray: Vec<u8>,
    /// Decimals of times that are read back; all that are set when absent.
    pub read_back_decimals: Option<usize>,
    /// Delays and widths are rounded to this, in ps.
    pub time_step_ps: i64,
    /// Whether `?9` is known (577); other units answer `?5` to values out of bounds.
    pub knows_out_of_bounds: bool,
    /// Whether `*RST` leaves the channels enabled.
    pub reset_enables_channels: bool,
    /// The gate input as it is wired and set: whether it lets pulses out.
    pub gate_open: bool,
    /// Whether the wait counter holds back a burst, or has no effect in burst mode.
    pub wait_counter_delays_bursts: bool,
    /// Whether the unit drops to OFF once every burst is complete, although lamps go on.
    pub drops_off_after_burst: bool,
}

/// Commands need time between them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Pacing {
    /// Least time from a reply to the next command, in ns.
    pub least_gap_ns: u64,
    /// What becomes of commands that come sooner.
    pub too_soon: TooSoon,
}

/// What becomes of a command that comes too soon.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TooSoon {
    /// Its first byte is lost.
    Garbled,
    /// It is answered `?8`.
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
