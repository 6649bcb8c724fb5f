//! Dyadic rationals: every finite floating-point and fixed-point number is one, and sums and products stay within them.
//!
//! They are kept apart from general rationals because they need no greatest common divisor, which would otherwise
//! cost more than all the rest of a solve.

use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

use dashu::base::{BitTest, Sign};
use dashu::integer::{IBig, UBig};
use dashu::rational::RBig;

/// The number `mantissa * 2^exponent`, exactly.
///
/// The same number has many representations; comparison is by value.
#[derive(Clone, Debug)]
pub struct Dyadic {
    /// The integer factor.
    pub mantissa: IBig,
    /// The power of two that it is scaled by.
    pub exponent: isize,
}

/// -1, 0 or 1, as the integer is negative, zero or positive.
pub fn sign_of(value: &IBig) -> i8 {
    if value.is_zero() {
        0
    } else if value.sign() == Sign::Negative {
        -1
    } else {
        1
    }
}

/// `value * 2^bits`, rounded down where `bits` is negative.
pub fn shifted(value: &IBig, bits: isize) -> IBig {
    if bits >= 0 { value << bits.unsigned_abs() } else { value >> bits.unsigned_abs() }
}

impl Dyadic {
    /// `mantissa * 2^exponent`.
    pub fn new(mantissa: impl Into<IBig>, exponent: isize) -> Self {
        Self { mantissa: mantissa.into(), exponent }
    }

    /// Zero.
    pub fn zero() -> Self {
        Self::new(0, 0)
    }

    /// `2^exponent`.
    pub fn power_of_two(exponent: isize) -> Self {
        Self::new(1, exponent)
    }

    /// -1, 0 or 1.
    pub fn signum(&self) -> i8 {
        sign_of(&self.mantissa)
    }

    /// Whether the number is zero.
    pub fn is_zero(&self) -> bool {
        self.mantissa.is_zero()
    }

    /// The number squared.
    pub fn squared(&self) -> Self {
        Self::new(self.mantissa.sqr(), 2 * self.exponent)
    }

    /// The number without its sign.
    pub fn magnitude(&self) -> Self {
        if self.signum() < 0 { -self } else { self.clone() }
    }

    /// The number times `2^bits`.
    pub fn scaled(&self, bits: isize) -> Self {
        Self::new(self.mantissa.clone(), self.exponent + bits)
    }

    /// The number in units of `2^exponent`, which must divide it.
    pub fn in_units_of(&self, exponent: isize) -> IBig {
        if self.is_zero() {
            return IBig::ZERO;
        }
        let shift = self.exponent - exponent;
        debug_assert!(
            shift >= 0 || self.mantissa.trailing_zeros().unwrap() >= shift.unsigned_abs(),
            "2^{exponent} does not divide {self:?}"
        );
        shifted(&self.mantissa, shift)
    }

    /// The number as a rational in lowest terms.
    pub fn to_rational(&self) -> RBig {
        if self.exponent >= 0 {
            RBig::from(shifted(&self.mantissa, self.exponent))
        } else {
            RBig::from_parts(self.mantissa.clone(), UBig::ONE << self.exponent.unsigned_abs())
        }
    }

    /// The nearest `f64`, to within two units of its last place; for reports, never for decisions.
    pub fn to_f64(&self) -> f64 {
        let length = self.mantissa.bit_len() as isize;
        let excess = (length - 64).max(0);
        let leading = shifted(&self.mantissa, -excess).to_f64().value();
        let exponent = (self.exponent + excess).clamp(-4000, 4000) as i32;
        // One factor of 2^-1100 is already zero, so the scale is applied in steps that each stay finite.
        let mut scaled = leading;
        let mut left = exponent;
        while left != 0 {
            let step = left.clamp(-500, 500);
            scaled *= 2f64.powi(step);
            left -= step;
        }
        scaled
    }
}

/// The greatest exponent, of those occurring, that measures all the numbers in whole units.
pub fn common_exponent<'a>(numbers: impl IntoIterator<Item = &'a Dyadic>) -> isize {
    numbers.into_iter().filter(|number| !number.is_zero()).map(|number| number.exponent).min().unwrap_or(0)
}

fn decoded(negative: bool, magnitude: u64, exponent: isize) -> Dyadic {
    if magnitude == 0 {
        return Dyadic::zero();
    }
    // Without its trailing zeros, 1.0 is one bit instead of 24, and products of such numbers stay short.
    let zeros = magnitude.trailing_zeros();
    let odd = IBig::from(magnitude >> zeros);
    Dyadic::new(if negative { -odd } else { odd }, exponent + zeros as isize)
}

/// The exact value of an `f32`.
///
/// # Panics
///
/// If it is not finite.
pub fn exact_f32(value: f32) -> Dyadic {
    assert!(value.is_finite(), "{value} is not a number to compute with");
    let bits = value.to_bits();
    let field = (bits >> 23) & 0xff;
    let fraction = u64::from(bits & 0x7f_ffff);
    let (magnitude, field) = if field == 0 { (fraction, 1) } else { (fraction | 1 << 23, field) };
    decoded(bits >> 31 == 1, magnitude, field as isize - 150)
}

/// The exact value of an `f64`.
///
/// # Panics
///
/// If it is not finite.
pub fn exact_f64(value: f64) -> Dyadic {
    assert!(value.is_finite(), "{value} is not a number to compute with");
    let bits = value.to_bits();
    let field = (bits >> 52) & 0x7ff;
    let fraction = bits & 0xf_ffff_ffff_ffff;
    let (magnitude, field) = if field == 0 { (fraction, 1) } else { (fraction | 1 << 52, field) };
    decoded(bits >> 63 == 1, magnitude, field as isize - 1075)
}

/// The exact value of a fixed-point number, `raw / 2^fraction_bits`.
pub fn exact_fixed(raw: i128, fraction_bits: u32) -> Dyadic {
    if raw == 0 {
        return Dyadic::zero();
    }
    let zeros = raw.trailing_zeros();
    Dyadic::new(raw >> zeros, zeros as isize - fraction_bits as isize)
}

impl From<i64> for Dyadic {
    fn from(value: i64) -> Self {
        Self::new(value, 0)
    }
}

fn aligned(left: &Dyadic, right: &Dyadic) -> (IBig, IBig, isize) {
    let exponent = common_exponent([left, right]);
    (left.in_units_of(exponent), right.in_units_of(exponent), exponent)
}

impl Add for &Dyadic {
    type Output = Dyadic;

    fn add(self, other: &Dyadic) -> Dyadic {
        let (left, right, exponent) = aligned(self, other);
        Dyadic::new(left + right, exponent)
    }
}

impl Sub for &Dyadic {
    type Output = Dyadic;

    fn sub(self, other: &Dyadic) -> Dyadic {
        let (left, right, exponent) = aligned(self, other);
        Dyadic::new(left - right, exponent)
    }
}

impl Mul for &Dyadic {
    type Output = Dyadic;

    fn mul(self, other: &Dyadic) -> Dyadic {
        Dyadic::new(&self.mantissa * &other.mantissa, self.exponent + other.exponent)
    }
}

impl Neg for &Dyadic {
    type Output = Dyadic;

    fn neg(self) -> Dyadic {
        Dyadic::new(-&self.mantissa, self.exponent)
    }
}

impl Ord for Dyadic {
    fn cmp(&self, other: &Self) -> Ordering {
        let (left, right, _) = aligned(self, other);
        left.cmp(&right)
    }
}

impl PartialOrd for Dyadic {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Dyadic {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Dyadic {}
