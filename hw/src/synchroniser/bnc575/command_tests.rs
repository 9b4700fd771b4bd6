use proptest::prelude::*;

use super::*;
use crate::synchroniser::bnc575::reply::{Refusal, Reply};

fn channel(number: u8, parameter: ChannelParameter) -> Parameter {
    Parameter::Of(Channel(number), parameter)
}

#[test]
fn every_row_of_the_command_table_is_spelt_as_in_the_manual() {
    use ChannelParameter as P;
    let set = Command::Set;
    let keyword = Value::Keyword;
    let rows = [
        (Command::Identify, "*IDN?"),
        (Command::Catalogue, ":INST:CAT?"),
        (Command::Reset, "*RST"),
        (Command::Trigger, "*TRG"),
        (Command::Arm, "*ARM"),
        (set(Parameter::Running, Value::Switch(false)), ":PULSE0:STATE OFF"),
        (set(Parameter::Running, Value::Switch(true)), ":PULSE0:STATE ON"),
        (set(Parameter::Period, Value::period(100_000.0)), ":PULSE0:PER 0.100000000"),
        (set(Parameter::SystemMode, keyword("NORM")), ":PULSE0:MODE NORM"),
        (set(Parameter::SystemMode, keyword("SING")), ":PULSE0:MODE SING"),
        (set(Parameter::TriggerMode, keyword("TRIG")), ":PULSE0:TRIG:MODE TRIG"),
        (set(Parameter::TriggerEdge, Value::edge(TriggerEdge::Rising)), ":PULSE0:TRIG:EDGE RIS"),
        (set(Parameter::TriggerLevel, Value::Volts(2.5)), ":PULSE0:TRIG:LEV 2.50"),
        (set(channel(1, P::State), Value::Switch(true)), ":PULSE1:STATE ON"),
        (set(channel(2, P::Sync), keyword("T0")), ":PULSE2:SYNC T0"),
        (set(channel(2, P::Polarity), keyword("NORM")), ":PULSE2:POL NORM"),
        (set(channel(2, P::OutputMode), keyword("TTL")), ":PULSE2:OUTP:MODE TTL"),
        (set(channel(2, P::Delay), Value::time(280.0)), ":PULSE2:DEL 0.00028000000"),
        (set(channel(2, P::Width), Value::time(50.0)), ":PULSE2:WIDT 0.00005000000"),
        (set(channel(1, P::Mode), keyword("NORM")), ":PULSE1:CMOD NORM"),
        (set(channel(8, P::Mode), keyword("BURS")), ":PULSE8:CMOD BURS"),
        (set(channel(8, P::BurstCount), Value::Count(50)), ":PULSE8:BCO 50"),
        (set(channel(8, P::WaitCount), Value::Count(100)), ":PULSE8:WCO 100"),
        (Command::Query(channel(8, P::WaitCount)), ":PULSE8:WCO?"),
        (Command::Query(Parameter::Period), ":PULSE0:PER?"),
        (Command::Query(Parameter::TriggerCount), ":PULS0:COUN:COUN? TCNTS"),
    ];
    for (command, text) in rows {
        assert_eq!(command.to_string(), text);
    }
}

#[test]
fn every_reply_is_understood_and_nothing_else() {
    assert_eq!(Reply::parse("ok"), Some(Reply::Done));
    assert_eq!(Reply::parse("OK"), Some(Reply::Done));
    for code in 1..=9 {
        assert_eq!(Reply::parse(&format!("?{code}")), Some(Reply::Refused(Refusal(code))));
    }
    assert_eq!(Refusal(8).to_string(), "?8 (command unavailable in the present state of the unit)");
    for stray in ["", "o", "okok", "?", "?0", "?10", "0.1", "1"] {
        assert_eq!(Reply::parse(stray), None, "{stray}");
    }
}

#[test]
fn read_back_is_compared_as_numbers() {
    let delay = Value::time(280.0);
    for same in ["0.00028000000", "0.00028", "+0.000280000", "2.8E-4", "0.000280000000"] {
        assert!(delay.agrees(same), "{same}");
    }
    for other in ["0.00028000025", "0.000281", "-0.00028", "", "NaN", "inf", "ok", "0,00028"] {
        assert!(!delay.agrees(other), "{other}");
    }
    // A difference of 250 ps is detected if the unit shows enough digits.
    assert!(!Value::time(280.00025).agrees("0.00028000000"));
    assert!(Value::time(280.00025).agrees("0.000280000"));
    assert!(Value::Switch(true).agrees("1") && !Value::Switch(true).agrees("0"));
    assert!(Value::Keyword("BURS").agrees("BURST") && Value::Keyword("BURS").agrees("burs"));
    assert!(!Value::Keyword("NORM").agrees("BURS") && !Value::Keyword("NORM").agrees("NO"));
    assert!(Value::Count(50).agrees("0000050") && !Value::Count(50).agrees("51"));
    assert!(Value::Volts(2.5).agrees("2.50") && !Value::Volts(2.5).agrees("2.49"));
}

#[test]
fn stray_lines_are_distinguished_from_replies() {
    assert!(Parameter::Running.can_be("1") && !Parameter::Running.can_be("2"));
    assert!(!Parameter::Running.can_be("ok") && !Parameter::SystemMode.can_be("ok"));
    assert!(!Parameter::SystemMode.can_be("noise") && Parameter::SystemMode.can_be("SINGLE"));
    assert!(Parameter::SystemMode.can_be("NORM") && !Parameter::SystemMode.can_be("0.1"));
    assert!(Parameter::Period.can_be("0.100000000") && !Parameter::Period.can_be("NORM"));
    assert!(!Parameter::TriggerCount.can_be("-1"));
}

proptest! {
    #![proptest_config(ProptestConfig { rng_seed: proptest::test_runner::RngSeed::Fixed(575), ..ProptestConfig::with_cases(2048) })]

    /// In steps of 250 ps over the whole range of delays, text represents the value exactly, agrees
    /// with itself, and differs from the neighbouring steps.
    #[test]
    fn times_survive_being_sent_and_read_back(steps in -3_999_999_999_999_i64..=3_999_999_999_999) {
        let value = Value::Time { ps: 250 * steps, decimals: 11 };
        prop_assert!(value.agrees(&value.to_string()), "{value}");
        for neighbour in [steps - 1, steps + 1] {
            let other = Value::Time { ps: 250 * neighbour, decimals: 11 };
            prop_assert!(!value.agrees(&other.to_string()), "{value} agrees with {other}");
        }
    }

    #[test]
    fn no_reply_makes_the_parsers_panic(reply in "\\PC{0,24}") {
        let values = [
            Value::Switch(true), Value::Keyword("NORM"), Value::time(280.0), Value::Volts(2.5),
            Value::Count(5),
        ];
        for value in values {
            value.agrees(&reply);
        }
        Reply::parse(&reply);
        Parameter::Period.can_be(&reply);
        Parameter::SystemMode.can_be(&reply);
    }

    #[test]
    fn delays_in_whole_nanoseconds_are_sent_as_they_are(ns in 0_i64..999_000_000_000) {
        let text = Value::time(ns as f64 / 1000.0).to_string();
        let (seconds, digits) = text.split_once('.').unwrap();
        prop_assert_eq!(digits.len(), 11);
        let read_ns: i64 = format!("{seconds}{}", &digits[..9]).parse().unwrap();
        prop_assert_eq!(read_ns, ns);
        prop_assert_eq!(&digits[9..], "00");
    }
}
