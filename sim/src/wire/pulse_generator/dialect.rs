//! The remote commands: parses text, changes registers, formats replies.
//!
//! Implements the manual, independently of the driver: keywords in short or long form, in any case,
//! and the error codes listed there.

use super::{PulseGeneratorOptions, registers::Registers};

/// Error code `?n`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Code(pub(super) u8);

const BAD_PREFIX: Code = Code(1);
const MISSING_KEYWORD: Code = Code(2);
const INVALID_KEYWORD: Code = Code(3);
const MISSING_PARAMETER: Code = Code(4);
const INVALID_PARAMETER: Code = Code(5);
const QUERY_ONLY: Code = Code(6);
const NO_QUERY: Code = Code(7);
pub(super) const UNAVAILABLE: Code = Code(8);
const OUT_OF_BOUNDS: Code = Code(9);

/// Reply to a command.
pub(super) type Answer = Result<String, Code>;

/// A parsed line.
struct Request<'a> {
    keywords: Vec<String>,
    query: bool,
    parameter: Option<&'a str>,
}

impl<'a> Request<'a> {
    fn parse(line: &'a str) -> Result<Self, Code> {
        let (header, parameter) = match line.split_once(char::is_whitespace) {
            Some((header, parameter)) => (header, Some(parameter.trim())),
            None => (line, None),
        };
        let (header, query) = match header.strip_suffix('?') {
            Some(header) => (header, true),
            None => (header, false),
        };
        let keywords = match header.strip_prefix(':') {
            Some(rest) => rest.split(':').map(str::to_ascii_uppercase).collect(),
            None if header.starts_with('*') => vec![header.to_ascii_uppercase()],
            None => return Err(BAD_PREFIX),
        };
        Ok(Self { keywords, query, parameter: parameter.filter(|text| !text.is_empty()) })
    }

    fn parameter(&self) -> Result<&'a str, Code> {
        self.parameter.ok_or(MISSING_PARAMETER)
    }
}

/// Compares a keyword with its short and long form.
fn is(keyword: &str, short: &str, long: &str) -> bool {
    keyword == short || keyword == long
}

/// Executes one line.
pub(super) fn execute(
    registers: &mut Registers,
    options: &mut PulseGeneratorOptions,
    line: &str,
    now_ns: u64,
) -> Answer {
    let request = Request::parse(line)?;
    let keywords: Vec<&str> = request.keywords.iter().map(String::as_str).collect();
    match keywords.as_slice() {
        ["*IDN"] => query_only(&request, options.identity.clone()),
        ["*RST"] => command_only(&request, || registers.reset(options)),
        ["*ARM"] => command_only(&request, || registers.rearm()),
        ["*TRG"] => Err(UNAVAILABLE),
        [""] | [] => Err(MISSING_KEYWORD),
        [head, rest @ ..] if is(head, "INST", "INSTRUMENT") => match rest {
            [catalogue] if is(catalogue, "CAT", "CATALOG") => {
                query_only(&request, catalogue_of(options))
            }
            [] => Err(MISSING_KEYWORD),
            _ => Err(INVALID_KEYWORD),
        },
        [head, rest @ ..] if is(head, "SYST", "SYSTEM") => match rest {
            [_, _, "ECHO"] => switch(&request, &mut options.echo),
            _ => Err(INVALID_KEYWORD),
        },
        [head, rest @ ..] => match output_number(head) {
            Some(0) => system(registers, options, &request, rest, now_ns),
            Some(number) if number <= registers.channels.len() => {
                channel(registers, options, &request, rest, number - 1)
            }
            _ => Err(INVALID_KEYWORD),
        },
    }
}

/// Whether the line is `*TRG`, for which the caller must generate the T0.
pub(super) fn is_software_trigger(line: &str) -> bool {
    line.eq_ignore_ascii_case("*TRG")
}

fn catalogue_of(options: &PulseGeneratorOptions) -> String {
    let channels = (0..options.channels).map(|index| format!("CH{}", char::from(b'A' + index)));
    std::iter::once("T0".to_owned()).chain(channels).collect::<Vec<_>>().join(", ")
}

/// Index of an output: `PULS0` and `PULSE0` are T0, `PULSE1` is channel A.
fn output_number(head: &str) -> Option<usize> {
    let digits = head.strip_prefix("PULSE").or_else(|| head.strip_prefix("PULS"))?;
    digits.parse().ok()
}

fn system(
    registers: &mut Registers,
    options: &PulseGeneratorOptions,
    request: &Request,
    keywords: &[&str],
    now_ns: u64,
) -> Answer {
    let system = &mut registers.system;
    match keywords {
        [state] if is(state, "STAT", "STATE") => {
            let mut running = system.running;
            let answer = switch(request, &mut running)?;
            if !request.query {
                registers.run(running, now_ns);
            }
            Ok(answer)
        }
        [period] if is(period, "PER", "PERIOD") => {
            let limits_ps = (100_000, 5_000_000_000_000_000);
            time(request, options, &mut system.period_ps, limits_ps, (10_000, 9))
        }
        ["MODE"] => keyword(request, &mut system.mode, &[("NORM", "NORMAL"), ("SING", "SINGLE")]),
        [trigger, "MODE"] if is(trigger, "TRIG", "TRIGGER") => {
            let modes = [("DIS", "DISABLED"), ("TRIG", "TRIGGERED")];
            keyword(request, &mut system.trigger_mode, &modes)
        }
        [trigger, "EDGE"] if is(trigger, "TRIG", "TRIGGER") => {
            let edges = [("RIS", "RISING"), ("FALL", "FALLING")];
            keyword(request, &mut system.trigger_edge, &edges)
        }
        [trigger, level] if is(trigger, "TRIG", "TRIGGER") && is(level, "LEV", "LEVEL") => {
            volts(request, options, &mut system.trigger_level_v)
        }
        [counter, counts] if is(counter, "COUN", "COUNTER") && is(counts, "COUN", "COUNTS") => {
            match request.parameter()?.to_ascii_uppercase().as_str() {
                "TCNTS" => query_only(request, system.count.to_string()),
                _ => Err(INVALID_PARAMETER),
            }
        }
        [] => Err(MISSING_KEYWORD),
        _ => Err(INVALID_KEYWORD),
    }
}

fn channel(
    registers: &mut Registers,
    options: &PulseGeneratorOptions,
    request: &Request,
    keywords: &[&str],
    index: usize,
) -> Answer {
    let channel = &mut registers.channels[index];
    match keywords {
        [state] if is(state, "STAT", "STATE") => switch(request, &mut channel.enabled),
        ["SYNC"] => keyword(request, &mut channel.sync, &[("T0", "T0"), ("CHA", "CHA")]),
        [polarity] if is(polarity, "POL", "POLARITY") => {
            let polarities = [("NORM", "NORMAL"), ("INV", "INVERTED")];
            keyword(request, &mut channel.polarity, &polarities)
        }
        [output, "MODE"] if is(output, "OUTP", "OUTPUT") => {
            let modes = [("TTL", "TTL"), ("ADJ", "ADJUSTABLE")];
            keyword(request, &mut channel.output_mode, &modes)
        }
        [mode] if is(mode, "CMOD", "CMODE") => {
            let modes =
                [("NORM", "NORMAL"), ("SING", "SINGLE"), ("BURS", "BURST"), ("DCYC", "DCYCLE")];
            keyword(request, &mut channel.mode, &modes)
        }
        [delay] if is(delay, "DEL", "DELAY") => {
            let limit_ps = 999_999_999_999_750;
            let step = (options.time_step_ps, 11);
            time(request, options, &mut channel.delay_ps, (-limit_ps, limit_ps), step)
        }
        [width] if is(width, "WIDT", "WIDTH") => {
            let limits_ps = (10_000, 999_900_000_000_000);
            let step = (options.time_step_ps, 11);
            time(request, options, &mut channel.width_ps, limits_ps, step)
        }
        [count] if is(count, "BCO", "BCOUNTER") => {
            counter(request, options, &mut channel.burst_count, 1)
        }
        [count] if is(count, "WCO", "WCOUNTER") => {
            counter(request, options, &mut channel.wait_count, 0)
        }
        [] => Err(MISSING_KEYWORD),
        _ => Err(INVALID_KEYWORD),
    }
}

fn done() -> Answer {
    Ok("ok".into())
}

fn query_only(request: &Request, answer: String) -> Answer {
    if request.query { Ok(answer) } else { Err(QUERY_ONLY) }
}

fn command_only(request: &Request, act: impl FnOnce()) -> Answer {
    if request.query {
        return Err(NO_QUERY);
    }
    act();
    done()
}

fn switch(request: &Request, value: &mut bool) -> Answer {
    if request.query {
        return Ok(u8::from(*value).to_string());
    }
    *value = match request.parameter()?.to_ascii_uppercase().as_str() {
        "ON" | "1" => true,
        "OFF" | "0" => false,
        _ => return Err(INVALID_PARAMETER),
    };
    done()
}

fn keyword(
    request: &Request,
    value: &mut &'static str,
    allowed: &[(&'static str, &'static str)],
) -> Answer {
    if request.query {
        return Ok((*value).to_owned());
    }
    let given = request.parameter()?.to_ascii_uppercase();
    let found = allowed.iter().find(|(short, long)| is(&given, short, long));
    *value = found.ok_or(INVALID_PARAMETER)?.0;
    done()
}

fn time(
    request: &Request,
    options: &PulseGeneratorOptions,
    value_ps: &mut i64,
    (lowest_ps, highest_ps): (i64, i64),
    (step_ps, decimals): (i64, usize),
) -> Answer {
    if request.query {
        let decimals = options.read_back_decimals.unwrap_or(decimals);
        return Ok(format!("{:.decimals$}", *value_ps as f64 * 1e-12));
    }
    let seconds: f64 = request.parameter()?.parse().map_err(|_| INVALID_PARAMETER)?;
    let ps = (seconds * 1e12).round() as i64;
    if !(lowest_ps..=highest_ps).contains(&ps) {
        return Err(out_of_bounds(options));
    }
    *value_ps = (ps as f64 / step_ps as f64).round() as i64 * step_ps;
    done()
}

fn volts(request: &Request, options: &PulseGeneratorOptions, value: &mut f64) -> Answer {
    if request.query {
        return Ok(format!("{value:.2}"));
    }
    let volts: f64 = request.parameter()?.parse().map_err(|_| INVALID_PARAMETER)?;
    if !(0.2..=15.0).contains(&volts) {
        return Err(out_of_bounds(options));
    }
    *value = volts;
    done()
}

fn counter(
    request: &Request,
    options: &PulseGeneratorOptions,
    value: &mut u64,
    lowest: u64,
) -> Answer {
    if request.query {
        return Ok(value.to_string());
    }
    let count: u64 = request.parameter()?.parse().map_err(|_| INVALID_PARAMETER)?;
    if !(lowest..=9_999_999).contains(&count) {
        return Err(out_of_bounds(options));
    }
    *value = count;
    done()
}

fn out_of_bounds(options: &PulseGeneratorOptions) -> Code {
    if options.knows_out_of_bounds { OUT_OF_BOUNDS } else { INVALID_PARAMETER }
}
