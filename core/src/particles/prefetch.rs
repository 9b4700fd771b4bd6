//! Memory that is loaded before it is needed.

/// Asks the processor to load the cache line of value number `at` of a slice. Beyond the slice's end, and on
/// processors other than x86-64, it does nothing.
#[inline(always)]
#[cfg_attr(target_arch = "x86_64", expect(unsafe_code))]
pub fn prefetch<T>(values: &[T], at: usize) {
    #[cfg(target_arch = "x86_64")]
    if let Some(value) = values.get(at) {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        // SAFETY: a prefetch is a hint. It reads no value and faults at no address, and this one is of a value that
        // is borrowed here; every x86-64 processor has the instruction.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(std::ptr::from_ref(value).cast()) };
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = (values, at);
}

#[cfg(test)]
mod tests {
    use super::prefetch;

    #[test]
    fn a_prefetch_changes_nothing_and_may_be_asked_beyond_the_end() {
        let values: Vec<u32> = (0..100).collect();
        (0..200).chain([usize::MAX]).for_each(|at| prefetch(&values, at));
        prefetch::<u8>(&[], 0);
        assert_eq!(values, (0..100).collect::<Vec<u32>>());
    }
}
