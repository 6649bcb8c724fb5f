//! Decimal text to fixed point, correctly rounded however many digits there are.

use super::is_decimal;

/// A tie of 64 fraction bits ends at the 65th decimal place: what follows these places only says that there is more.
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
    // The point stands before this digit. An exponent beyond all lengths is as good as any other beyond them.
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
    // Twice the fraction, and again: the bit that comes out is the next of the binary number.
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
