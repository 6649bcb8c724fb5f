//! Angle, sine, cosine and power in integers, for the fixed-point types.
//!
//! All use shifts and additions (Volder, *The CORDIC Trigonometric Computing Technique*, 1959): a loop with a fixed
//! number of steps, one table for every width, the same bits on every machine. Angles are in turns: a whole turn is
//! 2^64, so that they wrap around without a test.

/// `atan(2^-i)` in turns, in units of 2^-64.
const ARC_TANGENT: [u64; 64] = [
    0x2000000000000000,
    0x12e4051d9df30866,
    0x09fb385b5ee39e8e,
    0x051111d41ddd9a1b,
    0x028b0d430e589aed,
    0x0145d7e159046278,
    0x00a2f61e5c28262a,
    0x00517c5511d442af,
    0x0028be5346d0c337,
    0x00145f2ebb30ab38,
    0x000a2f980091ba7b,
    0x000517cc14a80cb7,
    0x00028be60cdfec62,
    0x000145f306c172f2,
    0x0000a2f9836ae911,
    0x0000517cc1b6ba7c,
    0x000028be60db85fc,
    0x0000145f306dc816,
    0x00000a2f9836e4ae,
    0x00000517cc1b726b,
    0x0000028be60db938,
    0x00000145f306dc9c,
    0x000000a2f9836e4e,
    0x000000517cc1b727,
    0x00000028be60db94,
    0x000000145f306dca,
    0x0000000a2f9836e5,
    0x0000000517cc1b72,
    0x000000028be60db9,
    0x0000000145f306dd,
    0x00000000a2f9836e,
    0x00000000517cc1b7,
    0x0000000028be60dc,
    0x00000000145f306e,
    0x000000000a2f9837,
    0x000000000517cc1b,
    0x00000000028be60e,
    0x000000000145f307,
    0x0000000000a2f983,
    0x0000000000517cc2,
    0x000000000028be61,
    0x0000000000145f30,
    0x00000000000a2f98,
    0x00000000000517cc,
    0x0000000000028be6,
    0x00000000000145f3,
    0x000000000000a2fa,
    0x000000000000517d,
    0x00000000000028be,
    0x000000000000145f,
    0x0000000000000a30,
    0x0000000000000518,
    0x000000000000028c,
    0x0000000000000146,
    0x00000000000000a3,
    0x0000000000000051,
    0x0000000000000029,
    0x0000000000000014,
    0x000000000000000a,
    0x0000000000000005,
    0x0000000000000003,
    0x0000000000000001,
    0x0000000000000001,
    0x0000000000000000,
];

/// The product of `1 / sqrt(1 + 4^-i)`, by which the rotations lengthen a vector, inverted; in Q2.62.
const GAIN: i64 = 0x26dd3b6a10d7969a;

/// `2^(2^-(i+1))` in Q2.62.
const POWER_OF_TWO: [u64; 62] = [
    0x5a827999fcef3242,
    0x4c1bf828c6dc54b8,
    0x45cae0f1f545eb73,
    0x42d561b3e6243d8a,
    0x4166c34c5615d0ec,
    0x40b268f9de0183ba,
    0x4058f6a7ecccd5b6,
    0x402c6be96af2fb58,
    0x4016321b687027a8,
    0x400b18178ba33b14,
    0x40058bce410147e8,
    0x4002c5d7bff71daf,
    0x400162e807ee7e5b,
    0x4000b1730df6a524,
    0x400058b9497b8152,
    0x40002c5c955dd701,
    0x4000162e46d6f26c,
    0x40000b1722757b1b,
    0x4000058b90fd3e0c,
    0x400002c5c86f3f26,
    0x40000162e433c79b,
    0x400000b17218edd0,
    0x40000058b90c3968,
    0x4000002c5c860d54,
    0x400000162e4302d2,
    0x4000000b17218073,
    0x400000058b90bffc,
    0x40000002c5c85fef,
    0x4000000162e42ff3,
    0x40000000b17217f9,
    0x4000000058b90bfc,
    0x400000002c5c85fe,
    0x40000000162e42ff,
    0x400000000b17217f,
    0x40000000058b90c0,
    0x4000000002c5c860,
    0x400000000162e430,
    0x4000000000b17218,
    0x400000000058b90c,
    0x40000000002c5c86,
    0x4000000000162e43,
    0x40000000000b1721,
    0x4000000000058b91,
    0x400000000002c5c8,
    0x40000000000162e4,
    0x400000000000b172,
    0x40000000000058b9,
    0x4000000000002c5d,
    0x400000000000162e,
    0x4000000000000b17,
    0x400000000000058c,
    0x40000000000002c6,
    0x4000000000000163,
    0x40000000000000b1,
    0x4000000000000059,
    0x400000000000002c,
    0x4000000000000016,
    0x400000000000000b,
    0x4000000000000006,
    0x4000000000000003,
    0x4000000000000001,
    0x4000000000000001,
];

/// One in Q2.62.
const ONE: u64 = 1 << 62;

/// The angle of (x, y), in units of 2^-64 turns; the magnitudes must be below 2^61.
///
/// `steps` is the number of bits wanted; components should use their upper bits.
pub(super) fn angle(y: i64, x: i64, steps: usize) -> u64 {
    if x == 0 && y == 0 {
        return 0;
    }
    // Half a turn brings the vector into the right half plane, where the rotations converge.
    let (mut x, mut y, mut angle) = if x < 0 { (-x, -y, 1 << 63) } else { (x, y, 0_u64) };
    for (i, arc) in ARC_TANGENT.iter().enumerate().take(steps) {
        if y == 0 {
            break;
        }
        let (dx, dy) = (y >> i, x >> i);
        if y > 0 {
            (x, y, angle) = (x + dx, y - dy, angle.wrapping_add(*arc));
        } else {
            (x, y, angle) = (x - dx, y + dy, angle.wrapping_sub(*arc));
        }
    }
    angle
}

/// Sine and cosine in Q2.62 of an angle in units of 2^-64 turns.
pub(super) fn sine_cosine(angle: u64, steps: usize) -> (i64, i64) {
    // The quadrant is subtracted first, exactly; the remaining angle is within an eighth of a turn.
    let quadrant = angle.wrapping_add(1 << 61) >> 62;
    let mut rest = angle.wrapping_sub(quadrant << 62) as i64;
    let (mut x, mut y) = (GAIN, 0_i64);
    if rest == 0 {
        x = ONE as i64;
    } else {
        for (i, arc) in ARC_TANGENT.iter().enumerate().take(steps) {
            let (dx, dy) = (y >> i, x >> i);
            if rest >= 0 {
                (x, y, rest) = (x - dx, y + dy, rest - *arc as i64);
            } else {
                (x, y, rest) = (x + dx, y - dy, rest + *arc as i64);
            }
        }
    }
    match quadrant & 3 {
        0 => (y, x),
        1 => (x, -y),
        2 => (-y, -x),
        _ => (-x, y),
    }
}

/// `base^(exponent * 2^-fraction)` in Q2.62 for a base of 0 to 1 in Q2.62 and an exponent of at least zero.
pub(super) fn power(base: u64, exponent: u64, fraction: u32) -> u64 {
    if exponent == 0 || base >= ONE {
        return ONE;
    }
    if base == 0 {
        return 0;
    }
    let product = |a: u64, b: u64| ((a as u128 * b as u128) >> 62) as u64;
    // log2(base) = whole + bits: the bits one at a time, by squaring.
    let shift = base.leading_zeros() - 1;
    let mut x = base << shift;
    let mut bits = 0_u64;
    for _ in 0..62 {
        x = product(x, x);
        bits <<= 1;
        if x >> 63 != 0 {
            x >>= 1;
            bits |= 1;
        }
    }
    // -log2(base), in Q7.62, times the exponent: base = 2^-(shift - bits).
    let negative_log = ((shift as u128) << 62) - bits as u128;
    let (high, low) = (negative_log >> 32, negative_log & 0xffff_ffff);
    // Below 2^-63 the result is zero in every type, so that a saturated product gives the same result as the true one.
    let scaled = (high.saturating_mul(exponent as u128)).saturating_add((low * exponent as u128) >> 32);
    let scaled = if fraction >= 32 { scaled >> (fraction - 32) } else { scaled.saturating_mul(1 << (32 - fraction)) };
    let whole = scaled >> 62;
    if whole > 62 {
        return 0;
    }
    // 2^-(whole + part) = 2^(1 - part) / 2^(whole + 1)
    let part = (scaled as u64) & (ONE - 1);
    let mut value = ONE;
    let mut rising = ONE - part;
    let mut whole = whole as u32 + 1;
    if part == 0 {
        (rising, whole) = (0, whole - 1);
    }
    for (i, factor) in POWER_OF_TWO.iter().enumerate() {
        if rising & (ONE >> (i + 1)) != 0 {
            value = product(value, *factor);
        }
    }
    if whole > 62 { 0 } else { value >> whole }
}

#[cfg(units)]
#[path = "../../tests/units/scalar/elementary.rs"]
mod tests;
