//! Rounding that compiles to vector instructions. The standard conversions handle NaN and overflow,
//! which prevents vectorisation.

/// At this magnitude the last bit of a mantissa has the value 1.
const ONES: f32 = 8_388_608.0;

/// The integer nearest to a value from 0 to 2²², as the mantissa bits of a float: see [`whole`].
#[inline(always)]
pub(super) fn nearest(value: f32) -> u32 {
    (value + ONES).to_bits()
}

/// Extracts the integer.
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
