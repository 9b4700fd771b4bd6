//! Frame-of-reference bit packing: unused bits of 12- and 8-bit sensors take no space.
//!
//! Counts are packed in blocks of 128; the last block is padded with its first count. A block
//! consists of its smallest count (2 bytes), the width W in bits of the largest difference from it
//! (1 byte), and the 128 differences of W bits each, in 16·W bytes. Difference n is in lane n mod 8,
//! so that one vector operation shifts eight of them. Each lane is a string of 16 differences,
//! lowest bits first, cut into W words of 16 bits; word w of lane l is word 8·w + l of the block.

use std::array;

const LANES: usize = 8;
/// Differences per lane: the bits of a word, so that a lane is W whole words.
const DEPTH: usize = 16;
const BLOCK: usize = LANES * DEPTH;
const BLOCK_HEADER_BYTES: usize = 3;
const WORD_ROW_BYTES: usize = 2 * LANES;

/// One loop per width, so that all shifts are constants and the compiler unrolls it.
macro_rules! with_width {
    ($width:expr, $function:ident $arguments:tt) => {
        with_width!(@ $width, $function $arguments, 0 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15)
    };
    (@ $width:expr, $function:ident $arguments:tt, $($known:literal)*) => {
        match $width {
            $($known => $function::<$known>$arguments,)*
            _ => $function::<16>$arguments,
        }
    };
}

/// Upper bound of the counts that this many stored bytes can encode.
pub(super) fn max_counts(stored_bytes: usize) -> usize {
    (stored_bytes / BLOCK_HEADER_BYTES).saturating_mul(BLOCK)
}

/// Appends the packed counts to `packed`.
pub(super) fn pack(counts: &[u16], packed: &mut Vec<u8>) {
    let (blocks, rest) = counts.as_chunks::<BLOCK>();
    for block in blocks {
        pack_block(block, packed);
    }
    if let Some(first) = rest.first() {
        let mut block = [*first; BLOCK];
        block[..rest.len()].copy_from_slice(rest);
        pack_block(&block, packed);
    }
}

/// Fills `counts` from the output of [`pack`] for the same number of counts. `None` if the bytes are
/// not such output.
pub(super) fn unpack(mut packed: &[u8], counts: &mut [u16]) -> Option<()> {
    let (blocks, rest) = counts.as_chunks_mut::<BLOCK>();
    for block in blocks {
        packed = unpack_block(packed, block)?;
    }
    if !rest.is_empty() {
        let mut block = [0; BLOCK];
        packed = unpack_block(packed, &mut block)?;
        rest.copy_from_slice(&block[..rest.len()]);
    }
    packed.is_empty().then_some(())
}

fn pack_block(block: &[u16; BLOCK], packed: &mut Vec<u8>) {
    let smallest = block.iter().fold(u16::MAX, |least, count| least.min(*count));
    let largest = block.iter().fold(0, |most: u16, count| most.max(*count));
    let width = (u16::BITS - (largest - smallest).leading_zeros()) as usize;
    packed.extend(smallest.to_le_bytes());
    packed.push(width as u8);
    let start = packed.len();
    packed.resize(start + width * WORD_ROW_BYTES, 0);
    with_width!(width, pack_differences(block, smallest, &mut packed[start..]));
}

fn unpack_block<'p>(packed: &'p [u8], block: &mut [u16; BLOCK]) -> Option<&'p [u8]> {
    let (header, packed) = packed.split_first_chunk::<BLOCK_HEADER_BYTES>()?;
    let [low, high, width] = *header;
    let (words, rest) = packed.split_at_checked(usize::from(width) * WORD_ROW_BYTES)?;
    let smallest = u16::from_le_bytes([low, high]);
    let width = usize::from(width);
    if width > DEPTH {
        return None;
    }
    with_width!(width, unpack_differences(words, smallest, block));
    Some(rest)
}

fn pack_differences<const WIDTH: usize>(block: &[u16; BLOCK], smallest: u16, words: &mut [u8]) {
    let (word_rows, _) = words.as_chunks_mut::<WORD_ROW_BYTES>();
    let mut word_rows = word_rows.iter_mut();
    let mut word = [0_u16; LANES];
    let mut filled_bits = 0;
    for row in block.as_chunks::<LANES>().0 {
        let difference: [u16; LANES] = array::from_fn(|lane| row[lane] - smallest);
        for lane in 0..LANES {
            word[lane] |= difference[lane] << filled_bits;
        }
        filled_bits += WIDTH;
        if filled_bits >= DEPTH {
            filled_bits -= DEPTH;
            if let Some(bytes) = word_rows.next() {
                write_row(&word, bytes);
            }
            let written_bits = WIDTH - filled_bits;
            word =
                array::from_fn(
                    |lane| {
                        if filled_bits > 0 { difference[lane] >> written_bits } else { 0 }
                    },
                );
        }
    }
}

fn unpack_differences<const WIDTH: usize>(words: &[u8], smallest: u16, block: &mut [u16; BLOCK]) {
    if WIDTH == 0 {
        return block.fill(smallest);
    }
    let mask = u16::MAX >> (DEPTH - WIDTH);
    let (word_rows, _) = words.as_chunks::<WORD_ROW_BYTES>();
    let mut word_rows = word_rows.iter().map(read_row);
    let mut next_row = || word_rows.next().unwrap_or_default();
    let mut word = next_row();
    let mut used_bits = 0;
    for row in block.as_chunks_mut::<LANES>().0 {
        if used_bits == DEPTH {
            word = next_row();
            used_bits = 0;
        }
        let mut difference: [u16; LANES] = array::from_fn(|lane| word[lane] >> used_bits);
        used_bits += WIDTH;
        if used_bits > DEPTH {
            word = next_row();
            used_bits -= DEPTH;
            for lane in 0..LANES {
                difference[lane] |= word[lane] << (WIDTH - used_bits);
            }
        }
        *row = array::from_fn(|lane| (difference[lane] & mask).wrapping_add(smallest));
    }
}

fn write_row(words: &[u16; LANES], bytes: &mut [u8; WORD_ROW_BYTES]) {
    for (bytes, word) in bytes.as_chunks_mut::<2>().0.iter_mut().zip(words) {
        *bytes = word.to_le_bytes();
    }
}

fn read_row(bytes: &[u8; WORD_ROW_BYTES]) -> [u16; LANES] {
    array::from_fn(|lane| u16::from_le_bytes([bytes[2 * lane], bytes[2 * lane + 1]]))
}
