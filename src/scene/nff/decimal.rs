//! Fast reading and comparison of decimal numbers of up to 19 digits, which nearly all numbers of scene files are.
//!
//! Scalars read any decimal ([`Scalar::parse_scaled`]), those of fixed point digit by digit and bit by bit. This module
//! gives the same value, to the bit, in a small fraction of the time.

use crate::number::Limbs;
use crate::scalar::{Real, Scalar};

/// `digits * 10^exponent`, and less than a unit of the last digit more if it is not exact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Decimal {
    negative: bool,
    digits: u64,
    exponent: i32,
    exact: bool,
}

/// The decimal place of a number's first digit, and the digits, aligned to the left: ordered as magnitudes are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Magnitude {
    place: i32,
    aligned: u64,
}

/// Any 19 digits fit into 64 bits.
const DIGITS: u32 = 19;

/// A number with 19 digits or more takes no further digit.
const FULL: u64 = 10_u64.pow(DIGITS - 1);

/// Exponents of more digits than these are left to [`Scalar::parse_scaled`].
const LARGEST_EXPONENT: i32 = 9999;

const POWERS_OF_TEN: [u64; DIGITS as usize + 1] = {
    let mut powers = [1_u64; DIGITS as usize + 1];
    let mut i = 1;
    while i < powers.len() {
        powers[i] = powers[i - 1] * 10;
        i += 1;
    }
    powers
};

fn power_of_ten(exponent: u32) -> Option<u64> {
    POWERS_OF_TEN.get(exponent as usize).copied()
}

impl Decimal {
    /// `None` if the text is no number, or its exponent is out of all bounds.
    pub(super) fn parse(text: &str) -> Option<Self> {
        let (negative, mut rest) = signed(text.as_bytes());
        let (mut digits, mut shift, mut exponent) = (0_u64, 0_i32, 0_i32);
        let (mut point, mut any, mut exact) = (false, false, true);
        while let Some((byte, behind)) = rest.split_first() {
            rest = behind;
            match byte {
                b'0'..=b'9' => {
                    let digit = u64::from(byte - b'0');
                    any = true;
                    if digits < FULL {
                        digits = digits * 10 + digit;
                        shift = shift.saturating_sub(i32::from(point));
                    } else {
                        exact &= digit == 0;
                        shift = shift.saturating_add(i32::from(!point));
                    }
                }
                b'.' if !point => point = true,
                b'e' | b'E' => {
                    exponent = exponent_of(rest)?;
                    break;
                }
                _ => return None,
            }
        }
        any.then_some(Self { negative, digits, exponent: shift.saturating_add(exponent), exact })
    }

    /// False for a number of more than 19 significant digits.
    pub(super) const fn is_exact(self) -> bool {
        self.exact
    }

    /// `None` for zero.
    pub(super) fn magnitude(self) -> Option<Magnitude> {
        let last = self.digits.checked_ilog10()?;
        let aligned = self.digits.saturating_mul(power_of_ten((DIGITS - 1).saturating_sub(last))?);
        Some(Magnitude { place: self.exponent.saturating_add(last as i32), aligned })
    }

    /// The number times `2^power` in a fixed-point type, as [`Scalar::parse_scaled`] rounds it; `None` if that function
    /// must be used instead.
    fn fixed<S: Scalar>(self, power: i32) -> Option<S> {
        if !self.exact {
            return None;
        }
        let unit = S::last_place(0);
        let bits = u32::try_from(power.checked_sub(unit)?).ok().filter(|bits| *bits <= 64)?;
        if self.digits == 0 {
            return Some(S::ZERO);
        }
        let factor = power_of_ten(self.exponent.unsigned_abs())?;
        let (digits, divisor) =
            if self.exponent > 0 { (self.digits.checked_mul(factor)?, 1) } else { (self.digits, factor) };
        let (units, rest) = if bits <= digits.leading_zeros() {
            let numerator = digits << bits;
            let units = numerator.checked_div(divisor)?;
            (units, numerator.wrapping_sub(units.wrapping_mul(divisor)))
        } else {
            let numerator = u128::from(digits) << bits;
            let units = u64::try_from(numerator.checked_div(u128::from(divisor))?).ok()?;
            // It is less than the divisor, so that its upper half is zero.
            (units, (numerator as u64).wrapping_sub(units.wrapping_mul(divisor)))
        };
        // Ties to even. Twice the rest may be more than 64 bits hold.
        let missing = divisor.saturating_sub(rest);
        let up = rest > missing || rest == missing && units & 1 != 0;
        let units = units.checked_add(u64::from(up))?;
        let value = S::from_limbs::<u64>(Limbs::from_integer(units, unit, self.negative));
        value.is_finite().then_some(value)
    }

    /// The digits from the decimal place `place` to the eighth place after it, as an integer with the number's sign.
    /// There must be no digit before that place.
    pub(super) fn leading<R: Real>(self, place: i32) -> R {
        let dropped = place.saturating_sub(8).saturating_sub(self.exponent);
        let digits = match power_of_ten(dropped.unsigned_abs()) {
            Some(factor) if dropped > 0 => self.digits.checked_div(factor).unwrap_or(0),
            Some(factor) => self.digits.saturating_mul(factor),
            None => 0,
        };
        let integer = i32::try_from(digits).unwrap_or(i32::MAX);
        R::from_int(if self.negative { -integer } else { integer })
    }
}

impl Magnitude {
    /// The decimal place of the first digit: 0 for 1 to 9, 1 for 10 to 99.
    pub(super) const fn place(self) -> i32 {
        self.place
    }
}

/// The sign, true for a minus, and the text after it.
const fn signed(text: &[u8]) -> (bool, &[u8]) {
    match text {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        all => (false, all),
    }
}

/// The exponent after an `e`.
fn exponent_of(text: &[u8]) -> Option<i32> {
    let (negative, unsigned) = signed(text);
    let mut exponent = (!unsigned.is_empty()).then_some(0_i32)?;
    for byte in unsigned {
        let digit = byte.checked_sub(b'0').filter(|digit| *digit <= 9)?;
        exponent = exponent * 10 + i32::from(digit);
        if exponent > LARGEST_EXPONENT {
            return None;
        }
    }
    Some(if negative { -exponent } else { exponent })
}

/// As [`Scalar::parse_scaled`], but faster in fixed point.
pub(super) fn parse_scaled<S: Scalar>(text: &str, power: i32) -> Option<S> {
    if S::RELATIVE {
        return S::parse_scaled(text, power);
    }
    let soon = Decimal::parse(text).and_then(|decimal| decimal.fixed(power));
    soon.or_else(|| S::parse_scaled(text, power))
}

#[cfg(all(units, feature = "fixed"))]
#[path = "../../../tests/units/scene/nff/decimal.rs"]
mod tests;
