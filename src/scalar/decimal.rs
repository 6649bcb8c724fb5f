//! Decimal text to fixed point, correctly rounded however many digits there are.

use super::is_decimal;

/// A tie of 64 fraction bits ends at the 65th decimal place: of the digits after these places it only matters whether
/// one is not zero.
const PLACES: usize = 66;

/// The sign and the magnitude of a decimal number in units of `2^-fraction_bits`, rounded to nearest, ties to even;
/// `None` if the text is no number or its magnitude is 2^64 or more.
pub(super) fn parse(text: &str, fraction_bits: u32) -> Option<(bool, u128)> {
    if !is_decimal(text) {
        return None;
    }
    let negative = text.starts_with('-');
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    let (mantissa, exponent) = unsigned.split_once(['e', 'E']).unwrap_or((unsigned, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let digits = || whole.bytes().chain(fraction.bytes()).map(|byte| byte - b'0');
    if digits().all(|digit| digit == 0) {
        return Some((negative, 0));
    }
    // The decimal point is before this digit. All exponents that are larger than any text is long have the same effect.
    let shift = exponent.parse::<i32>().unwrap_or(if exponent.starts_with('-') { i32::MIN } else { i32::MAX });
    let point = i64::from(shift) + whole.len() as i64;
    let (mut integer, mut places, mut more) = (0_u128, [0_u8; PLACES], false);
    let mut count = 0;
    for (i, digit) in digits().enumerate() {
        count = i as i64 + 1;
        let place = i as i64 - point;
        if place < 0 {
            integer = integer * 10 + u128::from(digit);
            if integer >> 64 != 0 {
                return None;
            }
        } else if place < PLACES as i64 {
            places[place as usize] = digit;
        } else {
            more |= digit != 0;
        }
    }
    // Zeros up to the point.
    while count < point && integer != 0 {
        integer *= 10;
        if integer >> 64 != 0 {
            return None;
        }
        count += 1;
    }
    // The fraction is doubled repeatedly: each carry is the next bit of the binary number.
    let mut double = || {
        let mut carry = 0;
        for digit in places.iter_mut().rev() {
            let doubled = *digit * 2 + carry;
            carry = doubled / 10;
            *digit = doubled % 10;
        }
        u128::from(carry)
    };
    let mut units = integer;
    for _ in 0..fraction_bits {
        units = (units << 1) | double();
    }
    let half = double() != 0;
    more |= places.iter().any(|digit| *digit != 0);
    let up = half && (more || units & 1 != 0);
    Some((negative, units + u128::from(up)))
}

/// A decimal number: the integer part, and the digits behind the point as an integer of so many places.
#[cfg(any(feature = "serde", units))]
#[derive(Debug, PartialEq)]
pub(super) struct Decimal {
    pub(super) whole: u64,
    pub(super) places: usize,
    pub(super) fraction: u128,
}

/// `magnitude * 2^-fraction_bits` with the fewest places from which [`parse`] gives the same number; at most 20. (The
/// `Display` of `fixed` 1.29 drops digits: two numbers are `440.1` in 16 fraction bits.)
#[cfg(any(feature = "serde", units))]
pub(super) fn shortest(magnitude: u64, fraction_bits: u32) -> Decimal {
    let one = 1_u128 << fraction_bits;
    let mut whole = (u128::from(magnitude) >> fraction_bits) as u64;
    // The part below the last place so far, in units of 2^-fraction_bits of that place.
    let mut rest = u128::from(magnitude) & (one - 1);
    let (mut places, mut fraction, mut power) = (0, 0_u128, 1_u128);
    loop {
        let up = one - rest;
        // The error is less than half a unit.
        if 2 * rest.min(up) < power {
            if up < rest {
                fraction += 1;
            }
            if fraction == power {
                whole += 1;
                fraction = 0;
            }
            return Decimal { whole, places, fraction };
        }
        fraction = fraction * 10 + ((rest * 10) >> fraction_bits);
        rest = (rest * 10) & (one - 1);
        places += 1;
        power *= 10;
    }
}

/// The integer part of `magnitude * 2^-fraction_bits`, and so many decimal places of the rest, cut off; at most 19.
#[cfg(any(feature = "defmt", units))]
pub(super) fn digits(magnitude: u64, fraction_bits: u32, places: u32) -> (u64, u64) {
    let magnitude = u128::from(magnitude);
    let rest = magnitude & ((1 << fraction_bits) - 1);
    // Below 2^64 * 10^19, which is below 2^128.
    let shifted = (rest * 10_u128.pow(places)) >> fraction_bits;
    ((magnitude >> fraction_bits) as u64, shifted as u64)
}

#[cfg(units)]
#[path = "../../tests/units/scalar/decimal.rs"]
mod tests;
