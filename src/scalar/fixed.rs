//! `FixedI32<F>` and `FixedI64<F>` as scalars, for every number of fraction bits.
//!
//! A coordinate has the fraction bits of its type. A direction has 30 (or 62) fraction bits, because the accuracy of
//! every result depends on that of the direction. Products of the two are exact in the double width.

use super::block::{Block64, Block128};
use super::scanline::{InIntegers, InNumbers};
use super::slabs::Slabs;
use super::{
    Attempt, Budget, Computing, Culling, Elementary, Numbers, Real, RoundLine, RoundSolid, Scalar, UnitScalar,
    ValueError, elementary, found, integers, sealed::Sealed,
};
use crate::ladder::FixedPoint;
use crate::number::word::Word;
use crate::number::{Limbs, Parts, Robust};
use crate::vector::pairs;
use fixed::types::extra::{LeEqU32, LeEqU64, U30, U62};
use fixed::{FixedI32, FixedI64};

/// Coordinates and sizes of an N-bit fixed type stay at or below `2^(N - SIZE_BITS)` units.
const SIZE_BITS: u32 = 2;

/// `a * b` in 128 bits.
#[inline(always)]
fn product(a: i64, b: i64) -> i128 {
    a as i128 * b as i128
}

/// `o - base + t d` in integers of twice the width.
trait WideApproach: Numbers {
    type Wide;

    /// In units of a coordinate times a direction's.
    fn wide_approach(o: [Self; 3], base: [Self; 3], d: [Self::Unit; 3], t: Self) -> [Self::Wide; 3];
    /// That vector along these axes, in units of a coordinate times two directions' less a word.
    fn wide_along(v: [Self::Wide; 3], axes: [[Self::Unit; 3]; 3]) -> [Self::Wide; 3];
    /// Units of a coordinate, and rests in units of those times a direction's.
    fn from_units(units: [Self::Wide; 3], rests: [Self::Wide; 3], radius: Self::Wide) -> [Self::Real; 3];
}

/// Defines the implementations for one width.
macro_rules! fixed {
    (
        $Fixed:ident, $LeEq:ident, $UnitBits:ident, $Block:ident, $robust:ty, $raw:ty, $wide:ty, $unsigned:ty,
        $bits:literal, $unit_bits:literal, $product:path, $scanline:ty, { $($direction:tt)* }
    ) => {
        impl<F: $LeEq + Send + Sync + 'static> Sealed for $Fixed<F> {}

        impl<F: $LeEq + Send + Sync + 'static> Numbers for $Fixed<F> {
            type Unit = $Fixed<$UnitBits>;
            type Real = $Block;
        }

        impl<F: $LeEq + Send + Sync + 'static> Scalar for $Fixed<F> {
            type Robust = Robust<$robust>;
            type Tiers = FixedPoint;
            type Scanline = $scanline;
            const ZERO: Self = Self::from_bits(0);
            const ROUNDED_ONE: Self = Self::from_bits(if F::U32 < $bits - 1 { 1 << F::U32 } else { <$raw>::MAX });
            const INFINITY: Self = Self::from_bits(<$raw>::MAX);
            const RELATIVE: bool = false;
            const BUDGET: Budget<Self> = Budget {
                coordinate: Self::from_bits(1 << ($bits - SIZE_BITS)),
                size: Self::from_bits(1 << ($bits - SIZE_BITS)),
                smallest_size: Self::from_bits(1),
                slope: Self::from_bits(1 << ($bits - SIZE_BITS)),
                smallest_slope: Self::from_bits(1),
                distance: Self::from_bits(<$raw>::MAX - 1),
            };
            #[inline(always)]
            fn is_finite(self) -> bool {
                self.magnitude().to_bits() < <$raw>::MAX
            }
            #[inline(always)]
            fn parts(self) -> Parts {
                let raw = self.to_bits();
                Parts { mantissa: raw.unsigned_abs().into(), exponent: -(F::I32), negative: raw < 0 }
            }
            #[inline(always)]
            fn unit_parts(value: Self::Unit) -> Parts {
                value.parts()
            }
            #[inline]
            fn from_limbs<W: Word>(value: Limbs<W>) -> Self {
                let units = value.to_units(-(F::I32)).and_then(|units| <$raw>::try_from(units).ok());
                let magnitude = units.map_or(Self::INFINITY, Self::from_bits);
                if value.is_negative() { -magnitude } else { magnitude }
            }
            #[inline]
            fn from_robust(value: Self::Robust) -> Self {
                Self::from_limbs(value)
            }
            #[inline]
            fn unit_from_limbs<W: Word>(value: Limbs<W>) -> Self::Unit {
                <$Fixed<$UnitBits> as Scalar>::from_limbs(value)
            }
            #[inline]
            fn unit_from_robust(value: Self::Robust) -> Self::Unit {
                <$Fixed<$UnitBits> as Scalar>::from_limbs(value)
            }
            #[inline(always)]
            fn last_place(_: i32) -> i32 {
                -(F::I32)
            }
            #[inline(always)]
            fn real(self) -> $Block {
                $Block::new(self.to_bits() as $wide, -(F::I32))
            }
            #[inline]
            fn round(value: $Block) -> Self {
                match value.to_units(-(F::I32)) {
                    Some(raw) if raw.unsigned_abs() < <$raw>::MAX as $unsigned => Self::from_bits(raw as $raw),
                    _ if value.is_negative() => Self::from_bits(-<$raw>::MAX),
                    _ => Self::INFINITY,
                }
            }
            #[inline(always)]
            fn unit_real(value: Self::Unit) -> $Block {
                $Block::new(value.to_bits() as $wide, -$unit_bits)
            }
            #[inline]
            fn unit_round(value: $Block) -> Self::Unit {
                match value.to_units(-$unit_bits) {
                    Some(raw) if raw.unsigned_abs() < <$raw>::MAX as $unsigned => $Fixed::from_bits(raw as $raw),
                    _ if value.is_negative() => $Fixed::from_bits(-<$raw>::MAX),
                    _ => $Fixed::from_bits(<$raw>::MAX),
                }
            }
            #[inline(always)]
            fn plus(self, other: Self) -> Self {
                self.saturating_add(other)
            }
            #[inline(always)]
            fn minus(self, other: Self) -> Self {
                self.saturating_sub(other)
            }
            #[inline(always)]
            fn next_up(self) -> Self {
                self.saturating_add(Self::from_bits(1))
            }
            #[inline(always)]
            fn magnitude(self) -> Self {
                self.saturating_abs()
            }
            fn parse_scaled(text: &str, power: i32) -> Option<Self> {
                let fraction_bits = F::U32.checked_add_signed(power).filter(|bits| *bits <= 64)?;
                let (negative, units) = super::decimal::parse(text, fraction_bits)?;
                let raw = <$raw>::try_from(units).ok().filter(|raw| *raw < <$raw>::MAX)?;
                Some(Self::from_bits(if negative { -raw } else { raw }))
            }
            fn from_f64(value: f64) -> Result<Self, ValueError> {
                if !value.is_finite() {
                    return Err(ValueError::NotFinite);
                }
                Self::checked_from_num(value).filter(|value| value.is_finite()).ok_or(ValueError::BeyondType)
            }
            fn to_f64(self) -> f64 {
                self.to_num()
            }
        }

        impl<F: $LeEq + Send + Sync + 'static> WideApproach for $Fixed<F> {
            type Wide = $wide;

            #[inline(always)]
            fn wide_approach(o: [Self; 3], base: [Self; 3], d: [Self::Unit; 3], t: Self) -> [$wide; 3] {
                let walked = |i: usize| {
                    let from_base = (o[i].to_bits() as $wide - base[i].to_bits() as $wide) << $unit_bits;
                    from_base + $product(t.to_bits(), d[i].to_bits())
                };
                [walked(0), walked(1), walked(2)]
            }

            #[inline(always)]
            fn wide_along(v: [$wide; 3], axes: [[Self::Unit; 3]; 3]) -> [$wide; 3] {
                // Words of the number's own width, so that no product is longer than the double width.
                let (high, low) = (v.map(|c| c >> $bits), v.map(|c| c & ((1 << $bits) - 1)));
                axes.map(|axis| {
                    let a = axis.map(|c| c.to_bits() as $wide);
                    let along = |i: usize| high[i] * a[i] + (low[i] * a[i] >> $bits);
                    along(0) + along(1) + along(2)
                })
            }

            #[inline(always)]
            fn from_units(units: [$wide; 3], rests: [$wide; 3], radius: $wide) -> [$Block; 3] {
                // Of a wide number only the bits that a direction has: sums of its squares would take four times as
                // many products.
                let drop = if $bits == 64 { 2 * $bits - radius.leading_zeros() } else { 0 };
                let rounding = (1 << drop) >> 1;
                pairs(units, rests).map(|(unit, rest)| {
                    let sum = (unit << $unit_bits) + rest + rounding;
                    $Block::new(sum >> drop, -(F::I32) - $unit_bits + drop as i32)
                })
            }
        }

        impl<F: $LeEq + Send + Sync + 'static> Computing for $Fixed<F> {
            #[inline(always)]
            fn resolves(_: Self, size: Self) -> bool {
                // Half of 1, in units; the limit is one unit for a type without fraction bits.
                size.to_bits() >= (1 as $raw).checked_shl(F::U32.saturating_sub(1)).unwrap_or(<$raw>::MAX)
            }
            #[inline(always)]
            fn resolves_turn(_: Self, radius: Self) -> bool {
                // Half a unit of `t` over the radius, in units of a direction.
                radius.to_bits() >= 1 << ($unit_bits - 2)
            }
            #[inline(always)]
            fn dot(o: [Self; 3], d: [Self::Unit; 3]) -> $Block {
                // Cauchy-Schwarz: the sum stays below 2^(2 bits - 2), though a coordinate may use all its bits.
                let product = |i: usize| $product(o[i].to_bits(), d[i].to_bits());
                $Block::new(product(0) + product(1) + product(2), -(F::I32) - $unit_bits)
            }
            #[inline(always)]
            fn cross(o: [Self; 3], d: [Self::Unit; 3]) -> [$Block; 3] {
                let ([x, y, z], [dx, dy, dz]) = (o.map(Self::to_bits), d.map($Fixed::to_bits));
                let minor = |a, b, c, d| $Block::new($product(a, d) - $product(b, c), -(F::I32) - $unit_bits);
                [minor(y, z, dy, dz), minor(z, x, dz, dx), minor(x, y, dx, dy)]
            }
            #[inline(always)]
            fn unit_dot(d: [Self::Unit; 3], e: [Self::Unit; 3]) -> $Block {
                $Fixed::<$UnitBits>::dot(d, e)
            }
            #[inline]
            fn approach(o: [Self; 3], base: [Self; 3], d: [Self::Unit; 3], t: Self) -> [Self; 3] {
                Self::wide_approach(o, base, d, t).map(|sum| {
                    // Rounded to nearest, ties to even; infinite beyond the type.
                    let rounding = (1 << ($unit_bits - 1)) - 1 + ((sum >> $unit_bits) & 1);
                    let units = (sum + rounding) >> $unit_bits;
                    match units.unsigned_abs() < <$raw>::MAX as $unsigned {
                        true => Self::from_bits(units as $raw),
                        false if units < 0 => Self::from_bits(-<$raw>::MAX),
                        false => Self::INFINITY,
                    }
                })
            }
            #[inline]
            fn approach_exactly(o: [Self; 3], base: [Self; 3], d: [Self::Unit; 3], t: Self) -> [$Block; 3] {
                Self::wide_approach(o, base, d, t).map(|sum| $Block::new(sum, -(F::I32) - $unit_bits))
            }
            #[inline]
            fn approach_along(
                o: [Self; 3],
                base: [Self; 3],
                d: [Self::Unit; 3],
                t: Self,
                axes: [[Self::Unit; 3]; 3],
            ) -> [$Block; 3] {
                let along = Self::wide_along(Self::wide_approach(o, base, d, t), axes);
                along.map(|sum| $Block::new(sum, -(F::I32) - 2 * $unit_bits + $bits))
            }
            fn round_normal(line: RoundLine<Self>, solid: RoundSolid<Self>) -> Option<[$Block; 3]> {
                // Bits of a direction, and those of `f` below the square of a unit.
                const DIRECTION: u32 = $unit_bits;
                const BELOW: u32 = DIRECTION - 6;
                let RoundLine { o, base, d, t, axes, enters } = line;
                let world = (Self::wide_approach(o, base, d, t), d.map(|c| c.to_bits() as $wide));
                // The point in units of `2^-fraction` coordinate units, and the direction in its own.
                let (fraction, (p, d)) = match axes {
                    None => (DIRECTION, world),
                    Some(axes) => {
                        let turned = |axis: [Self::Unit; 3]| {
                            let a = axis.map(|c| c.to_bits() as $wide);
                            let sum = a[0] * world.1[0] + a[1] * world.1[1] + a[2] * world.1[2];
                            sum >> DIRECTION
                        };
                        (2 * DIRECTION - $bits, (Self::wide_along(world.0, axes), axes.map(turned)))
                    }
                };
                let radius = solid.radius.to_bits() as $wide;
                // Coordinates from the centre, in units, and rests in units of `2^-DIRECTION`.
                let mut units = p.map(|c| (c + (1 << (fraction - 1))) >> fraction);
                let mut rests = pairs(p, units).map(|(c, unit)| (c - (unit << fraction)) << (DIRECTION - fraction));
                let mut d = d;
                match solid.centre {
                    Some(centre) => units[1] -= centre.to_bits() as $wide,
                    None => (units[1], rests[1], d[1]) = (0, 0, 0),
                }
                // Next to the surface, so that no square overflows.
                let limit = radius + (1 << 6);
                // In the small the bits of `f` are too few.
                if radius < 1 << 10 || !units.iter().all(|c| -limit < *c && *c < limit) {
                    return None;
                }
                let product = |a: [$wide; 3], b: [$wide; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
                let squares = product(units, units) - radius * radius;
                if squares.unsigned_abs() >= 1 << (DIRECTION + 7) {
                    return None;
                }
                let halves = rests.map(|c| c >> (DIRECTION / 2));
                // f, and half its slope in units of a coordinate times a direction.
                let f = (squares << BELOW)
                    + (product(units, rests) >> (DIRECTION - BELOW - 1))
                    + (product(halves, halves) >> (DIRECTION - BELOW));
                let h = product(units, d) + (product(rests, d) >> DIRECTION);
                if h == 0 || (h < 0) != enters {
                    return None;
                }
                if f == 0 {
                    return Some(Self::from_units(units, rests, radius));
                }
                // |f| / 2 |h| by words of the number's own width, with the exponents that belong to them.
                let (mut divisor, mut down) = (h.unsigned_abs(), 0);
                let excess = (2 * $bits - divisor.leading_zeros()).saturating_sub($bits - 1);
                if excess > 0 {
                    (divisor, down) = (divisor >> excess, excess);
                }
                let up = f.unsigned_abs().leading_zeros() - 2;
                let quotient = (f.unsigned_abs() << up).checked_div(divisor)?;
                let bits = 2 * $bits - quotient.leading_zeros();
                let surplus = bits.saturating_sub(DIRECTION);
                let short = (quotient >> surplus) as $wide;
                // short 2^surplus 2^-up 2^-BELOW / 2^down 2^DIRECTION / 2 units, times a direction, in rests.
                let shift = (up + BELOW + down + 1) as i32 - (surplus + DIRECTION) as i32;
                if shift < 8 {
                    return None;
                }
                let moved_by = |a: $wide, shift: u32| if shift < 2 * $bits { a >> shift } else { 0 };
                // The step in units of `2^-8`; its square over the slope is what a second step would add.
                let coarse = moved_by(short, shift as u32 - 8);
                let room = ((h >> DIRECTION).abs() * radius) >> (DIRECTION - 15);
                if coarse >= 1 << 12 || coarse * coarse > room {
                    return None;
                }
                let step = if (f < 0) == (h < 0) { -short } else { short };
                let moved = pairs(rests, d).map(|(rest, d)| rest + moved_by(step * d, shift as u32));
                Some(Self::from_units(units, moved, radius))
            }
            #[inline]
            fn advance(o: [Self; 3], d: [Self::Unit; 3], t: Self) -> [Self; 3] {
                Self::approach(o, [<Self as Scalar>::ZERO; 3], d, t)
            }
            #[inline]
            fn times(component: Self::Unit, by: Self) -> Self::Unit {
                let product = $product(component.to_bits(), by.to_bits());
                let units = (product + ((1 << F::U32) >> 1)) >> F::U32;
                match units.unsigned_abs() < <$raw>::MAX as $unsigned {
                    true => $Fixed::from_bits(units as $raw),
                    false if units < 0 => $Fixed::from_bits(-<$raw>::MAX),
                    false => $Fixed::from_bits(<$raw>::MAX),
                }
            }
            #[inline]
            fn normalize(v: [$Block; 3]) -> Option<([Self::Unit; 3], $Block)> {
                let [x, y, z] = v;
                let length = $Block::sum_of_products([[x, x], [y, y], [z, z]]).sqrt();
                if length.is_zero() {
                    return None;
                }
                Some((v.map(|component| Self::unit_round(component / length)), length))
            }
            #[inline(always)]
            fn binary_exponent(_: Self) -> i32 {
                0
            }
            #[inline(always)]
            fn scaled(self, e: i32) -> Self {
                let raw = self.to_bits();
                Self::from_bits(if e < 0 { raw.wrapping_shr(e.unsigned_abs()) } else { raw.wrapping_shl(e as u32) })
            }
            #[inline]
            fn finest(values: [$Block; 3]) -> ([Self; 3], i32) {
                // The exponent of the power of two above all of them.
                let mut top = i32::MIN;
                for value in values {
                    if !value.is_zero() {
                        let bits = (2 * $bits - value.mantissa().unsigned_abs().leading_zeros()) as i32;
                        top = top.max(value.exponent().wrapping_add(bits));
                    }
                }
                if top == i32::MIN {
                    return ([Self::ZERO; 3], 0);
                }
                let units = |unit: i32| values.map(|value| value.to_units(unit).unwrap_or(0));
                let unit = top.wrapping_sub($bits - 1);
                // A number whose bits are all ones has one bit more when it is rounded up.
                let is_full = units(unit).iter().any(|raw| raw.unsigned_abs() >= <$raw>::MAX as $unsigned);
                let unit = if is_full { unit.wrapping_add(1) } else { unit };
                (units(unit).map(|raw| Self::from_bits(raw as $raw)), (-(F::I32)).wrapping_sub(unit))
            }
            $($direction)*
        }

        impl<F: $LeEq + Send + Sync + 'static> Elementary for $Fixed<F> {
            fn fraction(self) -> Self::Unit {
                // Keep the fraction bits and move them to the unit type's place.
                let rest = (self.to_bits() as $wide) & (((1 as $wide) << F::U32) - 1);
                let shift = $unit_bits - F::I32;
                $Fixed::from_bits(if shift >= 0 { rest << shift } else { rest >> -shift } as $raw)
            }
            fn turns(y: $Block, x: $Block) -> Self::Unit {
                // Both in units of the larger one's last place of 60 bits.
                let top = |block: $Block| {
                    block.exponent().wrapping_add((2 * $bits - block.mantissa().unsigned_abs().leading_zeros()) as i32)
                };
                let unit = match (x.is_zero(), y.is_zero()) {
                    (true, true) => return Self::Unit::ZERO,
                    (true, false) => top(y),
                    (false, true) => top(x),
                    (false, false) => top(x).max(top(y)),
                } - 60;
                let component = |block: $Block| block.to_units(unit).map_or(0, |raw| raw as i64);
                let angle = elementary::angle(component(y), component(x), $bits);
                // From 64 fraction bits to those of the unit type; a whole turn wraps to zero.
                let rounded = (angle >> (63 - $unit_bits)).wrapping_add(1) >> 1;
                $Fixed::from_bits((rounded & ((1 << $unit_bits) - 1)) as $raw)
            }
            fn sine_cosine(turns: Self::Unit) -> (Self::Unit, Self::Unit) {
                let angle = (turns.to_bits() as i64 as u64) << (64 - $unit_bits);
                let (sine, cosine) = elementary::sine_cosine(angle, $bits - 2);
                let narrow = |value: i64| $Block::new(value as $wide, -62);
                (Self::unit_round(narrow(sine)), Self::unit_round(narrow(cosine)))
            }
            #[inline]
            fn small_integer(self) -> Option<u32> {
                let (raw, fraction) = (self.to_bits(), F::U32);
                let whole = if fraction < $bits { raw >> fraction } else { 0 };
                let is_small = (0..1024).contains(&whole);
                (is_small && whole.checked_shl(fraction).unwrap_or(0) == raw).then_some(whole as u32)
            }
            fn power(base: Self::Unit, exponent: Self) -> Self::Unit {
                if exponent <= Self::ZERO {
                    return Self::Unit::ONE;
                }
                let base = (base.to_bits().max(0) as u64) << (62 - $unit_bits);
                let value = elementary::power(base, exponent.to_bits() as u64, F::U32);
                Self::unit_round($Block::new(value as $wide, -62))
            }
        }

        impl UnitScalar for $Fixed<$UnitBits> {
            const ZERO: Self = Self::from_bits(0);
            const ONE: Self = Self::from_bits(1 << $unit_bits);

            #[inline(always)]
            fn plus(self, other: Self) -> Self {
                self.saturating_add(other)
            }
            #[inline(always)]
            fn minus(self, other: Self) -> Self {
                self.saturating_sub(other)
            }
            #[inline]
            fn times(self, other: Self) -> Self {
                let product = $product(self.to_bits(), other.to_bits());
                let rounded = (product >> $unit_bits) + ((product >> ($unit_bits - 1)) & 1);
                Self::from_bits(if rounded > <$raw>::MAX as $wide {
                    <$raw>::MAX
                } else if rounded < -(<$raw>::MAX as $wide) {
                    -<$raw>::MAX
                } else {
                    rounded as $raw
                })
            }
            #[inline]
            fn level(self, levels: u16) -> u16 {
                let clamped = self.clamp(<Self as UnitScalar>::ZERO, <Self as UnitScalar>::ONE).to_bits() as $wide;
                ((clamped * levels as $wide + (1 << ($unit_bits - 1))) >> $unit_bits) as u16
            }
            #[inline]
            fn in_65536ths(self) -> u32 {
                let clamped = self.clamp(<Self as UnitScalar>::ZERO, <Self as UnitScalar>::ONE).to_bits();
                (clamped >> ($unit_bits - 16)) as u32
            }
            fn from_f64(value: f64) -> Self {
                if value.is_nan() { Self::from_bits(0) } else { Self::saturating_from_num(value) }
            }
            fn to_f64(self) -> f64 {
                self.to_num()
            }
        }
    };
}

fixed!(FixedI32, LeEqU32, U30, Block64, u64, i32, i64, u64, 32, 30, integers::product, InIntegers, {
    #[inline(always)]
    fn along(self, component: Self::Unit) -> Self {
        Self::from_bits(integers::round_off(integers::product(self.to_bits(), component.to_bits()), 30) as i32)
    }
    #[inline(always)]
    fn direction_of(v: [Self; 3]) -> Attempt<[Self::Unit; 3]> {
        Attempt::Hit(found!(integers::direction(v.map(Self::to_bits))).map(FixedI32::from_bits))
    }
    #[inline]
    fn direction(v: [Block64; 3]) -> Option<[Self::Unit; 3]> {
        // Rounded to 31 bits of the longest component, which adds an error of half a unit.
        match Self::direction_of(Self::finest(v).0) {
            Attempt::Hit(direction) => Some(direction),
            Attempt::Miss => None,
            Attempt::Unsure => Self::normalize(v).map(|(direction, _)| direction),
        }
    }
});
fixed!(FixedI64, LeEqU64, U62, Block128, u128, i64, i128, u128, 64, 62, product, InNumbers<Self>, {
    #[inline(always)]
    fn along(self, component: Self::Unit) -> Self {
        <Self as Scalar>::round(self.real() * Self::unit_real(component))
    }
});

impl<F: LeEqU32 + Send + Sync + 'static> Culling for FixedI32<F> {
    #[inline(always)]
    fn passes_axis(o: [Self; 3], d: [Self::Unit; 3], position: [Self; 3], axis: [Self::Unit; 3], r: Self) -> bool {
        let from = |i: usize| o[i].to_bits().wrapping_sub(position[i].to_bits());
        let (d, axis) = (d.map(FixedI32::to_bits), axis.map(FixedI32::to_bits));
        integers::passes([from(0), from(1), from(2)], d, axis, r.to_bits())
    }
    type Slabs = Slabs<i32, i32>;
    #[inline(always)]
    fn slabs(o: [Self; 3], d: [Self::Unit; 3]) -> Self::Slabs {
        Slabs::<i32, i32>::new(o.map(Self::to_bits), d.map(FixedI32::to_bits))
    }
    #[inline(always)]
    fn misses_box(slabs: &Self::Slabs, range: [Self; 2], centre: [Self; 3], half: [Self; 3]) -> bool {
        slabs.misses(range.map(Self::to_bits), centre.map(Self::to_bits), half.map(Self::to_bits))
    }
}

impl<F: LeEqU64 + Send + Sync + 'static> Culling for FixedI64<F> {
    #[inline(always)]
    fn passes_axis(o: [Self; 3], d: [Self::Unit; 3], position: [Self; 3], axis: [Self::Unit; 3], r: Self) -> bool {
        let from = |i: usize| o[i].to_bits().wrapping_sub(position[i].to_bits());
        let (d, axis) = (d.map(|c| (c.to_bits() >> 32) as i32), axis.map(|c| (c.to_bits() >> 32) as i32));
        integers::passes_wide([from(0), from(1), from(2)], d, axis, r.to_bits())
    }
    type Slabs = Slabs<i64, i32>;
    #[inline(always)]
    fn slabs(o: [Self; 3], d: [Self::Unit; 3]) -> Self::Slabs {
        Slabs::<i64, i32>::new(o.map(Self::to_bits), d.map(FixedI64::to_bits))
    }
    #[inline(always)]
    fn misses_box(slabs: &Self::Slabs, range: [Self; 2], centre: [Self; 3], half: [Self; 3]) -> bool {
        slabs.misses(range.map(Self::to_bits), centre.map(Self::to_bits), half.map(Self::to_bits))
    }
}
