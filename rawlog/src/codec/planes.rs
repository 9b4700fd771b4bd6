//! Counts as two byte planes: the high bytes vary little and compress well.

/// All low bytes, then all high bytes.
pub(super) fn split(counts: &[u16], planes: &mut Vec<u8>) {
    planes.clear();
    planes.extend(counts.iter().map(|count| *count as u8));
    planes.extend(counts.iter().map(|count| (*count >> 8) as u8));
}

/// Fills `counts` from planes of as many low and high bytes.
pub(super) fn join(planes: &[u8], counts: &mut [u16]) {
    let (low, high) = planes.split_at(planes.len() / 2);
    for (count, (low, high)) in counts.iter_mut().zip(low.iter().zip(high)) {
        *count = u16::from_le_bytes([*low, *high]);
    }
}
