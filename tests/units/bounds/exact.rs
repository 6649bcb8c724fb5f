//! Exact numbers, and how far a placed solid reaches in them.

use crate::scalar::Scalar;
use crate::{Placement, Primitive, Shape};
use core::ops::{Add, Mul, Neg, Sub};
use dashu_int::IBig;
use fixed::types::{I16F16, I32F32};
use std::vec::Vec;

/// `mantissa * 2^exponent`
#[derive(Clone, Debug)]
pub(super) struct Exact(IBig, i32);

impl Exact {
    pub(super) fn of_f64(value: f64) -> Self {
        let bits = value.to_bits();
        let field = (bits >> 52 & 0x7ff) as i32;
        let mantissa = IBig::from((bits & ((1 << 52) - 1)) | u64::from(field > 0) << 52);
        Self(if value < 0.0 { -mantissa } else { mantissa }, field.max(1) - 1075)
    }

    pub(super) fn power_of_two(exponent: i32) -> Self {
        Self(IBig::ONE, exponent)
    }

    fn at_exponent(&self, exponent: i32) -> IBig {
        &self.0 << (self.1 - exponent) as usize
    }

    fn is_negative(&self) -> bool {
        self.0 < IBig::ZERO
    }

    fn squared(&self) -> Self {
        self * self
    }
}

impl Add for Exact {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let exponent = self.1.min(other.1);
        Self(self.at_exponent(exponent) + other.at_exponent(exponent), exponent)
    }
}

impl Sub for Exact {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Exact {
    type Output = Self;
    fn neg(self) -> Self {
        Self(-self.0, self.1)
    }
}

impl Mul for &Exact {
    type Output = Exact;
    fn mul(self, other: Self) -> Exact {
        Exact(&self.0 * &other.0, self.1 + other.1)
    }
}

/// A number type whose values are known to the bit.
pub(super) trait Number: Scalar {
    /// The power of ten of the largest coordinates to try.
    const MOST: f64;
    fn exact(self) -> Exact;
    fn exact_unit(unit: Self::Unit) -> Exact;
    /// The exponent of the unit of numbers of this magnitude.
    fn unit_at(magnitude: f64) -> i32;
}

macro_rules! floats {
    ($($Float:ident, $most:literal;)+) => {
        $(impl Number for $Float {
            const MOST: f64 = $most;
            fn exact(self) -> Exact {
                Exact::of_f64(self.into())
            }
            fn exact_unit(unit: $Float) -> Exact {
                Exact::of_f64(unit.into())
            }
            fn unit_at(magnitude: f64) -> i32 {
                let exponent = (magnitude.to_bits() >> 52) as i32 - 1023;
                exponent.max($Float::MIN_EXP - 1) + 1 - $Float::MANTISSA_DIGITS as i32
            }
        })+
    };
}
floats!(f32, 6.0; f64, 12.0;);

macro_rules! fixed {
    ($($Fixed:ident, $most:literal;)+) => {
        $(impl Number for $Fixed {
            const MOST: f64 = $most;
            fn exact(self) -> Exact {
                Exact(self.to_bits().into(), -(Self::FRAC_NBITS as i32))
            }
            fn exact_unit(unit: Self::Unit) -> Exact {
                Exact(unit.to_bits().into(), 2 - Self::INT_NBITS as i32 - Self::FRAC_NBITS as i32)
            }
            fn unit_at(_: f64) -> i32 {
                -(Self::FRAC_NBITS as i32)
            }
        })+
    };
}
fixed!(I16F16, 3.5; I32F32, 8.0;);

/// A part whose hull with the others is the solid's.
#[derive(Clone, Debug)]
pub(super) enum Part {
    /// Height and radius.
    Ball(Exact, Exact),
    /// Height and radius.
    Disc(Exact, Exact),
    Point([Exact; 3]),
}

/// A solid's parts as a placement moves them: `p = o + adj(R) v / det(R)`.
pub(super) struct Exactly {
    parts: Vec<Part>,
    position: [Exact; 3],
    /// By rows.
    adjugate: [[Exact; 3]; 3],
    determinant: Exact,
}

impl Exactly {
    pub(super) fn new<S: Number>(shape: &Shape<S>, parts: &[Part]) -> Self {
        let zero = Exact::of_f64(0.0);
        let unit = |i: usize| [0, 1, 2].map(|j| Exact::of_f64(if i == j { 1.0 } else { 0.0 }));
        let (position, rows) = match shape.placement() {
            Placement::World => ([zero.clone(), zero.clone(), zero], [0, 1, 2].map(unit)),
            Placement::Frame(frame) => {
                let axes = [frame.left(), frame.up(), frame.forward()];
                let turned = axes.map(|axis| axis.to_array().map(S::exact_unit));
                let is_ball = matches!(shape.primitive(), Primitive::Sphere(_));
                (frame.position().to_array().map(S::exact), if is_ball { [0, 1, 2].map(unit) } else { turned })
            }
            Placement::Affine(affine) => {
                let rows = affine.inverse().map(|(row, e)| row.map(|c| &S::exact_unit(c) * &Exact::power_of_two(e)));
                (affine.position().to_array().map(S::exact), rows)
            }
        };
        let minor = |i: usize, j: usize| {
            let ([a, b], [c, d]) = ([(i + 1) % 3, (i + 2) % 3], [(j + 1) % 3, (j + 2) % 3]);
            &rows[c][a] * &rows[d][b] - &rows[c][b] * &rows[d][a]
        };
        let adjugate = [0, 1, 2].map(|i| [0, 1, 2].map(|j| minor(i, j)));
        let [a, b, c] = [0, 1, 2].map(|i| &rows[0][i] * &adjugate[i][0]);
        Self { parts: parts.to_vec(), position, adjugate, determinant: a + b + c }
    }

    /// Whether no point is beyond the bound along an axis, upwards or downwards.
    pub(super) fn is_held_by(&self, axis: usize, up: bool, bound: &Exact) -> bool {
        let [x, y, z] = &self.adjugate[axis];
        let from_position = &(bound.clone() - self.position[axis].clone()) * &self.determinant;
        let positive = up != self.determinant.is_negative();
        // What is left beyond the centre, times the magnitude of the determinant.
        let room = |centre: Exact| {
            let room = from_position.clone() - centre;
            if positive { room } else { -room }
        };
        let is_enough = |room: Exact, radius: &Exact, squares: Exact| {
            !room.is_negative() && !(room.squared() - &radius.squared() * &squares).is_negative()
        };
        self.parts.iter().all(|part| match part {
            Part::Ball(height, radius) => is_enough(room(y * height), radius, x.squared() + y.squared() + z.squared()),
            Part::Disc(height, radius) => is_enough(room(y * height), radius, x.squared() + z.squared()),
            Part::Point([a, b, c]) => !room(x * a + y * b + z * c).is_negative(),
        })
    }
}
