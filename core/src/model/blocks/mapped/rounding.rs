//! Numbers to whole ones, in loops that become vector instructions: conversions that care for NaN and for
//! numbers out of range do not.

/// From here on the last bit of a mantissa counts ones.
const ONES: f32 = 8_388_608.0;

/// The whole number nearest to one from 0 to 2²², as the last bits of a float: see [`whole`].
#[inline(always)]
pub(super) fn nearest(value: f32) -> u32 {
    (value + ONES).to_bits()
}

/// The whole number itself.
#[inline(always)]
pub(super) fn whole(nearest: u32) -> i32 {
    nearest.wrapping_sub(ONES.to_bits()) as i32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_numbers_are_those_of_the_standard_library() {
        for n in 0..100_000 {
            let value = n as f32 * 0.37;
            assert_eq!(whole(nearest(value)), value.round_ties_even() as i32, "{value}");
        }
    }
}
