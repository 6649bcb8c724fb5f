//! Quadratic surds, compared exactly and enclosed as tightly as needed.

use std::cmp::Ordering;
use std::ops::Neg;

use dashu::base::{BitTest, SquareRoot, UnsignedAbs};
use dashu::integer::{IBig, UBig};
use dashu::rational::RBig;

use super::dyadic::{Dyadic, shifted, sign_of};

/// The number `(p + s * sqrt(D)) / q * 2^e`, exactly; `D >= 0`, `q > 0` and `s` is -1, 0 or 1.
///
/// All but `e` are integers. The power of two stands apart so that one solve can work in its own units of length
/// without shifting every coefficient.
#[derive(Clone, Debug)]
pub struct Root {
    p: IBig,
    s: i8,
    d: IBig,
    q: IBig,
    e: isize,
}

/// The sign of `p + s * sqrt(d)`.
fn sign_with_one_radical(p: &IBig, s: i8, d: &IBig) -> i8 {
    let rational = sign_of(p);
    let radical = if d.is_zero() { 0 } else { s };
    if radical == 0 || rational == radical {
        return rational;
    }
    if rational == 0 {
        return radical;
    }
    // Opposite signs: the larger magnitude wins, and magnitudes compare as their squares do.
    match p.sqr().as_ibig().cmp(d) {
        Ordering::Greater => rational,
        Ordering::Equal => 0,
        Ordering::Less => radical,
    }
}

/// The sign of `p + s1 * sqrt(d1) + s2 * sqrt(d2)`.
fn sign_with_two_radicals(p: &IBig, (s1, d1): (i8, &IBig), (s2, d2): (i8, &IBig)) -> i8 {
    let first = sign_with_one_radical(p, s1, d1);
    let second = if d2.is_zero() { 0 } else { s2 };
    if second == 0 || first == second {
        return first;
    }
    if first == 0 {
        return second;
    }
    // With opposite signs the sign is that of the larger square: (p + s1 sqrt d1)^2 - d2 has only one radical left.
    let square = p.sqr();
    let rational = &square + d1 - d2;
    let radicand = (square * d1) << 2;
    let difference = sign_with_one_radical(&rational, s1 * sign_of(p), &radicand);
    if difference >= 0 { first * difference } else { second }
}

/// `numerator / denominator * 2^exponent`, rounded towards zero to a little more than `bits` bits, and whether that is
/// not exact.
fn quotient(numerator: &UBig, denominator: &UBig, exponent: isize, bits: usize) -> (UBig, isize, bool) {
    let wanted = bits as isize + 2;
    let shift = (wanted + denominator.bit_len() as isize - numerator.bit_len() as isize).max(0);
    let (quotient, remainder) = {
        let dividend = numerator << shift.unsigned_abs();
        (&dividend / denominator, dividend % denominator)
    };
    (quotient, exponent - shift, !remainder.is_zero())
}

impl Root {
    /// `(p + s * sqrt(d)) / q * 2^e` of integers.
    ///
    /// # Panics
    ///
    /// If `d` is negative, `q` is zero or `s` is not -1, 0 or 1.
    pub fn new(p: IBig, s: i8, d: IBig, q: IBig, e: isize) -> Self {
        assert!(
            sign_of(&d) >= 0 && !q.is_zero() && (-1..=1).contains(&s),
            "({p} + {s} sqrt({d})) / {q} is not a real number"
        );
        let (p, s, q) = if sign_of(&q) < 0 { (-p, -s, -q) } else { (p, s, q) };
        let s = if d.is_zero() { 0 } else { s };
        let d = if s == 0 { IBig::ZERO } else { d };
        Self { p, s, d, q, e }
    }

    /// `numerator / denominator * 2^e` of integers.
    ///
    /// # Panics
    ///
    /// If the denominator is zero.
    pub fn quotient(numerator: IBig, denominator: IBig, e: isize) -> Self {
        Self::new(numerator, 0, IBig::ZERO, denominator, e)
    }

    /// `(p + s * sqrt(d)) / q` of rationals.
    ///
    /// # Panics
    ///
    /// If `d` is negative, `q` is zero or `s` is not -1, 0 or 1.
    pub fn from_rationals(p: &RBig, s: i8, d: &RBig, q: &RBig) -> Self {
        // sqrt(n / m) = sqrt(n m) / m; then numerator and denominator are multiplied by both denominators p.. and m.
        let m = d.denominator().as_ibig();
        let radicand = d.numerator() * m;
        let p_denominator = p.denominator().as_ibig();
        let q_denominator = q.denominator().as_ibig();
        Self::new(
            p.numerator() * m * q_denominator,
            s,
            radicand * (p_denominator * q_denominator).sqr(),
            q.numerator() * m * p_denominator,
            0,
        )
    }

    /// A rational.
    pub fn from_rational(value: &RBig) -> Self {
        Self::quotient(value.numerator().clone(), value.denominator().as_ibig().clone(), 0)
    }

    /// `sqrt(value)`.
    ///
    /// # Panics
    ///
    /// If the value is negative.
    pub fn square_root_of(value: &Dyadic) -> Self {
        let odd = value.exponent.rem_euclid(2);
        Self::new(IBig::ZERO, 1, shifted(&value.mantissa, odd), IBig::ONE, (value.exponent - odd) / 2)
    }

    /// The rational and the irrational part: the number is `first + second * sqrt(third)`.
    pub fn parts(&self) -> (RBig, RBig, RBig) {
        let scale = Dyadic::power_of_two(self.e).to_rational();
        let denominator = RBig::from(self.q.clone());
        (
            RBig::from(self.p.clone()) / &denominator * &scale,
            RBig::from(IBig::from(self.s)) / denominator * scale,
            RBig::from(self.d.clone()),
        )
    }

    /// -1, 0 or 1.
    pub fn signum(&self) -> i8 {
        sign_with_one_radical(&self.p, self.s, &self.d)
    }

    /// The number without its sign.
    pub fn magnitude(&self) -> Self {
        if self.signum() < 0 { -self } else { self.clone() }
    }

    /// `self * factor + addend`, such as a coordinate of the point at this parameter of a line.
    pub fn mul_add(&self, factor: &Dyadic, addend: &Dyadic) -> Self {
        let scaled = Dyadic::new(&self.p * &factor.mantissa, self.e + factor.exponent);
        let added = Dyadic::new(&addend.mantissa * &self.q, addend.exponent);
        let e = if added.is_zero() {
            scaled.exponent
        } else {
            // The radical's scale is fixed too, so it bounds the unit even where the rational part vanishes.
            scaled.exponent.min(added.exponent)
        };
        let radical_factor = shifted(&factor.mantissa, scaled.exponent - e);
        Self::new(
            scaled.in_units_of(e) + added.in_units_of(e),
            self.s * sign_of(&radical_factor),
            &self.d * radical_factor.sqr(),
            self.q.clone(),
            e,
        )
    }

    /// How the number compares with a dyadic one.
    pub fn cmp_dyadic(&self, other: &Dyadic) -> Ordering {
        self.cmp(&Self::from(other))
    }

    /// How the number compares with a rational one.
    pub fn cmp_rational(&self, other: &RBig) -> Ordering {
        self.cmp(&Self::from_rational(other))
    }

    /// Bounds `lo <= self <= hi`, at most `2^-bits` times the number apart; equal where the number is zero.
    pub fn enclosure(&self, bits: usize) -> (Dyadic, Dyadic) {
        let sign = self.signum();
        if sign == 0 {
            return (Dyadic::zero(), Dyadic::zero());
        }
        let magnitude = (&self.p).unsigned_abs();
        let q = (&self.q).unsigned_abs();
        let (low, high) = if self.s == 0 {
            let (low, exponent, inexact) = quotient(&magnitude, &q, self.e, bits);
            ((low.clone(), exponent), (low + u8::from(inexact), exponent))
        } else {
            let d = (&self.d).unsigned_abs();
            let shift = (bits + 3).saturating_sub(d.bit_len() / 2);
            let scaled = &d << (2 * shift);
            let root = scaled.sqrt();
            let root_above = &root + u8::from(root.sqr() != scaled);
            let rational = &magnitude << shift;
            if magnitude.is_zero() || sign_of(&self.p) == self.s {
                let e = self.e - shift as isize;
                let (low, low_exponent, _) = quotient(&(&rational + root), &q, e, bits + 1);
                let (high, high_exponent, inexact) = quotient(&(rational + root_above), &q, e, bits + 1);
                ((low, low_exponent), (high + u8::from(inexact), high_exponent))
            } else {
                // p + s sqrt(D) cancels; (p^2 - D) / (p - s sqrt(D)) is the same number and does not.
                let numerator = (self.p.sqr().as_ibig() - &self.d).unsigned_abs() << shift;
                let below = (&rational + root) * &q;
                let above = (rational + root_above) * q;
                let (low, low_exponent, _) = quotient(&numerator, &above, self.e, bits + 1);
                let (high, high_exponent, inexact) = quotient(&numerator, &below, self.e, bits + 1);
                ((low, low_exponent), (high + u8::from(inexact), high_exponent))
            }
        };
        let low = Dyadic::new(IBig::from(low.0), low.1);
        let high = Dyadic::new(IBig::from(high.0), high.1);
        if sign > 0 { (low, high) } else { (-&high, -&low) }
    }

    /// A dyadic within `2^-bits` times the number of the number.
    pub fn approximation(&self, bits: usize) -> Dyadic {
        let (low, high) = self.enclosure(bits);
        (&low + &high).scaled(-1)
    }

    /// The nearest `f64`, to within two units of its last place; for reports, never for decisions.
    pub fn to_f64(&self) -> f64 {
        self.approximation(80).to_f64()
    }

    /// The greatest `n` with `2^n <= |self|`; none for zero.
    pub fn binary_exponent(&self) -> Option<isize> {
        let magnitude = self.magnitude();
        let (low, high) = magnitude.enclosure(32);
        if low.is_zero() {
            return None;
        }
        let leading = |value: &Dyadic| value.exponent + value.mantissa.bit_len() as isize - 1;
        let above = leading(&high);
        if leading(&low) == above || magnitude.cmp_dyadic(&Dyadic::power_of_two(above)) != Ordering::Less {
            Some(above)
        } else {
            Some(above - 1)
        }
    }

    /// The spacing of `f32` in the binade that holds the number: a power of two, at least 2^-149.
    pub fn ulp_f32(&self) -> Dyadic {
        self.ulp(23, -149)
    }

    /// The spacing of `f64` in the binade that holds the number: a power of two, at least 2^-1074.
    pub fn ulp_f64(&self) -> Dyadic {
        self.ulp(52, -1074)
    }

    fn ulp(&self, fraction_bits: isize, least: isize) -> Dyadic {
        let spacing = self.binary_exponent().map_or(least, |n| n - fraction_bits);
        Dyadic::power_of_two(spacing.max(least))
    }

    /// The multiple of the unit nearest to the number, in units; of two equally near, the even one.
    ///
    /// # Panics
    ///
    /// If the unit is not positive.
    pub fn nearest_multiple(&self, unit: &Dyadic) -> IBig {
        let in_units = self.divided_by(unit);
        let magnitude_bits = in_units.binary_exponent().unwrap_or(0).max(0).unsigned_abs();
        let near = in_units.approximation(magnitude_bits + 8);
        // The approximation is off by far less than one, so the answer is its floor or the integer above.
        let floor = shifted(&near.mantissa, near.exponent.min(0)) << near.exponent.max(0).unsigned_abs();
        let floor = if in_units.cmp_dyadic(&Dyadic::new(floor.clone(), 0)) == Ordering::Less {
            floor - IBig::ONE
        } else if in_units.cmp_dyadic(&Dyadic::new(&floor + IBig::ONE, 0)) != Ordering::Less {
            floor + IBig::ONE
        } else {
            floor
        };
        let half = Dyadic::new((&floor << 1usize) + IBig::ONE, -1);
        let odd = !floor.is_zero() && floor.trailing_zeros() == Some(0);
        match in_units.cmp_dyadic(&half) {
            Ordering::Less => floor,
            Ordering::Equal if !odd => floor,
            _ => floor + IBig::ONE,
        }
    }

    /// `|value - self| / unit`; only the last step, the conversion to `f64`, rounds.
    ///
    /// # Panics
    ///
    /// If the unit is not positive.
    pub fn error_in(&self, value: &Dyadic, unit: &Dyadic) -> f64 {
        let difference = self.mul_add(&Dyadic::from(1), &-value);
        difference.divided_by(unit).magnitude().to_f64()
    }

    /// `self / unit`, for a positive unit.
    fn divided_by(&self, unit: &Dyadic) -> Self {
        assert!(unit.signum() > 0, "{unit:?} is not a unit");
        Self { q: &self.q * &unit.mantissa, e: self.e - unit.exponent, ..self.clone() }
    }
}

impl From<&Dyadic> for Root {
    fn from(value: &Dyadic) -> Self {
        Self::quotient(value.mantissa.clone(), IBig::ONE, value.exponent)
    }
}

impl Neg for &Root {
    type Output = Root;

    fn neg(self) -> Root {
        Root { p: -&self.p, s: -self.s, ..self.clone() }
    }
}

impl Ord for Root {
    fn cmp(&self, other: &Self) -> Ordering {
        // A number of the other sign needs no arithmetic, and zeros must not bring in a distant exponent.
        let (left_sign, right_sign) = (self.signum(), other.signum());
        if left_sign != right_sign || left_sign == 0 {
            return left_sign.cmp(&right_sign);
        }
        let e = self.e.min(other.e);
        let left_factor = shifted(&other.q, self.e - e);
        let right_factor = shifted(&self.q, other.e - e);
        let rational = &self.p * &left_factor - &other.p * &right_factor;
        let radicand = |root: &Self, factor: &IBig| {
            if root.s == 0 { IBig::ZERO } else { &root.d * factor.sqr() }
        };
        sign_with_two_radicals(
            &rational,
            (self.s, &radicand(self, &left_factor)),
            (-other.s, &radicand(other, &right_factor)),
        )
        .cmp(&0)
    }
}

impl PartialOrd for Root {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for Root {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other) == Ordering::Equal
    }
}

impl Eq for Root {}
