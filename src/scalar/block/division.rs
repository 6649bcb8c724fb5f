//! Quotients, shifts and roots of the integers of one width.

/// The quotient of integers whose divisor is never zero, without the panic path of `/`.
macro_rules! quotient {
    ($numerator:expr, $divisor:expr) => {
        $numerator.checked_div($divisor).unwrap_or(0)
    };
}

/// Arithmetic shift right by at least 1 bit and by fewer than the width, rounded to nearest, ties to even, so that a
/// mirrored ray has mirrored hits, to the bit.
macro_rules! shift_right_rounded {
    ($value:expr, $shift:expr) => {{
        let (value, shift) = ($value, $shift);
        // The last dropped bit is added: that cannot overflow, unlike adding half a unit before the shift.
        let rounded = (value >> shift) + ((value >> (shift - 1)) & 1);
        let is_tie = value & !(!0 << shift) == 1 << (shift - 1);
        if is_tie { rounded & !1 } else { rounded }
    }};
}

/// The root of the top half of a radicand, in the type of the radicand.
macro_rules! root_of_half {
    (128, $top:expr) => {
        Block64::integer_square_root($top as u64) as u128
    };
    (64, $top:expr) => {
        division::root_of_32($top as u32) as u64
    };
    (16, $top:expr) => {
        division::ROOT_OF_BYTE[$top as usize] as u16
    };
}

/// Square roots, rounded down, of a byte with one of its two top bits set (others: zero).
pub(super) const ROOT_OF_BYTE: [u8; 256] = {
    let mut table = [0; 256];
    let mut n = 0x40;
    while n < 256 {
        let mut root = 15;
        while root * root > n {
            root -= 1;
        }
        table[n] = root as u8;
        n += 1;
    }
    table
};

/// The square root of a 32-bit integer with one of its two top bits set, rounded down: a table for the first four
/// bits, then two Newton steps on prefixes.
pub(super) fn root_of_32(n: u32) -> u32 {
    let root = ROOT_OF_BYTE[(n >> 24) as usize] as u32;
    let root = floor_root((root << 3) + quotient!((n >> 21), root), n >> 16);
    floor_root((root << 7) + quotient!((n >> 9), root), n)
}

/// Subtracts one if a Newton step gave a root that is one too large. (`root` has at most half as many bits as a `u32`,
/// or one more.)
fn floor_root(root: u32, n: u32) -> u32 {
    if root as u64 * root as u64 > n as u64 { root - 1 } else { root }
}
