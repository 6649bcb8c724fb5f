//! Numbers from bytes: every bit pattern can come, and those that meet something come often enough to be found.

use fixed::types::extra::{LeEqU32, LeEqU64};
use fixed::{FixedI32, FixedI64};
use raylet::scalar::UnitScalar;
use raylet::{Scalar, UnitVec3, Vec3};
use support::exact_types::Exact;

/// A number type that any bits make.
pub trait Number: Exact {
    /// The number of these bits; those above the type's width count for nothing.
    fn from_raw(raw: u64) -> Self;
    /// Its bits.
    fn raw(self) -> u64;
    /// The component of a direction of these bits.
    fn unit_from_raw(raw: u64) -> Self::Unit;
    /// A number in the middle of the type, where products neither vanish nor overflow.
    fn moderate(value: i16) -> Self;
    /// Any digits, so large as `size` says: a number that uses all its bits.
    fn small(raw: u64, size: u8) -> Self;
    /// `value * 2^shift` for a float, `value * 2^shift` units for a fixed type; cut off at its ends.
    fn shifted(value: i16, shift: u8) -> Self;
    /// Numbers at the ends of the type, of the budget, and around one and zero.
    fn extremes() -> Vec<Self>;
    /// Fraction bits of the type's products: a size is known to one part in `2^PRECISION`.
    const PRECISION: isize;
    /// For a float, the exponent from which on the square of a smaller number beside the largest is nothing.
    const VANISHING: Option<i32>;
}

macro_rules! float {
    ($Float:ident, $bits:ty, $precision:literal, $vanishing:literal) => {
        impl Number for $Float {
            fn from_raw(raw: u64) -> Self {
                Self::from_bits(raw as $bits)
            }
            fn raw(self) -> u64 {
                u64::from(self.to_bits())
            }
            fn unit_from_raw(raw: u64) -> Self {
                Self::from_raw(raw)
            }
            fn moderate(value: i16) -> Self {
                Self::from(value) / 256.0
            }
            fn small(raw: u64, size: u8) -> Self {
                // The digits of the bits, and an exponent of a few binades about one.
                let (one, digits) = ((1.0 as $Float).to_bits(), (1 << $precision) - 1);
                let number = Self::from_bits(one | (raw as $bits & digits));
                number * (2.0 as Self).powi(i32::from(size as i8) / 8)
            }
            fn shifted(value: i16, shift: u8) -> Self {
                Self::from(value) * (2.0 as Self).powi(i32::from(shift as i8))
            }
            fn extremes() -> Vec<Self> {
                let budget = <Self as Scalar>::BUDGET.coordinate;
                let positive = [
                    0.0,
                    Self::from_bits(1),
                    Self::from_bits(12345),
                    Self::MIN_POSITIVE,
                    Self::MIN_POSITIVE.sqrt(),
                    Self::EPSILON,
                    1.0,
                    1.0 + Self::EPSILON,
                    3.0,
                    Self::MAX.sqrt(),
                    budget / 3.0,
                    budget,
                    budget.next_up(),
                    Self::MAX,
                    Self::INFINITY,
                    Self::NAN,
                ];
                positive.into_iter().flat_map(|x: Self| [x, -x]).collect()
            }
            const PRECISION: isize = $precision;
            const VANISHING: Option<i32> = Some($vanishing);
        }
    };
}
float!(f32, u32, 23, -60);
float!(f64, u64, 52, -500);

macro_rules! fixed {
    ($Fixed:ident, $LeEq:ident, $raw:ty, $bits:literal, $precision:literal) => {
        impl<F: $LeEq + Send + Sync + 'static> Number for $Fixed<F> {
            fn from_raw(raw: u64) -> Self {
                Self::from_bits(raw as $raw)
            }
            fn raw(self) -> u64 {
                self.to_bits() as u64
            }
            fn unit_from_raw(raw: u64) -> Self::Unit {
                <Self::Unit>::from_bits(raw as $raw)
            }
            fn moderate(value: i16) -> Self {
                // An eighth of the type's range is large enough, where 128 is too large for it; one unit, where 1/256
                // is too small.
                let shift = (F::I32 - 8).clamp(0, $bits - 19);
                Self::from_bits(<$raw>::from(value) << shift)
            }
            fn small(raw: u64, size: u8) -> Self {
                Self::from_bits((raw as $raw) >> (1 + u32::from(size) % ($bits - 1)))
            }
            fn shifted(value: i16, shift: u8) -> Self {
                let shift = u32::from(shift) % $bits;
                Self::from_bits(<$raw>::from(value).saturating_mul(1 << shift.min($bits - 2)))
            }
            fn extremes() -> Vec<Self> {
                let budget: $raw = 1 << ($bits - 2);
                let one: $raw = if F::U32 < $bits - 1 { 1 << F::U32 } else { <$raw>::MAX };
                let positive =
                    [0, 1, 2, 3, 1 << ($bits / 2), one, budget >> 1, budget - 1, budget, budget + 1, <$raw>::MAX - 1];
                let both = positive.into_iter().flat_map(|raw| [raw, -raw]);
                both.chain([<$raw>::MAX, <$raw>::MIN, <$raw>::MIN + 1]).map(Self::from_bits).collect()
            }
            const PRECISION: isize = $precision;
            const VANISHING: Option<i32> = None;
        }
    };
}
fixed!(FixedI32, LeEqU32, i32, 32, 30);
fixed!(FixedI64, LeEqU64, i64, 64, 62);

/// Bytes, read from the front; zeros behind their end, so that every input is a whole case.
pub struct Bytes<'a, S> {
    rest: &'a [u8],
    /// The numbers read so far: what degenerates is mostly made of equal ones.
    earlier: Vec<S>,
}

impl<'a, S: Number> Bytes<'a, S> {
    pub fn new(data: &'a [u8]) -> Self {
        Self { rest: data, earlier: vec![] }
    }

    pub fn byte(&mut self) -> u8 {
        let Some((first, rest)) = self.rest.split_first() else { return 0 };
        self.rest = rest;
        *first
    }

    /// One of these.
    pub fn pick<T: Copy>(&mut self, from: &[T]) -> T {
        from[usize::from(self.byte()) % from.len()]
    }

    fn short(&mut self) -> i16 {
        i16::from_le_bytes([self.byte(), self.byte()])
    }

    fn raw(&mut self) -> u64 {
        let mut raw = [0; 8];
        for byte in &mut raw[..size_of::<S>()] {
            *byte = self.byte();
        }
        u64::from_le_bytes(raw)
    }

    fn earlier(&mut self) -> S {
        let byte = self.byte();
        if self.earlier.is_empty() { S::ZERO } else { self.earlier[usize::from(byte) % self.earlier.len()] }
    }

    /// A number: any bits, or one of those that are worth trying.
    pub fn number(&mut self) -> S {
        let number = match self.byte() % 12 {
            0 => S::ZERO,
            1 => S::from_raw(self.raw()),
            2..5 => S::moderate(self.short()),
            5 => S::small(self.raw(), self.byte()),
            6 => S::shifted(self.short(), self.byte()),
            7 => self.pick(&S::extremes()),
            8 | 9 => self.earlier(),
            // A few units beside it.
            10 => S::from_raw(self.earlier().raw().wrapping_add_signed(i64::from(self.byte() as i8))),
            _ => S::ZERO.minus(self.earlier()),
        };
        self.earlier.push(number);
        number
    }

    /// A number that is mostly positive, as a size is.
    pub fn size(&mut self) -> S {
        let (sign, number) = (self.byte(), self.number());
        if sign < 16 { number } else { number.magnitude() }
    }

    pub fn vector(&mut self) -> Vec3<S> {
        Vec3::new(self.number(), self.number(), self.number())
    }

    /// A direction, if the bytes make one.
    pub fn direction(&mut self) -> Option<UnitVec3<S>> {
        let lattice = |byte: u8| {
            let digits = [byte % 3, byte / 3 % 3, byte / 9 % 3];
            digits.map(|digit| f64::from(digit) - 1.0)
        };
        match self.byte() % 9 {
            0 => {
                let components = [self.raw(), self.raw(), self.raw()].map(S::unit_from_raw);
                UnitVec3::from_components(components).ok()
            }
            1 | 2 => UnitVec3::new(self.vector()).ok(),
            3 | 4 => unit(lattice(self.byte())),
            5 | 6 => unit([self.short(), self.short(), self.short()].map(f64::from)),
            // Nearly along an axis or a diagonal.
            _ => {
                let ([x, y, z], off) = (lattice(self.byte()), 2.0_f64.powi(-i32::from(self.byte() % 64)));
                let [a, b, c] = lattice(self.byte());
                unit([x + a * off, y + b * off, z + c * off])
            }
        }
    }
}

/// The direction nearest to the given one; `None` for a vector of no length.
fn unit<S: Number>([x, y, z]: [f64; 3]) -> Option<UnitVec3<S>> {
    let length = (x * x + y * y + z * z).sqrt();
    let component = |c: f64| <S::Unit as UnitScalar>::from_f64(c / length);
    UnitVec3::from_components([x, y, z].map(component)).ok()
}
