//! `f32` and `f64` as scalars: plain arithmetic, and error-free sums and products for ill-conditioned cases.

use super::error_free::{exact_f32, exact_f64};
use super::scanline::InNumbers;
use super::slabs::Slabs;
use super::square_root::square_root_f32;
use super::{
    Budget, Computing, Culling, Elementary, Numbers, Real, Scalar, UnitScalar, ValueError, largest, sealed::Sealed,
};
use crate::ladder::Floats;
use crate::number::word::Word;
use crate::number::{Limbs, Parts, Ring, Robust, cross, difference, dot};

/// Defines the float implementations.
macro_rules! float {
    (
        $Float:ident, $exact:ident, $bits:ty, $mantissa:literal, $bias:literal, $largest_exponent:literal,
        $slope:literal, $robust:ty, $instructions:ident,
        sqrt: $sqrt:path, atan2: $atan2:path, sincos: $sincos:path, pow: $pow:path
    ) => {
        impl Sealed for $Float {}

        impl Numbers for $Float {
            type Unit = $Float;
            type Real = $Float;
        }

        impl Scalar for $Float {
            type Robust = Robust<$robust>;
            type Tiers = Floats;
            type Scanline = InNumbers<Self>;
            const ZERO: Self = 0.0;
            const ROUNDED_ONE: Self = 1.0;
            const INFINITY: Self = $Float::INFINITY;
            const RELATIVE: bool = true;
            const BUDGET: Budget<Self> = Budget {
                coordinate: $Float::from_bits((($largest_exponent + $bias) as $bits) << $mantissa),
                size: $Float::from_bits((($largest_exponent + $bias) as $bits) << $mantissa),
                smallest_size: $Float::from_bits(1),
                slope: $Float::from_bits((($slope + $bias) as $bits) << $mantissa),
                smallest_slope: $Float::from_bits((($bias - $slope) as $bits) << $mantissa),
                distance: $Float::MAX,
            };
            #[inline(always)]
            fn is_finite(self) -> bool {
                $Float::is_finite(self)
            }
            #[inline]
            fn parts(self) -> Parts {
                const FRACTION: $bits = (1 << $mantissa) - 1;
                let bits = self.to_bits();
                let (field, fraction) = (((bits >> $mantissa) & (2 * $bias + 1)) as i32, bits & FRACTION);
                let mantissa = if field == 0 { fraction } else { fraction | (1 << $mantissa) };
                let exponent = field.max(1) - $bias - $mantissa;
                Parts { mantissa: mantissa as u64, exponent, negative: self.is_sign_negative() }
            }
            #[inline(always)]
            fn unit_parts(value: Self) -> Parts {
                value.parts()
            }
            #[inline]
            fn from_limbs<W: Word>(value: Limbs<W>) -> Self {
                // The fraction, and above it the exponent's field. A subnormal number or a carry changes that field
                // without a test.
                const LEAST: i32 = 1 - $bias - $mantissa;
                let unit = Self::last_place(value.exponent());
                let field = unit.saturating_sub(LEAST);
                let Some(units) = value.to_units(unit).filter(|_| field < 2 * $bias) else {
                    return if value.is_negative() { -Self::INFINITY } else { Self::INFINITY };
                };
                let magnitude = Self::from_bits(((field as $bits) << $mantissa) + units as $bits);
                if value.is_negative() && !value.is_zero() { -magnitude } else { magnitude }
            }
            #[inline]
            fn from_robust(value: Self::Robust) -> Self {
                Self::from_limbs(value)
            }
            #[inline]
            fn unit_from_limbs<W: Word>(value: Limbs<W>) -> Self {
                Self::from_limbs(value)
            }
            #[inline]
            fn unit_from_robust(value: Self::Robust) -> Self {
                Self::from_limbs(value)
            }
            #[inline(always)]
            fn last_place(top: i32) -> i32 {
                let (last, least) = (top - 1 - $mantissa, 1 - $bias - $mantissa);
                if last > least { last } else { least }
            }
            #[inline(always)]
            fn real(self) -> Self {
                self
            }
            #[inline(always)]
            fn round(value: Self) -> Self {
                value
            }
            #[inline(always)]
            fn unit_real(value: Self) -> Self {
                value
            }
            #[inline(always)]
            fn unit_round(value: Self) -> Self {
                value
            }
            #[inline(always)]
            fn plus(self, other: Self) -> Self {
                self + other
            }
            #[inline(always)]
            fn minus(self, other: Self) -> Self {
                self - other
            }
            #[inline(always)]
            fn next_up(self) -> Self {
                $Float::next_up(self)
            }
            #[inline(always)]
            fn magnitude(self) -> Self {
                $Float::abs(self)
            }
            fn parse_scaled(text: &str, power: i32) -> Option<Self> {
                if !super::is_decimal(text) {
                    return None;
                }
                // Exact, unless the result is subnormal.
                let value = Ring::scaled(text.parse::<Self>().ok()?, power);
                Some(value).filter(|value| Scalar::is_finite(*value))
            }
            #[allow(clippy::unnecessary_cast, reason = "necessary for `f32`")]
            fn from_f64(value: f64) -> Result<Self, ValueError> {
                let rounded = value as $Float;
                match Scalar::is_finite(rounded) {
                    true => Ok(rounded),
                    false if value.is_finite() => Err(ValueError::BeyondType),
                    false => Err(ValueError::NotFinite),
                }
            }
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
        }

        impl Culling for $Float {
            type Slabs = Slabs<$Float, $Float>;
            #[inline(always)]
            fn slabs(o: [Self; 3], d: [Self; 3]) -> Self::Slabs {
                Slabs::<$Float, $Float>::new(o, d)
            }
            #[inline(always)]
            fn misses_box(slabs: &Self::Slabs, range: [Self; 2], centre: [Self; 3], half: [Self; 3]) -> bool {
                slabs.misses(range, centre, half)
            }
            #[inline(always)]
            fn passes_axis(o: [Self; 3], d: [Self; 3], position: [Self; 3], axis: [Self; 3], r: Self) -> bool {
                passes_axis(o, d, position, axis, r)
            }
        }

        impl Computing for $Float {
            #[inline(always)]
            fn resolves(t: Self, size: Self) -> bool {
                $Float::abs(t) <= 4.0 * size
            }
            #[inline(always)]
            fn resolves_turn(t: Self, radius: Self) -> bool {
                Self::resolves(t, radius)
            }
            #[inline(always)]
            fn dot(o: [Self; 3], d: [Self; 3]) -> Self {
                o[0] * d[0] + o[1] * d[1] + o[2] * d[2]
            }
            #[inline(always)]
            fn cross(o: [Self; 3], d: [Self; 3]) -> [Self; 3] {
                [o[1] * d[2] - o[2] * d[1], o[2] * d[0] - o[0] * d[2], o[0] * d[1] - o[1] * d[0]]
            }
            #[inline(always)]
            fn unit_dot(d: [Self; 3], e: [Self; 3]) -> Self {
                Self::dot(d, e)
            }
            #[inline]
            fn advance(o: [Self; 3], d: [Self; 3], t: Self) -> [Self; 3] {
                let step = |o: Self, d: Self| {
                    let (p, e) = $exact::two_product(t, d);
                    let (s, f) = $exact::two_sum(o, p);
                    let correction = e + f;
                    // At the end of the float range the error terms overflow; then the plain sum is the result.
                    if Scalar::is_finite(correction) { s + correction } else { s }
                };
                [step(o[0], d[0]), step(o[1], d[1]), step(o[2], d[2])]
            }
            #[inline]
            fn approach(o: [Self; 3], base: [Self; 3], d: [Self; 3], t: Self) -> [Self; 3] {
                let step = |o: Self, base: Self, d: Self| {
                    let (from_base, e) = $exact::two_sum(o, -base);
                    let (p, f) = $exact::two_product(t, d);
                    let (s, g) = $exact::two_sum(from_base, p);
                    let correction = e + f + g;
                    if Scalar::is_finite(correction) { s + correction } else { s }
                };
                [step(o[0], base[0], d[0]), step(o[1], base[1], d[1]), step(o[2], base[2], d[2])]
            }
            #[inline(always)]
            fn approach_exactly(o: [Self; 3], base: [Self; 3], d: [Self; 3], t: Self) -> [Self; 3] {
                Self::approach(o, base, d, t)
            }
            #[inline(always)]
            fn approach_along(o: [Self; 3], base: [Self; 3], d: [Self; 3], t: Self, axes: [[Self; 3]; 3]) -> [Self; 3] {
                let v = Self::approach(o, base, d, t);
                axes.map(|axis| Self::dot(v, axis))
            }
            #[inline(always)]
            fn times(component: Self, by: Self) -> Self {
                component * by
            }
            #[inline]
            fn normalize(v: [Self; 3]) -> Option<([Self; 3], Self)> {
                let longest = largest(v);
                if !(longest > 0.0 && v.iter().all(|c| Scalar::is_finite(*c))) {
                    return None;
                }
                // A power of two near the longest component keeps every square in range and changes no bit.
                let e = Self::binary_exponent(longest);
                let [x, y, z] = v.map(|c| $exact::scale(c, -e));
                let length = (x * x + y * y + z * z).sqrt();
                Some(([x / length, y / length, z / length], $exact::scale(length, e)))
            }
            #[inline(always)]
            fn binary_exponent(largest: Self) -> i32 {
                let e = (largest.to_bits() >> $mantissa) as i32 - $bias;
                // Zero and subnormal numbers all have the lowest field.
                e.max(1 - $bias)
            }
            #[inline]
            fn scaled(self, e: i32) -> Self {
                $exact::scale(self, e)
            }
            #[inline(always)]
            fn finest(values: [Self; 3]) -> ([Self; 3], i32) {
                (values, 0)
            }
            #[inline(always)]
            fn along(self, component: Self) -> Self {
                self * component
            }
        }

        impl Elementary for $Float {
            fn fraction(self) -> Self {
                // % is exact. A tiny negative value rounds up to one.
                let rest = self % 1.0;
                let rest = if rest < 0.0 { rest + 1.0 } else { rest };
                if rest < 1.0 { rest } else { 0.0 }
            }
            fn turns(y: Self, x: Self) -> Self {
                const TURNS_PER_RADIAN: $Float = 1.0 / core::$Float::consts::TAU;
                let turns = $atan2(y, x) * TURNS_PER_RADIAN;
                if turns < 0.0 {
                    let turns = turns + 1.0;
                    // A tiny negative angle rounds up to a whole turn.
                    if turns < 1.0 { turns } else { 0.0 }
                } else {
                    // Adding zero makes -0 positive.
                    turns + 0.0
                }
            }
            fn sine_cosine(turns: Self) -> (Self, Self) {
                $sincos(turns * core::$Float::consts::TAU)
            }
            #[inline]
            fn small_integer(self) -> Option<u32> {
                let is_small = (0.0..1024.0).contains(&self);
                let whole = if is_small { self as u32 } else { 0 };
                (is_small && whole as $Float == self).then_some(whole)
            }
            fn power(base: Self, exponent: Self) -> Self {
                $pow(base, exponent)
            }
        }

        impl UnitScalar for $Float {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;

            #[inline(always)]
            fn plus(self, other: Self) -> Self {
                self + other
            }
            #[inline(always)]
            fn minus(self, other: Self) -> Self {
                self - other
            }
            #[inline(always)]
            fn times(self, other: Self) -> Self {
                self * other
            }
            #[inline]
            fn level(self, levels: u16) -> u16 {
                // A cast from float to integer saturates, and gives zero for NaN.
                ((self * levels as $Float + 0.5) as u16).min(levels)
            }
            #[inline]
            fn in_65536ths(self) -> u32 {
                ((self * 65536.0) as u32).min(65536)
            }
            #[allow(clippy::unnecessary_cast, reason = "necessary for `f32`")]
            fn from_f64(value: f64) -> Self {
                if value.is_nan() { 0.0 } else { value as $Float }
            }
            fn to_f64(self) -> f64 {
                f64::from(self)
            }
        }

        impl Ring for $Float {
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;

            #[inline]
            fn scaled(self, n: i32) -> Self {
                $exact::scale(self, n)
            }
        }

        impl Real for $Float {
            const ROUNDING: i32 = -1 - $mantissa;
            const IS_FLOAT: bool = true;
            const HAS_INSTRUCTIONS: bool = $instructions;
            const INFINITY: Self = $Float::INFINITY;
            const SMALLEST: Self = $Float::MIN_POSITIVE;

            #[inline(always)]
            fn from_int(n: i32) -> Self {
                n as $Float
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                if self > 0.0 { $sqrt(self) } else { 0.0 }
            }
            #[inline(always)]
            fn split(self) -> [Self; 2] {
                $exact::split(self).into()
            }
            #[inline(always)]
            fn plus_with_rest(self, other: Self) -> [Self; 2] {
                $exact::two_sum(self, other).into()
            }
            #[inline(always)]
            fn times_with_rest(self, other: Self) -> [Self; 2] {
                $exact::two_product(self, other).into()
            }
            #[inline]
            fn sum_with_rest<const N: usize>(terms: [[Self; 2]; N]) -> [Self; 2] {
                let (mut sum, mut error) = (0.0, 0.0);
                for [a, b] in terms {
                    let (p, e) = $exact::two_product(a, b);
                    let (s, f) = $exact::two_sum(sum, p);
                    sum = s;
                    error += e + f;
                }
                let (sum, rest) = $exact::two_sum(sum, error);
                [sum, rest]
            }
            #[inline(always)]
            fn abs(self) -> Self {
                $Float::abs(self)
            }
            #[inline(always)]
            fn is_negative(self) -> bool {
                self < 0.0
            }
            #[inline(always)]
            fn is_zero(self) -> bool {
                self == 0.0
            }
        }
    };
}

/// An Arm chip without a unit for floats passes none in registers.
const F32_INSTRUCTIONS: bool = !cfg!(any(
    all(target_arch = "arm", not(target_abi = "eabihf")),
    all(target_arch = "riscv32", not(target_feature = "f"))
));
/// Of Arm chips, few have a unit for doubles.
const F64_INSTRUCTIONS: bool = !cfg!(any(target_arch = "arm", all(target_arch = "riscv32", not(target_feature = "d"))));

float!(
    f32, exact_f32, u32, 23, 127, 126, 30, u64, F32_INSTRUCTIONS,
    sqrt: square_root_f32, atan2: libm::atan2f, sincos: libm::sincosf, pow: libm::powf
);
float!(
    f64, exact_f64, u64, 52, 1023, 1022, 200, u128, F64_INSTRUCTIONS,
    sqrt: libm::sqrt, atan2: libm::atan2, sincos: libm::sincos, pow: libm::pow
);

/// True if the line from `o` along `d` passes the axis through `position` along `a` at a distance greater than `r`. The
/// distance of the lines is `|n . from| / |n|`, `n = d x a` (Ericson, *Real-Time Collision Detection*, 2005, 5.1.8).
#[inline(always)]
fn passes_axis<R: Real>(o: [R; 3], d: [R; 3], position: [R; 3], a: [R; 3], r: R) -> bool {
    let (from, n) = (difference(o, position), cross(d, a));
    let (moment, rr) = (dot(n, from), r * r);
    // Far above all rounding errors, and above the errors of the right angles of frames that were read from files.
    let doubt = (dot(from, from) + rr).scaled(-12);
    moment * moment > rr * dot(n, n) + doubt
}
