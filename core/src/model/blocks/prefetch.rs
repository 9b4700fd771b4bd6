//! Memory prefetch.

/// Size of a cache line in bytes.
#[cfg(target_arch = "x86_64")]
const CACHE_LINE: usize = 64;

/// Prefetches value `at`, of at most two cache lines' size. Does nothing if the processor has no
/// such instruction, or beyond the last value.
#[inline(always)]
#[cfg_attr(
    target_arch = "x86_64",
    expect(
        unsafe_code,
        reason = "the instruction takes an address; safe code has no way to say it"
    )
)]
pub(super) fn prefetch<T>(values: &[T], at: usize) {
    #[cfg(target_arch = "x86_64")]
    {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        const { assert!(size_of::<T>() > 0 && size_of::<T>() <= 2 * CACHE_LINE) };
        let first = values.as_ptr().wrapping_add(at).cast::<i8>();
        // A value spans up to two cache lines, a larger one up to three, of which the middle one
        // may be missed.
        let last = first.wrapping_add(size_of::<T>() - 1);
        // SAFETY: the instruction is part of SSE, which every x86-64 has. It is a hint that loads
        // nothing into registers and never faults, whatever the address.
        unsafe {
            _mm_prefetch::<_MM_HINT_T0>(first);
            _mm_prefetch::<_MM_HINT_T0>(last);
        }
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = (values, at);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prefetched_values_are_unchanged() {
        let values: Vec<[u16; 10]> = (0..1000).map(|n| [n; 10]).collect();
        (0..1001).for_each(|n| prefetch(&values, n));
        assert!((0..1000).zip(&values).all(|(n, value)| *value == [n; 10]));
    }
}
