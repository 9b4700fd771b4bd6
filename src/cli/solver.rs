//! Conversion between solvers and their names in the configuration.

use lfpiv_core::reconstruction::Solver;
use serde::{
    Deserialize,
    de::value::{Error, StrDeserializer},
};

/// A solver's name.
pub fn solver_name(solver: Solver) -> String {
    solver.to_string()
}

/// The solver with this name, or a message that lists all names.
pub fn solver_by_name(name: &str) -> Result<Solver, String> {
    Solver::deserialize(StrDeserializer::<Error>::new(name))
        .map_err(|error| error.to_string().replace("unknown variant", "unknown solver"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solver_names_round_trip() {
        assert_eq!(solver_by_name("os-sart"), Ok(Solver::OsSart));
        assert_eq!(solver_name(Solver::OsSart), "os-sart");
        let message = solver_by_name("magic").unwrap_err();
        assert!(message.contains("`magic`, expected one of `mlos`, `sart`"), "{message}");
    }
}
